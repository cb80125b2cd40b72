// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/isosurfaces_of.h"

#include <algorithm>

#include "core/shapes/combined/bounded_shape.h"
#include "core/shapes/combined/clipped_shape.h"
#include "core/shapes/combined/csg.h"
#include "core/shapes/combined/inverse_shape.h"
#include "core/shapes/combined/placed_shape.h"

namespace isoscope {

std::vector<std::shared_ptr<const Isosurface>> isosurfacesOf(const ShapePointer& shape) {
    std::vector<std::shared_ptr<const Isosurface>> found;
    std::vector<ShapePointer> waiting{shape};
    while (!waiting.empty()) {
        const ShapePointer next = waiting.back();
        waiting.pop_back();
        if (!next) continue;
        if (auto isosurface = std::dynamic_pointer_cast<const Isosurface>(next)) {
            if (std::find(found.begin(), found.end(), isosurface) == found.end()) found.push_back(isosurface);
        } else if (const auto* placed = dynamic_cast<const PlacedShape*>(next.get())) {
            waiting.push_back(placed->shape());
        } else if (const auto* inverse = dynamic_cast<const InverseShape*>(next.get())) {
            waiting.push_back(inverse->shape());
        } else if (const auto* clipped = dynamic_cast<const ClippedShape*>(next.get())) {
            // The last pushed comes first.
            waiting.insert(waiting.end(), clipped->clips().rbegin(), clipped->clips().rend());
            waiting.push_back(clipped->shape());
        } else if (const auto* bounded = dynamic_cast<const BoundedShape*>(next.get())) {
            waiting.insert(waiting.end(), bounded->limits().rbegin(), bounded->limits().rend());
            waiting.push_back(bounded->shape());
        } else if (const auto* csg = dynamic_cast<const Csg*>(next.get())) {
            waiting.insert(waiting.end(), csg->parts().rbegin(), csg->parts().rend());
        }
    }
    return found;
}

}  // namespace isoscope
