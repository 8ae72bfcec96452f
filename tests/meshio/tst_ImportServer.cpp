// SPDX-License-Identifier: BSD-3-Clause
#include "LabelFiles.h"
#include "Samples.h"
#include "read/ImportServer.h"
#include "read/MeshWire.h"
#include "read/ReadMesh.h"
#include "read/VolumeFile.h"

#include <QtTest>

#include <palpate/core/Message.h>
#include <palpate/meshio/LoadScene.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <limits>
#include <mutex>
#include <set>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

using namespace palpate;
using core::StatusCode;
using meshio::internal::readOutcome;
using meshio::internal::takeVolume;
using meshio::internal::VoxelGrid;
using meshio::internal::writeOutcome;
using meshio::internal::writeStructure;
using meshio::internal::writeVolume;

namespace {

/// Misbehaves in the reader as selected by the file name.
void misbehave(const char* path)
{
    const std::string name = std::filesystem::path(path).stem().string();
    if (name == "segv") {
        (void)std::raise(SIGSEGV);
    } else if (name == "abort") {
        std::abort();
    } else if (name == "exit") {
        ::_exit(7);
    } else if (name == "hang") {
        std::ofstream(std::string(path) + ".pid") << ::getpid() << std::flush;
        while (true) {
            ::pause();
        }
    } else if (name == "spin") {
        for (std::atomic<unsigned> i = 0;; ++i) {
        }
    } else if (name == "eat") {
        while (true) { // until the memory is exhausted; writing all of it takes seconds on a busy machine
            std::memset(::operator new (std::size_t{1} << 24), 1, 1);
        }
    } else if (name == "files") {
        int opened = 0;
        while (opened < 1000 && ::open("/dev/null", O_RDONLY) >= 0) {
            ++opened;
        }
        ::_exit(opened < 32 ? 7 : 8);
    } else if (name == "midway") {
        const rlimit some{50'000, 50'000}; // the size of a few structures of `manyCubes`
        (void)::setrlimit(RLIMIT_FSIZE, &some);
    } else if (name == "noise") {
        (void)!::write(1, "out", 3);
        (void)!::write(2, "error", 5);
    }
}

/// An outcome in a memory file.
class Wire
{
  public:
    Wire()
        : m_file(::memfd_create("wire", MFD_CLOEXEC))
    {
    }
    ~Wire() { ::close(m_file); }
    [[nodiscard]] int file() const { return m_file; }
    [[nodiscard]] std::string bytes() const
    {
        std::string out(static_cast<std::size_t>(::lseek(m_file, 0, SEEK_END)), '\0');
        return ::pread(m_file, out.data(), out.size(), 0) == static_cast<ssize_t>(out.size()) ? out : std::string();
    }
    void set(std::string_view bytes) const
    {
        QCOMPARE(::ftruncate(m_file, 0), 0);
        QCOMPARE(::pwrite(m_file, bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
    }
    [[nodiscard]] core::Result<VoxelGrid> volume() const { return takeVolume(m_file, "/somewhere/a.mha"); }
    [[nodiscard]] core::Result<meshio::MeshFile> taken() const { return readOutcome(m_file, "/somewhere/a.stl"); }

  private:
    int m_file;
};

/// @return a label map of 27 cubes, each surface of which takes about 20 kB
std::string manyCubes()
{
    test::LabelGrid grid;
    grid.size = {30, 30, 30};
    grid.fill([](const core::Vec3& p) {
        const auto cube = [](double x) { return static_cast<int>(x) / 10; };
        const auto isIn = [](double x) { return static_cast<int>(x) % 10 >= 2; };
        return isIn(p.x()) && isIn(p.y()) && isIn(p.z()) ? 1 + cube(p.x()) + 3 * cube(p.y()) + 9 * cube(p.z()) : 0;
    });
    return test::labelNrrd(grid, "uint8", "raw") + test::labelNumbers<std::uint8_t>(grid);
}

meshio::MeshFile twoStructures()
{
    meshio::MeshFile file;
    file.format = "VTP";
    file.frame = meshio::FileFrame::Ras;
    file.notes = {core::Message(PALPATE_TEXT("one")), core::Message(PALPATE_TEXT("%1 and %2"), 1, "two")};
    file.loss = core::Message(PALPATE_TEXT("%1: lost"), "a.stl");
    file.structures = {test::tetrahedron("liver"), test::tetrahedron("größe", {1, 2, 3})};
    file.structures[1].colour = {0.1, 0.2, 0.3};
    return file;
}

bool haveSameParts(const core::Message& a, const core::Message& b)
{
    const auto isSame = [](const core::MessageArgument& x, const core::MessageArgument& y) {
        return x.kind == y.kind && x.english == y.english && (x.message == nullptr) == (y.message == nullptr) &&
               (x.message == nullptr || haveSameParts(*x.message, *y.message));
    };
    return a.text() == b.text() && std::ranges::equal(a.arguments(), b.arguments(), isSame);
}

std::size_t openDescriptors()
{
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
        count += entry.path().empty() ? 0 : 1;
    }
    return count;
}

/// Writes a binary STL of 10 million triangles, most of them degenerate, as a sparse file.
std::filesystem::path tenMillion(const test::Folder& folder)
{
    constexpr std::uint32_t kCount = 10'000'000;
    const auto path = folder.write("large.stl", test::binaryStl(kCount, {{0, 0, 0, 25, 0, 0, 0, 15, 0}}));
    std::filesystem::resize_file(path, 84 + std::uintmax_t{50} * kCount);
    return path;
}

bool isGone(pid_t process)
{
    constexpr int kPatience_ms = 60000; // a busy machine
    return QTest::qWaitFor([process] { return ::kill(process, 0) != 0; }, kPatience_ms);
}

} // namespace

/// Tests readers that fail in a child process, and that the parent continues.
class ImportServer : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void readsWhatThisProcessReads();
    void readerThatEndsBadlyIsOneError_data();
    void readerThatEndsBadlyIsOneError();
    void noiseOfTheReaderIsNotHeard();
    void progressRisesAndCancelEndsTheReader();
    void tenMillionTrianglesCanBeCancelled();
    void tenMillionTrianglesLoad();
    void manyAtOnceAndNothingLeft();
    void structuresComeOneByOne();
    void readerThatEndsMidwayLeavesNothing();
    void sceneShowsStructuresEarly();
    void outcomeComesBackWhole();
    void structuresComeBeforeTheOutcome();
    void errorComesBackAsOneLine();
    void errorKeepsItsTextsAndArguments();
    void excessiveMessagesAreRefused_data();
    void excessiveMessagesAreRefused();
    void liesAreRefused_data();
    void liesAreRefused();
    void anyByteMayBeWrong();
    void readsVolumesAsThisProcessDoes();
    void readerOfAVolumeThatEndsBadlyIsOneError_data();
    void readerOfAVolumeThatEndsBadlyIsOneError();
    void aVolumeThatHangsCanBeCancelled();
    void mapsGoThroughTheChild();
    void liesAboutAVolumeAreRefused_data();
    void liesAboutAVolumeAreRefused();
    void anyByteOfAVolumeMayBeWrong();
};

