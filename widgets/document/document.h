// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QObject>
#include <QString>

namespace isoscope {

/// The file behind the editor's text: its path, how it is written on disk (encoding, line ends) and whether
/// the text has changed since. The text itself belongs to the editor.
class Document : public QObject {
    Q_OBJECT
  public:
    explicit Document(QObject* parent = nullptr);

    /// Absolute; empty for a text that was never saved.
    QString filePath() const { return filePath_; }
    /// The file's name; without one what reset() called the text, or "Untitled".
    QString name() const;
    /// For the window: the name with Qt's "[*]" place for the modified mark.
    QString title() const;
    /// Also when the file is known to be gone, or another text stands there by the user's wish.
    bool isModified() const { return modified_ || missing_ || apart_; }

    /// Forgets the file; the text is a new one, to be called `name`.
    void reset(const QString& name = {});
    /// Reads a file, which becomes the document's: UTF-8 with or without a mark, else Latin-1, so that no
    /// byte is lost. Lines of the returned text end in \n (mixed line ends are left alone). Empty, with
    /// errorText() set and the document unchanged, when it cannot be read or is larger than `sizeLimit`.
    std::optional<QString> load(const QString& path);
    /// Writes the text as it was encoded before (UTF-8 when a character asks for it), whole or not at all
    /// (core/text/whole_file.h). True makes `path` the document's and the text unmodified. What another
    /// program has written there is not asked for: see onDisk().
    bool save(const QString& path, const QString& text);
    QString errorText() const { return errorText_; }

    /// What stands at the path, beside what was last read or written there.
    enum class OnDisk { same, changed, missing };
    /// `thorough` compares the bytes even when time stamp, size and place on the disk are the same. `same`
    /// without a path.
    OnDisk onDisk(bool thorough = false) const;
    /// The text that stands there; empty when it cannot be read.
    std::optional<QString> textOnDisk() const;
    /// Tells one content of the disk from another; the same for all that cannot be read.
    QByteArray diskDigest() const;
    /// What stands there now is known, and may be written over; until then the text counts as modified.
    void acceptDisk();
    /// Of what was last read or written.
    const QByteArray& digest() const { return digest_; }
    /// The text was made from what had this digest, whatever has been read now.
    void setDigest(const QByteArray& digest);
    /// The file is gone, or back.
    void setMissing(bool missing);

    static constexpr qint64 sizeLimit = 64 << 20;

  public slots:
    /// Whether the text differs from what was last read or written; emits changed() when that is new.
    void setModified(bool modified);

  signals:
    /// Path or modified state changed.
    void changed();

  private:
    enum class Encoding { utf8, utf8WithMark, latin1 };

    /// What tells one state of a file from another.
    struct Stamp {
        qint64 size = -1;
        qint64 seconds = 0;
        qint64 nanoseconds = 0;
        quint64 place = 0;
        bool operator==(const Stamp&) const = default;
    };
    struct Content {
        QByteArray bytes;
        Stamp stamp;
        QString problem;  ///< why there are no bytes
    };
    struct Decoded {
        QString text;
        Encoding encoding;
    };
    static Decoded decoded(QByteArray bytes);
    static Stamp stampOf(const QString& path);
    static Content contentOf(const QString& path);
    void remember(const QByteArray& bytes, const Stamp& stamp);

    QString filePath_;
    QString unsavedName_;
    QString errorText_;
    QByteArray digest_;  ///< of the bytes that were last read or written
    mutable Stamp stamp_;
    QString lineEnd_ = QStringLiteral("\n");
    Encoding encoding_ = Encoding::utf8;
    bool modified_ = false;
    bool missing_ = false;
    bool apart_ = false;
};

}  // namespace isoscope
