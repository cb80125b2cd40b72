// SPDX-License-Identifier: GPL-3.0-or-later
// `mesh` and `mesh2`.
#include <array>

#include "core/language/expressions/declared_value.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/objects/shape_parser.h"
#include "core/language/objects/shape_reader.h"
#include "core/language/textures/texture_parser.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/shapes/patches/mesh.h"
#include "core/shapes/patches/triangle.h"

namespace isoscope {

namespace {

constexpr std::size_t faceLimit = 4'000'000;

/// What both kinds of mesh have in common.
class MeshReader {
  public:
    explicit MeshReader(ShapeReader& reader) : reader_(reader), tokens_(reader.tokens()) {}

  protected:
    /// `inside_vector`, `hierarchy` and other items that both know.
    bool parseCommon() {
        bool ignored = false;
        if (tokens_.accept("inside_vector")) {
            const glm::dvec3 direction = reader_.vector("inside_vector");
            if (direction != glm::dvec3(0)) inside_ = direction;
            return true;
        }
        return reader_.flag("hierarchy", ignored);
    }

    ShapePointer finish() {
        if (reader_.failed() || !reader_.finite()) return nullptr;
        if (degenerate_ > 0)
            reader_.warn(reader_.keywordRange(),
                         "Triangles of this mesh whose corners lie on one line are left out: " +
                             std::to_string(degenerate_) + ".");
        else if (faces_.empty())
            reader_.warn(reader_.keywordRange(), "This mesh has no triangles.");
        if (faces_.empty()) return nullptr;
        return std::make_shared<Mesh>(std::move(points_), std::move(normals_), std::move(faces_), inside_,
                                      std::move(places_));
    }

    void addFace(const Mesh::Face& face) {
        if (Triangle::degenerate(
                {points_[face.corners[0]], points_[face.corners[1]], points_[face.corners[2]]}))
            ++degenerate_;
        else
            faces_.push_back(face);
    }

    /// What POV-Ray takes for a texture.
    enum class Form { block, name };
    /// `texture { ... }` or the name of one. 0: neither comes next.
    std::uint32_t parseTexture(Form form) {
        TextureParser textures(tokens_, reader_.draft().defaultMaterials.back());
        const Token first = tokens_.peek();
        if (tokens_.accept("texture")) {
            reader_.textures.push_back(textures.parseTexture());
            if (form == Form::name)
                warnOfRefusal(tokens_.context(), first.range, "wants the name of a declared texture here.",
                              "declare the texture");
        } else if (const std::optional<Material> declared = takeDeclared<Material>(tokens_)) {
            reader_.textures.push_back(*declared);
            if (form == Form::block) warnOfName(rangeSince(first.range, tokens_));
        } else {
            return 0;
        }
        tokens_.accept(",");
        return static_cast<std::uint32_t>(reader_.textures.size());
    }

    void warnOfName(const SourceRange& range) {
        ParseContext& context = tokens_.context();
        const std::string block = "texture { " + std::string(context.sources.slice(range)) + " }";
        warnOfRefusal(context, range, "wants `texture { ... }` around this name.", "write `" + block + "`",
                      {{"Write `" + block + "`", range, block}});
    }

    ShapeReader& reader_;
    TokenStream& tokens_;
    std::vector<glm::dvec3> points_;
    std::vector<glm::dvec3> normals_;
    std::vector<Mesh::Face> faces_;
    std::optional<glm::dvec3> inside_;
    std::size_t degenerate_ = 0;
    std::vector<glm::dvec2> places_;
};

/// `mesh { triangle { ... } smooth_triangle { ... } ... }`
class TriangleMeshReader : public MeshReader {
  public:
    using MeshReader::MeshReader;

    ShapePointer parse() {
        while (!reader_.failed()) {
            if (tokens_.accept("triangle"))
                parseTriangle(false);
            else if (tokens_.accept("smooth_triangle"))
                parseTriangle(true);
            else if (!parseCommon())
                break;
        }
        return finish();
    }

