// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <QObject>

class QLineEdit;
class QMenu;
class QToolButton;

namespace isoscope {

class ParameterBinding;
class ParameterPanel;
class SceneEditor;
struct TextEdit;

/// The button of a ParameterPanel for the presets of the text, with its menu and the field for their names.
/// All that it does to the text is one undo step each.
class PresetController : public QObject {
    Q_OBJECT
  public:
    /// All must outlive the controller.
    PresetController(SceneEditor* editor, ParameterPanel* panel, ParameterBinding* binding, QObject* parent);

    /// The entries are those of the present text once it has shown.
    QMenu* menu() const { return menu_; }
    /// Where a name is typed; hidden unless one is asked for.
    QLineEdit* nameField() const { return name_; }

  signals:
    /// For the status line.
    void said(const QString& message);

  protected:
    /// Escape in the field.
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void fillMenu();
    void addSubmenu(const QString& title, const QString& help, const QStringList& names,
                    const std::function<void(std::size_t)>& act);
    void apply(std::size_t index);
    void update(std::size_t index);
    void rename(std::size_t index);
    void remove(std::size_t index);
    void addNew();
    /// Shows the field; `accept` gets a name that no other preset has.
    void askName(const QString& suggested, const std::function<void(const QString&)>& accept);
    void acceptName();
    void closeField();
    void write(const TextEdit& edit);

    SceneEditor* editor_;
    ParameterPanel* panel_;
    ParameterBinding* binding_;
    QToolButton* button_;
    QMenu* menu_;
    QLineEdit* name_;
    QString suggested_;
    std::function<void(const QString&)> accept_;
};

}  // namespace isoscope
