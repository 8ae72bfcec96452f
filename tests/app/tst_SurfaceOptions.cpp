// SPDX-License-Identifier: BSD-3-Clause
#include "../meshio/Samples.h"
#include "Masks.h"
#include "Program.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <span>

using namespace palpate;
using core::Vec3;
using test::Outcome;

/// Tests `--smooth` and `--outwards`, and the messages of `info`, `replay` and `felt` for surfaces that need these
/// options.
class SurfaceOptions : public QObject
{
    Q_OBJECT

    test::Folder m_folder;

    Outcome run(const QStringList& arguments) const
    {
        return test::runProgram(QString::fromStdString(m_folder.path("").string()), arguments);
    }
    void write(const char* name, geometry::TriangleMesh mesh, bool isInsideOut = false) const
    {
        if (isInsideOut) {
            geometry::flip(mesh);
        }
        const meshio::MeshStructure one{std::filesystem::path(name).stem().string(), std::move(mesh), std::nullopt};
        QVERIFY(meshio::writeMesh(m_folder.path(name), std::span(&one, 1)).isOk());
    }
    QJsonObject json(const QStringList& arguments, int file = 0) const
    {
        return QJsonDocument::fromJson(run(arguments).out).array().at(file).toObject();
    }
    /// Returns the force of the last tick.
    double felt_N(const QStringList& arguments) const
    {
        const Outcome outcome = run(QStringList{"replay"} + arguments + QStringList{"--out", "t.csv"});
        const auto lines = QByteArray::fromStdString(test::fileBytes(m_folder.path("t.csv"))).trimmed().split('\n');
        const auto fields = lines.last().split(',');
        return outcome.exitCode == 0 && fields.size() > 9
                   ? Vec3(fields[7].toDouble(), fields[8].toDouble(), fields[9].toDouble()).norm()
                   : -1.0;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        write("stairs.stl", test::maskSurface(test::ballMask(15.0, Vec3(1, 1, 3))));
        write("inverted.stl", test::box(Vec3(10, 20, 30), Vec3(50, 50, 50), 2), true);
        geometry::TriangleMesh open = test::box(Vec3(10, 20, 30), Vec3(50, 50, 50), 2);
        std::erase_if(open.triangles, [&](const geometry::Triangle& t) {
            return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return open.vertices[v].z() == 50.0; });
        });
        write("open.stl", open);
        write("organ.stl", test::sphere(24, 40.0));
        write("lump.stl", test::sphere(8, 10.0));
        std::string motion = "x,y,z\n";
        for (int i = 0; i <= 60; ++i) {
            motion += "30,35," + std::to_string(51.0 - 0.05 * i) + "\n"; // 2 mm into the box from above
        }
        (void)m_folder.write("press.csv", motion);
    }

    void infoNamesAStaircaseAndSmooths()
    {
        const Outcome plain = run({"info", "stairs.stl"});
        QCOMPARE(plain.exitCode, 0);
        QVERIFY2(plain.out.contains("staircase of about 1 × 1 × 3 mm voxels (100 % of the area in 60 directions)"),
                 plain.out.constData());
        QVERIFY(plain.out.contains("--smooth"));
        const QJsonObject before = json({"info", "stairs.stl", "--json"})["structures"].toArray().at(0).toObject();
        const QJsonArray voxel = before["staircase"].toObject()["voxel_mm"].toArray();
        QCOMPARE(voxel.at(2).toDouble(), 3.0);
        QVERIFY(!before.contains("smoothed"));
        const std::string bytes = test::fileBytes(m_folder.path("stairs.stl"));
        const Outcome smooth = run({"info", "stairs.stl", "--smooth"});
        QVERIFY2(smooth.out.contains("smoothed: vertices moved by at most "), smooth.out.constData());
        QVERIFY(!smooth.out.contains("--smooth"));
        const QJsonObject after =
            json({"info", "stairs.stl", "--smooth", "--json"})["structures"].toArray().at(0).toObject();
        QVERIFY(after["smoothed"].toObject()["most_moved_mm"].toDouble() > 0.1);
        QVERIFY(after["sha256"] != before["sha256"]);
        QCOMPARE(test::fileBytes(m_folder.path("stairs.stl")), bytes); // the file is never changed
        QVERIFY(!run({"info", "organ.stl"}).out.contains("staircase"));
    }

    void outwardsTurnsWhatIsInsideOut()
    {
        for (const char* command : {"info", "replay"}) {
            QStringList arguments{command, "inverted.stl"};
            if (QByteArray(command) == "replay") {
                arguments << "--motion"
                          << "press.csv";
            }
            const Outcome plain = run(arguments);
            QCOMPARE(plain.exitCode, 0);
            QVERIFY2(plain.out.contains("1 surface is inside out and felt from within only: inverted; --outwards"),
                     plain.out.constData());
            QVERIFY(!run(arguments + QStringList{"--outwards"}).out.contains("inside out and felt"));
        }
        const auto volume = [this](const QStringList& more) {
            return json(QStringList{"info", "inverted.stl", "--json"} + more)["structures"]
                .toArray()
                .at(0)
                .toObject()["volume_mm3"]
                .toDouble();
        };
        QCOMPARE(volume({}), -24000.0);
        QCOMPARE(volume({"--outwards"}), 24000.0);
        const QStringList press{"inverted.stl", "--motion", "press.csv", "--stiffness", "0.5"};
        QCOMPARE(felt_N(press), 0.0);
        QVERIFY(std::abs(felt_N(press + QStringList{"--outwards"}) - 1.0) < 1e-3); // 0.5 N/mm, 2 mm deep
    }

    void closeHolesClosesThoseUpToASize()
    {
        const auto structure = [this](const QStringList& more) {
            return json(QStringList{"info", "open.stl", "--json"} + more)["structures"].toArray().at(0).toObject();
        };
        const std::string bytes = test::fileBytes(m_folder.path("open.stl"));
        QVERIFY(!structure({})["is_closed"].toBool());
        QVERIFY(!structure({"--close-holes", "5"})["is_closed"].toBool());
        const QJsonObject closed = structure({"--close-holes", "200"});
        QVERIFY(closed["is_closed"].toBool());
        QCOMPARE(closed["closed_holes"].toObject()["holes"].toInt(), 1);
        QCOMPARE(closed["volume_mm3"].toDouble(), 24000.0);
        QVERIFY(run({"info", "open.stl", "--close-holes", "200"}).out.contains("1 hole of "));
        QCOMPARE(run({"info", "open.stl", "--close-holes", "-1"}).exitCode, 2);
        QCOMPARE(test::fileBytes(m_folder.path("open.stl")), bytes);
    }

    void filesNamedTogetherAreOneScene()
    {
        const Outcome layered = run({"info", "--layers", "auto", "organ.stl", "lump.stl"});
        QCOMPARE(layered.exitCode, 0);
        QVERIFY2(layered.out.contains("layers: lump lies in organ and is felt below it\n"), layered.out.constData());
        QVERIFY(!layered.out.contains("all is in one layer"));
        const QJsonObject lump = json({"info", "--layers", "auto", "--json", "organ.stl", "lump.stl"}, 1);
        QCOMPARE(lump["structures"].toArray().at(0).toObject()["layer"].toInt(), 1);
        const Outcome flat = run({"info", "organ.stl", "lump.stl"});
        QVERIFY2(flat.out.contains("note: lump lies in organ and in the same layer: it is never felt"),
                 flat.out.constData());
    }

    void replaySaysWhatIsNeverFelt()
    {
        std::filesystem::create_directory(m_folder.path("two"));
        for (const char* name : {"organ.stl", "lump.stl"}) {
            std::filesystem::copy_file(m_folder.path(name), m_folder.path("two") / name);
        }
        const char* const says = "lump lies in organ and in the same layer: it is never felt";
        const Outcome replay = run({"replay", "two", "--motion", "press.csv", "--json", "s.json"});
        QVERIFY2(replay.out.contains(says), replay.out.constData());
        QVERIFY(QByteArray::fromStdString(test::fileBytes(m_folder.path("s.json"))).contains(says));
        QVERIFY(!run({"replay", "two", "--motion", "press.csv", "--layers", "auto"}).out.contains(says));
        const Outcome felt = run({"felt", "two", "--press", "2"});
        QVERIFY2(!felt.out.contains(says), felt.out.constData()); // its table answers for lumps
    }

    /// A recording of smoothed and reoriented surfaces is resimulated without their options.
    void recordingsKeepTheOptions()
    {
        write("steps-inverted.stl", test::maskSurface(test::ballMask(15.0, Vec3(1, 1, 3))), true);
        std::string motion = "x,y,z\n";
        for (int i = 0; i <= 60; ++i) {
            motion += "1,2," + std::to_string(17.0 - 0.1 * i) + "\n";
        }
        (void)m_folder.write("ball.csv", motion);
        const Outcome made = run({"replay", "steps-inverted.stl", "--motion", "ball.csv", "--smooth", "--outwards",
                                  "--record", "r.palpate"});
        QVERIFY2(made.exitCode == 0, made.error.constData());
        const Outcome again = run({"session", "verify", "r.palpate"});
        QVERIFY2(again.exitCode == 0, (again.out + again.error).constData());
    }

    void examinationComesAfterTouch()
    {
        const QByteArray out = run({"info", "organ.stl"}).out;
        QVERIFY(out.indexOf("touch: ") > 0 && out.indexOf("touch: ") < out.indexOf("crossing triangles"));
    }
};

PALPATE_TEST(SurfaceOptions)
#include "tst_SurfaceOptions.moc"
