// SPDX-License-Identifier: BSD-3-Clause
// Tests a stiffness that varies over a surface: the force at each position, and that no closed path generates energy.
#include "Known.h"
#include "Shapes.h"
#include "TestRunner.h"
#include "Trials.h"

#include <palpate/haptics/Palpator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>

using namespace palpate;
using namespace palpate::test;
using haptics::HapticScene;
using haptics::HapticStructure;
using haptics::Palpator;
using haptics::TickResult;
using haptics::Tissue;
using haptics::TissueMap;

namespace {

struct Mapped
{
    geometry::RepairedMesh mesh;
    HapticStructure structure;
    std::unique_ptr<HapticScene> scene;
    Palpator palpator;

    Mapped(const geometry::TriangleMesh& from, const Tissue& tissue, const std::function<double(const Vec3&)>& s,
           double radius_mm = 0.0)
        : mesh(geometry::repair(from))
    {
        structure.name = "it";
        auto index = std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(mesh));
        std::vector<float> values;
        for (const Vec3& p : mesh.mesh.vertices) {
            values.push_back(static_cast<float>(s(p)));
        }
        structure.maps.stiffness = TissueMap::atVertices(*index, mesh, values);
        structure.surface = std::move(index);
        structure.tissue = tissue;
        build(radius_mm);
    }
    /// Sets the stiffness ratio k/k0 of buried lumps for a position and each press depth.
    void feel(const std::function<double(const Vec3&, double press_mm)>& ratio, double radius_mm = 0.0)
    {
        for (std::size_t j = 0; j < haptics::kFeltPress_mm.size(); ++j) {
            std::vector<float> values;
            for (const Vec3& p : mesh.mesh.vertices) {
                values.push_back(static_cast<float>(ratio(p, haptics::kFeltPress_mm[j])));
            }
            structure.maps.felt[j] = TissueMap::atVertices(*structure.surface, mesh, values);
        }
        build(radius_mm);
    }
    void build(double radius_mm = 0.0)
    {
        scene = std::make_unique<HapticScene>(std::vector{structure}, radius_mm);
        palpator.borrowScene(scene.get());
        palpator.reset();
    }
    TickResult at(const Vec3& hip) { return palpator.step(hip, kTick_s); }
};

Tissue spring(double k)
{
    Tissue tissue;
    tissue.stiffness_N_per_mm = k;
    return tissue;
}

Tissue fung()
{
    Tissue tissue = spring(0.3);
    tissue.law.kind = core::LawKind::Exponential;
    tissue.law.numbers = {0.1, 0.35, 2.0};
    return tissue;
}

geometry::TriangleMesh slab(int n)
{
    return box(Vec3(-20, -20, -30), Vec3(20, 20, 0), n);
}

/// Returns the parameters (0 to 1) at which the straight path may cross an edge of `slab(2)`.
std::vector<double> pieces(const Vec3& from, const Vec3& to)
{
    std::vector<double> shares{0.0, 1.0};
    const auto cut = [&](double begin, double end) { // where a coordinate crosses -20, 0, 20
        for (const double line : {-20.0, 0.0, 20.0}) {
            const double share = (line - begin) / (end - begin);
            if (share > 0.0 && share < 1.0) {
                shares.push_back(share);
            }
        }
    };
    cut(from.x(), to.x());
    cut(from.y(), to.y());
    for (const double press : haptics::kFeltPress_mm) { // below z = 0
        const double share = (-press - from.z()) / (to.z() - from.z());
        if (share > 0.0 && share < 1.0) {
            shares.push_back(share);
        }
    }
    cut(from.x() - from.y(), to.x() - to.y());
    cut(from.x() + from.y(), to.x() + to.y());
    std::sort(shares.begin(), shares.end());
    return shares;
}

