// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "widgets/help/help_library.h"
#include "widgets/help/help_markdown.h"

class QLabel;
class QLineEdit;
class QModelIndex;
class QStackedWidget;
class QStandardItemModel;
class QToolButton;
class QTreeView;

namespace isoscope {

class HelpBrowser;
class WordFilter;

/// The help: a page, the way there and back, the list of all pages with a search for words in them, and a
/// field to find a text on the page. Escape gives the focus back.
class HelpPanel : public QWidget {
    Q_OBJECT
  public:
    explicit HelpPanel(QWidget* parent = nullptr);
    ~HelpPanel() override;

    QSize sizeHint() const override;

    /// Shows the page at an address in the place of the list; see HelpBrowser::open().
    void open(const QString& address, const QString& words = {});
    const HelpLibrary& library() const { return library_; }
    HelpBrowser* browser() const { return browser_; }
    /// Whether the list of pages is shown.
    bool listShown() const;

  signals:
    /// A link of the page asks for its scene.
    void sceneRequested(const isoscope::HelpScene& scene);
    /// The person is done with the keys here.
    void focusReleased();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget* makeBar();
    QWidget* makeList();
    QWidget* makeFindRow();
    QToolButton* addButton(QWidget* row, const char* icon, const QString& name, const QString& toolTip);
    void fillList();
    void search(const QString& words);
    void showList(bool shown);
    void choose(const QModelIndex& row);
    void chooseFirst();
    void findOnPage(bool forward);
    void pageChanged();

    HelpLibrary library_;
    QStandardItemModel* pages_;
    WordFilter* filter_;
    HelpBrowser* browser_;
    QToolButton* back_ = nullptr;
    QToolButton* forward_ = nullptr;
    QToolButton* contents_ = nullptr;
    QLineEdit* search_ = nullptr;
    QStackedWidget* stack_ = nullptr;
    QTreeView* list_ = nullptr;
    QLabel* noMatch_ = nullptr;
    QLineEdit* find_ = nullptr;
    QLabel* found_ = nullptr;
};

}  // namespace isoscope
