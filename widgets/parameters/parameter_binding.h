// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <QObject>
#include <utility>
#include <vector>

#include "core/language/parse.h"
#include "core/language/sliders/slider_note.h"

namespace isoscope {

class ParameterPanel;
class SceneEditor;
class SceneSession;
class TextFeed;

/// Keeps text, sliders and scene in step: a slider rewrites its number in the text and, where the scene has a
/// slot for it, changes the scene at once; a parse of the text as it stands sets up the sliders anew.
/// What the user changes about a slider itself is written behind its number. Parameters of include files have
/// no slider, since their text is not in the editor.
class ParameterBinding : public QObject {
    Q_OBJECT
  public:
    /// All of them must outlive the binding. `feed` hands the same text to the same session.
    ParameterBinding(SceneEditor* editor, ParameterPanel* panel, SceneSession* session, TextFeed* feed,
                     QObject* parent = nullptr);

    /// The parameters that have sliders, in the panel's order.
    const std::vector<SceneParameter>& parameters() const { return parameters_; }
    /// The text went to the session outside the binding's own doing (a new document): nothing is waiting.
    void clear();
    /// Changes a comment of the text, which changes nothing of the scene but places: an undo step of its own.
    void changeComment(const TextEdit& edit) { changeComments({edit}); }
    /// Several, each with the places that it has behind the ones before it: one undo step.
    void changeComments(const std::vector<TextEdit>& edits);
    /// Numbers by their indexes in parameters().
    using Values = std::vector<std::pair<int, double>>;
    /// Shows them in the picture without a change of the text, until keepPlayed(). `parse`: the text is read
    /// again even where all have slots.
    void showPlayed(const Values& values, bool parse);
    /// What was shown is over: the text gets these, those that differ in one undo step, and is what is shown.
    void keepPlayed(const Values& values);

  signals:
    /// A value that plays gives no picture, for the text has errors with it.
    void playedInVain();
    /// For the status line.
    void said(const QString& message);

  private:
    void adopt(const std::shared_ptr<const ParseResult>& result, quint64 revision);
    void move(int index, double value);
    /// Puts the number into the text; a setting that was left out gets its name with it.
    bool write(int index, const QString& text);
    void finishPlay(int index, double value);
    void moveAll(const std::vector<std::pair<int, double>>& values);
    void writeNote(int index, const std::optional<SliderNote>& note);
    bool isIndex(int index) const { return index >= 0 && index < static_cast<int>(parameters_.size()); }
    void scrub(int index, double value);
    void replaceExpression(int index);
    void submit(int index, double value);

    SceneEditor* editor_;
    ParameterPanel* panel_;
    SceneSession* session_;
    TextFeed* feed_;
    std::vector<SceneParameter> parameters_;
    std::shared_ptr<const ParseResult> owner_;  ///< the result that the sliders belong to
};

}  // namespace isoscope
