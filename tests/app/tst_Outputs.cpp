// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Shapes.h"
#include "Program.h"
#include "TestRunner.h"

#include <palpate/session/RecordingReader.h>

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <csignal>
#include <functional>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace palpate;
using core::Vec3;
using test::Outcome;

namespace {

constexpr int kTicks = 60;

QByteArray motion(int rows)
{
    QByteArray text = "x,y,z\n";
    for (int i = 0; i < rows; ++i) {
        text += "0,0," + QByteArray::number(32.0 - 0.2 * (i % kTicks)) + '\n';
    }
    return text;
}

QByteArray obj(const geometry::TriangleMesh& mesh)
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
    return text;
}

} // namespace

/// Tests the output files of the real program: complete or absent, and never over an input file.
class Outputs : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    QString file(const QString& name) const { return m_folder->filePath(name); }
    bool write(const QString& name, const QByteArray& content) const
    {
        QFile out(file(name));
        return out.open(QIODevice::WriteOnly) && out.write(content) == content.size();
    }
    QByteArray read(const QString& name) const
    {
        QFile in(file(name));
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray("nothing");
    }

    /// @param prepare  runs in the child before the program
    Outcome run(const QStringList& arguments, const std::function<void()>& prepare = {}) const
    {
        return test::runProgram(m_folder->path(), arguments, prepare);
    }
    QStringList scratch() const
    {
        return QDir(m_folder->path()).entryList({".palpate-*"}, QDir::AllEntries | QDir::Hidden);
    }

    /// Returns whether an output is complete.
    bool isWhole(const QString& name) const
    {
        const QByteArray content = read(name);
        if (name.endsWith(".palpate")) {
            const auto reader = session::RecordingReader::open(file(name).toStdString());
            return reader.isOk() && reader.value()->extent().isComplete && reader.value()->extent().ticks == kTicks;
        }
        if (name.startsWith("table")) {
            // Fewer rows than without a limit: below some limits, surfaces cannot be read.
            return content.startsWith("session,") && content.endsWith("\r\n");
        }
        return name.endsWith(".csv")   ? content.count('\n') == (name.startsWith("f") ? 2 : kTicks + 1)
               : name.endsWith(".vtp") ? content.startsWith("<") && content.trimmed().endsWith("</VTKFile>")
                                       : QJsonDocument::fromJson(content).isObject();
    }

    QByteArray oldContent(const QString& name) const
    {
        return name.endsWith(".palpate")       ? read("older.palpate")
               : name.endsWith("-surface.vtp") ? QByteArray("an older export, with Name=\"dwell_s\"")
                                               : QByteArray("old");
    }

  private Q_SLOTS:
    void initTestCase()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(write("organ.obj", obj(test::sphere(10, 30.0))));
        QVERIFY(write("lump.obj", obj(test::moved(test::sphere(4, 5.0), Vec3(0, 0, 20)))));
        QVERIFY(write("s.palpate.json",
                      R"({"version": 1, "structures": [{"mesh": "organ.obj", "name": "=1+1", "stiffness_N_per_mm": 0.2},
                          {"mesh": "lump.obj", "name": "lump", "stiffness_N_per_mm": 0.6, "palpable": false,
                           "inside": "=1+1", "young_ratio": 4}],
                          "findings": [{"name": "A", "position": [0, 0, 30], "note": ""}]})"));
        QVERIFY(write("m.csv", motion(kTicks)));
        QVERIFY(write("one.csv", motion(1)));
        QVERIFY(write("long.csv", motion(40'000)));
        QVERIFY(write("in.mrk.json", R"({"@schema": "markups-schema-v1.0.3.json", "markups": [{"type": "Fiducial",
            "coordinateSystem": "LPS", "controlPoints": [{"label": "F", "position": [1, 2, 3]}]}]})"));
        const Outcome made = run({"replay", "s.palpate.json", "--motion", "m.csv", "--record", "r.palpate"});
        QVERIFY2(made.exitCode == 0, made.error.constData());
        QCOMPARE(run({"replay", "s.palpate.json", "--motion", "one.csv", "--record", "older.palpate"}).exitCode, 0);
    }

    void isOldOrNewAtAnyLimitOfSize_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QStringList>("outputs");
        const QStringList replay{"replay", "s.palpate.json", "--motion", "m.csv"};
        QTest::newRow("replay --out") << replay + QStringList{"--out", "o.csv"} << QStringList{"o.csv"};
        QTest::newRow("replay --json") << replay + QStringList{"--json", "o.json"} << QStringList{"o.json"};
        QTest::newRow("replay --record") << replay + QStringList{"--record", "new.palpate"}
                                         << QStringList{"new.palpate"};
        QTest::newRow("replay --record --force")
            << replay + QStringList{"--record", "o.palpate", "--force"} << QStringList{"o.palpate"};
        QTest::newRow("session export --csv")
            << QStringList{"session", "export", "r.palpate", "--csv", "o.csv"} << QStringList{"o.csv"};
        QTest::newRow("session export --vtp")
            << QStringList{"session", "export", "r.palpate", "--vtp", "o.vtp"} << QStringList{"o.vtp", "o-surface.vtp"};
        QTest::newRow("session measure --json")
            << QStringList{"session", "measure", "r.palpate", "--json", "o.json"} << QStringList{"o.json"};
        QTest::newRow("session measure --csv")
            << QStringList{"session", "measure", "r.palpate", "--csv", "table.csv", "--findings", "table-findings.csv"}
            << QStringList{"table.csv", "table-findings.csv"};
        QTest::newRow("session share") << QStringList{"session", "share", "r.palpate", "--out", "o.palpate"}
                                       << QStringList{"o.palpate"};
        QTest::newRow("session recover") << QStringList{"session", "recover", "r.palpate", "--out", "o.palpate"}
                                         << QStringList{"o.palpate"};
        QTest::newRow("felt") << QStringList{"felt",  "s.palpate.json", "--press", "0",
                                             "--vtp", "o.vtp",          "--json",  "o.json"}
                              << QStringList{"o.vtp", "o.json"};
        QTest::newRow("findings") << QStringList{"findings", "s.palpate.json", "--csv", "f.csv", "--markups", "o.json"}
                                  << QStringList{"f.csv", "o.json"};
        QTest::newRow("findings --import")
            << QStringList{"findings", "s.palpate.json", "--import", "in.mrk.json", "--out", "o.palpate.json"}
            << QStringList{"o.palpate.json"};
    }
    void isOldOrNewAtAnyLimitOfSize()
    {
        QFETCH(const QStringList, arguments);
        QFETCH(const QStringList, outputs);
        const auto putOld = [&] {
            for (const QString& name : outputs) {
                (void)QFile::remove(file(name));
                QVERIFY(name.startsWith("new") || write(name, oldContent(name)));
            }
        };
        putOld();
        const Outcome free = run(arguments);
        QVERIFY2(free.exitCode == 0, free.error.constData());
        rlim_t largest = 0;
        for (const QString& name : outputs) {
            QVERIFY2(isWhole(name), qPrintable(name));
            largest = std::max<rlim_t>(largest, static_cast<rlim_t>(QFile(file(name)).size()));
        }
        for (const rlim_t limit : {rlim_t{0}, rlim_t{1}, rlim_t{511}, rlim_t{4096}, rlim_t{16'384}, largest / 3,
                                   largest / 2, largest - 1, largest}) {
            putOld();
            const Outcome full = run(arguments, [limit] {
                const rlimit size{limit, limit};
                ::setrlimit(RLIMIT_FSIZE, &size);
            });
            const QByteArray said = QByteArray::number(qulonglong(limit)) + ": " + full.error;
            for (const QString& name : outputs) {
                const bool isOld = name.startsWith("new") ? !QFile::exists(file(name)) : read(name) == oldContent(name);
                QVERIFY2(isOld || isWhole(name), said.constData());
            }
            if (limit < largest) {
                QVERIFY2((full.exitCode == 2 || full.exitCode == 3) && full.error.startsWith("palpate: "),
                         said.constData());
            } else {
                QVERIFY2(full.exitCode != 1 && full.exitCode != -1, said.constData()); // a journal may be larger
            }
            QCOMPARE(scratch(), QStringList());
        }
    }

    void isNoFileOfTheInput_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("output");
        const QStringList replay{"replay", "s.palpate.json", "--motion", "m.csv"};
        const auto row = [](const QStringList& arguments, const char* output) {
            QTest::newRow(qPrintable(arguments.join(' '))) << arguments << QString(output);
        };
        for (const char* option : {"--out", "--json", "--record"}) {
            row(replay + QStringList{option, "organ.obj"}, "organ.obj");
        }
        row(replay + QStringList{"--force", "--record", "./lump.obj"}, "lump.obj");
        row({"replay", ".", "--motion", "m.csv", "--out", "lump.obj"}, "lump.obj");
        row({"replay", "r.palpate", "--motion", "m.csv", "--out", "organ.obj"}, "organ.obj");
        row({"replay", "s.palpate.json", "--motion", "r.palpate", "--out", "link.csv"}, "r.palpate");
        row({"felt", "s.palpate.json", "--vtp", "organ.obj"}, "organ.obj");
        row({"findings", "s.palpate.json", "--csv", "lump.obj"}, "lump.obj");
        row({"findings", "s.palpate.json", "--import", "in.mrk.json", "--out", "in.mrk.json"}, "in.mrk.json");
        row({"session", "measure", "r.palpate", "--json", "s.palpate.json"}, "s.palpate.json");
        row({"session", "export", "r.palpate", "--csv", "organ.obj"}, "organ.obj");
        row({"session", "export", "r.palpate", "--vtp", "foreign.vtp"}, "foreign-surface.vtp");
        row({"session", "measure", "r.palpate", "--csv", "organ.obj"}, "organ.obj");
        row({"session", "recover", "r.palpate", "--out", "organ.obj"}, "organ.obj");
        row({"session", "share", "r.palpate", "--force", "--out", "organ.obj"}, "organ.obj");
        row({"session", "recover", "r.palpate", "--force", "--out", "organ.obj"}, "organ.obj");
        row({"evaluate", "s.palpate.json", "--motion", "results.csv", "--out", "."}, "results.csv");
        row({"stability", "stability.html.json", "--out", "link.d"}, "stability.html");
        row({"s.palpate.json", "--screenshot", "organ.obj"}, "organ.obj");
    }
    void isNoFileOfTheInput()
    {
        QFETCH(const QStringList, arguments);
        QFETCH(const QString, output);
        (void)QFile::link("r.palpate", file("link.csv"));
        (void)QFile::link(".", file("link.d"));
        QVERIFY(write("foreign-surface.vtp", "<VTKFile>a liver</VTKFile>"));
        QVERIFY(write("results.csv", motion(3)));
        QVERIFY(write("stability.html", obj(test::sphere(2, 10.0))));
        QVERIFY(write("stability.html.json", R"({"version": 1, "structures": [{"mesh": "stability.html"}]})"));
        const QByteArray before = read(output);
        const Outcome outcome = run(arguments);
        QCOMPARE(outcome.exitCode, 2);
        QCOMPARE(outcome.error.count('\n'), 1);
        QVERIFY2(outcome.error.contains("expected another name") || outcome.error.contains("expected a new one") ||
                     outcome.error.contains("expected none"),
                 outcome.error.constData());
        QCOMPARE(read(output), before);
        QCOMPARE(scratch(), QStringList());
    }

    /// A hard link is another name of the input: the input stays unchanged.
    void aSecondNameOfTheInputKeepsIt()
    {
        QCOMPARE(::link(file("m.csv").toUtf8().constData(), file("m2.csv").toUtf8().constData()), 0);
        QCOMPARE(run({"replay", "s.palpate.json", "--motion", "m.csv", "--out", "m2.csv"}).exitCode, 0);
        QCOMPARE(read("m.csv"), motion(kTicks));
        QVERIFY(isWhole("m2.csv"));
    }

    void anExistingRecordingNeedsForce()
    {
        const QStringList replay{"replay", "s.palpate.json", "--motion", "m.csv", "--record", "k.palpate"};
        QVERIFY(write("k.palpate", read("older.palpate")));
        const Outcome refused = run(replay);
        QCOMPARE(refused.exitCode, 2);
        QVERIFY2(refused.error.contains("--force"), refused.error.constData());
        QCOMPARE(read("k.palpate"), read("older.palpate"));
        QCOMPARE(run(replay + QStringList{"--force"}).exitCode, 0);
        QVERIFY(isWhole("k.palpate"));
        QVERIFY(QFile::remove(file("k.palpate")));
        QCOMPARE(run(replay + QStringList{"--force"}).exitCode, 0);
        for (const char* suffix : {"-journal", "-wal", "-shm"}) { // of another program
            QVERIFY(QFile::remove(file("k.palpate")) && write(QString("k.palpate") + suffix, "theirs"));
            QCOMPARE(run(replay).exitCode, 2);
            QCOMPARE(read(QString("k.palpate") + suffix), QByteArray("theirs"));
            QVERIFY(!QFile::exists(file("k.palpate")));
            QVERIFY(write("k.palpate", "old"));
            QCOMPARE(run({"session", "recover", "r.palpate", "--force", "--out", "k.palpate"}).exitCode, 2);
            QCOMPARE(read(QString("k.palpate") + suffix), QByteArray("theirs"));
            QVERIFY(QFile::remove(file(QString("k.palpate") + suffix)));
        }
    }

    void twoWritersHaveTwoFiles()
    {
        QProcess first;
        test::startProgram(first, m_folder->path(),
                           {"replay", "s.palpate.json", "--motion", "long.csv", "--live", "--record", "t.palpate"});
        PALPATE_TRY_VERIFY(QFile::exists(file("t.palpate")));
        const QStringList second{"replay", "s.palpate.json", "--motion", "m.csv", "--record", "t.palpate"};
        QCOMPARE(run(second).exitCode, 2);
        for (const QStringList& other :
             {second + QStringList{"--force"}, QStringList{"session", "recover", "r.palpate", "--out", "t.palpate"}}) {
            const Outcome outcome = run(other);
            QCOMPARE(outcome.exitCode, 2);
            QVERIFY2(outcome.error.contains("another program is recording into it"), outcome.error.constData());
        }
        QCOMPARE(first.state(), QProcess::Running);
        first.kill();
        QVERIFY(first.waitForFinished());
        const auto prefix = session::RecordingReader::open(file("t.palpate").toStdString());
        QVERIFY2(prefix.isOk(), prefix.status().message().c_str());
        QVERIFY(!prefix.value()->extent().isComplete);
        QVERIFY2(prefix.value()->verify().isOk(), prefix.value()->verify().message().c_str());
        // A recording without an active writer can be replaced.
        QVERIFY(QFile::remove(file("t.palpate-journal")) || !QFile::exists(file("t.palpate-journal")));
        QCOMPARE(run(second + QStringList{"--force"}).exitCode, 0);
        QVERIFY(isWhole("t.palpate"));
    }

    void signalsLeaveTheOldFile_data()
    {
        QTest::addColumn<int>("signal");
        QTest::newRow("TERM") << SIGTERM;
        QTest::newRow("INT") << SIGINT;
        QTest::newRow("HUP") << SIGHUP;
        QTest::newRow("KILL") << SIGKILL;
    }
    void signalsLeaveTheOldFile()
    {
        QFETCH(const int, signal);
        QVERIFY(write("o.csv", "old") && write("o.palpate", read("older.palpate")));
        QProcess process;
        test::startProgram(process, m_folder->path(),
                           {"replay", "s.palpate.json", "--motion", "long.csv", "--live", "--out", "o.csv", "--record",
                            "o.palpate", "--force"},
                           [] {
                               for (const int one : {SIGTERM, SIGINT, SIGHUP}) {
                                   (void)std::signal(one, SIG_DFL); // the test's shell may ignore some signals
                               }
                           });
        PALPATE_TRY_VERIFY(scratch().size() == 2);
        QCOMPARE(::kill(static_cast<pid_t>(process.processId()), signal), 0);
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitStatus(), QProcess::CrashExit);
        QCOMPARE(scratch().size(), signal == SIGKILL ? 2 : 0);
        QCOMPARE(read("o.csv"), QByteArray("old"));
        QCOMPARE(read("o.palpate"), read("older.palpate"));
        QCOMPARE(run({"findings", "s.palpate.json", "--csv", "f.csv"}).exitCode, 0);
        QCOMPARE(scratch(), QStringList()); // the next start removes temporary files
    }

    void standardStreams()
    {
        const QStringList replay{"replay", "s.palpate.json", "--motion", "m.csv"};
        for (const QStringList& arguments : {replay + QStringList{"--out", "/dev/stdout"},
                                             QStringList{"session", "export", "r.palpate", "--csv", "/dev/stdout"},
                                             QStringList{"findings", "s.palpate.json", "--csv", "/dev/stdout"}}) {
            const Outcome outcome = run(arguments);
            QVERIFY2(outcome.exitCode == 0, outcome.error.constData());
            QVERIFY2(outcome.out.contains("tick,hip_x") || outcome.out.contains("id,name"), outcome.out.constData());
        }
        QCOMPARE(run({"session", "export", "r.palpate", "--csv", "/dev/null"}).exitCode, 0);
        QCOMPARE(run({"session", "export", "r.palpate", "--csv", "/dev/full"}).exitCode, 2);
        for (const QStringList& arguments : {QStringList{"info", "organ.obj"}, QStringList{"--version"},
                                             QStringList{"session", "measure", "r.palpate", "--json", "-"}}) {
            const Outcome outcome = run(arguments, [] { (void)::close(STDOUT_FILENO); });
            QCOMPARE(outcome.exitCode, 1);
            QVERIFY2(outcome.error.contains("the output could not be written"), outcome.error.constData());
        }
        const Outcome none = run(replay + QStringList{"--out", "c.csv"}, [] {
            for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
                (void)::close(stream);
            }
        });
        QCOMPARE(none.exitCode, 1);
        QVERIFY(isWhole("c.csv")); // and no output on the standard streams
        QCOMPARE(::mkfifo(file("fifo").toUtf8().constData(), 0600), 0);
        for (const QStringList& arguments : {replay + QStringList{"--record", "fifo"},
                                             QStringList{"session", "recover", "r.palpate", "--out", "fifo"}}) {
            const Outcome outcome = run(arguments);
            QCOMPARE(outcome.exitCode, 2);
            QVERIFY2(outcome.error.contains("not a file"), outcome.error.constData());
        }
    }

    /// One tick between two losses, or a hand that was present for one tick: a line of one point.
    void aPathOfOnePointIsAVertex()
    {
        const Outcome outcome = run({"session", "export", "older.palpate", "--vtp", "p.vtp"});
        QVERIFY2(outcome.exitCode == 3 && outcome.error.contains("no surface that is there was touched"),
                 outcome.error.constData());
        vtkNew<vtkXMLPolyDataReader> reader;
        reader->SetFileName(file("p.vtp").toUtf8().constData());
        reader->Update();
        QCOMPARE(reader->GetOutput()->GetNumberOfPoints(), vtkIdType{1});
        QCOMPARE(reader->GetOutput()->GetNumberOfVerts(), vtkIdType{1});
        QCOMPARE(reader->GetOutput()->GetNumberOfLines(), vtkIdType{0});
    }

    void namesAreNoFormulas()
    {
        QCOMPARE(run({"replay", "s.palpate.json", "--motion", "m.csv", "--out", "n.csv"}).exitCode, 0);
        QVERIFY2(read("n.csv").contains(",'=1+1,"), read("n.csv").right(300).constData());
        QVERIFY(!read("n.csv").contains(",=1+1"));
        QVERIFY2(read("n.csv").contains(",%3D1+1="), read("n.csv").right(300).constData()); // the column `layers`
    }
};

PALPATE_TEST(Outputs)
#include "tst_Outputs.moc"
