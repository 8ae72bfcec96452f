// SPDX-License-Identifier: BSD-3-Clause
// Tests the god-object by brute force in long double against its definition: no legal move improves the position, and
// the god-object never reaches a place that no legal move leads to.
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/haptics/Palpator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

using namespace palpate;
using namespace palpate::test;
using geometry::RepairedMesh;
using haptics::HapticScene;
using haptics::HapticStructure;
using haptics::Palpator;
using haptics::TickResult;
using haptics::TickStatus;

namespace {

using Long3 = Eigen::Matrix<long double, 3, 1>;

/// Definition in god-object.md: a move against the normal, from the front or the plane to behind, through the closed
/// triangle.
bool isBlocked(const RepairedMesh& r, const Vec3& from, const Vec3& to)
{
    const Long3 x = from.cast<long double>(), y = to.cast<long double>(), d = y - x;
    const core::Box reach(from.cwiseMin(to), from.cwiseMax(to));
    for (std::size_t i = 0; i < r.mesh.triangles.size(); ++i) {
        const geometry::Triangle& t = r.mesh.triangles[i];
        const Vec3 &va = r.mesh.vertices[t[0]], &vb = r.mesh.vertices[t[1]], &vc = r.mesh.vertices[t[2]];
        if (!reach.intersects(core::Box(va.cwiseMin(vb).cwiseMin(vc), va.cwiseMax(vb).cwiseMax(vc)))) {
            continue;
        }
        const Long3 a = va.cast<long double>(), b = vb.cast<long double>(), c = vc.cast<long double>();
        const Long3 n = (b - a).cross(c - a);
        long double start = n.dot(x - a), end = n.dot(y - a), side = 1;
        if (start < 0) {
            if (r.twoSided[i] == 0) {
                continue;
            }
            side = -1;
            start = -start;
            end = -end;
        }
        if (end >= 0 || side * n.dot(d) >= 0) {
            continue;
        }
        if (side * d.dot((a - x).cross(b - x)) <= 0 && side * d.dot((b - x).cross(c - x)) <= 0 &&
            side * d.dot((c - x).cross(a - x)) <= 0) {
            return true;
        }
    }
    return false;
}

/// Returns the winding number around `p`: 1 inside a closed surface that faces outwards.
double winding(const RepairedMesh& r, const Vec3& p)
{
    double angle = 0.0;
    for (const geometry::Triangle& t : r.mesh.triangles) {
        const Vec3 a = r.mesh.vertices[t[0]] - p, b = r.mesh.vertices[t[1]] - p, c = r.mesh.vertices[t[2]] - p;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return angle / (4 * std::numbers::pi);
}

using Voxel = std::array<int, 3>;

/// Returns the surface of some 1 mm voxels as from a label map: two triangles for each face that belongs to only one
/// voxel.
geometry::TriangleMesh voxels(const std::vector<Voxel>& all)
{
    geometry::TriangleMesh mesh;
    std::map<Voxel, std::uint32_t> number;
    for (const Voxel& voxel : all) {
        for (std::size_t face = 0; face < 6; ++face) {
            const std::size_t axis = face / 2;
            const int side = static_cast<int>(face % 2);
            Voxel beside = voxel;
            beside[axis] += 2 * side - 1;
            if (std::find(all.begin(), all.end(), beside) != all.end()) {
                continue;
            }
            std::array<std::uint32_t, 4> corner{};
            for (std::size_t i = 0; i < 4; ++i) {
                Voxel at = voxel;
                at[axis] += side;
                at[(axis + 1) % 3] += i == 1 || i == 2 ? 1 : 0;
                at[(axis + 2) % 3] += i >= 2 ? 1 : 0;
                const auto [found, isNew] = number.try_emplace(at, static_cast<std::uint32_t>(mesh.vertices.size()));
                if (isNew) {
                    mesh.vertices.push_back(Vec3(at[0], at[1], at[2]));
                }
                corner[i] = found->second;
            }
            if (side == 0) {
                std::swap(corner[1], corner[3]);
            }
            mesh.triangles.push_back({corner[0], corner[1], corner[2]});
            mesh.triangles.push_back({corner[0], corner[2], corner[3]});
        }
    }
    return mesh;
}

/// Sets the god-object to a position, without contacts.
void putTo(Palpator& palpator, const Vec3& p_WG)
{
    haptics::PalpatorState state;
    state.layers[0].p_WG = p_WG;
    state.layers[0].placed = 1;
    palpator.restore(state);
}

} // namespace

class LegalMoves : public QObject
{
    Q_OBJECT

    static geometry::TriangleMesh crossingBoxes()
    {
        geometry::TriangleMesh mesh = box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 3);
        append(mesh, box(Vec3(-4, -4, 3), Vec3(16, 5, 17), 2));
        return mesh;
    }

