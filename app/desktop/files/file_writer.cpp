// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/files/file_writer.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "widgets/document/document.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"

namespace isoscope {

namespace {

namespace fs = std::filesystem;

std::optional<std::string> contentOf(const fs::path& file) {
    std::error_code failed;
    if (!fs::is_regular_file(file, failed)) return std::nullopt;
    std::ifstream input(file, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(input), {}};
}

QString listOf(const std::set<std::string>& names) {
    QStringList list;
    for (const std::string& name : names) list << QString::fromStdString(name);
    return list.join(QStringLiteral(", "));
}

}  // namespace

FileWriter::FileWriter(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {
    connect(parts_.session, &SceneSession::parsed, this, [this](const auto& result, quint64 revision) {
        if (revision == parts_.editor->revision()) consider(result);
    });
    connect(parts_.editor, &SceneEditor::textEdited, this, [this] { untyped_ = false; });
    settling_.setSingleShot(true);
    settling_.setInterval(settlingTime);
    connect(&settling_, &QTimer::timeout, this, &FileWriter::settle);
}

void FileWriter::begin() {
    withdraw(topics_);
    allowed_.clear();
    declined_.clear();
    settled_.clear();
    result_.reset();
    untyped_ = true;
    settling_.stop();
}

std::string FileWriter::scene() const { return parts_.document->filePath().toStdString(); }

WrittenFiles FileWriter::changed() const {
    WrittenFiles differing;
    const fs::path own(scene());
    for (const auto& [name, content] : result_->writtenFiles) {
        std::error_code failed;
        const fs::path place = own.parent_path() / name;
        if (!own.empty() && fs::equivalent(place, own, failed)) continue;
        if (contentOf(place) != content) differing[name] = content;
    }
    return differing;
}

bool FileWriter::grows(const std::string& name, const std::string& content) const {
    const std::optional<std::string> before = contentOf(fs::path(scene()).parent_path() / name);
    if (!before || before->empty() || !content.starts_with(*before)) return false;
    // Else it is an edit that made the content longer.
    for (std::size_t i = 0; i < result_->sources->size(); ++i)
        if ((*result_->sources)[static_cast<std::uint32_t>(i)].text().find("append") !=
            std::string_view::npos)
            return true;
    return false;
}

bool FileWriter::caretInString() const {
    if (!parts_.editor->hasFocus()) return false;
    int line = 0, column = 0;
    parts_.editor->getCursorPosition(&line, &column);
    const QString before = parts_.editor->text(line).left(column);
    bool inside = false;
    for (qsizetype i = 0; i < before.size(); ++i) {
        if (before[i] == u'"') inside = !inside;
        if (inside && before[i] == u'\\') ++i;
    }
    return inside;
}

void FileWriter::consider(const std::shared_ptr<const ParseResult>& result) {
    // Of a text with mistakes only a part may have been written.
    if (!result->ok()) return;
    result_ = result;
    // A name that went is a new one when it comes back.
    const auto gone = [&](const std::string& name) { return !result->writtenFiles.contains(name); };
    std::erase_if(settled_, gone);
    std::erase_if(declined_, gone);
    const WrittenFiles files = changed();
    const Names foreign = foreignFiles(scene(), files, record_);
    Names allowed;
    for (const auto& [name, content] : files)
        if (allowed_.contains(name) && !foreign.contains(name) && !grows(name, content)) allowed.insert(name);
    if (!allowed.empty()) write(allowed, {});
    if (!untyped_) settling_.start();
    if (untyped_) settle();
    if (!untyped_) askAll();
}

void FileWriter::settle() {
    if (!result_) return;
    if (!untyped_ && caretInString()) return settling_.start();
    for (const auto& [name, content] : result_->writtenFiles) settled_.insert(name);
    askAll();
}

void FileWriter::askAll() {
    const WrittenFiles files = changed();
    const Names foreign = foreignFiles(scene(), files, record_);
    Names ordinary, standing;
    for (const auto& [name, content] : files) {
        if (!settled_.contains(name) || declined_.contains(name)) continue;
        const bool own = !scene().empty() && (foreign.contains(name) || grows(name, content));
        if (own) {
            standing.insert("write " + name);
            ask(grows(name, content) ? Question::add : Question::replace, {name});
        } else if (!allowed_.contains(name)) {
            ordinary.insert(name);
        }
    }
    if (!ordinary.empty()) {
        standing.insert("write");
        ask(scene().empty() ? Question::saveFirst : Question::write, ordinary);
    }
    Names pointless;
    for (const std::string& topic : topics_)
        if (!standing.contains(topic)) pointless.insert(topic);
    withdraw(pointless);
}

void FileWriter::ask(Question question, const Names& names) {
    const QString list = listOf(names), own = QStringLiteral("write ") + list;
    switch (question) {
        case Question::write:
            return askAbout(tr("The text writes to files beside the scene: %1").arg(list),
                            QStringLiteral("write"), tr("Allow"),
                            tr("Write these files now, and again when they change, until the text is closed"),
                            names);
        case Question::replace:
            return askAbout(tr("The text would replace %1, which this scene did not write.").arg(list), own,
                            tr("Replace %1").arg(list), tr("What stands in the file now is lost"), names);
        case Question::add:
            return askAbout(tr("The text adds to %1, each time it is read.").arg(list), own, tr("Add Once"),
                            tr("Write to the file once more"), names);
        case Question::saveFirst:
            return askAbout(
                tr("The text writes %1. Save the scene first: files are written beside it only.").arg(list),
                QStringLiteral("write"), {}, {}, names);
    }
}

void FileWriter::askAbout(const QString& text, const QString& topic, const QString& label,
                          const QString& toolTip, const Names& names) {
    topics_.insert(topic.toStdString());
    if (parts_.notices->asks(topic, text)) return;
    std::vector<NoticeBar::Choice> choices;
    const bool ofItsOwn = topic != QStringLiteral("write");
    if (!label.isEmpty())
        choices.push_back({label, toolTip, [this, names, ofItsOwn] {
                               allowed_.insert(names.begin(), names.end());
                               write(names, ofItsOwn ? names : Names());
                           }});
    choices.push_back({tr("Not Now"),
                       tr("Write nothing; #read and #include of the same text find it all the same"),
                       [this, names] { declined_.insert(names.begin(), names.end()); }});
    parts_.notices->ask(text, std::move(choices), topic);
}

void FileWriter::withdraw(const Names& topics) {
    for (const std::string& topic : Names(topics)) {
        parts_.notices->withdraw(QString::fromStdString(topic));
        topics_.erase(topic);
    }
}

void FileWriter::write(const Names& names, const Names& replaceable) {
    if (!result_) return;
    WrittenFiles files = changed();
    std::erase_if(files, [&](const auto& file) { return !names.contains(file.first); });
    const std::vector<RefusedFile> refused = writeBeside(scene(), files, record_, replaceable);
    Names written;
    for (const auto& [name, content] : files) written.insert(name);
    Names notWritten;
    for (const RefusedFile& file : refused) {
        written.erase(file.name);
        notWritten.insert(file.name);
        // Told once, not with every change of the text.
        allowed_.erase(file.name);
        declined_.insert(file.name);
    }
    if (!written.empty()) emit said(tr("Written: %1").arg(listOf(written)));
    if (notWritten.empty()) return;
    parts_.notices->tell(
        tr("Not written: %1 (%2)").arg(listOf(notWritten), QString::fromLocal8Bit(refused.front().reason)));
}

}  // namespace isoscope
