// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QByteArray>
#include <QString>
#include <utility>
#include <vector>

namespace isoscope {

/// The steps of an undo history as data, so that they can be stored and done again in another run: what each
/// changed in the text, and what stands beside the text as an opaque record. Places are byte offsets.
class EditJournal {
  public:
    /// `removed` stood at `begin` and made way for `inserted`.
    struct Replacement {
        qint64 begin = 0;
        QByteArray removed, inserted;

        friend bool operator==(const Replacement&, const Replacement&) = default;
    };
    /// One undo step: replacements of the text, one after the other, or, where `kind` is not empty, a step
    /// beside the text.
    struct Step {
        std::vector<Replacement> text;
        QString kind;       ///< who understands the record
        QByteArray record;  ///< what it was before and after
        bool joined = false;

        friend bool operator==(const Step&, const Step&) = default;
    };

    /// No steps.
    void clear();
    /// `text` came to `at`, or went from there. `begins` a step, else it belongs to the last one. Steps that
    /// were taken back are gone.
    void change(qint64 at, const QByteArray& text, bool inserted, bool begins);
    /// A step beside the text.
    void add(Step step);
    /// The last step was taken back, or done again.
    void undone();
    void redone();
    /// The text as it is now is the saved one, or none is.
    void setSaved(bool saved) { saved_ = saved ? done_ : -1; }

    /// All steps, those that were taken back, too.
    const std::vector<Step>& steps() const { return steps_; }
    /// What stands beside the text after step number `step`, from 0, as it is now.
    void setRecord(std::size_t step, QByteArray record) { steps_[step].record = std::move(record); }
    /// How many of them lead to the present text, and to the saved one; negative when that is not known.
    int done() const { return done_; }
    int saved() const { return saved_; }

    /// The text after `count` steps, at most done(), when the present one is `text`; nothing when the steps
    /// do not lead to it.
    std::optional<QByteArray> textAfter(int count, QByteArray text) const;

    /// Bytes to store, of the last steps alone where all would be too many.
    QByteArray packed() const;
    /// What packed() gave; nothing for any other bytes.
    static std::optional<EditJournal> unpacked(const QByteArray& bytes);

    /// What packed() keeps at most.
    static constexpr int mostSteps = 500;
    static constexpr qsizetype mostBytes = 1'000'000;

  private:
    std::vector<Step> steps_;
    int done_ = 0;
    int saved_ = 0;
};

}  // namespace isoscope
