// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace isoscope {

struct Scene;

/// The isosurfaces of a scene to choose from, by number; hidden while there is no choice.
class SurfaceChooser : public QComboBox {
    Q_OBJECT

  public:
    /// `first` comes before the isosurfaces, if there is such an entry.
    explicit SurfaceChooser(const QString& toolTip, const QString& first = {});

    /// Lists the isosurfaces of a scene (none for null); what was chosen stays chosen as long as it is there.
    void setScene(const Scene* scene);

  private:
    QString first_;
};

}  // namespace isoscope
