// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include "tests/support/program.h"

namespace isoscope::test {

/// A file system of 64 KB of its own, to be filled and to be made read-only; gone at the end. Only root may
/// have one, and not in every container: then mounted() is false.
class SmallDisk {
  public:
    SmallDisk()
        : mounted_(run("mount", {"-t", "tmpfs", "-o", "size=64k", "isoscope-test", folder_.path()})) {}
    ~SmallDisk() {
        if (mounted_) run("umount", {"--lazy", folder_.path()});
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    bool mounted() const { return mounted_; }
    QString path(const QString& name) const { return folder_.filePath(name); }
    /// Not one more byte has room.
    void fill() const {
        QFile file(path("filling"));
        if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered)) return;
        const QByteArray page(4096, 'x');
        while (file.write(page) == page.size()) {
        }
    }
    void empty() const { QFile::remove(path("filling")); }
    void setReadOnly(bool readOnly) const {
        run("mount", {"-o", readOnly ? "remount,ro" : "remount,rw", folder_.path()});
    }

  private:
    static bool run(const QString& program, const QStringList& arguments) {
        return runProgram(program, arguments).status == 0;
    }

    QTemporaryDir folder_;
    bool mounted_;
};

}  // namespace isoscope::test
