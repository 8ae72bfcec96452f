// SPDX-License-Identifier: BSD-3-Clause
#include "Samples.h"
#include "TestRunner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <fcntl.h>
#include <unistd.h>

using namespace palpate;
using core::StatusCode;

namespace {

/// Captures the process's error stream while the object lives.
class ErrorStream
{
  public:
    explicit ErrorStream(const std::filesystem::path& file)
        : m_file(file)
        , m_before(::dup(2))
    {
        const int to = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        ::dup2(to, 2);
        ::close(to);
    }
    std::string stop()
    {
        ::dup2(m_before, 2);
        ::close(m_before);
        return test::fileBytes(m_file);
    }

  private:
    std::filesystem::path m_file;
    int m_before;
};

/// Checks that the file is rejected with one line that names the file and the expected content.
void verifyRefused(const core::Result<meshio::MeshFile>& file, const std::string& name)
{
    QVERIFY(!file.isOk());
    const std::string& message = file.status().message();
    QVERIFY2(message.starts_with(name + ": "), message.c_str());
    QVERIFY2(message.find("; expected ") != std::string::npos, message.c_str());
    QVERIFY2(message.find('\n') == std::string::npos, message.c_str());
}

std::string withPlyHeader(const std::string& header, const std::string& body)
{
    return "ply\nformat binary_little_endian 1.0\n" + header + "end_header\n" + body;
}

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";

/// Returns a valid binary PLY of one triangle.
std::string binaryPly()
{
    std::string body;
    test::appendRaw(body, std::array<float, 9>{0, 0, 0, 2.5F, 0, 0, 0, 1.5F, 0});
    test::appendRaw(body, std::uint8_t{3});
    test::appendRaw(body, std::array<std::int32_t, 3>{0, 1, 2});
    return withPlyHeader("element vertex 3\n" + kXyz + "element face 1\nproperty list uchar int vertex_indices\n",
                         body);
}

} // namespace

class HostileFiles : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void sharedFilesAreDecided();
    void ownFilesAreRefused_data();
    void ownFilesAreRefused();
    void namesWhatElseItIs_data();
    void namesWhatElseItIs();
    void missingFileFolderAndPipeAreErrors();
    void cutAnywhereNeverCrashes_data();
    void cutAnywhereNeverCrashes();
    void flippedBytesNeverCrash_data() { cutAnywhereNeverCrashes_data(); }
    void flippedBytesNeverCrash();
};

void HostileFiles::sharedFilesAreDecided()
{
    PALPATE_SHARED_OR_SKIP(folder, "hostile");
    static const std::set<std::string> valid{"s03_count_ffffffff.stl", // a count that was not filled in
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
    const test::Folder own;
    ErrorStream errors(own.path("errors"));
    std::vector<std::pair<std::string, core::Result<meshio::MeshFile>>> results;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        results.emplace_back(entry.path().filename().string(), meshio::readMesh(entry.path()));
    }
    QCOMPARE(errors.stop(), std::string()); // neither VTK nor Qt printed a message
    QVERIFY(results.size() >= 50);
    for (const auto& [name, file] : results) {
        if (valid.contains(name)) {
            QVERIFY2(file.isOk(), file.status().message().c_str());
        } else {
            QVERIFY2(!file.isOk(), name.c_str());
            verifyRefused(file, name);
        }
    }
}

