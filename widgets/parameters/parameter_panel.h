// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <QHash>
#include <QWidget>
#include <string>
#include <utility>
#include <vector>

#include "core/language/sliders/slider_note.h"
#include "core/scene/scene.h"

class QLabel;
class QLineEdit;
class QHBoxLayout;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace isoscope {

class ParameterGroup;
struct ParameterPlace;
class ParameterSlider;
class SliderPlayer;
struct ValuePreset;

/// All numbers of the text that sliders can move, grouped by call or statement, with a filter. Indexes in the
/// signals are those of the vector last handed in.
class ParameterPanel : public QWidget {
    Q_OBJECT
  public:
    explicit ParameterPanel(QWidget* parent = nullptr);
    ~ParameterPanel() override;

    /// Shows the parameters of a parse. Rows that are still there keep their widget, focus, range set by the
    /// user and a drag in progress. `sources`, where given, adds the notes of the text about its sliders, and
    /// line numbers to tell several calls of one function apart.
    void setParameters(const std::vector<SceneParameter>& parameters, const SourceLibrary* sources = nullptr);
    /// Forgets rows, ranges and initial values: a new document.
    void clear();

    /// Shows a value that was changed elsewhere (scrubbing in the text); emits nothing.
    void setValue(int index, double value);
    int count() const { return static_cast<int>(rows_.size()); }
    /// Further parameters get no row, so that a text of thousands of numbers costs no time; a line says so.
    static constexpr std::size_t rowLimit = 200;
    /// The row of parameter `index`; null for a bad index or one without a row.
    ParameterSlider* slider(int index) const;
    /// The text to write for a value of parameter `index`: the shortest number that reads back as it, or the
    /// decimals that its note asks for. Values of sliders are round already.
    QString textFor(int index, double value) const;

    /// The row of the number that stands there; null without one.
    ParameterSlider* sliderAt(const SourceRange& number) const;
    /// The row of the setting of this role that stands in the statement, or is left out there; null without
    /// one.
    ParameterSlider* settingOf(const SourceRange& statement, ParameterRole role) const;
    /// The number of a row, -1 for another widget.
    int indexOf(const ParameterSlider* slider) const;
    /// Moves one of the rows by itself; never null.
    SliderPlayer* player() const { return player_; }

    /// The values of all rows that have a number in the text, by what presets call them.
    std::vector<std::pair<std::string, double>> presetValues() const;
    /// How many values of a preset could not be set.
    struct Applied {
        int locked = 0;
        int missing = 0;  ///< there is no such row
    };
    /// Sets the rows of a preset by valuesChosen(), whatever the filter shows; locked ones stay.
    Applied applyPreset(const ValuePreset& preset);

    /// Puts a button behind the filter, or a widget below it; the panel owns it.
    void addTool(QWidget* tool);
    void addBar(QWidget* bar);

    /// Ends runs of changes by keyboard, wheel or box, and what plays: undo is to find them complete.
    void settle();

  public slots:
    /// Random values for the rows that the filter shows and that shape the surface: not for settings of the
    /// root finder, containers, locked ones and expressions.
    void randomise();
    /// The rows that the filter shows go back to the values that they had first, locked ones apart.
    void resetAll();

  signals:
    /// The user moves a row: a start, values, and a finish, as ParameterSlider has them. A row that goes
    /// while it is dragged emits dragFinished() with the index that it had.
    void valueChanged(int index, double value);
    void dragStarted(int index);
    void dragFinished(int index);
    /// Several rows at once are to get values: one step for undo.
    void valuesChosen(const std::vector<std::pair<int, double>>& values);
    /// The user wants another note, or none, for the slider of a row.
    void noteChanged(int index, const std::optional<isoscope::SliderNote>& note);
    /// The timeline is to keep the present value of the row that presets call so.
    void keyRequested(const QString& presetName);
    /// A button asks to write the value of an expression in its place.
    void replaceExpressionRequested(int index);

  private:
    struct Row {
        QString key;
        QString presetName;
        ParameterSlider* slider = nullptr;
    };

    void buildTools();
    /// For each row that the filter shows, that can move and that `value` has one for.
    void choose(const std::function<std::optional<double>(const ParameterSlider&)>& value);
    ParameterSlider* makeSlider(const SceneParameter& parameter, const QString& key);
    void arrange(const std::vector<ParameterPlace>& places, const std::vector<SceneParameter>& parameters,
                 const SourceLibrary* sources, bool sameRows);
    QList<QWidget*> rowsOf(QList<std::size_t> members, const std::vector<SceneParameter>& parameters) const;
    void applyFilter();

    std::vector<Row> rows_;
    QHash<QString, double> initialValues_;  ///< of the document, by the keys of rows
    SliderPlayer* player_;
    int hidden_ = 0;
    QHash<QString, ParameterGroup*> groups_;
    QLineEdit* filter_ = nullptr;
    QHBoxLayout* tools_ = nullptr;
    QVBoxLayout* bars_ = nullptr;
    QScrollArea* scroll_ = nullptr;
    QVBoxLayout* list_ = nullptr;
    QLabel* empty_ = nullptr;
};

}  // namespace isoscope
