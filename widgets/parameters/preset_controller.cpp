// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/preset_controller.h"

#include <algorithm>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <utility>

#include "core/language/sliders/value_preset.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/icons.h"
#include "widgets/parameters/parameter_binding.h"
#include "widgets/parameters/parameter_panel.h"

namespace isoscope {
namespace {

/// As text of a menu, where & marks a key.
QString menuText(QString name) { return name.isEmpty() ? QStringLiteral("“”") : name.replace('&', "&&"); }

}  // namespace

PresetController::PresetController(SceneEditor* editor, ParameterPanel* panel, ParameterBinding* binding,
                                   QObject* parent)
    : QObject(parent),
      editor_(editor),
      panel_(panel),
      binding_(binding),
      button_(new QToolButton(panel)),
      menu_(new QMenu(button_)),
      name_(new QLineEdit(panel)) {
    button_->setIcon(themeIcon("bookmarks"));
    button_->setText(tr("Presets"));
    button_->setAutoRaise(true);
    button_->setFocusPolicy(Qt::StrongFocus);
    button_->setPopupMode(QToolButton::InstantPopup);
    button_->setMenu(menu_);
    button_->setToolTip(tr("Presets: named sets of values, kept in the text"));
    button_->setAccessibleName(tr("Presets"));
    menu_->setToolTipsVisible(true);
    connect(menu_, &QMenu::aboutToShow, this, &PresetController::fillMenu);
    name_->setAccessibleName(tr("Name of the preset"));
    name_->setPlaceholderText(tr("Name of the preset"));
    name_->setToolTip(tr("Enter keeps the preset under this name, Esc leaves it"));
    name_->installEventFilter(this);
    name_->hide();
    connect(name_, &QLineEdit::returnPressed, this, &PresetController::acceptName);
    panel->addTool(button_);
    panel->addBar(name_);
}

void PresetController::fillMenu() {
    menu_->clear();
    QStringList names;
    for (const ValuePreset& preset : presetsOf(editor_->utf8())) names << QString::fromStdString(preset.name);
    for (qsizetype i = 0; i < names.size(); ++i) {
        QAction* action =
            menu_->addAction(menuText(names[i]), this, [this, i] { apply(static_cast<std::size_t>(i)); });
        action->setToolTip(tr("Sets the numbers to those of this preset; locked ones stay"));
    }
    if (!names.isEmpty()) menu_->addSeparator();
    QAction* add = menu_->addAction(tr("New preset…"), this, &PresetController::addNew);
    add->setToolTip(tr("Keeps the present values under a name, in a comment of the text"));
    add->setEnabled(!panel_->presetValues().empty());
    addSubmenu(tr("Update"), tr("The preset takes the present values"), names,
               [this](std::size_t i) { update(i); });
    addSubmenu(tr("Rename"), tr("Another name for the preset"), names, [this](std::size_t i) { rename(i); });
    addSubmenu(tr("Delete"), tr("Takes the preset out of the text"), names,
               [this](std::size_t i) { remove(i); });
}

void PresetController::addSubmenu(const QString& title, const QString& help, const QStringList& names,
                                  const std::function<void(std::size_t)>& act) {
    QMenu* menu = menu_->addMenu(title);
    menu->setEnabled(!names.isEmpty());
    menu->setToolTipsVisible(true);
    for (qsizetype i = 0; i < names.size(); ++i)
        menu->addAction(menuText(names[i]), this, [act, i] { act(static_cast<std::size_t>(i)); })
            ->setToolTip(help);
}

void PresetController::apply(std::size_t index) {
    const std::vector<ValuePreset> presets = presetsOf(editor_->utf8());
    if (index >= presets.size()) return;
    const ParameterPanel::Applied applied = panel_->applyPreset(presets[index]);
    const QString name = QString::fromStdString(presets[index].name);
    QString message = tr("Preset “%1” is set.").arg(name);
    if (applied.locked > 0) message += ' ' + tr("Locked and left as they are: %1.").arg(applied.locked);
    if (applied.missing > 0) message += ' ' + tr("Not in the text: %1.").arg(applied.missing);
    emit said(message);
}

void PresetController::update(std::size_t index) {
    panel_->settle();
    const std::string text = editor_->utf8();
    const std::vector<ValuePreset> presets = presetsOf(text);
    if (index >= presets.size()) return;
    write(presetReplaced(text, index, {presets[index].name, panel_->presetValues()}));
}

void PresetController::rename(std::size_t index) {
    const std::vector<ValuePreset> presets = presetsOf(editor_->utf8());
    if (index >= presets.size()) return;
    const std::string old = presets[index].name;
    askName(QString::fromStdString(old), [this, old](const QString& name) {
        const std::string text = editor_->utf8();
        const std::vector<ValuePreset> now = presetsOf(text);
        const auto preset =
            std::find_if(now.begin(), now.end(), [&](const ValuePreset& one) { return one.name == old; });
        if (preset == now.end()) return;
        write(presetReplaced(text, static_cast<std::size_t>(preset - now.begin()),
                             {name.toStdString(), preset->values}));
    });
}

void PresetController::remove(std::size_t index) {
    panel_->settle();
    const std::string text = editor_->utf8();
    if (index < presetsOf(text).size()) write(presetRemoved(text, index));
}

void PresetController::addNew() {
    const auto count = presetsOf(editor_->utf8()).size();
    askName(tr("Preset %1").arg(count + 1), [this](const QString& name) {
        panel_->settle();
        write(presetAdded(editor_->utf8(), {name.toStdString(), panel_->presetValues()}));
    });
}

void PresetController::askName(const QString& suggested, const std::function<void(const QString&)>& accept) {
    accept_ = accept;
    suggested_ = suggested;
    name_->setText(suggested);
    name_->show();
    name_->setFocus();
    name_->selectAll();
}

void PresetController::acceptName() {
    const QString name = QString::fromStdString(presetWord(name_->text().toStdString()));
    if (name.isEmpty()) return emit said(tr("A preset needs a name."));
    const std::vector<ValuePreset> presets = presetsOf(editor_->utf8());
    const bool taken = std::any_of(presets.begin(), presets.end(), [&](const ValuePreset& preset) {
        return QString::fromStdString(preset.name) == name;
    });
    // The old name of one that is renamed is its own.
    if (taken && name != suggested_) return emit said(tr("There is a preset “%1” already.").arg(name));
    const auto accept = std::exchange(accept_, nullptr);
    closeField();
    if (accept && !taken) accept(name);
}

void PresetController::closeField() {
    accept_ = nullptr;
    name_->hide();
    button_->setFocus();
}

bool PresetController::eventFilter(QObject*, QEvent* event) {
    if (event->type() != QEvent::KeyPress || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
        return false;
    closeField();
    return true;
}

void PresetController::write(const TextEdit& edit) { binding_->changeComment(edit); }

}  // namespace isoscope
