// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include "../support/Shapes.h"
#include "Sessions.h"
#include "tables/Contacts.h"

#include <palpate/session/CompareSessions.h>
#include <palpate/session/GeometryHash.h>
#include <palpate/session/MeasureSession.h>
#include <palpate/session/RecordingWriter.h>

#include <QTemporaryDir>

#include <cmath>

using namespace palpate;
using core::Vec3;

class Measures : public QObject
{
    Q_OBJECT

    static servo::TickRecord tick(int number, double hip_z, double god_z, double force_z)
    {
        servo::TickRecord record;
        record.tick = number;
        record.p_WH = core::Vec3(0, 0, hip_z);
        record.felt.p_WG = core::Vec3(0, 0, god_z);
        record.felt.f_W = core::Vec3(0, 0, force_z);
        record.felt.structure = force_z > 0.0 ? 0 : -1;
        if (force_z > 0.0) {
            record.felt.contactCount = 1;
            record.felt.contacts[0] = session::internal::ownContact(record);
        }
        return record;
    }
    /// @return a function that gives every structure this name
    static session::StructureNames called(const char* name)
    {
        return [name](std::uint32_t) { return std::string_view(name); };
    }

  private Q_SLOTS:
    /// Down 1 mm per tick from 2 mm above to 3 mm below a plane at 0, with 0.5 N/mm: computed by hand.
    void agreeWithASessionWorkedOutByHand()
    {
        session::MeasureAccumulator measures(1e-3);
        for (int i = 0; i < 6; ++i) {
            const double z = 2.0 - i;
            measures.add(tick(i, z, std::max(z, 0.0), 0.5 * std::max(-z, 0.0)), called("liver"));
        }
        const session::Measures m = measures.result();
        QCOMPARE(m.ticks, std::int64_t{6});
        QCOMPARE(m.contact.ticks, std::int64_t{3});
        QCOMPARE(m.contact.contacts, std::int64_t{1});
        QCOMPARE(m.duration_s, 6e-3);
        QCOMPARE(m.contact.time_s, 3e-3);
        QCOMPARE(m.pathLength_mm, 5.0);
        QCOMPARE(m.contactPath_mm, 0.0);
        QCOMPARE(m.contact.peakForce_N, 1.5);
        QCOMPARE(m.contact.meanForce_N, 1.0);
        QCOMPARE(m.contact.medianForce_N, 1.0);
        QCOMPARE(m.contact.p95Force_N, 1.5);
        QCOMPARE(m.contact.meanDepth_mm, 2.0);
        QCOMPARE(m.contact.peakDepth_mm, 3.0);
        QCOMPARE(m.structures.size(), std::size_t{1});
        QCOMPARE(m.structures.begin()->first, std::string("liver"));
        QCOMPARE(m.structures.begin()->second.time_s, 3e-3);
        QCOMPARE(m.structures.begin()->second.meanForce_N, 1.0);
    }

    void compareForcesByTheThresholdOfTheHand()
    {
        session::ComparedMeasure force{"", {}, 4, true, 2.0, 2.13};
        QCOMPARE(force.isNoticeable(), std::optional(false)); // 6.5 %
        force.second = 1.85;
        QCOMPARE(force.isNoticeable(), std::optional(true)); // -7.5 %
        QVERIFY(std::abs(*force.difference() + 0.15) < 1e-12);
        force.isForce = false;
        QVERIFY(!force.isNoticeable()); // a depth, or a time
        force.isForce = true;
        force.first = 0.0;
        QVERIFY(!force.isNoticeable() && !force.difference_percent());
        force.first.reset(); // never touched
        QVERIFY(!force.isNoticeable() && !force.difference());
    }

    void doNotCountMovesAcrossALoss()
    {
        session::MeasureAccumulator measures(1e-3);
        measures.add(tick(0, 0, 0, 0), called(""));
        measures.add(tick(5, 100, 100, 0), called("")); // 4 ticks are missing
        servo::TickRecord reset = tick(6, 200, 200, 0);
        reset.flags = servo::kReset;
        measures.add(reset, called(""));
        measures.add(tick(7, 201, 201, 0), called(""));
        QCOMPARE(measures.result().pathLength_mm, 1.0);
    }

