// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/tables/density_table.h"

#include <QTemporaryDir>
#include <QTest>

using namespace isoscope;

namespace {

std::shared_ptr<const DensityVolume> read(const QByteArray& bytes, std::string& problem) {
    const QTemporaryDir folder;
    const QString name = folder.filePath("a.df3");
    QFile file(name);
    if (!file.open(QIODevice::WriteOnly)) return nullptr;
    file.write(bytes);
    file.close();
    return readDensityFile(name.toStdString(), problem);
}

}  // namespace

class DensityTableTest : public QObject {
    Q_OBJECT

  private slots:
    void samplesOfEveryWidthAreRead() {
        std::string problem;
        const auto bytes = read(QByteArray::fromHex("000200010001"
                                                    "00ff"),
                                problem);
        QVERIFY(bytes);
        QCOMPARE(bytes->samples, (std::vector<float>{0, 1}));
        const auto words = read(QByteArray::fromHex("000200010001"
                                                    "0000"
                                                    "ffff"),
                                problem);
        QVERIFY(words);
        QCOMPARE(words->samples, (std::vector<float>{0, 1}));
        const auto longs = read(QByteArray::fromHex("000100010001"
                                                    "80000000"),
                                problem);
        QVERIFY(longs);
        QVERIFY(std::abs(longs->samples[0] - 0.5F) < 1e-6F);
    }

    void damagedFilesAreRefused() {
        for (const char* hex :
             {"", "0002", "000200010001", "000200010001ff", "000000010001ff", "000200010001ffffffffffff"}) {
            std::string problem;
            QVERIFY2(!read(QByteArray::fromHex(hex), problem), hex);
            QCOMPARE(problem, std::string("it is no DF3 file"));
        }
        std::string problem;
        QVERIFY(!readDensityFile("/no/such/file", problem));
        QCOMPARE(problem, std::string("it cannot be read"));
    }

    void valuesFillTheUnitCube() {
        auto volume = std::make_shared<DensityVolume>();
        volume->size = {2, 1, 1};
        volume->samples = {0.25F, 0.75F};
        using Interpolation = DensityTable::Interpolation;
        const DensityTable nearest(volume, Interpolation::none), linear(volume, Interpolation::linear),
            cubic(volume, Interpolation::cubic);
        QCOMPARE(nearest.value({0.1, 0.5, 0.5}), 0.25);
        QCOMPARE(nearest.value({0.6, 0.5, 0.5}), 0.75);
        QCOMPARE(linear.value({0, 0.5, 0.5}), 0.25);
        QCOMPARE(linear.value({0.25, 0.5, 0.5}), 0.5);
        QCOMPARE(linear.value({0.75, 0.5, 0.5}), 0.5);  // on the way to the first again
        QCOMPARE(cubic.value({0.5, 0.5, 0.5}), 0.75);
        for (const DensityTable* table : {&nearest, &linear, &cubic}) {
            QCOMPARE(table->value({-0.1, 0.5, 0.5}), 0.0);
            QCOMPARE(table->value({0.5, 1, 0.5}), 0.0);
            QCOMPARE(table->value({0.5, 0.5, NAN}), 0.0);
        }
    }
};

QTEST_APPLESS_MAIN(DensityTableTest)
#include "density_table_test.moc"
