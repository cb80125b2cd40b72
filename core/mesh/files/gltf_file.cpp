// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "core/mesh/files/mesh_writers.h"
#include "core/render/image.h"

namespace isoscope {

namespace {

using Json = nlohmann::ordered_json;

// Numbers of the notation (Khronos, glTF 2.0).
constexpr int floatType = 5126, wordType = 5125, shortType = 5123;
constexpr int pointBuffer = 34962, indexBuffer = 34963;
constexpr std::uint32_t magic = 0x46546c67, version = 2, jsonChunk = 0x4e4f534a, binaryChunk = 0x004e4942;

class GltfWriter {
  public:
    explicit GltfWriter(const TriangleMesh& mesh) : mesh_(mesh) {
        json_["asset"] = {{"version", "2.0"}, {"generator", "Isoscope"}};
        json_["scene"] = 0;
        json_["scenes"] = Json::array({{{"nodes", Json::array()}}});
        for (const char* list : {"nodes", "meshes", "accessors", "bufferViews"}) json_[list] = Json::array();
        json_["materials"] = Json::array({{{"pbrMetallicRoughness",
                                            {{"baseColorFactor", {1.0, 1.0, 1.0, 1.0}},
                                             {"metallicFactor", 0.0},
                                             {"roughnessFactor", 0.6}}}}});
        for (std::size_t object = 0; object < mesh.objects.size(); ++object) addObject(object);
    }

    MeshFile file() {
        json_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
        std::string text = json_.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        const std::size_t size = 12 + 8 + text.size() + 8 + binary_.size();
        MeshFile file;
        if (size > std::numeric_limits<std::uint32_t>::max()) {
            file.problem = "the mesh is too large for a .glb file, which ends at 4 GB";
            return file;
        }
        for (const std::uint32_t word : {magic, version, static_cast<std::uint32_t>(size),
                                         static_cast<std::uint32_t>(text.size()), jsonChunk})
            appendBytes(file.content, word);
        file.content += text;
        appendBytes(file.content, static_cast<std::uint32_t>(binary_.size()));
        appendBytes(file.content, binaryChunk);
        file.content += binary_;
        return file;
    }

  private:
    struct Corner {
        std::uint32_t point, normal;
    };

    /// Points with different normals at different corners are parted.
    void findCorners(std::size_t object) {
        corners_.clear();
        indices_.clear();
        std::unordered_map<std::uint64_t, std::uint32_t> numbers;
        for (std::size_t t = mesh_.objects[object]; t < objectEnd(mesh_, object); ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const Corner corner{mesh_.triangles[t][k], mesh_.cornerNormals[t][k]};
                const std::uint64_t key = std::uint64_t(corner.point) << 32 | corner.normal;
                const auto [place, isNew] =
                    numbers.try_emplace(key, static_cast<std::uint32_t>(corners_.size()));
                if (isNew) corners_.push_back(corner);
                indices_.push_back(place->second);
            }
    }

    /// What has been appended since `begin` becomes the numbers of an accessor, which is returned.
    Json& addAccessor(std::size_t begin, int target, int type, const char* shape, std::size_t count) {
        json_["bufferViews"].push_back({{"buffer", 0},
                                        {"byteOffset", begin},
                                        {"byteLength", binary_.size() - begin},
                                        {"target", target}});
        json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                      {"componentType", type},
                                      {"count", count},
                                      {"type", shape}});
        return json_["accessors"].back();
    }
    std::size_t lastAccessor() const { return json_["accessors"].size() - 1; }

    void addObject(std::size_t object) {
        findCorners(object);
        Json attributes;
        addPoints();
        attributes["POSITION"] = lastAccessor();
        std::size_t begin = binary_.size();
        for (const Corner& corner : corners_) appendFloats(binary_, mesh_.normals[corner.normal]);
        addAccessor(begin, pointBuffer, floatType, "VEC3", corners_.size());
        attributes["NORMAL"] = lastAccessor();
        if (!mesh_.colors.empty()) {
            addColors();
            attributes["COLOR_0"] = lastAccessor();
        }
        begin = binary_.size();
        for (const std::uint32_t index : indices_) appendBytes(binary_, index);
        addAccessor(begin, indexBuffer, wordType, "SCALAR", indices_.size());
        const std::string name = "isosurface " + std::to_string(object + 1);
        json_["meshes"].push_back(
            {{"name", name},
             {"primitives",
              Json::array({{{"attributes", attributes}, {"indices", lastAccessor()}, {"material", 0}}})}});
        json_["nodes"].push_back({{"name", name}, {"mesh", object}});
        json_["scenes"][0]["nodes"].push_back(object);
    }

    void addPoints() {
        const std::size_t begin = binary_.size();
        glm::vec3 low(std::numeric_limits<float>::infinity()), high(-low);
        for (const Corner& corner : corners_) {
            const glm::vec3 point(mesh_.points[corner.point]);
            low = glm::min(low, point);
            high = glm::max(high, point);
            appendFloats(binary_, mesh_.points[corner.point]);
        }
        Json& accessor = addAccessor(begin, pointBuffer, floatType, "VEC3", corners_.size());
        accessor["min"] = {low.x, low.y, low.z};
        accessor["max"] = {high.x, high.y, high.z};
    }

    /// Linear light, as the notation wants it.
    void addColors() {
        const std::size_t begin = binary_.size();
        for (const Corner& corner : corners_) {
            for (const std::uint8_t channel : channels(mesh_.colors[corner.point]))
                appendBytes(binary_,
                            static_cast<std::uint16_t>(std::lround(65535 * decodeChannel(channel / 255.0))));
            appendBytes(binary_, std::uint16_t(65535));
        }
        addAccessor(begin, pointBuffer, shortType, "VEC4", corners_.size())["normalized"] = true;
    }

    const TriangleMesh& mesh_;
    Json json_;
    std::string binary_;
    std::vector<Corner> corners_;
    std::vector<std::uint32_t> indices_;
};

}  // namespace

MeshFile gltfFile(const TriangleMesh& mesh) { return GltfWriter(mesh).file(); }

}  // namespace isoscope
