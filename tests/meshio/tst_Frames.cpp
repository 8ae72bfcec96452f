// SPDX-License-Identifier: BSD-3-Clause
#include "English.h"
#include "Samples.h"
#include "TestRunner.h"

#include <palpate/geometry/MeshReport.h>

#include <QTest>

#include <algorithm>

using namespace palpate;
using core::FileFrame;
using core::Vec3;

namespace {

/// Returns a tetrahedron with edges of 10, 20 and 30 mm along x, y and z from (1, 2, 3), normals outwards.
std::string lopsided(const std::string& head = "")
{
    return head + "v 1 2 3\nv 11 2 3\nv 1 22 3\nv 1 2 33\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
}

meshio::ReadOptions as(FileFrame frame)
{
    meshio::ReadOptions options;
    options.frame = frame;
    return options;
}

/// Returns a volume of 24 mm with values that rise along x only: 1 at x = -12 mm to 25 at 12 mm.
std::string vti()
{
    std::string values;
    for (int z = 0; z < 3; ++z) {
        for (int y = 0; y < 3; ++y) {
            values += "1 13 25 ";
        }
    }
    return "<?xml version=\"1.0\"?><VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\"><ImageData "
           "WholeExtent=\"0 2 0 2 0 2\" Origin=\"-12 -12 -12\" Spacing=\"12 12 12\"><Piece Extent=\"0 2 0 2 0 2\">"
           "<PointData Scalars=\"s\"><DataArray type=\"Float64\" Name=\"s\" format=\"ascii\">" +
           values + "</DataArray></PointData></Piece></ImageData></VTKFile>";
}

} // namespace