  private:
    void parseTriangle(bool smooth) {
        if (!tokens_.accept("{"))
            return reader_.fail(tokens_.peek().range, "A triangle of this mesh is incomplete.");
        Mesh::Face face;
        face.smooth = smooth;
        for (std::size_t k = 0; k < 3; ++k) {
            face.corners[k] = static_cast<std::uint32_t>(points_.size());
            points_.push_back(reader_.vector("corner"));
            if (!smooth) continue;
            face.normals[k] = static_cast<std::uint32_t>(normals_.size());
            normals_.push_back(reader_.vector("normal"));
        }
        parseAppearance(face);
        if (!tokens_.accept("}")) {
            reader_.fail(tokens_.peek().range,
                         describe(tokens_.peek()) + " is not understood in a triangle of a mesh.");
            return tokens_.skipBlock();
        }
        if (faces_.size() < faceLimit) addFace(face);
    }

    void parseAppearance(Mesh::Face& face) {
        for (;;) {
            if (tokens_.accept("uv_vectors")) {
                // The first stands for the corners of all faces that say nothing.
                if (places_.empty()) places_.emplace_back(0, 0);
                for (std::uint32_t& place : face.places) {
                    place = static_cast<std::uint32_t>(places_.size());
                    places_.push_back(reader_.pair("uv"));
                }
            } else if (tokens_.accept("texture_list")) {
                if (!tokens_.expect("{", "to begin `texture_list`")) return;
                for (std::uint32_t& texture : face.textures) texture = parseTexture(Form::name);
                tokens_.expect("}", "to close `texture_list`");
            } else if (const std::uint32_t texture = parseTexture(Form::block)) {
                face.textures = {texture, texture, texture};
            } else {
                return;
            }
        }
    }
};

/// `mesh2 { vertex_vectors { ... } face_indices { ... } ... }`
class IndexedMeshReader : public MeshReader {
  public:
    using MeshReader::MeshReader;

    ShapePointer parse() {
        while (!reader_.failed() && parseItem()) continue;
        if (!reader_.failed()) join();
        return finish();
    }

  private:
    using Indices = std::array<std::uint32_t, 3>;

    bool parseItem() {
        if (tokens_.accept("vertex_vectors"))
            parseVectors("vertex_vectors", points_);
        else if (tokens_.accept("normal_vectors"))
            parseVectors("normal_vectors", normals_);
        else if (tokens_.accept("face_indices"))
            parseIndices("face_indices", points_.size(), corners_, true);
        else if (tokens_.accept("normal_indices"))
            parseIndices("normal_indices", normals_.size(), normalIndices_, false);
        else if (tokens_.accept("uv_vectors"))
            parsePlaces();
        else if (tokens_.accept("uv_indices"))
            parseIndices("uv_indices", places_.size(), placeIndices_, false);
        else if (tokens_.accept("texture_list"))
            parseTextureList();
        else
            return parseCommon();
        return true;
    }

    void parsePlaces() {
        reader_.allowLastCommas();
        int missing = parseCount("uv_vectors");
        for (; missing > 0 && ExpressionParser(tokens_).atExpression(); --missing)
            places_.push_back(reader_.pair("uv"));
        close("uv_vectors", missing);
    }

    void parseTextureList() {
        int missing = parseCount("texture_list");
        for (; missing > 0 && parseTexture(Form::block) > 0; --missing) continue;
        close("texture_list", missing);
    }

    int parseCount(const std::string& word) {
        if (!tokens_.accept("{")) {
            reader_.fail(tokens_.peek().range, "`" + word + "` is incomplete.");
            return 0;
        }
        return reader_.count("number of entries in `" + word + "`", 0, static_cast<int>(faceLimit));
    }

    void close(const std::string& word, int missing) {
        if (missing == 0 && tokens_.accept("}")) return;
        reader_.fail(tokens_.peek().range,
                     missing > 0 ? "`" + word + "` has " + std::to_string(missing) + " entries too few."
                     : ExpressionParser(tokens_).atExpression()
                         ? "`" + word + "` has more entries than announced."
                         : "Expected `}` to close `" + word + "`.");
        tokens_.skipBlock();
    }

