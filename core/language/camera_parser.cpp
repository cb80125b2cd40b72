// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/camera_parser.h"

#include <array>

#include "core/language/expressions/declared_value.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/objects/transform_parser.h"
#include "core/language/textures/normal_parser.h"
#include "core/language/tokens/block_words.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/unknown_name.h"
#include "core/texture/surface_needs.h"

namespace isoscope {

namespace {

constexpr int mostBlurSamples = 100000;
/// The first version, in hundredths, in which POV-Ray wants the kind of a camera first.
constexpr int kindFirst = 350;

}  // namespace

constexpr std::array<const char*, 3> CameraParser::itemWords{
    transformWords,
    "location look_at right up direction sky angle perspective orthographic fisheye ultra_wide_angle "
    "omnimax panoramic spherical cylinder aperture focal_point confidence variance blur_samples normal"};

Camera CameraParser::parse() {
    CameraStatement statement;
    if (!tokens_.expect("{", "to begin `camera`")) return statement.camera();
    const bool declared = startFromDeclared(statement);
    bool isFirst = true;
    while (!tokens_.peek().is("}")) {
        if (TransformParser(tokens_).parseModifier(statement.transform)) continue;
        const Token word = tokens_.peek();
        const bool isKind = parseKind(statement);
        if (isKind || parseItem(statement)) {
            if (declared)
                warnOfRefusal(tokens_.context(), word.range,
                              "takes nothing but transformations behind the name of a camera.",
                              "declare the camera with this item");
            else if (isKind && !isFirst && tokens_.context().languageVersion >= kindFirst)
                warnOfRefusal(tokens_.context(), word.range,
                              "wants the kind of a camera first, such as `" + std::string(word.text) + "`.",
                              "move it to the beginning of the camera");
            isFirst = isFirst && isKind;
            continue;
        }
        const Token token = tokens_.peek();
        if (token.kind == TokenKind::end) {
            tokens_.expect("}", "to close `camera`");
            return statement.camera();
        }
        passUnknownItem(tokens_, "camera");
    }
    tokens_.next();
    return statement.camera();
}

bool CameraParser::startFromDeclared(CameraStatement& statement) {
    const std::optional<Camera> declared = takeDeclared<Camera>(tokens_);
    if (!declared) return false;
    statement.start = *declared;
    statement.kind = declared->kind;
    return true;
}

bool CameraParser::parseItem(CameraStatement& statement) {
    if (parseVectorItem(statement)) return true;
    const Token word = tokens_.peek();
    if (tokens_.accept("angle")) {
        const double degrees = ExpressionParser(tokens_).parseFloat();
        if (!(degrees > 0))
            tokens_.context().error("bad-angle", rangeSince(word.range, tokens_),
                                    "The `angle` of a camera must be greater than 0.");
        else
            statement.angle = degrees;
        // Of a spherical camera; the comma may be missing.
        if (tokens_.accept(",") || ExpressionParser(tokens_).atExpression()) {
            statement.verticalAngle = ExpressionParser(tokens_).parseFloat();
            if (statement.kind != CameraKind::spherical)
                warnOfRefusal(tokens_.context(), rangeSince(word.range, tokens_),
                              "takes a second `angle` in `spherical` cameras alone.", "leave it out");
        }
        return true;
    }
    return parseBlur(statement) || parseNormal(statement) || parseLeftOut();
}

bool CameraParser::parseVectorItem(CameraStatement& statement) {
    struct Entry {
        const char* word;
        std::optional<glm::dvec3> CameraStatement::*member;
    };
    static constexpr std::array<Entry, 6> entries{{{"location", &CameraStatement::location},
                                                   {"look_at", &CameraStatement::lookAt},
                                                   {"right", &CameraStatement::right},
                                                   {"up", &CameraStatement::up},
                                                   {"direction", &CameraStatement::direction},
                                                   {"sky", &CameraStatement::sky}}};
    for (const Entry& entry : entries)
        if (tokens_.accept(entry.word)) {
            statement.*entry.member = ExpressionParser(tokens_).parseVector();
            return true;
        }
    return false;
}

bool CameraParser::parseKind(CameraStatement& statement) {
    struct Entry {
        const char* word;
        CameraKind kind;
    };
    static constexpr std::array<Entry, 7> entries{{{"perspective", CameraKind::perspective},
                                                   {"orthographic", CameraKind::orthographic},
                                                   {"fisheye", CameraKind::fisheye},
                                                   {"ultra_wide_angle", CameraKind::ultraWideAngle},
                                                   {"omnimax", CameraKind::omnimax},
                                                   {"panoramic", CameraKind::panoramic},
                                                   {"spherical", CameraKind::spherical}}};
    for (const Entry& entry : entries)
        if (tokens_.accept(entry.word)) {
            statement.kind = entry.kind;
            return true;
        }
    return parseCylinder(statement);
}

bool CameraParser::parseCylinder(CameraStatement& statement) {
    static constexpr std::array<CameraKind, 4> kinds{CameraKind::uprightCylinder, CameraKind::lyingCylinder,
                                                     CameraKind::movingUprightCylinder,
                                                     CameraKind::movingLyingCylinder};
    const Token word = tokens_.peek();
    if (!tokens_.accept("cylinder")) return false;
    const double number = ExpressionParser(tokens_).parseFloat();
    if (!(number >= 1 && number < 5)) {
        tokens_.context().error("bad-cylinder", rangeSince(word.range, tokens_),
                                "A `cylinder` camera is one of 1, 2, 3 or 4.");
        return true;
    }
    statement.kind = kinds[static_cast<std::size_t>(number) - 1];
    return true;
}

bool CameraParser::parseBlur(CameraStatement& statement) {
    const Token word = tokens_.peek();
    ExpressionParser expressions(tokens_);
    FocalBlur blur = statement.blur.value_or(statement.start.blur);
    if (tokens_.accept("aperture")) {
        blur.aperture = expressions.parseFloat();
    } else if (tokens_.accept("focal_point")) {
        blur.focalPoint = expressions.parseVector();
    } else if (tokens_.accept("confidence")) {
        blur.confidence = expressions.parseFloat();
    } else if (tokens_.accept("variance")) {
        blur.variance = expressions.parseFloat();
    } else if (tokens_.accept("blur_samples")) {
        double samples = expressions.parseFloat();
        // Two numbers: the least and the most.
        if (tokens_.accept(",")) samples = expressions.parseFloat();
        if (!(samples <= mostBlurSamples)) {
            tokens_.context().error(
                "bad-blur-samples", rangeSince(word.range, tokens_),
                "At most " + std::to_string(mostBlurSamples) + " `blur_samples` are sent.");
            samples = mostBlurSamples;
        }
        blur.samples = samples >= 1 ? static_cast<int>(samples) : 0;
    } else {
        return false;
    }
    statement.blur = blur;
    return true;
}

bool CameraParser::parseNormal(CameraStatement& statement) {
    const Token word = tokens_.peek();
    if (!tokens_.accept("normal")) return false;
    NormalParser normals(tokens_);
    statement.normal = normals.parse(statement.normal);
    if (statement.normal && needsSurface(*statement.normal)) {
        statement.normal = nullptr;
        reportLeftOut(tokens_.context(), word.range,
                      "The camera's `normal` is not shown: its pattern needs a surface.");
    }
    const SourceRange range = rangeSince(word.range, tokens_);
    const SourceLibrary& sources = tokens_.context().sources;
    if (range.file < sources.size())
        statement.normalText =
            std::string(sources[range.file].text().substr(range.begin, range.end - range.begin));
    for (const std::string& what : normals.leftOut())
        reportLeftOut(tokens_.context(), word.range, "`" + what + "` is not simulated.");
    return true;
}

bool CameraParser::parseLeftOut() {
    const Token word = tokens_.peek();
    static constexpr std::array<const char*, 3> oneValue{"h_angle", "v_angle", "bokeh"};
    const auto report = [&] {
        reportLeftOut(tokens_.context(), word.range, "`" + std::string(word.text) + "` is not simulated.");
    };
    for (const char* item : oneValue)
        if (tokens_.accept(item)) {
            if (tokens_.accept("{")) {
                tokens_.skipBlock();
            } else {
                ExpressionParser(tokens_).parseValue();
                if (tokens_.accept(",")) ExpressionParser(tokens_).parseValue();
            }
            report();
            return true;
        }
    if (!word.is("mesh_camera")) return false;
    tokens_.next();
    if (tokens_.accept("{")) tokens_.skipBlock();
    report();
    return true;
}

}  // namespace isoscope
