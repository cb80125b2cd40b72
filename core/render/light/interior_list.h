// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/scene/interior.h"

namespace isoscope {

/// The interiors that a ray is in, in the order in which it has entered them. Rays are many, so that this is
/// small: of more than `room` interiors one within the other the outermost are forgotten.
class InteriorList {
  public:
    static constexpr std::size_t room = 7;

    /// From the outermost to the innermost; valid until the list changes.
    std::span<const InteriorId> all() const { return {ids_.data(), count_}; }
    bool empty() const { return count_ == 0; }
    /// The one entered last, or noInterior.
    InteriorId innermost() const { return count_ > 0 ? ids_[count_ - 1] : noInterior; }
    bool has(InteriorId id) const { return std::find(ids_.begin(), end(), id) != end(); }

    /// The ray enters one more, which becomes the innermost; a full list forgets the outermost for it.
    void enter(InteriorId id) {
        if (count_ == room) {
            std::copy(ids_.begin() + 1, ids_.end(), ids_.begin());
            --count_;
        }
        ids_[count_++] = id;
    }
    /// Nothing happens where the ray is not in it.
    void leave(InteriorId id) {
        const auto found = std::find(ids_.begin(), end(), id);
        if (found == end()) return;
        std::copy(found + 1, end(), found);
        --count_;
    }

  private:
    std::array<InteriorId, room>::iterator end() { return ids_.begin() + count_; }
    std::array<InteriorId, room>::const_iterator end() const { return ids_.begin() + count_; }

    std::array<InteriorId, room> ids_{};
    std::uint8_t count_ = 0;
};

}  // namespace isoscope
