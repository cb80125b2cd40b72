// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>
#include <vector>

namespace isoscope {

/// An unsaved text as it is kept on disk.
struct UnsavedText {
    QString id;        ///< of the kept copy
    QString filePath;  ///< of the document; empty for a new one
    QString text;
    QByteArray base;  ///< Document::digest() of the file that the text was made from
    QDateTime saved;  ///< when the copy was written
};

/// Keeps a copy of the unsaved text in the application's data folder, one file per running instance guarded
/// by a lock, so that a crash or a kill loses at most two seconds of typing; other users may not read it.
/// Nothing is ever restored by itself: the next start asks abandoned() and offers it. A copy is removed only
/// by markSaved(), discard() or, thirty days old, by cleaning, never before it was offered for a day.
class RecoveryStore : public QObject {
    Q_OBJECT
  public:
    /// What is to be kept now: text, filePath and base are used.
    using Snapshot = std::function<UnsavedText()>;

    /// `folder` empty means "recovery" in the application's data folder.
    explicit RecoveryStore(Snapshot snapshot, QString folder = {}, QObject* parent = nullptr);
    /// A normal end keeps the copy unless markSaved() was called: the window decides, not this class.
    ~RecoveryStore() override;

    /// Half of the two seconds that are promised: a busy machine is late.
    static constexpr int interval = 1000;
    static constexpr int keptDays = 30;

    /// Copies left by instances that no longer run, newest first.
    std::vector<UnsavedText> abandoned() const;
    /// Makes an abandoned copy this instance's own and returns it; empty when another instance was faster.
    /// The text stays on disk all the time.
    std::optional<UnsavedText> take(const QString& id);
    /// Deletes an abandoned copy: the user said so.
    void discard(const QString& id);

    /// Whether the text has a copy, at most `interval` old.
    bool isKept() const { return lock_ && errorText_.isEmpty(); }
    /// Why the last copy could not be written; empty when it could.
    QString errorText() const { return errorText_; }

  public slots:
    /// The text changed: a copy is written at most `interval` later.
    void textChanged();
    /// Writes a waiting copy now: on loss of focus and before risky steps.
    void flush();
    /// The text is safe in its file, or was given up by the user: the copy goes.
    void markSaved();

  signals:
    /// isKept() has changed, or a copy was renewed.
    void kept();
    void failed(const QString& message);

  private:
    QString path(const QString& id) const;
    bool makeFolder() const;
    bool write(const UnsavedText& text);
    std::optional<UnsavedText> read(const QString& id) const;
    void removeOld() const;
    QDateTime beginOffer() const;

    Snapshot snapshot_;
    QString folder_;
    QString id_;
    QString errorText_;
    std::unique_ptr<QLockFile> lock_;
    QTimer timer_;
    bool waiting_ = false;
};

}  // namespace isoscope
