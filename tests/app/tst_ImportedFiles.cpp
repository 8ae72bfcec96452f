// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Shapes.h"
#include "HostileMeshes.h"
#include "Samples.h"
#include "TestRunner.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <set>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace palpate;
namespace fs = std::filesystem;

namespace {

struct Ending
{
    int exitCode = -1;
    std::string out, error;
    double time_s = 0.0;
    long memory_KiB = 0; ///< peak memory of the program and its child processes
};

/// Runs the real executable in `folder` and waits for the process and its descendants.
Ending run(const test::Folder& folder, std::vector<std::string> words, std::vector<std::string> environment = {})
{
    ::prctl(PR_SET_CHILD_SUBREAPER, 1); // orphaned descendants are reparented to this process
    words.insert(words.begin(), PALPATE_EXECUTABLE);
    environment.emplace_back("LANG=C.UTF-8");
    std::vector<char*> argv, envp;
    for (std::string& word : words) {
        argv.push_back(word.data());
    }
    for (std::string& word : environment) {
        envp.push_back(word.data());
    }
    argv.push_back(nullptr);
    envp.push_back(nullptr);
    const std::string out = folder.path("stdout.txt"), error = folder.path("stderr.txt"), there = folder.path("");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, error.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addchdir_np(&actions, there.c_str());
    Ending outcome;
    pid_t program = -1;
    const auto start = std::chrono::steady_clock::now();
    if (::posix_spawn(&program, PALPATE_EXECUTABLE, &actions, nullptr, argv.data(), envp.data()) != 0) {
        return outcome;
    }
    posix_spawn_file_actions_destroy(&actions);
    int status = 0;
    rusage usage = {};
    for (pid_t ended = 0; (ended = ::wait4(-1, &status, 0, &usage)) > 0;) {
        outcome.memory_KiB = std::max(outcome.memory_KiB, usage.ru_maxrss);
        if (ended == program) {
            outcome.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
        }
    }
    outcome.time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    outcome.out = test::fileBytes(out);
    outcome.error = test::fileBytes(error);
    return outcome;
}

QJsonObject firstOf(const Ending& outcome)
{
    return QJsonDocument::fromJson(QByteArray::fromStdString(outcome.out)).array().at(0).toObject();
}

/// @return description of a wrong decision; empty if the file is accepted, or rejected with one line, within 1 GiB and
/// 10 s
std::string mistakeOf(const Ending& outcome, const std::string& name, bool isValid, const std::string& complaint)
{
    constexpr long kMostMemory_KiB = 1 << 20;
    constexpr double kMostTime_s = 10.0;
    const bool isRefused = outcome.exitCode == 2 && std::count(outcome.error.begin(), outcome.error.end(), '\n') == 1 &&
                           outcome.error.ends_with('\n') &&
                           outcome.error.starts_with(std::string("palpate: ") + name + ": " + complaint) &&
                           outcome.error.find("; expected ") != std::string::npos && outcome.out.empty();
    const bool isAccepted = outcome.exitCode == 0 && outcome.error.empty();
    const bool isCheap = outcome.memory_KiB < kMostMemory_KiB && outcome.time_s < kMostTime_s;
    if (isCheap && (isValid ? isAccepted : isRefused)) {
        return {};
    }
    return name + ": exit code " + std::to_string(outcome.exitCode) + ", " + std::to_string(outcome.memory_KiB) +
           " KiB, " + std::to_string(outcome.time_s) + " s, " + outcome.error + " (expected: " + complaint + ")\n";
}

} // namespace

/// Tests the real executable on foreign files.
class ImportedFiles : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void hostileFilesOfOursAreDecided();
    void sharedHostileFilesAreDecided();
    void cutFileNeedsPartialAndThenSaysTheLoss();
    void missingMeshOfASceneIsALoss();
    void infoTellsTheWholeReport();
    void infoOffersTheUnit_data();
    void infoOffersTheUnit();
    void sameUnderAGermanLocale();
    void anyPathWorks();
};

