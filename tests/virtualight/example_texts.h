// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QString>
#include <string>

#include "core/exchange/read_scene.h"
#include "core/virtualight/scene_reader.h"
#include "test_folders.h"

namespace isoscope::test {

/// The examples of the manual, written anew, and a few that its words describe.
inline QString exampleFolder() { return QStringLiteral(ISOSCOPE_TEST_DATA "/virtualight/"); }

inline QStringList exampleNames() {
    return QDir(exampleFolder()).entryList({QStringLiteral("*.vl")}, QDir::Files, QDir::Name);
}

inline ParseResult readExample(const QString& name) {
    ParseOptions options;
    options.imageWidth = 160;
    options.imageHeight = 120;
    return readSceneFile((exampleFolder() + name).toStdString(), options);
}

/// A text as it would be typed into the window.
inline ParseResult readText(const std::string& text) {
    ParseOptions options;
    options.imageWidth = 160;
    options.imageHeight = 120;
    return virtualight::parseVirtualight(text, options);
}

/// The diagnostics of one severity, one per line.
inline std::string messages(const ParseResult& parsed, Severity severity) {
    std::string text;
    for (const Diagnostic& diagnostic : parsed.diagnostics)
        if (diagnostic.severity == severity) text += toString(diagnostic, *parsed.sources) + "\n";
    return text;
}

}  // namespace isoscope::test
