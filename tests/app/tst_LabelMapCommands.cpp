// SPDX-License-Identifier: BSD-3-Clause
#include "LabelFiles.h"
#include "Program.h"
#include "Samples.h"
#include "TestRunner.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <numbers>

using namespace palpate;
using core::Vec3;
using test::Outcome;

/// Tests that the commands take a label map like a mesh.
class LabelMapCommands : public QObject
{
    Q_OBJECT

    test::Folder m_folder;

    Outcome run(const QStringList& arguments) const
    {
        return test::runProgram(QString::fromStdString(m_folder.path("").string()), arguments);
    }
    /// Returns the force of the last tick.
    double felt_N(const QStringList& arguments) const
    {
        const Outcome outcome = run(QStringList{"replay"} + arguments +
                                    QStringList{"--motion", "press.csv", "--stiffness", "0.5", "--out", "t.csv"});
        const auto lines = QByteArray::fromStdString(test::fileBytes(m_folder.path("t.csv"))).trimmed().split('\n');
        const auto fields = lines.last().split(',');
        return outcome.exitCode == 0 && fields.size() > 9
                   ? Vec3(fields[7].toDouble(), fields[8].toDouble(), fields[9].toDouble()).norm()
                   : -1.0;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        // A ball of 20 mm with a ball of 6 mm in it, and a box beside it.
        test::LabelGrid grid;
        grid.size = {60, 60, 30};
        grid.steps = Vec3(1, 1, 2).asDiagonal();
        grid.origin = Vec3(-30, -30, -30);
        grid.fill([](const Vec3& p) {
            return p.norm() < 6.0                                                   ? 2
                   : p.norm() < 20.0                                                ? 1
                   : p.x() > 24.0 && p.x() < 28.0 && p.cwiseAbs().maxCoeff() < 28.5 ? 3
                                                                                    : 0;
        });
        const std::string names = "Segment0_Name:=liver\nSegment0_LabelValue:=1\nSegment1_Name:=tumour\n"
                                  "Segment1_LabelValue:=2\nSegment2_Name:=rib\nSegment2_LabelValue:=3\n";
        (void)m_folder.write("case.seg.nrrd", test::labelNrrd(grid, "uchar", "gzip", names) +
                                                  test::gzipped(test::labelNumbers<std::uint8_t>(grid)));
        (void)m_folder.write("scene.palpate.json",
                             R"({"version": 1, "structures": [{"mesh": "case.seg.nrrd", "part": "liver"}]})");
        std::string motion = "x,y,z\n";
        for (int i = 0; i <= 200; ++i) { // 4 mm deep on a meridian
            motion += std::to_string(26.0 - 0.05 * i) + ",0.3,0.4\n";
        }
        (void)m_folder.write("press.csv", motion);
    }

    void infoTellsVoxelsAndChange()
    {
        const Outcome text = run({"info", "case.seg.nrrd"});
        QCOMPARE(text.exitCode, 0);
        QVERIFY2(
            text.out.contains("surface from a label map of 1 × 1 × 2 mm voxels, smoothed by 0.5: volume changed by "),
            text.out.constData());
        QVERIFY2(text.out.contains("frame LPS (the file's format)"), text.out.constData());
        const auto json = [this](const QStringList& options) {
            const Outcome outcome = run(QStringList{"info", "case.seg.nrrd", "--json"} + options);
            return QJsonDocument::fromJson(outcome.out).array().at(0).toObject()["structures"].toArray();
        };
        const QJsonArray structures = json({});
        QCOMPARE(structures.size(), 3);
        QCOMPARE(structures.at(0).toObject()["name"].toString(), QString("liver"));
        QCOMPARE(structures.at(1).toObject()["name"].toString(), QString("tumour"));
        const QJsonObject liver = structures.at(0).toObject();
        QCOMPARE(liver["label_map"].toObject()["voxel_mm"].toArray().at(2).toDouble(), 2.0);
        QCOMPARE(liver["smoothed"].toObject()["smoothing"].toDouble(), 0.5);
        const QJsonArray other = json({"--smoothing", "0.2"}), steps = json({"--smoothing", "0"});
        QCOMPARE(other.at(0).toObject()["smoothed"].toObject()["smoothing"].toDouble(), 0.2);
        QVERIFY(!steps.at(0).toObject().contains("smoothed"));
        QVERIFY(other.at(0).toObject()["sha256"] != liver["sha256"] &&
                steps.at(0).toObject()["sha256"] != liver["sha256"]);
        QCOMPARE(run({"info", "case.seg.nrrd", "--smoothing", "1.5"}).exitCode, 2);
    }

    void replayFeelsTheBall()
    {
        // The hand ends 4 mm deep, so an exact ball gives 2 N.
        const double whole = felt_N({"scene.palpate.json"});
        QVERIFY2(std::abs(whole - 2.0) <= 0.2, qPrintable(QString::number(whole)));
    }

    void feltTakesLabelMaps()
    {
        const Outcome felt = run({"felt", "case.seg.nrrd"});
        QCOMPARE(felt.exitCode, 0);
        QVERIFY2(felt.out.contains("tumour (") && felt.out.contains("below at least"),
                 (felt.out + felt.error).constData()); // although its voxels are cut out of the liver's
    }

    void anImageIsRefusedByName()
    {
        test::LabelGrid grid;
        grid.size = {9, 9, 9};
        grid.fill([](const Vec3& p) { return static_cast<int>(p.x() * 37 + p.y() * 11 + p.z() * 5) - 200; });
        (void)m_folder.write("ct.nii", test::labelNifti(grid, 4) + test::labelNumbers<std::int16_t>(grid));
        const Outcome outcome = run({"info", "ct.nii"});
        QCOMPARE(outcome.exitCode, 2);
        QVERIFY2(outcome.error.contains("ct.nii: a NIfTI volume with ") &&
                     outcome.error.contains(" intensities, not labels"),
                 outcome.error.constData());
    }
};

PALPATE_TEST(LabelMapCommands)
#include "tst_LabelMapCommands.moc"
