// SPDX-License-Identifier: BSD-3-Clause
// A liver of a person breathes by 15 mm, and is pressed and slid over for 60 s through the safety gate.
#include "TestRunner.h"

#include <palpate/device/DevicePresets.h>
#include <palpate/geometry/Inside.h>
#include <palpate/geometry/SurfaceMotion.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/servo/ServoCore.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

using namespace palpate;
using core::Vec3;

namespace {

struct Place
{
    Vec3 p, n; ///< on the surface, outward unit normal
};

/// The vertex whose normal agrees best with those of all vertices within a distance.
Place flattest(const geometry::TriangleMesh& mesh, double within_mm)
{
    std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
    for (const geometry::Triangle& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[t[0]];
        const Vec3 n = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
        for (const std::uint32_t corner : t) {
            normals[corner] += n;
        }
    }
    Place best;
    double most = -2.0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const Vec3 n = normals[i].normalized();
        double least = 1.0;
        for (std::size_t j = 0; j < normals.size(); ++j) {
            if ((mesh.vertices[j] - mesh.vertices[i]).norm() < within_mm) {
                least = std::min(least, n.dot(normals[j].normalized()));
            }
        }
        if (least > most) {
            most = least;
            best = {mesh.vertices[i], n};
        }
    }
    return best;
}

} // namespace

class BreathingLiver : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void isPressedForAMinuteWithoutAFault()
    {
        PALPATE_SHARED_OR_SKIP(anatomy, "anatomy");
        meshio::ReadOptions options;
        options.unit_mm = 31.3; // 200 mm from left to right
        const auto loaded = meshio::loadScene(anatomy / "liver-smooth.obj", options);
        QVERIFY2(loaded.isOk(), loaded.status().message().c_str());
        const geometry::RepairedMesh& liver = *loaded.value().structures.front().surface;
        const core::Box& box = liver.report.bounds;
        geometry::Breath breath;
        breath.amplitude_mm = Vec3(0.0, -3.0, -15.0);
        breath.still_W = box.center() - 0.5 * box.sizes().z() * Vec3::UnitZ();
        breath.full_W = box.center() + 0.5 * box.sizes().z() * Vec3::UnitZ();
        haptics::HapticStructure structure;
        structure.name = "liver";
        structure.surface = std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(liver));
        structure.tissue.stiffness_N_per_mm = 0.3;
        structure.tissue.friction_static = 0.2;
        structure.tissue.friction_dynamic = 0.15;
        const auto motion = geometry::SurfaceMotion::breath(breath, box);
        QVERIFY2(motion.isOk(), motion.status().message().c_str());
        structure.motion = motion.value();
        const haptics::HapticScene scene({structure});

        device::DeviceInfo info = device::deviceInfo(*device::findDevicePreset("omega"));
        info.workspaceRadius_mm = 0.0;
        servo::ServoCore core(servo::GateLimits::forDevice(info), 1000.0, servo::PassivityLimits::forDevice(info));
        core.borrowScene(&scene, 1);
        // Along a figure of eight of 30 x 24 mm over the flattest place of the liver, and 8 mm into it.
        const Place at = flattest(liver.mesh, 25.0);
        const Vec3 u = at.n.unitOrthogonal(), v = at.n.cross(u);
        int contacts = 0, passes = 0;
        double deepest_mm = 0.0, most_N = 0.0;
        for (std::int64_t i = 0; i < 60'000; ++i) {
            const double t = 1e-3 * static_cast<double>(i);
            device::DeviceState hand;
            hand.isPresent = true;
            hand.time_ns = 1'000'000 * i;
            const bool follows = i < 40'000; // then the hand rests, and the tissue comes and goes below it
            const Vec3 below = follows ? structure.motion->toWorld(structure.motion->at(t), at.p) : at.p;
            hand.p_D = below + 15.0 * std::sin(0.9 * t) * u + 12.0 * std::sin(1.8 * t) * v +
                       (6.0 - 14.0 * std::min(1.0, t)) * at.n;
            const servo::TickRecord tick = core.tick(hand, hand.time_ns);
            const bool isTouched = tick.felt.structure >= 0;
            contacts += isTouched ? 1 : 0;
            // A surface that had passed the god-object would leave the hand inside without contact.
            const auto rest = structure.motion->toRest(structure.motion->at(t), tick.p_WH, tick.p_WH);
            passes += !isTouched && geometry::isInside(*structure.surface, rest.X) ? 1 : 0;
            deepest_mm = std::max(deepest_mm, (tick.felt.p_WG - tick.p_WH).norm());
            most_N = std::max(most_N, tick.felt.f_W.norm());
            QVERIFY2(core.fault().kind == servo::FaultKind::None, qPrintable(QString("tick %1").arg(i)));
            QVERIFY((tick.flags & servo::kIterationLimit) == 0);
        }
        qInfo("%d ticks in contact, %.1f mm deep, %.2f N", contacts, deepest_mm, most_N);
        QCOMPARE(passes, 0);
        QVERIFY(contacts > 30'000); // most of the time
        QVERIFY(deepest_mm > 8.0 && most_N > 2.0);
    }
};

PALPATE_TEST(BreathingLiver)
#include "tst_BreathingLiver.moc"
