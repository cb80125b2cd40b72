// SPDX-License-Identifier: GPL-3.0-or-later
// The checklist of the tutorials (data/spec/coverage_ids.txt, one ID a line): a row is covered when a test
// bears its ID, or the beginning of it that names its group, in its own name or in that of its data row. Asks
// the test programs beside this one for the names, and prints rows covered / rows.
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>
#include <map>
#include <set>

#include "test_folders.h"
#include "tests/support/csv_table.h"

using namespace isoscope;

namespace {

QStringList rowsOfChecklist() {
    QFile file(QStringLiteral(ISOSCOPE_TEST_DATA "/spec/coverage_ids.txt"));
    QStringList ids;
    if (file.open(QIODevice::ReadOnly))
        for (const QByteArray& line : file.readAll().split('\n'))
            if (!line.trimmed().isEmpty()) ids << line.trimmed();
    return ids;
}

/// Every ID, and every beginning of one: "PRIM-BLOB-EX" names two rows.
std::set<QString> namesOfGroups(const QStringList& ids) {
    std::set<QString> groups;
    for (QString id : ids)
        for (; !id.isEmpty(); id = id.left(std::max<qsizetype>(id.lastIndexOf('-'), 0))) groups.insert(id);
    return groups;
}

/// IDs in names of functions are written with `_`, and several may follow each other.
void addFromFunction(const QString& function, const std::set<QString>& groups, std::set<QString>& named) {
    const QStringList parts = function.split('_').mid(1);
    for (qsizetype first = 0; first < parts.size(); ++first)
        for (qsizetype count = parts.size() - first; count > 0; --count) {
            const QString group = parts.mid(first, count).join('-');
            if (!groups.contains(group)) continue;
            named.insert(group);
            first += count - 1;
            break;
        }
}

/// What the lines of `-datatags` name: class, function, tag.
std::set<QString> groupsNamedBy(const QString& lines, const std::set<QString>& groups) {
    std::set<QString> named;
    for (const QString& line : lines.split('\n')) {
        const QStringList words = line.split(' ', Qt::SkipEmptyParts);
        if (words.size() < 2) continue;
        addFromFunction(words[1], groups, named);
        for (const QString& word : words.mid(2))
            if (groups.contains(word)) named.insert(word);
    }
    return named;
}

}  // namespace

class CoverageTest : public QObject {
    Q_OBJECT

  private slots:
    void idsAreFoundInNames() {
        const std::set<QString> groups = namesOfGroups({"PRIM-HF-11", "CONF-09", "FN-R", "FN-TORUS2-P0"});
        const auto found = [&](const char* lines) { return groupsNamedBy(lines, groups); };
        QCOMPARE(found("ATest triangles_PRIM_HF_11_CONF_09"), (std::set<QString>{"PRIM-HF-11", "CONF-09"}));
        QCOMPARE(found("ATest values FN-TORUS2 f_torus2"), (std::set<QString>{"FN-TORUS2"}));
        QCOMPARE(found("ATest values FN-TORUS"), std::set<QString>());
        QCOMPARE(found("ATest values_PRIM FN-R\nATest others"), (std::set<QString>{"PRIM", "FN-R"}));
    }

    void rowsCoveredOfAll() {
        const QStringList ids = rowsOfChecklist();
        QCOMPARE(ids.size(), 1418);
        const std::set<QString> groups = namesOfGroups(ids);
        const QDir folder(QCoreApplication::applicationDirPath());
        std::set<QString> named;
        int programs = 0;
        for (const char* area : {"function", "language", "render", "roots", "shapes", "virtualight"})
            for (const QString& program :
                 folder.entryList({QString("test_%1_*").arg(area)}, QDir::Files | QDir::Executable)) {
                QProcess process;
                process.start(folder.filePath(program), {"-datatags"});
                if (!process.waitForFinished() || process.exitCode() != 0) continue;
                ++programs;
                named.merge(groupsNamedBy(QString::fromUtf8(process.readAllStandardOutput()), groups));
            }
        std::map<QString, int> open;
        int covered = 0;
        for (const QString& id : ids) {
            bool held = false;
            for (QString group = id; !group.isEmpty() && !held;
                 group = group.left(std::max<qsizetype>(group.lastIndexOf('-'), 0)))
                held = named.contains(group);
            covered += held;
            if (!held) ++open[id];
        }
        for (const auto& [id, count] : open) qInfo("no test: %s", qPrintable(id));
        qInfo("%d / %lld rows covered, by the names of the tests in %d programs", covered,
              static_cast<long long>(ids.size()), programs);
        QCOMPARE(covered, ids.size());
    }
};

QTEST_GUILESS_MAIN(CoverageTest)
#include "coverage_test.moc"