void ImportServer::readsWhatThisProcessReads()
{
    QVERIFY(meshio::internal::hasImportServer());
    const test::Folder folder;
    for (const auto& [name, bytes] : {std::pair<std::string, std::string>{"ä b.stl", test::asciiStl()},
                                      {"a.vtp", test::asciiVtp()},
                                      {"a.obj", "# SPACE=RAS\no liver\n" + test::kObj},
                                      {"a.ply", test::asciiPly()},
                                      {"cut.stl", test::binaryStl(2, {{0, 0, 0, 1, 0, 0, 0, 1, 0}})},
                                      {"none.ply", ""}}) {
        const auto path = folder.write(name, bytes);
        meshio::ReadOptions options;
        options.unit_mm = 0.1;
        const auto here = meshio::internal::readHere(path, options);
        const auto child = meshio::readMesh(path, options);
        QCOMPARE(child.isOk(), here.isOk());
        QCOMPARE(child.status().code(), here.status().code());
        QCOMPARE(child.status().message(), here.status().message());
        if (here.isOk()) {
            QCOMPARE(child.value().path, path);
            QCOMPARE(child.value().unit_mm, 0.1);
            QCOMPARE(child.value().format, here.value().format);
            QCOMPARE(child.value().frame, here.value().frame);
            QVERIFY(std::ranges::equal(child.value().notes, here.value().notes, haveSameParts));
            QCOMPARE(child.value().structures.size(), here.value().structures.size());
            QCOMPARE(child.value().structures[0].name, here.value().structures[0].name);
            QVERIFY(child.value().structures[0].mesh.vertices == here.value().structures[0].mesh.vertices);
            QVERIFY(child.value().structures[0].mesh.triangles == here.value().structures[0].mesh.triangles);
        }
    }
    QCOMPARE(meshio::readMesh(folder.path("missing.stl")).status().code(), StatusCode::NotFound);
    QCOMPARE(meshio::readMesh(folder.path("")).status().code(), StatusCode::Unreadable);
}

