// SPDX-License-Identifier: BSD-3-Clause
// Tests that cached facets of a layer are complete where the cache claims to be: against all facets, one by one.
#include "Shapes.h"
#include "TestRunner.h"
#include "Trials.h"
#include "nearby/BallCell.h"
#include "nearby/FacetCache.h"
#include "nearby/NearBall.h"
#include "nearby/NearPoint.h"
#include "probe/BallProbe.h"

#include <algorithm>
#include <random>
#include <set>

using namespace palpate;
using namespace palpate::haptics::internal;
using namespace palpate::test;
using haptics::HapticLayer;
using haptics::HapticScene;
using haptics::HapticStructure;

class Nearby : public QObject
{
    Q_OBJECT

    using Numbers = std::set<std::pair<std::uint32_t, std::uint32_t>>;

    static HapticScene sceneOf(const std::vector<TriangleMesh>& meshes, double radius_mm = 0.0)
    {
        std::vector<HapticStructure> structures;
        for (const TriangleMesh& mesh : meshes) {
            structures.push_back({"it", indexed(mesh), {0.5, 0.0}, 0});
        }
        return HapticScene(std::move(structures), radius_mm);
    }

    /// Calls `f(facet)` for each facet of a layer.
    template<class F>
    static void forEachFacet(const HapticLayer& layer, F&& f)
    {
        for (const std::uint32_t structure : layer.structures) {
            for (std::uint32_t i = 0; i < layer.surface(structure).triangleCount(); ++i) {
                f(Facet::of(layer.surface(structure), structure, i));
            }
        }
    }

    template<class Held>
    static Numbers numbersOf(const Held& held)
    {
        Numbers numbers;
        for (int i = 0; i < held.count(); ++i) {
            numbers.emplace(held.structure(i), held.triangle(i));
        }
        return numbers;
    }

    static core::Box boxOf(const Facet& facet)
    {
        return {facet.a.cwiseMin(facet.b).cwiseMin(facet.c), facet.a.cwiseMax(facet.b).cwiseMax(facet.c)};
    }

    static Vec3 randomIn(std::mt19937_64& random, double half_mm)
    {
        std::uniform_real_distribution<double> place(-half_mm, half_mm);
        return {place(random), place(random), place(random)};
    }

    const HapticScene m_scene = sceneOf({bumpySphere(24, 30.0, 0.05), sphere(6, 12.0)});

    static GatheringPlan planOf(const HapticLayer& layer)
    {
        return {.few = 16,
                .many = 48,
                .narrowest_mm = 0.2 * layer.facetSize_mm,
                .widest_mm = 16.0 * layer.facetSize_mm,
                .around_mm = 1e-6};
    }

  private Q_SLOTS:
    void aRegionHoldsAllThatComesNear()
    {
        const HapticLayer& layer = m_scene.layer(0);
        std::mt19937_64 random(1);
        int held = 0, tooMany = 0;
        for (int i = 0; i < trials(2000); ++i) {
            const Vec3 middle = randomIn(random, 32.0);
            const Vec3 half = randomIn(random, 5.0).cwiseAbs();
            const core::Box region(middle - half, middle + half);
            GatheredFacets facets;
            Numbers wanted;
            forEachFacet(layer, [&](const Facet& facet) {
                const core::Box box = boxOf(facet);
                if ((box.min().array() <= region.max().array() + 0.1).all() &&
                    (box.max().array() >= region.min().array() - 0.1).all()) {
                    wanted.emplace(facet.structure, facet.triangle);
                }
            });
            if (!facets.begin(layer, region, middle, 0.1)) {
                ++tooMany;
                QVERIFY(!facets.holds(middle) && facets.count() == 0);
                QVERIFY(wanted.size() > GatheredFacets::kMost / 2); // leaves contain some facets beyond the query
                continue;
            }
            QVERIFY(facets.count() == 0 || !facets.holds(middle)); // not yet
            while (!facets.isReady()) {
                facets.proceed(layer, 1 + i % 3);
            }
            QVERIFY(facets.holds(middle) && !facets.holds(middle + 2.0 * (half + Vec3::Ones())));
            const Numbers found = numbersOf(facets);
            QVERIFY(std::includes(found.begin(), found.end(), wanted.begin(), wanted.end()));
            held += wanted.empty() ? 0 : 1;
        }
        QVERIFY2(held > trials(100) && tooMany > trials(20), qPrintable(QString("%1 %2").arg(held).arg(tooMany)));
    }

    void whatIsPreparedIsWhatWouldBeGathered()
    {
        const HapticLayer& layer = m_scene.layer(0);
        FacetCache cache;
        int prepared = 0;
        for (int i = 0; i < trials(4000); ++i) {
            const double a = 0.004 * i;
            const Vec3 g = 30.0 * Vec3(std::cos(a), std::sin(a) * std::cos(0.3 * a), std::sin(a) * std::sin(0.3 * a));
            if (!cache.holds(g)) {
                if (cache.takePrepared(layer, g, g)) {
                    ++prepared;
                } else {
                    (void)cache.gather(layer, planOf(layer), g, g);
                }
            }
            if (cache.holds(g)) {
                Numbers wanted;
                forEachFacet(layer, [&](const Facet& facet) {
                    if (boxOf(facet).contains(g)) {
                        wanted.emplace(facet.structure, facet.triangle);
                    }
                });
                const Numbers found = numbersOf(cache.held());
                QVERIFY(std::includes(found.begin(), found.end(), wanted.begin(), wanted.end()));
            }
            cache.follow(g);
            cache.prepare(layer, planOf(layer), false);
        }
        QVERIFY2(prepared > trials(20), qPrintable(QString::number(prepared)));
        cache.clear();
        QVERIFY(!cache.holds(Vec3(30.0, 0.0, 0.0)));
    }

