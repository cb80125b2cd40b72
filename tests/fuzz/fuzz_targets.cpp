// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/fuzz_targets.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

#include "core/image/raster_file.h"
#include "core/language/parse.h"
#include "core/shapes/solids/font_file.h"
#include "core/text/csv_table.h"
#include "core/texture/tables/density_table.h"
#include "core/virtualight/scene_reader.h"
#include "test_folders.h"

namespace isoscope::test {

namespace {

namespace fs = std::filesystem;

/// Small limits, for many executions a second: a loop without an end costs little more than a text with none.
ParseOptions quickOptions(const char* name, std::string_view bytes) {
    ParseOptions options;
    options.file = fs::temp_directory_path() / "isoscope-fuzz" / name;
    options.restrictedReading = true;
    options.stepBudget = std::clamp<std::size_t>(32 * bytes.size(), 2'000, 20'000);
    options.secondsBudget = 5;
    // That of texts without #version, which most parts of texts are: with another one they are read twice.
    options.noiseGenerator = 1;
    return options;
}

void readScene(std::string_view bytes) { parseScene(std::string(bytes), quickOptions("scene.pov", bytes)); }

void readFunction(std::string_view bytes) {
    (void)parseFunction(std::string(bytes), {}, quickOptions("function.pov", bytes));
}

void readVirtualight(std::string_view bytes) {
    virtualight::parseVirtualight(std::string(bytes), quickOptions("scene.vl", bytes));
}

void readImage(std::string_view bytes) {
    const std::span data(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    for (const auto decode :
         {decodePng, decodeGif, decodeTga, decodeJpeg, decodeTiff, decodeBmp, decodeNetpbm})
        decode(data);
}

/// Readers of files read one of this process.
fs::path asFile(std::string_view bytes) {
    static const fs::path file = fs::temp_directory_path() / ("isoscope-fuzz-" + std::to_string(getpid()));
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return file;
}

void readFont(std::string_view bytes) {
    const fs::path file = asFile(bytes);
    if (const auto font = FontFile::open(file)) {
        for (const char32_t character : {U'a', U'B', U'\u00e4', U'\u4e2d', U' '}) font->glyph(character);
        font->kerning(U'A', U'V');
    }
    fs::remove(file);
}

void readDensity(std::string_view bytes) {
    const fs::path file = asFile(bytes);
    std::string problem;
    readDensityFile(file, problem);
    fs::remove(file);
}

void readTable(std::string_view bytes) {
    const CsvTable table = CsvTable::parse(bytes);
    for (std::size_t row = 0; row < table.rowCount(); ++row)
        for (const std::string& column : table.header()) table.number(row, column, 0);
    for (std::size_t row = 0; row < table.rowCount(); ++row) csvLine(table.row(row));
}

std::string contentOf(const fs::path& file) {
    std::ifstream input(file, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(input), {}};
}

bool hasEnding(const fs::path& file, std::string_view endings) {
    const std::string ending = file.extension().string();
    return !ending.empty() && endings.find(ending) != std::string_view::npos;
}

/// Two bytes, the higher one first.
std::string bigEndian(int value) {
    return {static_cast<char>(value >> 8 & 255), static_cast<char>(value & 255)};
}

/// One input of each kind of file that the sources do not hold.
std::vector<std::string> madeInputs(std::string_view target) {
    using namespace std::string_literals;
    if (target == "function")
        return {"x*x+y*y+z*z-1", "f_noise3d(x,y,z)-select(x,0,sin(y))", "sum(i,1,9,i*x)"};
    if (target == "density") return {bigEndian(2) + bigEndian(2) + bigEndian(2) + "abcdefgh"s};
    if (target == "table") return {"a,b\n1,\"x,\"\"y\"\"\"\n2,nan\n"};
    if (target != "image") return {};
    return {"P6 2 1 255\nabcdef"s,
            "P2\n# grey\n2 2 9 1 2 3 4\n"s,
            "BM\x3e\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x01\0\0\0\x01\0\0\0\x01\0\x18\0\0\0\0\0\x04\0\0\0"s +
                std::string(16, '\0') + "abc\0"s,
            "GIF89a\x01\0\x01\0\x80\0\0\0\0\0\xff\xff\xff,\0\0\0\0\x01\0\x01\0\0\x02\x02\x44\x01\0;"s,
            "\0\0\x0a\0\0\0\0\0\0\0\0\0\x02\0\x01\0\x18\0\x81"s + "abc"s,
            "II*\0\x08\0\0\0\0\0\0\0\0\0"s};
}

}  // namespace

std::span<const FuzzTarget> fuzzTargets() {
    static constexpr std::array targets{
        FuzzTarget{"scene", readScene, ".pov .inc", true},
        FuzzTarget{"function", readFunction, "", true},
        FuzzTarget{"virtualight", readVirtualight, ".vl .vib", true},
        FuzzTarget{"image", readImage, ".png .jpg .jpeg .gif .tga .tif .tiff .bmp .ppm .pgm"},
        FuzzTarget{"font", readFont, ".ttf .otf"},
        FuzzTarget{"density", readDensity, ".df3"},
        FuzzTarget{"table", readTable, ".csv", true},
    };
    return targets;
}

std::vector<std::string> corpusOf(const FuzzTarget& target) {
    constexpr std::uintmax_t sizeLimit = 64 * 1024;
    std::vector<fs::path> files;
    const fs::path sources = ISOSCOPE_SOURCE_DIR, kept = sources / "tests/fuzz/corpus" / target.name;
    for (const fs::path& folder :
         {kept, sources / "examples", sources / "tests/data", fs::path("/usr/share/fonts")}) {
        std::error_code failed;
        for (fs::recursive_directory_iterator it(folder, failed), end; !failed && it != end;
             it.increment(failed))
            if (it->is_regular_file(failed) && it->file_size(failed) <= sizeLimit &&
                (folder == kept || hasEnding(it->path(), target.endings)))
                files.push_back(it->path());
    }
    std::sort(files.begin(), files.end());
    std::vector<std::string> inputs = madeInputs(target.name);
    for (const fs::path& file : files) inputs.push_back(contentOf(file));
    return inputs;
}

}  // namespace isoscope::test