void ImportServer::readerThatEndsBadlyIsOneError_data()
{
    QTest::addColumn<std::string>("found");
    QTest::newRow("segv.stl") << std::string("the process that read it crashed (SIGSEGV)");
    QTest::newRow("abort.stl") << std::string("the process that read it crashed (SIGABRT)");
    QTest::newRow("exit.stl") << std::string("the process that read it ended with exit code 7");
    QTest::newRow("files.stl") << std::string("the process that read it ended with exit code 7");
    QTest::newRow("hang.stl") << std::string("reading it took more than ");
    QTest::newRow("spin.stl") << std::string("reading it took more than ");
    QTest::newRow("eat.stl") << std::string("the process that read it crashed (SIGABRT)"); // by an uncaught bad_alloc
}

void ImportServer::readerThatEndsBadlyIsOneError()
{
    QFETCH(std::string, found);
    const test::Folder folder;
    const std::string name = QTest::currentDataTag();
    const auto file = meshio::readMesh(folder.write(name, test::asciiStl()));
    QVERIFY(!file.isOk());
    const std::string& message = file.status().message();
    QVERIFY2(message.starts_with(name + ": " + found), message.c_str());
    QVERIFY2(message.find("; expected ") != std::string::npos, message.c_str());
    QCOMPARE(std::count(message.begin(), message.end(), '\n'), std::ptrdiff_t{0});
    QVERIFY(meshio::readMesh(folder.write("good.stl", test::asciiStl())).isOk());
}

void ImportServer::noiseOfTheReaderIsNotHeard()
{
    const test::Folder folder;
    std::fflush(stdout);
    std::fflush(stderr);
    const int before[2] = {::dup(1), ::dup(2)};
    const int caught = ::open(folder.path("caught").c_str(), O_RDWR | O_CREAT, 0600);
    ::dup2(caught, 1);
    ::dup2(caught, 2);
    const bool isOk = meshio::readMesh(folder.write("noise.stl", test::asciiStl())).isOk();
    ::dup2(before[0], 1);
    ::dup2(before[1], 2);
    for (const int file : {before[0], before[1], caught}) {
        ::close(file);
    }
    QVERIFY(isOk);
    QCOMPARE(test::fileBytes(folder.path("caught")), std::string());
}

void ImportServer::progressRisesAndCancelEndsTheReader()
{
    const test::Folder folder;
    const std::vector<std::array<float, 9>> facets(300000, {0, 0, 0, 1, 0, 0, 0, 1, 0});
    const auto path = folder.write("large.stl", test::binaryStl(300000, facets));
    double last = 0.0;
    std::size_t steps = 0;
    meshio::ReadOptions options;
    options.progress = [&](double share) {
        steps += share > last ? 1 : 0;
        last = share >= last ? share : 2.0;
        return true;
    };
    QVERIFY(meshio::readMesh(path, options).isOk());
    QCOMPARE(last, 1.0);
    QVERIFY2(steps >= 3, std::to_string(steps).c_str());

    const auto hanging = folder.write("hang.stl", test::asciiStl());
    const auto note = folder.path("hang.stl.pid");
    std::string process;
    options.progress = [&](double) { // called also while the reader sends nothing
        process = test::fileBytes(note);
        return process.empty();
    };
    QCOMPARE(meshio::readMesh(hanging, options).status().code(), StatusCode::Cancelled);
    QVERIFY(isGone(static_cast<pid_t>(std::stol(process))));
}

void ImportServer::tenMillionTrianglesCanBeCancelled()
{
    const test::Folder folder;
    const auto path = tenMillion(folder);
    double last = 0.0;
    meshio::ReadOptions options;
    options.progress = [&last](double share) {
        last = share;
        return share < 0.1;
    };
    QCOMPARE(meshio::readMesh(path, options).status().code(), StatusCode::Cancelled);
    QVERIFY(last >= 0.1 && last < 0.9);
}

void ImportServer::tenMillionTrianglesLoad()
{
    if (!qEnvironmentVariableIsSet("PALPATE_SLOW_TESTS")) {
        QSKIP("takes 3 GiB and 10 s: runs as meshio.ImportServer.slow");
    }
    const test::Folder folder;
    const auto path = tenMillion(folder);
    std::set<int> percents;
    meshio::ReadOptions options;
    options.progress = [&percents](double share) {
        percents.insert(static_cast<int>(100.0 * share));
        return true;
    };
    const auto file = meshio::readMesh(path, options);
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QCOMPARE(test::triangles(file.value()), std::size_t{10'000'000});
    QVERIFY(percents.size() > 20);
}

