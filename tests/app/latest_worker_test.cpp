// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <QTest>
#include <new>
#include <semaphore>

#include "widgets/latest_worker.h"

using namespace isoscope;

class LatestWorkerTest : public QObject {
    Q_OBJECT

  private slots:
    void onlyTheNewestOfWaitingTasksRuns() {
        LatestWorker worker;
        std::binary_semaphore begun(0), proceed(0);
        std::atomic<int> last = 0, runs = 0;
        worker.submit([&](std::stop_token) {
            begun.release();
            proceed.acquire();
            last = 1;
            ++runs;
        });
        begun.acquire();
        for (int i = 2; i <= 9; ++i)
            worker.submit([&, i](std::stop_token) {
                last = i;
                ++runs;
            });
        QVERIFY(!worker.idle());
        proceed.release();
        QTRY_VERIFY(worker.idle());
        QCOMPARE(last.load(), 9);
        QCOMPARE(runs.load(), 2);  // the running one was left to finish
    }

    void destructorStopsAndWaits() {
        std::atomic<bool> ended = false;
        std::binary_semaphore begun(0);
        {
            LatestWorker worker;
            worker.submit([&](std::stop_token stop) {
                begun.release();
                while (!stop.stop_requested()) std::this_thread::yield();
                ended = true;
            });
            begun.acquire();
        }
        QVERIFY(ended);
    }

    void waitingTaskDiesWithTheWorker() {
        std::atomic<bool> ran = false;
        std::binary_semaphore begun(0);
        {
            LatestWorker worker;
            worker.submit([&](std::stop_token stop) {
                begun.release();
                while (!stop.stop_requested()) std::this_thread::yield();
            });
            begun.acquire();
            worker.submit([&](std::stop_token) { ran = true; });
        }
        QVERIFY(!ran);
    }

    /// The program ended there, as the test of little memory shows with 400 MB.
    void refusedMemoryEndsTheTaskAlone() {
        LatestWorker worker;
        std::binary_semaphore begun(0), proceed(0);
        std::atomic<bool> ran = false;
        worker.submit([&](std::stop_token) {
            begun.release();
            proceed.acquire();
            throw std::bad_alloc();
        });
        begun.acquire();
        worker.submit([&](std::stop_token) { ran = true; });
        proceed.release();
        QTRY_VERIFY(worker.idle());
        QVERIFY(ran);
    }

    void idleBeforeTheFirstTask() { QVERIFY(LatestWorker().idle()); }
};

QTEST_APPLESS_MAIN(LatestWorkerTest)
#include "latest_worker_test.moc"
