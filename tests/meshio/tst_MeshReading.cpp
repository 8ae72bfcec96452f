// SPDX-License-Identifier: BSD-3-Clause
#include "Samples.h"
#include "TestRunner.h"

#include <QProcess>

#include <clocale>
#include <cmath>
#include <locale>

using namespace palpate;
using core::Vec3;
using meshio::FileFrame;

namespace {

/// Writes 1.5 as "1,5", like a program in a German locale.
struct CommaPoint : std::numpunct<char>
{
    char do_decimal_point() const override { return ','; }
};

/// Sets a German numeric locale for this process, in C and in C++, if the machine can generate one.
class GermanLocale
{
  public:
    GermanLocale()
    {
        static const QTemporaryDir folder; // generating the locale takes seconds
        static const int made =
            QProcess::execute("localedef", {"-c", "-i", "de_DE", "-f", "UTF-8", folder.path() + "/de_DE.UTF-8"});
        Q_UNUSED(made);
        qputenv("LOCPATH", folder.path().toUtf8());
        isC = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr && std::localeconv()->decimal_point[0] == ',';
        m_before = std::locale::global(std::locale(std::locale::classic(), new CommaPoint));
        if (isC) {
            std::setlocale(LC_ALL, "de_DE.UTF-8"); // std::locale::global may have changed it
        }
    }
    ~GermanLocale()
    {
        std::locale::global(m_before);
        std::setlocale(LC_ALL, "C");
        qunsetenv("LOCPATH");
    }
    bool isC = false;

  private:
    std::locale m_before;
};

std::string extensionOf(const std::string& format)
{
    return format.starts_with("vtk") ? ".vtk"
           : format == "obj"         ? ".obj"
           : format == "ply"         ? ".ply"
           : format == "vtp"         ? ".vtp"
                                     : ".stl";
}

} // namespace

class MeshReading : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void readsEachFormat_data();
    void readsEachFormat();
    void kindComesFromContent_data() { readsEachFormat_data(); }
    void kindComesFromContent();
    void decimalCommaOfTheUserChangesNothing_data() { readsEachFormat_data(); }
    void decimalCommaOfTheUserChangesNothing();
    void unitScalesToMillimetres_data() { readsEachFormat_data(); }
    void unitScalesToMillimetres();
    void rasIsTurnedToLps_data();
    void rasIsTurnedToLps();
    void unknownFrameIsNoted();
    void concavePolygonKeepsItsArea_data();
    void concavePolygonKeepsItsArea();
    void stripWindsOneWay();
    void objGroupsBecomeStructures();
    void objObjectsGoBeforeGroups();
    void objNegativeIndicesAndContinuedLines();
    void stlSolidsBecomeStructures();
    void stlTextStaysTextToVtk_data();
    void stlTextStaysTextToVtk();
    void vtpStructuresKeepTheirTriangles();
    void plyElementsAndTypesOfAnyKind();
    void legacyVtkStripsDoublesAndTag();
    void plyKeepsDoubles_data();
    void plyKeepsDoubles();
    void progressRisesAndCancels_data() { readsEachFormat_data(); }
    void progressRisesAndCancels();
    void unitMustBePositive();
    void partialKeepsWhatIsWhole_data();
    void partialKeepsWhatIsWhole();
    void partialTakesNoOtherDamage_data();
    void partialTakesNoOtherDamage();
};

void MeshReading::readsEachFormat_data()
{
    QTest::addColumn<std::string>("extension");
    QTest::addColumn<std::string>("bytes");
    QTest::addColumn<std::string>("format");
    const auto row = [](const char* name, const std::string& bytes, const std::string& format) {
        QTest::newRow(name) << extensionOf(name) << bytes << format;
    };
    row("stl", test::binaryStl(1, {{0, 0, 0, 2.5F, 0, 0, 0, 1.5F, 0}}), "STL binary");
    row("ascii stl", test::asciiStl(), "STL ASCII");
    row("obj", test::kObj, "OBJ");
    row("ply", test::asciiPly(), "PLY");
    row("vtp", test::asciiVtp(), "VTP");
    row("vtk", test::asciiVtk(), "VTK");
    row("vtk, binary", test::binaryVtk(), "VTK");
}

