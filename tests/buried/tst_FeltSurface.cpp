// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/buried/FeltSurface.h>
#include <palpate/buried/LumpShape.h>

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

using namespace palpate;
using buried::BuriedLump;
using buried::ContactPlace;
using buried::FeltOptions;
using buried::LumpShape;
using core::Vec3;
using geometry::RepairedMesh;

class FeltSurface : public QObject
{
    Q_OBJECT

    static constexpr double kRadius_mm = 5.0;
    static constexpr double kPi = 3.14159265358979323846;

    static std::shared_ptr<const RepairedMesh> made(const geometry::TriangleMesh& mesh)
    {
        return std::make_shared<const RepairedMesh>(geometry::repair(mesh, geometry::Facing::AsGiven));
    }
    /// A ball of triangles with the volume of a true one.
    static geometry::TriangleMesh ball(int n, double radius_mm, const Vec3& at)
    {
        const RepairedMesh flat = geometry::repair(test::sphere(n, radius_mm));
        const double by = std::cbrt(4.0 / 3.0 * kPi * std::pow(radius_mm, 3) / flat.report.volume_mm3);
        return test::moved(test::sphere(n, by * radius_mm), at);
    }
    static double shareOf(const geometry::TriangleMesh& mesh, const ContactPlace& place, double press_mm = 0.0,
                          std::size_t most = 0)
    {
        const LumpShape lump(*made(mesh), most);
        double share = -1.0;
        lump.shares(place, std::span(&press_mm, 1), std::span(&share, 1));
        return share;
    }
    static ContactPlace top() { return {Vec3::Zero(), Vec3::UnitZ(), kRadius_mm}; }

    /// An organ in which the model holds on its top: 160 mm wide.
    static std::shared_ptr<const RepairedMesh> organ()
    {
        static const auto kOrgan = made(test::sphere(48, 80.0));
        return kOrgan;
    }
    static core::Result<buried::FeltSurface> felt(const std::vector<BuriedLump>& lumps, const FeltOptions& how = {})
    {
        return buried::feltSurface("organ", *organ(), lumps, how);
    }
    static BuriedLump lumpAt(const Vec3& at, double radius_mm = 10.0, double ratio = 4.4)
    {
        return {"lump", made(ball(16, radius_mm, at)), ratio};
    }

    /// The result for a lump 8 mm below the top of the organ, computed once.
    static const buried::FeltSurface& feltNearTheTop()
    {
        static const auto kFelt = felt({lumpAt(Vec3(0.0, 0.0, 62.0))});
        return kFelt.value();
    }

  private Q_SLOTS:
    /// The haptic surface consists of the organ's triangles: if these are too wide for a lump, the error is reported.
    void aCoarseOrganSaysByHowMuchItIsFeltOtherwise()
    {
        const std::vector<BuriedLump> lumps{lumpAt(Vec3(0.0, 0.0, 48.0), 6.0)};
        double before = 0.0;
        for (const int n : {32, 16, 12}) { // edges of 2.5, 5 and 6.6 mm
            auto mesh = test::sphere(n, 60.0);
            const Eigen::AngleAxisd turn(0.7, Vec3(1.0, 2.0, 3.0).normalized()); // no vertex just over the lump
            for (Vec3& v : mesh.vertices) {
                v = turn * v;
            }
            const auto coarse = buried::feltSurface("organ", *made(mesh), lumps);
            QVERIFY(coarse.isOk());
            const buried::FeltSurface& felt = coarse.value();
            const bool isSaid = std::any_of(felt.notes.begin(), felt.notes.end(), [](const core::Message& note) {
                return note.english().find("organ: its triangles are wider") == 0;
            });
            QVERIFY2(n == 32 ? felt.interpolationError == 0.0 : felt.interpolationError > 1.5 * before,
                     qPrintable(QString::number(felt.interpolationError)));
            QCOMPARE(isSaid, n == 12);
            before = felt.interpolationError;
        }
        QVERIFY2(before > 0.08 && before < 0.13, qPrintable(QString::number(before))); // 10.4 %, by a separate search
    }

