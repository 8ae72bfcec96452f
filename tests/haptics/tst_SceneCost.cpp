// SPDX-License-Identifier: BSD-3-Clause
// Tests the cost of a scene by counting: bytes per triangle, and structures visited per tick.
#include "ResidentMemory.h"
#include "Shapes.h"
#include "TestRunner.h"
#include "Trials.h"

#include <palpate/geometry/internal/BoxHierarchyVisit.h>
#include <palpate/haptics/Palpator.h>

#include <cmath>

using namespace palpate;
using namespace palpate::test;
using haptics::HapticScene;
using haptics::HapticStructure;
using haptics::Palpator;

namespace {

constexpr double kMostBytes = 64.0; // per triangle

/// Returns 7 × 7 × 6 bumpy balls of 10 mm, 30 mm apart, with the same mesh at different positions.
std::vector<HapticStructure> crowd()
{
    const TriangleMesh ball = bumpySphere(8, 10.0, 0.05);
    std::vector<HapticStructure> structures;
    for (int i = 0; i < 294; ++i) {
        const Vec3 at = 30.0 * Vec3(i % 7, i / 7 % 7, i / 49);
        structures.push_back({"ball", indexed(transformed(ball, [&](const Vec3& p) { return Vec3(p + at); })), {}, 0});
    }
    return structures;
}

} // namespace

class SceneCost : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void aLayerIsLargeByItsOwnStructures()
    {
        const auto small = indexed(sphere(16, 10.0)), large = indexed(sphere(128, 10.0));
        const HapticScene scene(
            {{"outer", small, {}, 0}, {"inner", large, {}, 1}, {"inner too", small, {}, 1}, {"core", small, {}, 2}},
            4.0);
        QVERIFY(!scene.layer(0).isLarge);
        QVERIFY(scene.layer(1).isLarge);
        QVERIFY(!scene.layer(2).isLarge); // regardless of its surroundings
    }

    void theHapticCopyIsAsLargeAsItSays()
    {
        if (kIsSanitized) {
            QSKIP("a sanitizer keeps memory of its own");
        }
        const geometry::RepairedMesh mesh = geometry::repair(sphere(128, 50.0));
        const auto triangles = static_cast<double>(mesh.mesh.triangles.size());
        // On one thread: the stacks and heaps of other threads do not belong to the copy, nor do remains of a first
        // build.
        (void)geometry::SurfaceIndex::build(mesh, 1);
        const double before = residentBytes();
        std::vector<HapticStructure> structures(1);
        structures[0].surface = std::make_shared<geometry::SurfaceIndex>(geometry::SurfaceIndex::build(mesh, 1));
        const HapticScene scene(std::move(structures));
        const double grown = residentBytes() - before, counted = static_cast<double>(scene.byteSize());
        qInfo("%.1f bytes a triangle counted, %.1f by the process's growth", counted / triangles, grown / triangles);
        QVERIFY(counted / triangles <= kMostBytes);
        // Page granularity and overhead of the allocator.
        QVERIFY(std::abs(grown - counted) <= 0.01 * counted + (256 << 10));
    }

    void structuresThatAreNotNearAreNotLookedAt()
    {
        const HapticScene scene(crowd());
        const haptics::HapticLayer& layer = scene.layer(0);
        const Vec3 centre = 30.0 * Vec3(3, 3, 3);
        std::size_t most = 0;
        for (int i = 0; i < 500; ++i) {
            const double a = 0.05 * i;
            const Vec3 p = centre + 9.0 * Vec3(std::cos(a), std::sin(a) * std::cos(0.3 * a), std::sin(a)).normalized();
            std::size_t found = 0;
            layer.hierarchy.visitSegment(p, p + Vec3(0.5, 0.3, 0.2), [&](std::uint32_t, std::uint32_t count) {
                found += count;
                return 1.0;
            });
            most = std::max(most, found);
        }
        // One or two leaves of the hierarchy, of 294 structures.
        QVERIFY2(most >= 1 && most <= 2 * geometry::BoxHierarchy::kLeafSize, qPrintable(QString::number(most)));
    }

    void aCrowdChangesNothingThatIsFelt()
    {
        std::vector<HapticStructure> all = crowd();
        const HapticScene one({all[171]}), crowded(std::move(all));
        const Vec3 centre = 30.0 * Vec3(171 % 7, 171 / 7 % 7, 171 / 49);
        Palpator alone, among;
        alone.borrowScene(&one);
        among.borrowScene(&crowded);
        for (int i = 0; i < 2000; ++i) {
            const double a = 0.003 * i, r = std::max(8.5, 14.0 - 0.02 * i);
            const Vec3 hip = centre + r * Vec3(std::cos(a), std::sin(0.7 * a), std::sin(a)).normalized();
            const haptics::TickResult x = alone.step(hip, 1e-3), y = among.step(hip, 1e-3);
            QVERIFY((x.p_WG - y.p_WG).norm() <= 1e-12);
            QCOMPARE(x.iterations, y.iterations); // the work is equal too
        }
    }
};

PALPATE_TEST(SceneCost)
#include "tst_SceneCost.moc"
