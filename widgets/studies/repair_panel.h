// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <QIcon>
#include <utility>
#include <vector>

#include "core/language/parse.h"
#include "core/study/gradient/statement_verdict.h"
#include "widgets/studies/study_panel.h"

class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace isoscope {

class ProgressRow;

/// Every isosurface statement of the scene and its include files: its max_gradient, what is proven, the
/// pixels that POV-Ray gets wrong, the time it wastes. What is ticked is written back by one click. What is
/// shown is found out by others, and handed in with show().
class RepairPanel : public StudyPanel {
    Q_OBJECT
  public:
    explicit RepairPanel(QWidget* parent = nullptr);

    /// How the file of the scene is asked for; empty for a text without one.
    void setSceneFile(std::function<std::filesystem::path()> file) { sceneFile_ = std::move(file); }
    /// What is known of the isosurfaces of `parsed`, null while the text is newer. `busy`: more is being
    /// found out; `stopped`: it would be, but for the user.
    void show(const std::shared_ptr<const ParseResult>& parsed, const std::vector<SurfaceVerdict>& verdicts,
              bool busy, bool stopped);
    void leaveDocument() override;

    /// Of the rows, in their order.
    const std::vector<StatementVerdict>& statements() const { return statements_; }
    /// Parts, for tests; never null.
    QTreeWidget* list() const { return list_; }
    QPushButton* writeButton() const { return write_; }
    QPushButton* stopButton() const;
    QPushButton* tickButton() const { return tick_; }
    QLabel* note() const;

  signals:
    /// The place of a row is to be shown.
    void placeRequested(const SourceRange& range);
    /// These isosurfaces, by number, are to have these values of max_gradient.
    void repairRequested(const std::map<std::size_t, double>& values);
    /// The work is to end, or to go on.
    void stopRequested();
    void goOnRequested();

  private:
    enum Column { place, setting, proven, toWrite, wrong, time, verdict, columnCount };
    using Key = std::pair<std::uint32_t, std::uint32_t>;  ///< file and place of a statement

    void buildList();
    void buildRow();
    void lookAtFiles();
    /// Why a mendable row is not to be written; empty when it may be.
    QString obstacleOf(const StatementVerdict& statement) const;
    bool isChosen(const StatementVerdict& statement) const;
    void showRows(const std::vector<SurfaceVerdict>& verdicts);
    void fill(QTreeWidgetItem* row, const StatementVerdict& statement, const SurfaceVerdict& worst);
    QIcon noBox() const;
    void showState(bool busy, bool stopped);
    void showChoice();
    void tickAll();
    std::map<std::size_t, double> chosenValues() const;

    std::function<std::filesystem::path()> sceneFile_;
    std::shared_ptr<const ParseResult> parsed_;
    std::vector<StatementVerdict> statements_;
    std::set<Key> unticked_;
    std::map<std::uint32_t, QString> obstacles_;  ///< of include files
    QTreeWidget* list_;
    ProgressRow* row_;
    QPushButton *tick_, *write_;
    bool stopped_ = false;
    bool filling_ = false;
};

}  // namespace isoscope