void MeshReading::readsEachFormat()
{
    QFETCH(std::string, extension);
    QFETCH(std::string, bytes);
    QFETCH(std::string, format);
    const test::Folder folder;
    const auto file = meshio::readMesh(folder.write("größe 1" + extension, bytes));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QCOMPARE(file.value().format, format);
    QCOMPARE(test::triangles(file.value()), std::size_t{1});
    const geometry::TriangleMesh& mesh = file.value().structures[0].mesh;
    QCOMPARE(mesh.vertices.size(), std::size_t{3});
    QVERIFY(mesh.vertices[mesh.triangles[0][1]] == Vec3(2.5, 0, 0));
    QVERIFY(mesh.vertices[mesh.triangles[0][2]] == Vec3(0, 1.5, 0));
}

void MeshReading::kindComesFromContent()
{
    QFETCH(std::string, bytes);
    QFETCH(std::string, format);
    const test::Folder folder;
    for (const char* extension : {".stl", ".obj", ".ply", ".vtp", ".vtk", ".dat", ""}) {
        const auto file = meshio::readMesh(folder.write(std::string("mesh") + extension, bytes));
        QVERIFY2(file.isOk(), file.status().message().c_str());
        QCOMPARE(file.value().format, format);
    }
}

void MeshReading::decimalCommaOfTheUserChangesNothing()
{
    const GermanLocale german;
    readsEachFormat();
    if (!QTest::currentTestFailed() && !german.isC) {
        QSKIP("no de_DE locale can be made here: only the C++ locale had a decimal comma");
    }
}

void MeshReading::unitScalesToMillimetres()
{
    QFETCH(std::string, extension);
    QFETCH(std::string, bytes);
    const test::Folder folder;
    const auto path = folder.write("mesh" + extension, bytes);
    const auto file = meshio::readMesh(path, {1000.0, {}});
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QVERIFY(file.value().structures[0].mesh.bounds().max() == Vec3(2500, 1500, 0));
    QCOMPARE(file.value().unit_mm, 1000.0);
    // 2.5 units of 1e7 mm are beyond the limit.
    QCOMPARE(meshio::readMesh(path, {1e7, {}}).status().code(), core::StatusCode::NonFinite);
}

void MeshReading::rasIsTurnedToLps_data()
{
    QTest::addColumn<std::string>("extension");
    QTest::addColumn<std::string>("bytes"); // with LPS
    const auto row = [](const char* name, const std::string& bytes) {
        QTest::newRow(name) << extensionOf(name) << bytes;
    };
    row("stl", test::binaryStl(1, {{0, 0, 0, 2.5F, 0, 0, 0, 1.5F, 0}}, "3D Slicer output. SPACE=LPS"));
    row("ascii stl", test::asciiStl("3D Slicer output. SPACE=LPS"));
    row("obj", "# 3D Slicer output. SPACE=LPS\n" + test::kObj);
    row("ply", test::asciiPly());
    row("vtp",
        test::asciiVtp("0 0 0 2.5 0 0 0 1.5 0", "0 1 2", "NumberOfPoints=\"3\" NumberOfPolys=\"1\"", "3", "Polys",
                       "<FieldData><Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" "
                       "format=\"ascii\">76 80 83 0</Array></FieldData>"));
}

void MeshReading::rasIsTurnedToLps()
{
    QFETCH(std::string, extension);
    QFETCH(std::string, bytes);
    const test::Folder folder;
    const auto lps = meshio::readMesh(folder.write("lps" + extension, bytes));
    QVERIFY2(lps.isOk(), lps.status().message().c_str());
    QCOMPARE(lps.value().frame, FileFrame::Lps);
    QVERIFY(lps.value().structures[0].mesh.bounds().max() == Vec3(2.5, 1.5, 0));
    for (const auto& [from, to] : {std::pair{"LPS", "RAS"}, std::pair{"76 80 83", "82 65 83"}}) {
        if (const std::size_t at = bytes.find(from); at != std::string::npos) {
            bytes.replace(at, std::strlen(from), to);
        }
    }
    const auto ras = meshio::readMesh(folder.write("ras" + extension, bytes));
    QVERIFY2(ras.isOk(), ras.status().message().c_str());
    QCOMPARE(ras.value().frame, FileFrame::Ras);
    QVERIFY(ras.value().structures[0].mesh.bounds().min() == Vec3(-2.5, -1.5, 0));
}

