// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/surface_chooser.h"

#include <algorithm>

#include "core/scene/scene.h"

namespace isoscope {

SurfaceChooser::SurfaceChooser(const QString& toolTip, const QString& first) : first_(first) {
    setToolTip(toolTip);
    setAccessibleName(tr("Isosurface"));
    setSizeAdjustPolicy(AdjustToContents);
    setScene(nullptr);
}

void SurfaceChooser::setScene(const Scene* scene) {
    const int count = scene ? static_cast<int>(scene->isosurfaces.size()) : 0;
    const int entries = count + (first_.isEmpty() ? 0 : 1);
    setVisible(count > 1);
    if (this->count() == entries) return;
    const int kept = std::clamp(currentIndex(), 0, std::max(0, entries - 1));
    clear();
    if (!first_.isEmpty()) addItem(first_);
    for (int i = 0; i < count; ++i) addItem(tr("Isosurface %1").arg(i + 1));
    if (entries > 0) setCurrentIndex(kept);
}

}  // namespace isoscope
