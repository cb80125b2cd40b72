// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <QImage>
#include <QList>

#include "core/function/builtins/builtin.h"

namespace isoscope {

class ThumbnailRenderer;

/// builtins() as a list: row i is builtins()[i]. Pictures are asked for when they are first shown.
class FunctionListModel : public QAbstractListModel {
    Q_OBJECT
  public:
    /// Data besides Qt's roles: the formula as a text, and what FunctionFilter searches.
    enum Role { formulaRole = Qt::UserRole + 1, searchRole };

    explicit FunctionListModel(QObject* parent = nullptr);
    ~FunctionListModel() override;

    /// The picture's edge in logical pixels.
    static constexpr int pictureSize = 64;

    /// Pictures are rendered for this ratio of device to logical pixels; starts the renderer at the first
    /// call.
    void startPictures(double devicePixelRatio);

    /// What a row shows.
    static const Builtin& builtin(int row);

    /// 0 below a row: the list is flat.
    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

  private:
    QImage picture(int row) const;

    ThumbnailRenderer* renderer_ = nullptr;
    double ratio_ = 1;
    mutable QList<QImage> pictures_;
};

}  // namespace isoscope