void ImportedFiles::hostileFilesOfOursAreDecided()
{
    const test::Folder folder;
    std::string mistakes;
    long most_KiB = 0;
    double longest_s = 0.0;
    std::size_t valid = 0;
    const std::vector<test::HostileMesh> meshes = test::hostileMeshes();
    for (const test::HostileMesh& mesh : meshes) {
        (void)folder.write(mesh.name, mesh.bytes);
        const Ending outcome = run(folder, {"info", mesh.name});
        mistakes += mistakeOf(outcome, mesh.name, mesh.complaint.empty(), mesh.complaint);
        valid += mesh.complaint.empty() ? 1 : 0;
        most_KiB = std::max(most_KiB, outcome.memory_KiB);
        longest_s = std::max(longest_s, outcome.time_s);
    }
    QVERIFY2(mistakes.empty(), mistakes.c_str());
    qInfo("%zu OBJ and PLY files: %zu valid, %zu refused; at most %ld MiB and %.2f s", meshes.size(), valid,
          meshes.size() - valid, most_KiB / 1024, longest_s);
}

void ImportedFiles::sharedHostileFilesAreDecided()
{
    PALPATE_SHARED_OR_SKIP(shared, "hostile");
    static const std::set<std::string> kValid{"s03_count_ffffffff.stl",
                                              "s08_binary_starts_solid.stl",
                                              "s09_ascii_ok.stl",
                                              "s11_ascii_longname.stl",
                                              "s15_degenerate.stl",
                                              "t1_two_solids.stl",
                                              "t2_slicer_space.stl",
                                              "t3_upper.stl",
                                              "t4_crlf.stl",
                                              "t5_name1000.stl",
                                              "t6_leadingblank.stl",
                                              "t8_bom.stl",
                                              "u1_shortscalars.vtp",
                                              "u2_normals_nan.vtp",
                                              "v01_ok.vtp",
                                              "v18_app_ok.vtp"};
    const test::Folder folder;
    std::string mistakes;
    long most_KiB = 0;
    double longest_s = 0.0;
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(shared)) {
        const std::string name = entry.path().filename().string();
        const Ending outcome = run(folder, {"info", entry.path().string()});
        mistakes += mistakeOf(outcome, name, kValid.contains(name), "");
        ++count;
        most_KiB = std::max(most_KiB, outcome.memory_KiB);
        longest_s = std::max(longest_s, outcome.time_s);
    }
    QVERIFY(count >= 50);
    QVERIFY2(mistakes.empty(), mistakes.c_str());
    qInfo("%zu files of shared/hostile: %zu valid; at most %ld MiB and %.2f s", count, kValid.size(), most_KiB / 1024,
          longest_s);
}

void ImportedFiles::cutFileNeedsPartialAndThenSaysTheLoss()
{
    const test::Folder folder;
    const std::string stl = test::binaryStl(3, {3, {0, 0, 0, 25, 0, 0, 0, 15, 0}});
    (void)folder.write("cut.stl", stl.substr(0, stl.size() - 60));
    (void)folder.write("m.csv", "x,y,z\n1,1,1\n1,1,-1\n");
    const std::string loss = "palpate: cut.stl: byte 174: the file ends there: 2 of 3 triangles lost\n";
    QCOMPARE(mistakeOf(run(folder, {"info", "cut.stl"}), "cut.stl", false, "byte 174: cut off: "), std::string());
    const Ending info = run(folder, {"info", "cut.stl", "--partial", "--json"});
    QCOMPARE(info.exitCode, 3);
    QCOMPARE(info.error, loss);
    QCOMPARE(firstOf(info)["losses"].toArray().size(), 1);
    QCOMPARE(firstOf(info)["structures"].toArray()[0].toObject()["input_triangles"].toInt(), 1);
    const Ending strict = run(folder, {"replay", "cut.stl", "--motion", "m.csv", "--out", "t.csv"});
    QCOMPARE(strict.exitCode, 2);
    QVERIFY(!fs::exists(folder.path("t.csv")));
    const Ending replay = run(folder, {"replay", "cut.stl", "--motion", "m.csv", "--out", "t.csv", "--partial"});
    QCOMPARE(replay.exitCode, 3);
    QCOMPARE(replay.error, loss);
    QVERIFY(fs::exists(folder.path("t.csv")));
}

