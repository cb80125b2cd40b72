// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/function/builtins/builtin.h"

class QLabel;
class QLineEdit;
class QListView;
class QPushButton;

namespace isoscope {

class FunctionListModel;
class FunctionFilter;

/// Every built-in with picture, formula and parameters, to be searched and inserted.
class FunctionBrowser : public QWidget {
    Q_OBJECT
  public:
    explicit FunctionBrowser(QWidget* parent = nullptr);
    ~FunctionBrowser() override;

    /// Shows and focuses the search field.
    void startSearch();
    /// The selected function; null when the search finds none.
    const Builtin* current() const;

  signals:
    /// A whole `isosurface { ... }` of the function is wanted in the text, or just the call.
    void statementRequested(const isoscope::Builtin* builtin);
    void callRequested(const isoscope::Builtin* builtin);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void build();
    void showDetails();
    void insertStatement();
    void insertCall();
    void selectFirst();

    FunctionListModel* model_ = nullptr;
    FunctionFilter* filter_ = nullptr;
    QLineEdit* search_ = nullptr;
    QListView* list_ = nullptr;
    QLabel* details_ = nullptr;
    QLabel* noMatch_ = nullptr;
    QPushButton* insertStatement_ = nullptr;
    QPushButton* insertCall_ = nullptr;
    bool painted_ = false;
};

}  // namespace isoscope
