// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/files/example_menu.h"

#include <algorithm>
#include <cmath>
#include <QFile>
#include <QPixmap>
#include <QProxyStyle>
#include <QRegularExpression>

#include "widgets/thumbnail_renderer.h"

namespace isoscope {

namespace {

/// Gives the icons of one menu the size of its pictures.
class PictureStyle : public QProxyStyle {
  public:
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
        return metric == PM_SmallIconSize ? ExampleMenu::pictureSize
                                          : QProxyStyle::pixelMetric(metric, option, widget);
    }
};

QString readExample(const QString& name) {
    QFile file(QStringLiteral(":/examples/") + name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

}  // namespace

QString Example::text() const { return readExample(name); }

QString Example::title() const {
    static const QRegularExpression around(QStringLiteral("^/+\\s*|\\.$"));
    return text().section(QLatin1Char('\n'), 0, 0).remove(around);
}

std::vector<Example> exampleContents() {
    std::vector<Example> examples;
    for (const QString& line : readExample(QStringLiteral("contents.txt")).trimmed().split(QLatin1Char('\n')))
        examples.push_back(
            {line.section(QLatin1Char(' '), 0, 0), line.endsWith(QLatin1String(" as-povray"))});
    return examples;
}

ExampleMenu::ExampleMenu(QWidget* parent) : QMenu(parent) {
    auto* style = new PictureStyle;
    style->setParent(this);
    setStyle(style);
    QPixmap room(pictureSize, pictureSize);
    room.fill(Qt::transparent);
    for (const Example& example : exampleContents()) {
        if (example.name.isEmpty()) {
            addSeparator();
            continue;
        }
        QAction* entry = addAction(QIcon(room), example.title());
        entry->setToolTip(tr("Open the example %1").arg(example.name));
        entry->setData(example.name);
        entries_.push_back(entry);
        connect(entry, &QAction::triggered, this, [this, name = example.name] { emit chosen(name); });
    }
    connect(this, &QMenu::aboutToShow, this, &ExampleMenu::startPictures);
}

void ExampleMenu::startPictures() {
    if (renderer_) return;
    renderer_ =
        new ThumbnailRenderer(static_cast<int>(std::lround(pictureSize * devicePixelRatioF())), {}, this);
    connect(renderer_, &ThumbnailRenderer::ready, this, &ExampleMenu::showPicture);
    // The last request is the first to be served.
    for (int index = static_cast<int>(entries_.size()) - 1; index >= 0; --index)
        showPicture(index, renderer_->thumbnail(
                               index, readExample(entries_[index]->data().toString()).toStdString()));
}

void ExampleMenu::showPicture(int index, QImage image) {
    if (image.isNull()) return;
    image.setDevicePixelRatio(devicePixelRatioF());
    entries_[index]->setIcon(QIcon(QPixmap::fromImage(std::move(image))));
}

}  // namespace isoscope
