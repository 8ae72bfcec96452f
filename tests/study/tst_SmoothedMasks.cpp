// SPDX-License-Identifier: BSD-3-Clause
#include "Masks.h"
#include "TestRunner.h"

#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/MotionFile.h>
#include <palpate/session/Replay.h>
#include <palpate/study/HapticCopy.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace palpate;
using core::Vec3;

namespace {

constexpr double kRadius_mm = 30.0, kDepth_mm = 5.0, kStiffness_N_per_mm = 0.5;

/// Deviations of the contact from that of an exact ball.
struct Deviation
{
    std::size_t ticks = 0;
    double force = 0.0; ///< largest, relative to the true force
    double direction_deg = 0.0;
    double longest_mm = 0.0; ///< length of the spring
};

/// Returns a scene with one surface, smoothed or not.
meshio::LoadedScene sceneOf(const geometry::TriangleMesh& mesh, meshio::SurfaceKind surface)
{
    meshio::LoadedScene scene;
    meshio::LoadedStructure& one = scene.structures.emplace_back();
    one.description.name = "ball";
    one.description.surface = surface;
    one.description.tissue.stiffness_N_per_mm = kStiffness_N_per_mm;
    one.asRead = std::make_shared<const geometry::RepairedMesh>(geometry::repair(mesh));
    one.surface = meshio::shapeSurface(one.asRead, one.description).surface;
    scene.scene.structures.push_back(one.description);
    return scene;
}

void feel(const haptics::HapticScene& scene, const session::Motion& motion, const Vec3& centre_mm, Deviation& out)
{
    session::replay(scene, motion, [&](const servo::TickRecord& tick) {
        const Vec3 out_mm = tick.p_WH - centre_mm;
        const double depth_mm = kRadius_mm - out_mm.norm();
        if (depth_mm < kDepth_mm - 1e-3) {
            return true; // during the approach
        }
        const Vec3& f = tick.felt.f_W;
        const double true_N = kStiffness_N_per_mm * depth_mm;
        ++out.ticks;
        out.force = std::max(out.force, std::abs(f.norm() - true_N) / true_N);
        const double cosine = f.norm() > 0.0 ? std::clamp(f.normalized().dot(out_mm.normalized()), -1.0, 1.0) : -1.0;
        out.direction_deg = std::max(out.direction_deg, std::acos(cosine) * 180.0 / std::numbers::pi);
        out.longest_mm = std::max(out.longest_mm, f.norm() / kStiffness_N_per_mm);
        return true;
    });
}

/// Returns a motion in from above, then along a meridian to equally near the other pole.
session::Motion meridian(double azimuth_rad, const Vec3& centre_mm)
{
    constexpr double kFromPole_rad = 18.0 * std::numbers::pi / 180.0;
    const auto at = [&](double polar_rad, double radius_mm) {
        return Vec3(centre_mm + radius_mm * Vec3(std::sin(polar_rad) * std::cos(azimuth_rad),
                                                 std::sin(polar_rad) * std::sin(azimuth_rad), std::cos(polar_rad)));
    };
    session::Motion motion;
    for (double radius_mm = kRadius_mm + 4.0; radius_mm > kRadius_mm - kDepth_mm; radius_mm -= 0.05) {
        motion.p_WH.push_back(at(kFromPole_rad, radius_mm));
    }
    for (double polar_rad = kFromPole_rad; polar_rad < std::numbers::pi - kFromPole_rad; polar_rad += 0.004) {
        motion.p_WH.push_back(at(polar_rad, kRadius_mm - kDepth_mm));
    }
    return motion;
}

} // namespace

