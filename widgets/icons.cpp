// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/icons.h"

#include <algorithm>
#include <QApplication>
#include <QDir>
#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QStandardPaths>
#include <QStyle>

#include "widgets/look.h"

namespace isoscope {
namespace {

/// Of icons that the style has nothing like.
constexpr auto noPixmap = QStyle::SP_CustomBase;

QStyle::StandardPixmap standardPixmap(const QString& name) {
    static const QHash<QString, QStyle::StandardPixmap> pixmaps = {
        {"document-new", QStyle::SP_FileIcon},
        {"document-open", QStyle::SP_DialogOpenButton},
        {"document-save", QStyle::SP_DialogSaveButton},
        {"document-save-as", QStyle::SP_DialogSaveButton},
        {"edit-undo", QStyle::SP_ArrowBack},
        {"edit-redo", QStyle::SP_ArrowForward},
        {"edit-find", QStyle::SP_FileDialogContentsView},
        {"edit-find-replace", QStyle::SP_FileDialogDetailedView},
        {"edit-clear", QStyle::SP_DialogResetButton},
        {"process-stop", QStyle::SP_BrowserStop},
        {"help-about", QStyle::SP_MessageBoxInformation},
        {"go-up-search", QStyle::SP_ArrowUp},
        {"go-down-search", QStyle::SP_ArrowDown},
        {"document-export", QStyle::SP_DialogSaveButton},
        {"application-exit", QStyle::SP_DialogCloseButton},
        {"go-up", QStyle::SP_ArrowUp},
        {"go-down", QStyle::SP_ArrowDown},
        {"dialog-error", QStyle::SP_MessageBoxCritical},
        {"dialog-warning", QStyle::SP_MessageBoxWarning},
        {"dialog-information", QStyle::SP_MessageBoxInformation},
        {"window-close", QStyle::SP_TitleBarCloseButton},
        {"view-refresh", QStyle::SP_BrowserReload},
        {"media-playback-start", QStyle::SP_MediaPlay},
        {"media-playback-stop", QStyle::SP_MediaStop},
        {"help-contents", QStyle::SP_DialogHelpButton},
        {"go-home", QStyle::SP_DirHomeIcon},
    };
    return pixmaps.value(name, noPixmap);
}

/// The edge, in pixels, for which themes draw what tool bars show: line drawings of the text's colour.
constexpr int toolBarEdge = 22;

/// The file of that drawing in the theme of now; empty without one.
QString drawingOf(const QString& name) {
    static QHash<QString, QString> known;
    const QString key = QIcon::themeName() + QLatin1Char('/') + name;
    const auto found = known.constFind(key);
    if (found != known.constEnd()) return *found;
    for (const QString& folder : QIcon::themeSearchPaths()) {
        const QDir theme(folder + QLatin1Char('/') + QIcon::themeName());
        for (const QString& context : theme.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
            const QString file =
                theme.filePath(QStringLiteral("%1/%2/%3.svg").arg(context).arg(toolBarEdge).arg(name));
            if (QFile::exists(file)) return *known.insert(key, file);
        }
    }
    return *known.insert(key, QString());
}

/// Every colour of the picture made light enough for high contrast.
QPixmap legibleOnBlack(const QPixmap& pixmap) {
    static QHash<QRgb, QRgb> known;
    QImage image = pixmap.toImage().convertToFormat(QImage::Format_ARGB32);
    for (int y = 0; y < image.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x) {
            const QRgb color = line[x] | 0xff000000U;
            if (!known.contains(color))
                known.insert(color, legible(QColor::fromRgb(color), Qt::black, highContrastRatio).rgb());
            line[x] = (known[color] & 0x00ffffffU) | (line[x] & 0xff000000U);
        }
    }
    return QPixmap::fromImage(image);
}

/// An icon of the theme that looks the same at every size: where more pixels are asked for than tool bars
/// have, their drawing is drawn larger. Follows a change of the theme.
class ThemeIconEngine : public QIconEngine {
  public:
    explicit ThemeIconEngine(const QString& name) : name_(name) {}

    QIconEngine* clone() const override { return new ThemeIconEngine(*this); }
    QString iconName() override { return name_; }
    bool isNull() override { return QIcon::fromTheme(name_).isNull(); }
    QSize actualSize(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        return iconFor(size).actualSize(size, mode, state);
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        return scaledPixmap(size, mode, state, 1);
    }
    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State state, qreal) override {
        const QPixmap drawn = iconFor(size).pixmap(size, 1, mode, state);
        return mode != QIcon::Disabled && lookOf(QApplication::palette()) == Look::highContrast
                   ? legibleOnBlack(drawn)
                   : drawn;
    }
    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const qreal scale = painter->device()->devicePixelRatio();
        painter->drawPixmap(rect, scaledPixmap((QSizeF(rect.size()) * scale).toSize(), mode, state, scale));
    }

  private:
    QIcon iconFor(const QSize& size) const {
        const QString drawing =
            std::max(size.width(), size.height()) > toolBarEdge ? drawingOf(name_) : QString();
        return drawing.isEmpty() ? QIcon::fromTheme(name_) : QIcon(drawing);
    }

    QString name_;
};

/// Whether the theme's pictures can be read: they need Qt's SVG plug-in. Asked of one icon for all of them,
/// since the answer draws it, and a window has a hundred, most of them in menus.
bool canDraw(const QIcon& icon) {
    static const bool can = !icon.pixmap(16, 16).isNull();
    return can;
}

}  // namespace

void useIconTheme(bool dark) {
    // The platform plug-in "offscreen" does not know the system's folders.
    QStringList paths = QIcon::themeSearchPaths();
    const QStringList folders = QStandardPaths::locateAll(QStandardPaths::GenericDataLocation, "icons",
                                                          QStandardPaths::LocateDirectory);
    for (const QString& folder : folders + QStringList{"/usr/share/icons", ":/icons"})
        if (!paths.contains(folder)) paths << folder;
    QIcon::setThemeSearchPaths(paths);
    QIcon::setFallbackThemeName("hicolor");
    QIcon::setThemeName(dark ? "breeze-dark" : "breeze");
}

QIcon themeIcon(const QString& name) {
    const QIcon icon = QIcon::fromTheme(name);
    if (!icon.isNull() && canDraw(icon)) return QIcon(new ThemeIconEngine(name));
    const QStyle::StandardPixmap pixmap = standardPixmap(name);
    return pixmap == noPixmap ? QIcon() : QApplication::style()->standardIcon(pixmap);
}

}  // namespace isoscope
