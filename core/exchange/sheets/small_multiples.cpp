// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/sheets/small_multiples.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/render/render_image.h"

namespace isoscope {

namespace {

std::string rounded(double value) {
    char text[32];
    constexpr int digits = 4;
    const auto written =
        std::to_chars(std::begin(text), std::end(text), value, std::chars_format::general, digits);
    return std::string(std::begin(text), written.ptr);
}

}  // namespace

SmallMultiples::SmallMultiples(const ParseResult& parsed, RenderRequest view, bool ownCamera,
                               VariedNumber first, std::optional<VariedNumber> second, int columns)
    : parsed_(parsed), view_(std::move(view)), ownCamera_(ownCamera) {
    const int count = static_cast<int>(first.values.size());
    const int square = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
    columns_ = std::max(1, second ? count : columns > 0 ? std::min(columns, count) : square);
    if (!second) {
        for (const double value : first.values)
            cells_.push_back({0, 0, {{first.parameter, value}}, rounded(value)});
    } else {
        for (const double down : second->values)
            for (const double across : first.values)
                cells_.push_back({0,
                                  0,
                                  {{first.parameter, across}, {second->parameter, down}},
                                  rounded(across) + ", " + rounded(down)});
    }
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        cells_[i].column = static_cast<int>(i) % columns_;
        cells_[i].row = static_cast<int>(i) / columns_;
    }
    rows_ = std::max(1, (static_cast<int>(cells_.size()) + columns_ - 1) / columns_);
    if (!tooLarge()) sheet_.emplace(columns_, rows_, view_.width, view_.height);
}

bool SmallMultiples::tooLarge() const {
    return PictureSheet::pixels(columns_, rows_, view_.width, view_.height) > mostPixels;
}

bool SmallMultiples::draw(std::size_t index, std::stop_token stop, int threads) {
    const Cell& cell = cells_[index];
    const auto scene = sceneWithNumbers(parsed_, cell.numbers);
    Image picture;
    if (scene) {
        RenderRequest request = view_;
        request.scene = scene;
        if (ownCamera_) request.camera = scene->camera;
        picture = renderImage(request, threads, nullptr, stop);
    }
    if (stop.stop_requested()) return false;
    sheet_->put(cell.column, cell.row, picture, cell.label);
    return scene != nullptr;
}

}  // namespace isoscope