/// The bounds after smoothing: ripple at most 10 % of the force, direction within 25°, no spring longer than twice the
/// depth.
class SmoothedMasks : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void feelsAsTheTrueBall_data()
    {
        QTest::addColumn<double>("inPlane_mm");
        QTest::addColumn<double>("slice_mm");
        QTest::newRow("1 x 1 x 3") << 1.0 << 3.0;
        QTest::newRow("0.8 x 0.8 x 2.5") << 0.8 << 2.5;
        QTest::newRow("1 x 1 x 1") << 1.0 << 1.0;
    }
    void feelsAsTheTrueBall()
    {
        QFETCH(double, inPlane_mm);
        QFETCH(double, slice_mm);
        const Vec3 voxel_mm(inPlane_mm, inPlane_mm, slice_mm);
        const test::Mask mask = test::ballMask(kRadius_mm, voxel_mm);
        const Vec3 centre_mm = test::ballCentre_mm(voxel_mm);
        const geometry::TriangleMesh mesh = test::maskSurface(mask);
        Deviation stepped, smooth;
        const auto asItIs = study::hapticScene(sceneOf(mesh, meshio::SurfaceKind::Facets));
        const auto smoothed = study::hapticScene(sceneOf(mesh, meshio::SurfaceKind::Smoothed));
        for (int i = 0; i < 5; ++i) {
            const session::Motion motion = meridian(0.3 + 1.3 * i, centre_mm);
            feel(*asItIs, motion, centre_mm, stepped);
            feel(*smoothed, motion, centre_mm, smooth);
        }
        qInfo("as it is: force off by %.0f %%, %.0f degrees, spring %.1f mm; smoothed: %.1f %%, %.1f degrees, %.2f mm",
              100.0 * stepped.force, stepped.direction_deg, stepped.longest_mm, 100.0 * smooth.force,
              smooth.direction_deg, smooth.longest_mm);
        QVERIFY(smooth.ticks > 3000);
        QVERIFY(stepped.force > 0.3); // otherwise there would be nothing to smooth
        QVERIFY(smooth.force <= 0.10);
        QVERIFY(smooth.direction_deg <= 25.0);
        QVERIFY(smooth.longest_mm <= 2.0 * kDepth_mm);
    }

    void feelsAsTheTrueBallOnTheReportedMask_data()
    {
        QTest::addColumn<double>("smoothing");
        QTest::newRow("mesh") << meshio::kDefaultSmoothing;
        QTest::newRow("label map") << meshio::kLabelSmoothing;
    }
    void feelsAsTheTrueBallOnTheReportedMask()
    {
        QFETCH(double, smoothing);
        PALPATE_SHARED_OR_SKIP(shared, "reports/haptics");
        const auto motion = session::readMotion(shared / "2-meridian.csv");
        meshio::ReadOptions smoothed;
        smoothed.isSmoothed = true;
        smoothed.smoothing = smoothing;
        auto scene = meshio::loadScene(shared / "2-stairs-1x1x3.ply", smoothed);
        QVERIFY(motion.isOk() && scene.isOk());
        QVERIFY(scene.value().structures.front().staircase.has_value());
        scene.value().structures.front().description.tissue.stiffness_N_per_mm = kStiffness_N_per_mm;
        Deviation found;
        feel(*study::hapticScene(scene.value()), motion.value(), Vec3::Zero(), found);
        QVERIFY(found.ticks > 500);
        QVERIFY2(found.force <= 0.10 && found.direction_deg <= 25.0 && found.longest_mm <= 2.0 * kDepth_mm,
                 qPrintable(QString::number(found.force)));
    }

    void realAnatomyIsNoStaircase()
    {
        PALPATE_SHARED_OR_SKIP(shared, "anatomy");
        std::size_t surfaces = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(shared)) {
            const auto loaded = entry.is_regular_file() ? meshio::loadScene(entry.path())
                                                        : core::Result<meshio::LoadedScene>(core::Status(
                                                              core::StatusCode::NotFound, PALPATE_TEXT("a folder")));
            if (!loaded.isOk()) {
                continue;
            }
            for (const meshio::LoadedStructure& one : loaded.value().structures) {
                QVERIFY2(!one.staircase, one.description.name.c_str());
                ++surfaces;
            }
        }
        QVERIFY(surfaces > 20);
    }
};

PALPATE_TEST(SmoothedMasks)
#include "tst_SmoothedMasks.moc"
