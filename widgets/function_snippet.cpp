// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/function_snippet.h"

#include <algorithm>
#include <cmath>
#include <QRegularExpression>
#include <QStringList>

#include "widgets/number_text.h"

namespace isoscope {
namespace {

struct Container {
    QString text;  // "sphere { 0, 1.1 }"
    double center[3] = {0, 0, 0};
    double radius = 1;
};

/// The container of the table, "sphere 0 1.1" or "box <-1,-1,-1> <1,1,1>", as scene language. What is not
/// understood becomes POV-Ray's default box.
Container container(const std::string& description) {
    const QString text = QString::fromStdString(description).simplified();
    Container result{"box { <-1, -1, -1>, <1, 1, 1> }", {0, 0, 0}, std::sqrt(3.0)};
    static const QRegularExpression number(R"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)");
    QStringList found;
    for (auto matches = number.globalMatch(text); matches.hasNext();)
        found << numberText(matches.next().captured().toDouble());
    const auto vector = [&found](int i) {
        return QString("<%1, %2, %3>").arg(found[i], found[i + 1], found[i + 2]);
    };
    if (text.startsWith("sphere") && (found.size() == 2 || found.size() == 4)) {
        const bool withVector = found.size() == 4;
        result.text = QString("sphere { %1, %2 }").arg(withVector ? vector(0) : found[0], found.last());
        for (int i = 0; i < 3; ++i) result.center[i] = found[withVector ? i : 0].toDouble();
        result.radius = found.last().toDouble();
    } else if (text.startsWith("box") && found.size() == 6) {
        result.text = QString("box { %1, %2 }").arg(vector(0), vector(3));
        double diagonal = 0;
        for (int i = 0; i < 3; ++i) {
            const double low = found[i].toDouble(), high = found[i + 3].toDouble();
            result.center[i] = (low + high) / 2;
            diagonal += (high - low) * (high - low);
        }
        result.radius = std::sqrt(diagonal) / 2;
    }
    return result;
}

}  // namespace

QString callSnippet(const Builtin& builtin) { return QString::fromStdString(sampleCall(builtin)); }

QString signature(const Builtin& builtin) {
    QStringList names;
    if (builtin.pointArguments == 3)
        names << "x"
              << "y"
              << "z";
    for (const BuiltinParameter& parameter : builtin.parameters) {
        // A comma or parenthesis inside a name would split the argument that the call tip points at.
        QString name = QString::fromStdString(parameter.name);
        name.remove(QRegularExpression(R"(\s*\(.*\))"));
        names << name.replace(',', ' ');
    }
    return QString("%1(%2)").arg(QString::fromStdString(builtin.name), names.join(", "));
}

QString statementSnippet(const Builtin& builtin) {
    const QString function = (builtin.invert ? "-" : "") + callSnippet(builtin);
    return QString(
               "isosurface {\n"
               "  function { %1 }\n"
               "  contained_by { %2 }\n"
               "  threshold %3\n"
               "  max_gradient %4\n"
               "  pigment { rgb <0.9, 0.7, 0.4> }\n"
               "  finish { phong 0.5 }\n"
               "}\n")
        .arg(function, container(builtin.container).text, numberText(builtin.threshold),
             numberText(builtin.maxGradient));
}

std::string thumbnailScene(const Builtin& builtin) {
    const Container box = container(builtin.container);
    const double angle = 30;
    const double distance = box.radius / std::sin(angle / 2 * std::acos(-1.0) / 180);
    const auto vector = [](double x, double y, double z) {
        return QString("<%1, %2, %3>").arg(numberText(x), numberText(y), numberText(z));
    };
    // From the front, right and above, as the surfaces of the table are best seen.
    const double direction[3] = {0.42, 0.45, -0.79};
    double eye[3];
    for (int i = 0; i < 3; ++i) eye[i] = box.center[i] + distance * direction[i];
    const double far = 20 * distance;
    const QString scene =
        QString(
            "#version 3.7;\n#include \"functions.inc\"\nglobal_settings { assumed_gamma 1 }\n"
            "background { rgb <0.16, 0.18, 0.21> }\n"
            "camera { location %1 right x up y angle %2 look_at %3 }\n"
            "light_source { %4 rgb 1 shadowless }\nlight_source { %5 rgb 0.4 shadowless }\n")
            .arg(vector(eye[0], eye[1], eye[2]), numberText(angle),
                 vector(box.center[0], box.center[1], box.center[2]),
                 vector(eye[0] - far * 0.5, eye[1] + far, eye[2] - far),
                 vector(eye[0] + far, eye[1] + far * 0.2, eye[2]));
    return (scene + statementSnippet(builtin)).toStdString();
}

}  // namespace isoscope
