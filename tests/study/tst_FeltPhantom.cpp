// SPDX-License-Identifier: BSD-3-Clause
// Tests the phantom with its lumps transmitted through the liver: conservative, and as stable in a device as without
// lumps.
#include "TestRunner.h"

#include <palpate/evaluation/Stability.h>
#include <palpate/haptics/Palpator.h>
#include <palpate/study/BuriedLumps.h>
#include <palpate/study/HapticCopy.h>

#include <Phantom.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace palpate;
using core::Vec3;
namespace stability = evaluation::stability;

namespace {

/// Returns liver and lumps as opened, transmitted or as layers.
const meshio::LoadedScene& feltPhantom()
{
    static const meshio::LoadedScene kScene = [] {
        meshio::LoadedScene scene;
        for (const phantom::PhantomStructure& from : phantom::makePhantom()) {
            meshio::LoadedStructure& one = scene.structures.emplace_back();
            one.description.name = from.name;
            one.description.palpable = from.palpable;
            one.description.tissue.stiffness_N_per_mm = from.stiffness_N_per_mm;
            one.surface = std::make_shared<const geometry::RepairedMesh>(geometry::repair(from.mesh));
        }
        scene.scene.buried = meshio::BuriedTouch::Felt;
        (void)study::applyBuriedLumps(scene);
        return scene;
    }();
    return kScene;
}

Vec3 middle(const geometry::RepairedMesh& of)
{
    core::Box box;
    for (const Vec3& v : of.mesh.vertices) {
        box.extend(v);
    }
    return box.center();
}

/// Integrates the work of a god-object's force along straight paths by the trapezoidal rule.
class Way
{
  public:
    explicit Way(const haptics::HapticScene& scene) { m_palpator.borrowScene(&scene); }

    void to(const Vec3& p)
    {
        constexpr double kStep_mm = 0.01;
        const Vec3 from = m_isBegun ? m_at : p;
        const int steps = std::max(1, static_cast<int>(std::ceil((p - from).norm() / kStep_mm)));
        for (int i = 1; i <= steps; ++i) {
            const Vec3 next = from + (p - from) * (static_cast<double>(i) / steps);
            const haptics::TickResult felt = m_palpator.step(next, 1e-3);
            const Vec3 force = felt.f_W, across = (felt.p_WG - next).normalized();
            const Vec3 spring = felt.structure >= 0 ? Vec3(force.dot(across) * across) : Vec3(Vec3::Zero());
            if (m_isBegun) {
                const double part = 0.5 * (force + m_force).dot(next - m_at);
                work_mJ += part;
                moved_mJ += std::abs(part);
                alongNormal_mJ += 0.5 * (spring + m_spring).dot(next - m_at);
            }
            m_isBegun = true;
            m_at = next;
            m_force = force;
            m_spring = spring;
        }
    }

    double work_mJ = 0.0, moved_mJ = 0.0;
    double alongNormal_mJ = 0.0; ///< work of the force component along the contact normal

  private:
    haptics::Palpator m_palpator;
    Vec3 m_at, m_force, m_spring;
    bool m_isBegun = false;
};

} // namespace