void MeshReading::unknownFrameIsNoted()
{
    const test::Folder folder;
    const auto file = meshio::readMesh(folder.write("a.obj", "# SPACE=LAS\n" + test::kObj));
    QVERIFY(file.isOk());
    QCOMPARE(file.value().frame, FileFrame::Untagged);
    QCOMPARE(file.value().notes.size(), std::size_t{1});
    QVERIFY(file.value().notes[0].english().find("LAS") != std::string::npos);
}

void MeshReading::concavePolygonKeepsItsArea_data()
{
    QTest::addColumn<std::string>("obj");
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("area");
    const auto row = [](const char* name, const std::string& obj, int count, double area) {
        QTest::newRow(name) << obj << count << area;
    };
    row("square", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n", 2, 4.0);
    row("arrow head", "v 0 0 0\nv 4 2 0\nv 0 4 0\nv 1 2 0\nf 1 2 3 4\n", 2, 6.0);
    row("arrow head, clockwise", "v 0 0 0\nv 4 2 0\nv 0 4 0\nv 1 2 0\nf 4 3 2 1\n", 2, 6.0);
    row("arrow head, from its notch", "v 0 0 0\nv 4 2 0\nv 0 4 0\nv 1 2 0\nf 4 1 2 3\n", 2, 6.0);
    row("L in a tilted plane, far off, tiny",
        "v 1000 0 0\nv 1000.002 0 0.002\nv 1000.002 0.001 0.002\nv 1000.001 0.001 0.001\nv 1000.001 0.002 0.001\n"
        "v 1000 0.002 0\nf 1 2 3 4 5 6\n",
        4, 3e-6 * std::sqrt(2.0));
    row("triangle with a corner inside a side", "v 0 0 0\nv 1 0 0\nv 4 0 0\nv 0 3 0\nf 1 2 3 4\n", 2, 6.0);
    row("comb",
        "v 0 0 0\nv 5 0 0\nv 5 3 0\nv 4 3 0\nv 4 1 0\nv 3 1 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\n"
        "v 1 3 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8 9 10 11 12\n",
        10, 11.0);
}

void MeshReading::concavePolygonKeepsItsArea()
{
    QFETCH(std::string, obj);
    QFETCH(int, count);
    QFETCH(double, area);
    const test::Folder folder;
    const auto file = meshio::readMesh(folder.write("a.obj", obj));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    const geometry::TriangleMesh& mesh = file.value().structures[0].mesh;
    QCOMPARE(static_cast<int>(mesh.triangles.size()), count);
    // Triangles outside the outline or overlapping would add to the area; VTK stores floats (6e-8), and the tiny
    // polygon is 1e3 from the origin with sides of 1e-3.
    const double error = obj.starts_with("v 1000") ? 0.2 * area : 1e-6 * area;
    QVERIFY2(std::abs(test::area(mesh) - area) <= error, qPrintable(QString::number(test::area(mesh))));
    // Consistent winding: the vector areas also add up to the total.
    Vec3 sum = Vec3::Zero();
    for (const geometry::Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.vertices[t[1]] - mesh.vertices[t[0]];
        const Vec3 normal = a.cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
        QVERIFY(normal.norm() > 0.0);
        sum += 0.5 * normal;
    }
    QVERIFY(std::abs(sum.norm() - area) <= error);
    QVERIFY(file.value().notes.empty());
}

void MeshReading::stripWindsOneWay()
{
    const test::Folder folder;
    const auto file = meshio::readMesh(
        folder.write("a.vtp", test::asciiVtp("0 0 0 0 1 0 1 0 0 1 1 0 2 0 0", "0 1 2 3 4",
                                             "NumberOfPoints=\"5\" NumberOfStrips=\"1\"", "5", "Strips")));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    const geometry::TriangleMesh& mesh = file.value().structures[0].mesh;
    QCOMPARE(mesh.triangles.size(), std::size_t{3});
    for (const geometry::Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.vertices[t[1]] - mesh.vertices[t[0]];
        QVERIFY(a.cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).z() == -1.0);
    }
}

