// SPDX-License-Identifier: BSD-3-Clause
// Tests several structures that hold one god-object: each pushes with its own law.
#include "Known.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/haptics/Palpator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace palpate;
using namespace palpate::test;
using haptics::HapticScene;
using haptics::HapticStructure;
using haptics::Palpator;
using haptics::TickResult;
using haptics::Tissue;

namespace {

Tissue linear(double k)
{
    Tissue tissue;
    tissue.stiffness_N_per_mm = k;
    return tissue;
}

/// Returns a slab whose top is the plane through the origin with normal n in the xz plane.
geometry::TriangleMesh slabUnder(const Vec3& n)
{
    const Vec3 along(n.z(), 0.0, -n.x());
    return transformed(box(Vec3(-60, -60, -60), Vec3(60, 60, 0)),
                       [&](const Vec3& p) { return Vec3(p.x() * along + p.y() * Vec3::UnitY() + p.z() * n); });
}

/// Two half-spaces whose outward normals enclose `angle`: a crease along y through the origin.
struct Crease
{
    Vec3 first, second;
    HapticScene scene;
    Palpator palpator;

    Crease(double angle, const Tissue& one, const Tissue& other)
        : first(std::sin(0.5 * angle), 0.0, std::cos(0.5 * angle))
        , second(-std::sin(0.5 * angle), 0.0, std::cos(0.5 * angle))
        , scene({HapticStructure{"one", indexed(slabUnder(first)), one, 0},
                 HapticStructure{"other", indexed(slabUnder(second)), other, 0}})
    {
        palpator.borrowScene(&scene);
        (void)at(Vec3(0, 0.3, 50.0));
    }
    TickResult at(const Vec3& hip) { return palpator.step(hip, kTick_s); }
};

/// How a structure is touched: each uses another list of the terms of a tissue.
enum class Touched
{
    Linear,
    ByLaw,
    Mapped,
    OverLump,
    WithAnother ///< structure in the same contact
};

/// Returns the scene of a floor at z = 0 and, for a shared contact, a wall at x = 5.
HapticScene sceneFor(Touched how, Tissue tissue)
{
    if (how == Touched::ByLaw) {
        tissue.law = {core::LawKind::Exponential, {0.1, 0.35, 1.5}, {}};
    }
    HapticStructure floor{"floor", indexed(box(Vec3(-60, -60, -60), Vec3(60, 60, 0))), tissue, 0};
    const auto map =
        haptics::TissueMap::atTriangles(*floor.surface, std::vector<float>(floor.surface->triangleCount(), 2.0F));
    if (how == Touched::Mapped) {
        floor.maps.stiffness = map;
    } else if (how == Touched::OverLump) {
        floor.maps.felt.fill(map);
    }
    std::vector<HapticStructure> structures{floor};
    if (how == Touched::WithAnother) {
        structures.push_back({"wall", indexed(box(Vec3(5, -60, -60), Vec3(60, 60, 60))), tissue, 0});
    }
    return HapticScene(std::move(structures));
}

/// Returns the force after a move along y in contact.
/// @param speed_mm_per_s  velocity along y that dampers use
Vec3 dragged(const HapticScene& scene, double speed_mm_per_s)
{
    const Vec3 v_W(0.0, speed_mm_per_s, 0.0);
    Palpator palpator;
    palpator.borrowScene(&scene);
    TickResult felt;
    for (const Vec3& hip : {Vec3(0, 0, 5), Vec3(6, 0, -1), Vec3(6, 2, -1)}) {
        felt = palpator.step(hip, kTick_s, &v_W);
    }
    return felt.f_W;
}

/// Results for a hand path around the crease: down along one normal, around, and up along the other.
struct Round
{
    double slope = 0.0;   ///< largest change of the force per hand displacement [N/mm]
    double most_N = 0.0;  ///< largest force
    double work_mJ = 0.0; ///< on the hand
    int shared = 0;       ///< ticks with two contacts

    Round(Crease& on, double angle, double depth_mm)
    {
        std::vector<Vec3> path;
        constexpr int kSteps = 4000;
        const auto below = [](double r, double a) { return Vec3(-r * std::sin(a), 0.3, -r * std::cos(a)); };
        for (int i = 0; i <= kSteps; ++i) {
            path.push_back(below(depth_mm * i / kSteps, 0.5 * angle));
        }
        for (int i = 1; i <= kSteps; ++i) {
            path.push_back(below(depth_mm, angle * (0.5 - double(i) / kSteps)));
        }
        for (int i = kSteps; i-- > 0;) {
            path.push_back(below(depth_mm * i / kSteps, -0.5 * angle));
        }
        TickResult last = on.at(path.front());
        for (std::size_t i = 1; i < path.size(); ++i) {
            const TickResult now = on.at(path[i]);
            const Vec3 step = path[i] - path[i - 1];
            slope = std::max(slope, (now.f_W - last.f_W).norm() / step.norm());
            most_N = std::max(most_N, now.f_W.norm());
            work_mJ += 0.5 * (now.f_W + last.f_W).dot(step);
            shared += now.contactCount == 2 ? 1 : 0;
            last = now;
        }
    }
};

} // namespace

