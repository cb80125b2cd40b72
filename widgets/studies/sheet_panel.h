// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <QImage>
#include <QSize>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/exchange/sheets/small_multiples.h"
#include "widgets/latest_worker.h"
#include "widgets/studies/study_panel.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace isoscope {

class NumberBox;
class SheetView;

/// The scene in small for values of one number, or of two, as one picture that grows while it is drawn. Drawn
/// when asked for; it stays until the next one. A click on a picture sets its values in the text.
class SheetPanel : public StudyPanel {
    Q_OBJECT
  public:
    /// Gives the text as it was read last; null while the text is newer.
    using Reader = std::function<std::shared_ptr<const ParseResult>()>;
    /// A number of the text and the value that it is to have.
    using Setting = std::pair<SceneParameter, double>;

    explicit SheetPanel(QWidget* parent = nullptr);
    ~SheetPanel() override;

    /// Where scenes come from; without one there is nothing to draw.
    void setReader(Reader reader) { reader_ = std::move(reader); }
    void setScene(std::shared_ptr<const Scene> scene) override;
    void setView(const Camera& camera, QSize size) override;
    void setActive(bool active) override;

    /// Starts a sheet; one that is being drawn ends.
    void draw();
    void stop();
    bool drawing() const { return drawing_; }
    /// Pictures that are on the sheet.
    int drawn() const { return drawn_; }
    const QImage& image() const { return image_; }
    /// Writes the sheet as it is shown; false when the file cannot be written.
    bool saveTo(const QString& path) const;

    /// Parts, for tests; never null. The number and its values: 0 across, 1 down.
    QComboBox* numbers(int which) const { return axes_[which].numbers; }
    NumberBox* from(int which) const { return axes_[which].from; }
    NumberBox* to(int which) const { return axes_[which].to; }
    QSpinBox* steps(int which) const { return axes_[which].steps; }
    SheetView* view() const { return view_; }
    QPushButton* startButton() const { return start_; }
    QPushButton* saveButton() const { return save_; }
    /// The middle of a picture of the sheet, in pixels of it.
    QPoint middleOf(int column, int row) const;

  signals:
    /// A click asks for these values.
    void valuesRequested(const QList<isoscope::SheetPanel::Setting>& values);

  private:
    struct Axis {
        QComboBox* numbers;
        NumberBox *from, *to;
        QSpinBox* steps;
    };

    QHBoxLayout* buildAxis(Axis& axis, bool second);
    void listNumbers();
    void takeEnds(const Axis& axis);
    const SceneParameter* number(const Axis& axis) const;
    std::optional<VariedNumber> varied(const Axis& axis, const ParseResult& parsed) const;
    void receive(const QImage& image, int count, std::uint64_t generation);
    void choose(QPoint pixel);
    void save();
    void refresh();

    Reader reader_;
    std::shared_ptr<const Scene> scene_;
    Camera camera_;
    QSize size_{160, 120};
    std::vector<SceneParameter> listed_;  ///< by the entries of `numbers`; behind an empty one in the second
    std::vector<SmallMultiples::Cell> cells_;  ///< of the sheet that is shown, with
    std::vector<SceneParameter> varied_;       ///< the numbers of its cells
    QSize cellSize_, grid_;
    QImage image_;
    int drawn_ = 0;
    Axis axes_[2];
    QPushButton *start_, *save_;
    QProgressBar* progress_;
    QLabel* note_;
    SheetView* view_;
    std::stop_source stop_;
    std::uint64_t generation_ = 0;
    bool drawing_ = false;
    bool active_ = false;
    LatestWorker worker_;  // last: its tasks refer to the panel
};

}  // namespace isoscope
