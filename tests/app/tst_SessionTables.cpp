// SPDX-License-Identifier: BSD-3-Clause
#include "../meshio/Samples.h"
#include "Program.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include <cmath>
#include <filesystem>
#include <span>

using namespace palpate;
using core::Vec3;
using test::Outcome;

/// Tests the tables of `session measure` over files and folders, `session share`, and the chosen columns of
/// `session export`.
class SessionTables : public QObject
{
    Q_OBJECT

    test::Folder m_folder;

    QString file(const QString& name) const
    {
        return QString::fromStdString((m_folder.path("") / name.toStdString()).string());
    }
    Outcome run(const QStringList& arguments) const { return test::runProgram(file(""), arguments); }
    QByteArray read(const QString& name) const
    {
        QFile in(file(name));
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }
    QList<QByteArray> lines(const QString& name) const
    {
        QList<QByteArray> all = read(name).split('\n');
        all.removeLast();
        return all;
    }
    static void copy(const QString& from, const QString& to)
    {
        QFile::remove(to);
        QVERIFY2(QFile::copy(from, to), qPrintable(to));
    }

  private Q_SLOTS:

    void initTestCase()
    {
        QVERIFY(QDir(file("")).mkpath("all/a") && QDir(file("")).mkpath("all/b") && QDir(file("")).mkpath("empty"));
        const meshio::MeshStructure box{"box", test::box(Vec3(-20, -20, -20), Vec3(20, 20, 20), 4), std::nullopt};
        for (const char* name : {"box.stl", "all/box.stl", "all/a/box.stl", "all/b/box.stl"}) {
            QVERIFY(meshio::writeMesh(m_folder.path(name), std::span(&box, 1)).isOk());
        }
        QByteArray motion = "x,y,z\n";
        for (int i = 0; i < 500; ++i) {
            motion += "0.02,0.3," + QByteArray::number(20.5 - 3.0 * std::sin(i * 3.14159 / 500)) + '\n';
        }
        m_folder.write("m.csv", motion.toStdString());
        const Outcome made = run({"replay", "box.stl", "--motion", "m.csv", "--record", "r.palpate"});
        QVERIFY2(made.exitCode == 0, made.error.constData());
        for (const char* name : {"all/a/same.palpate", "all/b/same.palpate", "all/x, \"y\".palpate"}) {
            copy(file("r.palpate"), file(name));
        }
    }

    void aTableHasOneRowPerMeasure()
    {
        const Outcome outcome = run({"session", "measure", "r.palpate", "--csv", "t.csv", "--findings", "f.csv"});
        QCOMPARE(outcome.error, QByteArray());
        QCOMPARE(outcome.exitCode, 0);
        const QList<QByteArray> table = lines("t.csv");
        QCOMPARE(table[0], QByteArray("session,sha256,started_utc,device,structure,measure,value,unit\r"));
        const Outcome json = run({"session", "measure", "r.palpate", "--json", "-"});
        const QJsonObject all = QJsonDocument::fromJson(json.out).object();
        const auto value = [&](const QByteArray& structure, const QByteArray& measure, const QByteArray& unit) {
            const QRegularExpression row(
                QString("^r\\.palpate,[0-9a-f]{64},[^,]+,replay,%1,%2,([^,]*),%3\r$").arg(structure, measure, unit));
            for (const QByteArray& line : table) {
                if (const auto match = row.match(QString::fromUtf8(line)); match.hasMatch()) {
                    return match.captured(1).toDouble();
                }
            }
            return -1.0;
        };
        const QJsonObject box = all["structures"].toObject()["box"].toObject();
        QCOMPARE(value("", "peak_force_N", "N"), all["peak_force_N"].toDouble());
        QCOMPARE(value("", "ticks", "1"), 500.0);
        QCOMPARE(value("", "damaged_parts", "1"), 0.0);
        QCOMPARE(value("box", "coverage", "1"), box["coverage"].toDouble());
        QCOMPARE(value("box", "area_mm2", "mm2"), box["area_mm2"].toDouble());
        QCOMPARE(value("box", "press_time_s", "s"), box["press"].toObject()["time_s"].toDouble());
        QVERIFY(value("", "press_time_s", "s") > 0.0);
        QVERIFY(read("f.csv").startsWith("session,sha256,started_utc,device,id,name,"));
    }

    void foldersAreSearchedAndNamesDiffer()
    {
        const Outcome outcome = run({"session", "measure", "all", "r.palpate", "./r.palpate", "--csv", "t.csv"});
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY2(outcome.out.contains("4 of 4 sessions measured"), outcome.out.constData());
        const QByteArray table = read("t.csv");
        for (const char* name :
             {"\na/same.palpate,", "\nb/same.palpate,", "\n\"x, \"\"y\"\".palpate\",", "\nr.palpate,"}) {
            QVERIFY2(table.contains(name), name);
        }
        // Two files of one name get their folders.
        QCOMPARE(run({"session", "measure", "all/a/same.palpate", "all/b/same.palpate", "--csv", "u.csv"}).exitCode, 0);
        QVERIFY(read("u.csv").contains("\na/same.palpate,") && read("u.csv").contains("\nb/same.palpate,"));
    }

