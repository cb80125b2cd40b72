// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QByteArray>
#include <QString>

namespace isoscope {

/// Undo histories on disk, one for each document, in the application's data folder; other users may not read
/// them. A history is found again by the text that it leads to, so that it never meets another text.
class HistoryStore {
  public:
    /// `folder` empty means "history" in the application's data folder. The oldest histories beyond
    /// `mostFiles` are removed; age alone says nothing where a clock was wrong.
    explicit HistoryStore(QString folder = {});

    static constexpr int mostFiles = 50;

    /// What a document's history is called: by its file, or, without one, by anything that is its own.
    static QString nameOf(const QString& document);
    /// Replaces the history of that name; `steps` empty removes it. False when it cannot be written.
    bool write(const QString& name, const QString& text, const QByteArray& steps) const;
    /// The history that leads to `text`, that of this name before others; nothing without one.
    std::optional<QByteArray> find(const QString& name, const QString& text) const;

  private:
    void removeOld() const;

    QString folder_;
};

}  // namespace isoscope