    void parseVectors(const std::string& word, std::vector<glm::dvec3>& vectors) {
        int missing = parseCount(word);
        for (; missing > 0 && ExpressionParser(tokens_).atExpression(); --missing) {
            vectors.push_back(ExpressionParser(tokens_).parseVector());
            tokens_.accept(",");
        }
        close(word, missing);
    }

    void parseIndices(const std::string& word, std::size_t limit, std::vector<Indices>& indices,
                      bool textures) {
        int missing = parseCount(word);
        while (ExpressionParser(tokens_).atExpression()) {
            const SourceRange start = tokens_.peek().range;
            const std::optional<Value> value = ExpressionParser(tokens_).parseValue();
            tokens_.accept(",");
            const auto* written = value ? std::get_if<VectorValue>(&value->data) : nullptr;
            // Numbers of textures may follow each face.
            const auto* number = value ? std::get_if<NumberValue>(&value->data) : nullptr;
            if (number && textures && !indices.empty()) {
                addTexture(indices.size() - 1, number->value);
                continue;
            }
            if (!written || missing == 0)
                return reader_.fail(rangeSince(start, tokens_),
                                    missing == 0 ? "`" + word + "` has more entries than announced."
                                                 : "Expected a vector of indices here.");
            --missing;
            Indices face{};
            for (std::size_t k = 0; k < 3; ++k) {
                const double index = written->components[k];
                if (!(index >= 0 && index < static_cast<double>(limit)))
                    return reader_.fail(rangeSince(start, tokens_),
                                        "An index of `" + word + "` lies outside 0 to " +
                                            std::to_string(limit == 0 ? 0 : limit - 1) + ".");
                face[k] = static_cast<std::uint32_t>(index);
            }
            indices.push_back(face);
        }
        close(word, missing);
    }

    /// One number for the whole face, or one for each corner.
    void addTexture(std::size_t face, double number) {
        if (textures_.size() <= face) textures_.resize(face + 1);
        std::vector<std::uint32_t>& list = textures_[face];
        if (!(number >= 0 && number < static_cast<double>(reader_.textures.size())))
            return reader_.fail(tokens_.lastRange(), "There is no such texture in the list of this mesh.");
        if (list.size() < 3) list.push_back(static_cast<std::uint32_t>(number) + 1);
    }

    void join() {
        // Without indices of its own, a corner has the normal with its own number.
        const bool shared = normalIndices_.empty() && normals_.size() >= points_.size() && !normals_.empty();
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            Mesh::Face face;
            face.corners = corners_[i];
            face.smooth = shared || i < normalIndices_.size();
            if (face.smooth) face.normals = shared ? corners_[i] : normalIndices_[i];
            if (i < placeIndices_.size())
                face.places = placeIndices_[i];
            else if (places_.size() >= points_.size())
                face.places = corners_[i];
            if (i < textures_.size() && !textures_[i].empty()) {
                const std::vector<std::uint32_t>& list = textures_[i];
                face.textures = {list[0], list.size() == 3 ? list[1] : list[0],
                                 list.size() == 3 ? list[2] : list[0]};
            }
            addFace(face);
        }
    }

    std::vector<Indices> corners_;
    std::vector<Indices> normalIndices_;
    std::vector<Indices> placeIndices_;
    std::vector<std::vector<std::uint32_t>> textures_;  ///< of the faces
};

ShapePointer parseMesh(ShapeReader& reader) { return TriangleMeshReader(reader).parse(); }
ShapePointer parseMesh2(ShapeReader& reader) { return IndexedMeshReader(reader).parse(); }

}  // namespace

std::span<const ShapeParser> meshParser() {
    static constexpr std::array parsers{
        ShapeParser{.keyword = "mesh",
                    .parse = parseMesh,
                    .words = "triangle smooth_triangle inside_vector",
                    .ignoresOwnBounds = true},
        ShapeParser{.keyword = "mesh2",
                    .parse = parseMesh2,
                    .words = "vertex_vectors normal_vectors uv_vectors texture_list face_indices "
                             "normal_indices uv_indices inside_vector",
                    .ignoresOwnBounds = true},
    };
    return parsers;
}

}  // namespace isoscope
