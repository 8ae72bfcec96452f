// SPDX-License-Identifier: BSD-3-Clause
// Tests `palpate replay` of a recording on a different scene: the message about the difference.
#include "../meshio/Samples.h"
#include "../support/Shapes.h"
#include "Program.h"
#include "TestRunner.h"

#include <QFile>

using namespace palpate;
using core::Vec3;
using test::Outcome;

class ReplayedScene : public QObject
{
    Q_OBJECT

    test::Folder m_folder;

    QString path(const char* name) const { return QString::fromStdString(m_folder.path(name).string()); }

    Outcome replay(const QStringList& arguments) const
    {
        return test::runProgram(path(""), QStringList{"replay"} + arguments);
    }
    void write(const char* name, const QByteArray& text) const
    {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    }
    void write(const char* name, const geometry::TriangleMesh& mesh) const
    {
        QByteArray text;
        for (const Vec3& v : mesh.vertices) {
            text += "v " + QByteArray::number(v.x(), 'g', 12) + ' ' + QByteArray::number(v.y(), 'g', 12) + ' ' +
                    QByteArray::number(v.z(), 'g', 12) + '\n';
        }
        for (const geometry::Triangle& t : mesh.triangles) {
            text += "f " + QByteArray::number(t[0] + 1) + ' ' + QByteArray::number(t[1] + 1) + ' ' +
                    QByteArray::number(t[2] + 1) + '\n';
        }
        write(name, text);
    }
    /// @param scene  fields of the scene
    /// @param lump  fields of the lump
    void writeScene(const char* name, const QByteArray& scene, const QByteArray& lump) const
    {
        write(name, R"({"version": 1, )" + scene + R"("structures": [)" +
                        R"({"mesh": "organ.obj", "stiffness_N_per_mm": 0.2, "layer": 0}, )" +
                        R"({"mesh": "lump.obj", "stiffness_N_per_mm": 0.6)" + lump + "}]}");
    }

  private Q_SLOTS:
    void initTestCase()
    {
        write("organ.obj", test::sphere(20, 80.0));
        write("lump.obj", test::moved(test::sphere(6, 10.0), Vec3(0, 0, 62)));
        writeScene("layers.json", "", R"(, "layer": 1)");
        writeScene("felt.json", R"("buried": "felt", )", R"(, "inside": "organ", "young_ratio": 3)");
        writeScene("seen.json", "", R"(, "layer": 1, "palpable": false)");
        write("other.obj", test::sphere(10, 80.0));
        write("other.json", R"({"version": 1, "structures": [{"mesh": "other.obj"}]})");
        QByteArray csv = "x,y,z\n";
        for (int i = 0; i < 300; ++i) {
            csv += "1,2," + QByteArray::number(82.0 - 0.05 * i) + '\n';
        }
        write("press.csv", csv);
        QCOMPARE(replay({"layers.json", "--motion", "press.csv", "--record", "press.palpate"}).exitCode, 0);
        QCOMPARE(replay({"layers.json", "--motion", "press.palpate"}).exitCode, 0);
    }

    void namesWhatIsTouchedOtherwise_data()
    {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<QString>("reason");
        QTest::newRow("felt through its organ") << "felt.json"
                                                << "felt.json: structure \"lump\" was touched by itself in the "
                                                   "recording (layer 1), here it is felt through "
                                                   "the structure around it";
        QTest::newRow("seen only") << "seen.json"
                                   << "seen.json: structure \"lump\" was touched by itself in the recording (layer 1), "
                                      "here it is not palpable";
        QTest::newRow("another mesh") << "other.json"
                                      << "its geometry (SHA-256";
    }
    void namesWhatIsTouchedOtherwise()
    {
        QFETCH(QString, scene);
        QFETCH(QString, reason);
        const Outcome outcome = replay({scene, "--motion", "press.palpate"});
        QCOMPARE(outcome.exitCode, 2);
        QVERIFY2(outcome.error.contains(reason.toUtf8()), outcome.error.constData());
        QVERIFY2(outcome.error.contains("expected the scene that was recorded, or --force"), outcome.error.constData());
        QCOMPARE(outcome.error.count('\n'), qsizetype(1));
        QCOMPARE(replay({scene, "--motion", "press.palpate", "--force"}).exitCode, 0);
    }
};

PALPATE_TEST(ReplayedScene)
#include "tst_ReplayedScene.moc"
