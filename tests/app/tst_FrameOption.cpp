// SPDX-License-Identifier: BSD-3-Clause
#include "../meshio/Samples.h"
#include "../support/Shapes.h"
#include "Program.h"
#include "TestRunner.h"

#include <palpate/session/RecordingReader.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

using namespace palpate;
using core::FileFrame;
using core::Vec3;
using test::Outcome;

/// Tests `--frame`: the axes of mesh files, on the command line and in recordings.
class FrameOption : public QObject
{
    Q_OBJECT

    test::Folder m_folder;

    Outcome run(const QStringList& arguments) const
    {
        return test::runProgram(QString::fromStdString(m_folder.path("").string()), arguments);
    }

    QJsonObject infoOf(const QStringList& arguments) const
    {
        const Outcome outcome = run(QStringList{"info", "--json"} + arguments);
        return QJsonDocument::fromJson(outcome.out).array().at(0)["structures"].toArray().at(0).toObject();
    }

    FileFrame recordedFrame() const
    {
        const auto reader = session::RecordingReader::open(m_folder.path("r.palpate"));
        return reader.isOk() ? reader.value()->scenes().at(0).structures.at(0).source.frame : FileFrame::YUp;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        // A shape without rotational symmetry; its top is at z = 10.
        const geometry::TriangleMesh box = test::box(Vec3(-10, -5, -10), Vec3(12, 15, 10), 3);
        std::string obj;
        for (const Vec3& p : box.vertices) {
            obj += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + "\n";
        }
        for (const geometry::Triangle& t : box.triangles) {
            obj += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " + std::to_string(t[2] + 1) +
                   "\n";
        }
        (void)m_folder.write("plain.obj", obj);
        (void)m_folder.write("tagged.obj", "# SPACE=LPS\n" + obj);
        (void)m_folder.write("s.palpate.json",
                             R"({"version": 1, "structures": [{"mesh": "plain.obj", "frame": "RAS"}]})");
        std::string motion = "x,y,z\n";
        for (int i = 0; i < 200; ++i) {
            motion += "0.1,0.2," + std::to_string(11.0 - 0.02 * i) + "\n";
        }
        (void)m_folder.write("m.csv", motion);
    }

    void infoSaysWhereItIsKnownFrom_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("frame");
        QTest::addColumn<QString>("from");
        QTest::addColumn<double>("low_y");
        const QString assumed("assumed: the file has no SPACE tag"), read("the file's SPACE tag"), chosen("chosen");
        QTest::newRow("assumed") << QStringList{"plain.obj"} << "LPS" << assumed << -5.0;
        QTest::newRow("read") << QStringList{"tagged.obj"} << "LPS" << read << -5.0;
        QTest::newRow("LPS") << QStringList{"plain.obj", "--frame", "LPS"} << "LPS" << chosen << -5.0;
        QTest::newRow("RAS") << QStringList{"plain.obj", "--frame", "RAS"} << "RAS" << chosen << -15.0;
        QTest::newRow("over the tag") << QStringList{"tagged.obj", "--frame", "RAS"} << "RAS" << chosen << -15.0;
        QTest::newRow("Y-up") << QStringList{"plain.obj", "--frame", "Y-up"} << "Y-up" << chosen << -10.0;
        QTest::newRow("scene") << QStringList{"s.palpate.json"} << "RAS" << chosen << -15.0;
    }
    void infoSaysWhereItIsKnownFrom()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, frame);
        QFETCH(QString, from);
        QFETCH(double, low_y);
        const QJsonObject one = infoOf(arguments);
        QCOMPARE(one["frame"].toString(), frame);
        QCOMPARE(one["frame_from"].toString(), from);
        QCOMPARE(one["low_mm"].toArray().at(1).toDouble(), low_y);
        QCOMPARE(one["orientation"].toString(), QString("outwards"));
        const Outcome text = run(QStringList{"info"} + arguments);
        QVERIFY2(text.out.contains(("frame " + frame + " (" + from + ")").toUtf8()), text.out);
        QCOMPARE(text.out.contains("tagged SPACE=LPS, but taken as RAS, as was chosen"),
                 QLatin1String(QTest::currentDataTag()) == QLatin1String("over the tag"));
    }

    void anotherWordIsRefused_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("info") << QStringList{"info", "plain.obj"};
        QTest::newRow("replay") << QStringList{"replay", "plain.obj", "--motion", "m.csv"};
        QTest::newRow("evaluate") << QStringList{"evaluate", "plain.obj", "--out", "x"};
        QTest::newRow("stability") << QStringList{"stability", "plain.obj", "--out", "x"};
        QTest::newRow("window") << QStringList{"plain.obj"};
    }
    void anotherWordIsRefused()
    {
        QFETCH(QStringList, arguments);
        for (const char* word : {"LAS", "ras", "Yup"}) {
            const Outcome outcome = run(arguments + QStringList{"--frame", word});
            QCOMPARE(outcome.exitCode, 2);
            QCOMPARE(outcome.error,
                     "palpate: --frame: found \"" + QByteArray(word) + "\", expected LPS, RAS or Y-up\n");
        }
    }

    /// A recording stores the chosen frame: the mesh is read the same way again.
    void recordingsKeepIt_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<FileFrame>("frame");
        QTest::newRow("not chosen") << QStringList{"plain.obj"} << FileFrame::Untagged;
        QTest::newRow("RAS") << QStringList{"plain.obj", "--frame", "RAS"} << FileFrame::Ras;
        QTest::newRow("Y-up") << QStringList{"plain.obj", "--frame", "Y-up"} << FileFrame::YUp;
        QTest::newRow("over the tag") << QStringList{"tagged.obj", "--frame", "RAS"} << FileFrame::Ras;
        QTest::newRow("scene") << QStringList{"s.palpate.json"} << FileFrame::Ras;
    }
    void recordingsKeepIt()
    {
        QFETCH(QStringList, arguments);
        QFETCH(FileFrame, frame);
        std::filesystem::remove(m_folder.path("r.palpate"));
        const Outcome made =
            run(QStringList{"replay"} + arguments + QStringList{"--motion", "m.csv", "--record", "r.palpate"});
        QVERIFY2(made.exitCode == 0, made.error);
        QCOMPARE(recordedFrame(), frame);
        const Outcome verified = run({"session", "verify", "r.palpate"});
        QCOMPARE(verified.error, QByteArray());
        QVERIFY2(verified.out.contains("the same bit for bit"), verified.out);
        const Outcome again = run(QStringList{"replay"} + arguments + QStringList{"--motion", "r.palpate"});
        QVERIFY2(again.exitCode == 0 && again.out.contains("the same bit for bit"), again.error);
        if (frame == FileFrame::Ras && arguments.contains("plain.obj")) { // in another frame the surface differs
            QCOMPARE(run({"replay", "plain.obj", "--motion", "r.palpate"}).exitCode, 2);
        }
    }
};

PALPATE_TEST(FrameOption)
#include "tst_FrameOption.moc"
