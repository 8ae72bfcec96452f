// SPDX-License-Identifier: BSD-3-Clause
// Tests the reference solvers against closed forms and against the engine.
#include "TestRunner.h"

#include <palpate/evaluation/CornerForce.h>
#include <palpate/evaluation/ExactSolver.h>
#include <palpate/evaluation/LagrangeElimination.h>
#include <palpate/evaluation/MotionComparison.h>
#include <palpate/evaluation/PaperBody.h>
#include <palpate/evaluation/PaperSolver.h>
#include <palpate/evaluation/ProductSolver.h>
#include <palpate/evaluation/RaySolver.h>
#include <palpate/evaluation/Shapes.h>
#include <palpate/evaluation/SmoothComparison.h>
#include <palpate/evaluation/Subject.h>
#include <palpate/evaluation/VectorFieldSolver.h>
#include <palpate/meshio/MeshFile.h>

#include <QFile>
#include <QTemporaryDir>

#include <cmath>
#include <numbers>

using namespace palpate;
using namespace palpate::evaluation;
using geometry::TriangleMesh;

namespace {

std::unique_ptr<ReferenceSolver> make(const QString& name, const Surface& surface)
{
    if (name == "paper") {
        return std::make_unique<PaperSolver>(surface);
    }
    if (name == "vtk") {
        return std::make_unique<RaySolver>(surface, makeVtkCaster(surface));
    }
    if (name == "product") {
        return std::make_unique<ProductSolver>(sceneOf(surface.repaired()), "product");
    }
    return std::make_unique<ExactSolver>(surface);
}

/// Moves straight from the solver's position to `to`, then two more ticks there: the paper's solver needs them at an
/// edge.
SolverStep move(ReferenceSolver& solver, const Vec3& from, const Vec3& to, int ticks)
{
    solver.start(from);
    for (int i = 1; i <= ticks; ++i) {
        (void)solver.step(from + (to - from) * (double(i) / ticks));
    }
    (void)solver.step(to);
    return solver.step(to);
}

} // namespace

class References : public QObject
{
    Q_OBJECT

