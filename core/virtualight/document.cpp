// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/virtualight/document.h"

namespace isoscope::virtualight {

ShapeModifiers ShapeModifiers::within(const ShapeModifiers& outer) const {
    ShapeModifiers result = *this;
    if (!result.solver) result.solver = outer.solver;
    if (!result.bound) result.bound = outer.bound;
    if (!result.renderBound) result.renderBound = outer.renderBound;
    if (!result.subdivision) result.subdivision = outer.subdivision;
    return result;
}

Transform transformOf(const std::vector<TransformStep>& steps) {
    Transform transform;
    for (const TransformStep& step : steps) {
        switch (step.kind) {
            case TransformStep::Kind::rotate:
                transform = transform.then(Transform::rotation(step.numbers));
                break;
            case TransformStep::Kind::translate:
                transform = transform.then(Transform::translation(step.numbers));
                break;
            case TransformStep::Kind::scale:
                transform = transform.then(Transform::scaling(step.numbers));
                break;
        }
    }
    return transform;
}

}  // namespace isoscope::virtualight