    void aBallHoldsWhatTheQuadratureSays_data()
    {
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("cover");
        for (const double radius : {2.5, 5.0, 10.0, 15.0}) {
            for (const double cover : {1.0, 2.5, 5.0, 15.0}) {
                QTest::addRow("radius %g mm, %g mm below", radius, cover) << radius << cover;
            }
        }
        QTest::addRow("half above the surface") << 6.0 << -6.0;
        QTest::addRow("touches the surface") << 6.0 << 0.0;
        QTest::addRow("around the finger") << 20.0 << -19.0;
    }
    void aBallHoldsWhatTheQuadratureSays()
    {
        QFETCH(const double, radius);
        QFETCH(const double, cover);
        const double depth = radius + cover;
        const double share = shareOf(ball(48, radius, Vec3(0.0, 0.0, -depth)), top());
        const double exact = buried::shareOfSphere(radius, depth, kRadius_mm);
        QVERIFY2(std::abs(share - exact) < 1e-3 * (cover < 0.0 ? 3.0 * exact : exact),
                 qPrintable(QString("%1, exact %2").arg(share, 0, 'g', 8).arg(exact, 0, 'g', 8)));
        const double coarse = shareOf(ball(48, radius, Vec3(0.0, 0.0, -depth)), top(), 0.0, 500);
        QVERIFY2(std::abs(coarse - exact) < 0.03 * exact, qPrintable(QString::number(coarse / exact)));
    }

    void aLumpIsTheSameFromAfar()
    {
        const geometry::TriangleMesh lump = test::transformed(ball(24, 10.0, Vec3::Zero()), [](const Vec3& p) {
            return Vec3(1.6 * p.x() + 0.02 * p.x() * p.x(), p.y(), 0.7 * p.z());
        });
        for (const double away : {38.0, 60.0, 90.0}) {
            for (const Vec3& direction : {Vec3(0.0, 0.0, -1.0), Vec3(0.5, 0.3, -0.8)}) {
                const auto there = test::moved(lump, away * direction.normalized());
                const double all = shareOf(there, top(), 2.0), few = shareOf(there, top(), 2.0, 500);
                QVERIFY2(std::abs(few - all) < 0.01 * std::max(all, LumpShape::kLeastShare),
                         qPrintable(QString("%1 %2").arg(all).arg(few)));
            }
        }
    }

    void aSlabHoldsWhatTheFormulaSays()
    {
        const double depth = 5.0;
        const auto slab = test::box(Vec3(-400.0, -400.0, -400.0), Vec3(400.0, 400.0, -depth));
        const double share = shareOf(slab, top());
        // The field beyond 400 mm is missing: about 8 a / (pi 400) of the far field.
        QVERIFY2(std::abs(share - buried::shareBelow(depth, kRadius_mm)) < 2e-2, qPrintable(QString::number(share)));
        const double less = shareOf(test::box(Vec3(-400.0, -400.0, -400.0), Vec3(400.0, 400.0, -50.0)), top());
        QVERIFY(std::abs(share - less -
                         (buried::shareBelow(depth, kRadius_mm) - buried::shareBelow(50.0, kRadius_mm))) < 2e-3);
    }

    void aPoseChangesNothing()
    {
        const core::Transform X = core::Transform(Eigen::Translation3d(31.0, -7.0, 112.0) *
                                                  Eigen::AngleAxisd(0.7, Vec3(0.2, 0.5, -0.9).normalized()));
        geometry::TriangleMesh lump = ball(12, 6.0, Vec3(3.0, 1.0, -9.0));
        const double there = shareOf(lump, top(), 2.0);
        for (Vec3& v : lump.vertices) {
            v = X * v;
        }
        const ContactPlace place{X * Vec3::Zero(), X.linear() * Vec3::UnitZ(), kRadius_mm};
        QVERIFY(there > 0.01 && std::abs(shareOf(lump, place, 2.0) - there) < 1e-12);
    }

    void pressingComesNearer()
    {
        const geometry::TriangleMesh lump = ball(32, 10.0, Vec3(0.0, 0.0, -18.0));
        const std::array<std::array<double, 2>, 4> known{{{0.0, 9.77}, {2.0, 13.34}, {4.0, 18.76}, {6.0, 27.39}}};
        for (const auto& [press, percent] : known) {
            const double felt = buried::stiffening(shareOf(lump, top(), press), 3.0).estimate;
            QVERIFY2(std::abs(100.0 * (felt - 1.0) - percent) < 0.15, qPrintable(QString::number(felt)));
        }
    }