    static void solvers()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("bound"); // the ray solver keeps a gap of 1e-6 of the scene
        QTest::newRow("paper") << "paper" << 1e-7;
        QTest::newRow("vtk") << "vtk" << 1e-3;
        QTest::newRow("exact") << "exact" << 1e-9;
        QTest::newRow("product") << "product" << 1e-6;
    }

  private Q_SLOTS:
    void boxHoldsAtFaceAndLetsGoRoundItsEdge_data() { solvers(); }
    void boxHoldsAtFaceAndLetsGoRoundItsEdge()
    {
        QFETCH(QString, name);
        QFETCH(double, bound);
        const Surface surface(geometry::repair(shapes::box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 3)));
        const auto solver = make(name, surface);
        SolverStep s = move(*solver, Vec3(1.1, 2.3, 14), Vec3(1.7, 2.9, 7), 20);
        QVERIFY((s.p_WG - Vec3(1.7, 2.9, 10)).norm() <= bound);
        QVERIFY((s.spring_mm - Vec3(0, 0, 3)).norm() <= bound);
        QCOMPARE(s.constraints, 1);
        s = move(*solver, Vec3(8, 1.3, 12), Vec3(9.5, 1.3, 5), 30);
        QVERIFY((s.p_WG - Vec3(9.5, 1.3, 10)).norm() <= bound);
        s = move(*solver, Vec3(8, 1.3, 12), Vec3(11, 1.3, 8), 30);
        QVERIFY((s.p_WG - Vec3(11, 1.3, 8)).norm() <= bound);
        QVERIFY(s.spring_mm.norm() <= bound);
    }

    void wedgeHoldsAtItsBottom_data() { solvers(); }
    void wedgeHoldsAtItsBottom()
    {
        QFETCH(QString, name);
        QFETCH(double, bound);
        for (const double degrees : {90.0, 30.0, 10.0}) {
            const double half = degrees * std::numbers::pi / 360.0;
            const Surface surface(geometry::repair(shapes::groove(2.0 * half)));
            const auto solver = make(name, surface);
            const SolverStep s = move(*solver, Vec3(0.01, -3.3, 21), Vec3(0.01, 4.1, -5), 200);
            // A gap to both walls raises the result by the gap over the sine of the half angle.
            QVERIFY2((s.p_WG - Vec3(0, 4.1, 0)).norm() <= bound / std::sin(half),
                     qPrintable(QString("%1 degrees: off by %2").arg(degrees).arg((s.p_WG - Vec3(0, 4.1, 0)).norm())));
            QCOMPARE(s.constraints, 2);
        }
    }

    void sphereIsFeltWithinItsSag_data() { solvers(); }
    void sphereIsFeltWithinItsSag()
    {
        QFETCH(QString, name);
        constexpr double radius = 30.0;
        constexpr int n = 12;
        const Surface surface(geometry::repair(shapes::bumpySphere(n, radius, 0.0)));
        const double edge = 1.0515 / 0.7947 * radius / n, sag = edge * edge / (6.0 * radius);
        const auto solver = make(name, surface);
        solver->start(Vec3(0, 0, 33));
        for (int i = 0; i < 400; ++i) {
            const double a = 2e-3 * i;
            const double r = std::max(27.0, 33.0 - 0.1 * i);
            const SolverStep s = solver->step(r * Vec3(std::sin(a), 0.2 * std::sin(2 * a), std::cos(a)).normalized());
            if (i > 100) {
                QVERIFY(s.p_WG.norm() <= radius + 1e-3 && s.p_WG.norm() >= radius - 1.01 * sag - 1e-3);
            }
        }
    }

    void paperTakesTwoTicksOverAConvexEdge()
    {
        const Surface surface(geometry::repair(shapes::box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 2)));
        PaperSolver solver(surface);
        solver.start(Vec3(9, 1.3, 11));
        (void)solver.step(Vec3(9, 1.3, 9));
        // The HIP leaves below the edge: the top plane stays active for one more tick.
        QVERIFY((solver.step(Vec3(11, 1.3, 8)).p_WG - Vec3(11, 1.3, 10)).norm() < 1e-6);
        QVERIFY((solver.step(Vec3(11, 1.3, 8)).p_WG - Vec3(11, 1.3, 8)).norm() < 1e-6);
    }

    /// Errors are measured with an accelerated copy that finds facets in a box hierarchy: both must give equal results.
    void paperGivesTheSameBitsThroughBoxes()
    {
        for (const TriangleMesh& mesh : {shapes::bumpySphere(10, 20.0, 0.03), paperBody(), shapes::fan(40, -6.0),
                                         shapes::soup(shapes::groove(0.3))}) {
            const Surface surface(geometry::repair(mesh, geometry::Facing::AsGiven));
            PaperSolver all(surface), near(surface, PaperSolver::Search::Boxes);
            int contacts = 0;
            for (const std::uint64_t seed : {1, 2}) {
                for (const HandMotion& motion : standardMotions(surface, seed, 500)) {
                    all.start(motion.p_WH.front());
                    near.start(motion.p_WH.front());
                    for (const Vec3& hip : motion.p_WH) {
                        const SolverStep a = all.step(hip), b = near.step(hip);
                        QVERIFY(a.p_WG == b.p_WG && a.constraints == b.constraints && a.iterations == b.iterations);
                        contacts += a.constraints > 0 ? 1 : 0;
                    }
                }
            }
            QVERIFY(contacts > 500);
        }
    }

    /// Figure 3: summed force fields give 1 - cos of the angle between the surfaces times the correct force; a
    /// god-object gives the correct force. Perpendicular is correct, obtuse too stiff, parallel twice, acute too soft.
    void forceInACornerIsWhatFigure3Says()
    {
        const std::vector<CornerForce> corners = forceInCorners();
        QCOMPARE(corners.size(), std::size_t(17));
        QCOMPARE(corners.front().angle_deg, 20.0);
        QCOMPARE(corners.back().angle_deg, 180.0);
        for (const CornerForce& c : corners) {
            const double expected = 1.0 - std::cos(c.angle_deg * std::numbers::pi / 180.0);
            QVERIFY2(
                std::abs(c.vectorField - expected) < 1e-9,
                qPrintable(QString("%1 degrees: %2, expected %3").arg(c.angle_deg).arg(c.vectorField).arg(expected)));
            QVERIFY2(std::abs(c.godObject - 1.0) < 1e-8,
                     qPrintable(QString("%1 degrees: %2").arg(c.angle_deg).arg(c.godObject)));
        }
    }

    void movingSurfacesPassOnlyWhenTheirNodesAreMoved()
    {
        const std::vector<MotionRow> rows = compareMotions();
        QCOMPARE(rows.size(), std::size_t{8});
        for (std::size_t i = 0; i < rows.size(); i += 2) {
            const MotionRow &moved = rows[i], &back = rows[i + 1];
            QCOMPARE(moved.motion, back.motion);
            QVERIFY2(moved.passes > 0, moved.motion.c_str());
            QVERIFY(back.passes == 0 && back.share == 0.0);
            QVERIFY2(back.touched > back.ticks / 5, back.motion.c_str());
        }
    }

    void smoothSurfacesAreNearerToTheTrueOnes()
    {
        const std::vector<SmoothRow> rows = compareSmoothSurfaces();
        QCOMPARE(rows.size(), std::size_t{12});
        for (std::size_t i = 0; i < rows.size(); i += 4) {
            const SmoothRow &facets = rows[i], &pn = rows[i + 1], &shaded = rows[i + 2], &twoPasses = rows[i + 3];
            for (const SmoothRow& row : {facets, pn, shaded, twoPasses}) {
                qInfo("%-9s %-46s %7zu: %.3g of the radius, %.3g deg, %.3g N, %.3g of %.3g mJ", row.shape.c_str(),
                      row.way.c_str(), row.triangles, row.position_mm / row.extent_mm, row.direction_deg, row.step_N,
                      row.work_mJ, row.press_mJ);
            }
            // Edges in up to 16 pieces: sagittas shrink by up to 256, angles, steps and the work by up to 16.
            QVERIFY(pn.position_mm < facets.position_mm / 30.0);
            QVERIFY(pn.direction_deg < facets.direction_deg / 5.0 && pn.step_N < facets.step_N / 8.0);
            QVERIFY(pn.work_mJ < facets.work_mJ / 10.0);
            // Shading leaves the god-object on the facets; a shaded goal lifts it off the surface.
            QCOMPARE(shaded.position_mm, facets.position_mm);
            QVERIFY(shaded.work_mJ > pn.work_mJ);
            QVERIFY(twoPasses.position_mm > 10.0 * pn.position_mm);
            QVERIFY(twoPasses.step_N < pn.step_N);
        }
        // A sphere's normal is exact at the vertices, and the force steps by the pieces' angle: 2 N times 1° a tick.
        QVERIFY(rows[1].position_mm / rows[1].extent_mm < 7e-5 && rows[1].step_N < 0.04);
    }

    void paperBodyHas616TrianglesAndAnInside()
    {
        const geometry::RepairedMesh body = geometry::repair(paperBody());
        QCOMPARE(body.mesh.triangles.size(), std::size_t(616));
        const Surface surface(body);
        QVERIFY(surface.isClosed());
        QCOMPARE(surface.componentCount(), 1u);
        QCOMPARE(surface.winding(Vec3::Zero()), 1);
    }

    void theBundledPaperBodyIsThatMesh()
    {
        QTemporaryDir folder;
        const QString made = folder.filePath("shuttle.stl");
        const meshio::MeshStructure structure{"shuttle", paperBody(), {}};
        QVERIFY(meshio::writeMesh(made.toStdString(), {&structure, 1}).isOk());
        QFile kept(QString(PALPATE_SOURCE_DIR) + "/data/paper/shuttle.stl"), again(made);
        QVERIFY(kept.open(QIODevice::ReadOnly) && again.open(QIODevice::ReadOnly));
        QCOMPARE(kept.size(), qint64(84 + 50 * 616));
        QVERIFY(kept.readAll() == again.readAll());
    }

    void eliminationSolvesInFewerOperationsThanThePaperStates()
    {
        const std::array<Plane, 3> planes{Plane{Vec3(0.1, 0.2, 1).normalized(), 1.0},
                                          Plane{Vec3(1, -0.3, 0.2).normalized(), -2.0},
                                          Plane{Vec3(-0.2, 1, 0.4).normalized(), 0.5}};
        const std::array<int, 3> expected{10, 27, 52};
        const Vec3 hip(3.0, -4.0, -5.0);
        for (std::size_t k = 1; k <= 3; ++k) {
            const Elimination e = eliminate(hip, std::span(planes).first(k));
            QVERIFY(e.isSolved);
            Vec3 gradient = e.p - hip;
            for (std::size_t i = 0; i < k; ++i) {
                QVERIFY(std::abs(planes[i].n.dot(e.p) - planes[i].d) < 1e-13);
                gradient += e.lambda[i] * planes[i].n;
            }
            QVERIFY(gradient.norm() < 1e-13);
            QCOMPARE(e.multiplicativeOperations, expected[k - 1]);
            QVERIFY(e.multiplicativeOperations <= kPaperOperations[k - 1]);
        }
        const std::array<Plane, 2> same{planes[0], planes[0]};
        QVERIFY(!eliminate(hip, same).isSolved || !eliminate(hip, same).p.allFinite());
    }

    void vectorFieldShowsWhatThePaperSays()
    {
        const VectorFieldFigures f = measureVectorField();
        QVERIFY(std::abs(f.popThroughDepth_mm - f.plate_mm / 2.0) <= 0.011);
        // At the middle of a cube of 20 mm, the nearest faces are 10 mm away on opposite sides.
        QVERIFY(std::abs(f.jumpAtTheMiddle_N - 20.0) < 1e-5);
        QVERIFY(std::abs(f.stiffnessAlone - 1.0) < 1e-12);
        QVERIFY(std::abs(f.stiffnessOverlapped - 2.0) < 1e-12);
    }

    void productAgreesWithTheExactSolver_data()
    {
        QTest::addColumn<double>("bump");
        QTest::addColumn<int>("n");
        QTest::addColumn<double>("friction");
        QTest::newRow("sphere") << 0.0 << 8 << 0.0;
        QTest::newRow("hills") << 0.02 << 8 << 0.0;
        QTest::newRow("sphere, friction 0.3") << 0.0 << 8 << 0.3;
        QTest::newRow("hills, friction 0.3") << 0.02 << 8 << 0.3;
        QTest::newRow("hills, friction 1") << 0.02 << 8 << 1.0;
    }
    void productAgreesWithTheExactSolver()
    {
        QFETCH(double, bump);
        QFETCH(int, n);
        QFETCH(double, friction);
        const Surface surface(geometry::repair(shapes::bumpySphere(n, 20.0, bump)));
        ExactSolver exact(surface, 1, 0.0, friction);
        haptics::HapticStructure rough = sceneOf(surface.repaired())->structures()[0];
        rough.tissue.friction_static = rough.tissue.friction_dynamic = friction;
        ProductSolver product(std::make_shared<haptics::HapticScene>(std::vector{rough}), "product");
        Vec3 hip(0, 0, 25), god = hip;
        product.start(hip);
        double worst = 0.0;
        int contacts = 0;
        for (int i = 0; i < 1500; ++i) {
            const Vec3 before = hip;
            const double a = 3e-3 * i;
            hip = std::max(17.0, 25.0 - 0.1 * i) *
                  Vec3(std::sin(a), std::sin(0.7 * a + 0.2), std::cos(1.3 * a)).normalized();
            exact.resume(god, before);
            god = product.step(hip).p_WG;
            worst = std::max(worst, (exact.step(hip).p_WG - god).norm());
            contacts += (god - hip).norm() > 1e-3 ? 1 : 0;
        }
        QVERIFY(contacts > 1000);
        QVERIFY2(worst <= 1e-6, qPrintable(QString("%1 mm").arg(worst)));
    }

    /// Friction has closed forms on a plane and along a groove; the reference shares no code with the engine.
    void exactFrictionIsCoulombs()
    {
        constexpr double kMu = 0.4;
        const Surface floor(geometry::repair(shapes::box(Vec3(-30, -30, -10), Vec3(30, 30, 0), 4)));
        ExactSolver exact(floor, 1, 0.0, kMu);
        exact.start(Vec3(1.3, 2.1, 5));
        (void)exact.step(Vec3(1.3, 2.1, -2)); // straight in
        const Vec3 held = exact.step(Vec3(1.3 + 0.999 * kMu * 2.0, 2.1, -2)).p_WG;
        QVERIFY((held - Vec3(1.3, 2.1, 0)).norm() < 1e-9);
        const Vec3 dragged = exact.step(Vec3(9.3, 8.1, -2)).p_WG; // 10 mm off, at 3 : 4
        QVERIFY((dragged - Vec3(9.3 - 0.8 * kMu * 2.0, 8.1 - 0.6 * kMu * 2.0, 0)).norm() < 1e-9);
        // Along a groove of 90 degrees: R = mu h / sin 45 deg.
        const Surface groove(geometry::repair(shapes::groove(0.5 * std::numbers::pi)));
        ExactSolver along(groove, 1, 0.0, kMu);
        along.start(Vec3(0, 0.3, 5));
        QVERIFY(along.step(Vec3(0, 0.3, -8)).p_WG.norm() < 0.4); // its bottom
        const double y_mm = along.step(Vec3(0, 8, -8)).p_WG.y();
        QVERIFY2(std::abs(8.0 - y_mm - kMu * 8.0 * std::sqrt(2.0)) < 1e-9, qPrintable(QString::number(y_mm)));
    }

    void windingTellsInsideFromOutside()
    {
        geometry::TriangleMesh mesh = shapes::box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 3);
        geometry::TriangleMesh cavity = shapes::box(Vec3(-5, -5, -5), Vec3(5, 5, 5), 2);
        geometry::flip(cavity);
        shapes::append(mesh, cavity);
        const Surface surface(geometry::repair(mesh, geometry::Facing::AsGiven));
        QCOMPARE(surface.winding(Vec3(0, 0, 0)), 0);
        QCOMPARE(surface.winding(Vec3(7, 0, 0)), 1);
        QCOMPARE(surface.winding(Vec3(10 - 1e-14, 0, 0)), 1);
        QCOMPARE(surface.winding(Vec3(10 + 1e-14, 0, 0)), 0);
        QCOMPARE(surface.winding(Vec3(0, 11, 0)), 0);
    }
};

PALPATE_TEST(References)
#include "tst_References.moc"