/// Returns the work on the hand along a straight path. The force is smooth within a facet: eight-point Gauss quadrature
/// on each eighth between edges. Near a vertex the cubic blend is a ratio of polynomials, which no quadrature
/// integrates exactly.
double workAlong(Mapped& on, const Vec3& from, const Vec3& to)
{
    constexpr std::array<std::pair<double, double>, 4> kGauss{{{0.1834346424956498, 0.3626837833783620},
                                                               {0.5255324099163290, 0.3137066458778873},
                                                               {0.7966664774136267, 0.2223810344533745},
                                                               {0.9602898564975363, 0.1012285362903763}}};
    const std::vector<double> shares = pieces(from, to);
    double work = 0.0;
    for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
        const Vec3 step = (shares[i + 1] - shares[i]) / 8.0 * (to - from);
        for (int part = 0; part < 8; ++part) {
            const Vec3 middle = from + shares[i] * (to - from) + (part + 0.5) * step;
            for (const auto& [off, weight] : kGauss) {
                work += 0.5 * weight *
                        (on.at(middle - 0.5 * off * step).f_W + on.at(middle + 0.5 * off * step).f_W).dot(step);
            }
        }
    }
    return work;
}

/// Returns the largest work over random closed paths below the top of `slab(2)`, and the largest over a section of a
/// path.
std::pair<double, double> workOfClosedPaths(Mapped& on, int paths, double deepest_mm = 3.0)
{
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> across(-16.0, 16.0), deep(0.5, deepest_mm);
    (void)on.at(Vec3(0.3, 0.1, 1.0));
    double worst = 0.0, part = 0.0;
    for (int i = 0; i < paths; ++i) {
        std::vector<Vec3> corners;
        for (int j = 0; j < 4; ++j) {
            corners.emplace_back(across(random), across(random), -deep(random));
        }
        double work = 0.0;
        for (std::size_t j = 0; j < corners.size(); ++j) {
            work += workAlong(on, corners[j], corners[(j + 1) % corners.size()]);
            part = std::max(part, std::abs(work));
        }
        worst = std::max(worst, std::abs(work));
    }
    return {worst, part};
}

} // namespace

