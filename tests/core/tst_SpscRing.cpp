// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/core/SpscRing.h>

#include <barrier>
#include <cstdint>
#include <thread>

namespace {

struct Item
{
    std::uint64_t number = 0;
    std::uint64_t copies[6] = {};
};

Item itemOf(std::uint64_t number)
{
    Item item;
    item.number = number;
    for (std::uint64_t& copy : item.copies) {
        copy = ~number;
    }
    return item;
}

bool isWhole(const Item& item)
{
    for (const std::uint64_t copy : item.copies) {
        if (copy != ~item.number) {
            return false;
        }
    }
    return true;
}

} // namespace

class SpscRing : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void roundsCapacityUpToAPowerOfTwo_data()
    {
        QTest::addColumn<quint64>("asked");
        QTest::addColumn<quint64>("given");
        QTest::newRow("none") << quint64{0} << quint64{2};
        QTest::newRow("one") << quint64{1} << quint64{2};
        QTest::newRow("two") << quint64{2} << quint64{2};
        QTest::newRow("three") << quint64{3} << quint64{4};
        QTest::newRow("thousand") << quint64{1000} << quint64{1024};
    }
    void roundsCapacityUpToAPowerOfTwo()
    {
        QFETCH(quint64, asked);
        QTEST(quint64{palpate::core::SpscRing<int>(asked).capacity()}, "given");
    }

    void givesNothingWhenEmpty()
    {
        palpate::core::SpscRing<int> ring(4);
        int value = 7;
        QVERIFY(!ring.pop(value));
        QCOMPARE(value, 7);
    }

    void keepsOrderAcrossManyWraps()
    {
        palpate::core::SpscRing<int> ring(4);
        int expected = 0;
        for (int pushed = 0; pushed < 1000;) {
            for (int i = 0; i < 1 + pushed % 4; ++i) {
                QVERIFY(ring.push(pushed++));
            }
            int value = -1;
            while (ring.pop(value)) {
                QCOMPARE(value, expected++);
            }
            QCOMPARE(expected, pushed);
        }
        QCOMPARE(ring.dropped(), std::uint64_t{0});
    }

    void dropsTheNewestWhenFullAndCounts()
    {
        palpate::core::SpscRing<int> ring(4);
        for (int i = 0; i < 7; ++i) {
            QCOMPARE(ring.push(i), i < 4);
        }
        QCOMPARE(ring.dropped(), std::uint64_t{3});
        int value = -1;
        for (int i = 0; i < 4; ++i) {
            QVERIFY(ring.pop(value));
            QCOMPARE(value, i);
        }
        QVERIFY(!ring.pop(value));
        QVERIFY(ring.push(7));
        QVERIFY(ring.pop(value));
        QCOMPARE(value, 7);
    }

    void losesAndTearsNothingBetweenTwoThreads()
    {
        constexpr std::uint64_t kItems = 300'000;
        palpate::core::SpscRing<Item> ring(64);
        std::barrier start(2);
        std::thread producer([&] {
            start.arrive_and_wait();
            for (std::uint64_t i = 0; i < kItems;) {
                if (ring.push(itemOf(i))) {
                    ++i;
                } else {
                    std::this_thread::yield();
                }
            }
        });
        start.arrive_and_wait();
        std::uint64_t wrong = 0;
        for (std::uint64_t i = 0; i < kItems;) {
            Item item;
            if (ring.pop(item)) {
                wrong += item.number != i || !isWhole(item) ? 1 : 0;
                ++i;
            } else {
                std::this_thread::yield();
            }
        }
        producer.join();
        QCOMPARE(wrong, std::uint64_t{0});
    }

    void countsExactlyWhatAProducerThatNeverWaitsLoses()
    {
        constexpr std::uint64_t kItems = 300'000;
        palpate::core::SpscRing<Item> ring(16);
        std::barrier start(2);
        std::atomic<bool> isDone{false};
        std::thread producer([&] {
            start.arrive_and_wait();
            for (std::uint64_t i = 0; i < kItems; ++i) {
                ring.push(itemOf(i));
            }
            isDone.store(true, std::memory_order_release);
        });
        start.arrive_and_wait();
        std::uint64_t taken = 0;
        std::uint64_t wrong = 0;
        std::uint64_t next = 0;
        for (bool last = false;;) {
            last = isDone.load(std::memory_order_acquire);
            Item item;
            while (ring.pop(item)) {
                wrong += item.number < next || !isWhole(item) ? 1 : 0;
                next = item.number + 1;
                ++taken;
            }
            if (last) {
                break;
            }
        }
        producer.join();
        QCOMPARE(wrong, std::uint64_t{0});
        QCOMPARE(taken + ring.dropped(), kItems);
    }
};

PALPATE_TEST(SpscRing)
#include "tst_SpscRing.moc"
