// SPDX-License-Identifier: BSD-3-Clause
#include "Samples.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/meshio/LoadScene.h>

#include <cmath>
#include <numbers>

using namespace palpate;
using core::Vec3;
using geometry::SurfaceMotion;

namespace {

/// Writes a sphere of 40 mm, moved and stretched along z.
void writeSphere(const std::filesystem::path& path, double lift_mm = 0.0, double stretch = 0.0, int n = 8)
{
    meshio::MeshStructure one;
    one.name = "liver";
    one.mesh = test::transformed(test::sphere(n, 40.0),
                                 [&](const Vec3& p) { return Vec3(p + Vec3(0, 0, lift_mm + stretch * p.z())); });
    const core::Status status = meshio::writeMesh(path, std::span(&one, 1));
    QVERIFY2(status.isOk(), status.message().c_str());
}

std::string scene(const std::string& fields)
{
    return R"({"version": 1, "structures": [{"mesh": "liver.vtp", "name": "liver")" + fields + "}]}";
}

const std::string kBreath = R"(, "motion": {"kind": "breath", "period_s": 5, "amplitude_mm": [0, 3, 15],
    "still_mm": [0, 0, -60], "full_mm": [0, 0, 60]}, "pulse": {"period_s": 0.9, "share": 0.2})";

} // namespace

class SceneMotion : public QObject
{
    Q_OBJECT

    const test::Folder m_folder;

    [[nodiscard]] core::Result<meshio::LoadedScene> loaded(const std::string& fields) const
    {
        return meshio::loadScene(m_folder.write("s.palpate.json", scene(fields)));
    }

  private Q_SLOTS:
    void initTestCase()
    {
        writeSphere(m_folder.path("liver.vtp"));
        for (int i = 0; i < 4; ++i) {
            const double share = std::pow(std::sin(std::numbers::pi * i / 4.0), 2);
            writeSphere(m_folder.path("frame" + std::to_string(i) + ".vtp"), 10.0 * share, 0.1 * share);
        }
        writeSphere(m_folder.path("fine.vtp"), 0.0, 0.0, 9);
        writeSphere(m_folder.path("folded.vtp"), 0.0, -1.9);
        m_folder.write("poses.csv", "time_s,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,0,0,10,0.8,0.6,0,0\n");
        m_folder.write("nan.csv", "time_s,x,y,z\n0,0,0,0\n1,0,nan,10\n");
        m_folder.write("one.csv", "time_s,x,y,z\n0,0,0,0\n");
        m_folder.write("back.csv", "time_s,x,y,z\n1,0,0,0\n0.5,0,0,1\n");
    }

    void breathAndPulseAreMadeAndWritten()
    {
        const auto opened = loaded(kBreath);
        QVERIFY2(opened.isOk(), opened.status().message().c_str());
        const meshio::LoadedStructure& liver = opened.value().structures[0];
        QVERIFY(liver.motion != nullptr && liver.motion->isMoving());
        QCOMPARE(liver.motion->period_s(), 5.0);
        QVERIFY(liver.motion->strain() > 0.1 && liver.motion->strain() < 0.3);
        const auto full = liver.motion->at(2.5);
        const double t = (35.0 + 60.0) / 120.0, share = t * t * (3.0 - 2.0 * t);
        QVERIFY((liver.motion->toWorld(full, Vec3(1, 2, 35)) - Vec3(1, 2, 35) - share * Vec3(0, 3, 15)).norm() < 0.1);
        QVERIFY(std::abs(liver.motion->at(0.45).factor - 1.2) < 1e-6);
        bool isStated = false;
        for (const core::Message& line : opened.value().warnings) {
            isStated = isStated || line.english().starts_with("liver: moves by up to 1");
        }
        QVERIFY(isStated);
        QVERIFY(meshio::writeScene(m_folder.path("t.palpate.json"), opened.value().scene).isOk());
        const auto again = meshio::readScene(m_folder.path("t.palpate.json"));
        QVERIFY2(again.isOk(), again.status().message().c_str());
        QVERIFY(again.value().structures[0].motion == liver.description.motion);
        QVERIFY(again.value().structures[0].pulse == liver.description.pulse);
        QVERIFY(meshio::unknownFields(again.value()).empty());
        const auto other = loaded(R"(, "motion": {"kind": "breath", "amplitude_mm": [0, 0, 1], "sigh": true})");
        QCOMPARE(meshio::unknownFields(other.value().scene), std::vector<std::string>{"structures[0].motion.sigh"});
        QVERIFY(loaded("").value().structures[0].motion == nullptr);
    }