void MeshReading::objGroupsBecomeStructures()
{
    const test::Folder folder;
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\n";
    const auto file = meshio::readMesh(folder.write(
        "a.obj", "o body\n" + points + "f 1 2 3\ng left lobe\nf 1 2 4\ng right\nf 3 4 5\ng left lobe\nf 2 3 4\n"));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    const auto& s = file.value().structures;
    QCOMPARE(s.size(), std::size_t{3});
    QCOMPARE(s[0].name, std::string("a")); // faces before the first group
    QCOMPARE(s[1].name, std::string("left lobe"));
    QCOMPARE(s[1].mesh.triangles.size(), std::size_t{2});
    QCOMPARE(s[1].mesh.vertices.size(), std::size_t{4});
    QCOMPARE(s[2].name, std::string("right"));
    QVERIFY(s[2].mesh.vertices[s[2].mesh.triangles[0][2]] == Vec3(1, 1, 1));
}

void MeshReading::objObjectsGoBeforeGroups()
{
    const test::Folder folder;
    const auto file =
        meshio::readMesh(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                               "o femur\ng red\nf 1 2 3\ng white\nf 1 2 4\no tibia\nf 2 3 4\n"));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QCOMPARE(file.value().structures.size(), std::size_t{2});
    QCOMPARE(file.value().structures[0].name, std::string("femur"));
    QCOMPARE(file.value().structures[0].mesh.triangles.size(), std::size_t{2});
    QCOMPARE(file.value().structures[1].name, std::string("tibia"));
}

void MeshReading::objNegativeIndicesAndContinuedLines()
{
    const test::Folder folder;
    const auto file =
        meshio::readMesh(folder.write("a.obj", "\xef\xbb\xbf# a comment\nvn 0 0 1\nv 0 0 0 0.5 0.5 0.5\nv +2.5 0 0 "
                                               "1.0\nv 0 \\\n 1.5 0\n\n\tf -3//1 -2//1 \\\n-1//1\nl 1 2\n"));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    const geometry::TriangleMesh& mesh = file.value().structures[0].mesh;
    QCOMPARE(mesh.triangles.size(), std::size_t{1});
    QVERIFY(mesh.bounds().max() == Vec3(2.5, 1.5, 0));
    QCOMPARE(file.value().notes.size(), std::size_t{2}); // the line element, a vertex's colour
}

void MeshReading::stlSolidsBecomeStructures()
{
    const test::Folder folder;
    const auto file =
        meshio::readMesh(folder.write("a.stl", test::asciiStl("liver") + test::asciiStl("vein", "0 9 0")));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QCOMPARE(file.value().structures.size(), std::size_t{2});
    QCOMPARE(file.value().structures[1].name, std::string("vein"));
    QVERIFY(file.value().structures[1].mesh.bounds().max() == Vec3(2.5, 9, 0));
}

// Found by libFuzzer: VTK took these for binary files and requested 6 to 10 GB.
void MeshReading::stlTextStaysTextToVtk_data()
{
    QTest::addColumn<QByteArray>("text");
    const QByteArray text = QByteArray::fromStdString(test::asciiStl());
    const QByteArray tabs(33, '\v'); // vertical tabs
    QTest::newRow("in a normal") << QByteArray(text).replace(" 0 0 1", QByteArray(33, '\xf2') + "\x01\x7f 0 0 1");
    QTest::newRow("before a name") << tabs + text;
    QTest::newRow("in a blank line") << tabs + '\n' + text;
}

void MeshReading::stlTextStaysTextToVtk()
{
    QFETCH(const QByteArray, text);
    const test::Folder folder;
    const auto file = meshio::readMesh(folder.write("a.stl", text.toStdString()));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QCOMPARE(file.value().format, std::string("STL ASCII"));
    QCOMPARE(test::triangles(file.value()), std::size_t{1});
}