    void takeThePercentileByNearestRank()
    {
        session::MeasureAccumulator measures(1e-3);
        for (int i = 1; i <= 100; ++i) {
            measures.add(tick(i, -1, 0, i), called("a"));
        }
        QCOMPARE(measures.result().contact.p95Force_N, 95.0);
    }

    /// 0.3 s over the surface at 20 mm/s with 1 N, 0.2 s at rest with 2 N, no contact, 0.05 s at rest with 4 N.
    void tellSearchingFromPressing()
    {
        session::PhaseAccumulator phases(1e-3);
        int number = 100;
        const auto feel = [&](int ticks, double speed_mm_per_s, double force_N) {
            for (int i = 0; i < ticks; ++i) {
                servo::TickRecord record = tick(number++, -force_N, 0.0, force_N);
                record.felt.p_WG.x() = speed_mm_per_s * 1e-3 * i;
                phases.add(record);
            }
        };
        feel(300, 20.0, 1.0);
        feel(200, 0.0, 2.0);
        feel(10, 0.0, 0.0);
        feel(50, 9.0, 4.0); // slower than a search
        const auto found = phases.result();
        QCOMPARE(found.size(), std::size_t{3});
        QVERIFY(found[0].kind == session::Phase::Kind::Search);
        QCOMPARE(found[0].firstTick, std::int64_t{100});
        QCOMPARE(found[0].start_s, 0.0);
        QCOMPARE(found[0].time_s, 0.3);
        QCOMPARE(found[0].meanForce_N, 1.0);
        QVERIFY(found[1].kind == session::Phase::Kind::Press);
        QCOMPARE(found[1].start_s, 0.3);
        QCOMPARE(found[1].time_s, 0.2);
        QVERIFY(found[2].kind == session::Phase::Kind::Press); // released in between: another phase
        QCOMPARE(found[2].start_s, 0.51);
        const session::PhaseSummary press = session::summary(found, session::Phase::Kind::Press);
        QCOMPARE(press.phases, std::int64_t{2});
        QCOMPARE(press.time_s, 0.25);
        QVERIFY(std::abs(press.meanForce_N - (0.2 * 2.0 + 0.05 * 4.0) / 0.25) < 1e-12);
        QCOMPARE(press.peakForce_N, 4.0);
    }

    /// Half a second through a liver onto a lump and off again, twice: each structure has its own time, share, depth
    /// and presses.
    void everyLayerIsMeasured()
    {
        session::MeasureAccumulator measures(1e-3);
        session::PhaseAccumulator liver(1e-3);
        session::PhaseAccumulator lump(1e-3);
        for (int i = 0; i < 1000; ++i) {
            const bool isOnLump = i % 500 >= 200;
            servo::TickRecord record = tick(i, -10.0, 0.0, isOnLump ? 6.0 : 2.0);
            record.felt.contacts[0].f_W.z() = 2.0;
            if (isOnLump) {
                record.felt.contactCount = 2;
                record.felt.contacts[1] = record.felt.contacts[0];
                record.felt.contacts[1].structure = 1;
                record.felt.contacts[1].p_WG.z() = -8.0;
                record.felt.contacts[1].f_W.z() = 4.0;
                record.felt.contacts[1].depth_mm = 2.0;
            }
            measures.add(record, [](std::uint32_t number) { return number == 0 ? "liver" : "lump"; });
            liver.add(record, &record.felt.contacts[0]);
            lump.add(record, isOnLump ? &record.felt.contacts[1] : nullptr);
        }
        const session::Measures m = measures.result();
        QCOMPARE(m.contact.time_s, 1.0);
        QCOMPARE(m.contact.peakForce_N, 6.0);
        QCOMPARE(m.contact.contacts, std::int64_t{1});
        QCOMPARE(m.structures.size(), std::size_t{2});
        const session::ContactMeasures& outer = m.structures.at("liver");
        QCOMPARE(outer.time_s, 1.0);
        QCOMPARE(outer.peakForce_N, 2.0);
        QCOMPARE(outer.peakDepth_mm, 10.0);
        const session::ContactMeasures& inner = m.structures.at("lump");
        QCOMPARE(inner.time_s, 0.6);
        QCOMPARE(inner.contacts, std::int64_t{2});
        QCOMPARE(inner.meanForce_N, 4.0);
        QCOMPARE(inner.peakDepth_mm, 2.0);
        QCOMPARE(session::summary(liver.result(), session::Phase::Kind::Press).phases, std::int64_t{1});
        const session::PhaseSummary presses = session::summary(lump.result(), session::Phase::Kind::Press);
        QCOMPARE(presses.phases, std::int64_t{2});
        QCOMPARE(presses.time_s, 0.6);
        QCOMPARE(presses.peakForce_N, 4.0);
    }

