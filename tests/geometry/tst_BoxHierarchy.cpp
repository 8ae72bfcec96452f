// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <BoxHierarchyPairs.h>

#include <palpate/geometry/internal/BoxHierarchySwept.h>
#include <palpate/geometry/internal/BoxHierarchyVisit.h>

#include <random>
#include <set>

using namespace palpate;
using core::Box;
using core::Vec3;
using geometry::BoxedItem;
using geometry::BoxHierarchy;
using geometry::FloatBox;

class BoxHierarchyTest : public QObject
{
    Q_OBJECT

    struct Scene
    {
        std::vector<Box> boxes;
        BoxHierarchy hierarchy;
        std::vector<std::uint32_t> items; ///< item numbers in leaf order
    };

    static Scene randomScene(std::size_t n, double offset, double size, unsigned threads, unsigned seed)
    {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        Scene scene;
        const Vec3 origin = Vec3::Constant(offset);
        std::vector<BoxedItem> items;
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3 low = origin + 100.0 * Vec3(unit(random), unit(random), unit(random));
            scene.boxes.emplace_back(low, low + size * Vec3(unit(random), unit(random), unit(random)));
            items.emplace_back(FloatBox::around(scene.boxes.back(), origin), static_cast<std::uint32_t>(i));
        }
        scene.hierarchy = BoxHierarchy::build(items, origin, threads);
        for (const BoxedItem& item : items) {
            scene.items.push_back(item.number);
        }
        return scene;
    }

    static bool segmentTouches(const Box& box, const Vec3& from, const Vec3& to)
    {
        double enter = 0.0, leave = 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double d = to[axis] - from[axis];
            if (d == 0.0) {
                if (from[axis] < box.min()[axis] || from[axis] > box.max()[axis]) {
                    return false;
                }
                continue;
            }
            const double t0 = (box.min()[axis] - from[axis]) / d, t1 = (box.max()[axis] - from[axis]) / d;
            enter = std::max(enter, std::min(t0, t1));
            leave = std::min(leave, std::max(t0, t1));
        }
        return enter <= leave;
    }

  private Q_SLOTS:
    void everyQueryFindsWhatBruteForceFinds_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("offset");
        QTest::addColumn<double>("size");
        for (const int count : {0, 1, 4, 5, 17, 3000}) {
            QTest::addRow("%d boxes", count) << count << 0.0 << 5.0;
        }
        QTest::newRow("a million mm away") << 3000 << 1e6 << 5.0;
        QTest::newRow("flat boxes") << 3000 << -1e6 << 0.0;
    }
    void everyQueryFindsWhatBruteForceFinds()
    {
        QFETCH(int, count);
        QFETCH(double, offset);
        QFETCH(double, size);
        const Scene scene = randomScene(static_cast<std::size_t>(count), offset, size, 2, 1);
        std::mt19937 random(2);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        const auto point = [&] {
            return Vec3(Vec3::Constant(offset) + 100.0 * Vec3(unit(random), unit(random), unit(random)));
        };
        std::size_t found = 0;
        for (int round = 0; round < 300; ++round) {
            const Vec3 from = point();
            Vec3 to = round % 3 == 0 ? point() : Vec3(from + Vec3(unit(random), unit(random), unit(random)));
            if (round % 5 == 0) {
                to.y() = from.y(); // parallel to an axis plane
                to.z() = from.z();
            }
            const Box query(from.cwiseMin(to), from.cwiseMax(to));
            std::set<std::uint32_t> inBox, onSegment;
            scene.hierarchy.visitBox(query, [&](std::uint32_t first, std::uint32_t n) {
                for (std::uint32_t i = first; i < first + n; ++i) {
                    inBox.insert(scene.items[i]);
                }
                return true;
            });
            scene.hierarchy.visitSegment(from, to, [&](std::uint32_t first, std::uint32_t n) {
                for (std::uint32_t i = first; i < first + n; ++i) {
                    onSegment.insert(scene.items[i]);
                }
                return 1.0;
            });
            for (std::uint32_t i = 0; i < scene.boxes.size(); ++i) {
                if (query.intersects(scene.boxes[i])) {
                    QVERIFY(inBox.count(i) == 1);
                }
                if (segmentTouches(scene.boxes[i], from, to)) {
                    QVERIFY(onSegment.count(i) == 1);
                    ++found;
                }
            }
        }
        QVERIFY(count < 3000 || size == 0.0 || found > 100);
    }

    /// No facet is omitted that a ball touches at the start of a move and that faces the move at the given cosine.
    void aBallFindsWhatStandsAgainstIt()
    {
        for (const double offset : {0.0, -1e4}) {
            const Scene scene = randomScene(3000, offset, 5.0, 2, 1);
            std::mt19937 random(3);
            std::uniform_real_distribution<double> unit(0.0, 1.0);
            const auto point = [&] { return Vec3(unit(random), unit(random), unit(random)); };
            std::size_t standing = 0, visited = 0, all = 0;
            for (int round = 0; round < 300; ++round) {
                const Vec3 from = Vec3::Constant(offset) + 100.0 * point();
                const Vec3 u = (point() - Vec3::Constant(0.5)).normalized();
                const double reach = 20.0 * unit(random), cosine = unit(random);
                const auto visit = [&](geometry::SweptPruning interest) {
                    std::set<std::uint32_t> seen;
                    std::uint32_t nodes = 100000;
                    (void)scene.hierarchy.visitSwept(from, Vec3(from + u), reach, interest, nodes,
                                                     [&](std::uint32_t first, std::uint32_t n) {
                                                         for (std::uint32_t i = first; i < first + n; ++i) {
                                                             seen.insert(scene.items[i]);
                                                         }
                                                         return interest;
                                                     });
                    return seen;
                };
                const std::set<std::uint32_t> seen = visit({0.0, cosine});
                visited += seen.size();
                all += visit({0.0, 0.0}).size();
                for (std::uint32_t i = 0; i < scene.boxes.size(); ++i) {
                    for (int k = 0; k < 8; ++k) { // points in the box
                        const Vec3 at = scene.boxes[i].min() + point().cwiseProduct(scene.boxes[i].sizes());
                        const double distance = (at - from).norm();
                        if (distance <= reach && u.dot(at - from) >= cosine * distance) {
                            ++standing;
                            QVERIFY(seen.count(i) == 1);
                        }
                    }
                }
            }
            QVERIFY(standing > 1000);
            // the query does omit items
            QVERIFY2(4 * visited < 3 * all, qPrintable(QString("%1 of %2").arg(visited).arg(all)));
        }
    }

    void pairsOfLeavesMeetOnce_data()
    {
        QTest::addColumn<int>("items");
        QTest::addColumn<unsigned>("threads");
        QTest::newRow("one leaf") << 3 << 1u;
        QTest::newRow("few") << 40 << 1u;
        QTest::newRow("some") << 3000 << 1u;
        QTest::newRow("some, two threads") << 3000 << 2u;
        QTest::newRow("one leaf, two threads") << 3 << 2u;
        QTest::newRow("some, three threads") << 3000 << 3u;
        QTest::newRow("some, eight threads") << 3000 << 8u;
    }
    void pairsOfLeavesMeetOnce()
    {
        QFETCH(int, items);
        QFETCH(unsigned, threads);
        const double around = 0.5;
        const Scene scene = randomScene(static_cast<std::size_t>(items), 0.0, 4.0, threads, 9);
        std::vector<std::vector<std::array<std::uint32_t, 2>>> met(threads); // per thread
        scene.hierarchy.visitPairs(
            around, threads, [&](unsigned thread, std::uint32_t f, std::uint32_t n, std::uint32_t g, std::uint32_t m) {
                for (std::uint32_t i = f; i < f + n; ++i) {
                    for (std::uint32_t j = f == g ? i + 1 : g; j < g + m; ++j) {
                        met[thread].push_back({std::min(i, j), std::max(i, j)});
                    }
                }
                return true;
            });
        std::set<std::array<std::uint32_t, 2>> pairs;
        for (const auto& part : met) {
            for (const auto& pair : part) {
                QVERIFY(pairs.insert(pair).second);
            }
        }
        std::size_t near = 0;
        for (std::uint32_t i = 0; i < scene.items.size(); ++i) {
            for (std::uint32_t j = i + 1; j < scene.items.size(); ++j) {
                const Box &a = scene.boxes[scene.items[i]], &b = scene.boxes[scene.items[j]];
                const Box grown(a.min().array() - around, a.max().array() + around);
                if (grown.intersects(b)) {
                    QVERIFY(pairs.count({i, j}) == 1);
                    ++near;
                }
            }
        }
        QVERIFY(items < 100 || (near > 100 && pairs.size() < 100 * near));
        std::vector<int> calls(threads);
        scene.hierarchy.visitPairs(around, threads,
                                   [&calls](unsigned thread, std::uint32_t, std::uint32_t, std::uint32_t,
                                            std::uint32_t) { return ++calls[thread] < 5; });
        QVERIFY(*std::max_element(calls.begin(), calls.end()) <= 5);
    }

    void leavesOutWhatLiesBeyondTheShareOfInterest()
    {
        const Scene scene = randomScene(5000, 0.0, 1.0, 1, 3);
        int all = 0, near = 0;
        const Vec3 from(0, 0, 0), to(100, 100, 100);
        scene.hierarchy.visitSegment(from, to, [&](std::uint32_t, std::uint32_t) { return ++all, 1.0; });
        scene.hierarchy.visitSegment(from, to, [&](std::uint32_t, std::uint32_t) { return ++near, 0.05; });
        QVERIFY(near > 0);
        QVERIFY2(near * 3 < all, qPrintable(QString("%1 of %2").arg(near).arg(all)));
    }

    void doesNotDependOnTheNumberOfThreads()
    {
        const Scene one = randomScene(50000, 0.0, 0.5, 1, 4);
        const auto visited = [](const Scene& scene, double size) {
            std::vector<std::uint32_t> leaves;
            scene.hierarchy.visitBox(Box(Vec3::Constant(50.0 - size), Vec3::Constant(50.0 + size)),
                                     [&](std::uint32_t first, std::uint32_t n) {
                                         leaves.insert(leaves.end(), {first, n});
                                         return true;
                                     });
            return leaves;
        };
        for (const unsigned threads : {2u, 3u, 8u}) {
            const Scene several = randomScene(50000, 0.0, 0.5, threads, 4);
            QCOMPARE(one.items, several.items);
            QCOMPARE(one.hierarchy.nodeCount(), several.hierarchy.nodeCount());
            for (const double size : {1.0, 10.0, 60.0}) {
                QCOMPARE(visited(one, size), visited(several, size));
            }
        }
        QVERIFY(visited(one, 60.0).size() > 2 * 50000 / 4);
    }

    void oneFarAwayFromManyIsFound()
    {
        for (const unsigned threads : {1u, 2u, 8u}) {
            Scene scene;
            std::vector<BoxedItem> items;
            for (std::uint32_t i = 0; i < 30'000; ++i) {
                const Vec3 low(i % 30, i / 30 % 30, i / 900 % 30);
                scene.boxes.emplace_back(low, low + Vec3::Ones());
            }
            scene.boxes.emplace_back(Vec3::Constant(1e6), Vec3::Constant(1e6 + 1.0));
            for (std::uint32_t i = 0; i < scene.boxes.size(); ++i) {
                items.emplace_back(FloatBox::around(scene.boxes[i], Vec3::Zero()), i);
            }
            scene.hierarchy = BoxHierarchy::build(items, Vec3::Zero(), threads);
            const auto countIn = [&](const Box& box) {
                std::size_t seen = 0;
                scene.hierarchy.visitBox(box, [&](std::uint32_t, std::uint32_t n) { return seen += n, true; });
                return seen;
            };
            QCOMPARE(countIn(Box(Vec3::Constant(-1e7), Vec3::Constant(1e7))), items.size());
            QVERIFY(countIn(scene.boxes.back()) >= 1);
            std::set<std::uint32_t> met;
            scene.hierarchy.visitSegment(Vec3::Constant(1e6 - 10.0), Vec3::Constant(1e6 + 10.0),
                                         [&](std::uint32_t first, std::uint32_t n) {
                                             for (std::uint32_t i = first; i < first + n; ++i) {
                                                 met.insert(items[i].number);
                                             }
                                             return 1.0;
                                         });
            QVERIFY(met.count(30'000) == 1 && met.size() <= BoxHierarchy::kLeafSize);
        }
    }

    void keepsEveryItemOnceEvenWhenAllAreEqual()
    {
        std::vector<BoxedItem> items;
        for (std::uint32_t i = 0; i < 1000; ++i) {
            items.emplace_back(FloatBox{{0, 0, 0}, {1, 1, 1}}, i);
        }
        const BoxHierarchy hierarchy = BoxHierarchy::build(items, Vec3::Zero(), 2);
        std::set<std::uint32_t> numbers;
        for (const BoxedItem& item : items) {
            numbers.insert(item.number);
        }
        QCOMPARE(numbers.size(), std::size_t{1000});
        std::size_t seen = 0;
        hierarchy.visitBox(Box(Vec3::Zero(), Vec3::Ones()),
                           [&](std::uint32_t, std::uint32_t n) { return seen += n, true; });
        QCOMPARE(seen, std::size_t{1000});
    }
};

PALPATE_TEST_NAMED("BoxHierarchy", BoxHierarchyTest)
#include "tst_BoxHierarchy.moc"
