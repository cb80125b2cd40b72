// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/include_viewer.h"

#include <Qsci/qsciscintilla.h>

#include <algorithm>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/editor/editor_grounds.h"
#include "widgets/editor/scene_lexer.h"
#include "widgets/icons.h"

namespace isoscope {
namespace {

using Sci = QsciScintillaBase;

}  // namespace

IncludeViewer::IncludeViewer(QWidget* parent)
    : QFrame(parent),
      name_(new QLabel(this)),
      text_(new QsciScintilla(this)),
      lexer_(std::make_unique<SceneLexer>()) {
    setFrameShape(QFrame::StyledPanel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    auto* title = new QHBoxLayout;
    title->setContentsMargins(6, 2, 2, 2);
    name_->setTextFormat(Qt::PlainText);
    title->addWidget(name_, 1);
    auto* close = new QToolButton;
    close->setAutoRaise(true);
    close->setText(tr("Close"));
    close->setIcon(themeIcon(QStringLiteral("window-close")));
    close->setToolTip(tr("Close the include file (Esc)"));
    close->setAccessibleName(tr("Close the include file"));
    connect(close, &QToolButton::clicked, this, &IncludeViewer::leave);
    title->addWidget(close);
    layout->addLayout(title);
    layout->addWidget(text_, 1);
    text_->setUtf8(true);
    text_->setLexer(lexer_.get());
    text_->setMarginType(0, QsciScintilla::NumberMargin);
    text_->setMarginWidth(1, 0);
    text_->setScrollWidth(1);
    text_->setScrollWidthTracking(true);
    text_->setCaretLineVisible(true);
    text_->setFrameShape(QFrame::NoFrame);
    text_->setAccessibleName(tr("Include file, read only"));
    text_->installEventFilter(this);
    applyTheme();
    hide();
}

IncludeViewer::~IncludeViewer() {
    // The lexer goes first otherwise.
    text_->setLexer(nullptr);
}

void IncludeViewer::show(const SourceLibrary& sources, const SourceRange& range) {
    if (range.file >= sources.size()) return;
    const std::string_view text = sources[range.file].text();
    const QString name = QString::fromStdString(sources[range.file].name());
    name_->setText(tr("%1 – read only").arg(name.section('/', -1)));
    name_->setToolTip(name);
    text_->setReadOnly(false);
    text_->SendScintilla(Sci::SCI_CLEARALL);
    // Not setText(): it ends at the first NUL.
    text_->SendScintilla(Sci::SCI_ADDTEXT, static_cast<unsigned long>(text.size()), text.data());
    text_->SendScintilla(Sci::SCI_EMPTYUNDOBUFFER);
    text_->setReadOnly(true);
    text_->setMarginWidth(0, QString(static_cast<int>(QString::number(text_->lines()).size()) + 1, '9'));
    show();
    const long begin = range.begin, end = std::max<long>(range.end, begin);
    const long line = text_->SendScintilla(Sci::SCI_LINEFROMPOSITION, begin);
    const long shown = text_->SendScintilla(Sci::SCI_LINESONSCREEN);
    text_->SendScintilla(Sci::SCI_SETFIRSTVISIBLELINE, std::max(0L, line - shown / 3));
    text_->SendScintilla(Sci::SCI_SETSEL, static_cast<unsigned long>(end), begin);
    text_->setFocus(Qt::OtherFocusReason);
}

QString IncludeViewer::fileName() const { return name_->toolTip(); }

QString IncludeViewer::selectedText() const { return text_->selectedText(); }

void IncludeViewer::leave() {
    hide();
    emit closed();
}

bool IncludeViewer::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        leave();
        return true;
    }
    return QFrame::eventFilter(watched, event);
}

void IncludeViewer::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) applyTheme();
}

void IncludeViewer::applyTheme() {
    const Look look = lookOf(palette());
    lexer_->applyTheme(look);
    text_->setPaper(SceneLexer::paperColor(look));
    text_->setColor(SceneLexer::textColor(SceneStyle::plain, look));
    text_->setCaretForegroundColor(SceneLexer::textColor(SceneStyle::plain, look));
    text_->setCaretLineBackgroundColor(palette().color(QPalette::AlternateBase));
    text_->setMarginsBackgroundColor(palette().color(QPalette::Window));
    text_->setMarginsForegroundColor(SceneLexer::textColor(SceneStyle::comment, look));
    text_->setSelectionBackgroundColor(editorGrounds(look).selection);
    look == Look::highContrast
        ? text_->setSelectionForegroundColor(SceneLexer::textColor(SceneStyle::plain, look))
        : text_->resetSelectionForegroundColor();
    text_->resetSelectionForegroundColor();
}

}  // namespace isoscope