void ImportServer::manyAtOnceAndNothingLeft()
{
    const test::Folder folder;
    for (int i = 0; i < 40; ++i) {
        (void)folder.write(std::string("f").append(std::to_string(i)).append(".stl"), test::asciiStl());
    }
    (void)folder.write("segv.stl", test::asciiStl());
    const std::size_t before = openDescriptors();
    const auto scene = meshio::loadScene(folder.path("")); // on two threads
    QVERIFY2(scene.isOk(), scene.status().message().c_str());
    QCOMPARE(scene.value().structures.size(), std::size_t{40});
    QCOMPARE(scene.value().losses.size(), std::size_t{1});
    QVERIFY(scene.value().losses[0].english().starts_with("segv.stl: "));
    QCOMPARE(openDescriptors(), before);
}

/// Structures of a label map come in order while the child works, and the result is that of this process.
void ImportServer::structuresComeOneByOne()
{
    const test::Folder folder;
    const auto path = folder.write("cubes.nrrd", manyCubes());
    const auto here = meshio::internal::readHere(path, {});
    QVERIFY2(here.isOk(), here.status().message().c_str());
    QCOMPARE(here.value().structures.size(), std::size_t{27});
    std::size_t received = 0;
    meshio::ReadOptions options;
    options.structureRead = [&](meshio::MeshFile& file) {
        ++received;
        QCOMPARE(file.structures.size(), received);
        QCOMPARE(file.format, here.value().format);
        QVERIFY(file.voxels && file.voxels->voxel_mm == here.value().voxels->voxel_mm);
        QVERIFY(file.structures.back().mesh.vertices == here.value().structures[received - 1].mesh.vertices);
    };
    const auto child = meshio::readMesh(path, options);
    QVERIFY2(child.isOk(), child.status().message().c_str());
    QVERIFY(received <= 27);
    QCOMPARE(child.value().structures.size(), std::size_t{27});
    QVERIFY(std::ranges::equal(child.value().notes, here.value().notes, haveSameParts));
    for (std::size_t i = 0; i < 27; ++i) {
        const auto &a = child.value().structures[i], &b = here.value().structures[i];
        QCOMPARE(a.name, b.name);
        QVERIFY(a.mesh.vertices == b.mesh.vertices && a.mesh.triangles == b.mesh.triangles);
    }
}

/// A child that is stopped after some structures is an error, as if it had handed over none.
void ImportServer::readerThatEndsMidwayLeavesNothing()
{
    const test::Folder folder;
    const auto path = folder.write("midway.nrrd", manyCubes());
    std::size_t received = 0;
    meshio::ReadOptions options;
    options.structureRead = [&received](meshio::MeshFile&) { ++received; };
    const auto file = meshio::readMesh(path, options);
    QVERIFY(!file.isOk());
    QVERIFY2(file.status().message().starts_with("midway.nrrd: its content is larger than "),
             file.status().message().c_str());
    QVERIFY(received > 0 && received < 27);
    std::atomic<std::size_t> shown{0};
    options.structureReady = [&shown](const meshio::LoadedStructure&) { ++shown; };
    const auto scene = meshio::loadScene(path, options);
    QVERIFY(!scene.isOk());
    QCOMPARE(scene.status().code(), StatusCode::OutOfRange);
    QVERIFY(shown > 0);
    const auto other = folder.write("whole.stl", test::asciiStl()); // in a folder, only the whole file is left
    const auto both = meshio::loadScene(folder.path(""), options);
    QVERIFY2(both.isOk(), both.status().message().c_str());
    QCOMPARE(both.value().structures.size(), std::size_t{1});
    QCOMPARE(both.value().losses.size(), std::size_t{1});
}

/// The preview has each structure once, and the scene is the same without a preview.
void ImportServer::sceneShowsStructuresEarly()
{
    const test::Folder folder;
    const auto map = folder.write("cubes.nrrd", manyCubes());
    const test::Folder meshes;
    for (const char* name : {"a.stl", "b.stl", "c.stl"}) {
        (void)meshes.write(name, test::asciiStl());
    }
    for (const auto& path : {map, meshes.path("")}) {
        const auto plain = meshio::loadScene(path);
        QVERIFY2(plain.isOk(), plain.status().message().c_str());
        std::mutex mutex;
        std::set<std::string> names;
        std::set<std::shared_ptr<const geometry::RepairedMesh>> surfaces;
        meshio::ReadOptions options;
        options.structureReady = [&](const meshio::LoadedStructure& one) {
            const std::scoped_lock lock(mutex);
            names.insert(one.description.name);
            surfaces.insert(one.surface);
        };
        const auto scene = meshio::loadScene(path, options);
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        QCOMPARE(scene.value().structures.size(), plain.value().structures.size());
        QCOMPARE(surfaces.size(), plain.value().structures.size());
        for (std::size_t i = 0; i < scene.value().structures.size(); ++i) {
            const auto &a = scene.value().structures[i], &b = plain.value().structures[i];
            QCOMPARE(a.description.name, b.description.name);
            QCOMPARE(a.description.part, b.description.part);
            QVERIFY(a.description.colour == b.description.colour);
            QVERIFY(a.description.smoothing == b.description.smoothing);
            QVERIFY(names.contains(a.description.name) && surfaces.contains(a.surface));
            QVERIFY(a.surface->mesh.vertices == b.surface->mesh.vertices);
            QVERIFY(a.smoothing.has_value() == (path == map));
        }
    }
}