void HostileFiles::ownFilesAreRefused_data()
{
    QTest::addColumn<std::string>("name");
    QTest::addColumn<std::string>("bytes");
    QTest::addColumn<std::string>("place"); // text after the file's name
    const auto row = [](const char* title, const char* name, const std::string& bytes, const char* place) {
        QTest::newRow(title) << std::string(name) << bytes << std::string(place);
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();

    row("stl cut in a facet", "a.stl", test::binaryStl(2, {{0, 0, 0, 1, 0, 0, 0, 1, 0}}).append(20, '\0'),
        "byte 154: cut off: the binary STL declares 2 triangles, but the 154 bytes hold 1");
    row("stl of more facets than declared", "a.stl", test::binaryStl(1, {3, {0, 0, 0, 1, 0, 0, 0, 1, 0}}),
        "byte 80: number of triangles of the binary STL: declared 1, but the 234 bytes hold 3");
    row("stl of a count that was not filled in, cut off", "a.stl",
        test::binaryStl(0, {{0, 0, 0, 1, 0, 0, 0, 1, 0}}).append(20, '1'), "byte 80: 0 triangles");
    row("ascii stl that ends in a facet", "a.stl", test::asciiStl() + "solid b\nfacet normal 0 0 1\nouter loop\n",
        "line 12: the file ends after one complete triangle; expected the rest of a facet, then the keyword "
        "\"endsolid\"; --partial opens");
    row("ascii stl, four corners", "a.stl",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
        "vertex 0 1 0\nvertex 1 1 0\nendloop\nendfacet\nendsolid a\n",
        "line 7: found \"vertex 1 1 0\" after three corners");
    row("stl of no triangle", "a.stl", test::binaryStl(0, {}), "byte 80: 0 triangles");
    row("stl NaN", "a.stl", test::binaryStl(2, {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, 1, nan, 0, 0, 1, 0}}),
        "byte 134: coordinates are not numbers in 1 of 2 triangles (first: triangle 1)");
    row("stl far", "a.stl", test::binaryStl(1, {{0, 0, 0, 2e7F, 0, 0, 0, 1, 0}}),
        "byte 84: coordinates are farther than 10 km from the origin in 1 of 1 triangles");
    row("stl without area", "a.stl", test::binaryStl(1, {{0, 0, 0, 1, 1, 1, 2, 2, 2}}), "all triangles have zero area");
    row("ascii stl, two loops", "a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\n",
        "line 5: ");
    row("ascii stl, empty solid", "a.stl", "solid a\nendsolid a\n", "line 2: 0 triangles");

    row("obj index beyond", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n",
        "line 4: vertex index 4; expected at most 3");
    row("obj index huge", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999\n", "line 4: ");
    row("obj index zero", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "line 4: vertex index 0");
    row("obj index before the first", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n", "line 4: vertex index -4");
    row("obj index words", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n", "line 4: \"x\" is not a vertex index");
    row("obj two corners", "a.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", "line 3: 0 faces; expected at least one face");
    row("obj NaN", "a.obj", "v 0 nan 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1: ");
    row("obj overflow", "a.obj", "v 0 1e999 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1: ");
    row("obj decimal comma", "a.obj", "v 0,5 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1: \"0,5\" is not a number");
    row("obj cut in a vertex", "a.obj", "v 0 0 0\nv 1 0", "line 2: the vertex has fewer than three coordinates");
    row("obj no face", "a.obj", "v 0 0 0\nv 1 0 0\n", "line 2: 0 faces");
    row("obj zero byte", "a.obj", test::kObj + std::string("g a\0b\n", 6), "line 5: found a zero byte");
    std::string many = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
    for (int i = 0; i < 2000; ++i) {
        many += " 1";
    }
    row("obj 2000 corners", "a.obj", many + "\n", "line 4: a face with 2,000 corners");

    row("ply count beyond bytes", "a.ply", test::asciiPly("0 0 0\n", "", 1000000000, 1),
        "line 4: number of elements \"vertex\": declared 1,000,000,000");
    row("ply negative count", "a.ply", test::asciiPly("0 0 0\n", "", -3, 1), "line 4: ");
    row("ply index beyond", "a.ply", test::asciiPly("0 0 0\n1 0 0\n0 1 0\n", "3 0 1 3\n"),
        "line 14: face 0 uses vertex 3");
    row("ply index negative", "a.ply", test::asciiPly("0 0 0\n1 0 0\n0 1 0\n", "3 0 1 -1\n"),
        "line 14: face 0 uses vertex -1");
    row("ply NaN", "a.ply", test::asciiPly("0 0 0\n1 nan 0\n0 1 0\n"), "line 12: vertex 1");
    row("ply words", "a.ply", test::asciiPly("0 0 0\n1 x 0\n0 1 0\n"),
        "line 12: \"x\" is not a number, in element \"vertex\" 1 of 3");
    row("ply cut", "a.ply", test::asciiPly("0.00 0.00 0.00\n1 0 0\n", ""),
        "line 13: the file ends in element \"vertex\" 2 of 3");
    row("ply two corners", "a.ply", test::asciiPly("0 0 0\n1 0 0\n0 1 0\n", "2 0 1\n"), "line 14: 0 faces");
    row("ply more data", "a.ply", test::asciiPly() + "3 0 1 2\n", "line ");
    row("ply without faces", "a.ply", withPlyHeader("element vertex 1\n" + kXyz, std::string(12, '\0')),
        "header: 0 faces, but 1 points: a point cloud; expected a surface");
    row("ply without x", "a.ply", withPlyHeader("element vertex 1\nproperty float y\nelement face 0\n", "1234"),
        "header: ");
    row("ply cut header", "a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", "line 3: the file ends in the header");
    row("ply format", "a.ply", "ply\nformat binary_middle_endian 1.0\nend_header\n", "line 2: ");
    row("ply list of 4 billion", "a.ply",
        withPlyHeader("element vertex 1\n" + kXyz + "element face 1\nproperty list uint int vertex_indices\n",
                      std::string(12, '\0') + std::string(4, '\xff') + std::string(40, '\0')),
        "byte ");
    row("ply binary cut", "a.ply", binaryPly().substr(0, binaryPly().size() - 1), "byte ");

    row("vtp empty pieces", "a.vtp", test::asciiVtp("", "", "NumberOfPoints=\"0\" NumberOfPolys=\"0\"", ""), "0 faces");
    row("vtp two-cornered polygon", "a.vtp",
        test::asciiVtp("0 0 0 1 0 0 0 1 0", "0 1", "NumberOfPoints=\"3\" NumberOfPolys=\"1\"", "2"), "0 faces");
    row("vtp offsets fall", "a.vtp",
        test::asciiVtp("0 0 0 1 0 0 0 1 0", "0 1 2", "NumberOfPoints=\"3\" NumberOfPolys=\"3\"", "3 1 3"),
        "line 5: array \"offsets\": value 1 is 1; expected 3 to 3");
    row("vtp numbers behind a tag", "a.vtp", test::asciiVtp("<Key/>0 0 0 1 0 0 0 1 0"),
        "line 4: array \"Points\": number of values: 0; expected exactly 9");
    row("vtp numbers around a comment", "a.vtp", test::asciiVtp("0 0 0 1 0 <!-- 2 -->0 0 1 0"),
        "line 4: array \"Points\": number of values: 5; expected exactly 9");
    row("vtp without area", "a.vtp", test::asciiVtp("0 0 0 1 1 1 2 2 2"), "all triangles have zero area");
    const auto withText = [](const char* tuples, const char* characters) {
        return test::asciiVtp("0 0 0 1 0 0 0 1 0", "0 1 2", "NumberOfPoints=\"3\" NumberOfPolys=\"1\"", "3", "Polys",
                              std::string("<FieldData><Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"") +
                                  tuples + "\" format=\"ascii\">" + characters + "</Array></FieldData>");
    };
    row("vtp field data without end", "a.vtp", withText("4000000000", "76 0"), "line 3: array \"SPACE\"");
    row("vtp more strings than declared", "a.vtp", withText("1", "76 0 80 0"),
        "line 3: array \"SPACE\": number of tuples: declared 1, of components in each: 1; expected exactly 2 values, "
        "as many as it contains");
    row("vtp string without end", "a.vtp", withText("1", "76 0 80"),
        "line 3: array \"SPACE\": its last string has no end");
    row("vtp text of no characters", "a.vtp", withText("1", "76 999 0"),
        "line 3: array \"SPACE\": character 1 is \"999\"");
    row("vtp what is no array", "a.vtp",
        test::asciiVtp("0 0 0 1 0 0 0 1 0", "0 1 2", "NumberOfPoints=\"3\" NumberOfPolys=\"1\"", "3", "Polys",
                       "<FieldData><Aaryr type=\"Strig\" Name=\"SPACE\" NumberOfTuples=\"2\">76 0</Aaryr></FieldData>"),
        "line 3: found an element \"Aaryr\" under \"FieldData\"; expected \"DataArray\" or \"Array\"");
    const test::Folder folder;
    const std::vector<meshio::MeshStructure> structures{test::tetrahedron("a")};
    QVERIFY(meshio::writeMesh(folder.path("w.vtp"), structures).isOk());
    const std::string written = test::fileBytes(folder.path("w.vtp"));
    const std::size_t data = written.find('_', written.find("<AppendedData")) + 1;
    // VTK divides by the block size
    row("vtp blocks of no bytes", "a.vtp", std::string(written).replace(data + 8, 8, 8, '\0'),
        "line 4: array \"StructureNames\": block size 0 bytes, size of the last block ");
    const std::size_t encoding = written.find("encoding=\"raw\"");
    row("vtp of another encoding", "a.vtp", std::string(written).replace(encoding + 10, 3, "ras"),
        "line 34: found encoding=\"ras\"; expected \"raw\" or \"base64\"");
    // VTK names the element of the point data if reading the cell data fails.
    const std::size_t offset = written.find("offset=\"", written.find("\"StructureId\"")) + 8;
    const std::size_t block = data + std::stoul(written.substr(offset)) + std::size_t{4} * 8; // after its header
    std::string damaged = std::string(written).replace(block, 4, 4, '?');
    const std::size_t pointData = damaged.find("<PointData"), cellData = damaged.find("<CellData");
    row("vtp cells damaged, no point data", "a.vtp", damaged.erase(pointData, cellData - pointData),
        "line 9: array \"StructureId\": its compressed data are damaged");
    row("vtp entity", "a.vtp", "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\"><PolyData>&a;</PolyData></VTKFile>",
        "line 1: ");
    row("vtp as legacy", "a.vtp", "# vtk DataFile Version 3.0\n",
        "line 2: found \"\"; expected the keyword \"ASCII\" or \"BINARY\"");

    row("vtk of a grid", "a.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_GRID\n",
        "line 4: a VTK file of type \"STRUCTURED_GRID\"; expected the type \"POLYDATA\"");
    const auto grid = [](const std::string& cells, const std::string& types) {
        return "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 "
               "1\n" +
               cells + types;
    };
    row("vtk grid of tetrahedra", "a.vtk", grid("CELLS 1 5\n4 0 1 2 3\n", "CELL_TYPES 1\n10\n"),
        "line 10: a cell of VTK's type 10");
    row("vtk grid, types missing", "a.vtk", grid("CELLS 1 4\n3 0 1 2\n", "CELL_TYPES 2\n5 5\n"),
        "line 9: CELL_TYPES: number of values: declared 2; expected 1, one for each cell");
    row("vtk grid, types cut", "a.vtk", grid("CELLS 2 8\n3 0 1 2\n3 0 1 3\n", "CELL_TYPES 2\n5\n"),
        "line 12: CELL_TYPES: ");
    row("vtk grid, types first", "a.vtk", grid("", "CELL_TYPES 1\n5\n"), "line 7: CELL_TYPES: number of values");
    row("vtk grid, triangle of four corners", "a.vtk", grid("CELLS 1 5\n4 0 1 2 3\n", "CELL_TYPES 1\n5\n"),
        "line 10: number of corners of a cell of VTK's type 5: 4");
    row("vtk grid, index beyond", "a.vtk", grid("CELLS 1 4\n3 0 1 4\n", "CELL_TYPES 1\n5\n"),
        "line 8: CELLS use point 4");
    row("vtk grid without cells", "a.vtk", grid("", ""), "line 7: 0 faces, but 4 points");
    const auto vtu = [](const std::string& corners, const std::string& ends, const std::string& types) {
        return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"3\" NumberOfCells=\"1\">"
               "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0</DataArray></Points>"
               "<Cells><DataArray type=\"Int64\" Name=\"connectivity\">" +
               corners + "</DataArray><DataArray type=\"Int64\" Name=\"offsets\">" + ends + "</DataArray>" + types +
               "</Cells></Piece></UnstructuredGrid></VTKFile>";
    };
    const std::string triangle = "<DataArray type=\"UInt8\" Name=\"types\">5</DataArray>";
    row("vtu index beyond", "a.vtu", vtu("0 1 3", "3", triangle), "line 1: array \"connectivity\": value 2 is point 3");
    row("vtu offsets beyond", "a.vtu", vtu("0 1 2", "4", triangle), "line 1: array \"offsets\": value 0 is 4");
    row("vtu without types", "a.vtu", vtu("0 1 2", "3", ""), "line 1: the cells have no types");
    row("vtu two types", "a.vtu", vtu("0 1 2", "3", "<DataArray type=\"UInt8\" Name=\"types\">5 5</DataArray>"),
        "line 1: array \"types\": number of values: 2; expected exactly 1");
    row("vtu types of words", "a.vtu", vtu("0 1 2", "3", "<DataArray type=\"UInt8\" Name=\"types\">x</DataArray>"),
        "line 1: array \"types\": value 0 is \"x\"");
    row("vtu without cells", "a.vtu", "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid/></VTKFile>", "");
    row("vtk without a version", "a.vtk", "# vtk DataFile\nx\nASCII\nDATASET POLYDATA\n",
        "line 3: found \"# vtk DataFile\"");
    row("vtk of a version to come", "a.vtk", test::asciiVtk("", "", "x", "65536"),
        "line 3: version 65536; expected 1 to 5");
    row("vtk points beyond bytes", "a.vtk", test::asciiVtk("POINTS 1000000000 float\n0 0 0\n"),
        "line 5: number of points: declared 1,000,000,000");
    row("vtk negative points", "a.vtk", test::asciiVtk("POINTS -3 float\n0 0 0\n"),
        "line 5: number of points: found \"-3\"");
    row("vtk points of words", "a.vtk", test::asciiVtk("POINTS 3 string\na\nb\nc\n"),
        "line 5: points of type \"string\"");
    row("vtk points cut", "a.vtk", test::asciiVtk("POINTS 3 float\n0 0 0 1 0 0 0 1\n", ""),
        "line 7: a coordinate of point 2 of 3 is missing");
    row("vtk NaN", "a.vtk", test::asciiVtk("POINTS 3 float\n0 0 0 1 nan 0 0 1 0\n"),
        "line 6: point 1: a coordinate is not");
    row("vtk far", "a.vtk", test::asciiVtk("POINTS 3 float\n0 0 0 2e7 0 0 0 1 0\n"),
        "line 6: point 1: a coordinate is farther");
    row("vtk no points", "a.vtk", test::asciiVtk(""),
        "line 6: POLYGONS use point 0; expected POINTS before this section");
    row("vtk points twice", "a.vtk", test::asciiVtk("POINTS 1 float\n0 0 0\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n"),
        "line 7: a second section \"POINTS\"");
    row("vtk points twice, in small letters", "a.vtk",
        test::asciiVtk("POINTS 1 float\n0 0 0\npoints 3 float\n0 0 0 1 0 0 0 1 0\n"),
        "line 7: a second section \"points\"");
    row("vtk index beyond", "a.vtk", test::asciiVtk("POINTS 3 float\n0 0 0 1 0 0 0 1 0\n", "POLYGONS 1 4\n3 0 1 3\n"),
        "line 8: POLYGONS use point 3; expected 0 to 2");
    row("vtk index negative", "a.vtk",
        test::asciiVtk("POINTS 3 float\n0 0 0 1 0 0 0 1 0\n", "POLYGONS 1 4\n3 0 1 -1\n"),
        "line 8: POLYGONS use point -1");
    row("vtk index of a line beyond", "a.vtk", test::asciiVtk("POINTS 3 float\n0 0 0 1 0 0 0 1 0\nLINES 1 3\n2 0 7\n"),
        "line 8: LINES use point 7");
    row("vtk corners beyond the list", "a.vtk",
        test::asciiVtk("POINTS 3 float\n0 0 0 1 0 0 0 1 0\n", "POLYGONS 1 4\n4 0 1 2 0\n"),
        "line 8: POLYGONS: number of corners of cell 0: 4; expected 0 to 3");
    row("vtk corners negative", "a.vtk",
        test::asciiVtk("POINTS 3 float\n0 0 0 1 0 0 0 1 0\n", "POLYGONS 1 4\n-3 0 1 2\n"),
        "line 8: POLYGONS: number of corners of cell 0: -3; expected 0 to 3");
    row("vtk list too long", "a.vtk",
        test::asciiVtk("POINTS 3 float\n0 0 0 1 0 0 0 1 0\n", "POLYGONS 1 6\n3 0 1 2 0 0\n"),
        "line 8: POLYGONS: number of values: declared 6; expected 4");
    row("vtk cells beyond bytes", "a.vtk",
        test::asciiVtk("POINTS 3 float\n0 0 0 1 0 0 0 1 0\n", "POLYGONS 900000000 4\n3 0 1 2\n"),
        "line 7: number of cells: declared 900,000,000");
    row("vtk no polygon", "a.vtk", test::asciiVtk("POINTS 3 float\n0 0 0 1 0 0 0 1 0\n", ""),
        "line 7: 0 faces, but 3 points: a point cloud");
    const auto offsets = [](const std::string& numbers) {
        return test::asciiVtk("POINTS 3 float\n0 0 0 1 0 0 0 1 0\n",
                              "POLYGONS 2 3\nOFFSETS vtktypeint64\n" + numbers + "\nCONNECTIVITY vtktypeint64\n0 1 2\n",
                              "x", "5.1");
    };
    row("vtk first offset", "a.vtk", offsets("1 3"), "line 9: POLYGONS: offset 0 is 1; expected exactly 0");
    row("vtk offset beyond", "a.vtk", offsets("0 9"), "line 9: POLYGONS: offset 1 is 9; expected 0 to 3");
    row("vtk offsets end early", "a.vtk", offsets("0 2"),
        "line 9: POLYGONS: number of corners: declared 3; expected 2");
    row("vtk no offsets", "a.vtk",
        test::asciiVtk("POINTS 3 float\n0 0 0 1 0 0 0 1 0\n", "POLYGONS 1 4\n3 0 1 2\n", "x", "5.1"),
        "line 8: found \"3\" and \"0\"; expected the keyword \"OFFSETS\"");
    row("vtk unknown section", "a.vtk", test::asciiVtk("TRIANGLES 3\n"), "line 5: found \"TRIANGLES\"");
    row("vtk field beyond bytes", "a.vtk", test::asciiVtk("FIELD f 1\na 3 2000000000 double\n1 2 3\n"),
        "line 6: number of tuples: declared 2,000,000,000");
    row("vtk field of no type", "a.vtk", test::asciiVtk("FIELD f 1\na 1 3 quux\n1 2 3\n"),
        "line 7: array \"a\": number of values: declared 3");
}

void HostileFiles::ownFilesAreRefused()
{
    QFETCH(std::string, name);
    QFETCH(std::string, bytes);
    QFETCH(std::string, place);
    const test::Folder folder;
    const auto path = folder.write(name, bytes);
    ErrorStream errors(folder.path("errors"));
    const auto file = meshio::readMesh(path);
    QCOMPARE(errors.stop(), std::string());
    verifyRefused(file, name);
    QVERIFY2(file.status().message().starts_with(name + ": " + place), file.status().message().c_str());
}

void HostileFiles::namesWhatElseItIs_data()
{
    QTest::addColumn<std::string>("bytes");
    QTest::addColumn<std::string>("words");
    const auto row = [](const std::string& bytes, const char* words) {
        QTest::newRow(words) << bytes << std::string(words);
    };
    row("", "empty");
    row("<!DOCTYPE html>\n<html><body>404</body></html>", "web page");
    row("version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 5\n", "Git LFS pointer");
    row("PK\x03\x04 and more", "ZIP");
    row("hello, this is not a mesh", "no known mesh format");
}

void HostileFiles::namesWhatElseItIs()
{
    QFETCH(std::string, bytes);
    QFETCH(std::string, words);
    const test::Folder folder;
    for (const std::string name : {"liver.ply", "liver.vtp"}) {
        const auto file = meshio::readMesh(folder.write(name, bytes));
        verifyRefused(file, name);
        QVERIFY2(file.status().message().find(words) != std::string::npos, file.status().message().c_str());
    }
}

void HostileFiles::missingFileFolderAndPipeAreErrors()
{
    const test::Folder folder;
    QCOMPARE(meshio::readMesh(folder.path("none.stl")).status().code(), StatusCode::NotFound);
    QCOMPARE(meshio::readMesh(folder.path("")).status().code(), StatusCode::Unreadable);
    QCOMPARE(meshio::readMesh("/dev/zero").status().code(), StatusCode::Unreadable);
}

void HostileFiles::cutAnywhereNeverCrashes_data()
{
    QTest::addColumn<std::string>("name");
    QTest::addColumn<std::string>("bytes");
    const test::Folder folder;
    const std::vector<meshio::MeshStructure> structures{test::tetrahedron("a"), test::tetrahedron("b")};
    QVERIFY(meshio::writeMesh(folder.path("a.vtp"), structures).isOk());
    const std::string packed = test::fileBytes(folder.path("a.vtp"));
    QTest::newRow("vtp, packed") << std::string("a.vtp") << packed;
    QTest::newRow("vtp, text") << std::string("a.vtp") << test::asciiVtp();
    QTest::newRow("stl") << std::string("a.stl") << test::binaryStl(1, {{0, 0, 0, 1, 0, 0, 0, 1, 0}});
    QTest::newRow("stl, text") << std::string("a.stl") << test::asciiStl();
    QTest::newRow("obj") << std::string("a.obj") << "# x\ng a\n" + test::kObj;
    QTest::newRow("ply") << std::string("a.ply") << binaryPly();
    QTest::newRow("ply, text") << std::string("a.ply") << test::asciiPly();
    QTest::newRow("vtk") << std::string("a.vtk") << test::binaryVtk();
    QTest::newRow("vtk, text") << std::string("a.vtk") << test::asciiVtk();
    QTest::newRow("vtk grid, text") << std::string("a.vtk") << test::asciiGrid();
    QTest::newRow("vtu, text") << std::string("a.vtu") << test::asciiVtu();
    QTest::newRow("ply strips") << std::string("a.ply") << test::stripsPly();
}

void HostileFiles::cutAnywhereNeverCrashes()
{
    QFETCH(std::string, name);
    QFETCH(std::string, bytes);
    const test::Folder folder;
    const auto whole = meshio::readMesh(folder.write(name, bytes));
    QVERIFY2(whole.isOk(), whole.status().message().c_str());
    ErrorStream errors(folder.path("errors"));
    std::size_t wrong = bytes.size();
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        const auto file = meshio::readMesh(folder.write(name, bytes.substr(0, size)));
        // Files that are complete without their end (a last line feed, XML after the data) must give the full mesh.
        if (file.isOk() && test::triangles(file.value()) != test::triangles(whole.value())) {
            wrong = size;
        }
    }
    QCOMPARE(errors.stop(), std::string());
    QCOMPARE(wrong, bytes.size());
}

void HostileFiles::flippedBytesNeverCrash()
{
    QFETCH(std::string, name);
    QFETCH(std::string, bytes);
    const test::Folder folder;
    std::mt19937 random(20261121);
    ErrorStream errors(folder.path("errors"));
    std::size_t read = 0;
    for (int round = 0; round < 1500; ++round) {
        std::string damaged = bytes;
        for (unsigned k = 0; k <= random() % 3; ++k) {
            damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
        }
        const auto file = meshio::readMesh(folder.write(name, damaged));
        if (file.isOk()) { // then all guarantees hold
            ++read;
            for (const meshio::MeshStructure& s : file.value().structures) {
                for (const core::Vec3& p : s.mesh.vertices) {
                    QVERIFY(p.cwiseAbs().maxCoeff() <= 1e7);
                }
                for (const geometry::Triangle& t : s.mesh.triangles) {
                    QVERIFY(std::max({t[0], t[1], t[2]}) < s.mesh.vertices.size());
                }
            }
        } else {
            QVERIFY(file.status().message().starts_with(name));
        }
    }
    const std::string said = errors.stop();
    QVERIFY2(said.empty(), said.substr(0, 500).c_str());
    QVERIFY(read < 1500);
}

PALPATE_TEST(HostileFiles)
#include "tst_HostileFiles.moc"
