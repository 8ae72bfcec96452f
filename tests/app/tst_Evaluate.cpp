// SPDX-License-Identifier: BSD-3-Clause
// Tests `palpate evaluate` from the command line: exit codes, output files, and the reaction to Ctrl-C.
#include "../support/Shapes.h"
#include "Program.h"
#include "TestRunner.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include <memory>

#include <csignal>

using namespace palpate;
using core::Vec3;

class Evaluate : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    QString file(const QString& name) const { return m_folder->filePath(name); }

    void write(const QString& name, const QByteArray& text) const
    {
        QFile out(file(name));
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(text);
    }

    void writeObj(const QString& name, const geometry::TriangleMesh& mesh) const
    {
        QByteArray text;
        for (const Vec3& v : mesh.vertices) {
            text += "v " + QByteArray::number(v.x()) + ' ' + QByteArray::number(v.y()) + ' ' +
                    QByteArray::number(v.z()) + '\n';
        }
        for (const geometry::Triangle& t : mesh.triangles) {
            text += "f " + QByteArray::number(t[0] + 1) + ' ' + QByteArray::number(t[1] + 1) + ' ' +
                    QByteArray::number(t[2] + 1) + '\n';
        }
        write(name, text);
    }

    int exitCodeOf(const QStringList& arguments, QByteArray* error = nullptr) const
    {
        const test::Outcome outcome = test::runProgram(m_folder->path(), QStringList{"evaluate"} + arguments);
        if (error != nullptr) {
            *error = outcome.error;
        }
        return outcome.exitCode;
    }

  private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QDir(m_folder->path()).mkdir("organs");
        writeObj("organs/box.obj", test::box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 3));
        writeObj("organs/ball.obj", test::sphere(4, 8.0));
        QByteArray csv = "x,y,z\n";
        for (int i = 0; i < 200; ++i) {
            csv += QByteArray::number(0.02 * i) + ",1," + QByteArray::number(i < 100 ? 12 - 0.04 * i : 8) + '\n';
        }
        write("m.csv", csv);
    }

    void wrongCommandLinesEndWithCode2_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("no such scene") << QStringList{"nothing.stl", "--out", "x"};
        QTest::newRow("no such motion") << QStringList{"organs", "--motion", "none.csv", "--out", "x"};
        QTest::newRow("not a motion") << QStringList{"organs", "--motion", "organs/box.obj", "--out", "x"};
        QTest::newRow("folder that can't be made") << QStringList{"organs", "--out", "m.csv/x"};
        QTest::newRow("unit") << QStringList{"organs", "--unit", "inch", "--out", "x"};
        QTest::newRow("lumps of a scene") << QStringList{"organs", "--felt", "--out", "x"};
        QTest::newRow("no path") << QStringList{"organs", "--seeds", "0", "--out", "x"};
        QTest::newRow("seeds") << QStringList{"organs", "--seeds", "many", "--out", "x"};
        QTest::newRow("stiffness") << QStringList{"organs", "--stiffness", "-1", "--out", "x"};
    }
    void wrongCommandLinesEndWithCode2()
    {
        QFETCH(QStringList, arguments);
        QByteArray error;
        QCOMPARE(exitCodeOf(arguments, &error), 2);
        QCOMPARE(error.count('\n'), qsizetype(1));
        QVERIFY(QDir(file("x")).entryList(QDir::Files).isEmpty());
    }

    void aProgramAloneSaysWhatItMisses_data()
    {
        QTest::addColumn<QString>("command");
        QTest::newRow("evaluate") << "evaluate";
        QTest::newRow("stability") << "stability";
    }
    void aProgramAloneSaysWhatItMisses()
    {
        QFETCH(QString, command);
        QVERIFY(QFile::copy(PALPATE_EXECUTABLE, file("palpate")));
        QProcess process;
        process.start(file("palpate"), {command, "organs"});
        QVERIFY(process.waitForFinished(60000));
        QCOMPARE(process.exitCode(), 1);
        const QByteArray error = process.readAllStandardError();
        QCOMPARE(error.count('\n'), qsizetype(1));
        QVERIFY2(error.contains(file("palpate-evaluation").toUtf8() + ": No such file"), error);
        QVERIFY2(error.contains("build all of Palpate"), error);
    }

    void whatIsWrittenGoesBelowOut_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("folder");
        QTest::newRow("evaluate") << QStringList{"evaluate", "m.csv"} << "out/evaluation";
        QTest::newRow("stability") << QStringList{"stability", "m.csv"} << "out/stability";
        QTest::newRow("evaluate, said") << QStringList{"evaluate", "m.csv", "--out", "out/e"} << "out/e";
        QTest::newRow("stability, said") << QStringList{"stability", "m.csv", "--out", "out/s"} << "out/s";
    }
    void whatIsWrittenGoesBelowOut()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, folder);
        // No mesh; the output folder is created before the input is read.
        QCOMPARE(test::runProgram(m_folder->path(), arguments).exitCode, 2);
        QVERIFY(QDir(file(folder)).exists());
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
                 (QStringList{"m.csv", "organs", "out"}));
        QCOMPARE(QDir(file("out")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot), QStringList{folder.mid(4)});
    }

    void aFolderIsEvaluatedAndItsLossesAreNamed()
    {
        write("organs/broken.stl", "no mesh at all");
        QByteArray error;
        QCOMPARE(exitCodeOf({"organs", "--quick", "--motion", "m.csv", "--stiffness", "0.7", "--out", "a/b"}, &error),
                 3);
        QVERIFY(error.contains("broken.stl"));
        QCOMPARE(QDir(file("a/b")).entryList(QDir::Files | QDir::Hidden),
                 (QStringList{"chart.svg", "hard_cases.csv", "report.html", "results.csv", "results.json"}));
        QFile json(file("a/b/results.json"));
        QVERIFY(json.open(QIODevice::ReadOnly));
        const QJsonObject all = QJsonDocument::fromJson(json.readAll()).object();
        QCOMPARE(all["motions"].toArray(), QJsonArray{"m.csv"});
        const QJsonArray structures = all["subjects"][0].toObject()["structures"].toArray();
        QCOMPARE(structures.size(), qsizetype(2));
        QCOMPARE(structures[0]["stiffness_n_per_mm"].toDouble(), 0.7);
        QVERIFY(all["hard_cases"].toArray().size() > 0);
    }

    void whatIsSaidOfBuriedLumpsIsProvedWithoutAScene()
    {
        QCOMPARE(exitCodeOf({"--felt", "--quick", "--out", "f"}), 0);
        QCOMPARE(QDir(file("f")).entryList(QDir::Files | QDir::Hidden),
                 (QStringList{"felt-cover.svg", "felt-estimate.svg", "felt.csv", "felt.html"}));
    }

    void withoutASceneThePhantomIsTakenAndCtrlCLeavesNothing()
    {
        QProcess process;
        process.setReadChannel(QProcess::StandardError); // what waitForReadyRead waits for
        test::startProgram(process, m_folder->path(), {"evaluate", "--quick", "--out", "out"});
        QByteArray progress;
        while (!progress.contains("phantom") && process.waitForReadyRead(test::kPatience_ms)) {
            progress += process.readAllStandardError();
        }
        QVERIFY2(progress.contains("phantom"), progress);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(test::kPatience_ms));
        QVERIFY(process.exitStatus() == QProcess::CrashExit); // killed by the signal, as shells expect
        QVERIFY(QDir(file("out")).entryList(QDir::Files | QDir::Hidden).isEmpty());
    }
};

PALPATE_TEST(Evaluate)
#include "tst_Evaluate.moc"
