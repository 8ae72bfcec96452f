// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/core/TripleBuffer.h>

#include <array>
#include <atomic>
#include <barrier>
#include <cstdint>
#include <thread>

class TripleBuffer : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void givesTheInitialValueBeforeTheFirstWrite()
    {
        palpate::core::TripleBuffer<int> buffer(5);
        QVERIFY(!buffer.fetch());
        QCOMPARE(buffer.value(), 5);
    }

    void givesTheNewestOfSeveralWritesOnce()
    {
        palpate::core::TripleBuffer<int> buffer;
        for (int i = 1; i <= 10; ++i) {
            buffer.write(i);
        }
        QVERIFY(buffer.fetch());
        QCOMPARE(buffer.value(), 10);
        QVERIFY(!buffer.fetch());
        QCOMPARE(buffer.value(), 10);
    }

    void neverShowsWhatWasNotFetched()
    {
        palpate::core::TripleBuffer<int> buffer;
        buffer.write(1);
        QVERIFY(buffer.fetch());
        for (int i = 2; i < 9; ++i) {
            buffer.write(i);
            QCOMPARE(buffer.value(), 1);
        }
        QVERIFY(buffer.fetch());
        QCOMPARE(buffer.value(), 8);
    }

    void tearsNothingAndNeverGoesBackBetweenTwoThreads()
    {
        using Words = std::array<std::uint64_t, 12>;
        constexpr std::uint64_t kWrites = 300'000;
        palpate::core::TripleBuffer<Words> buffer;
        std::barrier start(2);
        std::thread writer([&] {
            start.arrive_and_wait();
            for (std::uint64_t i = 1; i <= kWrites; ++i) {
                Words words;
                words.fill(i);
                buffer.write(words);
            }
        });
        start.arrive_and_wait();
        std::uint64_t torn = 0;
        std::uint64_t backwards = 0;
        std::uint64_t last = 0;
        while (last < kWrites) {
            if (!buffer.fetch()) {
                std::this_thread::yield();
                continue;
            }
            const Words& words = buffer.value();
            for (const std::uint64_t word : words) {
                torn += word != words[0] ? 1 : 0;
            }
            backwards += words[0] <= last ? 1 : 0;
            last = words[0];
        }
        writer.join();
        QCOMPARE(torn, std::uint64_t{0});
        QCOMPARE(backwards, std::uint64_t{0});
    }
};

PALPATE_TEST(TripleBuffer)
#include "tst_TripleBuffer.moc"
