// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/scene/camera.h"

namespace isoscope {

/// A camera block that shows `view`, with as much as possible of `block`, the text's present one, that shows
/// `written`: where turning, shifting and zooming moved nothing but location and look_at, only their values
/// are exchanged, so that `angle`, `right x*image_width/image_height` and comments stay as the author wrote
/// them. Everything else is a new block.
std::string cameraText(std::string_view block, const Camera& written, const Camera& view);

}  // namespace isoscope