class TissueMaps : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void aRampIsFeltAsWritten()
    {
        // Values that floats represent exactly: s = 1 + x / 32 at the corners.
        Mapped on(box(Vec3(-16, -16, -16), Vec3(16, 16, 0), 4), spring(0.5),
                  [](const Vec3& p) { return 1.0 + p.x() / 32.0; });
        for (double x = -15.3; x < 15.5; x += 0.37) {
            (void)on.at(Vec3(x, 0.7, 1.0));
            const Vec3 hip(x, 0.7, -3.0);
            const TickResult t = on.at(hip);
            const double depth = (t.p_WG - hip).norm(), s = 1.0 + x / 32.0;
            QVERIFY(std::abs(t.f_W.z() / depth / (0.5 * s) - 1.0) < 1e-14);
            QVERIFY(std::abs(t.contacts[0].stiffnessScale - s) < 1e-13);
            QVERIFY(std::abs(t.f_W.x() + 0.25 * depth * depth / 32.0) < 1e-13); // -W ds/dx
            QVERIFY(std::abs(t.f_W.y()) < 1e-13);
        }
    }

    void forceIsTheGradientOfTheEnergy_data()
    {
        QTest::addColumn<double>("radius_mm");
        QTest::addColumn<bool>("isPlain");
        QTest::newRow("point, linear") << 0.0 << true;
        QTest::newRow("point, exponential") << 0.0 << false;
        QTest::newRow("ball, linear") << 3.0 << true;
        QTest::newRow("ball, exponential") << 3.0 << false;
    }
    void forceIsTheGradientOfTheEnergy()
    {
        QFETCH(double, radius_mm);
        QFETCH(bool, isPlain);
        const Tissue tissue = isPlain ? spring(0.5) : fung();
        const auto s = [](const Vec3& p) { return 1.0 + 0.3 * std::sin(0.4 * p.x()) * std::cos(0.3 * p.y()); };
        Mapped on(slab(6), tissue, s, radius_mm);
        std::mt19937_64 random(2);
        std::uniform_real_distribution<double> across(-15.0, 15.0), deep(0.5, 6.0);
        const auto law = haptics::ForceTable::build(tissue);
        for (int i = 0; i < 400; ++i) {
            const Vec3 hip(across(random), across(random), radius_mm - deep(random));
            on.palpator.reset();
            (void)on.at(Vec3(hip.x(), hip.y(), radius_mm + 1.0));
            const TickResult t = on.at(hip);
            // The energy from the resulting stiffness: the normal force is s F.
            const auto energy = [&](const Vec3& p) {
                const TickResult at = on.at(p);
                const double d = (at.p_WG - p).norm();
                const double F = law == nullptr ? 0.5 * d : law->force(d),
                             W = law == nullptr ? 0.25 * d * d : law->energy(d);
                return at.f_W.z() / F * W;
            };
            QVERIFY(t.constraints == 1 && t.f_W.z() > 0.0);
            constexpr double kStep = 1e-4;
            Vec3 gradient;
            for (int axis = 0; axis < 3; ++axis) {
                const Vec3 by = kStep * Vec3::Unit(axis);
                gradient[axis] = (energy(hip + by) - energy(hip - by)) / (2.0 * kStep);
            }
            // The gradient has a kink where the step crosses to another facet: such positions are skipped.
            const std::uint32_t triangle = t.triangle;
            bool isInside = true;
            for (int axis = 0; axis < 3; ++axis) {
                const Vec3 by = 2.0 * kStep * Vec3::Unit(axis);
                isInside = isInside && on.at(hip + by).triangle == triangle && on.at(hip - by).triangle == triangle;
            }
            if (isInside) {
                const double off = (t.f_W + gradient).norm();
                QVERIFY2(off < 1e-6, qPrintable(QString("%1 N").arg(off)));
            }
        }
    }

    void noClosedPathMakesEnergy()
    {
        std::mt19937_64 random(9);
        std::uniform_real_distribution<double> value(0.5, 2.0);
        Mapped on(slab(2), spring(0.5), [&](const Vec3&) { return value(random); });
        const auto [worst, part] = workOfClosedPaths(on, 300);
        QVERIFY2(worst < 1e-6 * part, qPrintable(QString("%1 of %2 mJ").arg(worst).arg(part)));
        QVERIFY(part > 1.0);
    }

    /// Over a convex edge the foot point jumps and the stored energy with it, by at most W |grad s| 2 d tan(theta / 2).
    void overAConvexEdgeTheEnergyJumpsAsDerived()
    {
        constexpr double kSlope = 0.03, kDepth = 5.0, kFold = std::numbers::pi / 180.0; // half of the dihedral
        geometry::TriangleMesh ridge = slab(6);
        double top = -1e9;
        for (const Vec3& v : ridge.vertices) {
            top = std::max(top, v.z());
        }
        for (Vec3& v : ridge.vertices) {
            if (v.z() > top - 1e-9) {
                v.z() -= std::tan(kFold) * std::abs(v.x());
            }
        }
        Mapped on(ridge, spring(0.5), [](const Vec3& p) { return 1.0 + kSlope * p.x(); });
        std::array<double, 2> stored{};
        for (const int side : {0, 1}) {
            on.palpator.reset();
            const double x = side == 0 ? -1e-6 : 1e-6;
            (void)on.at(Vec3(x, 0.7, top + 1.0));
            const Vec3 hip(x, 0.7, top - kDepth);
            const TickResult t = on.at(hip);
            const double d = (t.p_WG - hip).norm();
            QCOMPARE(int(t.constraints), 1);
            stored[static_cast<std::size_t>(side)] = t.contacts[0].stiffnessScale * 0.25 * d * d;
        }
        const double jump = (stored[1] - stored[0]) / (0.25 * kDepth * kDepth);
        const double derived = kSlope * 2.0 * kDepth * std::tan(kFold); // 0.5 % of the stored energy
        QVERIFY2(std::abs(jump / derived - 1.0) < 1e-3, qPrintable(QString("%1, %2").arg(jump).arg(derived)));
    }

    /// The sideways force varies with the position without jumps at triangle edges: over a tenth of the path the force
    /// changes by about a tenth.
    void thePushAsideDoesNotJumpAtEdges_data()
    {
        QTest::addColumn<double>("radius_mm");
        QTest::addColumn<bool>("isFelt");
        QTest::newRow("point, map") << 0.0 << false;
        QTest::newRow("point, lumps below") << 0.0 << true;
        QTest::newRow("ball, map") << 2.0 << false;
    }
    void thePushAsideDoesNotJumpAtEdges()
    {
        QFETCH(double, radius_mm);
        QFETCH(bool, isFelt);
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> value(0.8, 1.6), across(-14.0, 14.0);
        std::map<std::pair<double, double>, double> at;
        const auto s = [&](const Vec3& p) { return at.try_emplace({p.x(), p.y()}, value(random)).first->second; };
        Mapped on(slab(8), spring(0.5), s, radius_mm);
        if (isFelt) {
            on.structure.maps.stiffness = {};
            on.feel([&](const Vec3& p, double) { return s(p); }, radius_mm);
        }
        constexpr double kDepth_mm = 4.0;
        std::array<double, 2> worst{}; // change of the sideways force in a step, relative to the force
        for (int path = 0; path < 20; ++path) {
            const Vec3 from(across(random), across(random), radius_mm - kDepth_mm);
            const Vec3 to(across(random), across(random), radius_mm - kDepth_mm);
            for (const auto& [i, step_mm] : {std::pair(0, 0.01), std::pair(1, 0.001)}) {
                on.palpator.reset();
                (void)on.at(from + Vec3(0, 0, kDepth_mm + 1.0));
                Vec3 last = on.at(from).f_W;
                for (double way = step_mm; way < (to - from).norm(); way += step_mm) {
                    const Vec3 now = on.at(from + way * (to - from).normalized()).f_W;
                    double& most = worst[static_cast<std::size_t>(i)];
                    most = std::max(most, (now - last).head<2>().norm() / now.norm());
                    last = now;
                }
            }
        }
        const QString told = QString("%1 % in 0.01 mm, %2 % in 0.001 mm").arg(100.0 * worst[0]).arg(100.0 * worst[1]);
        QVERIFY2(worst[0] < 0.02 && worst[1] < 0.15 * worst[0], qPrintable(told));
    }

    /// Cell values step at cell edges, and no gradient is computed from them; a fold in the surface adds no value of
    /// its own either.
    void bendsAreWhereNumbersAgreeAlone()
    {
        Mapped on(slab(4), spring(0.5), [](const Vec3& p) { return p.x() > 1.0 ? 2.0 : 1.0; });
        std::vector<float> values(on.mesh.mesh.triangles.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = 1.0F + 0.1F * static_cast<float>(i % 7);
        }
        const auto cells = TissueMap::atTriangles(*on.structure.surface, values).withBends(*on.structure.surface);
        QVERIFY(cells.bends != nullptr && cells.bends->empty());
        // A step stays within the range of the surrounding values.
        (void)on.at(Vec3(0.3, 0.2, 1));
        for (double x = -15.0; x < 15.0; x += 0.05) {
            const double scale = on.at(Vec3(x, 0.2, -1)).contacts[0].stiffnessScale;
            QVERIFY2(scale > 0.95 && scale < 2.05, qPrintable(QString::number(scale)));
        }
    }

    void withoutTheGradientsTermPathsWouldMakeEnergy()
    {
        // In over the soft side and out over the stiff one: the gradient term absorbs the surplus energy of a plain
        // k(x) d.
        Mapped on(slab(2), spring(0.5), [](const Vec3& p) { return 1.0 + 0.04 * p.x(); });
        const std::vector<Vec3> path{{-5, 1, -0.5}, {-5, 1, -4}, {5, 1, -4}, {5, 1, -0.5}, {-5, 1, -0.5}};
        (void)on.at(Vec3(-5, 1, 1));
        double whole = 0.0, plain = 0.0;
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            const double work = workAlong(on, path[i], path[i + 1]);
            whole += work;
            plain += path[i].x() == path[i + 1].x() ? work : 0.0; // a plain k(x) d does no work along the surface
        }
        QVERIFY2(std::abs(whole) < 1e-12, qPrintable(QString::number(whole)));
        QVERIFY2(plain > 0.5, qPrintable(QString::number(plain)));
    }

    void frictionTakesWhatLumpsFeltBelowCouldMake()
    {
        // With friction the foot point stays behind the HIP; the sideways force of the press maps widens the cone by
        // |grad U| / F. With the same s = 1 + x/32 at each press depth, this ratio is depth/2 / (32 s), far above mu.
        Tissue tissue = spring(0.5);
        tissue.friction_static = tissue.friction_dynamic = 0.001;
        const auto s = [](const Vec3& p) { return 1.0 + p.x() / 32.0; };
        Mapped byFelt(slab(4), tissue, [](const Vec3&) { return 1.0; });
        byFelt.structure.maps.stiffness = {};
        byFelt.feel([&](const Vec3& p, double) { return s(p); });
        Mapped byStiffness(slab(4), tissue, s);
        for (const double depth : {1.0, 3.0, 6.0, 9.0}) {
            TickResult a, b;
            for (Mapped* on : {&byFelt, &byStiffness}) {
                on->palpator.reset();
                (void)on->at(Vec3(1, 1, 0.5));
                (void)on->at(Vec3(1, 1, -depth));
                (on == &byFelt ? a : b) = on->at(Vec3(3, 1, -depth));
            }
            QVERIFY((a.p_WG - b.p_WG).norm() < 1e-12);
            const double cone = 0.5 * depth * depth / 32.0 / s(Vec3(1, 1, 0)); // R = mu depth, where the move started
            QVERIFY2(std::abs(3.0 - a.p_WG.x() - std::min(cone, 2.0)) < 0.2 * cone,
                     qPrintable(QString("%1 mm behind, R %2 mm").arg(3.0 - a.p_WG.x()).arg(cone)));
        }
        // In over the soft side, out over the stiff one.
        const std::vector<Vec3> path{{-5, 1, -0.5}, {-5, 1, -4}, {5, 1, -4}, {5, 1, -0.5}, {-5, 1, -0.5}};
        (void)byFelt.at(Vec3(-5, 1, 1));
        double work = 0.0; // on the hand; the first round only settles the foot point
        for (std::size_t i = 0; i < 8; ++i) {
            const Vec3 step = (path[i % 4 + 1] - path[i % 4]) / 1000.0;
            for (int j = 1; j <= 1000; ++j) {
                const double part = byFelt.at(path[i % 4] + j * step).f_W.dot(step);
                work += i < 4 ? 0.0 : part;
            }
        }
        QVERIFY2(work < 0.0, qPrintable(QString("%1 mJ made").arg(work)));
    }

    void inACreaseTheForceFollowsItsLine()
    {
        Mapped on(groove(1.2, 20.0, 30.0), spring(0.5), [](const Vec3& p) { return 1.0 + p.y() / 64.0; });
        (void)on.at(Vec3(0, 3, 5));
        const TickResult t = on.at(Vec3(0, 3, -2));
        QCOMPARE(int(t.constraints), 2);
        const double d = (t.p_WG - Vec3(0, 3, -2)).norm();
        QVERIFY(std::abs(t.f_W.z() - 0.5 * (1.0 + 3.0 / 64.0) * d) < 1e-6);
        QVERIFY(std::abs(t.f_W.y() + 0.25 * d * d / 64.0) < 1e-6);
        QVERIFY(std::abs(t.f_W.x()) < 1e-6);
    }

    void frictionTakesWhatTheMapCouldMake()
    {
        Tissue sticky = spring(0.5);
        sticky.friction_static = sticky.friction_dynamic = 0.02;
        Mapped on(slab(5), sticky, [](const Vec3& p) { return 1.0 + 0.4 * std::sin(0.5 * p.x()); });
        std::mt19937_64 random(6);
        std::uniform_real_distribution<double> across(-12.0, 12.0), deep(0.3, 5.0);
        Vec3 hip(0, 0, -1), goal = hip, before = hip;
        const Vec3 home = hip;
        double input = 0.0;
        (void)on.at(Vec3(0, 0, 1));
        for (int i = 0; i < test::trials(100000); ++i) {
            if ((hip - goal).norm() < 0.1) {
                goal = i < 99000 ? Vec3(across(random), across(random), -deep(random)) : home;
            }
            hip += 0.05 * (goal - hip).normalized();
            input -= on.at(hip).f_W.dot(hip - before);
            before = hip;
        }
        QVERIFY(input > 0.0);
    }

    /// In contact with a frictional structure too, the map's sideways force of a frictionless structure is part of the
    /// output, so nothing may hold the god-object against that force.
    void withoutFrictionAMapHoldsNothingBesideWhatHasSome()
    {
        Mapped on(slab(2), spring(0.5), [](const Vec3& p) { return 1.0 + 0.04 * p.x(); });
        HapticStructure rough = on.structure;
        rough.surface = indexed(transformed(slab(2), [](const Vec3& p) { return Vec3(p + Vec3(100, 0, 0)); }));
        rough.maps = {};
        rough.tissue.friction_static = rough.tissue.friction_dynamic = 0.5;
        on.scene = std::make_unique<HapticScene>(std::vector{on.structure, rough});
        on.palpator.borrowScene(on.scene.get());
        (void)on.at(Vec3(-5, 1, 1));
        for (double x = -5.0; x < 5.0; x += 0.03) {
            const Vec3 hip(x, 1, -4);
            const TickResult t = on.at(hip);
            QVERIFY(t.constraints == 1 && std::abs(t.p_WG.x() - x) < 1e-9);
            const double depth = t.contacts[0].depth_mm;
            QVERIFY(std::abs(t.f_W.x() + 0.04 * 0.25 * depth * depth) < 1e-6); // the map is stored as floats
        }
    }

    void dampingAndFrictionFollowTheirMaps()
    {
        Tissue tissue = spring(0.5);
        tissue.damping_Ns_per_mm = 7.0; // replaced by the damping map
        tissue.friction_static = tissue.friction_dynamic = 0.4;
        Mapped on(slab(1), tissue, [](const Vec3&) { return 1.0; });
        on.structure.maps.damping =
            TissueMap::atTriangles(*on.structure.surface, std::vector<float>(on.mesh.mesh.triangles.size(), 0.25F));
        on.structure.maps.friction =
            TissueMap::atTriangles(*on.structure.surface, std::vector<float>(on.mesh.mesh.triangles.size(), 0.5F));
        on.structure.maps.friction.factor = 2.0;
        on.structure.maps.stiffness = {};
        on.build();
        (void)on.at(Vec3(1, 2, 1));
        (void)on.at(Vec3(1, 2, -2));
        const Vec3 hip(3, 2, -2);
        const TickResult t = on.at(hip);
        const Vec3 felt = t.f_W + 0.25 * Vec3(2.0 / kTick_s, 0, 0); // without the damper
        QVERIFY((felt - 0.5 * (t.p_WG - hip)).norm() < 1e-9);
        QVERIFY(std::abs(felt.x() + 0.4 * felt.z()) < 1e-9);
    }

    void lumpsBelowAreFeltBetweenThePressesThatAreKnown_data()
    {
        QTest::addColumn<bool>("isPlain");
        QTest::addColumn<bool>("isMapped");
        QTest::newRow("linear") << true << false;
        QTest::newRow("exponential") << false << false;
        QTest::newRow("linear, with a map of stiffness") << true << true;
    }
    void lumpsBelowAreFeltBetweenThePressesThatAreKnown()
    {
        QFETCH(bool, isPlain);
        QFETCH(bool, isMapped);
        const Tissue tissue = isPlain ? spring(0.5) : fung();
        const auto law = haptics::ForceTable::build(tissue);
        const auto F = [&](double d) { return law == nullptr ? 0.5 * d : law->force(d); };
        const auto ratio = [](const Vec3& p, double press) { return 1.0 + 0.0625 * press * (1.0 + p.x() / 32.0); };
        const auto map = [&](double x) { return isMapped ? 1.0 + x / 64.0 : 1.0; };
        Mapped on(box(Vec3(-16, -16, -30), Vec3(16, 16, 0), 4), tissue, [&](const Vec3& p) { return map(p.x()); });
        if (!isMapped) {
            on.structure.maps.stiffness = {};
        }
        on.feel(ratio);
        for (const double asked : {0.7, 2.0, 2.9, 4.0, 6.5, 8.0, 11.0}) {
            const double x = 0.3 * asked;
            (void)on.at(Vec3(x, 0.7, 1.0));
            const TickResult t = on.at(Vec3(x, 0.7, -asked));
            const double depth = asked + t.p_WG.z(), press = std::min(depth, 8.0);
            // The ratio is linear in the press depth here, so the interpolation between presses matches the formula.
            const double scale = 1.0 + 0.0625 * press * (1.0 + x / 32.0);
            QVERIFY(std::abs(t.f_W.z() / (map(x) * scale * F(depth)) - 1.0) < 1e-12);
            QVERIFY(std::abs(t.contacts[0].stiffnessScale - map(x) * scale) < 1e-12);
            // U = map (W + 1/16 (1 + x / 32) V), where V is the integral of min(d, 8) F.
            double V = 0.0, W = 0.0;
            constexpr int kSteps = 20000;
            for (int i = 0; i < kSteps; ++i) {
                const double d = (i + 0.5) * depth / kSteps;
                V += std::min(d, 8.0) * F(d) * depth / kSteps;
                W += F(d) * depth / kSteps;
            }
            const double along =
                map(x) * 0.0625 / 32.0 * V + (isMapped ? 1.0 / 64.0 : 0.0) * (W + 0.0625 * (1.0 + x / 32.0) * V);
            QVERIFY2(std::abs(t.f_W.x() + along) < 1e-6, qPrintable(QString("%1 %2").arg(t.f_W.x()).arg(along)));
        }
    }

    void noClosedPathOverALumpMakesEnergy()
    {
        std::mt19937_64 random(9);
        std::uniform_real_distribution<double> value(0.7, 2.0);
        Mapped on(slab(2), spring(0.5), [](const Vec3&) { return 1.0; });
        on.structure.maps.stiffness = {};
        on.feel([&](const Vec3&, double) { return value(random); });
        const auto [worst, part] = workOfClosedPaths(on, 300, 10.0);
        QVERIFY2(worst < 1e-6 * part, qPrintable(QString("%1 of %2 mJ").arg(worst).arg(part)));
        QVERIFY(part > 1.0);
    }

    void aMapOfOnesChangesNothingButRounding()
    {
        Mapped on(bumpySphere(12, 25.0, 0.04), spring(0.5), [](const Vec3&) { return 1.0; });
        Mapped plain(bumpySphere(12, 25.0, 0.04), spring(0.5), [](const Vec3&) { return 1.0; });
        plain.structure.maps = {};
        plain.build();
        for (int i = 0; i < 2000; ++i) {
            const Vec3 hip(24.0 * std::sin(0.01 * i), 5.0 * std::sin(0.003 * i), 20.0 + 6.0 * std::cos(0.02 * i));
            const TickResult a = on.at(hip), b = plain.at(hip);
            QVERIFY(a.p_WG == b.p_WG);
            QVERIFY((a.f_W - b.f_W).norm() <= 1e-15 * b.f_W.norm());
        }
    }
};

PALPATE_TEST(TissueMaps)
#include "tst_TissueMaps.moc"