    void aLumpIsFeltMostAtTheFootOfItsAxis()
    {
        const buried::FeltSurface& m = feltNearTheTop();
        QVERIFY(m.notes.empty() && m.lumps.size() == 1);
        QVERIFY2(std::abs(m.lumps[0].minCover_mm - 8.0) < 0.3, std::to_string(m.lumps[0].minCover_mm).c_str());
        for (std::size_t press = 0; press < m.press.size(); ++press) {
            const auto& one = m.lumps[0].press[press];
            QVERIFY(one.best.has_value());
            QVERIFY((m.surface.vertices[*one.best] - Vec3(0.0, 0.0, 80.0)).norm() < 2.5);
            QVERIFY(one.felt.low < one.felt.estimate && one.felt.estimate < one.felt.high);
            QVERIFY(press == 0 || one.felt.estimate > m.lumps[0].press[press - 1].felt.estimate);
            QVERIFY(one.area_mm2[0] >= one.area_mm2[1] && one.area_mm2[1] >= one.area_mm2[2]);
        }
        // For a flat half-space the result is shareOfSphere; the curvature of the organ reduces the value slightly.
        const double share = buried::shareOfSphere(10.0, 18.0, kRadius_mm);
        const double flat = buried::stiffening(share, 4.4).estimate;
        QVERIFY(std::abs(m.lumps[0].press[0].felt.estimate - flat) < 0.05 * (flat - 1.0));
        QVERIFY(m.lumps[0].press[0].verdict == buried::Verdict::NotByHand);
        QVERIFY(m.lumps[0].press[1].verdict == buried::Verdict::ByTrainedHand);
        QVERIFY(m.lumps[0].press[3].verdict == buried::Verdict::Plainly);
    }

    void oneThreadOrManyGiveTheSameBits()
    {
        FeltOptions how;
        how.threads = 1;
        const auto one = felt({lumpAt(Vec3(0.0, 0.0, 62.0))}, how);
        for (const unsigned threads : {2u, 3u, 7u}) {
            how.threads = threads;
            const auto many = felt({lumpAt(Vec3(0.0, 0.0, 62.0))}, how);
            for (std::size_t press = 0; press < one.value().press.size(); ++press) {
                QVERIFY(many.value().press[press].ratio == one.value().press[press].ratio);
                const auto &a = one.value().lumps[0].press[press], &b = many.value().lumps[0].press[press];
                QVERIFY(a.area_mm2 == b.area_mm2 && a.best == b.best);
            }
        }
    }

    void softAndStiffAreToldApart()
    {
        const auto soft = felt({lumpAt(Vec3(0.0, 0.0, 66.0), 10.0, 0.05)});
        const auto& press = soft.value().lumps[0].press[2];
        QVERIFY(press.felt.estimate < 0.8 && press.verdict == buried::Verdict::Plainly);
    }

    void whatIsNotFeltIsJudged()
    {
        // As soft as the organ: a best place is known, and it is not felt there.
        const auto alike = felt({lumpAt(Vec3(0.0, 0.0, 62.0), 10.0, 1.0)});
        // In the middle of 160 mm: it reaches no place of the surface.
        const auto deep = felt({lumpAt(Vec3::Zero(), 3.0)});
        for (std::size_t press = 0; press < alike.value().press.size(); ++press) {
            QVERIFY(alike.value().lumps[0].press[press].verdict == buried::Verdict::NotByHand);
            QVERIFY(!deep.value().lumps[0].press[press].best.has_value());
            QVERIFY(deep.value().lumps[0].press[press].verdict == buried::Verdict::NotByHand);
        }
    }

    void whereTheModelDoesNotHoldIsSaid()
    {
        // A finger of 25 mm on a ball of 80 mm: curved everywhere.
        FeltOptions wide;
        wide.radius_mm = 25.0;
        const auto curved = felt({lumpAt(Vec3(0.0, 0.0, 62.0))}, wide);
        QVERIFY(std::all_of(curved.value().notJudged.begin(), curved.value().notJudged.end(),
                            [](std::uint8_t why) { return (why & buried::kCurved) != 0; }));
        QVERIFY(curved.value().lumps[0].press[0].verdict == buried::Verdict::NotJudged);
        // With 5 mm nowhere.
        const auto& fine = feltNearTheTop().notJudged;
        const auto curvedPlaces = std::count_if(fine.begin(), fine.end(), [](std::uint8_t why) { return why != 0; });
        QVERIFY2(curvedPlaces == 0, std::to_string(curvedPlaces).c_str());
        // A plate of 15 mm is thin, its middle is not curved, its edges are.
        const auto plate = made(test::box(Vec3(-35.0, -35.0, -15.0), Vec3(35.0, 35.0, 0.0)));
        const BuriedLump lump{"lump", made(ball(8, 3.0, Vec3(0.0, 0.0, -7.5))), 4.4};
        const auto thin = buried::feltSurface("plate", *plate, {lump});
        QVERIFY(thin.isOk());
        for (std::size_t v = 0; v < thin.value().surface.vertices.size(); ++v) {
            const Vec3& p = thin.value().surface.vertices[v];
            const std::uint8_t why = thin.value().notJudged[v];
            if (std::abs(p.x()) < 15.0 && std::abs(p.y()) < 15.0) {
                QCOMPARE(int(why), int(buried::kThin));
            } else if (std::abs(p.x()) > 32.0 || std::abs(p.y()) > 32.0) {
                QVERIFY((why & buried::kCurved) != 0);
            }
        }
    }

