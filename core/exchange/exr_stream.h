// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "core/render/image.h"
#include "core/study/view/surface_layers.h"
#include "core/text/whole_file.h"

namespace isoscope {

/// An OpenEXR picture that is made from the top, a strip of rows at a time. Channels: `R`, `G`, `B` and `A`
/// (half floats, linear light, colours multiplied by the opacity), `Z` (float: the distance along the ray,
/// infinite where nothing is met), `N.X`, `N.Y`, `N.Z` (half floats: the normal, 0 where nothing is met) and,
/// where root finders prove what they find, `verdict` (whole numbers, which the attribute `verdicts`
/// explains).
class ExrStream {
  public:
    /// Writes to `file`, which must outlive this.
    ExrStream(int width, int height, bool verdicts, GrowingFile& file);
    ~ExrStream();

    /// The next rows and their layers, of the same size. False after a failure; the file is whole when there
    /// are as many rows as its height.
    bool add(const Image& rows, const SurfaceLayers& layers);
    /// Why something failed, where that is not the file's problem (GrowingFile::finish).
    const std::string& problem() const { return problem_; }

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
    std::string problem_;
};

}  // namespace isoscope