    void aSweepFindsWhatAllFacetsOneByOneWould()
    {
        const HapticLayer& layer = m_scene.layer(0);
        std::mt19937_64 random(2);
        NearPoint warm;
        int blocked = 0;
        for (int i = 0; i < trials(3000); ++i) {
            const Vec3 x = randomIn(random, 32.0), y = x + randomIn(random, i % 2 == 0 ? 0.5 : 40.0);
            double least = 2.0;
            forEachFacet(layer, [&](const Facet& facet) {
                Crossing crossing;
                if (blocks(facet, x, y, 1.0, crossing)) {
                    least = std::min(least, crossing.key);
                }
            });
            NearPoint cold;
            for (NearPoint* near : {&cold, &warm}) {
                Crossing first;
                near->beginTick(TickWork(1u << 30));
                const Sweep swept = near->sweep(layer, x, y, first);
                QCOMPARE(swept, least <= 1.0 ? Sweep::Blocked : Sweep::Free);
                if (swept == Sweep::Blocked) {
                    QCOMPARE(first.key, least);
                }
                near->endTick(layer, y);
            }
            blocked += least <= 1.0 ? 1 : 0;
        }
        QVERIFY2(blocked > trials(200), qPrintable(QString::number(blocked)));
    }

    void aCellHoldsAllThatTheBallMayTouchInIt()
    {
        const HapticScene scene = sceneOf({bumpySphere(24, 30.0, 0.05), sphere(6, 12.0)}, 4.0);
        const HapticLayer& layer = scene.layer(0);
        std::mt19937_64 random(3);
        int held = 0, full = 0;
        for (int i = 0; i < 400; i += kIsSanitized ? 4 : 1) {
            const Vec3 p = randomIn(random, 36.0);
            BallCell cell;
            const bool isHeld = cell.gather(layer, p, 0.5 + 0.01 * i);
            QVERIFY(cell.contains(p));
            QCOMPARE(cell.isFull(), !isHeld);
            if (!isHeld) {
                ++full;
                QCOMPARE(cell.count(), 0);
                continue;
            }
            const Numbers found = numbersOf(cell);
            for (int k = 0; k < 8; ++k) {
                const core::Box& region = cell.region();
                const Vec3 centre = region.center() + 0.5 * randomIn(random, 1.0).cwiseProduct(region.sizes());
                forEachFacet(layer, [&](const Facet& facet) {
                    if ((centre - nearestOn(facet, centre).q).norm() <= layer.fingertip_mm) {
                        ++held;
                        QVERIFY(found.count({facet.structure, facet.triangle}) == 1);
                    }
                });
            }
        }
        QVERIFY2(held > trials(1000) && full > trials(10), qPrintable(QString("%1 %2").arg(held).arg(full)));
    }

    void aCellIsPaidForOnceATickWhetherHeldOrNot()
    {
        const HapticScene scene = sceneOf({sphere(24, 30.0)}, 4.0);
        const HapticLayer& layer = scene.layer(0);
        const Vec3 p(34.0, 0.1, 0.1);
        BallCells cells;
        TickWork first(100000);
        cells.beginTick();
        (void)cells.at(layer, p, first);
        QVERIFY(first.left() < 100000);
        const std::uint32_t paid = first.left();
        (void)cells.at(layer, p, first);
        QCOMPARE(first.left(), paid);
        TickWork second(100000);
        cells.beginTick();
        QVERIFY(cells.paidAt(p) == nullptr);
        (void)cells.at(layer, p, second);
        QCOMPARE(second.left(), paid);
        QVERIFY(cells.paidAt(p) != nullptr);
    }

    void whatIsPreparedIsPaidForAndDecidesNothing()
    {
        const HapticScene scene = sceneOf({sphere(24, 30.0)}, 4.0);
        const HapticLayer& layer = scene.layer(0);
        const Vec3 x(34.0, 0.1, 0.1);
        BallCells cells;
        const Vec3 y = x + Vec3(0.0, 1.1 * cells.size_mm(layer), 0.0);
        TickWork both(100000);
        cells.beginTick();
        (void)cells.at(layer, x, both);
        (void)cells.at(layer, y, both);

        NearBall prepared, fresh;
        for (int tick = 0; tick < 2; ++tick) { // the second tick finds the cells in the cache
            TickWork work(100000);
            prepared.beginTick();
            prepared.prepare(layer, x, y, work);
            QCOMPARE(work.left(), both.left());
            prepared.beginTick();
            prepared.prepare(layer, x, x + 4.0 * (y - x), work); // too far for a query of cells
            QCOMPARE(work.left(), both.left());
        }
        TickWork work(100000), workOfFresh(100000);
        BallCrossing crossing, crossingOfFresh;
        prepared.beginTick();
        fresh.beginTick();
        const Sweep sweep = prepared.sweep(layer, nullptr, x, y - Vec3(1.0, 0.0, 0.0), work, crossing);
        QCOMPARE(fresh.sweep(layer, nullptr, x, y - Vec3(1.0, 0.0, 0.0), workOfFresh, crossingOfFresh), sweep);
        QCOMPARE(sweep, Sweep::Blocked);
        QCOMPARE(crossing.stop, crossingOfFresh.stop);
        QCOMPARE(crossing.facet.triangle, crossingOfFresh.facet.triangle);
        QCOMPARE(work.left(), workOfFresh.left());
    }
};

PALPATE_TEST(Nearby)
#include "tst_Nearby.moc"