void ImportServer::outcomeComesBackWhole()
{
    const Wire wire;
    QVERIFY(writeOutcome(wire.file(), twoStructures()));
    const auto file = wire.taken();
    QVERIFY2(file.isOk(), file.status().message().c_str());
    const meshio::MeshFile whole = twoStructures();
    QCOMPARE(file.value().format, whole.format);
    QCOMPARE(file.value().frame, whole.frame);
    QVERIFY(std::ranges::equal(file.value().notes, whole.notes, haveSameParts));
    QVERIFY(haveSameParts(file.value().loss, whole.loss));
    QCOMPARE(file.value().structures.size(), std::size_t{2});
    for (std::size_t i = 0; i < 2; ++i) {
        QCOMPARE(file.value().structures[i].name, whole.structures[i].name);
        QVERIFY(file.value().structures[i].colour == whole.structures[i].colour);
        QVERIFY(file.value().structures[i].mesh.vertices == whole.structures[i].mesh.vertices);
        QVERIFY(file.value().structures[i].mesh.triangles == whole.structures[i].mesh.triangles);
    }
}

/// Structures can be read while the outcome is unknown; an error makes them void.
void ImportServer::structuresComeBeforeTheOutcome()
{
    for (const bool isOk : {true, false}) {
        const Wire wire;
        meshio::internal::OutcomeReader reader(wire.file(), "/somewhere/a.stl");
        meshio::MeshFile file = twoStructures();
        const meshio::MeshStructure second = file.structures[1];
        file.structures.pop_back();
        QVERIFY(writeStructure(wire.file(), file));
        QVERIFY(reader.readStructure());
        QVERIFY(reader.file().frame == file.frame && reader.file().structures.size() == 1);
        QVERIFY(reader.file().structures[0].mesh.vertices == twoStructures().structures[0].mesh.vertices);
        file.structures.push_back(second);
        QVERIFY(isOk ? writeOutcome(wire.file(), file, 1)
                     : writeOutcome(wire.file(), core::Status(StatusCode::OutOfRange, PALPATE_TEXT("too large"))));
        const auto outcome = std::move(reader).finish();
        QCOMPARE(outcome.isOk(), isOk);
        if (isOk) {
            QCOMPARE(outcome.value().structures.size(), std::size_t{2});
            QVERIFY(outcome.value().structures[1].mesh.vertices == second.mesh.vertices);
            QCOMPARE(outcome.value().notes.size(), std::size_t{2});
        } else {
            QCOMPARE(outcome.status().message(), std::string("a.stl: too large"));
        }
    }
}

void ImportServer::errorComesBackAsOneLine()
{
    const Wire wire;
    QVERIFY(writeOutcome(wire.file(), core::Status(StatusCode::OutOfRange, PALPATE_TEXT("two\nlines"))));
    QCOMPARE(wire.taken().status().code(), StatusCode::OutOfRange);
    QCOMPARE(wire.taken().status().message(), std::string("a.stl: two lines"));
}

void ImportServer::errorKeepsItsTextsAndArguments()
{
    const core::Message inner(PALPATE_TEXT("array \"%1\""), "heat");
    const core::Status sent(StatusCode::BadFormat, PALPATE_TEXT("%1: %2: %3 of %4"), "a.stl", inner, core::Count(1234),
                            0.5);
    const Wire wire;
    QVERIFY(writeOutcome(wire.file(), sent));
    const core::Status received = wire.taken().status();
    QCOMPARE(received.message(), std::string("a.stl: array \"heat\": 1,234 of 0.5"));
    QVERIFY(haveSameParts(received.text(), sent.text()));
    const Wire ofVolume; // of another name, which is added
    QVERIFY(writeVolume(ofVolume.file(), sent));
    QVERIFY(haveSameParts(ofVolume.volume().status().text(), sent.at("a.mha").text()));
}