  private Q_SLOTS:
    void noLegalMoveComesCloserAndNothingPopsThrough_data()
    {
        QTest::addColumn<geometry::TriangleMesh>("mesh");
        QTest::addColumn<double>("size");
        QTest::addColumn<bool>("hasHollows");
        QTest::newRow("bumpy sphere") << bumpySphere(10, 10.0, 0.08) << 10.0 << true;
        QTest::newRow("box") << box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 3) << 10.0 << false;
        QTest::newRow("crossing boxes") << crossingBoxes() << 12.0 << true;
        QTest::newRow("groove of 10 degrees") << groove(std::numbers::pi / 18, 10.0, 12.0) << 10.0 << true;
    }
    void noLegalMoveComesCloserAndNothingPopsThrough()
    {
        QFETCH(geometry::TriangleMesh, mesh);
        QFETCH(double, size);
        QFETCH(bool, hasHollows);
        const RepairedMesh r = geometry::repair(mesh);
        const HapticScene scene({HapticStructure{
            "it", std::make_shared<geometry::SurfaceIndex>(geometry::SurfaceIndex::build(r)), {0.5, 0.0}, 0}});
        const double skin = scene.structures()[0].surface->skin_mm();
        std::mt19937 random(5);
        std::normal_distribution<double> normal;
        int contacts = 0, several = 0;
        for (int path = 0; path < 15; ++path) {
            Palpator palpator;
            palpator.borrowScene(&scene);
            Vec3 hip = 2.5 * size * Vec3(normal(random), normal(random), normal(random)).normalized();
            Vec3 aim = hip;
            for (int i = 0; i < 150; ++i) {
                // Moves towards one point in the solid, then another: pressing, sliding, leaving.
                if (i % 30 == 0) {
                    aim = 0.9 * size * Vec3(normal(random), normal(random), normal(random)).normalized();
                }
                hip += 0.06 * (aim - hip) +
                       0.02 * size * Vec3(normal(random), normal(random), normal(random)) * (i % 7 == 0);
                const TickResult t = palpator.step(hip, 1e-3);
                QCOMPARE(int(t.status), int(TickStatus::Converged));
                if (t.constraints == 0) {
                    QVERIFY((t.p_WG - hip).norm() <= 1e-12);
                    continue;
                }
                ++contacts;
                several += t.constraints > 1 ? 1 : 0;
                QVERIFY2(winding(r, t.p_WG) < 0.9, qPrintable(QString("path %1 tick %2 is inside").arg(path).arg(i)));
                const double spring = (hip - t.p_WG).norm();
                const Vec3 straight = (hip - t.p_WG) / spring;
                for (int q = 0; q < 60; ++q) {
                    const Vec3 u =
                        (straight * std::abs(normal(random)) + Vec3(normal(random), normal(random), normal(random)))
                            .normalized();
                    const double along = u.dot(straight);
                    for (const double share : {1.0, 0.1, 0.01}) {
                        const Vec3 to = t.p_WG + u * (along * spring * share);
                        if (along > 0.0 && spring - (hip - to).norm() > 1e-6) {
                            QVERIFY2(isBlocked(r, t.p_WG, to),
                                     qPrintable(QString("path %1 tick %2: %3 mm closer, %4 constraints")
                                                    .arg(path)
                                                    .arg(i)
                                                    .arg(spring - (hip - to).norm())
                                                    .arg(t.constraints)));
                        }
                    }
                }
            }
        }
        QVERIFY(contacts > 500);
        QVERIFY(!hasHollows || several > 10);
        QVERIFY(skin < 1e-8);
    }

    /// Rounding places the god-object slightly behind both walls, where it could pass either wall past the edge of the
    /// other.
    void aPointPutOnAHollowEdgeIsHeldByItsWalls()
    {
        std::mt19937 random(7);
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> share(-1.0, 1.0);
        int moves = 0;
        for (int way = 0; way < 60; ++way) {
            // of the opening angle
            const double half = (10.0 + 70.0 * std::abs(share(random))) * std::numbers::pi / 180.0;
            const Eigen::Quaterniond turn =
                Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
            const Vec3 shift = 50.0 * Vec3(normal(random), normal(random), normal(random));
            const auto placed = [&](const Vec3& p) { return Vec3(turn * p + shift); };
            const HapticScene scene(
                {HapticStructure{"block", indexed(transformed(groove(2.0 * half, 10.0, 12.0), placed)), {}, 0}});
            for (int i = 0; i < 200; ++i) {
                const Vec3 on(0.0, 11.0 * share(random), 0.0);
                // Into the block: below the walls, whose slope is the cotangent of the half opening, and not out at an
                // end.
                const Vec3 by(4.0 * share(random), 4.0 * share(random), 4.0 * share(random));
                if (by.z() > std::abs(by.x()) / std::tan(half) - 0.01 || std::abs(on.y() + by.y()) > 11.0) {
                    continue;
                }
                Palpator palpator;
                palpator.borrowScene(&scene);
                (void)palpator.step(placed(on), 1e-3);
                const TickResult t = palpator.step(placed(on + by), 1e-3);
                const Vec3 g = turn.conjugate() * (t.p_WG - shift);
                QVERIFY2(t.constraints > 0 && g.z() > std::abs(g.x()) / std::tan(half) - 1e-6,
                         qPrintable(QString("block %1, move %2: %3 constraints").arg(way).arg(i).arg(t.constraints)));
                ++moves;
            }
        }
        QVERIFY(moves > 5000);
    }

    /// In the corner of a room, moving along one wall and almost parallel to another: rounding at the stop could place
    /// the god-object behind the first wall, and from there it could pass the floor beyond its edge.
    void aWallThatStopsAMoveLeavesNoWayPastAnother()
    {
        std::vector<Voxel> block;
        for (int i = 0; i < 7; ++i) { // a cube of eight voxels without the last
            block.push_back({(i & 1) - 1, (i >> 1 & 1) - 1, (i >> 2 & 1) - 1});
        }
        const geometry::TriangleMesh mesh = voxels(block);
        std::mt19937 random(3);
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> share;
        const auto oneOf = [&](const std::array<double, 3>& values) { return values[random() % values.size()]; };
        for (int room = 0; room < 150; ++room) {
            const Eigen::Quaterniond turn =
                Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
            const Vec3 shift = 100.0 * Vec3(normal(random), normal(random), normal(random));
            const auto placed = [&](const Vec3& p) { return Vec3(turn * p + shift); };
            const HapticScene scene({HapticStructure{"block", indexed(transformed(mesh, placed)), {}, 0}});
            const double skin = scene.structures()[0].surface->skin_mm();
            for (int way = 0; way < 200; ++way) {
                Palpator palpator;
                palpator.borrowScene(&scene);
                putTo(palpator, placed(Vec3(share(random), skin * share(random), skin)));
                const Vec3 hip(oneOf({-0.003, 0.0, -0.7}), skin * oneOf({-0.002, 0.0, 0.001}),
                               oneOf({0.0, -1.0, -0.003}));
                for (int i = 0; i < 3; ++i) {
                    const Vec3 g = turn.conjugate() * (palpator.step(placed(hip), 1e-3).p_WG - shift);
                    QVERIFY2(g.minCoeff() > -4.0 * skin, qPrintable(QString("room %1, way %2: at %3, %4, %5 mm")
                                                                        .arg(room)
                                                                        .arg(way)
                                                                        .arg(g.x())
                                                                        .arg(g.y())
                                                                        .arg(g.z())));
                }
            }
        }
    }

    /// Where many voxel walls meet in few planes, few escape directions should be tried: HIPs on voxel corners and
    /// edges, the hardest case for a point, rarely exceed the work of a tick.
    void wallsOfVoxelsSeldomSpendATicksWork()
    {
        constexpr int kWide = 6;
        std::mt19937 random(7);
        std::uniform_real_distribution<double> share;
        int contacts = 0, atBound = 0;
        for (int map = 0; map < 20; ++map) {
            std::vector<Voxel> filled;
            for (int i = 0; i < kWide * kWide * kWide; ++i) {
                if (share(random) < (map % 2 == 0 ? 0.7 : 0.5)) {
                    filled.push_back({i % kWide, i / kWide % kWide, i / kWide / kWide});
                }
            }
            const HapticScene scene({HapticStructure{"map", indexed(voxels(filled)), {}, 0}});
            Palpator palpator;
            palpator.borrowScene(&scene);
            for (int i = 0; i < 4000; ++i) {
                if (i % 20 == 0) {
                    palpator.reset();
                    (void)palpator.step(Vec3(12.0 * share(random) - 3.0, -3.0, -3.0), 1e-3);
                }
                Vec3 hip;
                for (double& coordinate : hip) {
                    coordinate = std::floor(share(random) * (kWide + 1));
                }
                if (share(random) < 0.6) {
                    hip[static_cast<int>(random() % 3)] += share(random);
                }
                const TickResult t = palpator.step(hip, 1e-3);
                contacts += t.constraints > 0 ? 1 : 0;
                atBound += t.status == TickStatus::IterationLimit ? 1 : 0;
            }
        }
        QVERIFY(contacts > 60000);
        QVERIFY2(atBound <= 20, qPrintable(QString("%1 of 80,000").arg(atBound)));
    }

    void aSoupIsFeltLikeTheWeldedSurface()
    {
        const geometry::TriangleMesh mesh = bumpySphere(12, 20.0, 0.05);
        const HapticScene welded({HapticStructure{"welded", indexed(mesh), {}, 0}});
        const HapticScene loose({HapticStructure{"loose", indexed(soup(mesh)), {}, 0}});
        Palpator one, two;
        one.borrowScene(&welded);
        two.borrowScene(&loose);
        for (int i = 0; i < 1000; ++i) {
            const double a = 5e-3 * i;
            const Vec3 hip = (i < 40 ? 24 - 0.2 * i : 16) * Vec3(std::cos(a), std::sin(a) * 0.8, std::sin(a) * 0.6);
            QVERIFY((one.step(hip, 1e-3).p_WG - two.step(hip, 1e-3).p_WG).norm() < 1e-9);
        }
    }
};

PALPATE_TEST(LegalMoves)
#include "tst_LegalMoves.moc"
