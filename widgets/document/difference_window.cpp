// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/difference_window.h"

#include <algorithm>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTextBlock>
#include <QVBoxLayout>

#include "widgets/document/line_difference.h"
#include "widgets/interface_style.h"

namespace isoscope {

namespace {

using Kind = DifferenceLine::Kind;

constexpr std::size_t context = 3;
constexpr QSize firstSize{760, 520};

/// Faint, so that the text stays readable in light and dark.
QColor background(Kind kind) {
    return kind == Kind::onlyFirst ? QColor(220, 60, 60, 70) : QColor(60, 180, 80, 70);
}

/// Whether line `index` differs or stands near one that does.
bool isNear(const std::vector<DifferenceLine>& lines, std::size_t index) {
    const std::size_t from = index < context ? 0 : index - context,
                      to = std::min(lines.size(), index + context + 1);
    return std::any_of(lines.begin() + static_cast<std::ptrdiff_t>(from),
                       lines.begin() + static_cast<std::ptrdiff_t>(to),
                       [](const DifferenceLine& line) { return line.kind != Kind::both; });
}

}  // namespace

DifferenceWindow::DifferenceWindow(const QString& name, const QString& onDisk, const QString& here,
                                   QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(tr("%1: the disk and the editor").arg(name));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* layout = new QVBoxLayout(this);
    summary_ = new QLabel;
    summary_->setWordWrap(true);
    layout->addWidget(summary_);
    text_ = new QPlainTextEdit;
    text_->setReadOnly(true);
    text_->setLineWrapMode(QPlainTextEdit::NoWrap);
    text_->setFont(fixedFont());
    text_->setAccessibleName(tr("Differing lines"));
    layout->addWidget(text_, 1);
    auto* buttons = new QDialogButtonBox;
    const auto add = [&](const QString& label, const QString& toolTip, auto signal) {
        QPushButton* button = buttons->addButton(label, QDialogButtonBox::ActionRole);
        button->setToolTip(toolTip);
        connect(button, &QPushButton::clicked, this, [this, signal] {
            emit(this->*signal)();
            close();
        });
    };
    add(tr("Take Theirs"), tr("Show the text of the disk; Undo brings yours back"),
        &DifferenceWindow::takeTheirs);
    add(tr("Keep Mine"), tr("Go on with the text of the editor; saving replaces the file"),
        &DifferenceWindow::keepMine);
    connect(buttons->addButton(QDialogButtonBox::Close), &QPushButton::clicked, this, &QDialog::close);
    layout->addWidget(buttons);
    resize(firstSize);
    showLines(lineDifference(onDisk, here));
}

QString DifferenceWindow::shownText() const { return text_->toPlainText(); }

void DifferenceWindow::showLines(const std::vector<DifferenceLine>& lines) {
    int removed = 0, added = 0;
    bool gap = false;
    QTextCursor cursor(text_->document());
    const QTextBlockFormat plain = cursor.blockFormat();
    const auto write = [&](const QString& line, const QTextBlockFormat& format) {
        if (!text_->document()->isEmpty()) cursor.insertBlock();
        cursor.setBlockFormat(format);
        cursor.insertText(line);
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const DifferenceLine& line = lines[i];
        if (!isNear(lines, i)) {
            if (!gap) write(QStringLiteral("…"), plain);
            gap = true;
            continue;
        }
        gap = false;
        removed += line.kind == Kind::onlyFirst;
        added += line.kind == Kind::onlySecond;
        QTextBlockFormat format = plain;
        if (line.kind != Kind::both) format.setBackground(background(line.kind));
        const QString mark = line.kind == Kind::both        ? QStringLiteral("  ")
                             : line.kind == Kind::onlyFirst ? QStringLiteral("- ")
                                                            : QStringLiteral("+ ");
        write(mark + line.text, format);
    }
    text_->moveCursor(QTextCursor::Start);
    summary_->setText(removed + added == 0
                          ? tr("Both texts are the same.")
                          : tr("−  red: lines that stand only on the disk (%1).   +  green: lines that stand "
                               "only in the editor (%2).")
                                .arg(removed)
                                .arg(added));
}

}  // namespace isoscope
