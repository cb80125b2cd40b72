// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QImage>
#include <QTextBrowser>
#include <QList>

#include "widgets/help/help_markdown.h"

namespace isoscope {

class HelpLibrary;
class ThumbnailRenderer;

/// Shows one page of the help, with the way there and back. Links between pages are followed here; a link
/// "Open this scene" is for others. Pictures of functions come from the background.
class HelpBrowser : public QTextBrowser {
    Q_OBJECT
  public:
    /// `library` outlives the browser. Nothing is shown before open().
    explicit HelpBrowser(const HelpLibrary* library, QWidget* parent = nullptr);
    ~HelpBrowser() override;

    /// Shows the page at an address as a new step of the way, unless it is shown. The heading of its anchor
    /// is marked, or the `words` are, and the first one is scrolled to. An address without a page shows the
    /// index.
    void open(const QString& address, const QString& words = {});
    /// The address of the page that is shown, with the anchor that it was opened with.
    QString address() const;
    bool canGoBack() const { return at_ > 0; }
    bool canGoForward() const { return at_ + 1 < way_.size(); }
    /// Larger letters by so many points; smaller for negative ones.
    void setZoom(int points);
    /// Marks a text wherever it stands and selects the next place, or the one before; goes round at the ends.
    /// The number of places.
    int findText(const QString& text, bool forward);

  public slots:
    void backward() override;
    void forward() override;
    /// The index.
    void home() override;

  signals:
    /// Another page is shown, or the same one from another place.
    void pageChanged();
    void sceneRequested(const isoscope::HelpScene& scene);
    /// Ctrl+wheel: 1 for larger letters, -1 for smaller ones.
    void zoomRequested(int steps);

  protected:
    QVariant loadResource(int type, const QUrl& name) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    /// A step of the way.
    struct Stop {
        QString address;
        QString words;
        int scroll = -1;  ///< where it was left; -1 before that
    };

    void follow(const QUrl& link);
    /// Shows the present stop.
    void showStop();
    void leaveStop();
    /// To where the present stop was left, or else to what it is about.
    void scrollToStop();
    /// Marks the places of the texts and returns them, in the order of the page. Where a text stands as a
    /// whole word and `words` asks for that, its other places are left out.
    QList<QTextCursor> mark(const QStringList& texts, bool words);
    void mark(const QList<QTextCursor>& places);
    /// The heading of the anchor; null without one.
    QTextCursor heading(const QString& anchor) const;
    void showPicture(int index, QImage image);

    const HelpLibrary* library_;
    QList<Stop> way_;
    int at_ = -1;
    int zoom_ = 0;
    PreparedPage page_;
    QTextCursor subject_;  ///< what the stop is about, on this page
    int placed_ = -1;      ///< where scrollToStop() has scrolled to
    ThumbnailRenderer* pictures_ = nullptr;
    QHash<QString, QImage> known_;  ///< pictures by the names of their functions
};

}  // namespace isoscope