    /// A square sheet of 40 mm in z = 0. Two ticks at its middle, a second apart, and two at (10, 0), 4 mm distance:
    /// disjoint discs of 16 pi mm² each.
    void knowWhatWasTouched()
    {
        for (const int n : {1, 8, 80}) { // from coarse to fine meshes of the same surface
            session::TouchedSurface surface(test::sheet(20.0, n), 4.0);
            QVERIFY(std::abs(surface.area_mm2() - 1600.0) < 1e-9);
            surface.add({Vec3(0, 0, 0), 3.0, 6.0, 0.0, 1e-3});
            surface.add({Vec3(0, 0, 0), 2.0, 7.0, 1.0, 1e-3}); // a second later: another visit
            surface.add({Vec3(10, 0, 0), 5.0, 4.0, 1.001, 1e-3});
            surface.add({Vec3(10, 0, 0), 1.0, 0.1, 1.002, 1e-3});  // too little depth for a stiffness
            surface.add({Vec3(0, 0, 4.5), 9.0, 9.0, 1.003, 1e-3}); // too far away
            const double exact_mm2 = 2.0 * M_PI * 16.0;
            QVERIFY2(std::abs(surface.coveredArea_mm2() - exact_mm2) < 0.25 * exact_mm2,
                     std::to_string(surface.coveredArea_mm2()).c_str());
            for (std::size_t i = 0; i < surface.mesh().vertices.size(); ++i) {
                const Vec3& p = surface.mesh().vertices[i];
                const bool isMiddle = p.norm() <= 4.0;
                const bool isAside = (p - Vec3(10, 0, 0)).norm() <= 4.0;
                QCOMPARE(surface.dwell_s()[i], isMiddle || isAside ? 2e-3 : 0.0);
                QCOMPARE(surface.peakForce_N()[i], isMiddle ? 3.0 : isAside ? 5.0 : 0.0);
                QCOMPARE(surface.peakDepth_mm()[i], isMiddle ? 7.0 : isAside ? 4.0 : 0.0);
                QCOMPARE(surface.meanForce_N()[i], isMiddle ? 2.5 : isAside ? 3.0 : 0.0);
                QCOMPARE(surface.stiffness_N_per_mm()[i], isMiddle ? 0.5 : isAside ? 1.25 : 0.0);
                QCOMPARE(surface.visits()[i], isMiddle ? 2u : isAside ? 1u : 0u);
            }
        }
        session::TouchedSurface fine(test::sheet(20.0, 400), 4.0);
        fine.add({Vec3(0, 0, 0), 1.0, 1.0, 0.0, 1e-3});
        QVERIFY(std::abs(fine.coveredArea_mm2() - M_PI * 16.0) < 0.01 * M_PI * 16.0);
    }

    void touchTheSurfaceBelowTheBall_data()
    {
        QTest::addColumn<double>("radius_mm");
        QTest::addColumn<double>("height_mm"); // of the centre; less than the radius: a start without room
        QTest::addColumn<double>("distance_mm");
        QTest::addColumn<double>("expected_mm"); // radius of the touched disc
        QTest::newRow("point") << 0.0 << 0.0 << 8.0 << 8.0;
        QTest::newRow("ball") << 8.0 << 8.0001 << 8.0 << 8.0;
        QTest::newRow("small distance") << 8.0 << 8.0001 << 3.0 << 3.0;
        QTest::newRow("large distance") << 8.0 << 8.0001 << 12.0 << 12.0;
        QTest::newRow("large ball") << 30.0 << 30.0001 << 5.0 << 5.0;
        QTest::newRow("without room") << 8.0 << 4.0 << 8.0 << std::sqrt(48.0);
        QTest::newRow("centre on the surface") << 8.0 << 0.0 << 8.0 << 8.0;
        QTest::newRow("without room, small distance") << 30.0 << 10.0 << 3.0 << 3.0;
    }

