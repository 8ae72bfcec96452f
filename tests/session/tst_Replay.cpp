// SPDX-License-Identifier: BSD-3-Clause
#include "Sessions.h"
#include "TestRunner.h"

#include <palpate/servo/ServoCore.h>
#include <palpate/session/GeometryHash.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>
#include <palpate/session/Replay.h>

#include <QTemporaryDir>

#include <bit>
#include <cmath>

using namespace palpate;
using core::Vec3;

class Replay : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    std::filesystem::path path(const char* name) const { return m_folder.filePath(name).toStdString(); }

    static session::Motion pressing(int ticks)
    {
        session::Motion motion;
        for (int i = 0; i < ticks; ++i) {
            const double t = i * 1e-3;
            motion.p_WH.emplace_back(5.0 * std::sin(7.0 * t), 3.0 * t, 20.5 - 2.0 * std::sin(5.0 * t));
        }
        return motion;
    }

    static std::vector<servo::TickRecord> felt(const haptics::HapticScene& scene, const session::Motion& motion)
    {
        std::vector<servo::TickRecord> ticks;
        session::replay(scene, motion, [&ticks](const servo::TickRecord& tick) {
            ticks.push_back(tick);
            return true;
        });
        return ticks;
    }

    core::Result<session::Resimulation> again(const char* name) const
    {
        const auto reader = session::RecordingReader::open(path(name));
        return reader.isOk() ? session::resimulate(*reader.value(), test::boxSurfaces()) : reader.status();
    }

    static void compareBits(const servo::TickRecord& a, const servo::TickRecord& b)
    {
        QCOMPARE(a.tick, b.tick);
        QCOMPARE(a.flags, b.flags);
        for (int axis = 0; axis < 3; ++axis) {
            QCOMPARE(std::bit_cast<std::uint64_t>(a.felt.f_W[axis]), std::bit_cast<std::uint64_t>(b.felt.f_W[axis]));
            QCOMPARE(std::bit_cast<std::uint64_t>(a.felt.p_WG[axis]), std::bit_cast<std::uint64_t>(b.felt.p_WG[axis]));
        }
    }

  private Q_SLOTS:
    void givesTheSameTicksOneByOne()
    {
        const auto plain = test::boxScene(0.5);
        auto structures = plain->structures();
        structures[0].tissue.damping_Ns_per_mm = 0.003;
        const haptics::HapticScene damped(structures);
        const auto motion = pressing(500);
        session::ReplayHand hand;
        for (const haptics::HapticScene* scene : {plain.get(), &damped, plain.get()}) {
            const auto expected = felt(*scene, motion);
            hand.borrowScene(scene);
            hand.reset();
            for (std::size_t i = 0; i < expected.size(); ++i) {
                compareBits(hand.step(motion.p_WH[i], motion.dt_s), expected[i]);
            }
        }
    }

    void givesOneTickARow()
    {
        const auto motion = pressing(10000); // longer than a batch
        const auto ticks = felt(*test::boxScene(0.5), motion);
        QCOMPARE(ticks.size(), motion.p_WH.size());
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            QCOMPARE(ticks[i].tick, static_cast<std::int64_t>(i));
            QCOMPARE(ticks[i].p_WH, motion.p_WH[i]);
        }
        QCOMPARE(ticks.front().felt.p_WG, motion.p_WH.front());
    }

    void forceIsSpringAndDamper()
    {
        constexpr double k = 0.7;
        constexpr double b = 0.002;
        const auto motion = pressing(3000);
        const auto ticks = felt(*test::boxScene(k, b), motion);
        int contacts = 0;
        for (std::size_t i = 1; i < ticks.size(); ++i) {
            const auto& tick = ticks[i];
            if (tick.p_WH.z() < 20.0) {
                ++contacts;
                QCOMPARE(tick.felt.structure, 0);
                QVERIFY(std::abs(tick.felt.p_WG.z() - 20.0) < 1e-6);
                const Vec3 v = (tick.p_WH - motion.p_WH[i - 1]) / motion.dt_s;
                QVERIFY((tick.felt.f_W - (k * (tick.felt.p_WG - tick.p_WH) - b * v)).norm() < 1e-12);
            } else if (tick.p_WH.z() > 20.001) {
                QCOMPARE(tick.felt.structure, -1);
                QCOMPARE(tick.felt.f_W, Vec3(0, 0, 0));
            }
        }
        QVERIFY(contacts > 100);
    }

    void isTheSameEachTime()
    {
        const auto motion = pressing(5000);
        const auto once = felt(*test::boxScene(0.5), motion);
        auto twice = felt(*test::boxScene(0.5), motion);
        for (std::size_t i = 0; i < once.size(); ++i) {
            twice[i].solve_ns = once[i].solve_ns;
            QVERIFY(test::isSameTick(once[i], twice[i]));
        }
    }

    void stopsWhenToldTo()
    {
        int count = 0;
        session::replay(*test::boxScene(0.5), pressing(100), [&count](const auto&) { return ++count < 10; });
        QCOMPARE(count, 10);
    }

    void aRecordingWithSceneChangeAndResetIsComputedAgainBitForBit()
    {
        const auto ticks = test::palpationTicks(3000);
        int contacts = 0;
        unsigned seen = 0;
        for (const auto& tick : ticks) {
            contacts += tick.felt.structure >= 0 ? 1 : 0;
            seen |= tick.flags;
        }
        QVERIFY(contacts > 500);
        QVERIFY((seen & servo::kReset) != 0 && (seen & servo::kNoHand) != 0 && (seen & servo::kSceneChanged) != 0);
        QVERIFY(test::writeRecording(path("a.palpate"), ticks));
        const auto result = again("a.palpate");
        QVERIFY2(result.isOk(), result.status().message().c_str());
        QVERIFY2(result.value().isSame(), result.value().difference.english().c_str());
        QCOMPARE(result.value().compared, std::int64_t{3000});
        QCOMPARE(result.value().unverified, std::int64_t{0});
    }

    /// A structure is removed under the hand, ticks are lost, and the structure returns with its contact.
    void doesNotCompareAContactOfBeforeTheLoss()
    {
        const auto box = test::boxScene(0.5), again = test::boxScene(0.5);
        auto structures = box->structures();
        structures[0].surface = nullptr;
        const haptics::HapticScene hidden(structures);
        const std::vector<session::StructureSource> sources{test::palpationScenes()[0].structures[0].source};
        servo::ServoCore core(servo::GateLimits{}, 1000.0);
        core.borrowScene(box.get(), 1);
        session::RecordingInfo info;
        info.firstGeneration = 1;
        auto writer = session::RecordingWriter::create(path("l.palpate"), info, session::RecordingWriter::Sync::AtEnd);
        QVERIFY2(writer.isOk(), writer.status().message().c_str());
        const haptics::HapticScene* const scenes[] = {box.get(), &hidden, again.get()};
        for (std::uint32_t i = 0; i < 3; ++i) {
            QVERIFY(writer.value()->addScene(session::describeScene(i + 1, *scenes[i], sources)).isOk());
        }
        bool isRestored = false;
        for (int i = 0; i < 1500; ++i) {
            if (i == 300 || i == 400) {
                core.borrowScene(i == 300 ? &hidden : again.get(), i == 300 ? 2 : 3);
            }
            device::DeviceState hand;
            hand.time_ns = std::int64_t{i} * 1'000'000;
            hand.isPresent = true;
            hand.p_D = Vec3(1, 2, 21.0 + 3.0 * std::cos(i * 0.008));
            servo::TickRecord tick = core.tick(hand, hand.time_ns);
            isRestored = isRestored || (i == 400 && tick.felt.structure == 0);
            tick.flags |= i == 320 ? servo::kDroppedBefore : 0;
            if (i < 310 || i >= 320) {
                QVERIFY(writer.value()->append(tick).isOk());
            }
        }
        QVERIFY(isRestored);
        QVERIFY(writer.value()->finish().isOk());
        const auto result = this->again("l.palpate");
        QVERIFY2(result.isOk(), result.status().message().c_str());
        QVERIFY2(result.value().isSame(), result.value().difference.english().c_str());
        QVERIFY2(result.value().unverified > 10, qPrintable(QString::number(result.value().unverified)));
        QVERIFY2(result.value().compared > 1200, qPrintable(QString::number(result.value().compared)));
    }

    void findsTheFirstTickThatDiffers_data()
    {
        QTest::addColumn<int>("tick");
        QTest::addColumn<bool>("isForce");
        for (const int tick : {0, 1, 249, 250, 420, 421, 1999}) {
            QTest::newRow(qPrintable(QString("god-object in tick %1").arg(tick))) << tick << false;
            QTest::newRow(qPrintable(QString("force in tick %1").arg(tick))) << tick << true;
        }
    }

    void findsTheFirstTickThatDiffers()
    {
        QFETCH(int, tick);
        QFETCH(bool, isForce);
        auto ticks = test::palpationTicks(2000);
        double& value = isForce ? ticks[static_cast<std::size_t>(tick)].felt.f_W.y()
                                : ticks[static_cast<std::size_t>(tick)].felt.p_WG.y();
        value = std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) ^ 1u); // the last bit
        QVERIFY(test::writeRecording(path("b.palpate"), ticks));
        const auto result = again("b.palpate");
        QVERIFY2(result.isOk(), result.status().message().c_str());
        QVERIFY(!result.value().isSame());
        QCOMPARE(*result.value().firstDifference, std::int64_t{tick});
    }

    void tellsRoundingFromAnotherWay_data()
    {
        QTest::addColumn<double>("skins");  // displacement of the god-object
        QTest::addColumn<double>("pushed"); // displacement of the force, times the stiffness
        QTest::addColumn<int>("structure");
        QTest::addColumn<int>("triangle"); // offset of the triangle's number
        QTest::addColumn<bool>("isRounding");
        QTest::newRow("a tenth of a skin") << 0.1 << 0.0 << 0 << 0 << true;
        QTest::newRow("15 skins") << 15.0 << 0.0 << 0 << 0 << true;
        QTest::newRow("17 skins") << 17.0 << 0.0 << 0 << 0 << false;
        QTest::newRow("a force as of 15 skins") << 0.0 << 15.0 << 0 << 0 << true;
        QTest::newRow("a force as of 17 skins") << 0.0 << 17.0 << 0 << 0 << false;
        QTest::newRow("the triangle alone") << 0.0 << 0.0 << 0 << 1 << true;
        QTest::newRow("a skin, and a force as of 17") << 1.0 << 17.0 << 0 << 0 << false;
        QTest::newRow("a skin, and another structure") << 1.0 << 0.0 << 1 << 0 << false;
        QTest::newRow("another structure") << 0.0 << 0.0 << 1 << 0 << false;
    }

    void tellsRoundingFromAnotherWay()
    {
        QFETCH(double, skins);
        QFETCH(double, pushed);
        QFETCH(int, structure);
        QFETCH(int, triangle);
        QFETCH(bool, isRounding);
        auto ticks = test::palpationTicks(2000);
        std::size_t at = 600; // in the second scene
        while (ticks[at].felt.structure < 0) {
            ++at;
        }
        const auto scene = session::rebuildScene(test::palpationScenes()[1], test::boxSurfaces());
        const double skin_mm = scene.value()->layer(0).skin_mm;
        QVERIFY(skin_mm > 0.0);
        ticks[at].felt.p_WG.y() += skins * skin_mm;
        ticks[at].felt.f_W.y() += pushed * skin_mm * scene.value()->structures()[0].tissue.stiffness_N_per_mm;
        ticks[at].felt.structure = structure;
        ticks[at].felt.triangle += static_cast<std::uint32_t>(triangle);
        QVERIFY(test::writeRecording(path("r.palpate"), ticks));
        const auto result = again("r.palpate");
        QVERIFY2(result.isOk(), result.status().message().c_str());
        const session::Resimulation& it = result.value();
        QVERIFY(!it.isSame());
        QCOMPARE(it.differing, std::int64_t{1});
        QCOMPARE(*it.firstDifference, ticks[at].tick);
        QCOMPARE(it.rounding_mm, 16.0 * skin_mm);
        QVERIFY2(it.isWithinRounding() == isRounding, it.beyond.english().c_str());
        if (!isRounding) {
            QCOMPARE(*it.firstBeyond, ticks[at].tick);
            const std::string what = pushed != 0.0 ? "force" : structure != 0 ? "structure" : "god-object";
            QVERIFY2(it.beyond.english().starts_with("tick " + std::to_string(ticks[at].tick) + ": " + what),
                     it.beyond.english().c_str());
        }
        if (skins > 0.0) {
            QVERIFY(std::abs(it.farthest_mm - skins * skin_mm) < 0.1 * skin_mm);
            QVERIFY2(it.difference.english().ends_with(" mm apart"), it.difference.english().c_str());
        }
    }

    void oneBuildMayTouchWhatAnotherJustMisses()
    {
        auto ticks = test::palpationTicks(2000);
        std::size_t at = 600;
        while (ticks[at].felt.structure < 0) {
            ++at;
        }
        ticks[at].felt.structure = -1; // but pressed: beyond any rounding
        ticks[at].felt.p_WG = ticks[at].p_WH;
        ticks[at].felt.f_W = Vec3::Zero();
        QVERIFY(test::writeRecording(path("m.palpate"), ticks));
        const auto pressed = again("m.palpate");
        QVERIFY2(pressed.isOk(), pressed.status().message().c_str());
        QCOMPARE(*pressed.value().firstBeyond, ticks[at].tick);

        ticks = test::palpationTicks(2000);
        ticks[at].felt.structure = -1; // the same position and force
        QVERIFY(test::writeRecording(path("m.palpate"), ticks));
        const auto grazed = again("m.palpate");
        QVERIFY2(grazed.isOk(), grazed.status().message().c_str());
        QCOMPARE(grazed.value().differing, std::int64_t{1});
        QVERIFY2(grazed.value().isWithinRounding(), grazed.value().beyond.english().c_str());
    }

    void aBuildWithChangesOfItsOwnIsNoExactOne()
    {
        QVERIFY(session::isExactBuild("aafc4961234a GNU 12.2.0 Release"));
        QVERIFY(!session::isExactBuild("aafc4961234a-dirty GNU 12.2.0 Release"));
        QVERIFY(!session::isExactBuild("unknown GNU 12.2.0 Release"));
    }

    /// Motion in encoder steps is damped by the estimated velocity; exact motion by its differences.
    void dampsAHandThatIsCounted()
    {
        const auto scene = test::boxScene(0.2, 0.005);
        for (const double step_mm : {0.0, 0.01, 0.031, 0.055, 0.12}) {
            session::Motion motion;
            for (int i = 0; i < 900; ++i) {
                const double z = 25.0 - 0.01 * i;
                motion.p_WH.emplace_back(1, 2, step_mm > 0.0 ? step_mm * std::round(z / step_mm) : z);
            }
            const double bound_N = step_mm > 0.0 ? 0.02 : 1e-9;
            int touching = 0;
            session::replay(*scene, motion, [&](const servo::TickRecord& tick) {
                if (tick.felt.structure >= 0) {
                    ++touching;
                    const core::Vec3 damper = tick.felt.f_W - 0.2 * (tick.felt.p_WG - tick.p_WH);
                    if ((damper - core::Vec3(0, 0, 0.05)).norm() > bound_N) {
                        qWarning("tick %d: %g N at %g mm", int(tick.tick), damper.z(), step_mm);
                        return false;
                    }
                }
                return true;
            });
            QVERIFY(touching > 390);
        }
    }

    void startsInTheMiddleOfATouch()
    {
        // A recording that starts during contact: its start state is the result of the earlier ticks.
        const auto motion = pressing(1000);
        const auto scene = test::boxScene(0.5, 0.001);
        haptics::Palpator palpator;
        palpator.borrowScene(scene.get());
        std::vector<servo::TickRecord> ticks;
        session::RecordingInfo info;
        for (std::size_t i = 0; i < motion.p_WH.size(); ++i) {
            if (i == 400) {
                info.start = palpator.state();
                info.firstTick = 400;
                info.firstGeneration = 1;
            }
            servo::TickRecord tick;
            tick.tick = static_cast<std::int64_t>(i);
            tick.scene = 1;
            tick.p_WH = motion.p_WH[i];
            tick.v_WH = i > 0 ? core::Vec3((motion.p_WH[i] - motion.p_WH[i - 1]) / 1e-3) : core::Vec3::Zero();
            servo::feelTick(palpator, 1e-3, tick);
            if (i >= 400) {
                ticks.push_back(tick);
            }
        }
        QVERIFY(ticks.front().felt.structure >= 0);
        {
            auto writer = session::RecordingWriter::create(path("c.palpate"), info);
            auto scenes = test::palpationScenes();
            QVERIFY(writer.value()->addScene(scenes[0]).isOk());
            for (const auto& tick : ticks) {
                QVERIFY(writer.value()->append(tick).isOk());
            }
            QVERIFY(writer.value()->finish().isOk());
        }
        const auto result = again("c.palpate");
        QVERIFY2(result.isOk(), result.status().message().c_str());
        QVERIFY2(result.value().isSame(), result.value().difference.english().c_str());
    }

    void goesOnAfterLostTicksWhenTheStateIsKnownAgain()
    {
        auto ticks = test::palpationTicks(2000);
        std::size_t firstLost = 1000;
        while (ticks[firstLost + 10].felt.structure < 0) {
            ++firstLost;
        }
        ticks.erase(ticks.begin() + static_cast<std::ptrdiff_t>(firstLost),
                    ticks.begin() + static_cast<std::ptrdiff_t>(firstLost) + 10);
        ticks[firstLost].flags |= servo::kDroppedBefore;
        QVERIFY(test::writeRecording(path("d.palpate"), ticks));
        const auto result = again("d.palpate");
        QVERIFY2(result.isOk(), result.status().message().c_str());
        QVERIFY2(result.value().isSame(), result.value().difference.english().c_str());
        QVERIFY(result.value().unverified > 0);
        QVERIFY(result.value().unverified < 500);
        QCOMPARE(result.value().compared + result.value().unverified, std::int64_t{1990});
    }

    void namesAStructureThatIsMissing()
    {
        QVERIFY(test::writeRecording(path("e.palpate"), test::palpationTicks(300)));
        const auto reader = session::RecordingReader::open(path("e.palpate"));
        const auto result = session::resimulate(*reader.value(), {});
        QCOMPARE(result.status().code(), core::StatusCode::Mismatch);
        QVERIFY(result.status().message().find("\"box\"") != std::string::npos);
    }

    void hashTellsGeometriesApart()
    {
        geometry::TriangleMesh mesh{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}};
        const std::string hash = session::geometryHash(mesh);
        QCOMPARE(hash.size(), std::size_t{64});
        QCOMPARE(session::geometryHash(mesh), hash);
        geometry::TriangleMesh turned = mesh;
        turned.triangles[0] = {0, 2, 1};
        QVERIFY(session::geometryHash(turned) != hash);
        mesh.vertices[2].y() = std::nextafter(1.0, 2.0);
        QVERIFY(session::geometryHash(mesh) != hash);
    }
};

PALPATE_TEST(Replay)
#include "tst_Replay.moc"