void ImportedFiles::missingMeshOfASceneIsALoss()
{
    const test::Folder folder;
    (void)folder.write("a.obj", "v 0 0 0\nv 25 0 0\nv 0 15 0\nf 1 2 3\n");
    (void)folder.write("s.palpate.json", R"({"version": 1, "structures": [{"mesh": "a.obj"}, {"mesh": "gone.obj"}]})");
    const Ending outcome = run(folder, {"info", "s.palpate.json"});
    QCOMPARE(outcome.exitCode, 3);
    QVERIFY2(outcome.error.starts_with("palpate: gone.obj: "), outcome.error.c_str());
    QVERIFY2(outcome.out.find("a: 1 triangles") != std::string::npos, outcome.out.c_str());
}

void ImportedFiles::infoTellsTheWholeReport()
{
    const test::Folder folder;
    // Two cubes of 24 mm, one moved by 8 mm along each axis: written as one structure, they intersect.
    const std::vector<meshio::MeshStructure> cubes{
        {"a", test::box(core::Vec3(0, 0, 0), core::Vec3(24, 24, 24), 4), std::nullopt},
        {"b", test::box(core::Vec3(8, 8, 8), core::Vec3(32, 32, 32), 4), std::nullopt}};
    QVERIFY(meshio::writeMesh(folder.path("two.stl"), cubes).isOk());
    const Ending outcome = run(folder, {"info", "two.stl", "--json"});
    QCOMPARE(outcome.exitCode, 0);
    const QJsonObject file = firstOf(outcome);
    QCOMPARE(file["schema"].toInt(), 1);
    QVERIFY(file["unit_guess"].isNull());
    const QJsonObject s = file["structures"].toArray()[0].toObject();
    QCOMPARE(s["triangles"].toInt(), 384);
    QCOMPARE(s["components"].toInt(), 2);
    QCOMPARE(s["open_edges"].toInt(), 0);
    QCOMPARE(s["non_manifold_edges"].toInt(), 0);
    QCOMPARE(s["orientation"].toString(), QString("outwards"));
    QCOMPARE(s["frame"].toString(), QString("LPS"));
    QCOMPARE(s["frame_from"].toString(), QString("the file's SPACE tag"));
    QCOMPARE(s["sha256"].toString().size(), 64);
    QCOMPARE(s["crossing_examined_triangles"].toInt(), 384);
    QCOMPARE(s["crossing_bound_hit"].toBool(true), false);
    QVERIFY(s["wall_samples"].toInt() > 100);
    QVERIFY2(std::abs(s["thinnest_wall_mm"].toDouble() - 16.0) < 1e-9, outcome.out.c_str()); // in the overlap
    QVERIFY(std::abs(s["volume_mm3"].toDouble() - 2 * 24.0 * 24.0 * 24.0) < 1e-6);
    QVERIFY(std::abs(s["area_mm2"].toDouble() - 2 * 6 * 24.0 * 24.0) < 1e-6);
    QCOMPARE(s["extent_mm"].toArray()[0].toDouble(), 32.0);
    QVERIFY(s["feels"].toString().startsWith("closed"));
    QVERIFY(s["crossing_pairs"].toInt() > 0);
    QVERIFY(!s["findings"].toArray().isEmpty());
}

void ImportedFiles::infoOffersTheUnit_data()
{
    QTest::addColumn<double>("size");
    QTest::addColumn<std::string>("unit");
    QTest::addColumn<QString>("option"); // empty: no guess
    const auto row = [](const char* name, double size, const char* unit, const char* option) {
        QTest::newRow(name) << size << std::string(unit) << QString(option);
    };
    row("organ in metres", 0.25, "mm", "--unit m");
    row("organ in mm", 250.0, "mm", "");
    row("organ in metres, said so", 0.25, "m", "");
    row("organ in mm, taken as metres", 250.0, "m", "--unit mm");
}

