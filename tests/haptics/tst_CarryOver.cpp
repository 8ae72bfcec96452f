// SPDX-License-Identifier: BSD-3-Clause
#include "Known.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/haptics/Palpator.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

using namespace palpate;
using namespace palpate::test;
using haptics::HapticScene;
using haptics::HapticStructure;
using haptics::Palpator;

namespace {

using Map = std::function<Vec3(const Vec3&)>;
using Scene = std::unique_ptr<HapticScene>;

constexpr double kStiffness_N_per_mm = 0.5;

HapticStructure structure(const geometry::TriangleMesh& mesh, const std::string& name = {}, std::uint32_t layer = 0)
{
    HapticStructure out;
    out.name = name;
    out.surface = indexed(mesh);
    out.tissue.stiffness_N_per_mm = kStiffness_N_per_mm;
    out.layer = layer;
    return out;
}

HapticStructure hidden(HapticStructure one)
{
    one.surface = nullptr;
    return one;
}

Scene sceneOf(std::vector<HapticStructure> structures, double fingertip_mm = 0.0)
{
    return std::make_unique<HapticScene>(std::move(structures), fingertip_mm);
}

geometry::TriangleMesh gridBlock(int n = 4)
{
    return box(Vec3(-50, -50, -40), Vec3(50, 50, 0), n);
}

Map moved(const Vec3& by)
{
    return [by](const Vec3& p) { return Vec3(p + by); };
}

/// Returns a rotation about the y axis; positive angles raise +x.
Map turned(double angle)
{
    return [angle](const Vec3& p) {
        return Vec3(std::cos(angle) * p.x() - std::sin(angle) * p.z(), p.y(),
                    std::sin(angle) * p.x() + std::cos(angle) * p.z());
    };
}

geometry::TriangleMesh insideOut(geometry::TriangleMesh mesh)
{
    for (geometry::Triangle& t : mesh.triangles) {
        std::swap(t[1], t[2]);
    }
    return mesh;
}

/// Presses straight down over (10, 2) until the HIP is at `z`.
void press(Palpator& palpator, double z, double from = 4.0)
{
    for (int i = 0; from - 0.1 * i > z + 1e-9; ++i) {
        (void)palpator.step(Vec3(10, 2, from - 0.1 * i), kTick_s);
    }
    (void)palpator.step(Vec3(10, 2, z), kTick_s);
}

double force(Palpator& palpator, double z = -3.0)
{
    return palpator.step(Vec3(10, 2, z), kTick_s).f_W.z();
}

} // namespace

