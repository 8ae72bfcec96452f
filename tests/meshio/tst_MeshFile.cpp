// SPDX-License-Identifier: BSD-3-Clause
#include "Samples.h"
#include "TestRunner.h"

using namespace palpate;
using meshio::MeshStructure;

/// Tests writing, and reading the result.
class MeshFile : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void vtpGivesBackEveryBit();
    void stlGivesBackTrianglesInLps();
    void writingNothingIsAnError();
    void badIndexIsNotWritten();
    void unknownExtensionIsAnError();
    void failedWriteLeavesNoFile();
    void overwritesInOneStep();
};

void MeshFile::vtpGivesBackEveryBit()
{
    const test::Folder folder;
    std::vector<MeshStructure> structures{test::tetrahedron("liver"),
                                          test::tetrahedron("hepatic vein <2>", {1e6, 0.1, 1.0 / 3.0})};
    structures[1].colour = {0.25, 1.0 / 3.0, 1.0};
    structures[0].mesh.vertices[1].x() = 24.000000000000004;
    const auto path = folder.path("two parts ä.vtp");
    const core::Status status = meshio::writeMesh(path, structures);
    QVERIFY2(status.isOk(), status.message().c_str());
    const auto file = meshio::readMesh(path);
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QCOMPARE(file.value().frame, meshio::FileFrame::Lps);
    QCOMPARE(file.value().structures.size(), std::size_t{2});
    for (std::size_t s = 0; s < 2; ++s) {
        const MeshStructure& back = file.value().structures[s];
        QCOMPARE(back.name, structures[s].name);
        QVERIFY(back.colour == structures[s].colour);
        QCOMPARE(back.mesh.triangles.size(), std::size_t{4});
        for (std::size_t t = 0; t < 4; ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const core::Vec3& was = structures[s].mesh.vertices[structures[s].mesh.triangles[t][k]];
                QVERIFY(back.mesh.vertices[back.mesh.triangles[t][k]] == was);
            }
        }
    }
}

void MeshFile::stlGivesBackTrianglesInLps()
{
    const test::Folder folder;
    const std::vector<MeshStructure> structures{test::tetrahedron("a"), test::tetrahedron("b", {100, 0, 0})};
    const auto path = folder.path("both.stl");
    QVERIFY(meshio::writeMesh(path, structures).isOk());
    QCOMPARE(std::filesystem::file_size(path), std::uintmax_t{84 + 8 * 50});
    const auto file = meshio::readMesh(path);
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QCOMPARE(file.value().format, std::string("STL binary"));
    QCOMPARE(file.value().frame, meshio::FileFrame::Lps);
    QCOMPARE(file.value().structures.size(), std::size_t{1});
    QCOMPARE(test::triangles(file.value()), std::size_t{8});
    const core::Box box = file.value().structures[0].mesh.bounds();
    QVERIFY(box.min() == core::Vec3(0, 0, 0) && box.max() == core::Vec3(124, 24, 24));
}

void MeshFile::writingNothingIsAnError()
{
    const test::Folder folder;
    QCOMPARE(meshio::writeMesh(folder.path("no.vtp"), {}).code(), core::StatusCode::Empty);
    QVERIFY(!std::filesystem::exists(folder.path("no.vtp")));
}

void MeshFile::badIndexIsNotWritten()
{
    const test::Folder folder;
    std::vector<MeshStructure> structures{test::tetrahedron("a")};
    structures[0].mesh.triangles[2][1] = 4;
    for (const char* name : {"a.vtp", "a.stl"}) {
        QCOMPARE(meshio::writeMesh(folder.path(name), structures).code(), core::StatusCode::OutOfRange);
        QVERIFY(!std::filesystem::exists(folder.path(name)));
    }
}

void MeshFile::unknownExtensionIsAnError()
{
    const test::Folder folder;
    const std::vector<MeshStructure> structures{test::tetrahedron("a")};
    QCOMPARE(meshio::writeMesh(folder.path("a.obj"), structures).code(), core::StatusCode::BadCommandLine);
}

void MeshFile::failedWriteLeavesNoFile()
{
    const test::Folder folder;
    const std::vector<MeshStructure> structures{test::tetrahedron("a")};
    std::filesystem::create_directory(folder.path("a.stl")); // a rename cannot replace a folder
    const core::Status status = meshio::writeMesh(folder.path("a.stl"), structures);
    QCOMPARE(status.code(), core::StatusCode::Unreadable);
    const std::filesystem::directory_iterator files(folder.path(""));
    QCOMPARE(std::distance(begin(files), end(files)), std::ptrdiff_t{1});
    QCOMPARE(meshio::writeMesh(folder.path("missing/a.stl"), structures).code(), core::StatusCode::NotFound);
}

void MeshFile::overwritesInOneStep()
{
    const test::Folder folder;
    const std::vector<MeshStructure> structures{test::tetrahedron("a")};
    const auto path = folder.write("a.stl", "what was there before");
    const std::filesystem::path link = folder.path("still the old one");
    std::filesystem::create_hard_link(path, link);
    QVERIFY(meshio::writeMesh(path, structures).isOk());
    QCOMPARE(test::fileBytes(link), std::string("what was there before"));
    QVERIFY(meshio::readMesh(path).isOk());
}

PALPATE_TEST(MeshFile)
#include "tst_MeshFile.moc"