class SharedContacts : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    /// A term that is missing in a list of `law/Law.h` would be lost in some contacts only, and a term of the velocity
    /// without HapticStructure::isDamped would be lost in live touch, which then provides no velocity.
    void haveEachTermOfATissueLikeOtherContacts()
    {
        int acting = 0;
        for (const core::TissueTerm& term : core::kTissueTerms) {
            if (term.member == &Tissue::stiffness_N_per_mm) {
                continue; // without effect where a law is set
            }
            Tissue with = linear(0.5);
            with.*term.member = 0.1;
            const auto acts = [&](Touched how) {
                return dragged(sceneFor(how, with), 50.0) != dragged(sceneFor(how, linear(0.5)), 50.0);
            };
            const bool isActing = acts(Touched::Linear);
            for (const Touched how : {Touched::ByLaw, Touched::Mapped, Touched::OverLump, Touched::WithAnother}) {
                QVERIFY2(acts(how) == isActing,
                         qPrintable(QStringLiteral("%1, contact %2").arg(term.key.data()).arg(static_cast<int>(how))));
            }
            const HapticScene scene = sceneFor(Touched::Linear, with);
            QVERIFY2(scene.isDamped() || dragged(scene, 50.0) == dragged(scene, 0.0), term.key.data());
            acting += isActing ? 1 : 0;
        }
        QVERIFY(acting > 0);
    }

    void atARightAngleEachAnswersAsIfAlone()
    {
        Tissue fung = linear(0.2);
        fung.law.kind = core::LawKind::Exponential;
        fung.law.numbers = {0.1, 0.35, 2.0};
        const auto law = haptics::ForceTable::build(fung);
        Crease on(0.5 * std::numbers::pi, fung, linear(1.5));
        for (const double depth : {0.2, 1.0, 4.0}) {
            const Vec3 hip = Vec3(0, 0.3, 0) - depth * on.first - 3.0 * on.second;
            const TickResult t = on.at(hip);
            QCOMPARE(int(t.constraints), 2);
            QVERIFY((t.f_W - law->force(depth) * on.first - 4.5 * on.second).norm() < 1e-7);
            QCOMPARE(int(t.contactCount), 2);
            QCOMPARE(t.structure, 1); // structure with the larger force
            QCOMPARE(t.contacts[0].structure, 1u);
            QVERIFY(std::abs(t.contacts[0].depth_mm - 3.0) < 1e-7 && std::abs(t.contacts[1].depth_mm - depth) < 1e-7);
            QVERIFY((t.contacts[0].f_W + t.contacts[1].f_W - t.f_W).norm() < 1e-12);
            QVERIFY(std::abs(t.contacts[0].n_W.dot(on.second) - 1.0) < 1e-12);
        }
    }

    void stepsAndEnergyAreAsDerived_data()
    {
        QTest::addColumn<double>("angle_deg");
        QTest::addColumn<double>("ratio");
        for (const double angle_deg : {8.0, 25.0, 60.0, 90.0, 120.0, 154.0, 172.0}) {
            for (const double ratio : {0.02, 0.5, 10.0}) {
                QTest::newRow(qPrintable(QString("%1 degrees, 1 : %2").arg(angle_deg).arg(ratio)))
                    << angle_deg << ratio;
            }
        }
    }
    /// Up to 90 degrees between the normals, the force has a curl, and a closed path gains theta / tan theta of the
    /// energy at an abrupt seam; beyond that there is no curl, and no tick steps by more than the stiffest spring.
    void stepsAndEnergyAreAsDerived()
    {
        QFETCH(double, angle_deg);
        QFETCH(double, ratio);
        constexpr double kDepth_mm = 3.0;
        const double angle = angle_deg * std::numbers::pi / 180.0, one = 1.0, other = ratio;
        Crease on(angle, linear(one), linear(other));
        const Round round(on, angle, kDepth_mm);
        QVERIFY2(round.shared > 3000, qPrintable(QString::number(round.shared)));
        const double stiffest = std::max(one, other), apart = std::abs(one - other);
        const double slope = std::min(one, other) + apart / (angle_deg < 90.0 ? std::sin(angle) : 1.0);
        QVERIFY2(round.slope < 1.02 * slope, qPrintable(QString("%1 N/mm of %2").arg(round.slope).arg(slope)));
        QVERIFY2(round.most_N < stiffest * kDepth_mm * (1.0 + 1e-6), qPrintable(QString::number(round.most_N)));
        const double seam_mJ = 0.5 * apart * kDepth_mm * kDepth_mm;
        const double made = angle_deg < 90.0 ? angle / std::tan(angle) * seam_mJ : 0.0;
        QVERIFY2(std::abs(std::abs(round.work_mJ) - made) < 2e-3 * seam_mJ + 1e-6,
                 qPrintable(QString("%1 mJ of %2").arg(round.work_mJ).arg(made)));
    }

    void aStructureInTwoPartsIsFeltAsOne()
    {
        // The same tissue on both sides of a crease: equal to a crease of one structure.
        const double angle = 1.2;
        Crease on(angle, linear(0.7), linear(0.7));
        geometry::TriangleMesh both = slabUnder(on.first);
        append(both, slabUnder(on.second));
        const HapticScene whole({HapticStructure{"both", indexed(both), linear(0.7), 0}});
        Palpator palpator;
        palpator.borrowScene(&whole);
        (void)palpator.step(Vec3(0, 0.3, 50), kTick_s);
        for (int i = 0; i < 300; ++i) {
            const Vec3 hip(2.0 * std::sin(0.05 * i), 0.3, -3.0 - std::cos(0.03 * i));
            QVERIFY((on.at(hip).f_W - palpator.step(hip, kTick_s).f_W).norm() < 1e-9);
        }
    }

    void aCornerOfThreeStructuresHasNoStep()
    {
        const HapticScene scene(
            {HapticStructure{"floor", indexed(box(Vec3(-50, -50, -50), Vec3(50, 50, 0))), linear(0.1)},
             HapticStructure{"wall", indexed(box(Vec3(-50, -50, -50), Vec3(0, 50, 50))), linear(1.0)},
             HapticStructure{"side", indexed(box(Vec3(-50, -50, -50), Vec3(50, 0, 50))), linear(5.0)}});
        Palpator palpator;
        palpator.borrowScene(&scene);
        (void)palpator.step(Vec3(1, 1, 1), kTick_s);
        Vec3 last = Vec3::Zero(), from(1, 1, 1);
        int three = 0;
        double work = 0.0;
        for (int i = 0; i < 20000; ++i) {
            const double a = 2.0 * std::numbers::pi * i / 20000.0;
            const Vec3 hip(1.0 - 2.0 * std::sin(3.0 * a), 1.0 - 2.0 * std::sin(2.0 * a), 1.0 - 3.0 * std::sin(a));
            const TickResult t = palpator.step(hip, kTick_s);
            const Vec3 exact(std::max(0.0, -hip.x()) * 1.0, std::max(0.0, -hip.y()) * 5.0,
                             std::max(0.0, -hip.z()) * 0.1);
            QVERIFY2((t.f_W - exact).norm() < 1e-7, qPrintable(QString("tick %1").arg(i)));
            if (i > 0) {
                QVERIFY((t.f_W - last).norm() <= 5.0 * (hip - from).norm() * (1.0 + 1e-6) + 1e-9);
                work += 0.5 * (t.f_W + last).dot(hip - from);
            }
            three += t.contactCount == 3 ? 1 : 0;
            last = t.f_W;
            from = hip;
        }
        QVERIFY(three > 500);
        QVERIFY2(std::abs(work) < 1e-3, qPrintable(QString::number(work)));
    }

    void dampersAndFrictionCountByTheirStructure()
    {
        Tissue damped = linear(0.2), rough = linear(2.0);
        damped.damping_Ns_per_mm = 0.004;
        rough.friction_static = rough.friction_dynamic = 0.5;
        Crease on(0.5 * std::numbers::pi, damped, rough);
        const auto hip = [&](double y) { return Vec3(Vec3(0, y, 0) - 4.0 * on.first - 1.0 * on.second); };
        for (int i = 0; i < 200; ++i) {
            (void)on.at(hip(0.05 * i));
        }
        const TickResult t = on.at(hip(10.0)); // slides along the crease at 50 mm/s
        QCOMPARE(int(t.contactCount), 2);
        // Friction: mu times the rough structure's own 2 N. Damper: 4 of 5 parts of the multipliers.
        const double friction = 0.5 * 2.0 * 1.0, damper = 0.004 * 50.0 * 4.0 / 5.0;
        QVERIFY2(std::abs(-t.f_W.y() - friction - damper) < 1e-6, qPrintable(QString::number(t.f_W.y())));
        QVERIFY(t.contacts[0].structure == 1 && t.contacts[0].friction == haptics::Friction::Slides);
        QVERIFY(t.contacts[1].friction == haptics::Friction::None);
    }

    void aBallInACreaseIsHeldByBoth()
    {
        const double angle = 0.5 * std::numbers::pi;
        Crease on(angle, linear(0.2), linear(2.0));
        const HapticScene ball(std::vector<HapticStructure>(on.scene.structures()), 3.0);
        on.palpator.borrowScene(&ball);
        on.palpator.reset();
        const Vec3 centre = Vec3(0, 0.3, 0) + 3.0 * on.first + 3.0 * on.second;
        (void)on.at(centre + Vec3(0, 0, 1));
        const TickResult t = on.at(centre - 5.0 * on.first - 0.1 * on.second);
        QVERIFY((t.f_W - on.first - 0.2 * on.second).norm() < 1e-6);
    }
};

PALPATE_TEST(SharedContacts)
#include "tst_SharedContacts.moc"
