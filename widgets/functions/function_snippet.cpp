// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/functions/function_snippet.h"

#include <QRegularExpression>
#include <QStringList>

#include "widgets/numbers/number_text.h"

namespace isoscope {
namespace {

/// The container of the table, "sphere 0 1.1" or "box <-1,-1,-1> <1,1,1>", as scene language. What is not
/// understood becomes POV-Ray's default box.
QString container(const std::string& description) {
    const QString text = QString::fromStdString(description).simplified();
    static const QRegularExpression number(R"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)");
    QStringList found;
    for (auto matches = number.globalMatch(text); matches.hasNext();)
        found << numberText(matches.next().captured().toDouble());
    const auto vector = [&found](int i) {
        return QString("<%1, %2, %3>").arg(found[i], found[i + 1], found[i + 2]);
    };
    if (text.startsWith("sphere") && (found.size() == 2 || found.size() == 4))
        return QString("sphere { %1, %2 }").arg(found.size() == 4 ? vector(0) : found[0], found.last());
    if (text.startsWith("box") && found.size() == 6)
        return QString("box { %1, %2 }").arg(vector(0), vector(3));
    return QStringLiteral("box { <-1, -1, -1>, <1, 1, 1> }");
}

QString pigment(const Showing& showing) {
    if (showing.paint.empty()) return QStringLiteral("  pigment { rgb <0.9, 0.7, 0.4> }\n");
    return QString(
               "  // As a surface it would have holes, whatever the max_gradient: it jumps.\n"
               "  pigment {\n"
               "    function { %1 }\n"
               "    color_map { [0 rgb <0.13, 0.25, 0.45>] [1 rgb <0.95, 0.75, 0.40>] }\n"
               "  }\n")
        .arg(QString::fromStdString(showing.paint));
}

}  // namespace

QString callSnippet(const Builtin& builtin) { return QString::fromStdString(sampleCall(builtin)); }

QString signature(const Builtin& builtin) {
    static const QRegularExpression inParentheses(R"(\s*\(.*\))");
    QStringList names;
    if (builtin.pointArguments == 3)
        names << "x"
              << "y"
              << "z";
    for (const BuiltinParameter& parameter : builtin.parameters) {
        // A comma or parenthesis inside a name would split the argument that the call tip points at.
        QString name = QString::fromStdString(parameter.name);
        name.remove(inParentheses);
        names << name.replace(',', ' ');
    }
    return QString("%1(%2)").arg(QString::fromStdString(builtin.name), names.join(", "));
}

QString statementSnippet(const Builtin& builtin, const QString& placement) {
    const Showing& showing = builtin.showing;
    return QString(
               "isosurface {\n"
               "  function { %1 }\n"
               "  contained_by { %2 }\n"
               "  threshold %3\n"
               "  max_gradient %4\n"
               "%5"
               "  finish { phong 0.5 }\n"
               "%6"
               "}\n")
        .arg(QString::fromStdString(showing.expression), container(showing.container),
             numberText(showing.threshold), numberText(showing.maxGradient), pigment(showing), placement);
}

std::string thumbnailScene(const Builtin& builtin) {
    return "#version 3.7;\n#include \"functions.inc\"\nglobal_settings { assumed_gamma 1 }\n"
           "background { rgb <0.16, 0.18, 0.21> }\n"
           "camera { location <0.42, 0.45, -0.79>*100 right x up y angle 30 look_at 0 }\n"
           "light_source { <-500, 1000, -1000> rgb 1 shadowless }\n"
           "light_source { <1000, 200, 0> rgb 0.4 shadowless }\n" +
           statementSnippet(builtin).toStdString();
}

}  // namespace isoscope