void ImportServer::excessiveMessagesAreRefused_data()
{
    QTest::addColumn<bool>("isAccepted");
    QTest::addColumn<core::Message>("message");
    core::Message deep(PALPATE_TEXT("a.stl: x"));
    for (int levels = 1; levels < 8; ++levels) {
        deep = core::Message::fromParts("%1", {deep});
    }
    QTest::newRow("8 levels") << true << deep;
    QTest::newRow("9 levels") << false << core::Message::fromParts("%1", {deep});
    const std::string longest(4000 - 7, 'x');
    QTest::newRow("4000 bytes") << true << core::Message(PALPATE_TEXT("a.stl: %1"), longest);
    QTest::newRow("4001 bytes") << false << core::Message(PALPATE_TEXT("a.stl: %1"), longest + 'x');
    QTest::newRow("no text") << false << core::Message();
    core::Message growing(PALPATE_TEXT("an English text of 32 characters"));
    for (int levels = 1; levels < 8; ++levels) { // doubles: 32 x 2^7 bytes
        growing = core::Message::fromParts("%1%1", {growing});
    }
    QTest::newRow("repeated places") << false << growing;
}

void ImportServer::excessiveMessagesAreRefused()
{
    QFETCH(bool, isAccepted);
    QFETCH(core::Message, message);
    const Wire wire;
    QVERIFY(writeOutcome(wire.file(), core::Status(StatusCode::BadFormat, message)));
    const core::Status received = wire.taken().status();
    QCOMPARE(received.code(), isAccepted ? StatusCode::BadFormat : StatusCode::Internal);
    QVERIFY(received.message().starts_with("a.stl: "));
}

void ImportServer::liesAreRefused_data()
{
    QTest::addColumn<std::string>("bytes");
    const auto row = [](const char* name, meshio::MeshFile file, auto&& change) {
        change(file);
        const Wire wire;
        QVERIFY(writeOutcome(wire.file(), std::move(file)));
        QTest::newRow(name) << wire.bytes();
    };
    const auto p = [](meshio::MeshFile& f) -> core::Vec3& { return f.structures[1].mesh.vertices[3]; };
    row("index", twoStructures(), [](auto& f) { f.structures[1].mesh.triangles[3][2] = 4; });
    row("not a number", twoStructures(), [&](auto& f) { p(f).y() = std::nan(""); });
    row("infinite", twoStructures(), [&](auto& f) { p(f).x() = std::numeric_limits<double>::infinity(); });
    row("far", twoStructures(), [&](auto& f) { p(f).z() = -1.1e7; });
    row("colour", twoStructures(), [](auto& f) { f.structures[1].colour = {0.0, 1.5, 0.0}; });
    row("frame", twoStructures(), [](auto& f) { f.frame = static_cast<meshio::FileFrame>(3); });
    row("no structure", twoStructures(), [](auto& f) { f.structures.clear(); });
    row("no triangle", twoStructures(), [](auto& f) { f.structures[0].mesh.triangles.clear(); });
    const auto frames = [](const char* name, auto&& write) {
        const Wire wire;
        meshio::MeshFile two = twoStructures(), one = twoStructures();
        one.structures.pop_back();
        QVERIFY(write(wire.file(), one, two));
        QTest::newRow(name) << wire.bytes();
    };
    frames("no end", [](int f, auto& one, auto&) { return writeStructure(f, one); });
    frames("structure first",
           [](int f, auto& one, auto& two) { return writeStructure(f, two) && writeOutcome(f, one, 1); });
    frames("begun twice", [](int f, auto& one, auto& two) {
        auto again = one;
        return writeStructure(f, one) && writeStructure(f, again) && writeOutcome(f, two, 2);
    });
    frames("fewer than stated",
           [](int f, auto& one, auto& two) { return writeStructure(f, one) && writeOutcome(f, two, 2); });
    frames("more than stated", [](int f, auto& one, auto& two) {
        auto whole = one;
        return writeStructure(f, one) && writeStructure(f, two) && writeOutcome(f, whole, 1);
    });
    frames("structure after the end", [](int f, auto& one, auto& two) {
        auto whole = one;
        return writeStructure(f, one) && writeOutcome(f, whole, 1) && writeStructure(f, two);
    });
    frames("unknown frame", [](int f, auto& one, auto& two) {
        const std::string frame = std::string("\x01\0\0\0\0\0\0\0\x03", 9);
        return writeStructure(f, one) && ::write(f, frame.data(), frame.size()) == 9 && writeOutcome(f, two, 1);
    });
    const Wire wire;
    QVERIFY(writeOutcome(wire.file(), twoStructures()));
    const std::string whole = wire.bytes();
    QTest::newRow("nothing") << std::string();
    QTest::newRow("cut") << whole.substr(0, whole.size() - 1);
    QTest::newRow("longer") << whole + 'a';
    QTest::newRow("head alone") << std::string(8, '\xff');
    QTest::newRow("ok without a mesh") << std::string(8, '\0');
}

