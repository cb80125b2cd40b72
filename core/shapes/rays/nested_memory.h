// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/shapes/trace_context.h"

namespace isoscope {

/// Scratch memory for the time of one query, which a TraceContext keeps for the next one: `Level` is what one
/// shape needs, and shapes that lie in one another get one each. To be made and destroyed like a stack.
template <class Level>
class NestedMemory {
  public:
    explicit NestedMemory(TraceContext& context)
        : levels_(context.state<Levels>(&key, [] { return std::make_unique<Levels>(); })) {
        if (levels_.depth == levels_.all.size()) levels_.all.push_back(std::make_unique<Level>());
        level_ = levels_.all[levels_.depth++].get();
    }
    ~NestedMemory() { --levels_.depth; }
    NestedMemory(const NestedMemory&) = delete;
    NestedMemory& operator=(const NestedMemory&) = delete;

    Level* operator->() const { return level_; }

  private:
    struct Levels : public ShapeState {
        std::vector<std::unique_ptr<Level>> all;
        std::size_t depth = 0;
    };
    /// Its address is the owner of the state.
    static inline const char key = 0;

    Levels& levels_;
    Level* level_;
};

}  // namespace isoscope
