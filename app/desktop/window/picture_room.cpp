// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/picture_room.h"

#include <algorithm>
#include <cmath>
#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QEvent>
#include <QLayout>
#include <QTabBar>
#include <QToolButton>

#include "app/desktop/window/dock_tabs.h"
#include "app/desktop/window/docks.h"

namespace isoscope {

namespace {

/// Of the area between tool bars and status line. A little more than what is promised, 0.45: panels have
/// minimum sizes.
constexpr double pictureShare = 0.47;
constexpr int lowestPicture = 240;
constexpr int narrowestPicture = 320;
/// What lies below is of no use when it is lower.
constexpr int lowestBelow = 150;
constexpr double usualBelow = 0.3;
/// Unfolds later than it folds, so that nothing flickers while a window is resized.
constexpr int roomToSpare = 24;
constexpr double usualUpper = 0.6;

}  // namespace

int PictureRoom::heightBelow(const Area& area, int wanted, bool folded) {
    const double promised = pictureShare * area.width * area.height / std::max(1, area.pictureWidth);
    const int spare = area.height - area.pictureFrame -
                      (wanted > 0 ? lowestPicture : std::max(lowestPicture, static_cast<int>(promised)));
    if (spare < lowestBelow + (folded ? roomToSpare : 0)) return 0;
    const int usual = static_cast<int>(usualBelow * area.height);
    return std::min(spare, std::max(lowestBelow, wanted > 0 ? wanted : usual));
}

int PictureRoom::textWidth(int windowWidth) {
    // From 36 columns in a small window to 80 in a large one, where more would be of no use.
    constexpr int narrowest = 350, widest = 700;
    return std::clamp(windowWidth * 46 / 100 - 152, narrowest, widest);
}

PictureRoom::PictureRoom(QMainWindow* window, Docks* docks, QWidget* picture)
    : QObject(window),
      window_(window),
      docks_(docks),
      picture_(picture),
      foldAction_(new QAction(tr("&Fold the Panels Below"), this)),
      button_(new QToolButton(window)) {
    foldAction_->setCheckable(true);
    foldAction_->setToolTip(
        tr("Leave of the panels below the picture only their tabs; a click on a tab unfolds them"));
    foldAction_->setStatusTip(foldAction_->toolTip());
    connect(foldAction_, &QAction::triggered, this, &PictureRoom::fold);
    button_->setAutoRaise(true);
    button_->hide();
    connect(button_, &QToolButton::clicked, this, [this] { fold(!folded_); });
    timer_.setSingleShot(true);
    timer_.setInterval(0);
    connect(&timer_, &QTimer::timeout, this, &PictureRoom::settle);
    connect(docks->tabs(), &DockTabs::changed, this, [this] { timer_.start(); });
    const auto unfoldFor = [this](QDockWidget* dock) {
        if (folded_ && !applying_ && below().contains(dock)) fold(false);
    };
    connect(docks->tabs(), &DockTabs::chosen, this, unfoldFor);
    connect(docks, &Docks::broughtUp, this, unfoldFor);
    window->installEventFilter(this);
    window->centralWidget()->installEventFilter(this);
    setFolded(false);
}

bool PictureRoom::eventFilter(QObject* watched, QEvent* event) {
    if (watched == window_) {
        // The first picture is to have its size at once.
        if (event->type() == QEvent::Show) settle();
        // Only what no panel takes reaches the window itself: the lines between them.
        if (event->type() == QEvent::MouseButtonPress) noteDrag(true);
        // The window itself has still to hear of the release.
        if (event->type() == QEvent::MouseButtonRelease)
            QTimer::singleShot(0, this, [this] { noteDrag(false); });
    } else if (watched == window_->centralWidget()) {
        // The window resizes its middle last, when all else has its place.
        if (event->type() == QEvent::Resize && !dragging_ && !applying_) timer_.start();
    }
    return QObject::eventFilter(watched, event);
}

QList<QDockWidget*> PictureRoom::below() const {
    QList<QDockWidget*> shown;
    for (QDockWidget* dock : docks_->all())
        if (!dock->isHidden() && !dock->isFloating() &&
            window_->dockWidgetArea(dock) == Qt::BottomDockWidgetArea)
            shown << dock;
    // A place without tabs could not be unfolded, nor several side by side.
    const QTabBar* bar = shown.isEmpty() ? nullptr : docks_->tabs()->barOf(shown.first());
    return bar && docks_->tabs()->docksOf(bar).size() == shown.size() ? shown : QList<QDockWidget*>();
}

PictureRoom::Area PictureRoom::area() const {
    QRect all = window_->centralWidget()->geometry();
    for (const QDockWidget* dock : docks_->all())
        if (!dock->isHidden() && !dock->isFloating() && dock->geometry().left() >= 0) all |= dock->geometry();
    const QWidget* middle = window_->centralWidget();
    return {all.width(), all.height(), middle->width(), middle->height() - picture_->height()};
}

void PictureRoom::fold(bool folded) {
    will_ = folded ? Will::folded : Will::open;
    settle();
}

void PictureRoom::reset() {
    will_ = Will::none;
    textShare_ = upperShare_ = belowShare_ = 0;
    timer_.start();
}

void PictureRoom::settle() {
    if (window_->isMinimized()) return;
    timer_.stop();
    applying_ = true;
    // The places of all panels follow from each other's: how high the picture may be, from how wide it is
    // then.
    constexpr int mostRounds = 3;
    for (int round = 0; round < mostRounds; ++round) {
        const QSize before = window_->centralWidget()->size();
        apply();
        window_->layout()->activate();
        if (window_->centralWidget()->size() == before) break;
    }
    applying_ = false;
    showButton();
}

void PictureRoom::apply() {
    QList<QDockWidget*> column;
    QDockWidget* text = docks_->at(Docks::Place::upperLeft).first();
    for (QDockWidget* dock : docks_->at(Docks::Place::upperLeft) + docks_->at(Docks::Place::lowerLeft))
        if (!dock->isHidden() && !dock->isFloating() &&
            window_->dockWidgetArea(dock) == window_->dockWidgetArea(text))
            column << dock;
    const int width = window_->width();
    if (!column.isEmpty()) {
        const int wanted =
            textShare_ > 0 ? static_cast<int>(std::lround(textShare_ * width)) : textWidth(width);
        window_->resizeDocks({column.first()}, {std::min(wanted, width - narrowestPicture)}, Qt::Horizontal);
        const int height = area().height;
        const int upper =
            static_cast<int>(std::lround((upperShare_ > 0 ? upperShare_ : usualUpper) * height));
        if (column.first() == text && column.size() > 1)
            window_->resizeDocks({text, column[1]}, {upper, height - upper}, Qt::Vertical);
    }
    const QList<QDockWidget*> lower = below();
    if (lower.isEmpty()) return setFolded(false);
    const Area room = area();
    const int wanted = static_cast<int>(std::lround(belowShare_ * window_->height()));
    const int height = heightBelow(room, wanted, folded_);
    if (will_ == Will::open && height > 0) will_ = Will::none;
    // A person's wish holds as long as there is any picture at all.
    const bool fits = room.height - room.pictureFrame - lowestBelow >= lowestPicture / 2;
    if (will_ == Will::open && !fits) will_ = Will::none;
    setFolded(will_ == Will::folded || (will_ == Will::none && height == 0));
    if (!folded_) window_->resizeDocks({lower.first()}, {std::max(height, lowestBelow)}, Qt::Vertical);
}

void PictureRoom::setFolded(bool folded) {
    folded_ = folded;
    foldAction_->setChecked(folded);
    const QList<QDockWidget*> lower = folded ? below() : QList<QDockWidget*>();
    for (QDockWidget* dock : docks_->all()) {
        const int most = lower.contains(dock) ? 0 : QWIDGETSIZE_MAX;
        if (dock->maximumHeight() != most) dock->setMaximumHeight(most);
    }
}

void PictureRoom::showButton() {
    const QList<QDockWidget*> lower = below();
    const QTabBar* bar = lower.isEmpty() ? nullptr : docks_->tabs()->barOf(lower.first());
    button_->setVisible(bar);
    if (!bar) return;
    button_->setArrowType(folded_ ? Qt::UpArrow : Qt::DownArrow);
    const QString name = folded_ ? tr("Unfold the panels below") : tr("Fold the panels below");
    button_->setToolTip(name);
    button_->setAccessibleName(name);
    const QRect row(bar->geometry().left(), bar->geometry().top(), window_->centralWidget()->width(),
                    bar->height());
    const int side = row.height() - 4;
    button_->setGeometry(row.right() - side - 1, row.top() + 2, side, side);
    button_->raise();
}

PictureRoom::Sizes PictureRoom::sizes() const {
    const QList<QDockWidget*> lower = below();
    const QDockWidget* text = docks_->at(Docks::Place::upperLeft).first();
    const auto shown =
        std::find_if(lower.begin(), lower.end(), [](auto* dock) { return dock->geometry().left() >= 0; });
    return {
        text->width(), text->height(),
        folded_ || shown == lower.end() ? 0 : docks_->tabs()->barOf(*shown)->height() + (*shown)->height()};
}

/// What has another size when the button is released was dragged.
void PictureRoom::noteDrag(bool begins) {
    dragging_ = begins;
    if (begins) {
        pressed_ = sizes();
        return;
    }
    const Sizes now = sizes();
    if (now.text != pressed_.text) textShare_ = static_cast<double>(now.text) / window_->width();
    if (now.upper != pressed_.upper)
        upperShare_ = static_cast<double>(now.upper) / std::max(1, area().height);
    if (now.below != pressed_.below) belowShare_ = static_cast<double>(now.below) / window_->height();
}

QString PictureRoom::choices() const {
    return QStringLiteral("%1 %2 %3 %4")
        .arg(static_cast<int>(will_))
        .arg(textShare_)
        .arg(upperShare_)
        .arg(belowShare_);
}

void PictureRoom::setChoices(const QString& choices) {
    const QStringList parts = choices.split(QLatin1Char(' '));
    if (parts.size() != 4) return reset();
    const auto share = [](const QString& text) { return std::clamp(text.toDouble(), 0.0, 0.9); };
    will_ = static_cast<Will>(std::clamp(parts[0].toInt(), 0, 2));
    textShare_ = share(parts[1]);
    upperShare_ = share(parts[2]);
    belowShare_ = share(parts[3]);
    timer_.start();
}

}  // namespace isoscope
