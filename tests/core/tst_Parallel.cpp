// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/core/Parallel.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace palpate;

class Parallel : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void eachIsDoneOnce()
    {
        for (const unsigned threads : {0U, 1U, 2U, 3U, 8U, 100U}) {
            for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
                std::vector<std::atomic<int>> calls(count);
                core::parallelFor(
                    count, [&](std::size_t i, unsigned) { ++calls[i]; }, threads);
                for (const std::atomic<int>& n : calls) {
                    QCOMPARE(n.load(), 1);
                }
                std::vector<int> done(count);
                core::parallelForBlocks(
                    count, 16, [&](std::size_t i) { ++done[i]; }, threads);
                QCOMPARE(done, std::vector<int>(count, 1));
            }
        }
    }

    void asManyRunAtOnceAsThereAreThreads()
    {
        // Each thread waits for all others: with fewer threads this would never end.
        constexpr unsigned kThreads = 5;
        std::mutex mutex;
        std::condition_variable arrived;
        std::set<std::thread::id> ids;
        std::set<unsigned> numbers;
        core::parallelFor(
            kThreads,
            [&](std::size_t, unsigned thread) {
                std::unique_lock lock(mutex);
                ids.insert(std::this_thread::get_id());
                numbers.insert(thread);
                arrived.notify_all();
                arrived.wait(lock, [&] { return ids.size() == kThreads; });
            },
            kThreads);
        QCOMPARE(numbers, (std::set<unsigned>{0, 1, 2, 3, 4}));
        QVERIFY(ids.count(std::this_thread::get_id()) == 1);
    }

    void theCallerIsThreadZero()
    {
        const std::thread::id caller = std::this_thread::get_id();
        std::atomic<bool> isRight = true;
        core::parallelFor(
            1000,
            [&](std::size_t, unsigned thread) {
                if ((thread == 0) != (std::this_thread::get_id() == caller) || thread >= 3) {
                    isRight = false;
                }
            },
            3);
        QVERIFY(isRight);
        // At most one thread per item: a single call stays in this thread for any limit.
        core::parallelFor(
            1, [&](std::size_t, unsigned) { isRight = isRight && std::this_thread::get_id() == caller; }, 8);
        QVERIFY(isRight);
        QVERIFY(core::coreCount() >= 1);
    }

    void aFailureEndsAllAndIsThrownHere()
    {
        for (const unsigned threads : {1U, 3U}) {
            std::atomic<int> calls = 0;
            const auto work = [&](std::size_t i, unsigned) {
                ++calls;
                if (i == 3) {
                    throw std::runtime_error("the fourth");
                }
            };
            QVERIFY_THROWS_EXCEPTION(std::runtime_error, core::parallelFor(1'000'000, work, threads));
            QVERIFY2(calls < 1'000'000, qPrintable(QString::number(calls)));
        }
    }
};

static const bool registered =
    palpate::test::registerTest("Parallel", []() -> std::unique_ptr<QObject> { return std::make_unique<Parallel>(); });
#include "tst_Parallel.moc"