/// Tests files with other axes than the world frame, and with other units.
class Frames : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void eachIsARotation()
    {
        for (const FileFrame frame : {FileFrame::Untagged, FileFrame::Lps, FileFrame::Ras, FileFrame::YUp}) {
            const Eigen::Matrix3d R = core::lpsRotation(frame);
            QCOMPARE(R.determinant(), 1.0);
            QVERIFY(R * R.transpose() == Eigen::Matrix3d::Identity());
            QVERIFY(R * Vec3(1, 2, 3) == core::toLps(frame, Vec3(1, 2, 3)));
        }
        // The patient's left, front and head.
        QVERIFY(core::toLps(FileFrame::Ras, Vec3(-1, 0, 0)) == Vec3(1, 0, 0));
        QVERIFY(core::toLps(FileFrame::Ras, Vec3(0, 1, 0)) == Vec3(0, -1, 0));
        QVERIFY(core::toLps(FileFrame::YUp, Vec3(1, 0, 0)) == Vec3(1, 0, 0));
        QVERIFY(core::toLps(FileFrame::YUp, Vec3(0, 0, 1)) == Vec3(0, -1, 0));
        QVERIFY(core::toLps(FileFrame::YUp, Vec3(0, 1, 0)) == Vec3(0, 0, 1));
    }

    void chosenAxesTurnTheMesh_data()
    {
        QTest::addColumn<std::string>("head");
        QTest::addColumn<FileFrame>("chosen");
        QTest::addColumn<Vec3>("low");
        QTest::addColumn<Vec3>("high");
        const Vec3 lps[]{{1, 2, 3}, {11, 22, 33}}, ras[]{{-11, -22, 3}, {-1, -2, 33}}, up[]{{1, -33, 2}, {11, -3, 22}};
        QTest::newRow("nothing said") << std::string() << FileFrame::Untagged << lps[0] << lps[1];
        QTest::newRow("LPS") << std::string() << FileFrame::Lps << lps[0] << lps[1];
        QTest::newRow("RAS") << std::string() << FileFrame::Ras << ras[0] << ras[1];
        QTest::newRow("Y-up") << std::string() << FileFrame::YUp << up[0] << up[1];
        QTest::newRow("RAS by tag") << std::string("# SPACE=RAS\n") << FileFrame::Untagged << ras[0] << ras[1];
        QTest::newRow("LPS over tag") << std::string("# SPACE=RAS\n") << FileFrame::Lps << lps[0] << lps[1];
        QTest::newRow("Y-up over tag") << std::string("# SPACE=LPS\n") << FileFrame::YUp << up[0] << up[1];
    }
    void chosenAxesTurnTheMesh()
    {
        QFETCH(std::string, head);
        QFETCH(FileFrame, chosen);
        QFETCH(Vec3, low);
        QFETCH(Vec3, high);
        const test::Folder folder;
        const auto scene = meshio::loadScene(folder.write("a.obj", lopsided(head)), as(chosen));
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        const meshio::LoadedStructure& one = scene.value().structures.at(0);
        QVERIFY(one.surface->report.bounds.min() == low && one.surface->report.bounds.max() == high);
        QVERIFY(std::abs(one.surface->report.volume_mm3 - 1000.0) < 1e-9); // positive: still outwards
        QCOMPARE(one.surface->report.insideOutComponents, std::size_t{0});
        QCOMPARE(one.description.frame, chosen);
        const bool isTold = !head.empty() && chosen != FileFrame::Untagged;
        QCOMPARE(test::mentions(scene.value().warnings, "as was chosen"), isTold);
        QCOMPARE(test::mentions(scene.value().warnings, "no SPACE tag: coordinates taken as LPS"),
                 head.empty() && chosen == FileFrame::Untagged);
    }

    void aSceneKeepsTheChoice()
    {
        const test::Folder folder;
        (void)folder.write("a.obj", lopsided());
        auto first = meshio::loadScene(folder.path("a.obj"), as(FileFrame::YUp));
        const auto path = folder.path("a.palpate.json");
        QVERIFY(meshio::writeScene(path, first.value().scene).isOk());
        QVERIFY(test::fileBytes(path).find("\"frame\": \"Y-up\"") != std::string::npos);
        const auto again = meshio::loadScene(path);
        QVERIFY2(again.isOk(), again.status().message().c_str());
        QCOMPARE(again.value().scene.structures[0].frame, FileFrame::YUp);
        QVERIFY(again.value().structures[0].surface->mesh.vertices ==
                first.value().structures[0].surface->mesh.vertices);
        // A frame in the scene file takes precedence over the option, and a message reports the conflict.
        const auto asked = meshio::loadScene(path, as(FileFrame::Ras));
        QVERIFY(asked.value().structures[0].surface->mesh.vertices ==
                again.value().structures[0].surface->mesh.vertices);
        QVERIFY(test::mentions(asked.value().warnings, "taken as Y-up, as the scene file says; not as RAS"));
        // In memory, reinterpreted in another frame.
        meshio::SceneFile turned = again.value().scene;
        turned.structures[0].frame = FileFrame::Ras;
        turned.structures[0].tissue.stiffness_N_per_mm = 0.75;
        const auto reloaded = meshio::loadScene(turned, path);
        QVERIFY2(reloaded.isOk(), reloaded.status().message().c_str());
        QVERIFY(reloaded.value().structures[0].surface->report.bounds.max() == Vec3(-1, -2, 33));
        QCOMPARE(reloaded.value().structures[0].description.tissue.stiffness_N_per_mm, 0.75);
    }

    void aSceneThatSaysNoneStaysAsItWas()
    {
        const test::Folder folder;
        (void)folder.write("a.obj", lopsided());
        const auto path =
            folder.write("a.palpate.json", R"({"version": 1, "structures": [{"mesh": "a.obj"}, {"mesh": "a.obj"}]})");
        const auto scene = meshio::loadScene(path);
        QCOMPARE(scene.value().structures[0].description.frame, FileFrame::Untagged);
        QVERIFY(meshio::writeScene(path, scene.value().scene).isOk());
        QVERIFY(test::fileBytes(path).find("frame") == std::string::npos);
        const auto asked = meshio::loadScene(path, as(FileFrame::Ras));
        QVERIFY(asked.value().structures[1].surface->report.bounds.max() == Vec3(-1, -2, 33));
    }

    void wrongAxesAreNamed()
    {
        const test::Folder folder;
        const auto wrong = [&](const char* value) {
            const auto path = folder.write("a.json", R"({"version": 1, "structures": [{"mesh": "a.obj", "frame": )" +
                                                         std::string(value) + "}]}");
            return QString::fromStdString(meshio::readScene(path).status().message());
        };
        QCOMPARE(wrong("\"LAS\""), QString("a.json: structures[0].frame: found \"LAS\", expected LPS, RAS or Y-up"));
        QCOMPARE(wrong("\"lps\""), QString("a.json: structures[0].frame: found \"lps\", expected LPS, RAS or Y-up"));
        QCOMPARE(wrong("\"\""), QString("a.json: structures[0].frame: found \"\", expected LPS, RAS or Y-up"));
        QVERIFY2(wrong("2").startsWith("a.json: structures[0].frame: found 2, expected"), qPrintable(wrong("2")));
    }

    void aVolumeWithoutAxesTurnsWithItsMesh()
    {
        const test::Folder folder;
        (void)folder.write("a.obj", "v -9 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
        (void)folder.write("v.vti", vti());
        const auto felt = [&](const char* frame) {
            const auto scene = meshio::loadScene(folder.write(
                "s.palpate.json", R"({"version": 1, "structures": [{"mesh": "a.obj", "frame": ")" + std::string(frame) +
                                      R"(", "maps": [{"quantity": "stiffness", "file": "v.vti", "unit": "scale",
                                         "contact_radius_mm": 0.01}]}]})"));
            return scene.value().structures.at(0).maps.at(0).values;
        };
        const auto lps = felt("LPS");
        QVERIFY2(lps[0] < 8.0F && lps[2] > 16.0F, qPrintable(QString("%1 %2").arg(lps[0]).arg(lps[2])));
        for (const char* other : {"RAS", "Y-up"}) { // the same positions in the same tissue
            const auto values = felt(other);
            for (std::size_t i = 0; i < lps.size(); ++i) {
                QVERIFY2(std::abs(values[i] - lps[i]) < 0.1F, other);
            }
        }
    }

    void slicersScaleIsTheUnit_data()
    {
        QTest::addColumn<std::string>("scale");
        QTest::addColumn<double>("unit_mm"); // the requested unit
        QTest::addColumn<double>("taken_mm");
        QTest::addColumn<QString>("note");
        QTest::newRow("metres") << std::string(";SCALE=0.001") << 1.0 << 1000.0 << "taken as 1000 mm";
        QTest::newRow("unit given") << std::string(";SCALE=0.001") << 10.0 << 10.0
                                    << "not used, because the unit was given";
        QTest::newRow("none") << std::string() << 1.0 << 1.0 << "";
        QTest::newRow("mm") << std::string(";SCALE=1") << 1.0 << 1.0 << "";
        QTest::newRow("zero") << std::string(";SCALE=0") << 1.0 << 1.0 << "SCALE=\"0\" in the header is not used";
        QTest::newRow("no number") << std::string(";SCALE=x") << 1.0 << 1.0 << "SCALE=\"\" in the header is not used";
    }
    void slicersScaleIsTheUnit()
    {
        QFETCH(std::string, scale);
        QFETCH(double, unit_mm);
        QFETCH(double, taken_mm);
        QFETCH(QString, note);
        const test::Folder folder;
        const std::string head = "3D Slicer output. SPACE=LPS" + scale;
        for (const auto& [name, bytes] :
             {std::pair("b.stl", test::binaryStl(1, {{0, 0, 0, 2.5F, 0, 0, 0, 1.5F, 0}}, head)),
              std::pair("a.stl", test::asciiStl(head)), std::pair("above.stl", head + "\n" + test::asciiStl())}) {
            const auto path = folder.write(name, bytes);
            const auto file = meshio::readMesh(path, {unit_mm, {}});
            QVERIFY2(file.isOk(), file.status().message().c_str());
            QCOMPARE(file.value().unit_mm, taken_mm);
            QVERIFY(file.value().structures[0].mesh.bounds().max() == Vec3(2.5, 1.5, 0) * taken_mm);
            QCOMPARE(test::mentions(file.value().notes, "SCALE="), !note.isEmpty());
            QVERIFY(test::mentions(file.value().notes, note.toStdString()) || note.isEmpty());
            // A scene file states its unit, and keeps the unit from the mesh header.
            const auto scene = meshio::loadScene(path, {unit_mm, {}});
            QCOMPARE(scene.value().scene.structures[0].unit_mm, taken_mm);
            meshio::SceneFile one = scene.value().scene;
            one.structures[0].unit_mm = 1.0;
            const auto again = meshio::loadScene(one, path);
            QVERIFY(again.value().structures[0].surface->report.bounds.max() == Vec3(2.5, 1.5, 0));
        }
    }

    void coloursThatAreNotReadAreSaid_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<std::string>("bytes");
        QTest::addColumn<QString>("note");
        const std::string faces = "f 1 3 2\nf 1 2 4\n", mesh = "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\n";
        QTest::newRow("obj materials") << "a.obj" << mesh + "usemtl red\nf 1 3 2\nusemtl blue\nf 1 2 4\nusemtl red\n"
                                       << "colours not read: those of its 2 materials";
        QTest::newRow("obj vertices") << "a.obj"
                                      << std::string("v 0 0 0 1 0 0\nv 9 0 0 1 0 0\nv 0 9 0 1 0 0\nf 1 2 3\n")
                                      << "colours not read: those of its vertices";
        QTest::newRow("obj weights") << "a.obj" << std::string("v 0 0 0 1\nv 9 0 0 1\nv 0 9 0 1\nf 1 2 3\n") << "";
        QTest::newRow("obj plain") << "a.obj" << mesh + faces << "";
        QTest::newRow("ply vertices")
            << "a.ply"
            << std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
                           "float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face "
                           "1\nproperty list uchar int vertex_index\nend_header\n0 0 0 1 2 3\n9 0 0 1 2 3\n0 9 0 1 2 "
                           "3\n3 0 1 2\n")
            << "colours not read: those of its elements \"vertex\"";
        QTest::newRow("ply plain") << "a.ply" << test::asciiPly() << "";
        std::string vtp = test::asciiVtp();
        vtp.insert(vtp.find("<Points>"), "<CellData><DataArray type=\"UInt8\" Name=\"Colors\" NumberOfComponents=\"3\" "
                                         "format=\"ascii\">255 0 0</DataArray></CellData>");
        QTest::newRow("vtp cells") << "a.vtp" << vtp << "colours not read: the array \"Colors\" of its polygons";
        QTest::newRow("vtp plain") << "a.vtp" << test::asciiVtp() << "";
        QTest::newRow("vtk") << "a.vtk" << test::asciiVtk() + "POINT_DATA 3\nCOLOR_SCALARS c 3\n0 0 0 0 0 0 0 0 0\n"
                             << "colours not read";
        QTest::newRow("vtk plain") << "a.vtk" << test::asciiVtk() << "";
    }
    void coloursThatAreNotReadAreSaid()
    {
        QFETCH(QString, name);
        QFETCH(std::string, bytes);
        QFETCH(QString, note);
        const test::Folder folder;
        const auto file = meshio::readMesh(folder.write(name.toStdString(), bytes));
        QVERIFY2(file.isOk(), file.status().message().c_str());
        QCOMPARE(test::mentions(file.value().notes, "colours not read"), !note.isEmpty());
        QVERIFY(note.isEmpty() || test::mentions(file.value().notes, note.toStdString()));
    }

    void otherPrograms_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<std::string>("json");
        QTest::addColumn<QString>("said");
        QTest::newRow("marks") << "F.mrk.json" << std::string(R"({"@schema": "x", "markups": []})")
                               << "F.mrk.json: is a list of 3D Slicer marks, not a Palpate scene";
        QTest::newRow("any") << "a.json" << std::string(R"({"name": "x"})")
                             << "a.json: is not a Palpate scene: found neither `version` nor `structures`";
        QTest::newRow("glTF")
            << "a.glb" << std::string("glTF\x02")
            << "a.glb: is a glTF file, which Palpate does not read; expected a mesh saved as STL, PLY, "
               "OBJ or VTK";
        QTest::newRow("no version") << "a.json" << std::string(R"({"structures": []})")
                                    << "a.json: version: found nothing, expected 1";
    }
    void otherPrograms()
    {
        QFETCH(QString, name);
        QFETCH(std::string, json);
        QFETCH(QString, said);
        const test::Folder folder;
        const auto scene = meshio::loadScene(folder.write(name.toStdString(), json));
        QVERIFY(!scene.isOk());
        QVERIFY2(QString::fromStdString(scene.status().message()).startsWith(said), scene.status().message().c_str());
    }

    void aFolderThatCannotBeWrittenSaysWhatToDo()
    {
        const auto status = meshio::writeScene("/proc/no/a.palpate.json", {});
        QVERIFY(!status.isOk());
        QVERIFY2(status.message().ends_with("; choose another folder"), status.message().c_str());
    }
};

PALPATE_TEST(Frames)
#include "tst_Frames.moc"
