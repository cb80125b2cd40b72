// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/functions/function_browser.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QVBoxLayout>
#include <utility>

#include "widgets/functions/function_delegate.h"
#include "widgets/functions/function_filter.h"
#include "widgets/functions/function_list_model.h"
#include "widgets/functions/function_snippet.h"
#include "widgets/icons.h"
#include "widgets/numbers/number_text.h"

namespace isoscope {
namespace {

QString detailsText(const Builtin& builtin) {
    QString text =
        QString("<p><b>%1</b></p><p>%2</p>")
            .arg(signature(builtin).toHtmlEscaped(), QString::fromStdString(builtin.formula).toHtmlEscaped());
    if (builtin.parameters.empty()) return text;
    text += "<table cellspacing='0' cellpadding='2'><tr>";
    for (const QString& head :
         {FunctionBrowser::tr("Parameter"), FunctionBrowser::tr("Default"), FunctionBrowser::tr("Range")})
        text += "<td><i>" + head + "</i>&nbsp;&nbsp;</td>";
    text += "</tr>";
    for (const BuiltinParameter& parameter : builtin.parameters)
        text +=
            FunctionBrowser::tr("<tr><td>%1&nbsp;&nbsp;</td><td>%2&nbsp;&nbsp;</td><td>%3 to %4</td></tr>")
                .arg(QString::fromStdString(parameter.name).toHtmlEscaped(),
                     numberText(parameter.defaultValue), numberText(parameter.minimum),
                     numberText(parameter.maximum));
    return text + "</table>";
}

}  // namespace

FunctionBrowser::FunctionBrowser(QWidget* parent) : QWidget(parent) {
    build();
    setAccessibleName(tr("Functions"));
    connect(search_, &QLineEdit::textChanged, this, [this](const QString& text) {
        filter_->setSearch(text);
        selectFirst();
    });
    connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &FunctionBrowser::showDetails);
    connect(list_, &QListView::doubleClicked, this, &FunctionBrowser::insertStatement);
    connect(insertStatement_, &QPushButton::clicked, this, &FunctionBrowser::insertStatement);
    connect(insertCall_, &QPushButton::clicked, this, &FunctionBrowser::insertCall);
    search_->installEventFilter(this);
    list_->installEventFilter(this);
    selectFirst();
}

FunctionBrowser::~FunctionBrowser() = default;

void FunctionBrowser::build() {
    model_ = new FunctionListModel(this);
    filter_ = new FunctionFilter(this);
    filter_->setSourceModel(model_);
    filter_->sort(0);
    search_ = new QLineEdit(this);
    search_->setPlaceholderText(tr("Search functions"));
    search_->setClearButtonEnabled(true);
    search_->addAction(themeIcon("edit-find"), QLineEdit::LeadingPosition);
    search_->setToolTip(tr("Words of the name or of parameters. Down goes to the list, Enter inserts"));
    search_->setAccessibleName(tr("Search functions"));

    list_ = new QListView(this);
    list_->setModel(filter_);
    list_->setItemDelegate(new FunctionDelegate(list_));
    list_->setUniformItemSizes(true);
    list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setAlternatingRowColors(true);
    list_->setToolTip(tr("Double-click or Enter inserts an isosurface of the function"));
    list_->setAccessibleName(tr("Functions"));
    noMatch_ = new QLabel(tr("No function matches the search."), list_->viewport());
    noMatch_->setForegroundRole(QPalette::PlaceholderText);
    noMatch_->setMargin(12);
    noMatch_->hide();

    details_ = new QLabel(this);
    details_->setWordWrap(true);
    details_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    details_->setMargin(6);
    details_->setAccessibleName(tr("About the function"));
    details_->setToolTip(tr("Formula and parameters of the selected function"));
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(details_);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setAccessibleName(tr("About the function"));
    scroll->setToolTip(details_->toolTip());
    auto* splitter = new QSplitter(Qt::Vertical, this);
    splitter->addWidget(list_);
    splitter->addWidget(scroll);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 1);
    splitter->setChildrenCollapsible(false);
    splitter->setSizes({420, 200});

    insertStatement_ = new QPushButton(tr("Insert isosurface"), this);
    insertStatement_->setToolTip(
        tr("Writes a whole isosurface that shows the function, beside what is there (Enter)"));
    insertStatement_->setAccessibleName(tr("Insert isosurface"));
    insertCall_ = new QPushButton(tr("Insert call"), this);
    insertCall_->setToolTip(tr("Writes just the call at the caret (Shift+Enter)"));
    insertCall_->setAccessibleName(tr("Insert call"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(insertStatement_);
    buttons->addWidget(insertCall_);
    buttons->addStretch(1);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addWidget(search_);
    layout->addWidget(splitter, 1);
    layout->addLayout(buttons);
}

void FunctionBrowser::startSearch() {
    show();
    search_->setFocus(Qt::ShortcutFocusReason);
    search_->selectAll();
}

const Builtin* FunctionBrowser::current() const {
    const QModelIndex index = filter_->mapToSource(list_->currentIndex());
    return index.isValid() ? &FunctionListModel::builtin(index.row()) : nullptr;
}

/// Pictures and the text of the details begin here: at the start of the program they would take time from the
/// first picture of the scene, and a panel behind another one gets a show event, too, but is not painted.
void FunctionBrowser::paintEvent(QPaintEvent* event) {
    QWidget::paintEvent(event);
    if (std::exchange(painted_, true)) return;
    model_->startPictures(devicePixelRatioF());
    QMetaObject::invokeMethod(this, &FunctionBrowser::showDetails, Qt::QueuedConnection);
}

void FunctionBrowser::showDetails() {
    const Builtin* builtin = current();
    details_->setText(builtin && painted_ ? detailsText(*builtin) : QString());
    insertStatement_->setEnabled(builtin);
    insertCall_->setEnabled(builtin);
}

void FunctionBrowser::selectFirst() {
    const bool any = filter_->rowCount() > 0;
    if (any && !list_->currentIndex().isValid()) list_->setCurrentIndex(filter_->index(0, 0));
    if (any) list_->scrollTo(list_->currentIndex());
    noMatch_->setVisible(!any);
    noMatch_->adjustSize();
    showDetails();
}

void FunctionBrowser::insertStatement() {
    if (const Builtin* builtin = current()) emit statementRequested(builtin);
}

void FunctionBrowser::insertCall() {
    if (const Builtin* builtin = current()) emit callRequested(builtin);
}

bool FunctionBrowser::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
        if (key->modifiers() & Qt::ShiftModifier)
            insertCall();
        else
            insertStatement();
        return true;
    }
    const bool walking = key->key() == Qt::Key_Down || key->key() == Qt::Key_Up ||
                         key->key() == Qt::Key_PageDown || key->key() == Qt::Key_PageUp;
    if (watched == search_ && walking) {
        // The list is walked through while the words stay under the fingers.
        QCoreApplication::sendEvent(list_, event);
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace isoscope
