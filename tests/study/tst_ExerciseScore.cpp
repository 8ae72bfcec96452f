// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/geometry/Repair.h>
#include <palpate/session/Findings.h>
#include <palpate/session/RecordingWriter.h>
#include <palpate/study/ExerciseScore.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace palpate;
using core::Vec3;
using study::FindingVerdict;

/// Tests the score of an exercise on a synthetic recording: a sheet of 40 mm, a target of radius 5 mm 8 mm below its
/// middle, and a deep one of radius 3 mm at (15, 0, -20). From tick 100 on, the hand presses with 3 N in the middle for
/// 0.2 s, with 6 N at x = 12 mm for 0.1 s, and with 10 N at y = 15 mm for 0.1 s.
class ExerciseScore : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    session::MeshesByHash m_meshes;
    std::unique_ptr<session::RecordingReader> m_reader;

    static core::Finding finding(const char* name, const Vec3& p_W, core::FindingType type = core::FindingType::Lump)
    {
        core::Finding out;
        out.name = out.id = name;
        out.p_W = p_W;
        out.type = type;
        return out;
    }
    static servo::TickRecord press(int tick, const Vec3& p_W, double force_N)
    {
        servo::TickRecord out;
        out.tick = tick;
        out.scene = 1;
        out.p_WH = p_W - Vec3(0, 0, 2);
        out.felt.p_WG = p_W;
        out.felt.n_W = Vec3(0, 0, 1);
        out.felt.f_W = Vec3(0, 0, force_N);
        out.felt.structure = 0;
        out.felt.constraints = 1;
        out.felt.contactCount = 1;
        out.felt.contacts[0] = {p_W, out.felt.n_W, out.felt.f_W, 2.0, 1.0, 0, 0, 0, {}};
        return out;
    }
    [[nodiscard]] core::Result<study::ExerciseScore> score(const meshio::Exercise& exercise) const
    {
        return study::scoreExercise(*m_reader, m_meshes, exercise, {5.0, 4.0});
    }

  private Q_SLOTS:
    void initTestCase()
    {
        const std::pair<const char*, geometry::TriangleMesh> surfaces[]{
            {"skin", test::sheet(20.0, 40)},
            {"lump", test::moved(test::sphere(6, 5.0), Vec3(0, 0, -8))},
            {"deep", test::moved(test::sphere(6, 3.0), Vec3(15, 0, -20))}};
        session::SceneRecord scene;
        scene.generation = 1;
        for (const auto& [name, mesh] : surfaces) {
            scene.structures.emplace_back().name = name;
            scene.structures.back().source.sha256 = std::string("hash of ") + name;
            m_meshes[std::string("hash of ") + name] =
                std::make_shared<const geometry::RepairedMesh>(geometry::repair(mesh));
        }
        const std::filesystem::path file = m_folder.filePath("a.palpate").toStdString();
        auto writer = session::RecordingWriter::create(file, {});
        QVERIFY(writer.value()->addScene(scene).isOk());
        for (int i = 100; i < 500; ++i) {
            QVERIFY(writer.value()
                        ->append(i < 300   ? press(i, Vec3(0, 0, 0), 3.0)
                                 : i < 400 ? press(i, Vec3(12, 0, 0), 6.0)
                                           : press(i, Vec3(0, 15, 0), 10.0))
                        .isOk());
        }
        const auto mark = [&writer](std::int64_t tick, const core::Finding& one) {
            return writer.value()->addEvent({tick, "finding", session::findingJson(one)}).isOk();
        };
        QVERIFY(mark(250, finding("first", Vec3(0, 0, 0)))); // 3 mm from the lump
        QVERIFY(mark(260, finding("again", Vec3(1, 0, 0), core::FindingType::Other)));
        QVERIFY(mark(270, finding("navel", Vec3(0, 0, 0), core::FindingType::Landmark)));
        QVERIFY(mark(350, finding("wrong", Vec3(12, 0, 0))));  // 9.4 mm from the lump
        QVERIFY(mark(450, finding("last", Vec3(15, 0, -17)))); // on the deep one
        QVERIFY(writer.value()->addEvent({460, "note", "{}"}).isOk());
        QVERIFY(writer.value()->finish().isOk());
        auto reader = session::RecordingReader::open(file);
        QVERIFY(reader.isOk());
        m_reader = std::move(reader).value();
    }

    void countsUpToTheTimeLimit()
    {
        const auto scored = score({{"deep", "lump"}, 0.3, 4.0, 0.5});
        QVERIFY2(scored.isOk(), scored.status().message().c_str());
        const study::ExerciseScore& s = scored.value();
        QCOMPARE(s.found(), std::size_t{1});
        QVERIFY(!s.targets[0].found_s && !s.targets[0].distance_mm);
        QVERIFY(std::abs(s.targets[1].found_s.value() - 0.15) < 1e-12);
        QVERIFY(std::abs(s.targets[1].distance_mm.value() - 3.0) < 1e-9);
        QVERIFY((s.targets[1].ball.centre_W - Vec3(0, 0, -8)).norm() < 1e-9);
        QCOMPARE(s.findings.size(), std::size_t{5});
        const FindingVerdict expected[]{FindingVerdict::Found, FindingVerdict::Again, FindingVerdict::NotCounted,
                                        FindingVerdict::FalseAlarm, FindingVerdict::Late};
        for (std::size_t i = 0; i < 5; ++i) {
            QCOMPARE(s.findings[i].verdict, expected[i]);
        }
        QCOMPARE(s.duration_s, 0.3);
        QCOMPARE(s.peakForce_N, 6.0);
        QVERIFY(std::abs(s.above->time_s - 0.1) < 1e-9);
        QVERIFY(std::abs(s.above->impulse_Ns - 0.2) < 1e-9); // (6 - 4) N for 0.1 s
        QVERIFY(std::abs(s.searched_mm2 - 1600.0) < 1e-9);   // the sheet, without the targets
        QVERIFY(std::abs(s.coverage().value() - 2.0 * std::numbers::pi * 16.0 / 1600.0) < 0.006);
    }

    void countsAllWithoutLimits()
    {
        const auto scored = score({{"deep", "lump"}, {}, {}, {}});
        const study::ExerciseScore& s = scored.value();
        QCOMPARE(s.found(), std::size_t{2});
        QVERIFY(std::abs(s.targets[0].found_s.value() - 0.35) < 1e-12);
        QVERIFY(std::abs(s.targets[0].distance_mm.value()) < 1e-9);
        QCOMPARE(s.count(FindingVerdict::FalseAlarm), std::size_t{1});
        QVERIFY(!s.above);
        QCOMPARE(s.peakForce_N, 10.0);
        QVERIFY(std::abs(s.coverage().value() - 3.0 * std::numbers::pi * 16.0 / 1600.0) < 0.009);
        const auto strict = score({{"deep"}, {}, 9.0, {}});
        QVERIFY(std::abs(strict.value().above->impulse_Ns - 0.1) < 1e-9);
        QVERIFY(std::abs(strict.value().searched_mm2 - 1600.0 - 4.0 * std::numbers::pi * 25.0) < 15.0);
    }

    void isWrittenAsJson()
    {
        const auto scored = score({{"deep", "lump"}, 0.3, 4.0, 0.5});
        const QJsonObject json =
            QJsonDocument::fromJson(QByteArray::fromStdString(study::exerciseJson(scored.value()))).object();
        QCOMPARE(json["found"].toInt(-1), 1);
        QCOMPARE(json["missed"].toInt(-1), 1);
        QCOMPARE(json["false_alarms"].toInt(-1), 1);
        QCOMPARE(json["found_again"].toInt(-1), 1);
        QCOMPARE(json["late"].toInt(-1), 1);
        QCOMPARE(json["coverage"].toDouble(), scored.value().coverage().value());
        QCOMPARE(json["impulse_above_Ns"].toDouble(), scored.value().above->impulse_Ns);
        QVERIFY(json["targets"][0]["found_s"].isNull());
        QCOMPARE(json["targets"][1]["name"].toString(), QString("lump"));
        QCOMPARE(json["findings"][3]["verdict"].toString(), QString("false alarm"));
        QVERIFY(json["findings"][3]["target"].isNull());
        QCOMPARE(json["findings"][0]["target"].toString(), QString("lump"));
    }

    void aTargetThatIsNotThereIsNamed()
    {
        QVERIFY(score({{"gone"}, {}, {}, {}})
                    .status()
                    .message()
                    .starts_with("target \"gone\": found no structure of that name in the recording"));
        session::MeshesByHash without = m_meshes;
        without.erase("hash of lump");
        const auto scored = study::scoreExercise(*m_reader, without, {{"lump"}, {}, {}, {}}, {});
        QVERIFY2(scored.status().message().starts_with("target \"lump\": its surface is missing"),
                 scored.status().message().c_str());
    }

    void aFindingGoesToTheNearestTargetThatIsLeft()
    {
        std::vector<study::ScoredTarget> targets{{"a", {Vec3(0, 0, 0), 5.0}, {}, {}},
                                                 {"b", {Vec3(8, 0, 0), 5.0}, {}, {}}};
        const core::Finding between = finding("f", Vec3(3, 0, 0));
        const auto matched = study::matchFindings({{1.0, between}, {2.0, between}, {3.0, between}}, targets, 1.0, {});
        QCOMPARE(matched[0].target.value(), std::size_t{0});
        QCOMPARE(matched[1].target.value(), std::size_t{1});
        QCOMPARE(matched[2].target.value(), std::size_t{0});
        QCOMPARE(matched[2].verdict, FindingVerdict::Again);
        QVERIFY(targets[0].found_s == 1.0 && targets[1].found_s == 2.0);
        QVERIFY(targets[0].distance_mm == -2.0 && targets[1].distance_mm == 0.0);
    }

    void theBallEnclosesTheTarget()
    {
        const study::TargetBall ball = study::ballAround(test::box(Vec3(9, 0, 0), Vec3(11, 4, 6), 3));
        QVERIFY((ball.centre_W - Vec3(10, 2, 3)).norm() < 1e-9);
        QVERIFY(std::abs(ball.radius_mm - std::sqrt(1.0 + 4.0 + 9.0)) < 1e-9);
    }
};

PALPATE_TEST(ExerciseScore)
#include "tst_ExerciseScore.moc"