void MeshReading::vtpStructuresKeepTheirTriangles()
{
    // Two lines come first: cell data cover verts, lines, polygons and strips in this order.
    const std::string vtp =
        "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData><FieldData>"
        "<Array type=\"String\" Name=\"StructureNames\" NumberOfTuples=\"2\" format=\"ascii\">97 0 98 0</Array>"
        "</FieldData><Piece NumberOfPoints=\"5\" NumberOfLines=\"2\" NumberOfPolys=\"3\">"
        "<CellData><DataArray type=\"Int16\" Name=\"StructureId\" format=\"ascii\">7 7 1 0 5</DataArray></CellData>"
        "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1 1 1 1"
        "</DataArray></Points><Lines><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 1 "
        "2</DataArray>"
        "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">2 4</DataArray></Lines>"
        "<Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 0 1 4 3 1 2 3</DataArray>"
        "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3 7 10</DataArray></Polys>"
        "</Piece></PolyData></VTKFile>";
    const test::Folder folder;
    const auto file = meshio::readMesh(folder.write("a.vtp", vtp));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    const auto& s = file.value().structures;
    QCOMPARE(s.size(), std::size_t{3});
    QCOMPARE(s[0].name, std::string("b"));
    QCOMPARE(s[0].mesh.triangles.size(), std::size_t{1});
    QCOMPARE(s[1].name, std::string("a"));
    QCOMPARE(s[1].mesh.triangles.size(), std::size_t{2}); // the quadrilateral
    QCOMPARE(s[2].name, std::string("structure 5"));
}

void MeshReading::legacyVtkStripsDoublesAndTag()
{
    const test::Folder folder;
    const auto file = meshio::readMesh(folder.write(
        "a.vtk", test::asciiVtk("POINTS 4 double\n0 0 0 1234567.0123456 0 0 0 1.5 0 1 1.5 0\n",
                                "VERTICES 1 2\n1 0\nTRIANGLE_STRIPS 1 5\n4 0 1 2 3\nCELL_DATA 2\nSCALARS a int\n",
                                "3D Slicer output. SPACE=RAS")));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QCOMPARE(file.value().frame, meshio::FileFrame::Ras);
    QCOMPARE(test::triangles(file.value()), std::size_t{2});
    QVERIFY(file.value().structures[0].mesh.bounds().min().x() == -1234567.0123456);
}

void MeshReading::plyKeepsDoubles_data()
{
    QTest::addColumn<std::string>("type");
    QTest::addColumn<bool>("isExact");
    QTest::newRow("double") << std::string("double") << true;
    QTest::newRow("float64") << std::string("float64") << true;
    QTest::newRow("float") << std::string("float") << false;
}

void MeshReading::plyKeepsDoubles()
{
    QFETCH(std::string, type);
    QFETCH(bool, isExact);
    const test::Folder folder;
    const double x = 1234567.0123456; // a float represents 1234567
    std::string text = test::asciiPly("0 0 0\n1234567.0123456 0 0\n0 1.5 0\n");
    for (std::size_t at = text.find("float"); at != std::string::npos; at = text.find("float", at + type.size())) {
        text.replace(at, 5, type);
    }
    const auto file = meshio::readMesh(folder.write("a.ply", text));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    const double found = file.value().structures[0].mesh.bounds().max().x();
    QVERIFY2(found == (isExact ? x : static_cast<double>(static_cast<float>(x))),
             qPrintable(QString::number(found, 'g', 17)));
}