/// Tests contacts that persist across a change of scene.
class CarryOver : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void goesAlongWithASurfaceThatMoves_data()
    {
        QTest::addColumn<Map>("map");
        QTest::addColumn<double>("depth_mm");
        QTest::newRow("not at all") << moved(Vec3::Zero()) << 3.0;
        QTest::newRow("1 mm sideways") << moved(Vec3(1, 0, 0)) << 3.0;
        QTest::newRow("0.1 mm away") << moved(Vec3(0, 0, -0.1)) << 2.9;
        QTest::newRow("0.1 mm towards the hand") << moved(Vec3(0, 0, 0.1)) << 3.1;
        QTest::newRow("1e-6 mm towards the hand") << moved(Vec3(0, 0, 1e-6)) << 3.0;
        QTest::newRow("4 mm towards the hand") << moved(Vec3(0, 0, 4)) << 7.0; // more than 1 mm: matched by triangle
        QTest::newRow("4 mm and sideways") << moved(Vec3(-2, 1, 3)) << 6.0;
        QTest::newRow("turned by 0.1 degrees") << turned(0.1 * 3.14159265358979 / 180.0) << 3.0 + 0.0174533;
        QTest::newRow("turned by 3 degrees")
            << turned(3.0 * 3.14159265358979 / 180.0) << (10.0 * 0.0523360 + 3.0 * 0.9986295);
        QTest::newRow("3 % larger") << Map([](const Vec3& p) {
            return Vec3(1.03 * (p + Vec3(0, 0, 40)) - Vec3(0, 0, 40));
        }) << 4.2;
    }
    void goesAlongWithASurfaceThatMoves()
    {
        QFETCH(const Map, map);
        QFETCH(const double, depth_mm);
        for (const double radius_mm : {0.0, 2.0}) {
            for (const bool isOpen : {false, true}) {
                const auto mesh = isOpen ? sheet(50.0, 4) : gridBlock();
                const Scene before = sceneOf({structure(mesh)}, radius_mm);
                const Scene after = sceneOf({structure(transformed(mesh, map))}, radius_mm);
                Palpator palpator;
                palpator.borrowScene(before.get());
                press(palpator, radius_mm - 3.0);
                QVERIFY(!palpator.borrowScene(after.get()));
                if (isOpen && std::abs(depth_mm - 4.2) < 1e-9) {
                    continue; // a sheet through z = 0 scales differently
                }
                const auto tick = palpator.step(Vec3(10, 2, radius_mm - 3.0), kTick_s);
                // the contact point of a ball differs
                const double turn = std::abs(tick.n_W.z() - 1.0) > 1e-3 ? 0.02 : 0.001;
                QVERIFY2(std::abs(tick.f_W.norm() - kStiffness_N_per_mm * depth_mm) <= turn,
                         qPrintable(QString("%1 N, radius %2").arg(tick.f_W.norm()).arg(radius_mm)));
            }
        }
    }

    /// A floor rises by 0.2 mm below an overhang of 10 degrees: a ball that touches both would have to move by 1.15 mm.
    void isNotMovedFartherThanAMillimetre()
    {
        const double radius_mm = 8.0, angle = 10.0 * 3.14159265358979 / 180.0;
        const auto overhang = transformed(box(Vec3(-200, -50, 0), Vec3(200, 50, 60), 8), [&](const Vec3& p) {
            return Vec3(std::cos(angle) * p.x() + std::sin(angle) * p.z(), p.y(),
                        20 - std::sin(angle) * p.x() + std::cos(angle) * p.z());
        });
        const auto floor = box(Vec3(-200, -50, -40), Vec3(200, 50, 0), 4);
        const HapticStructure stays = structure(overhang, "overhang");
        const Scene before = sceneOf({structure(floor, "floor"), stays}, radius_mm);
        const Scene after = sceneOf({structure(transformed(floor, moved(Vec3(0, 0, 0.2))), "floor"), stays}, radius_mm);
        Palpator palpator;
        palpator.borrowScene(before.get());
        for (int i = 0; i <= 100; ++i) {
            (void)palpator.step(Vec3(-60 + 1.2 * i, 2, 9 - 0.02 * i), kTick_s);
        }
        const auto tick = palpator.step(Vec3(60, 2, 7), kTick_s);
        QCOMPARE(tick.constraints, 2U);
        QVERIFY(!palpator.borrowScene(after.get()));
        const Vec3 by = palpator.state().layers[0].p_WG - tick.p_WG;
        QVERIFY2(by.norm() <= 1.0 + 1e-6, qPrintable(QString::number(by.norm())));
        const auto next = palpator.step(Vec3(60, 2, 7), kTick_s);
        QVERIFY(next.f_W.allFinite() && (next.p_WG - tick.p_WG).norm() < 1.0 + 1e-6);
    }

    /// A point in a groove of 60 degrees, whose faces' normals are 120 degrees apart, and the same triangles reversed.
    void aSharpGrooveKeepsItsSide()
    {
        for (const bool isTurned : {false, true}) {
            auto groove = transformed(sheet(50.0, 4), [](const Vec3& p) {
                return Vec3(0.5 * p.x(), p.y(), std::sqrt(0.75) * std::abs(p.x()));
            });
            if (isTurned) {
                groove = insideOut(groove);
            }
            auto reversed = groove;
            std::reverse(reversed.triangles.begin(), reversed.triangles.end());
            const Scene before = sceneOf({structure(groove)}), after = sceneOf({structure(reversed)});
            Palpator palpator;
            palpator.borrowScene(before.get());
            const auto press = [&](double z) { return palpator.step(Vec3(0.1, 2, z), kTick_s); };
            for (int i = 0; i <= 80; ++i) {
                (void)press(4.0 - 0.1 * i);
            }
            const auto was = press(-4.0);
            QCOMPARE(was.constraints, 2U);
            QVERIFY(!palpator.borrowScene(after.get()));
            QCOMPARE(palpator.state().layers[0].p_WG, was.p_WG);
            const auto is = press(-4.0);
            QVERIFY2((is.p_WG - was.p_WG).norm() < 1e-9, qPrintable(QString::number(is.p_WG.z())));
        }
    }

    /// A ball that starts too near to two surfaces stays where it is when both are replaced by the same shapes.
    void aBallThatWasTooNearAlreadyIsNotMoved()
    {
        const auto ceiling = [](int n) { return box(Vec3(-50, -50, 15.2), Vec3(50, 50, 50), n); };
        const double radius_mm = 8.0;
        const Scene before = sceneOf({structure(gridBlock(4)), structure(ceiling(4))}, radius_mm);
        const Scene after = sceneOf({structure(gridBlock(5)), structure(ceiling(3))}, radius_mm);
        Palpator palpator;
        palpator.borrowScene(before.get());
        const Vec3 start(10, 2, 7.5); // 0.5 mm too near to one, 0.3 mm to the other
        (void)palpator.step(start, kTick_s);
        QVERIFY(!palpator.borrowScene(after.get()));
        QCOMPARE(palpator.state().layers[0].p_WG, start);
    }

    /// A floor rises by 0.2 mm under a ball that also touches an overhang of 45 degrees, which does not change.
    void isNotLiftedIntoASurfaceThatStays()
    {
        const double radius_mm = 8.0, r2 = std::sqrt(0.5);
        // The overhang contains the positions with x + z >= 20 near the floor.
        const auto overhang = transformed(box(Vec3(0, -50, -100), Vec3(60, 50, 100), 4), [&](const Vec3& p) {
            return Vec3(20 + r2 * (p.x() - p.z()), p.y(), r2 * (p.x() + p.z()));
        });
        const HapticStructure stays = structure(overhang, "overhang");
        const Scene before = sceneOf({structure(gridBlock(), "floor"), stays}, radius_mm);
        const Scene after =
            sceneOf({structure(transformed(gridBlock(), moved(Vec3(0, 0, 0.2))), "floor"), stays}, radius_mm);
        Palpator palpator;
        palpator.borrowScene(before.get());
        for (int i = 0; i <= 100; ++i) {
            (void)palpator.step(Vec3(-20 + 0.4 * i, 2, 9 - 0.05 * i), kTick_s);
        }
        const Vec3 was = palpator.state().layers[0].p_WG;
        QVERIFY(std::abs(was.z() - radius_mm) < 1e-6);
        QVERIFY(std::abs(r2 * (20 - was.x() - was.z()) - radius_mm) < 1e-6);
        QVERIFY(!palpator.borrowScene(after.get()));
        const Vec3 is = palpator.state().layers[0].p_WG;
        QVERIFY2((is - was - Vec3(-0.2, 0, 0.2)).norm() < 1e-6,
                 qPrintable(QString("%1 %2").arg(is.x() - was.x()).arg(is.z() - was.z())));
    }

    /// A surface with another mesh, as after smoothing at another density: no triangle correspondence.
    void isPutInFrontOfASurfaceOfAnotherMesh()
    {
        for (const double radius_mm : {0.0, 2.0}) {
            for (const double rise_mm : {0.05, 0.5, 0.95, 1.2}) {
                const Scene before = sceneOf({structure(gridBlock(4))}, radius_mm);
                const Scene after = sceneOf({structure(test::moved(gridBlock(7), Vec3(0, 0, rise_mm)))}, radius_mm);
                Palpator palpator;
                palpator.borrowScene(before.get());
                press(palpator, radius_mm - 3.0);
                palpator.borrowScene(after.get());
                const double felt = force(palpator, radius_mm - 3.0);
                if (rise_mm < 1.0) {
                    QVERIFY2(std::abs(felt - kStiffness_N_per_mm * (3.0 + rise_mm)) < 1e-3,
                             qPrintable(QString::number(felt)));
                } else if (radius_mm == 0.0) {
                    QCOMPARE(felt, 0.0); // farther than 1 mm: released
                }
            }
        }
    }

    /// A hand just above the surface is not enclosed either.
    void aHandAboveIsPutInFront()
    {
        const Scene before = sceneOf({structure(gridBlock(4))}),
                    after = sceneOf({structure(test::moved(gridBlock(7), Vec3(0, 0, 0.1)))});
        Palpator palpator;
        palpator.borrowScene(before.get());
        press(palpator, 0.05);
        palpator.borrowScene(after.get());
        QVERIFY(std::abs(force(palpator, 0.05) - 0.5 * 0.05) < 1e-6);
        QVERIFY(std::abs(force(palpator, -1.0) - 0.5 * 1.1) < 1e-6);
    }

    void theSideOfASheetOutlastsWhateverMovesIt()
    {
        for (const bool isFlipped : {false, true}) {
            for (const double by : {-0.3, 0.0, 0.3}) {
                auto mesh = test::moved(sheet(50.0, 4), Vec3(0, 0, by));
                mesh = isFlipped ? insideOut(mesh) : mesh;
                const Scene before = sceneOf({structure(sheet(50.0, 4))}), after = sceneOf({structure(mesh)});
                Palpator palpator;
                palpator.borrowScene(before.get());
                press(palpator, -3.0);
                palpator.borrowScene(after.get());
                QVERIFY(std::abs(force(palpator) - 0.5 * (3.0 + by)) < 1e-3);
                for (int i = 0; i < 60; ++i) {
                    QVERIFY(force(palpator, -3.0 + 0.1 * i) >= 0.0); // never an inward pull
                }
                QCOMPARE(force(palpator, 3.0), 0.0);
            }
        }
    }

    /// A structure that newly encloses the god-object, or enclosed it before, exerts no force until the god-object
    /// leaves.
    void whatItWasInsideOfLetsItOut()
    {
        const Scene before = sceneOf({structure(gridBlock(4))}),
                    after = sceneOf({structure(test::moved(gridBlock(7), Vec3(0, 0, 0.1)))});
        const Scene other = sceneOf({structure(gridBlock(4), "another")});
        Palpator palpator;
        palpator.borrowScene(before.get());
        (void)palpator.step(Vec3(10, 2, -0.5), kTick_s); // starts inside
        palpator.borrowScene(after.get());
        QCOMPARE(force(palpator, -0.5), 0.0);
        palpator.borrowScene(nullptr);
        (void)palpator.step(Vec3(10, 2, -0.5), kTick_s);
        palpator.borrowScene(other.get());
        QCOMPARE(force(palpator, -0.5), 0.0);
    }

    void aHiddenStructureGivesItsContactBack_data()
    {
        QTest::addColumn<int>("ticks");
        QTest::addColumn<double>("z");
        QTest::addColumn<bool>("isOpen");
        QTest::addColumn<bool>("isBack");
        for (const bool isOpen : {false, true}) {
            QTest::addRow("%s, at once", isOpen ? "sheet" : "block") << 0 << -3.0 << isOpen << true;
            QTest::addRow("%s, 0.5 s later", isOpen ? "sheet" : "block") << 500 << -3.0 << isOpen << true;
            QTest::addRow("%s, 2 mm off", isOpen ? "sheet" : "block") << 100 << -5.0 << isOpen << true;
            QTest::addRow("%s, 0.6 s later", isOpen ? "sheet" : "block") << 600 << -3.0 << isOpen << isOpen;
            QTest::addRow("%s, 6 mm off", isOpen ? "sheet" : "block") << 100 << -9.0 << isOpen << false;
        }
    }
    void aHiddenStructureGivesItsContactBack()
    {
        QFETCH(const int, ticks);
        QFETCH(const double, z);
        QFETCH(const bool, isOpen);
        QFETCH(const bool, isBack);
        const HapticStructure touched = structure(isOpen ? sheet(50.0, 4) : gridBlock(), "touched");
        const HapticStructure other = structure(box(Vec3(100, 0, 0), Vec3(110, 10, 10)), "other");
        for (const bool isAlone : {true, false}) { // removed with or without its layer
            const Scene shown = sceneOf({other, touched});
            const Scene without =
                isAlone ? sceneOf({hidden(other), hidden(touched)}) : sceneOf({other, hidden(touched)});
            Palpator palpator, resumed;
            palpator.borrowScene(shown.get());
            press(palpator, -3.0);
            QVERIFY(!palpator.borrowScene(without.get()));
            for (int i = 0; i < ticks; ++i) {
                QCOMPARE(force(palpator, z), 0.0);
            }
            resumed.borrowScene(without.get());
            resumed.restore(palpator.state());
            QCOMPARE(palpator.borrowScene(shown.get()), isBack);
            QCOMPARE(resumed.borrowScene(shown.get()), isBack); // a recording may start in between
            const double felt = force(palpator, z);
            QVERIFY(std::abs(felt - (isBack ? -0.5 * z : 0.0)) < 1e-3);
            QVERIFY(felt == force(resumed, z));
        }
    }

    void nothingToTouchIsHiddenToo()
    {
        const Scene scene = sceneOf({structure(gridBlock(), "block")});
        Palpator palpator;
        palpator.borrowScene(scene.get());
        press(palpator, -3.0);
        palpator.borrowScene(nullptr);
        QCOMPARE(force(palpator), 0.0);
        QVERIFY(palpator.borrowScene(scene.get()));
        QVERIFY(std::abs(force(palpator) - 1.5) < 1e-3);
        palpator.borrowScene(nullptr);
        palpator.reset(); // a new hand
        QVERIFY(!palpator.borrowScene(scene.get()));
        QCOMPARE(force(palpator), 0.0);
    }

    void oldRecordingsKeepTheirRules()
    {
        const Scene before = sceneOf({structure(gridBlock())}),
                    after = sceneOf({structure(test::moved(gridBlock(), Vec3(0, 0, 0.1)))});
        Palpator palpator;
        palpator.borrowScene(before.get());
        press(palpator, -3.0);
        palpator.borrowScene(after.get(), haptics::Continuity::Places);
        QCOMPARE(force(palpator), 0.0);
    }
};

PALPATE_TEST(CarryOver)
#include "tst_CarryOver.moc"
