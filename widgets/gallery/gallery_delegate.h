// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace isoscope {

/// Draws an entry of the gallery: its picture, or a frame until there is one, the title below, and a line of
/// its sentence, softer.
class GalleryDelegate : public QStyledItemDelegate {
    Q_OBJECT
  public:
    /// Small: one line of the sentence. Large: three, for a page.
    enum class Size { small, large };
    GalleryDelegate(Size size, QObject* parent);

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    /// The field for another title lies over the title.
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;

  private:
    int width_;  ///< of an entry, at 100 %
    int lines_;  ///< of its sentence
};

}  // namespace isoscope