void ImportServer::liesAreRefused()
{
    QFETCH(std::string, bytes);
    const Wire wire;
    wire.set(bytes);
    const auto file = wire.taken();
    QVERIFY(!file.isOk());
    QCOMPARE(file.status().code(), StatusCode::Internal);
    QVERIFY(file.status().message().starts_with("a.stl: the result of the import process is damaged: "));
}

void ImportServer::anyByteMayBeWrong()
{
    const Wire whole;
    QVERIFY(writeOutcome(whole.file(), twoStructures()));
    const std::string bytes = whole.bytes();
    const Wire wire;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        for (const char flip : {'\x01', '\x80', '\xff'}) {
            std::string damaged = bytes;
            damaged[i] = static_cast<char>(damaged[i] ^ flip);
            wire.set(damaged);
            const auto file = wire.taken();
            if (file.isOk()) {
                for (const auto& structure : file.value().structures) {
                    for (const auto& triangle : structure.mesh.triangles) {
                        QVERIFY(*std::max_element(triangle.begin(), triangle.end()) < structure.mesh.vertices.size());
                    }
                }
            }
        }
    }
}

void ImportServer::readsVolumesAsThisProcessDoes()
{
    const std::size_t before = openDescriptors();
    for (const test::VolumeSample& sample : test::volumeSamples()) {
        const test::Folder folder;
        if (!sample.dataName.empty()) {
            (void)folder.write(sample.dataName, sample.data);
        }
        const auto path = folder.write(sample.name, sample.bytes);
        const auto here = meshio::internal::readVolumeHere(path, meshio::FileFrame::Ras, {});
        double last = 0.0;
        const auto child = meshio::internal::readVolume(path, meshio::FileFrame::Ras, [&last](double share) {
            last = share >= last ? share : 2.0;
            return true;
        });
        QVERIFY2(here.isOk() && child.isOk(), child.status().message().c_str());
        QVERIFY(child.value().size == here.value().size);
        QVERIFY(child.value().values == here.value().values);
        QVERIFY(child.value().toVoxel.matrix() == here.value().toVoxel.matrix());
        QCOMPARE(last, 1.0);
    }
    QCOMPARE(openDescriptors(), before);
    const test::Folder folder;
    QCOMPARE(meshio::internal::readVolume(folder.path("gone.mha"), meshio::FileFrame::Ras, {}).status().code(),
             StatusCode::NotFound);
}

void ImportServer::readerOfAVolumeThatEndsBadlyIsOneError_data()
{
    QTest::addColumn<std::string>("found");
    QTest::addColumn<std::string>("expected");
    QTest::newRow("segv.mha") << std::string("the process that read it crashed (SIGSEGV)")
                              << std::string("a file that can be read");
    QTest::newRow("exit.vti") << std::string("the process that read it ended with exit code 7")
                              << std::string("a file that can be read");
    QTest::newRow("hang.nrrd") << std::string("reading it took more than ")
                               << std::string("a file that can be read in this time");
    QTest::newRow("spin.nii") << std::string("reading it took more than ")
                              << std::string("a file that can be read in this time");
    QTest::newRow("eat.mha") << std::string("the process that read it crashed (SIGABRT)") // by an uncaught bad_alloc
                             << std::string("a file that can be read");
}

void ImportServer::readerOfAVolumeThatEndsBadlyIsOneError()
{
    QFETCH(std::string, found);
    QFETCH(std::string, expected);
    const test::Folder folder;
    const std::string name = QTest::currentDataTag();
    const auto volume = meshio::internal::readVolume(folder.write(name, "x"), meshio::FileFrame::Untagged, {});
    QVERIFY(!volume.isOk());
    const std::string& message = volume.status().message();
    QVERIFY2(message.starts_with(name + ": " + found), message.c_str());
    QVERIFY2(message.ends_with("; expected " + expected), message.c_str());
    QCOMPARE(std::count(message.begin(), message.end(), '\n'), std::ptrdiff_t{0});
}

void ImportServer::aVolumeThatHangsCanBeCancelled()
{
    const test::Folder folder;
    const auto path = folder.write("hang.mha", "x");
    const auto note = folder.path("hang.mha.pid");
    std::string process;
    const auto volume = meshio::internal::readVolume(path, meshio::FileFrame::Untagged, [&](double) {
        process = test::fileBytes(note);
        return process.empty();
    });
    QCOMPARE(volume.status().code(), StatusCode::Cancelled);
    QVERIFY(isGone(static_cast<pid_t>(std::stol(process))));
}

