// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include "tests/support/program.h"

namespace isoscope::test {

/// A folder that goes with the test, and its files.
class TestFolder {
  public:
    QString path(const QString& name) const { return folder_.filePath(name); }
    QByteArray contents(const QString& name) const {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(no file)");
    }
    /// Of all files, hidden ones too.
    QStringList names() const {
        return QDir(folder_.path()).entryList(QDir::Files | QDir::Hidden, QDir::Name);
    }
    /// Returns the path.
    QString write(const QString& name, const QByteArray& text) const {
        return writeFile(folder_.path(), name, text);
    }

  private:
    QTemporaryDir folder_;
};

}  // namespace isoscope::test
