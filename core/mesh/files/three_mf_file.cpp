// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <unordered_map>
#include <zip.h>

#include "core/mesh/files/mesh_writers.h"

namespace isoscope {

namespace {

constexpr const char* contentTypes =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
    "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
    "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
    "</Types>\n";
constexpr const char* relationships =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";

/// The time of all entries, so that the same mesh gives the same bytes: 1980-01-01, the first that zip has.
constexpr zip_uint16_t firstDosTime = 0, firstDosDate = (1 << 5) | 1;

std::string attribute(const char* name, std::string_view value) {
    return std::string(" ") + name + "=\"" + std::string(value) + '"';
}

void addPoint(std::string& text, const glm::dvec3& point) {
    text += "<vertex";
    for (int k = 0; k < 3; ++k) {
        std::string digits;
        appendDecimals(digits, glm::dvec3(point[k], 0, 0), ' ');
        digits = digits.substr(1, digits.find(' ', 1) - 1);
        text += attribute(k == 0 ? "x" : k == 1 ? "y" : "z", digits);
    }
    text += "/>\n";
}

/// The colours of a mesh, each once.
class Palette {
  public:
    explicit Palette(const TriangleMesh& mesh) : mesh_(mesh) {
        for (const std::uint32_t color : mesh.colors)
            if (numbers_.try_emplace(color, order_.size()).second) order_.push_back(color);
    }
    std::string text() const {
        std::string text = "<m:colorgroup id=\"1\">\n";
        constexpr const char* digits = "0123456789ABCDEF";
        for (const std::uint32_t color : order_) {
            text += "<m:color color=\"#";
            for (const std::uint8_t channel : channels(color)) {
                text += digits[channel >> 4];
                text += digits[channel & 15];
            }
            text += "\"/>\n";
        }
        return text + "</m:colorgroup>\n";
    }
    std::string number(std::uint32_t point) const { return std::to_string(numbers_.at(mesh_.colors[point])); }

  private:
    const TriangleMesh& mesh_;
    std::unordered_map<std::uint32_t, std::size_t> numbers_;
    std::vector<std::uint32_t> order_;
};

/// One object, with points of its own.
void addObject(std::string& text, const TriangleMesh& mesh, std::size_t object, const Palette& palette) {
    const std::size_t first = mesh.objects[object], end = objectEnd(mesh, object);
    std::vector<std::uint32_t> points;
    for (std::size_t t = first; t < end; ++t)
        points.insert(points.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const bool colored = !mesh.colors.empty();
    text += "<object id=\"" + std::to_string(object + 2) + "\" type=\"model\"";
    if (colored) text += " pid=\"1\" pindex=\"0\"";
    text += "><mesh><vertices>\n";
    for (const std::uint32_t point : points) addPoint(text, mesh.points[point]);
    text += "</vertices><triangles>\n";
    for (std::size_t t = first; t < end; ++t) {
        text += "<triangle";
        for (std::size_t k = 0; k < 3; ++k) {
            const auto place = std::lower_bound(points.begin(), points.end(), mesh.triangles[t][k]);
            const std::string name{'v', static_cast<char>('1' + k)};
            text += attribute(name.c_str(), std::to_string(place - points.begin()));
        }
        if (colored) {
            text += attribute("pid", "1");
            for (std::size_t k = 0; k < 3; ++k) {
                const std::string name{'p', static_cast<char>('1' + k)};
                text += attribute(name.c_str(), palette.number(mesh.triangles[t][k]));
            }
        }
        text += "/>\n";
    }
    text += "</triangles></mesh></object>\n";
}

std::string modelOf(const TriangleMesh& mesh) {
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-US\" "
        "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
        "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">\n"
        "<metadata name=\"Application\">Isoscope</metadata>\n<resources>\n";
    const Palette palette(mesh);
    if (!mesh.colors.empty()) text += palette.text();
    for (std::size_t object = 0; object < mesh.objects.size(); ++object)
        addObject(text, mesh, object, palette);
    text += "</resources>\n<build>\n";
    for (std::size_t object = 0; object < mesh.objects.size(); ++object)
        text += "<item objectid=\"" + std::to_string(object + 2) + "\"/>\n";
    return text + "</build>\n</model>\n";
}

/// A zip archive in memory.
class Archive {
  public:
    Archive() : source_(zip_source_buffer_create(nullptr, 0, 0, nullptr)) {
        if (source_ == nullptr) return;
        zip_source_keep(source_);
        archive_ = zip_open_from_source(source_, ZIP_TRUNCATE, nullptr);
    }
    ~Archive() {
        if (archive_ != nullptr) zip_discard(archive_);
        if (source_ != nullptr) zip_source_free(source_);
    }
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;

    /// The text must live until close().
    bool add(const char* name, std::string_view text) {
        if (archive_ == nullptr) return false;
        zip_source_t* part = zip_source_buffer(archive_, text.data(), text.size(), 0);
        const zip_int64_t index = part == nullptr ? -1 : zip_file_add(archive_, name, part, ZIP_FL_ENC_UTF_8);
        if (index < 0) {
            if (part != nullptr) zip_source_free(part);
            return false;
        }
        const auto place = static_cast<zip_uint64_t>(index);
        return zip_file_set_dostime(archive_, place, firstDosTime, firstDosDate, 0) == 0;
    }
    /// The bytes; empty where something went wrong.
    std::string close() {
        constexpr std::string_view comment = "Isoscope mesh";
        if (archive_ == nullptr || zip_set_archive_comment(archive_, comment.data(), comment.size()) != 0 ||
            zip_close(archive_) != 0)
            return {};
        archive_ = nullptr;
        zip_stat_t size;
        if (zip_source_stat(source_, &size) != 0 || zip_source_open(source_) != 0) return {};
        std::string content(static_cast<std::size_t>(size.size), '\0');
        const zip_int64_t read = zip_source_read(source_, content.data(), content.size());
        zip_source_close(source_);
        return read == static_cast<zip_int64_t>(content.size()) ? content : std::string();
    }

  private:
    zip_source_t* source_ = nullptr;
    zip_t* archive_ = nullptr;
};

}  // namespace

MeshFile threeMfFile(const TriangleMesh& mesh) {
    const std::string model = modelOf(mesh);
    Archive archive;
    MeshFile file;
    if (archive.add("[Content_Types].xml", contentTypes) && archive.add("_rels/.rels", relationships) &&
        archive.add("3D/3dmodel.model", model))
        file.content = archive.close();
    if (file.content.empty()) file.problem = "the archive cannot be made";
    return file;
}

}  // namespace isoscope