void ImportServer::mapsGoThroughTheChild()
{
    const test::Folder folder;
    QVERIFY(meshio::writeMesh(folder.path("m.vtp"), std::vector{test::tetrahedron("liver")}).isOk());
    (void)folder.write("segv.mha", "x");
    const auto scene = meshio::loadScene(folder.write(
        "s.palpate.json", "{\"version\": 1, \"structures\": [{\"mesh\": \"m.vtp\", \"stiffness_N_per_mm\": 0.4, "
                          "\"maps\": [{\"quantity\": \"friction\", \"file\": \"segv.mha\"}]}]}"));
    QVERIFY2(scene.isOk(), scene.status().message().c_str());
    QVERIFY(scene.value().structures[0].maps.empty());
    QCOMPARE(scene.value().losses.size(), std::size_t{1});
    QVERIFY2(scene.value().losses[0].english().find("segv.mha: the process that read it crashed") != std::string::npos,
             scene.value().losses[0].english().c_str());
}

void ImportServer::liesAboutAVolumeAreRefused_data()
{
    QTest::addColumn<std::string>("bytes");
    const auto row = [](const char* name, auto&& change) {
        VoxelGrid grid;
        grid.size = {2, 3, 1};
        grid.values.assign(6, 1.0F);
        change(grid);
        const Wire wire;
        QVERIFY(writeVolume(wire.file(), std::move(grid)));
        QTest::newRow(name) << wire.bytes();
    };
    row("more than there are", [](auto& g) { g.size[2] = 2; });
    row("fewer than there are", [](auto& g) { g.size[0] = 1; });
    row("none", [](auto& g) {
        g.size[1] = 0;
        g.values.clear();
    });
    row("a product of 2^96", [](auto& g) { g.size = {~0U, ~0U, ~0U}; });
    row("a product of 2^64 is 0", [](auto& g) {
        g.size = {1U << 30, 1U << 30, 16};
        g.values.clear();
    });
    row("not a number", [](auto& g) { g.toVoxel.matrix()(1, 2) = std::nan(""); });
    row("infinite", [](auto& g) { g.toVoxel.matrix()(0, 3) = std::numeric_limits<double>::infinity(); });
    VoxelGrid grid;
    grid.size = {2, 3, 1};
    grid.values.assign(6, 1.0F);
    const Wire wire;
    QVERIFY(writeVolume(wire.file(), std::move(grid)));
    QVERIFY(wire.volume().isOk()); // the unmodified outcome is accepted
    QTest::newRow("cut") << wire.bytes().substr(0, wire.bytes().size() - 1);
    QTest::newRow("longer") << wire.bytes() + 'a';
    QTest::newRow("nothing") << std::string();
    QTest::newRow("head alone") << std::string(8, '\xff');
    QTest::newRow("ok without a volume") << std::string(8, '\0');
}

void ImportServer::liesAboutAVolumeAreRefused()
{
    QFETCH(std::string, bytes);
    const Wire wire;
    wire.set(bytes);
    const auto volume = wire.volume();
    QVERIFY(!volume.isOk());
    QCOMPARE(volume.status().code(), StatusCode::Internal);
    QVERIFY(volume.status().message().starts_with("a.mha: the result of the import process is damaged: "));
}

void ImportServer::anyByteOfAVolumeMayBeWrong()
{
    constexpr std::size_t kStep = 13;
    for (const test::VolumeSample& sample : test::volumeSamples()) {
        const test::Folder folder;
        if (!sample.dataName.empty()) {
            (void)folder.write(sample.dataName, sample.data);
        }
        for (std::size_t i = 0; i < sample.bytes.size(); i += kStep) {
            std::string damaged = sample.bytes;
            damaged[i] = static_cast<char>(damaged[i] ^ (i % 2 == 0 ? '\x01' : '\xff'));
            const auto volume =
                meshio::internal::readVolume(folder.write(sample.name, damaged), meshio::FileFrame::Untagged, {});
            if (volume.isOk()) {
                const auto& size = volume.value().size;
                QCOMPARE(volume.value().values.size(), std::size_t{size[0]} * size[1] * size[2]);
                QVERIFY(volume.value().toVoxel.matrix().allFinite());
            } else {
                QVERIFY2(volume.status().message().starts_with(sample.name + ": "), volume.status().message().c_str());
            }
        }
    }
}

/// The server must fork at the start of the program, so this is a separate program.
int main(int argc, char** argv)
{
    meshio::ImportLimits limits;
    limits.memory_bytes = std::uint64_t{1} << 29;
    limits.cpu_s = 1.0;
    limits.wall_s = 4.0;
    if (!meshio::internal::startImportServer(limits, misbehave).isOk()) {
        return 1;
    }
    const QCoreApplication application(argc, argv);
    ImportServer tests;
    return QTest::qExec(&tests, argc, argv);
}

#include "tst_ImportServer.moc"