void ImportedFiles::infoOffersTheUnit()
{
    QFETCH(double, size);
    QFETCH(std::string, unit);
    QFETCH(QString, option);
    const test::Folder folder;
    const std::string text = std::to_string(size);
    (void)folder.write("a.obj", "v 0 0 0\nv " + text + " 0 0\nv 0 " + text + " 0\nf 1 2 3\n");
    const Ending outcome = run(folder, {"info", "a.obj", "--json", "--unit", unit});
    QCOMPARE(outcome.exitCode, 0);
    const QJsonObject file = firstOf(outcome);
    QCOMPARE(file["unit_guess"].toObject()["option"].toString(), option);
    QCOMPARE(file["structures"].toArray()[0].toObject()["extent_mm"].toArray()[0].toDouble(),
             size * (unit == "m" ? 1000.0 : 1.0));
}

void ImportedFiles::sameUnderAGermanLocale()
{
    const test::Folder folder;
    if (QProcess::execute("localedef", {"-c", "-i", "de_DE", "-f", "UTF-8",
                                        QString::fromStdString(folder.path("de_DE.UTF-8").string())}) > 1 ||
        !fs::exists(folder.path("de_DE.UTF-8"))) {
        QSKIP("no de_DE locale can be made here: the package \"locales\" is missing");
    }
    (void)folder.write("a.stl", test::asciiStl());
    (void)folder.write("b.obj", test::kObj);
    (void)folder.write("c.ply", test::asciiPly());
    (void)folder.write("d.vtp", test::asciiVtp());
    (void)folder.write("e.vtk", test::asciiVtk());
    (void)folder.write("m.csv", "x,y,z\n0.5,0.5,0.5\n0.5,0.5,-0.25\n");
    const std::vector<std::string> german{"LC_ALL=de_DE.UTF-8",
                                          std::string("LOCPATH=").append(folder.path("").string())};
    for (const char* name : {"a.stl", "b.obj", "c.ply", "d.vtp", "e.vtk"}) {
        const Ending plain = run(folder, {"replay", name, "--motion", "m.csv", "--out", "t.csv"});
        QCOMPARE(plain.exitCode, 0);
        const std::string ticks = test::fileBytes(folder.path("t.csv"));
        const Ending comma = run(folder, {"replay", name, "--motion", "m.csv", "--out", "t.csv"}, german);
        QVERIFY2(comma.exitCode == 0, comma.error.c_str());
        const auto withoutTime = [](std::string text) {
            std::string out;
            for (std::size_t at = 0, end = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
                std::size_t from = at; // of solve_ns, the 13th column
                for (int column = 1; column < 13; ++column) {
                    from = text.find(',', from) + 1;
                }
                out +=
                    text.substr(at, from - at) + text.substr(text.find(',', from), end - text.find(',', from)) + '\n';
            }
            return out;
        };
        QCOMPARE(withoutTime(test::fileBytes(folder.path("t.csv"))), withoutTime(ticks));
        QVERIFY(ticks.find("0.5,0.5,-0.25") != std::string::npos);
    }
}

void ImportedFiles::anyPathWorks()
{
    const test::Folder folder;
    const std::vector<std::string> names{"Größe mit Leerzeichen.stl", "肝臓.stl",  "a'b\"c$d.stl",
                                         "\xff\xfe latin.stl",        "-dash.stl", std::string(240, 'n') + ".stl"};
    for (const std::string& name : names) {
        (void)folder.write(name, test::asciiStl());
        const Ending outcome = run(folder, {"info", "./" + name});
        fs::remove(folder.path(name)); // Qt cannot remove every file name
        QVERIFY2(outcome.exitCode == 0, outcome.error.c_str());
    }
}

PALPATE_TEST(ImportedFiles)
#include "tst_ImportedFiles.moc"
