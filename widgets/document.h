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
    /// The file's name, "Untitled" without one.
    QString name() const;
    /// For the window: the name with Qt's "[*]" place for the modified mark.
    QString title() const;
    bool isModified() const { return modified_; }

    /// Forgets the file; the text is a new one.
    void reset();
    /// Reads a file, which becomes the document's: UTF-8 with or without a mark, else Latin-1, so that no
    /// byte is lost. Lines of the returned text end in \n (mixed line ends are left alone). Empty, with
    /// errorText() set and the document unchanged, when it cannot be read or is larger than `sizeLimit`.
    std::optional<QString> load(const QString& path);
    /// Writes the text as it was encoded before (UTF-8 when a character asks for it), by way of a temporary
    /// file so that the old file survives every failure. True makes `path` the document's and the text
    /// unmodified.
    bool save(const QString& path, const QString& text);
    QString errorText() const { return errorText_; }

    static constexpr qint64 sizeLimit = 64 << 20;

  public slots:
    void setModified(bool modified);

  signals:
    /// Path or modified state changed.
    void changed();

  private:
    enum class Encoding { utf8, utf8WithMark, latin1 };

    QString filePath_;
    QString errorText_;
    QString lineEnd_ = QStringLiteral("\n");
    Encoding encoding_ = Encoding::utf8;
    bool modified_ = false;
};

}  // namespace isoscope
