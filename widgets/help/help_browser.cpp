// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/help_browser.h"

#include <algorithm>
#include <cmath>
#include <QDesktopServices>
#include <QScrollBar>
#include <QTextBlock>
#include <QWheelEvent>

#include "core/function/builtins/builtin.h"
#include "widgets/functions/function_snippet.h"
#include "widgets/help/help_library.h"
#include "widgets/thumbnail_renderer.h"

namespace isoscope {
namespace {

/// The edge of a function's picture in logical pixels.
constexpr int pictureSize = 160;
constexpr int marginAround = 10;
constexpr double smallestLetters = 6;

}  // namespace

HelpBrowser::HelpBrowser(const HelpLibrary* library, QWidget* parent)
    : QTextBrowser(parent), library_(library) {
    setOpenLinks(false);
    setUndoRedoEnabled(false);
    setAccessibleName(tr("Page of the help"));
    document()->setDocumentMargin(marginAround);
    connect(this, &QTextBrowser::anchorClicked, this, &HelpBrowser::follow);
}

HelpBrowser::~HelpBrowser() = default;

QString HelpBrowser::address() const { return at_ < 0 ? QString() : way_[at_].address; }

void HelpBrowser::open(const QString& address, const QString& words) {
    leaveStop();
    const bool known = library_->isPage(address.section(QLatin1Char('#'), 0, 0));
    const Stop stop{known ? address : HelpLibrary::index(), words};
    if (at_ >= 0 && way_[at_].address == stop.address && way_[at_].words == words) {
        // The same question again is no step.
        way_[at_] = stop;
    } else {
        way_.resize(++at_);
        way_.push_back(stop);
    }
    showStop();
}

void HelpBrowser::backward() {
    if (!canGoBack()) return;
    leaveStop();
    --at_;
    showStop();
}

void HelpBrowser::forward() {
    if (!canGoForward()) return;
    leaveStop();
    ++at_;
    showStop();
}

void HelpBrowser::home() { open(HelpLibrary::index()); }

void HelpBrowser::setZoom(int points) {
    if (points == zoom_) return;
    zoom_ = points;
    if (at_ < 0) return;
    leaveStop();
    showStop();
}

void HelpBrowser::leaveStop() {
    if (at_ >= 0) way_[at_].scroll = verticalScrollBar()->value();
}

void HelpBrowser::showStop() {
    const Stop& stop = way_[at_];
    const QString file = stop.address.section(QLatin1Char('#'), 0, 0);
    page_ = preparedPage(library_->text(file), file,
                         [this](const QString& address) { return library_->isPage(address); });
    QFont letters = font();
    letters.setPointSizeF(std::max(smallestLetters, letters.pointSizeF() + zoom_));
    document()->clear();
    document()->setDefaultFont(letters);
    document()->setMarkdown(page_.markdown,
                            QTextDocument::MarkdownFeatures(QTextDocument::MarkdownDialectGitHub |
                                                            QTextDocument::MarkdownNoHTML));
    dressDocument(document(), palette());
    const QList<QTextCursor> found = mark(stop.words.split(' ', Qt::SkipEmptyParts), true);
    subject_ = found.isEmpty() ? heading(stop.address.section(QLatin1Char('#'), 1)) : found.first();
    if (found.isEmpty() && !subject_.isNull()) mark(QList{subject_});
    moveCursor(QTextCursor::Start);
    scrollToStop();
    emit pageChanged();
}

void HelpBrowser::scrollToStop() {
    const Stop& stop = way_[at_];
    if (stop.scroll >= 0) {
        verticalScrollBar()->setValue(stop.scroll);
    } else if (!subject_.isNull()) {
        // A word not at the very edge: what stands before tells what it is about.
        QTextCursor begin(subject_);
        begin.setPosition(subject_.selectionStart());
        const bool section = subject_.blockFormat().headingLevel() > 0;
        const int above = section ? marginAround : viewport()->height() / 3;
        verticalScrollBar()->setValue(cursorRect(begin).top() + verticalScrollBar()->value() - above);
    }
    placed_ = verticalScrollBar()->value();
}

void HelpBrowser::resizeEvent(QResizeEvent* event) {
    const bool untouched = at_ >= 0 && verticalScrollBar()->value() == placed_;
    QTextBrowser::resizeEvent(event);
    // The panel gets its width after its first page; and lines break elsewhere then.
    if (untouched && way_[at_].scroll < 0) scrollToStop();
}

void HelpBrowser::follow(const QUrl& link) {
    if (link.scheme() == QLatin1String("scene")) {
        const std::size_t index = link.path().toUInt();
        // A copy: what opens it may show another page.
        if (index < page_.scenes.size()) emit sceneRequested(HelpScene(page_.scenes[index]));
    } else if (link.scheme().isEmpty()) {
        open(link.toString().mid(1));
    } else {
        QDesktopServices::openUrl(link);
    }
}

QList<QTextCursor> HelpBrowser::mark(const QStringList& texts, bool words) {
    QList<QTextCursor> places;
    for (const QString& text : texts) {
        if (text.isEmpty()) continue;
        const auto all = [&](QTextDocument::FindFlags flags) {
            QList<QTextCursor> found;
            for (QTextCursor at = document()->find(text, 0, flags); !at.isNull();
                 at = document()->find(text, at, flags))
                found << at;
            return found;
        };
        const QList<QTextCursor> whole = words ? all(QTextDocument::FindWholeWords) : QList<QTextCursor>();
        places << (whole.isEmpty() ? all({}) : whole);
    }
    mark(places);
    std::ranges::sort(places, {}, &QTextCursor::selectionStart);
    return places;
}

void HelpBrowser::mark(const QList<QTextCursor>& places) {
    QColor ground = palette().color(QPalette::Highlight);
    constexpr int translucent = 90;
    ground.setAlpha(translucent);
    QList<ExtraSelection> marks;
    for (const QTextCursor& place : places) {
        ExtraSelection selection;
        selection.cursor = place;
        selection.format.setBackground(ground);
        marks << selection;
    }
    setExtraSelections(marks);
}

QTextCursor HelpBrowser::heading(const QString& anchor) const {
    for (QTextBlock block = document()->begin(); block.isValid() && !anchor.isEmpty(); block = block.next())
        if (block.blockFormat().headingLevel() > 0 && headingAnchor(block.text()) == anchor) {
            QTextCursor cursor(block);
            cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
            return cursor;
        }
    return {};
}

int HelpBrowser::findText(const QString& text, bool forward) {
    const QList<QTextCursor> places = mark({text}, false);
    if (places.isEmpty()) return 0;
    const int from = textCursor().selectionStart();
    const bool selected = textCursor().hasSelection();
    QTextCursor next = forward ? places.first() : places.last();
    if (forward) {
        const auto after = std::ranges::find_if(places, [&](const QTextCursor& place) {
            return selected ? place.selectionStart() > from : place.selectionStart() >= from;
        });
        if (after != places.end()) next = *after;
    } else {
        for (const QTextCursor& place : places)
            if (place.selectionStart() < from) next = place;
    }
    setTextCursor(next);
    return static_cast<int>(places.size());
}

QVariant HelpBrowser::loadResource(int type, const QUrl& name) {
    if (type != QTextDocument::ImageResource || name.scheme() != QLatin1String("picture"))
        return QTextBrowser::loadResource(type, name);
    const QString function = name.path();
    if (known_.contains(function)) return known_[function];
    const double ratio = devicePixelRatioF();
    const int edge = static_cast<int>(std::lround(pictureSize * ratio));
    if (!pictures_) {
        pictures_ = new ThumbnailRenderer(edge, {}, this);
        connect(pictures_, &ThumbnailRenderer::ready, this, &HelpBrowser::showPicture);
    }
    const Builtin* builtin = findBuiltin(function.toStdString());
    if (!builtin) return {};
    const auto index = static_cast<int>(builtin - builtins().data());
    QImage image = pictures_->thumbnail(index, thumbnailScene(*builtin));
    if (image.isNull()) {
        // Its room, until it is there.
        image = QImage(edge, edge, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
    } else {
        known_[function] = image;
    }
    image.setDevicePixelRatio(ratio);
    return image;
}

void HelpBrowser::showPicture(int index, QImage image) {
    if (image.isNull()) return;
    image.setDevicePixelRatio(devicePixelRatioF());
    const QString function = QString::fromStdString(builtins()[static_cast<std::size_t>(index)].name);
    known_[function] = image;
    document()->addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("picture:") + function), image);
    document()->markContentsDirty(0, document()->characterCount());
}

void HelpBrowser::wheelEvent(QWheelEvent* event) {
    if (!(event->modifiers() & Qt::ControlModifier)) return QTextBrowser::wheelEvent(event);
    if (event->angleDelta().y() != 0) emit zoomRequested(event->angleDelta().y() > 0 ? 1 : -1);
    event->accept();
}

void HelpBrowser::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    if (event->type() != QEvent::PaletteChange || at_ < 0) return;
    leaveStop();
    showStop();
}

}  // namespace isoscope