void MeshReading::plyElementsAndTypesOfAnyKind()
{
    const test::Folder folder;
    // An element before the vertices, one after the faces, a second list, doubles, and a big-endian body.
    std::string header =
        "ply\r\nformat binary_big_endian 1.0\r\nelement camera 1\r\nproperty short id\r\n"
        "element vertex 3\r\nproperty uchar red\r\nproperty double x\r\nproperty double y\r\n"
        "property double z\r\nelement face 1\r\nproperty list uchar float uv\r\n"
        "property list uint ushort vertex_indices\r\nelement note 1\r\nproperty char c\r\nend_header\r\n";
    const auto big = [](std::string& out, auto value) {
        std::string raw;
        test::appendRaw(raw, value);
        out.append(raw.rbegin(), raw.rend());
    };
    std::string body;
    big(body, std::int16_t{7});
    for (const std::array<double, 3>& p : {std::array{0.0, 0.0, 0.0}, {2.5, 0.0, 0.0}, {0.0, 1.5, 0.0}}) {
        big(body, std::uint8_t{255});
        for (const double x : p) {
            big(body, x);
        }
    }
    big(body, std::uint8_t{2});
    big(body, 0.5F);
    big(body, 0.25F);
    big(body, std::uint32_t{3});
    for (const int corner : {0, 1, 2}) {
        big(body, static_cast<std::uint16_t>(corner));
    }
    big(body, std::int8_t{1});
    const auto file = meshio::readMesh(folder.write("a.ply", header + body));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QVERIFY(file.value().structures[0].mesh.bounds().max() == Vec3(2.5, 1.5, 0));
}

void MeshReading::progressRisesAndCancels()
{
    QFETCH(std::string, extension);
    QFETCH(std::string, bytes);
    const test::Folder folder;
    const auto path = folder.write("mesh" + extension, bytes);
    std::vector<double> shares;
    QVERIFY(meshio::readMesh(path, {1.0,
                                    [&](double share) {
                                        shares.push_back(share);
                                        return true;
                                    }})
                .isOk());
    QVERIFY(!shares.empty());
    QVERIFY(std::is_sorted(shares.begin(), shares.end()));
    QVERIFY(shares.front() >= 0.0);
    QCOMPARE(shares.back(), 1.0);
    for (std::size_t stop = 0; stop < shares.size(); ++stop) { // cancel at each call
        std::size_t calls = 0;
        const auto file = meshio::readMesh(path, {1.0, [&](double) { return calls++ < stop; }});
        QCOMPARE(file.status().code(), core::StatusCode::Cancelled);
    }
}

void MeshReading::unitMustBePositive()
{
    const test::Folder folder;
    const auto path = folder.write("a.obj", test::kObj);
    for (const double unit : {0.0, -1.0, std::nan("")}) {
        QCOMPARE(meshio::readMesh(path, {unit, {}}).status().code(), core::StatusCode::BadCommandLine);
    }
}