    void aCoarseOrganIsRefined()
    {
        const auto block = made(test::box(Vec3(-15.0, -20.0, -40.0), Vec3(35.0, 30.0, 0.0)));
        const BuriedLump lump{"lump", made(ball(12, 10.0, Vec3(10.0, 5.0, -15.0))), 4.4};
        const auto map = buried::feltSurface("block", *block, {lump});
        QVERIFY(map.isOk());
        const buried::FeltSurface& m = map.value();
        QVERIFY(m.surface.vertices.size() > 2000);
        QCOMPARE(m.organVertices, std::size_t{8});
        for (std::size_t v = 0; v < 8; ++v) {
            QVERIFY(m.surface.vertices[v] == block->mesh.vertices[v]);
        }
        for (const geometry::Triangle& t : m.surface.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                QVERIFY((m.surface.vertices[t[k]] - m.surface.vertices[t[(k + 1) % 3]]).norm() <= 2.5 + 1e-9);
            }
        }
        const auto& best = m.lumps[0].press[0];
        QVERIFY((m.surface.vertices[best.best.value()] - Vec3(10.0, 5.0, 0.0)).norm() < 2.5);
        const double flat = buried::stiffening(buried::shareOfSphere(10.0, 15.0, kRadius_mm), 4.4).estimate;
        QVERIFY(std::abs(best.felt.estimate - flat) < 0.05 * (flat - 1.0));
    }

    void badInputIsNamed()
    {
        geometry::TriangleMesh open = ball(8, 5.0, Vec3(0.0, 0.0, 65.0));
        open.triangles.pop_back();
        geometry::TriangleMesh inward = ball(8, 5.0, Vec3(0.0, 0.0, 65.0));
        geometry::flip(inward);
        const BuriedLump good = lumpAt(Vec3(0.0, 0.0, 62.0));
        const auto some = felt({good,
                                {"open", made(open), 2.0},
                                {"inward", made(inward), 2.0},
                                {"outside", made(ball(8, 5.0, Vec3(0.0, 0.0, 120.0))), 2.0}});
        QVERIFY(some.isOk());
        QCOMPARE(some.value().lumps.size(), std::size_t{1});
        QCOMPARE(some.value().notes.size(), std::size_t{3});
        QVERIFY(some.value().notes[0].english().find("open: left out, its surface is open") == 0);
        QVERIFY(some.value().notes[1].english().find("inward: left out, its surface is inside out") == 0);
        QVERIFY(some.value().notes[2].english().find("outside: left out, it lies outside organ") == 0);
        QVERIFY(felt({{"open", made(open), 2.0}}).status().code() == core::StatusCode::Empty);
        for (const double ratio : {0.0, -1.0, 1.1e4, std::numeric_limits<double>::quiet_NaN()}) {
            BuriedLump bad = good;
            bad.ratio = ratio;
            QVERIFY(felt({bad}).status().code() == core::StatusCode::OutOfRange);
        }
        for (const double radius : {0.0, -5.0, 1e-300, 0.01, 31.0, std::numeric_limits<double>::quiet_NaN()}) {
            FeltOptions how;
            how.radius_mm = radius;
            QVERIFY(felt({good}, how).status().code() == core::StatusCode::OutOfRange);
        }
        FeltOptions how;
        how.press_mm = {2.0, 1.0};
        QVERIFY(felt({good}, how).status().code() == core::StatusCode::OutOfRange);
        QVERIFY(buried::feltSurface("organ", *made(open), {good}).status().code() == core::StatusCode::Unsupported);
        how = {};
        how.progress = [](double) { return false; };
        QVERIFY(felt({good}, how).status().code() == core::StatusCode::Cancelled);
    }

    void overlappingLumpsAreNotJudged()
    {
        const auto map = felt({lumpAt(Vec3(0.0, 0.0, 62.0)), lumpAt(Vec3(4.0, 0.0, 62.0))});
        QVERIFY(map.isOk() && map.value().notes.size() == 1);
        for (std::size_t v = 0; v < map.value().surface.vertices.size(); ++v) {
            if (map.value().surface.vertices[v].z() > 78.0) {
                QVERIFY((map.value().notJudged[v] & buried::kOverlapping) != 0);
            }
        }
    }
};

PALPATE_TEST(FeltSurface)
#include "tst_FeltSurface.moc"