class FeltPhantom : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    /// In over a lump, along the surface away from the lump, out, and back through the air; and the reverse. On a facet
    /// the work is zero (haptics.TissueMaps); between facets the god-object of a HIP at depth d jumps across an edge by
    /// d times the angle there. In total this is a fraction d / R of the map's variation, where R is the organ's
    /// radius.
    void aClosedPathOverALumpMakesOnlyWhatEdgesLeave()
    {
        const meshio::LoadedScene& scene = feltPhantom();
        const auto haptic = study::hapticScene(scene);
        const auto organs = study::organsWithLumps(scene);
        QVERIFY(organs.isOk() && organs.value().size() == 1 && organs.value()[0].lumps.size() == 2);
        const auto map = study::feltSurface(scene, organs.value()[0], {});
        QVERIFY(map.isOk());
        for (const buried::FeltSurface::Lump& lump : map.value().lumps) {
            const std::size_t structure = organs.value()[0].lumps[lump.given].structure;
            QVERIFY(lump.press[3].best.has_value() && haptic->structures()[structure].surface == nullptr);
            const Vec3 best = map.value().surface.vertices[*lump.press[3].best];
            const Vec3 out = (best - middle(*scene.structures[structure].surface)).normalized();
            const Vec3 aside = out.unitOrthogonal();
            for (const double depth_mm : {2.0, 7.0}) {
                std::vector<Vec3> corners;
                for (const auto& [along_mm, height_mm] :
                     {std::pair{0.0, 3.0}, {0.0, -depth_mm}, {9.0, -depth_mm}, {9.0, 12.0}, {0.0, 12.0}, {0.0, 3.0}}) {
                    corners.push_back(best + along_mm * aside + height_mm * out);
                }
                Way away(*haptic), towards(*haptic);
                std::for_each(corners.begin(), corners.end(), [&](const Vec3& p) { away.to(p); });
                std::for_each(corners.rbegin(), corners.rend(), [&](const Vec3& p) { towards.to(p); });
                for (const Way* way : {&away, &towards}) {
                    const QString seen = QStringLiteral("%1, %2 mm, %3: %4 of %5 mJ, along the normal alone %6 mJ")
                                             .arg(lump.name.c_str())
                                             .arg(depth_mm)
                                             .arg(way == &away ? "away" : "towards")
                                             .arg(way->work_mJ)
                                             .arg(way->moved_mJ)
                                             .arg(way->alongNormal_mJ);
                    qInfo("%s", qPrintable(seen));
                    QVERIFY2(way->moved_mJ > 0.5, qPrintable(seen));
                    QVERIFY2(std::abs(way->work_mJ) < 0.0015 * depth_mm * way->moved_mJ, qPrintable(seen));
                    QVERIFY2(std::abs(way->alongNormal_mJ) > 5.0 * std::abs(way->work_mJ), qPrintable(seen));
                }
                QVERIFY(away.work_mJ + towards.work_mJ < 0.0);
            }
        }
    }

    /// Transmitted lumps do not reduce the stable stiffness: at each position the same as for the liver without lumps.
    void theLiverHoldsWithItsLumpsWhatItHoldsWithoutThem_data()
    {
        QTest::addColumn<QByteArray>("id");
        for (const char* id : {"touch", "omega", "woodenhaptics"}) {
            QTest::newRow(id) << QByteArray(id);
        }
    }
    void theLiverHoldsWithItsLumpsWhatItHoldsWithoutThem()
    {
        QFETCH(QByteArray, id);
        constexpr double kSearch = 1.04; // the search's precision
        stability::Shape felt = stability::shapeOf("felt", *study::hapticScene(feltPhantom()));
        QVERIFY(felt.holds.size() >= 5);
        felt.holds.erase(felt.holds.begin(), felt.holds.end() - 2); // over a lump, and at the steepest part of the map
        stability::Shape plain = felt;
        for (std::size_t i = 0; i < plain.structures.size(); ++i) {
            plain.structures[i].maps = {};
            plain.share[i] = 1.0;
        }
        stability::Setup setup;
        setup.preset = *device::findDevicePreset(id.constData());
        for (const bool isControlled : {false, true}) {
            setup.isControlled = isControlled;
            const double with = stability::largestStiffness(felt, setup);
            const double without = stability::largestStiffness(plain, setup);
            const QString seen =
                QStringLiteral("controlled %1: %2, without lumps %3 N/mm").arg(isControlled).arg(with).arg(without);
            QVERIFY2(kSearch * with >= without, qPrintable(seen));
            qInfo("%s", qPrintable(seen));
        }
    }
};

PALPATE_TEST(FeltPhantom)
#include "tst_FeltPhantom.moc"
