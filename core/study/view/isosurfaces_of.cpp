// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/isosurfaces_of.h"

#include <algorithm>

#include "core/shapes/composition.h"

namespace isoscope {

std::vector<std::shared_ptr<const Isosurface>> isosurfacesOf(const ShapePointer& shape) {
    std::vector<std::shared_ptr<const Isosurface>> found;
    std::vector<ShapePointer> waiting{shape};
    while (!waiting.empty()) {
        const ShapePointer next = waiting.back();
        waiting.pop_back();
        if (!next) continue;
        if (auto isosurface = asIsosurface(next)) {
            if (std::find(found.begin(), found.end(), isosurface) == found.end()) found.push_back(isosurface);
            continue;
        }
        const Composition made = next->composition();
        // The last pushed comes first.
        waiting.insert(waiting.end(), made.limits.rbegin(), made.limits.rend());
        waiting.insert(waiting.end(), made.parts.rbegin(), made.parts.rend());
    }
    return found;
}

}  // namespace isoscope
