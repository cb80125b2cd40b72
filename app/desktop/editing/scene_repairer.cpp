// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/editing/scene_repairer.h"

#include <QFile>
#include <QFileInfo>

#include "app/desktop/editing/setting_writer.h"
#include "core/exchange/gradient_repairs.h"
#include "core/text/whole_file.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"

namespace isoscope {

namespace {

const QString repairTopic = QStringLiteral("repair");

}  // namespace

SceneRepairer::SceneRepairer(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {}

void SceneRepairer::repair(const std::map<std::size_t, double>& values) {
    const std::shared_ptr<const ParseResult> parsed = parts_.session->result();
    if (!parsed || !parsed->scene || parts_.session->resultRevision() != parts_.editor->revision()) {
        emit said(tr("The text is still being read; nothing is changed."));
        return;
    }
    std::map<std::size_t, double> own, others;
    for (const auto& [number, value] : values)
        if (number < parsed->scene->isosurfaces.size())
            (parsed->scene->isosurfaces[number].range.file == 0 ? own : others)[number] = value;
    const std::vector<Written> written = writeIncludes(*parsed, others);
    if (!own.empty()) parts_.settings->setMaxGradients(own);
    if (written.empty()) return;
    if (own.empty()) readAgain();
    offerBack(written);
}

std::vector<SceneRepairer::Written> SceneRepairer::writeIncludes(
    const ParseResult& parsed, const std::map<std::size_t, double>& values) {
    GradientRepairs repairs(parsed);
    for (const auto& [number, value] : values) repairs.add(number, value);
    std::vector<Written> written;
    QStringList problems;
    for (const std::uint32_t file : repairs.files()) {
        const SourceText& source = (*parsed.sources)[file];
        std::string why = GradientRepairs::obstacle(parsed, file, parts_.session->file());
        const std::string text = repairs.text(file);
        if (why.empty()) why = writeWhole(source.name(), text);
        if (why.empty())
            written.push_back({source.name(), std::string(source.text()), text});
        else
            problems << tr("%1 is not changed: %2.")
                            .arg(QString::fromStdString(source.name()).section('/', -1),
                                 QString::fromLocal8Bit(why));
    }
    if (!problems.isEmpty()) parts_.notices->tell(problems.join(QLatin1Char(' ')));
    return written;
}

void SceneRepairer::offerBack(const std::vector<Written>& written) {
    QStringList names;
    for (const Written& one : written) names << QString::fromStdString(one.file).section('/', -1);
    parts_.notices->ask(
        tr("Values of max_gradient were written into %1.").arg(names.join(QStringLiteral(", "))),
        {{tr("Put Back"), tr("Give the files the text that they had"), [this, written] { putBack(written); }},
         {tr("Close"), tr("Keep the files as they are now"), {}}},
        repairTopic);
}

void SceneRepairer::putBack(const std::vector<Written>& written) {
    QStringList problems;
    for (const Written& one : written) {
        const QString name = QString::fromStdString(one.file);
        QFile file(name);
        const bool untouched = file.open(QIODevice::ReadOnly) && file.readAll().toStdString() == one.after;
        file.close();
        const std::string why = untouched ? writeWhole(one.file, one.before) : std::string();
        if (!untouched || !why.empty()) problems << name.section('/', -1);
    }
    if (!problems.isEmpty())
        parts_.notices->tell(tr("Not put back, for it has changed since or cannot be written: %1.")
                                 .arg(problems.join(QStringLiteral(", "))));
    readAgain();
}

void SceneRepairer::readAgain() {
    parts_.session->setText(parts_.editor->utf8(), parts_.editor->revision(), SceneSession::When::now);
}

}  // namespace isoscope
