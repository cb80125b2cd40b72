// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/files/start_page.h"

#include <QApplication>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include "widgets/gallery/gallery_panel.h"
#include "widgets/icons.h"

namespace isoscope {
namespace {

const QString wantedKey = QStringLiteral("window/startPage");
constexpr int margin = 12;
constexpr double titleScale = 1.4;

}  // namespace

StartPage::StartPage(QWidget* host) : QFrame(host) {
    setAutoFillBackground(true);
    setAccessibleName(tr("Start page"));
    setWhatsThis(tr("<p>Scenes to begin with. A click opens one; everything in it can be changed.</p>"));
    build();
    hide();
    host->installEventFilter(this);
}

bool StartPage::wantedAtStart() {
    const QSettings settings;
    return settings.value(wantedKey, !settings.contains(QStringLiteral("window/geometry"))).toBool();
}

void StartPage::build() {
    auto* title = new QLabel(tr("Begin with a picture"));
    QFont large = title->font();
    large.setPointSizeF(large.pointSizeF() * titleScale);
    large.setBold(true);
    title->setFont(large);
    auto* hint =
        new QLabel(tr("Choose one: its text opens at the left, and every number in it becomes a slider."));
    hint->setWordWrap(true);
    gallery_ = new GalleryPanel(nullptr, GalleryPanel::Kind::page);
    always_ = new QCheckBox(tr("Show this page at each start"));
    always_->setToolTip(tr("Otherwise File, Start Page opens it"));
    always_->setChecked(QSettings().value(wantedKey, false).toBool());
    connect(always_, &QCheckBox::toggled, this, [](bool on) { QSettings().setValue(wantedKey, on); });

    auto* ways = new QHBoxLayout;
    const auto way = [&](const char* icon, const QString& text, const QString& toolTip, auto signal) {
        auto* button = new QPushButton(themeIcon(QLatin1String(icon)), text);
        button->setToolTip(toolTip);
        connect(button, &QPushButton::clicked, this, [this, signal] {
            leave();
            emit(this->*signal)();
        });
        ways->addWidget(button);
    };
    way("document-new", tr("New Scene"), tr("Begin with an empty scene"), &StartPage::newRequested);
    way("document-open", tr("Open File…"), tr("Open a scene or include file"), &StartPage::fileRequested);
    way("help-contents", tr("Lessons"), tr("Read the short lessons about isosurfaces"),
        &StartPage::lessonsRequested);
    ways->addStretch(1);
    auto* close = new QPushButton(themeIcon(QStringLiteral("window-close")), tr("Close"));
    close->setToolTip(tr("Go on with the scene that is open (Esc)"));
    connect(close, &QPushButton::clicked, this, &StartPage::leave);
    ways->addWidget(close);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->addWidget(title);
    layout->addWidget(hint);
    layout->addLayout(ways);
    layout->addWidget(gallery_, 1);
    layout->addWidget(always_);
    connect(gallery_, &GalleryPanel::openRequested, this, &StartPage::leave);
}

void StartPage::open() {
    before_ = QApplication::focusWidget();
    setGeometry(parentWidget()->rect());
    show();
    raise();
    gallery_->startSearch();
}

void StartPage::leave() {
    if (isHidden()) return;
    const bool had = isAncestorOf(QApplication::focusWidget());
    hide();
    if (had && before_) before_->setFocus(Qt::OtherFocusReason);
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
    return false;
}

void StartPage::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) return leave();
    QFrame::keyPressEvent(event);
}

}  // namespace isoscope
