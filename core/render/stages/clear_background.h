// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/stages/stage.h"

namespace isoscope {

/// Takes the background away, sky included, where the camera sees it, straight or through glass
/// (RenderRequest::transparent): such samples are black and are noted in SampleBatch::cleared. What mirrors
/// show stays.
class ClearBackground : public Stage {
  public:
    void run(TileScratch& work, SampleBatch& batch) const override;
};

/// Before the stages see the samples of TileScratch::batch of a transparent picture.
void beginBackgroundSeen(TileScratch& work);
/// After the stages: adds what the cleared samples of `batch`, one of those of `work`, would have shown of
/// the background to TileScratch::backgroundSeen.
void noteBackgroundSeen(TileScratch& work, const SampleBatch& batch);

}  // namespace isoscope