    /// The god-object of a ball is its centre: coverage and visits of findings count from the surface, from the
    /// recording as from ticks of the servo.
    void touchTheSurfaceBelowTheBall()
    {
        QFETCH(double, radius_mm);
        QFETCH(double, height_mm);
        QFETCH(double, distance_mm);
        QFETCH(double, expected_mm);
        constexpr double kEdge_mm = 0.4;
        const auto sheet = std::make_shared<const geometry::RepairedMesh>(geometry::repair(test::sheet(20.0, 100)));
        const std::string hash = session::geometryHash(sheet->mesh);
        session::SceneRecord scene = test::palpationScenes()[0];
        scene.fingertip_mm = radius_mm;
        scene.structures[0].name = "sheet";
        scene.structures[0].source.sha256 = hash;
        QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("a.palpate").toStdString();
        auto writer = session::RecordingWriter::create(file, {});
        QVERIFY(writer.value()->addScene(scene).isOk());
        servo::TickRecord record = tick(0, height_mm - 5.0, height_mm, 1.0);
        record.felt.n_W = Vec3::UnitZ();
        record.felt.contacts[0] = session::internal::ownContact(record);
        record.scene = 1;
        QVERIFY(writer.value()->append(record).isOk());
        const auto mark = [&](const char* name, double x_mm) {
            core::Finding finding{.name = name, .p_W = Vec3(x_mm, 0, 0), .structure = "sheet"};
            QVERIFY(writer.value()->addEvent({0, "finding", session::findingJson(finding)}).isOk());
        };
        mark("inside", expected_mm - kEdge_mm);
        mark("outside", expected_mm + kEdge_mm);
        QVERIFY(writer.value()->finish().isOk());

        const auto reader = session::RecordingReader::open(file);
        const auto measured = session::measureSession(*reader.value(), {{hash, sheet}}, {distance_mm, nullptr});
        QVERIFY2(measured.isOk(), measured.status().message().c_str());
        const session::SessionMeasures& m = measured.value();
        // The border of the disc passes through triangles, whose corners count with their shares.
        const double exact_mm2 = M_PI * expected_mm * expected_mm, border_mm2 = M_PI * expected_mm * kEdge_mm;
        QVERIFY2(std::abs(m.surfaces[0].coveredArea_mm2 - exact_mm2) < border_mm2,
                 std::to_string(m.surfaces[0].coveredArea_mm2).c_str());
        QCOMPARE(m.findings[0].visits, std::int64_t{1});
        QCOMPARE(m.findings[0].dwell_s, 1e-3);
        QCOMPARE(m.findings[1].visits, std::int64_t{0});

        session::TouchedSurfaces live(
            {{hash, sheet}}, [&](std::uint32_t, std::uint32_t) { return session::StructureKey("sheet", hash); },
            distance_mm);
        record.felt.fingertip_mm = radius_mm;
        live.add(record, 0.0, 1e-3);
        QCOMPARE(live.take({"sheet", hash})->coveredArea_mm2(), m.surfaces[0].coveredArea_mm2);
    }

