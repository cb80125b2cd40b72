// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/functions/function_list_model.h"

#include <cmath>

#include "widgets/functions/function_snippet.h"
#include "widgets/thumbnail_renderer.h"

namespace isoscope {

FunctionListModel::FunctionListModel(QObject* parent)
    : QAbstractListModel(parent), pictures_(static_cast<qsizetype>(builtins().size())) {}

FunctionListModel::~FunctionListModel() = default;

void FunctionListModel::startPictures(double devicePixelRatio) {
    if (renderer_) return;
    ratio_ = devicePixelRatio;
    renderer_ = new ThumbnailRenderer(static_cast<int>(std::lround(pictureSize * ratio_)), {}, this);
    connect(renderer_, &ThumbnailRenderer::ready, this, [this](int row, const QImage& image) {
        if (image.isNull()) return;
        pictures_[row] = image;
        pictures_[row].setDevicePixelRatio(ratio_);
        emit dataChanged(index(row), index(row), {Qt::DecorationRole});
    });
    if (rowCount() > 0) emit dataChanged(index(0), index(rowCount() - 1), {Qt::DecorationRole});
}

int FunctionListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(builtins().size());
}

const Builtin& FunctionListModel::builtin(int row) { return builtins()[static_cast<std::size_t>(row)]; }

QVariant FunctionListModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const Builtin& shown = builtin(index.row());
    const QString name = QString::fromStdString(shown.name);
    switch (role) {
        case Qt::DisplayRole: return name;
        case Qt::ToolTipRole: return signature(shown);
        case Qt::AccessibleTextRole: return name + ", " + QString::fromStdString(shown.formula);
        case Qt::DecorationRole: return picture(index.row());
        case formulaRole: return QString::fromStdString(shown.formula);
        case searchRole: {
            QString text = name + ' ' + QString::fromStdString(shown.kind);
            for (const BuiltinParameter& parameter : shown.parameters)
                text += ' ' + QString::fromStdString(parameter.name);
            return text;
        }
        default: return {};
    }
}

QImage FunctionListModel::picture(int row) const {
    if (pictures_[row].isNull() && renderer_) {
        pictures_[row] = renderer_->thumbnail(row, thumbnailScene(builtin(row)));
        if (!pictures_[row].isNull()) pictures_[row].setDevicePixelRatio(ratio_);
    }
    return pictures_[row];
}

}  // namespace isoscope
