// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/file_writer.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "core/language/written_files.h"
#include "widgets/document.h"
#include "widgets/notice_bar.h"
#include "widgets/scene_editor.h"
#include "widgets/scene_session.h"

namespace isoscope {

namespace {

namespace fs = std::filesystem;

std::optional<std::string> contentOf(const fs::path& file) {
    std::error_code failed;
    if (!fs::is_regular_file(file, failed)) return std::nullopt;
    std::ifstream input(file, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(input), {}};
}

QStringList namesOf(const std::map<std::string, std::string>& files) {
    QStringList names;
    for (const auto& [name, content] : files) names << QString::fromStdString(name);
    return names;
}

}  // namespace

FileWriter::FileWriter(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {
    connect(parts_.session, &SceneSession::parsed, this, [this](const auto& result, quint64 revision) {
        if (revision == parts_.editor->revision()) consider(result);
    });
}

void FileWriter::begin() {
    allowed_ = false;
    asked_.clear();
    refused_.clear();
    parts_.notices->hide();
}

std::string FileWriter::folder() const {
    const fs::path file(parts_.document->filePath().toStdString());
    return file.empty() ? std::string() : fs::absolute(file).parent_path().string();
}

FileWriter::Files FileWriter::changed(const Files& files) const {
    Files differing;
    const fs::path own(parts_.document->filePath().toStdString());
    for (const auto& [name, content] : files) {
        std::error_code failed;
        const fs::path place = fs::path(folder()) / name;
        if (!own.empty() && fs::equivalent(place, own, failed)) continue;
        if (contentOf(place) != content) differing[name] = content;
    }
    return differing;
}

void FileWriter::consider(const std::shared_ptr<const ParseResult>& result) {
    // Of a text with mistakes only a part may have been written.
    if (!result->ok()) return;
    const Files files = changed(result->writtenFiles);
    if (files.empty()) {
        if (!asked_.isEmpty()) parts_.notices->hide();
        asked_.clear();
        return;
    }
    const auto grows = [this](const auto& file) {
        const std::optional<std::string> before = contentOf(fs::path(folder()) / file.first);
        return before && !before->empty() && file.second.starts_with(*before);
    };
    if (allowed_ && std::none_of(files.begin(), files.end(), grows)) return write(files);
    if (namesOf(files) != asked_) ask(files);
}

void FileWriter::ask(const Files& files) {
    asked_ = namesOf(files);
    const QString names = asked_.join(QStringLiteral(", "));
    if (folder().empty()) {
        parts_.notices->tell(
            tr("The text writes %1. Save the scene first: files are written beside it only.").arg(names));
        return;
    }
    parts_.notices->ask(
        tr("The text writes to files beside the scene: %1").arg(names),
        {{tr("Allow"), tr("Write the files now, and again when they change, until the text is closed"),
          [this] {
              allowed_ = true;
              asked_.clear();
              const auto& result = parts_.session->result();
              if (result && result->ok()) write(changed(result->writtenFiles));
          }},
         {tr("Not Now"), tr("Write nothing; #read and #include of the same text find it all the same"), {}}});
}

void FileWriter::write(const Files& files) {
    QStringList names;
    const fs::path scene(parts_.document->filePath().toStdString());
    for (const std::string& name : writeBeside(scene, files)) names << QString::fromStdString(name);
    if (names.isEmpty()) emit said(tr("Written: %1").arg(namesOf(files).join(QStringLiteral(", "))));
    if (names.isEmpty() || names == refused_) return;
    refused_ = names;
    parts_.notices->tell(tr("Not written, because it is not beside the scene or cannot be: %1")
                             .arg(names.join(QStringLiteral(", "))));
}

}  // namespace isoscope
