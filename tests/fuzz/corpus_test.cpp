// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QTest>
#include <ctime>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/scene_mutator.h"

using namespace isoscope::test;

/// Every target reads its corpus and changes of it: a crash, a hang or a sanitizer's report is a failure.
class CorpusTest : public QObject {
    Q_OBJECT

    static std::uint64_t setting(const char* name, std::uint64_t otherwise) {
        const QByteArray value = qgetenv(name);
        return value.isEmpty() ? otherwise : value.toULongLong();
    }

  private slots:
    void reads_data() {
        QTest::addColumn<int>("target");
        for (std::size_t i = 0; i < fuzzTargets().size(); ++i)
            QTest::newRow(fuzzTargets()[i].name.data()) << static_cast<int>(i);
    }

    void reads() {
        QFETCH(int, target);
        const FuzzTarget& subject = fuzzTargets()[static_cast<std::size_t>(target)];
        const std::vector<std::string> corpus = corpusOf(subject);
        if (corpus.empty()) QSKIP("no files of this kind are installed");
        for (const std::string& input : corpus) subject.read(input);

        const std::uint64_t seed = setting("ISOSCOPE_SEED", 20260101);
        const auto seconds = static_cast<qint64>(setting("ISOSCOPE_FUZZ_SECONDS", 0));
        // Short ones are read many times as fast.
        const std::uint64_t most = setting("ISOSCOPE_FUZZ_LENGTH", 1 << 20);
        constexpr std::uint64_t changes = 300;
        std::mt19937_64 random(seed);
        std::uint64_t executions = corpus.size();
        std::clock_t slowest = 0;  // of the processor: other programs take none of it
        QElapsedTimer watch;
        watch.start();
        for (std::uint64_t i = 0; i < changes || watch.elapsed() < 1000 * seconds; ++i, ++executions) {
            const std::string first = partOf(corpus[random() % corpus.size()], most, subject.isText, random);
            const std::string& second = corpus[random() % corpus.size()];
            const bool tokens = subject.isText && random() % 4 != 0;
            const std::string input =
                tokens ? changedTokens(first, second, random) : changedBytes(first, random);
            keep(subject, input);
            const std::clock_t start = std::clock();
            subject.read(input);
            const std::clock_t took = std::clock() - start;
            if (took > slowest) {
                slowest = took;
                keepSlowest(subject, input);
            }
        }
        qInfo("seed %llu: %llu executions in %.1f s, the slowest %.0f ms of the processor",
              static_cast<unsigned long long>(seed), static_cast<unsigned long long>(executions),
              static_cast<double>(watch.elapsed()) / 1000,
              1000 * static_cast<double>(slowest) / CLOCKS_PER_SEC);
    }

  private:
    /// With ISOSCOPE_FUZZ_KEEP=FOLDER the input at hand is there after a crash, and the slowest one.
    static void keep(const FuzzTarget& target, const std::string& input) { write(target, "-last", input); }
    static void keepSlowest(const FuzzTarget& target, const std::string& input) {
        write(target, "-slowest", input);
    }
    static void write(const FuzzTarget& target, const char* what, const std::string& input) {
        static const QByteArray folder = qgetenv("ISOSCOPE_FUZZ_KEEP");
        if (folder.isEmpty()) return;
        QFile file(QString::fromUtf8(folder) + '/' + QString::fromUtf8(target.name.data()) + what);
        if (file.open(QIODevice::WriteOnly)) file.write(input.data(), static_cast<qint64>(input.size()));
    }
};

int main(int argc, char** argv) {
    // QtTest takes for hanging what is not done after five minutes.
    const qulonglong seconds = qgetenv("ISOSCOPE_FUZZ_SECONDS").toULongLong();
    if (seconds > 0) qputenv("QTEST_FUNCTION_TIMEOUT", QByteArray::number(1000 * (seconds + 300)));
    CorpusTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "corpus_test.moc"
