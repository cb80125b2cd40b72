// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

namespace isoscope {

/// Shows a picture as large as fits, at most in its own size, and tells of clicks in pixels of the picture.
class SheetView : public QWidget {
    Q_OBJECT
  public:
    explicit SheetView(QWidget* parent = nullptr);

    /// A null image shows `empty`.
    void setImage(const QImage& image);
    void setEmptyText(const QString& text);
    /// Where a pixel of the picture is shown.
    QPoint placeOf(QPoint pixel) const;

  signals:
    /// The left button was released over this pixel of the picture.
    void clicked(QPoint pixel);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    QRectF frame() const;

    QImage image_;
    QString empty_;
};

}  // namespace isoscope