    void framesAreFitted()
    {
        const auto opened = loaded(R"(, "motion": {"kind": "frames", "period_s": 4,
            "files": ["frame0.vtp", "frame1.vtp", "frame2.vtp", "frame3.vtp"]})");
        QVERIFY2(opened.isOk(), opened.status().message().c_str());
        const auto& motion = *opened.value().structures[0].motion;
        for (const Vec3& p : test::sphere(8, 40.0).vertices) {
            const Vec3 expected = p + Vec3(0, 0, 10.0 + 0.1 * p.z());
            QVERIFY((motion.toWorld(motion.at(2.0), p) - expected).norm() < 0.1);
            QVERIFY((motion.toWorld(motion.at(4.0), p) - p).norm() < 0.01);
        }
    }

    void posesAreRead()
    {
        const auto opened = loaded(R"(, "motion": {"kind": "poses", "file": "poses.csv"})");
        QVERIFY2(opened.isOk(), opened.status().message().c_str());
        const auto& motion = *opened.value().structures[0].motion;
        const Vec3 p(1, 2, 3), to = core::Quaternion(0.8, 0.6, 0, 0) * p + Vec3(0, 0, 10);
        QVERIFY((motion.toWorld(motion.at(7.0), p) - to).norm() < 1e-9);
    }

    void structuresThatBreatheAlikeShareTheMotion()
    {
        writeSphere(m_folder.path("vessel.vtp"), 5.0);
        const std::string file = R"({"version": 1, "structures": [{"mesh": "liver.vtp", "name": "a")" + kBreath +
                                 R"(}, {"mesh": "vessel.vtp", "name": "b")" + kBreath + "}]}";
        const auto opened = meshio::loadScene(m_folder.write("two.palpate.json", file));
        QVERIFY2(opened.isOk(), opened.status().message().c_str());
        QVERIFY(opened.value().structures[0].motion == opened.value().structures[1].motion);
    }

    void badMotionsAreRefused_data()
    {
        QTest::addColumn<QString>("fields");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* name, const char* fields, const char* said) {
            QTest::newRow(name) << (QString(", ") + fields) << said;
        };
        row("kind", R"("motion": {"kind": "dance"})", "structures[0].motion.kind: found \"dance\"");
        row("no amplitude", R"("motion": {"kind": "breath"})", "motion.amplitude_mm: found nothing");
        row("exponent", R"("motion": {"kind": "breath", "amplitude_mm": [0,0,1], "exponent": 3})",
            "motion.exponent: found 3");
        row("period", R"("motion": {"kind": "breath", "amplitude_mm": [0,0,1], "period_s": 0})",
            "motion.period_s: found 0");
        row("half a ramp", R"("motion": {"kind": "breath", "amplitude_mm": [0,0,1], "still_mm": [0,0,0]})",
            "motion.full_mm: found nothing");
        row("strain",
            R"("motion": {"kind": "breath", "amplitude_mm": [0,0,15], "still_mm": [0,0,-20], "full_mm": [0,0,20]})",
            "liver: motion: frame 0, cell (");
        row("fold",
            R"("motion": {"kind": "breath", "amplitude_mm": [0,0,-40], "still_mm": [0,0,-20], "full_mm": [0,0,20]})",
            "may fold");
        row("one frame", R"("motion": {"kind": "frames", "files": ["frame0.vtp"]})", "motion.files: found 1 files");
        row("another mesh", R"("motion": {"kind": "frames", "files": ["frame0.vtp", "fine.vtp"]})",
            "fine.vtp: 1100 vertices; expected 900 as in liver.vtp");
        row("no file", R"("motion": {"kind": "frames", "files": ["frame0.vtp", "none.vtp"]})", "none.vtp");
        row("folded frame", R"("motion": {"kind": "frames", "files": ["frame0.vtp", "folded.vtp"]})",
            "frame 1, cell (");
        row("NaN", R"("motion": {"kind": "poses", "file": "nan.csv"})", "nan.csv: line 3: y is \"nan\"");
        row("one pose", R"("motion": {"kind": "poses", "file": "one.csv"})", "one.csv: found 1 poses");
        row("time goes back", R"("motion": {"kind": "poses", "file": "back.csv"})", "back.csv: pose 1");
        row("pulse", R"("pulse": {"period_s": 1, "share": -1})", "pulse.share: found -1");
    }
    void badMotionsAreRefused()
    {
        QFETCH(QString, fields);
        QFETCH(QString, said);
        const auto opened = loaded(fields.toStdString());
        QVERIFY(!opened.isOk());
        QVERIFY2(QString::fromStdString(opened.status().message()).contains(said), opened.status().message().c_str());
        QVERIFY(opened.status().message().starts_with("s.palpate.json"));
    }
};

PALPATE_TEST(SceneMotion)
#include "tst_SceneMotion.moc"
