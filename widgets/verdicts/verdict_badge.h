// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <QToolButton>
#include <vector>

#include "core/study/gradient/surface_verdict.h"
#include "widgets/look.h"

class QMenu;

namespace isoscope {

/// The worst verdict of all isosurfaces, for the status line: sign, words, and all verdicts in its tooltip. A
/// click asks to see the isosurface that it is about. Hidden while there is nothing to judge.
class VerdictBadge : public QToolButton {
    Q_OBJECT
  public:
    explicit VerdictBadge(QWidget* parent = nullptr);

    /// `lines` are those of the isosurfaces in the text, by their numbers; 0 for those elsewhere. `needed`
    /// are the values that the menu offers, by isosurface.
    void show(const std::vector<SurfaceVerdict>& verdicts, const std::vector<int>& lines,
              const std::map<std::size_t, double>& needed = {});
    /// The text is still being read: what was known may be wrong by now.
    void showReading();
    /// The isosurface that the badge is about.
    std::size_t isosurface() const { return isosurface_; }

  signals:
    /// The badge was clicked: its isosurface, by number, is asked for.
    void chosen(std::size_t isosurface);
    /// The menu asks for these values of max_gradient, by isosurface, as one step.
    void mendRequested(const std::map<std::size_t, double>& values);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void fillMenu(const std::map<std::size_t, double>& needed, const std::vector<int>& lines);
    void setIconOf(std::optional<GradientVerdict> verdict);

    QMenu* menu_;
    std::size_t isosurface_ = 0;
    std::optional<GradientVerdict> verdict_;  ///< of the icon, and
    Look look_ = Look::light;                 ///< for which it is drawn
    std::map<std::size_t, double> needed_;    ///< what the menu offers, and
    std::vector<int> lines_;                  ///< the lines that it names
};

}  // namespace isoscope