    void aBadFileIsALossAndTheRestIsWritten()
    {
        copy(file("r.palpate"), file("cut.palpate"));
        QVERIFY(QFile(file("cut.palpate")).resize(2000));
        m_folder.write("text.palpate", "not a recording");
        const Outcome outcome = run({"session", "measure", "cut.palpate", "text.palpate", "gone.palpate", "empty",
                                     "r.palpate", "--csv", "t.csv"});
        QCOMPARE(outcome.exitCode, 3);
        for (const char* name : {"cut.palpate: ", "text.palpate: ", "gone.palpate: ", "empty: found no recording"}) {
            QVERIFY2(outcome.error.contains(name), outcome.error.constData());
        }
        QVERIFY(read("t.csv").contains("\nr.palpate,") && !read("t.csv").contains("\ntext.palpate,"));
        // Nothing is written when there is nothing to write.
        QFile::remove(file("none.csv"));
        QCOMPARE(run({"session", "measure", "empty", "text.palpate", "--csv", "none.csv"}).exitCode, 2);
        QVERIFY(!QFile::exists(file("none.csv")));
    }

    void wrongCommandLinesAreRefused_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("error");
        const auto row = [](const QStringList& arguments, const char* error) {
            QTest::newRow(qPrintable(arguments.join(' '))) << arguments << QByteArray(error);
        };
        row({"session", "measure", "r.palpate", "all/a/same.palpate"}, "expected --csv or --findings");
        row({"session", "measure", "all"}, "expected --csv or --findings");
        row({"session", "measure", "all", "--csv", "t.csv", "--json", "-"}, "--json");
        row({"session", "measure", "all", "--csv", "all/a/same.palpate"}, "expected another name");
        row({"session", "measure", "all", "--csv", "t.csv", "--findings", "./t.csv"}, "two outputs");
        row({"session", "measure", "all", "--csv", "/dev/full"}, "/dev/full");
        row({"session", "measure", "all", "--csv", "t.csv", "--distance", "0"}, "--distance");
        row({"session", "share", "r.palpate", "--out", "r.palpate"}, "expected another name");
        row({"session", "share", "r.palpate", "--out", "m.csv"}, "no recording");
        row({"session", "share", "r.palpate", "--out", "/dev/full"}, "/dev/full");
        row({"session", "share", "m.csv", "--out", "s.palpate"}, "m.csv");
        row({"session", "export", "r.palpate", "--csv", "t.csv", "--columns", "time_s,speed"}, "\"speed\"");
        row({"session", "export", "r.palpate", "--csv", "t.csv", "--columns", "tick,tick"}, "twice");
        row({"session", "export", "r.palpate", "--vtp", "t.vtp", "--columns", "tick"}, "--csv");
    }
    void wrongCommandLinesAreRefused()
    {
        QFETCH(const QStringList, arguments);
        QFETCH(const QByteArray, error);
        const QByteArray before = read("r.palpate");
        const Outcome outcome = run(arguments);
        QVERIFY2(outcome.exitCode == 2, outcome.error.constData());
        QVERIFY2(outcome.error.contains(error), outcome.error.constData());
        QCOMPARE(read("r.palpate"), before);
    }

    void columnsAreThoseOfTheWholeTable()
    {
        QCOMPARE(run({"session", "export", "r.palpate", "--csv", "all.csv"}).exitCode, 0);
        const QStringList names{"time_s", "force_N", "structure", "hip_z", "god_x", "tick", "layers", "events"};
        QCOMPARE(run({"session", "export", "r.palpate", "--csv", "some.csv", "--columns", names.join(',')}).exitCode,
                 0);
        const QList<QByteArray> all = lines("all.csv"), some = lines("some.csv");
        QCOMPARE(some.size(), all.size());
        const QList<QByteArray> head = all[0].split(',');
        for (qsizetype i = 0; i < all.size(); ++i) { // no text of these rows has a comma
            const QList<QByteArray> cells = all[i].split(',');
            QByteArray expected;
            for (const QString& name : names) {
                expected += (name == names[0] ? "" : ",") + cells[head.indexOf(name.toUtf8())];
            }
            QCOMPARE(some[i], expected);
        }
    }

    /// The copy beside the mesh is verified like the original; it contains no part of the folder's path.
    void aSharedCopyIsVerified()
    {
        const Outcome shared = run({"session", "share", "all/a/same.palpate", "--out", "all/b/shared.palpate"});
        QVERIFY2(shared.exitCode == 0, shared.error.constData());
        const Outcome verified = run({"session", "verify", "all/b/shared.palpate"});
        QVERIFY2(verified.exitCode == 0, verified.error.constData());
        QVERIFY(verified.out.contains("the same bit for bit"));
        QVERIFY(!read("all/b/shared.palpate").contains(file("").toUtf8()));
        QFile::remove(file("all/b/shared.palpate"));
    }
};

PALPATE_TEST(SessionTables)
#include "tst_SessionTables.moc"