void MeshReading::partialKeepsWhatIsWhole_data()
{
    QTest::addColumn<std::string>("name");
    QTest::addColumn<std::string>("bytes");
    QTest::addColumn<std::size_t>("whole"); // triangles; 0: rejected nevertheless
    QTest::addColumn<std::string>("loss");
    const auto row = [](const char* title, const char* name, const std::string& bytes, std::size_t whole,
                        const std::string& loss) {
        QTest::newRow(title) << std::string(name) << bytes << whole << loss;
    };
    const std::string stl = test::binaryStl(3, {3, {0, 0, 0, 2.5F, 0, 0, 0, 1.5F, 0}});
    row("stl in a facet", "a.stl", stl.substr(0, stl.size() - 20), 2,
        "a.stl: byte 214: the file ends there: 1 of 3 triangles lost");
    row("stl between facets", "a.stl", stl.substr(0, 84 + 50), 1,
        "a.stl: byte 134: the file ends there: 2 of 3 triangles lost");
    row("stl between facets, 7 instead of 3", "a.stl", std::string(stl).replace(80, 1, 1, '\x07'), 3,
        "a.stl: byte 234: the file ends there: 4 of 7 triangles lost");
    row("stl before a facet is whole", "a.stl", stl.substr(0, 84 + 49), 0, "");
    const std::string two = test::asciiStl() + test::asciiStl("vein", "0 9 0");
    row("ascii stl in a vertex", "a.stl", two.substr(0, two.rfind("9 0")), 1,
        "a.stl: line 8: everything after the first triangle is lost");
    row("ascii stl in the first facet", "a.stl", two.substr(0, 60), 0, "");
    row("obj in a face", "a.obj", test::kObj + "f 3 2", 1,
        "a.obj: byte 36: the file ends in a line; that line is lost");
    row("obj in a face, behind a blank", "a.obj", test::kObj + "f 3 2 ", 1,
        "a.obj: byte 36: the file ends in a line; that line is lost");
    row("obj in a face, behind a tab", "a.obj", test::kObj + "f 3/1/1\t", 1,
        "a.obj: byte 36: the file ends in a line; that line is lost");
    row("obj behind f", "a.obj", test::kObj + "f ", 1, "a.obj: byte 36: the file ends in a line; that line is lost");
    std::string back = test::kObj;
    std::replace(back.begin(), back.end(), '\n', '\r');
    row("obj in a face, CR", "a.obj", back + "f 3 2 ", 1, "a.obj: byte 36: the file ends in a line; that line is lost");
    row("obj in the first face", "a.obj", test::kObj.substr(0, test::kObj.size() - 3), 0, "");
    const std::string ply = test::asciiPly("0 0 0\n2.5 0 0\n0 1.5 0\n", "3 0 1 2\n3 0 ", 3, 4);
    row("ply in a face", "a.ply", ply, 1,
        "a.ply: byte " + std::to_string(ply.size()) + ": the file ends there: 3 of 4 faces lost");
    const std::string surplus = test::asciiPly("0 0 0\n2.5 0 0\n0 1.5 0\n", "3 0 1 2 0\n3 0 1 2 0\n3 0 ", 3, 4);
    row("ply with surplus numbers in a face", "a.ply", surplus, 2,
        "a.ply: byte " + std::to_string(surplus.size()) + ": the file ends there: 2 of 4 faces lost");
    row("ply in a vertex", "a.ply", test::asciiPly("0 0 0\n2.5 0 0\n0 ", "", 3, 1), 0, "");
    const std::string vtp = test::asciiVtp();
    row("vtp", "a.vtp", vtp.substr(0, vtp.size() - 30), 0, "");
}

void MeshReading::partialKeepsWhatIsWhole()
{
    QFETCH(std::string, name);
    QFETCH(std::string, bytes);
    QFETCH(std::size_t, whole);
    QFETCH(std::string, loss);
    const test::Folder folder;
    const auto path = folder.write(name, bytes);
    const auto strict = meshio::readMesh(path);
    QVERIFY(!strict.isOk());
    meshio::ReadOptions options;
    options.isPartial = true;
    const auto file = meshio::readMesh(path, options);
    QCOMPARE(file.isOk(), whole > 0);
    if (whole == 0) {
        QCOMPARE(file.status().message(), strict.status().message());
        return;
    }
    QCOMPARE(test::triangles(file.value()), whole);
    QCOMPARE(file.value().loss.english(), loss);
    const geometry::TriangleMesh& mesh = file.value().structures[0].mesh;
    QVERIFY(mesh.vertices[mesh.triangles[0][2]] == Vec3(0, 1.5, 0));
}

void MeshReading::partialTakesNoOtherDamage_data()
{
    QTest::addColumn<std::string>("name");
    QTest::addColumn<std::string>("bytes");
    const auto row = [](const char* title, const char* name, const std::string& bytes) {
        QTest::newRow(title) << std::string(name) << bytes;
    };
    row("stl longer than it says", "a.stl", test::binaryStl(1, {2, {0, 0, 0, 2.5F, 0, 0, 0, 1.5F, 0}}));
    row("ascii stl with a word", "a.stl", test::asciiStl("a", "0 x 0") + test::asciiStl());
    row("obj with a wrong index", "a.obj", test::kObj + "f 1 2 9\nf 1 2 3\n");
    row("ply with a wrong index", "a.ply", test::asciiPly("0 0 0\n2.5 0 0\n0 1.5 0\n", "3 0 1 2\n3 0 1 9\n", 3, 2));
}

void MeshReading::partialTakesNoOtherDamage()
{
    QFETCH(std::string, name);
    QFETCH(std::string, bytes);
    const test::Folder folder;
    meshio::ReadOptions options;
    options.isPartial = true;
    QVERIFY(!meshio::readMesh(folder.write(name, bytes), options).isOk());
}

PALPATE_TEST(MeshReading)
#include "tst_MeshReading.moc"
