// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Shapes.h"
#include "Program.h"
#include "TestRunner.h"

#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include <sqlite3.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkVersionMacros.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <cstring>
#include <functional>

using namespace palpate;
using core::Vec3;
using test::Outcome;

namespace {

/// A row of a tick table.
struct Row
{
    int tick = 0;
    Vec3 hip, god, force;
    int constraints = 0;
    QByteArray structure;
    int solve_ns = 0;
    Vec3 normal;
    QByteArray slides, layers;
};

Vec3 vector(const QList<QByteArray>& fields, int first)
{
    return {fields[first].toDouble(), fields[first + 1].toDouble(), fields[first + 2].toDouble()};
}

} // namespace

/// Runs the real executable in a separate folder and checks exit code, output and files.
class CommandLine : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    QString file(const char* name) const { return m_folder->filePath(name); }

    void write(const char* name, const QByteArray& text) const
    {
        QFile out(file(name));
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(text);
    }

    QByteArray read(const char* name) const
    {
        QFile in(file(name));
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }

    void writeStl(const char* name, const geometry::TriangleMesh& mesh) const
    {
        QByteArray bytes(80, ' ');
        const auto put = [&bytes](const auto value) {
            bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
        };
        put(static_cast<std::uint32_t>(mesh.triangles.size()));
        for (const auto& triangle : mesh.triangles) {
            bytes.append(12, '\0'); // normals are computed, not read
            for (const auto corner : triangle) {
                for (const double value : mesh.vertices[corner]) {
                    put(static_cast<float>(value));
                }
            }
            bytes.append(2, '\0');
        }
        write(name, bytes);
    }

    /// Writes the box of the other tests as VTP with a stiffness scale of 2 + x / 20; one corner of the bottom has no
    /// value.
    void writeMappedBox(const char* name) const
    {
        const geometry::TriangleMesh box = test::box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 3);
        QByteArray scale, points, corners, ends;
        for (const Vec3& p : box.vertices) {
            scale += p.maxCoeff() < -9.0 ? "nan " : QByteArray::number(2.0 + p.x() / 20.0, 'g', 17) + ' ';
            for (const double x : p) {
                points += QByteArray::number(x, 'g', 17) + ' ';
            }
        }
        for (std::size_t i = 0; i < box.triangles.size(); ++i) {
            for (const std::uint32_t corner : box.triangles[i]) {
                corners += QByteArray::number(corner) + ' ';
            }
            ends += QByteArray::number(3 * i + 3) + ' ';
        }
        const auto array = [](const char* attributes, const QByteArray& values) {
            return "<DataArray " + QByteArray(attributes) + " format=\"ascii\">" + values + "</DataArray>";
        };
        write(name, "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">"
                    "<PolyData><Piece NumberOfPoints=\"" +
                        QByteArray::number(box.vertices.size()) + "\" NumberOfPolys=\"" +
                        QByteArray::number(box.triangles.size()) + "\"><PointData>" +
                        array("type=\"Float64\" Name=\"StiffnessScale\"", scale) + "</PointData><Points>" +
                        array("type=\"Float64\" NumberOfComponents=\"3\"", points) + "</Points><Polys>" +
                        array("type=\"Int64\" Name=\"connectivity\"", corners) +
                        array("type=\"Int64\" Name=\"offsets\"", ends) + "</Polys></Piece></PolyData></VTKFile>");
    }

    Outcome run(const QStringList& arguments, const char* folder = "") const
    {
        return test::runProgram(file(folder), arguments);
    }

    QList<Row> rows(const char* name) const
    {
        QList<Row> out;
        QList<QByteArray> lines = read(name).split('\n');
        lines.removeFirst();
        for (const QByteArray& line : lines) {
            const QList<QByteArray> f = line.split(',');
            if (f.size() == 18) {
                out.append({f[0].toInt(), vector(f, 1), vector(f, 4), vector(f, 7), f[10].toInt(), f[11], f[12].toInt(),
                            vector(f, 13), f[16], f[17]});
            }
        }
        return out;
    }

    static QByteArray withoutTimes(const QByteArray& csv)
    {
        QByteArray out;
        for (const QByteArray& line : csv.split('\n')) {
            QList<QByteArray> fields = line.split(',');
            fields.remove(12, fields.size() > 12 ? 1 : 0); // solve_ns
            out += fields.join(',') + '\n';
        }
        return out;
    }

    /// Presses on the top of the box (z = 10), moves along the surface and lifts again.
    static QByteArray pressing()
    {
        QByteArray csv = "x,y,z\n";
        for (int i = 0; i < 1000; ++i) {
            const double t = i * 1e-3;
            csv += QByteArray::number(3.0 * t, 'g', 17) + ',' + QByteArray::number(1.0 - t, 'g', 17) + ',' +
                   QByteArray::number(11.0 - 3.0 * std::sin(M_PI * t), 'g', 17) + '\n';
        }
        return csv;
    }

    /// Copies r.palpate to c.palpate as if `build` had recorded the file with god-objects `off_mm` away from tick
    /// `from` on.
    void writeAltered(const std::string& build, double off_mm, std::int64_t from) const
    {
        const auto reader = session::RecordingReader::open(file("r.palpate").toStdString());
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        session::RecordingInfo info = reader.value()->info();
        info.build = build;
        auto writer = session::RecordingWriter::create(file("c.palpate").toStdString(), info);
        QVERIFY2(writer.isOk(), writer.status().message().c_str());
        for (const session::SceneRecord& scene : reader.value()->scenes()) {
            QVERIFY(writer.value()->addScene(scene).isOk());
        }
        const auto read = reader.value()->forEach(0, 1 << 20, [&](servo::TickRecord tick) {
            if (tick.tick >= from) {
                tick.felt.p_WG.z() += off_mm;
            }
            return writer.value()->append(tick).isOk();
        });
        QVERIFY(read.isOk());
        QVERIFY(writer.value()->finish().isOk());
    }

    /// Flips the last bit of the HIP of tick 500 in r.palpate.
    void changeTick500() const
    {
        QByteArray bytes = read("r.palpate");
        const double x = 3.0 * 500 * 1e-3;
        const QByteArray text = QByteArray::number(x, 'g', 17);
        const double stored = text.toDouble();
        QByteArray pattern(8, '\0'); // big-endian, as in SQLite
        std::memcpy(pattern.data(), &stored, 8);
        std::reverse(pattern.begin(), pattern.end());
        const qsizetype place = bytes.indexOf(pattern);
        QVERIFY(place > 0);
        bytes[place + 7] = static_cast<char>(bytes[place + 7] ^ 1);
        write("r.palpate", bytes);
    }

  private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        writeStl("box.stl", test::box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 3));
        write("m.csv", pressing());
    }

    void helpAndVersionNeedNothing_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("version") << QStringList{"--version"};
        QTest::newRow("help") << QStringList{"--help"};
        QTest::newRow("replay") << QStringList{"replay", "--help"};
        QTest::newRow("info") << QStringList{"info", "--help"};
        QTest::newRow("evaluate") << QStringList{"evaluate", "--help"};
        QTest::newRow("stability") << QStringList{"stability", "--help"};
        QTest::newRow("session") << QStringList{"session", "--help"};
    }

    void helpAndVersionNeedNothing()
    {
        QFETCH(QStringList, arguments);
        const Outcome outcome = run(arguments);
        QCOMPARE(outcome.exitCode, 0);
        QCOMPARE(outcome.error, QByteArray());
        QVERIFY(outcome.out.toLower().contains("palpate") || outcome.out.contains("--"));
        if (arguments == QStringList{"--help"}) { // also lists the subcommands of the companion program
            QVERIFY(outcome.out.contains("  evaluate ") && outcome.out.contains("  stability "));
        }
    }

    /// The versions are those of the headers that the program was compiled with.
    void versionNamesTheLibraries()
    {
        const QByteArrayList lines = run({"--version"}).out.split('\n');
        QVERIFY(lines.size() >= 2 && lines[0].startsWith("palpate ") && lines[0].endsWith(')'));
        QCOMPARE(QString::fromUtf8(lines[1]),
                 QStringLiteral("built with Qt %1, VTK %2.%3.%4, SQLite %5, Eigen %6.%7.%8")
                     .arg(QLatin1String(QT_VERSION_STR))
                     .arg(VTK_MAJOR_VERSION)
                     .arg(VTK_MINOR_VERSION)
                     .arg(VTK_BUILD_VERSION)
                     .arg(QLatin1String(SQLITE_VERSION))
                     .arg(EIGEN_WORLD_VERSION)
                     .arg(EIGEN_MAJOR_VERSION)
                     .arg(EIGEN_MINOR_VERSION));
    }

    /// A folder with two spheres, the inner one 8 mm below the surface of the outer. A press of 12 mm above the inner
    /// sphere has more than 1.3 times the force beside it, but only with `--layers auto`.
    void layersFollowFromWhatLiesInWhat()
    {
        QVERIFY(QDir(m_folder->path()).mkpath("two"));
        writeStl("two/liver.stl", test::sphere(24, 20.0));
        writeStl("two/tumour.stl", test::moved(test::sphere(12, 5.0), Vec3(0, -7, 0)));
        const auto pressed_N = [this](const Vec3& from, const QStringList& layers) {
            QByteArray csv = "x,y,z\n";
            for (int i = 0; i <= 280; ++i) { // from 2 mm in front to 12 mm deep
                const Vec3 p = from.normalized() * (22.0 - 0.05 * i) + Vec3(0.01, 0.01, 0.01);
                csv += QByteArray::number(p.x()) + ',' + QByteArray::number(p.y()) + ',' + QByteArray::number(p.z()) +
                       '\n';
            }
            write("press.csv", csv);
            const Outcome outcome =
                run(QStringList{"replay", "two", "--motion", "press.csv", "--out", "t.csv"} + layers);
            if (outcome.exitCode != 0 || outcome.out.contains("layers:") == layers.isEmpty()) {
                qFatal("%s%s", outcome.out.constData(), outcome.error.constData());
            }
            return rows("t.csv").last().force.norm();
        };
        const QStringList layered{"--layers", "auto"};
        const double beside_N = pressed_N(Vec3::UnitZ(), layered);
        QVERIFY(std::abs(beside_N - 6.0) < 0.1);
        QVERIFY(pressed_N(-Vec3::UnitY(), layered) > 1.3 * beside_N);
        QVERIFY(std::abs(pressed_N(-Vec3::UnitY(), {}) - beside_N) < 0.05); // unchanged without the option

        const Outcome info = run({"info", "two", "--layers", "auto"});
        QCOMPARE(info.exitCode, 0);
        QVERIFY2(info.out.contains("layers: tumour lies in liver and is felt below it\n"), info.out.constData());
        const QJsonObject json =
            QJsonDocument::fromJson(run({"info", "two", "--layers", "auto", "--json"}).out).array().at(0).toObject();
        QCOMPARE(json["layers"].toArray().at(0).toString(), QString("tumour lies in liver and is felt below it"));
        QCOMPARE(json["structures"].toArray().at(1).toObject()["layer"].toInt(), 1);
        QVERIFY(!run({"info", "two"}).out.contains("layers:"));
        QVERIFY(!run({"info", "two", "--json"}).out.contains("\"layer"));
    }

    void aSceneFileKeepsItsOwnLayers()
    {
        write("s.palpate.json", R"({"version": 1, "structures": [{"mesh": "box.stl"}]})");
        const Outcome outcome = run({"replay", "s.palpate.json", "--motion", "m.csv", "--layers", "auto"});
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY2(outcome.out.contains("layers: s.palpate.json is a scene file and keeps its own layers\n"),
                 outcome.out.constData());
        QVERIFY(run({"info", "box.stl", "--layers", "auto"}).out.contains("all is in one layer"));
    }

    void layersAreAutoOrNothing_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("info") << QStringList{"info", "box.stl"};
        QTest::newRow("replay") << QStringList{"replay", "box.stl", "--motion", "m.csv"};
        QTest::newRow("evaluate") << QStringList{"evaluate", "box.stl"};
    }
    void layersAreAutoOrNothing()
    {
        QFETCH(QStringList, arguments);
        const Outcome outcome = run(arguments + QStringList{"--layers", "deep"});
        QCOMPARE(outcome.exitCode, 2);
        QCOMPARE(outcome.error, QByteArray("palpate: --layers: found \"deep\", expected auto\n"));
        QCOMPARE(outcome.out, QByteArray());
    }

    void aWindowWithoutADisplayIsAnErrorOfOneLine()
    {
        const Outcome outcome = run({"box.stl"});
        QCOMPARE(outcome.exitCode, 1);
        QVERIFY2(outcome.error.count('\n') == 1 && outcome.error.contains("display"), outcome.error.constData());
    }

    void replayWritesTheTable()
    {
        const Outcome outcome = run({"replay", "box.stl", "--motion", "m.csv", "--out", "t.csv", "--json", "s.json"});
        QCOMPARE(outcome.error, QByteArray());
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY(read("t.csv").startsWith("tick,hip_x,hip_y,hip_z,god_x,god_y,god_z,force_x,force_y,force_z,"
                                         "constraints,structure,solve_ns,normal_x,normal_y,normal_z,slides,layers\n"));
        const QList<Row> table = rows("t.csv");
        QCOMPARE(table.size(), 1000);
        int contacts = 0;
        for (qsizetype i = 0; i < table.size(); ++i) {
            const Row& row = table[i];
            QCOMPARE(row.tick, static_cast<int>(i));
            QCOMPARE(row.slides, QByteArray()); // no friction
            if (row.hip.z() < 10.0) {           // force in the tick of contact
                ++contacts;
                QCOMPARE(row.structure, QByteArray("box"));
                QCOMPARE(row.constraints, 1);
                QVERIFY(std::abs(row.god.z() - 10.0) <= 1e-6);
                QVERIFY((row.force - 0.5 * (row.god - row.hip)).norm() <= 1e-12);
                QVERIFY((row.normal - Vec3::UnitZ()).norm() < 1e-6);
                const QList<QByteArray> layer = row.layers.split('=');
                QCOMPARE(layer.size(), 3);
                QCOMPARE(layer[0], QByteArray("box"));
                QCOMPARE(layer[1].toDouble(), row.force.norm());
                QCOMPARE(layer[2].toDouble(), (row.god - row.hip).norm());
            } else {
                QCOMPARE(row.layers, QByteArray());
                QCOMPARE(row.structure, QByteArray());
                QCOMPARE(row.constraints, 0);
                QCOMPARE(row.god, row.hip);
                QCOMPARE(row.force, Vec3(0, 0, 0));
            }
        }
        const QJsonObject summary = QJsonDocument::fromJson(read("s.json")).object();
        QCOMPARE(summary["ticks"].toInt(), 1000);
        QCOMPARE(summary["contact_ticks"].toInt(), contacts);
        QVERIFY(std::abs(summary["peak_force_N"].toDouble() - 1.0) < 1e-3);
        QVERIFY(summary["solve_ns"].toObject().contains("p99.9"));
        QVERIFY(outcome.out.contains("ticks 1,000"));
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files).size(), 4);
    }

    void anArrayOfTheMeshIsFelt()
    {
        writeMappedBox("mapped.vtp");
        const auto check = [this](const QStringList& more, const std::function<Vec3(const Row&)>& expected) {
            const Outcome outcome =
                run(QStringList{"replay", "mapped.vtp", "--motion", "m.csv", "--out", "t.csv"} + more);
            QVERIFY2(outcome.exitCode == 0, outcome.error.constData());
            int contacts = 0;
            for (const Row& row : rows("t.csv")) {
                if (row.constraints == 1) {
                    ++contacts;
                    QVERIFY((row.force - expected(row)).norm() <= 2e-6); // the scale is a float
                }
            }
            QVERIFY(contacts > 300);
        };
        // f = s F(d) n - W(d) grad s, with F = k d and W = k d^2 / 2.
        check({}, [](const Row& row) {
            const double d = row.god.z() - row.hip.z(), s = 2.0 + row.god.x() / 20.0;
            return Vec3(-0.25 * d * d / 20.0, 0.0, s * 0.5 * d);
        });
        check({"--stiffness", "0.5"}, [](const Row& row) { return Vec3(0.5 * (row.god - row.hip)); });
    }

    void infoNamesArraysAndWhatIsFeltOfThem()
    {
        writeMappedBox("mapped.vtp");
        const Outcome told = run({"info", "mapped.vtp"});
        QCOMPARE(told.exitCode, 0);
        QVERIFY2(told.out.contains("    array \"StiffnessScale\" (point): 1.5 to 2.5; 1 of 56 missing\n"),
                 told.out.constData());
        QVERIFY2(told.out.contains("    map: stiffness by the array \"StiffnessScale\" (scale): felt as 0.75 to 1.25 "
                                   "N/mm; 1 of 56 values missing: 0.5 is used there\n"),
                 told.out.constData());
        const QJsonObject json = QJsonDocument::fromJson(run({"info", "mapped.vtp", "--json"}).out)
                                     .array()[0]
                                     .toObject()["structures"]
                                     .toArray()[0]
                                     .toObject();
        const QJsonObject array = json["arrays"].toArray()[0].toObject();
        QCOMPARE(array["name"].toString(), QString("StiffnessScale"));
        QCOMPARE(array["of"].toString(), QString("point"));
        QCOMPARE(array["least"].toDouble(), 1.5);
        QCOMPARE(array["greatest"].toDouble(), 2.5);
        QCOMPARE(array["missing"].toInt(), 1);
        const QJsonObject map = json["maps"].toArray()[0].toObject();
        QCOMPARE(map["quantity"].toString(), QString("stiffness"));
        QCOMPARE(map["array"].toString(), QString("StiffnessScale"));
        QCOMPARE(map["unit"].toString(), QString("scale"));
        QCOMPARE(map["felt_least"].toDouble(), 0.75);
        QCOMPARE(map["felt_greatest"].toDouble(), 1.25);
        QCOMPARE(map["felt_unit"].toString(), QString("N/mm"));
        QCOMPARE(map["felt_where_missing"].toDouble(), 0.5);
        QCOMPARE(map["missing"].toInt(), 1);
        const QByteArray plain = run({"info", "box.stl", "--json"}).out;
        QVERIFY(!plain.contains("\"arrays\"") && !plain.contains("\"maps\""));
    }

    void tissueIsOverridden()
    {
        const Outcome outcome = run(
            {"replay", "box.stl", "--motion", "m.csv", "--out", "t.csv", "--stiffness", "1.25", "--damping", "0.002"});
        QCOMPARE(outcome.exitCode, 0);
        const QList<Row> table = rows("t.csv");
        for (qsizetype i = 1; i < table.size(); ++i) {
            if (table[i].constraints > 0) {
                const Vec3 v = (table[i].hip - table[i - 1].hip) / 1e-3;
                QVERIFY((table[i].force - (1.25 * (table[i].god - table[i].hip) - 0.002 * v)).norm() <= 1e-12);
            }
        }
    }

    void unitsScaleTheMeshOnly()
    {
        writeStl("metres.stl", test::box(Vec3(-0.01, -0.01, -0.01), Vec3(0.01, 0.01, 0.01), 3));
        QCOMPARE(run({"replay", "metres.stl", "--unit", "m", "--motion", "m.csv", "--out", "t.csv"}).exitCode, 0);
        int contacts = 0;
        for (const Row& row : rows("t.csv")) {
            contacts += row.constraints > 0 && std::abs(row.god.z() - 10.0) < 1e-5 ? 1 : 0;
        }
        QVERIFY(contacts > 500);
    }

    void aFolderIsAScene()
    {
        QVERIFY(QDir(m_folder->path()).mkdir("meshes"));
        writeStl("meshes/b.stl", test::box(Vec3(-10, -10, -10), Vec3(10, 10, 10)));
        writeStl("meshes/a.stl", test::sphere(4, 3.0));
        write("meshes/readme.txt", "not a mesh");
        const Outcome outcome = run({"replay", "meshes", "--motion", "m.csv", "--out", "t.csv"});
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY(outcome.out.contains("2 structures"));
        QVERIFY(read("t.csv").contains(",b,"));
    }

    void aRecordingReplaysBitForBit()
    {
        QCOMPARE(run({"replay", "box.stl", "--motion", "m.csv", "--out", "t.csv", "--record", "r.palpate",
                      "--stiffness", "0.8"})
                     .exitCode,
                 0);
        const Outcome again = run({"replay", "box.stl", "--motion", "r.palpate", "--out", "u.csv"});
        QCOMPARE(again.error, QByteArray());
        QCOMPARE(again.exitCode, 0);
        QVERIFY(again.out.contains("the same bit for bit"));
        QCOMPARE(withoutTimes(read("u.csv")), withoutTimes(read("t.csv")));

        const Outcome verified = run({"session", "verify", "r.palpate"});
        QCOMPARE(verified.error, QByteArray());
        QCOMPARE(verified.exitCode, 0);
        QCOMPARE(run({"session", "info", "r.palpate"}).exitCode, 0);
        QCOMPARE(run({"session", "measure", "r.palpate", "--json", "measures.json"}).exitCode, 0);
        QVERIFY(read("measures.json").contains("\"box\""));
        QCOMPARE(run({"session", "export", "r.palpate", "--csv", "e.csv"}).exitCode, 0);
        // The same bytes, followed by the columns that only a recording has.
        const QList<QByteArray> shown = withoutTimes(read("e.csv")).split('\n');
        const QList<QByteArray> plain = withoutTimes(read("t.csv")).split('\n');
        QCOMPARE(shown.size(), plain.size());
        QCOMPARE(shown[0], plain[0] + ",time_s,sent_x_N,sent_y_N,sent_z_N,force_N,depth_mm,felt_N_per_mm,events");
        for (qsizetype i = 1; i < 1001; ++i) {
            QVERIFY2(shown[i].startsWith(plain[i] + ','), shown[i]);
        }
    }

    /// The scene is found from any folder although its path was relative to the folder of the recording, and after both
    /// files were moved together.
    void aRecordingFindsItsSceneFromAnotherFolder()
    {
        QVERIFY(QDir(m_folder->path()).mkpath("case/elsewhere"));
        QVERIFY(QFile::copy(file("box.stl"), file("case/box.stl")));
        QCOMPARE(run({"replay", "box.stl", "--motion", "../m.csv", "--record", "r.palpate"}, "case").exitCode, 0);
        const Outcome verified = run({"session", "verify", "../r.palpate"}, "case/elsewhere");
        QCOMPARE(verified.error, QByteArray());
        QVERIFY(verified.out.contains("the same bit for bit"));
        QVERIFY(QDir(m_folder->path()).rename("case", "moved"));
        const Outcome moved = run({"session", "verify", "moved/r.palpate"});
        QCOMPARE(moved.error, QByteArray());
        QVERIFY(moved.out.contains("the same bit for bit"));
    }

    void measuresGoToStdout()
    {
        QCOMPARE(run({"replay", "box.stl", "--motion", "m.csv", "--record", "r.palpate"}).exitCode, 0);
        const Outcome piped = run({"session", "measure", "r.palpate", "--json", "-"});
        QCOMPARE(piped.exitCode, 0);
        const QJsonObject json = QJsonDocument::fromJson(piped.out).object(); // no other keys
        QCOMPARE(json["ticks"].toInt(), 1000);
        QCOMPARE(json["lost_ticks"].toInt(-1), 0);
        QCOMPARE(json["coverage_distance_mm"].toDouble(), 5.0);
        QVERIFY(!QFile::exists(file("-")));
        QCOMPARE(run({"replay", "box.stl", "--motion", "m.csv", "--record", "r.palpate", "--radius", "2", "--force"})
                     .exitCode,
                 0);
        const Outcome ball = run({"session", "measure", "r.palpate", "--json", "-"});
        QCOMPARE(QJsonDocument::fromJson(ball.out).object()["coverage_distance_mm"].toDouble(), 2.0);
    }

    void aRecordingOfAnotherBuildIsToldFromADifferentOne_data()
    {
        QTest::addColumn<bool>("isThisBuild");
        QTest::addColumn<double>("off_mm");
        QTest::addColumn<int>("exitCode");
        QTest::newRow("the same bits") << false << 0.0 << 0;
        QTest::newRow("rounding") << false << 1e-11 << 0;
        QTest::newRow("different") << false << 1e-6 << 1;
        QTest::newRow("different, of this build") << true << 1e-6 << 1;
        // With uncommitted changes, two different builds may share a build ID.
        QTest::newRow("rounding, of this build")
            << true << 1e-11 << (session::isExactBuild(session::buildId()) ? 1 : 0);
    }

    void aRecordingOfAnotherBuildIsToldFromADifferentOne()
    {
        QFETCH(bool, isThisBuild);
        QFETCH(double, off_mm);
        QFETCH(int, exitCode);
        QCOMPARE(run({"replay", "box.stl", "--motion", "m.csv", "--record", "r.palpate"}).exitCode, 0);
        writeAltered(isThisBuild ? session::buildId() : "0123456789ab GNU 12.2.0 Release", off_mm, 700);
        for (const QStringList& command :
             {QStringList{"session", "verify", "c.palpate"},
              QStringList{"replay", "box.stl", "--motion", "c.palpate", "--json", "s.json"}}) {
            const Outcome outcome = run(command);
            QVERIFY2(outcome.exitCode == exitCode, outcome.error + outcome.out);
            QCOMPARE(outcome.out.contains("the same bit for bit"), off_mm == 0.0);
            const QByteArray& told = exitCode == 0 ? outcome.out : outcome.error;
            if (off_mm != 0.0) {
                QVERIFY2(told.contains("tick 700: god-object recorded at (") && told.contains(" mm apart"), told);
                QVERIFY2(isThisBuild || told.contains("another build (0123456789ab GNU"), told);
            }
            QCOMPARE(outcome.error.count('\n'), exitCode == 0 ? 0 : 1);
        }
        const QJsonObject told = QJsonDocument::fromJson(read("s.json")).object()["resimulation"].toObject();
        QCOMPARE(told["identical"].toBool(), off_mm == 0.0);
        QCOMPARE(told["within_rounding"].toBool(), off_mm < 1e-9);
        QCOMPARE(told["differing_ticks"].toInt(), off_mm == 0.0 ? 0 : 300);
    }

    void aRecordingOfAnotherMeshIsRefusedUnlessForced()
    {
        QCOMPARE(run({"replay", "box.stl", "--motion", "m.csv", "--record", "r.palpate"}).exitCode, 0);
        writeStl("other.stl", test::box(Vec3(-10, -10, -10), Vec3(10, 10, 9.5), 3));
        const Outcome refused = run({"replay", "other.stl", "--motion", "r.palpate", "--out", "t.csv"});
        QCOMPARE(refused.exitCode, 2);
        QVERIFY(refused.error.contains("other.stl"));
        QVERIFY(refused.error.contains("\"box\""));
        QVERIFY(!QFile::exists(file("t.csv")));
        QCOMPARE(run({"replay", "other.stl", "--motion", "r.palpate", "--force", "--out", "t.csv"}).exitCode, 0);
        QCOMPARE(rows("t.csv").size(), 1000);
    }

    void aRecordingWithItsSurfacesNeedsNoOtherFile()
    {
        QCOMPARE(run({"replay", "box.stl", "--motion", "m.csv", "--record", "r.palpate", "--embed"}).exitCode, 0);
        QVERIFY(QFile::remove(file("box.stl")));
        const Outcome verified = run({"session", "verify", "r.palpate"});
        QCOMPARE(verified.error, QByteArray());
        QCOMPARE(verified.exitCode, 0);
        QVERIFY(verified.out.contains("the same bit for bit"));
        const Outcome again = run({"replay", "r.palpate", "--motion", "r.palpate", "--out", "t.csv"});
        QCOMPARE(again.exitCode, 0);
        QVERIFY(again.out.contains("the same bit for bit"));
        QCOMPARE(rows("t.csv").size(), 1000);
        // --embed has no target file
        QCOMPARE(run({"replay", "r.palpate", "--motion", "m.csv", "--embed"}).exitCode, 2);
    }

    void exportsOpenInVtk()
    {
        QCOMPARE(run({"replay", "box.stl", "--motion", "m.csv", "--record", "r.palpate", "--out", "t.csv"}).exitCode,
                 0);
        const Outcome outcome = run({"session", "export", "r.palpate", "--vtp", "p.vtp", "--csv", "e.csv"});
        QCOMPARE(outcome.error, QByteArray());
        QCOMPARE(outcome.exitCode, 0);
        const QList<Row> table = rows("t.csv");
        const auto open = [this](const char* name) {
            const auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
            reader->SetFileName(file(name).toUtf8().constData());
            reader->Update();
            return vtkSmartPointer<vtkPolyData>(reader->GetOutput());
        };
        const auto tag = [](vtkPolyData& data) {
            auto* space = vtkStringArray::SafeDownCast(data.GetFieldData()->GetAbstractArray("SPACE"));
            return space == nullptr ? std::string() : std::string(space->GetValue(0));
        };
        const auto path = open("p.vtp");
        QCOMPARE(path->GetNumberOfPoints(), vtkIdType{1000});
        QCOMPARE(path->GetNumberOfLines(), vtkIdType{1});
        QCOMPARE(tag(*path), std::string("LPS"));
        for (const char* name : {"force_N", "depth_mm", "time_s", "force", "god_object", "structure"}) {
            QVERIFY2(path->GetPointData()->GetArray(name) != nullptr, name);
        }
        for (vtkIdType i = 0; i < 1000; ++i) {
            QCOMPARE(Vec3(path->GetPoint(i)), table[i].hip);
            QCOMPARE(path->GetPointData()->GetArray("force_N")->GetTuple1(i), table[i].force.norm());
            QCOMPARE(path->GetPointData()->GetArray("depth_mm")->GetTuple1(i), (table[i].god - table[i].hip).norm());
        }
        QCOMPARE(path->GetPointData()->GetArray("time_s")->GetTuple1(999), 0.999);
        const auto surface = open("p-surface.vtp");
        QVERIFY(surface->GetNumberOfPolys() >= 108);
        QCOMPARE(tag(*surface), std::string("LPS"));
        double range[2];
        surface->GetPointData()->GetArray("peak_force_N")->GetRange(range);
        QVERIFY(range[0] == 0.0 && std::abs(range[1] - 1.0) < 1e-3);
        surface->GetPointData()->GetArray("coverage")->GetRange(range);
        QVERIFY(range[0] == 0.0 && range[1] == 1.0);
        QVERIFY(surface->GetPointData()->GetArray("dwell_s") != nullptr);
        QCOMPARE(run({"info", "p-surface.vtp"}).exitCode, 0); // also in Palpate itself
        QCOMPARE(run({"session", "export", "r.palpate"}).exitCode, 2);
        QVERIFY(QFile::remove(file("box.stl")));
        const Outcome without = run({"session", "measure", "r.palpate", "--json", "measures.json"});
        QCOMPARE(without.exitCode, 3);
        QVERIFY2(without.error.contains("no coverage of box: "), without.error.constData());
        QVERIFY(QJsonDocument::fromJson(read("measures.json")).object()["phases"].toObject().contains("press"));
    }

    void aMissingMeshIsNamedAndTheRestIsFelt()
    {
        write("s.palpate.json", R"({"version": 1, "structures": [{"mesh": "box.stl"}, {"mesh": "gone.stl"}]})");
        const Outcome outcome = run({"replay", "s.palpate.json", "--motion", "m.csv", "--out", "t.csv"});
        QCOMPARE(outcome.exitCode, 3);
        QVERIFY2(outcome.error.contains("gone.stl: "), outcome.error.constData());
        QCOMPARE(rows("t.csv").size(), 1000);
    }

    void recoverSaysWhatIsMissing()
    {
        QCOMPARE(run({"replay", "box.stl", "--motion", "m.csv", "--record", "r.palpate"}).exitCode, 0);
        const Outcome whole = run({"session", "recover", "r.palpate", "--out", "copy.palpate"});
        QCOMPARE(whole.error, QByteArray());
        QCOMPARE(whole.exitCode, 0);
        QByteArray bytes = read("r.palpate");
        const double stored = QByteArray::number(3.0 * 500 * 1e-3, 'g', 17).toDouble();
        QByteArray pattern(8, '\0'); // the HIP of tick 500, big-endian as in SQLite
        std::memcpy(pattern.data(), &stored, 8);
        std::reverse(pattern.begin(), pattern.end());
        bytes[bytes.indexOf(pattern) + 7] ^= 1;
        write("r.palpate", bytes);
        const Outcome damaged = run({"session", "recover", "r.palpate", "--out", "copy.palpate"});
        QCOMPARE(damaged.exitCode, 3);
        QVERIFY2(damaged.error.contains("r.palpate: ticks 500 to 749: left out"), damaged.error.constData());
        QVERIFY(damaged.out.contains("750 ticks recovered"));
        QCOMPARE(run({"session", "verify", "copy.palpate"}).exitCode, 3); // ticks are missing
        QCOMPARE(run({"session", "recover", "r.palpate", "--out", "r.palpate"}).exitCode, 2);
    }

    /// On a device the stiffness is limited to the stable range of the device, and the CSV contains the force that was
    /// sent.
    void liveOnADeviceIsBoundByIt()
    {
        const Outcome live = run({"replay", "box.stl", "--motion", "m.csv", "--stiffness", "50", "--live", "--device",
                                  "touch", "--out", "bound.csv"});
        QCOMPARE(live.error, QByteArray());
        QCOMPARE(live.exitCode, 0);
        QVERIFY2(live.out.contains(" can hold at most 0.4 N/mm of box (asked for 50 N/mm)\n"), live.out.constData());
        QFile csv(file("bound.csv"));
        QVERIFY(csv.open(QIODevice::ReadOnly));
        QVERIFY(csv.readLine().endsWith(",slides,layers,sent_x,sent_y,sent_z\n"));
    }

    void liveGivesTheSameTicks()
    {
        QCOMPARE(run({"replay", "box.stl", "--motion", "m.csv", "--out", "t.csv"}).exitCode, 0);
        const Outcome live =
            run({"replay", "box.stl", "--motion", "m.csv", "--live", "--out", "u.csv", "--record", "r.palpate"});
        QCOMPARE(live.error, QByteArray());
        QCOMPARE(live.exitCode, 0);
        QCOMPARE(withoutTimes(read("u.csv")), withoutTimes(read("t.csv")));
        QCOMPARE(run({"session", "verify", "r.palpate"}).exitCode, 0);
    }

    void infoSaysWhatAMeshIs()
    {
        const Outcome outcome = run({"info", "box.stl"});
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY(outcome.out.contains("108 triangles"));
        QVERIFY(outcome.out.contains("closed"));
        const Outcome json = run({"info", "--json", "box.stl", "box.stl"});
        QCOMPARE(json.exitCode, 0);
        QVERIFY(QJsonDocument::fromJson(json.out).isArray());
    }

    void badInputIsOneLineAndExitCode2_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("names"); // the expected text of the line
        const auto row = [](const char* name, const QStringList& arguments, const char* names) {
            QTest::newRow(name) << arguments << QByteArray(names);
        };
        const QStringList replay{"replay", "box.stl", "--motion", "m.csv", "--out", "t.csv"};
        row("unknown option", replay + QStringList{"--colour", "red"}, "--colour");
        row("no motion", {"replay", "box.stl", "--out", "t.csv"}, "--motion");
        row("no scene", {"replay", "--motion", "m.csv"}, "SCENE");
        row("option without value", {"replay", "box.stl", "--motion"}, "--motion");
        row("session without verb", {"session"}, "palpate");
        row("unit", replay + QStringList{"--unit", "inch"}, "found \"inch\", expected m, cm or mm");
        row("stiffness zero", replay + QStringList{"--stiffness", "0"}, "--stiffness: found \"0\"");
        row("stiffness negative", replay + QStringList{"--stiffness", "-1"}, "--stiffness");
        row("stiffness negative with =", replay + QStringList{"--stiffness=-1"}, "--stiffness: found \"-1\"");
        row("stiffness nan", replay + QStringList{"--stiffness", "nan"}, "--stiffness: found \"nan\"");
        row("stiffness inf", replay + QStringList{"--stiffness", "inf"}, "--stiffness: found \"inf\"");
        row("stiffness beyond a scene's", replay + QStringList{"--stiffness", "1e300"},
            "--stiffness: found \"1e300\", expected a number above 0 and at most 1000");
        row("damping beyond a scene's", replay + QStringList{"--damping", "1001"},
            "--damping: found \"1001\", expected a number of at least 0 and at most 1000");
        row("radius beyond a hand's", replay + QStringList{"--radius", "51"},
            "--radius: found \"51\", expected a number of at least 0 and at most 50");
        row("evaluate, stiffness beyond", {"evaluate", "box.stl", "--stiffness", "1e300"},
            "--stiffness: found \"1e300\", expected a number above 0 and at most 1000");
        row("command after an option", {"--unit", "mm", "evaluate", "box.stl", "--quick"},
            "evaluate: found after an option, expected as the first word");
        row("seed below", {"evaluate", "box.stl", "--quick", "--seed=-1"}, "--seed: found \"-1\", expected a whole");
        row("seed beyond", {"evaluate", "box.stl", "--quick", "--seed", "18446744073709551616"}, "--seed: found");
        row("stability, rate beyond", {"stability", "box.stl", "--rate", "1e5"},
            "--rate: found \"1e5\", expected a number of at least 1 and at most 10000");
        row("stiffness word", replay + QStringList{"--stiffness", "1,5"}, "--stiffness: found \"1,5\"");
        row("damping negative", replay + QStringList{"--damping=-0.1"}, "--damping: found \"-0.1\"");
        row("CPU of none", replay + QStringList{"--live", "--cpu", "100000"},
            "CPU 100000: this machine has no such CPU, expected one of 0");
        row("CPU negative", replay + QStringList{"--live", "--cpu=-2"}, "CPU -2: this machine has no such CPU");
        row("CPU of a word", replay + QStringList{"--live", "--cpu", "first"}, "--cpu = first");
        row("CPU without a loop", replay + QStringList{"--cpu", "0"}, "--live");
        row("CPU of none, window", {"box.stl", "--cpu", "100000"}, "");
        row("scene missing", {"replay", "no.stl", "--motion", "m.csv", "--out", "t.csv"}, "no.stl");
        row("motion missing", {"replay", "box.stl", "--motion", "no.csv", "--out", "t.csv"}, "no.csv");
        row("motion is a folder", {"replay", "box.stl", "--motion", ".", "--out", "t.csv"}, "directory");
        row("empty folder", {"replay", "empty", "--motion", "m.csv", "--out", "t.csv"}, "empty: a folder without");
        row("column missing", {"replay", "box.stl", "--motion", "two.csv", "--out", "t.csv"}, "two.csv: line 1");
        row("not a number", {"replay", "box.stl", "--motion", "word.csv", "--out", "t.csv"},
            "word.csv: line 3, column y: found \"abc\", expected a number");
        row("not finite", {"replay", "box.stl", "--motion", "nan.csv", "--out", "t.csv"}, "nan.csv: line 2, column z");
        row("empty motion", {"replay", "box.stl", "--motion", "empty.csv", "--out", "t.csv"}, "empty.csv: line 1");
        row("truncated mesh", {"replay", "cut.stl", "--motion", "m.csv", "--out", "t.csv"}, "cut.stl");
        row("empty mesh", {"replay", "empty.stl", "--motion", "m.csv", "--out", "t.csv"}, "empty.stl");
        row("mesh with NaN", {"replay", "nan.stl", "--motion", "m.csv", "--out", "t.csv"}, "nan.stl");
        row("text as mesh", {"replay", "m.csv", "--motion", "m.csv", "--out", "t.csv"}, "m.csv");
        row("output folder missing", {"replay", "box.stl", "--motion", "m.csv", "--out", "no/t.csv"}, "no/t.csv");
        row("output is a folder", {"replay", "box.stl", "--motion", "m.csv", "--out", "empty"}, "empty: cannot be");
        row("json unwritable", replay + QStringList{"--json", "no/s.json"}, "no/s.json");
        row("recording unwritable", replay + QStringList{"--record", "no/r.palpate"}, "no/r.palpate");
        row("output is an input", {"replay", "box.stl", "--motion", "m.csv", "--out", "m.csv"}, "m.csv");
        row("one output twice", replay + QStringList{"--json", "t.csv"}, "t.csv");
        row("bad recording", {"replay", "box.stl", "--motion", "bad.palpate", "--out", "t.csv"}, "bad.palpate");
        row("info missing", {"info", "no.stl"}, "no.stl");
        row("info nothing", {"info"}, "FILE");
        row("info truncated", {"info", "cut.stl"}, "cut.stl");
        row("session missing", {"session", "info", "no.palpate"}, "no.palpate");
        row("session of a mesh", {"session", "verify", "box.stl"}, "box.stl");
        row("session of rubbish", {"session", "measure", "bad.palpate"}, "bad.palpate");
        row("export unwritable", {"session", "export", "no.palpate", "--csv", "no/t.csv"}, "palpate");
        row("no such file to open", {"no-such-file.stl"}, "");
    }

    void badInputIsOneLineAndExitCode2()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, names);
        QVERIFY(QDir(m_folder->path()).mkdir("empty"));
        write("two.csv", "x,y\n1,2\n");
        write("word.csv", "x,y,z\n1,2,3\n1,abc,3\n");
        write("nan.csv", "x,y,z\n1,2,nan\n");
        write("empty.csv", "");
        write("empty.stl", "");
        write("cut.stl", read("box.stl").left(700));
        QByteArray nan = read("box.stl");
        const float notANumber = std::nanf("");
        std::memcpy(nan.data() + 84 + 12, &notANumber, sizeof notANumber);
        write("nan.stl", nan);
        write("bad.palpate", QByteArray("SQLite format 3\0", 16) + QByteArray(4096, 'x'));
        const auto before = QDir(m_folder->path()).entryList(QDir::Files);
        const QByteArray motion = read("m.csv");

        const Outcome outcome = run(arguments);
        QCOMPARE(outcome.exitCode, 2);
        QVERIFY2(outcome.error.count('\n') == 1 && outcome.error.endsWith('\n'), outcome.error.constData());
        QVERIFY2(outcome.error.contains(names), outcome.error.constData());
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files), before);
        QCOMPARE(read("m.csv"), motion);
    }

    void aDisplayWithoutOpenGlIsSaid()
    {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) { // the variables that Qt would use for a display
            environment.remove(name);
        }
        environment.insert("QT_QPA_PLATFORM", "minimal");
        process.setProcessEnvironment(environment);
        process.start(PALPATE_EXECUTABLE, {file("box.stl"), "--screenshot", file("p.png")});
        QVERIFY(process.waitForFinished(60000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 1);
        const QByteArray error = process.readAllStandardError();
        QVERIFY2(error.contains("palpate: the display (minimal) has no OpenGL"), error.constData());
        QVERIFY(!QFile::exists(file("p.png")));
    }

    void anOldOutputStaysWhenTheReplayFails()
    {
        write("t.csv", "kept");
        write("bad.csv", "x,y,z\n1,2,oops\n");
        QCOMPARE(run({"replay", "box.stl", "--motion", "bad.csv", "--out", "t.csv"}).exitCode, 2);
        QCOMPARE(read("t.csv"), QByteArray("kept"));
        QCOMPARE(run({"replay", "box.stl", "--motion", "m.csv", "--out", "t.csv"}).exitCode, 0);
        QCOMPARE(rows("t.csv").size(), 1000);
    }

    void verifyNamesAChangedTick()
    {
        QCOMPARE(run({"replay", "box.stl", "--motion", "m.csv", "--record", "r.palpate"}).exitCode, 0);
        changeTick500();
        const Outcome outcome = run({"session", "verify", "r.palpate"});
        QCOMPARE(outcome.exitCode, 1);
        QVERIFY2(outcome.error.contains("r.palpate: ticks 500 to 749"), outcome.error.constData());
    }

    /// Blocks that fail their checksum are skipped and named, with exit code 3; no command writes to the recording.
    void damagedTicksAreLeftOutAndNamed()
    {
        QCOMPARE(run({"replay", "box.stl", "--motion", "m.csv", "--record", "r.palpate"}).exitCode, 0);
        changeTick500();
        const QByteArray before = read("r.palpate");
        for (const QStringList& command : {QStringList{"session", "measure", "r.palpate", "--json", "m.json"},
                                           QStringList{"session", "export", "r.palpate", "--csv", "t.csv"},
                                           QStringList{"session", "export", "r.palpate", "--vtp", "p.vtp"},
                                           QStringList{"replay", "box.stl", "--motion", "r.palpate"}}) {
            const Outcome outcome = run(command);
            QVERIFY2(outcome.exitCode == 3, outcome.error + outcome.out);
            QVERIFY2(outcome.error.contains("r.palpate: DAMAGED, or changed after it was recorded, in 1 place"),
                     outcome.error);
            QVERIFY2(outcome.error.contains("r.palpate: ticks 500 to 749: found other bits"), outcome.error);
            QVERIFY(!outcome.out.contains("nan") && !outcome.out.contains("inf"));
            QCOMPARE(read("r.palpate"), before);
        }
        const QJsonObject measures = QJsonDocument::fromJson(read("m.json")).object();
        QCOMPARE(measures["damaged"].toArray().size(), 1);
        QCOMPARE(measures["duration_s"].toDouble(), 0.75);
        QCOMPARE(read("t.csv").count('\n'), 751);
        QCOMPARE(run({"session", "info", "r.palpate"}).exitCode, 0); // reads no ticks
        QCOMPARE(QDir(m_folder->path()).entryList({"r.palpate*"}, QDir::Files), QStringList{"r.palpate"});
    }
};

PALPATE_TEST(CommandLine)
#include "tst_CommandLine.moc"
