// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/function_page.h"

#include <algorithm>
#include <QCoreApplication>
#include <QStringList>

#include "widgets/functions/function_snippet.h"
#include "widgets/numbers/number_text.h"

namespace isoscope {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(HelpPanel)
};

/// In a cell of a table a bar would end it.
QString cell(const std::string& text) {
    return QString::fromStdString(text).replace(QLatin1Char('|'), QLatin1String("\\|"));
}

QString parameterTable(const Builtin& builtin) {
    if (builtin.parameters.empty())
        return Words::tr("It has no parameters but the place.") + QStringLiteral("\n\n");
    QString table =
        Words::tr("| formula | parameter | usual value | range |") + QStringLiteral("\n|---|---|---|---|\n");
    int number = 0;
    for (const BuiltinParameter& parameter : builtin.parameters)
        table +=
            QStringLiteral("| P%1 | %2 | %3 | %4 |\n")
                .arg(number++)
                .arg(cell(parameter.name), numberText(parameter.defaultValue),
                     Words::tr("%1 to %2").arg(numberText(parameter.minimum), numberText(parameter.maximum)));
    return table + QLatin1Char('\n');
}

}  // namespace

QString functionPage(const Builtin& builtin) {
    const QString name = QString::fromStdString(builtin.name);
    QString page = QStringLiteral("# %1\n\n![%1](picture:%1)\n\n").arg(name);
    page += QStringLiteral("```\n%1\n```\n\n").arg(signature(builtin));
    page += QStringLiteral("## %1\n\n```\n%2\n```\n\n")
                .arg(Words::tr("Formula"), QString::fromStdString(builtin.formula));
    page += QStringLiteral("## %1\n\n").arg(Words::tr("Parameters")) + parameterTable(builtin);
    page += QStringLiteral("## %1\n\n```pov fit\n// %2.\n%3```\n\n")
                .arg(Words::tr("In a scene"), name, QString::fromStdString(thumbnailScene(builtin)));
    return page + QStringLiteral("[%1](/help/functions.md)\n").arg(Words::tr("All built-in functions"));
}

QString functionLinks() {
    QStringList numbered, patterns;
    for (const Builtin& builtin : builtins()) {
        if (builtin.name.empty()) continue;
        const QString name = QString::fromStdString(builtin.name);
        (builtin.id < 0 ? patterns : numbered) << QStringLiteral("[%1](/function/%1)").arg(name);
    }
    numbered.sort();
    patterns.sort();
    return QStringLiteral("\n## %1\n\n%2\n\n## %3\n\n%4\n")
        .arg(Words::tr("Numbered functions"), numbered.join(QStringLiteral(" · ")),
             Words::tr("Patterns as functions"), patterns.join(QStringLiteral(" · ")));
}

}  // namespace isoscope