    /// From the recording to every number: a press of 0.2 s on the sheet, marked, then a press beside the sheet.
    void ofARecordingAreThoseOfItsTicks()
    {
        QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("a.palpate").toStdString();
        const auto sheet = std::make_shared<const geometry::RepairedMesh>(geometry::repair(test::sheet(20.0, 40)));
        const std::string hash = session::geometryHash(sheet->mesh);
        session::SceneRecord scene = test::palpationScenes()[0];
        scene.structures[0].name = "sheet";
        scene.structures[0].source.sha256 = hash;
        scene.structures.push_back(scene.structures[0]);
        scene.structures[1].name = "elsewhere";
        scene.structures[1].source.sha256 = "not here";
        auto writer = session::RecordingWriter::create(file, {});
        QVERIFY(writer.value()->addScene(scene).isOk());
        for (int i = 0; i < 500; ++i) {
            const bool isFirst = i < 200;
            const bool isSecond = i >= 300 && i < 400;
            servo::TickRecord record = tick(i,
                                            isFirst    ? -2.0
                                            : isSecond ? -1.0
                                                       : 1.0,
                                            isFirst || isSecond ? 0.0 : 1.0,
                                            isFirst    ? 1.0
                                            : isSecond ? 0.5
                                                       : 0.0);
            record.p_WH.x() = record.felt.p_WG.x() = i < 250 ? 0.0 : 12.0;
            record.felt.contacts[0] = session::internal::ownContact(record);
            record.scene = 1;
            record.flags = i == 250 ? servo::kReset : 0;
            QVERIFY(writer.value()->append(record).isOk());
        }
        const core::Finding finding{
            .name = "lump", .p_W = Vec3(1, 0, 0), .structure = "sheet", .force_N = 1.0, .depth_mm = 2.0};
        QVERIFY(writer.value()->addEvent({150, "finding", session::findingJson(finding)}).isOk());
        QVERIFY(writer.value()->addEvent({160, "note", "{}"}).isOk());
        QVERIFY(writer.value()->finish().isOk());

        const auto reader = session::RecordingReader::open(file);
        const auto measured = session::measureSession(*reader.value(), {{hash, sheet}}, {4.0, nullptr});
        QVERIFY2(measured.isOk(), measured.status().message().c_str());
        const session::SessionMeasures& m = measured.value();
        QCOMPARE(m.sums.contact.time_s, 0.3);
        QCOMPARE(m.sums.contact.contacts, std::int64_t{2});
        QCOMPARE(m.sums.pathLength_mm, 3.0 + 2.0 + 2.0); // up after the first, down to and up from the second
        QCOMPARE(m.unmeasured, std::vector<std::string>{"elsewhere"});
        QCOMPARE(m.surfaces.size(), std::size_t{1});
        QCOMPARE(m.surfaces[0].structure, std::string("sheet"));
        QVERIFY(std::abs(m.surfaces[0].area_mm2 - 1600.0) < 1e-9);
        QVERIFY(std::abs(m.surfaces[0].coverage() - 2.0 * M_PI * 16.0 / 1600.0) < 0.006);
        QVERIFY(std::abs(m.surfaces[0].longestDwell_s - 0.2) < 1e-9);
        QCOMPARE(m.phases.size(), std::size_t{2});
        QCOMPARE(m.findings.size(), std::size_t{1});
        const session::FindingMeasures& at = m.findings[0];
        QCOMPARE(at.finding.name, finding.name);
        QCOMPARE(at.finding.p_W, finding.p_W);
        QCOMPARE(at.marked_s, 0.15);
        QCOMPARE(at.firstTouched_s.value(), 0.0);
        QCOMPARE(at.dwell_s, 0.2);
        QCOMPARE(at.visits, std::int64_t{1});
        QCOMPARE(at.meanForce_N, 1.0);
        QCOMPARE(at.peakForce_N, 1.0);
        QCOMPARE(at.peakDepth_mm, 2.0);
        for (const double distance_mm : {0.03, 1e-300, 0.0, -1.0, std::nan("")}) {
            const auto refused = session::measureSession(*reader.value(), {{hash, sheet}}, {distance_mm, nullptr});
            QCOMPARE(refused.status().code(), core::StatusCode::OutOfRange);
            QVERIFY(refused.status().message().find("expected at least 0.04 mm") != std::string::npos);
        }
        QCOMPARE(session::measureSession(*reader.value(), {}, {4.0, [](double) { return false; }}).status().code(),
                 core::StatusCode::Cancelled);
    }

    void ofNothingAreZero()
    {
        const session::Measures m = session::MeasureAccumulator(1e-3).result();
        QCOMPARE(m.ticks, std::int64_t{0});
        QCOMPARE(m.contact.p95Force_N, 0.0);
    }
};

PALPATE_TEST(Measures)
#include "tst_Measures.moc"
