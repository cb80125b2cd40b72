// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/kept_texts_window.h"

#include <algorithm>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "widgets/interface_style.h"

namespace isoscope {

namespace {

constexpr QSize firstSize{760, 460};
constexpr int previewLines = 200;
constexpr int listWidth = 260;

}  // namespace

QString keptName(const UnsavedText& text) {
    return text.filePath.isEmpty() ? QObject::tr("A new scene") : QFileInfo(text.filePath).fileName();
}

KeptTextsWindow::KeptTextsWindow(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Kept texts"));
    auto* layout = new QVBoxLayout(this);
    summary_ = new QLabel;
    summary_->setWordWrap(true);
    layout->addWidget(summary_);
    auto* split = new QSplitter;
    list_ = new QListWidget;
    list_->setAccessibleName(tr("Kept texts"));
    list_->setAlternatingRowColors(true);
    split->addWidget(list_);
    auto* right = new QWidget;
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(0, 0, 0, 0);
    place_ = new QLabel;
    place_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    place_->setWordWrap(true);
    column->addWidget(place_);
    preview_ = new QPlainTextEdit;
    preview_->setReadOnly(true);
    preview_->setLineWrapMode(QPlainTextEdit::NoWrap);
    preview_->setFont(fixedFont());
    preview_->setAccessibleName(tr("First lines of the text"));
    column->addWidget(preview_, 1);
    split->addWidget(right);
    split->setStretchFactor(1, 1);
    split->setSizes({listWidth, firstSize.width() - listWidth});
    layout->addWidget(split, 1);

    auto* buttons = new QDialogButtonBox;
    const auto add = [&](const QString& label, const QString& toolTip) {
        QPushButton* button = buttons->addButton(label, QDialogButtonBox::ActionRole);
        button->setToolTip(toolTip);
        return button;
    };
    bringBack_ = add(tr("Bring Back"), tr("Show this text in the editor"));
    discard_ = add(tr("Discard"), tr("Delete this text for good"));
    discardAll_ = add(tr("Discard All"), tr("Delete all kept texts for good"));
    QPushButton* closing = buttons->addButton(QDialogButtonBox::Close);
    layout->addWidget(buttons);
    bringBack_->setDefault(true);
    resize(firstSize);

    connect(closing, &QPushButton::clicked, this, &QDialog::close);
    connect(list_, &QListWidget::currentRowChanged, this, &KeptTextsWindow::showPreview);
    connect(list_, &QListWidget::itemActivated, bringBack_, &QPushButton::click);
    connect(bringBack_, &QPushButton::clicked, this, [this] { emit bringBackRequested(currentId()); });
    connect(discard_, &QPushButton::clicked, this, [this] { emit discardRequested({currentId()}); });
    connect(discardAll_, &QPushButton::clicked, this, [this] {
        if (!asking_) return askWhetherAll(true);
        QStringList ids;
        for (const UnsavedText& text : texts_) ids << text.id;
        emit discardRequested(ids);
    });
}

QString KeptTextsWindow::currentId() const {
    const int row = list_->currentRow();
    return row < 0 || row >= count() ? QString() : texts_[static_cast<std::size_t>(row)].id;
}

void KeptTextsWindow::askWhetherAll(bool asking) {
    asking_ = asking;
    discardAll_->setText(asking ? tr("Discard All %1 for Good").arg(count()) : tr("Discard All"));
}

void KeptTextsWindow::setTexts(std::vector<UnsavedText> texts) {
    const int row = list_->currentRow();
    texts_ = std::move(texts);
    list_->clear();
    for (const UnsavedText& text : texts_)
        list_->addItem(keptName(text) + QLatin1Char('\n') +
                       QLocale().toString(text.saved.toLocalTime(), QLocale::ShortFormat));
    summary_->setText(count() == 0 ? tr("There are no kept texts.")
                                   : tr("Texts that were never saved. Each stays here until it is saved or "
                                        "discarded, for %1 days at least.")
                                         .arg(RecoveryStore::keptDays));
    list_->setCurrentRow(std::clamp(row, 0, std::max(0, count() - 1)));
    showPreview();
}

void KeptTextsWindow::showPreview() {
    askWhetherAll(false);
    const int row = list_->currentRow();
    const bool any = row >= 0 && row < count();
    for (QPushButton* button : {bringBack_, discard_}) button->setEnabled(any);
    discardAll_->setEnabled(count() > 0);
    if (!any) {
        place_->clear();
        preview_->clear();
        return;
    }
    const UnsavedText& text = texts_[static_cast<std::size_t>(row)];
    place_->setText(text.filePath.isEmpty() ? tr("Never had a file") : text.filePath);
    preview_->setPlainText(text.text.section(QLatin1Char('\n'), 0, previewLines - 1));
}

}  // namespace isoscope
