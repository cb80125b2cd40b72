// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "core/evaluate/reference_evaluator.h"
#include "core/image/brightness.h"
#include "core/language/directives/asset_file.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/functions/function_parser.h"
#include "core/language/objects/shape_parser.h"
#include "core/language/objects/shape_reader.h"
#include "core/shapes/patches/height_field.h"

namespace isoscope {

namespace {

constexpr int sideLimit = 16'384;
constexpr std::size_t heightLimit = std::size_t{1} << 24;

class HeightFieldReader {
  public:
    explicit HeightFieldReader(ShapeReader& reader) : reader_(reader), tokens_(reader.tokens()) {}

    ShapePointer parse() {
        HeightGrid grid;
        if (tokens_.accept("function"))
            grid = parseFunction();
        else
            grid = parseImage();
        double water = 0;
        bool smooth = false, hierarchy = true;
        for (;;) {
            if (tokens_.accept("water_level")) {
                water = reader_.number("water_level");
                if (!(water >= 0 && water <= 1))
                    reader_.warn(reader_.range(), "The water level of a height field lies between 0 and 1.");
            } else if (!reader_.flag("smooth", smooth) && !reader_.flag("hierarchy", hierarchy)) {
                break;
            }
        }
        if (reader_.failed() || !reader_.finite() || leftOut_) return nullptr;
        if (grid.columns < 2 || grid.rows < 2) {
            reader_.fail(reader_.keywordRange(), "A height field needs at least 2 by 2 heights.");
            return nullptr;
        }
        return std::make_shared<HeightField>(std::move(grid), water, smooth);
    }

  private:
    HeightGrid parseFunction() {
        HeightGrid grid;
        grid.columns = reader_.count("number of columns", 2, sideLimit);
        grid.rows = reader_.count("number of rows", 2, sideLimit);
        const SourceRange range = reader_.range();
        const FunctionValue value = FunctionParser(tokens_).parse();
        const auto size = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
        if (size > heightLimit) reader_.fail(range, "A height field has at most 16 777 216 heights.");
        if (!value.function.valid()) {
            leftOut_ = true;
            return grid;
        }
        if (value.function.argumentCount != 3 || value.function.results.empty())
            reader_.fail(range, "The heights of a height field need a function of x and y.");
        // A slider cannot move what is computed now.
        tokens_.context().markStructural(value.function);
        const std::size_t steps = size * (value.function.graph->size() / 4 + 1);
        if (reader_.failed()) return grid;
        leftOut_ = !tokens_.charge(steps, range);
        if (leftOut_) return grid;
        ReferenceEvaluator evaluator(value.function);
        for (int row = grid.rows - 1; row >= 0; --row) {
            leftOut_ = leftOut_ || !tokens_.charge(0, range);
            if (leftOut_) return grid;
            for (int column = 0; column < grid.columns; ++column) {
                // The function is asked for an image, whose first row is the far one; heights have 16 bits.
                const std::array<double, 3> at{static_cast<double>(column) / (grid.columns - 1),
                                               static_cast<double>(row) / (grid.rows - 1), 0};
                const double height = evaluator.evaluate(at, tokens_.context().parameterTable, 0);
                grid.heights.push_back(
                    std::isfinite(height) ? std::floor(std::clamp(height, 0.0, 1.0) * 65535) / 65536 : 0);
            }
        }
        return grid;
    }

    HeightGrid parseImage() {
        // The file says itself what it is: `sys`, the format of the machine, may be any.
        static constexpr std::array<const char*, 10> types{"png", "gif", "tga",  "pgm",  "ppm",
                                                           "bmp", "pot", "jpeg", "tiff", "sys"};
        const bool potential = tokens_.peek().is("pot");
        for (const char* word : types)
            if (tokens_.accept(word)) break;
        return parseFile(potential);
    }

    HeightGrid parseFile(bool potential = false) {
        const SourceRange start = tokens_.peek().range;
        const std::string name = ExpressionParser(tokens_).parseString();
        const SourceRange range = rangeSince(start, tokens_);
        const auto file = findAsset(tokens_.context(), name, start);
        if (!file) {
            reader_.fail(range,
                         file.whyNot("The image \"" + name +
                                     "\" was not found beside the scene or in the library paths."),
                         file.hint);
            return {};
        }
        std::string problem;
        const std::optional<Raster> raster = readRaster(*file, problem);
        if (!raster) {
            reader_.fail(range, "The image \"" + name + "\" cannot be used: " + problem + ".");
            return {};
        }
        if (rasterFormat(*file) == RasterFormat::png) return heightGrid(asPovrayReadsPng(*raster));
        return heightGrid(potential ? asPotential(*raster) : *raster);
    }

    /// Fractint's continuous potential: numbers of 16 bits, whose low bytes are the right half of the image.
    static Raster asPotential(const Raster& bytes) {
        if (bytes.channels != 1 || bytes.largest > 255 || bytes.width < 2) return bytes;
        Raster raster;
        raster.width = bytes.width / 2;
        raster.height = bytes.height;
        raster.largest = 65535;
        for (int y = 0; y < raster.height; ++y)
            for (int x = 0; x < raster.width; ++x)
                raster.samples.push_back(
                    static_cast<std::uint16_t>(bytes.at(x, y) << 8 | bytes.at(x + raster.width, y)));
        return raster;
    }

    /// POV-Ray makes colours of the grey values of 8-bit PNG images without alpha, and their brightness in
    /// single precision: some lose one step.
    static Raster asPovrayReadsPng(Raster raster) {
        if (raster.channels != 1 || raster.indexed || raster.largest != 255 || !raster.alpha.empty())
            return raster;
        for (std::uint16_t& sample : raster.samples) {
            const float grey = static_cast<float>(sample) / 255.0f;
            sample = static_cast<std::uint16_t>(brightness<float>(grey, grey, grey) * 255.0f);
        }
        return raster;
    }

    ShapeReader& reader_;
    TokenStream& tokens_;
    bool leftOut_ = false;
};

ShapePointer parseHeightField(ShapeReader& reader) { return HeightFieldReader(reader).parse(); }

}  // namespace

std::span<const ShapeParser> heightFieldParser() {
    static constexpr std::array parsers{
        ShapeParser{.keyword = "height_field",
                    .parse = parseHeightField,
                    .words = "function png jpeg gif tga pgm ppm tiff bmp sys smooth water_level",
                    .ignoresOwnBounds = true},
    };
    return parsers;
}

}  // namespace isoscope
