// SPDX-License-Identifier: BSD-3-Clause
// Files as other programs write them, in kinds for which public reports exist: each opens with the right surface, and a
// note tells what was left out.
#include "Samples.h"
#include "TestRunner.h"

#include <palpate/meshio/DicomFolder.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

using namespace palpate;
using core::Vec3;

namespace {

using Colour = std::array<double, 3>;

/// A box of twelve triangles.
struct Box
{
    Vec3 low, high;

    [[nodiscard]] std::vector<Vec3> corners() const
    {
        std::vector<Vec3> out;
        for (const double z : {low.z(), high.z()}) {
            for (const auto& [x, y] : {std::pair(low.x(), low.y()), std::pair(high.x(), low.y()),
                                       std::pair(high.x(), high.y()), std::pair(low.x(), high.y())}) {
                out.emplace_back(x, y, z);
            }
        }
        return out;
    }
    [[nodiscard]] double area() const
    {
        const Vec3 s = high - low;
        return 2.0 * (s.x() * s.y() + s.y() * s.z() + s.z() * s.x());
    }
    [[nodiscard]] double volume() const { return (high - low).prod(); }
};

const Box kA{{10, 20, 30}, {50, 50, 50}};
const Box kB{{60, 20, 30}, {70, 45, 36}};
constexpr std::array<std::array<int, 3>, 12> kFaces{{{0, 3, 2},
                                                     {0, 2, 1},
                                                     {4, 5, 6},
                                                     {4, 6, 7},
                                                     {0, 1, 5},
                                                     {0, 5, 4},
                                                     {1, 2, 6},
                                                     {1, 6, 5},
                                                     {2, 3, 7},
                                                     {2, 7, 6},
                                                     {3, 0, 4},
                                                     {3, 4, 7}}};

double volumeOf(const geometry::TriangleMesh& mesh)
{
    double sum = 0.0;
    for (const geometry::Triangle& t : mesh.triangles) {
        sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
    }
    return sum;
}

/// Verifies that the mesh is the box with its normals outwards.
void verifyBox(const geometry::TriangleMesh& mesh, const Box& box)
{
    QCOMPARE(mesh.triangles.size(), std::size_t{12});
    QCOMPARE(mesh.bounds().min(), box.low);
    QCOMPARE(mesh.bounds().max(), box.high);
    QVERIFY(std::abs(test::area(mesh) - box.area()) < 1e-9 * box.area());
    QVERIFY2(std::abs(volumeOf(mesh) - box.volume()) < 1e-9 * box.volume(),
             qPrintable(QString::number(volumeOf(mesh))));
}

std::string words(const Vec3& p)
{
    return std::to_string(static_cast<int>(p.x())) + " " + std::to_string(static_cast<int>(p.y())) + " " +
           std::to_string(static_cast<int>(p.z()));
}

std::string facets(const Box& box = kA)
{
    std::string out;
    const auto p = box.corners();
    for (const auto& face : kFaces) {
        out += "facet normal 0 0 0\n outer loop\n";
        for (const int corner : face) {
            out += "  vertex " + words(p[static_cast<std::size_t>(corner)]) + "\n";
        }
        out += " endloop\nendfacet\n";
    }
    return out;
}

std::string binary(std::uint32_t declared = 12, const std::string& header = "binary",
                   const std::function<std::uint16_t(int)>& attribute = {})
{
    std::vector<std::array<float, 9>> list;
    const auto p = kA.corners();
    for (const auto& face : kFaces) {
        std::array<float, 9>& facet = list.emplace_back();
        for (std::size_t i = 0; i < 9; ++i) {
            facet[i] = static_cast<float>(p[static_cast<std::size_t>(face[i / 3])][static_cast<Eigen::Index>(i % 3)]);
        }
    }
    std::string out = test::binaryStl(declared, list, header);
    for (int i = 0; attribute && i < 12; ++i) {
        const std::uint16_t bits = attribute(i);
        out.replace(84 + 50 * static_cast<std::size_t>(i) + 48, 2, reinterpret_cast<const char*>(&bits), 2);
    }
    return out;
}

std::string vertices(const Box& box = kA, const std::string& before = "v ")
{
    std::string out;
    for (const Vec3& p : box.corners()) {
        out += before + words(p) + "\n";
    }
    return out;
}

/// @param first  index of the first corner of the box
std::string faces(int first = 1, const std::string& before = "f ", const std::string& after = "")
{
    std::string out;
    for (const auto& face : kFaces) {
        out += before;
        for (const int corner : face) {
            out += std::to_string(corner + first) + " ";
        }
        out += after + "\n";
    }
    return out;
}

std::string plyHeader(int vertexCount, int faceCount, const std::string& extra = "",
                      const std::string& format = "ascii")
{
    return "ply\nformat " + format + " 1.0\n" + extra + "element vertex " + std::to_string(vertexCount) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faceCount) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string boxPly(bool isStrips = false)
{
    std::string out = plyHeader(8, 12, "", "binary_little_endian");
    if (isStrips) {
        out.replace(out.find("element face 12"), 15, "element tristrips 1");
        out.replace(out.find("list uchar"), 10, "list int");
    }
    for (const Vec3& p : kA.corners()) {
        for (const double x : p) {
            test::appendRaw(out, static_cast<float>(x));
        }
    }
    if (isStrips) {
        test::appendRaw(out, std::int32_t{47});
    }
    for (std::size_t i = 0; i < kFaces.size(); ++i) {
        if (!isStrips) {
            test::appendRaw(out, std::uint8_t{3});
        } else if (i > 0) {
            test::appendRaw(out, std::int32_t{-1});
        }
        for (const int corner : kFaces[i]) {
            test::appendRaw(out, std::int32_t{corner});
        }
    }
    return out;
}

std::string dataArray(const std::string& attributes, const std::string& numbers)
{
    return "<DataArray " + attributes + " format=\"ascii\">" + numbers + "</DataArray>";
}

std::string offsets(int cells)
{
    std::string out;
    for (int i = 1; i <= cells; ++i) {
        out += std::to_string(3 * i) + " ";
    }
    return out;
}

/// A VTK XML file of one piece, box A and then `more` boxes B. @param type  "PolyData" or "UnstructuredGrid"
std::string xml(const std::string& type, bool hasB, const std::string& cellData = "", const std::string& after = "")
{
    const bool isGrid = type == "UnstructuredGrid";
    const std::string points = vertices(kA, " ") + (hasB ? vertices(kB, " ") : "");
    const int cells = hasB ? 24 : 12;
    const std::string element = isGrid ? "Cells" : "Polys";
    std::string types;
    for (int i = 0; i < cells; ++i) {
        types += "5 ";
    }
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type +
           "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt32\"><" + type +
           "><Piece NumberOfPoints=\"" + (hasB ? "16" : "8") + "\" NumberOf" + element + "=\"" + std::to_string(cells) +
           "\">" + cellData + "<Points>" + dataArray("type=\"Float64\" NumberOfComponents=\"3\"", points) +
           "</Points><" + element + ">" +
           dataArray("type=\"Int64\" Name=\"connectivity\"", faces(0, "") + (hasB ? faces(8, "") : "")) +
           dataArray("type=\"Int64\" Name=\"offsets\"", offsets(cells)) +
           (isGrid ? dataArray("type=\"UInt8\" Name=\"types\"", types) : "") + "</" + element + "></Piece>" + after +
           "</" + type + "></VTKFile>\n";
}

std::string ghosts(const std::string& ofB)
{
    std::string numbers;
    for (int i = 0; i < 24; ++i) {
        numbers += i < 12 ? "0 " : ofB + " ";
    }
    return "<CellData>" + dataArray("type=\"UInt8\" Name=\"vtkGhostType\"", numbers) + "</CellData>";
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
    return text;
}

std::string utf16(const std::string& ascii, bool isBig, bool hasMark = true)
{
    std::string out = !hasMark ? "" : isBig ? "\xfe\xff" : "\xff\xfe";
    for (const char c : ascii) {
        out += isBig ? std::string{'\0', c} : std::string{c, '\0'};
    }
    return out;
}

std::string grid(const std::string& cellType = "5")
{
    std::string types;
    for (int i = 0; i < 12; ++i) {
        types += cellType + "\n";
    }
    return "# vtk DataFile Version 3.0\nsurface\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n" +
           vertices(kA, "") + "CELLS 12 48\n" + faces(0, "3 ") + "CELL_TYPES 12\n" + types;
}

/// Both boxes as a legacy VTK file whose second box is hidden.
std::string legacyHidden(bool isGrid)
{
    std::string types, hidden;
    for (int i = 0; i < 24; ++i) {
        types += "5\n";
        hidden += i < 12 ? "0 " : "32 ";
    }
    const std::string cells = faces(0, "3 ") + faces(8, "3 ");
    const std::string points = "POINTS 16 float\n" + vertices(kA, "") + vertices(kB, "");
    return isGrid ? "# vtk DataFile Version 4.2\nsurface\nASCII\nDATASET UNSTRUCTURED_GRID\n" + points +
                        "CELLS 24 96\n" + cells + "CELL_TYPES 24\n" + types +
                        "CELL_DATA 24\nFIELD FieldData 1\nvtkGhostType 1 24 unsigned_char\n" + hidden + "\n"
                  : "# vtk DataFile Version 4.2\nsurface\nASCII\nDATASET POLYDATA\n" + points + "LINES 1 3\n2 0 1\n" +
                        "POLYGONS 24 96\n" + cells + "POINT_DATA 16\nSCALARS a float 1\nLOOKUP_TABLE default\n" +
                        replaced(std::string(16, 'x'), "x", "1 ") +
                        "\nCELL_DATA 25\nSCALARS vtkGhostType unsigned_char\nLOOKUP_TABLE default\n0 " + hidden + "\n";
}

bool hasNote(const std::vector<core::Message>& notes, const std::string& part)
{
    return std::any_of(notes.begin(), notes.end(),
                       [&](const core::Message& note) { return note.english().find(part) != std::string::npos; });
}

/// What the folder of reported files should give.
struct Reported
{
    const char* file;
    std::vector<const char*> names; ///< of box A, or of boxes A and B; nullptr: any
    const char* note;               ///< part of a note; nullptr: none is required
};

} // namespace

class ReportedFiles : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void opensAsTheBox_data();
    void opensAsTheBox();
    void twoPartsStayTwo_data();
    void twoPartsStayTwo();
    void usedVertexMustBeFinite_data();
    void usedVertexMustBeFinite();
    void refusalsNameTheNextStep_data();
    void refusalsNameTheNextStep();
    void folderOfDicomIsNamed();
    void cutOffStlOpensInPart();
    void stlColours();
    void materialColours();
    void slicersColoursAreThirds();
    void namesBecomeUtf8();
    void blockFilesNameStructures();
    void blockFilesStayInTheirFolder();
    void foldersSkipHiddenFiles();
    void commonPrefixIsNotShown();
    void sharedFilesGiveTheRightAnswer();
};

void ReportedFiles::opensAsTheBox_data()
{
    QTest::addColumn<std::string>("name");
    QTest::addColumn<std::string>("bytes");
    QTest::addColumn<std::string>("note"); // part of a note; empty: no note at all
    const auto row = [](const char* title, const char* extension, const std::string& bytes, const char* note = "") {
        QTest::newRow(title) << std::string("box") + extension << bytes << std::string(note);
    };
    row("stl, a byte more", ".stl", binary() + "x", "1 byte behind the last face left out");
    row("stl, zeros to the end of a block", ".stl", binary() + std::string(340, '\0'), "340 bytes behind");
    row("stl, a text behind", ".stl", binary() + "written by a program that likes to sign what it writes, at length",
        "bytes behind");
    row("stl, header solid, a byte more", ".stl", binary(12, "solid box") + "x", "1 byte behind");
    row("stl, count 0", ".stl", binary(0), "the size of the file says 12");
    for (const std::uint32_t count : {0xffffffffU, 1U, 11U}) {
        QTest::addRow("stl, count %u", count)
            << std::string("box.stl") << binary(count) << std::string("the size of the file says 12");
    }
    row("stl, count 0, zeros behind", ".stl", binary(0) + std::string(10, '\0'), "the size of the file says 12");
    row("stl, count 0, zeros to the end of a block", ".stl", binary(0) + std::string(340, '\0'),
        "340 bytes behind the last face");
    row("stl, count 0, a text behind", ".stl",
        binary(0) + "written by a program that likes to sign what it writes, at length",
        "the size of the file says 12");
    row("stl, highest count, a text behind", ".stl", binary(0xffffffffU) + "the end", "7 bytes behind the last face");
    row("stl, header solid, highest count", ".stl", binary(0xffffffffU, "solid box"), "the size of the file says 12");
    row("stl, last attribute missing", ".stl", binary().substr(0, 84 + 600 - 2), "attribute");
    row("stl, half the last attribute missing", ".stl", binary().substr(0, 84 + 600 - 1), "attribute");

    row("ascii stl", ".stl", "solid a\n" + facets() + "endsolid a\n");
    row("ascii stl, end solid", ".stl", "solid a\n" + facets() + "end solid a\n");
    row("ascii stl, glued name", ".stl", "solid a\n" + facets() + "endsolida\n");
    row("ascii stl, glued names", ".stl", "solidBox\n" + facets() + "endsolidBox\n");
    row("ascii stl, no endsolid", ".stl", "solid a\n" + facets(), "\"endsolid\", is missing");
    row("ascii stl, solid twice", ".stl", "solid a\nsolid a\n" + facets() + "endsolid a\nendsolid a\n");
    row("ascii stl, comments", ".stl", "solid a\n# by hand\n; unit mm\n" + facets() + "// end\nendsolid a\n");
    row("ascii stl, header of several lines", ".stl", "solid a\nmade for a test\n" + facets() + "endsolid a\n");
    row("ascii stl, spaced keywords", ".stl",
        "solid a\n" + replaced(replaced(facets(), "endloop", "end loop"), "endfacet", "END FACET") + "endsolid a\n");
    row("ascii stl, outerloop", ".stl", "solid a\n" + replaced(facets(), "outer loop", "outerloop") + "endsolid a\n");
    row("ascii stl, long lines", ".stl",
        "solid a\n" + replaced(facets(), "vertex", std::string(300, ' ') + "vertex") + "endsolid a\n");
    row("ascii stl, Ctrl-Z", ".stl", "solid a\n" + facets() + "endsolid a\n\x1a");
    row("ascii stl, zeros behind", ".stl", "solid a\n" + facets() + "endsolid a\n" + std::string(64, '\0'));
    row("ascii stl, CR", ".stl", replaced("solid a\n" + facets() + "endsolid a\n", "\n", "\r"));
    row("ascii stl, UTF-16", ".stl", utf16("solid a\n" + facets() + "endsolid a\n", false));
    const std::string ascii = "solid a\n" + facets() + "endsolid a\n";
    row("ascii stl, comments above", ".stl", "# by hand\n; unit mm\n// x\n" + ascii);
    row("ascii stl, a line above", ".stl", "made for a test\n\n" + ascii);
    row("ascii stl, blank lines above", ".stl", std::string(100, '\n') + ascii);
    row("ascii stl, long comment above", ".stl", replaced(std::string(300, 'x'), "x", "# a licence text\n") + ascii);
    row("ascii stl, comment in Latin-1", ".stl",
        "# gr\xf6\xdf"
        "e\n" +
            ascii);
    row("ascii stl, no solid", ".stl", facets());
    row("ascii stl, no solid, capitals", ".dat", replaced(replaced(facets(), "facet", "FACET"), "vertex", "VERTEX"));
    row("ascii stl, comments above, zeros behind", ".stl", "# x\n" + ascii + std::string(64, '\0'));
    row("ascii stl, UTF-16 big", ".stl", utf16(ascii, true));
    row("ascii stl, UTF-16 little, no mark", ".stl", utf16(ascii, false, false));
    row("ascii stl, UTF-16 big, no mark", ".stl", utf16(ascii, true, false));
    row("ascii stl, UTF-16 and comments, no mark", ".stl", utf16("# x\n" + ascii, false, false));
    row("ascii stl, one line", ".stl", replaced(ascii, "\n", " "));
    row("ascii stl, one line, end facet", ".stl",
        replaced(replaced(replaced(replaced(ascii, "\n", " "), "endfacet", "end facet"), "endsolid", "end solid"),
                 "outer loop", "OUTERLOOP"));
    row("ascii stl, one line, no solid", ".stl", replaced(facets(), "\n", " "));
    row("ascii stl, one line for each facet", ".stl",
        "solid a\n" + replaced(replaced(facets(), "\n", " "), "endfacet ", "endfacet\n") + "endsolid a\n");
    row("ascii stl, vertices on a line", ".stl", replaced(ascii, "\n  vertex", " vertex"));
    row("ascii stl, facet behind solid", ".stl", replaced(ascii, "solid a\nfacet", "solid a facet"));
    row("ascii stl, facet behind endfacet", ".stl", replaced(ascii, "endfacet\nfacet", "endfacet facet"));
    row("ascii stl, keywords in a name", ".stl", replaced(ascii, "solid a", "solid vertex facet outer loop"));

    const std::string obj = vertices() + faces();
    row("obj, zeros behind", ".obj", obj + std::string(64, '\0'));
    row("obj, Ctrl-Z", ".obj", obj + "\x1a");
    row("obj, CR", ".obj", replaced(obj, "\n", "\r"));
    row("obj, CR CR LF", ".obj", replaced(obj, "\n", "\r\r\n"));
    row("obj, UTF-16 little", ".obj", utf16(obj, false));
    row("obj, UTF-16 big", ".obj", utf16(obj, true));
    row("obj, UTF-16 little, no mark", ".obj", utf16(obj, false, false));
    row("obj, UTF-16 big, no mark", ".obj", utf16(obj, true, false));
    row("obj, backslash before v", ".obj", "# from C:\\models\\\n" + obj);
    row("obj, backslash before f", ".obj", vertices() + "  # from C:\\models\\\n" + faces());
    row("obj, comment behind a face", ".obj", vertices() + faces(1, "f ", "# face"));
    row("obj, unused NaN", ".obj", vertices() + "v nan nan nan\n" + faces(), "1 vertex without finite");
    row("obj, unused -nan(ind)", ".obj", vertices() + "v -nan(ind) 0 0\nv 1.#QNAN -1.#IND 0\n" + faces(),
        "2 vertices without finite");
    for (const char* number : {"1.#INF", "-1.#INF", "1.#INF00", "1.#SNAN", "1.#QNAN0", "-1.#IND00", "1.#J"}) {
        QTest::addRow("obj, unused %s", number)
            << std::string("box.obj") << vertices() + "v 0 " + number + " 0\n" + faces()
            << std::string("1 vertex without finite");
    }
    row("obj, unused far", ".obj", vertices() + "v 1e30 0 0\n" + faces(), "1 vertex without finite");
    row("obj, two corners", ".obj", obj + "f 1 2\nf 3\n", "2 faces of fewer than 3 corners");
    row("obj, one material", ".obj", "usemtl a\n" + obj, "colours not read");

    row("ply, unused NaN", ".ply", plyHeader(9, 12) + vertices(kA, "") + "nan nan nan\n" + faces(0, "3 "),
        "1 vertex without finite");
    row("ply, blank behind the magic word", ".ply",
        replaced(plyHeader(8, 12) + vertices(kA, "") + faces(0, "3 "), "ply\n", "ply \n"));
    row("ply, tab behind the magic word, CR LF", ".dat",
        replaced(replaced(plyHeader(8, 12), "ply\n", "ply\t\n"), "\n", " \r\n") + vertices(kA, "") + faces(0, "3 "));
    row("ply, two corners", ".ply", plyHeader(8, 13) + vertices(kA, "") + "2 0 1\n" + faces(0, "3 "),
        "1 face of fewer than 3 corners");
    row("ply, surplus numbers", ".ply",
        plyHeader(8, 12) + vertices(kA, "") + faces(0, "3 ", "6 0 0.5 1 0.5 0 1 255 0 0"),
        "lines with more numbers than the header declares: 12");
    row("ply, surplus numbers of vertices", ".ply",
        plyHeader(8, 12) + replaced(vertices(kA, ""), "\n", " 255\n") + faces(0, "3 "),
        "lines with more numbers than the header declares: 8");
    // As many surplus numbers as further elements: read word by word, these bodies hold other triangles.
    row("ply, surplus of a number", ".ply", plyHeader(8, 12) + vertices(kA, "") + faces(0, "3 ", "5"),
        "lines with more numbers than the header declares: 12");
    row("ply, surplus of two numbers", ".ply", plyHeader(8, 12) + vertices(kA, "") + faces(0, "3 ", "7 0"),
        "lines with more numbers than the header declares: 12");
    row("ply, surplus of a number, CR and blank lines", ".ply",
        replaced(plyHeader(8, 12) + vertices(kA, "") + "\n" + faces(0, "3 ", "5") + " \n", "\n", "\r"),
        "lines with more numbers than the header declares: 12");
    row("ply, elements over several lines", ".ply",
        plyHeader(8, 12) + replaced(vertices(kA, ""), " ", "\n") + replaced(faces(0, "3 "), " ", "\n"));
    row("ply, elements on one line", ".ply", plyHeader(8, 12) + replaced(vertices(kA, "") + faces(0, "3 "), "\n", " "));
    row("ply, as many lines as elements, otherwise divided", ".ply",
        plyHeader(8, 12) + replaced(vertices(kA, ""), "\n", " ") + "\n\n" +
            replaced(replaced(replaced(faces(0, "3 "), "3 0 3 2 ", "3\n0\n3\n2\n"), "3 0 2 1 ", "3\n0\n2\n1\n"),
                     "3 4 5 6 ", "3 4\n5 6"));
    row("ply, stray header line", ".ply",
        plyHeader(8, 12, "Created by a program - source file: box\n") + vertices(kA, "") + faces(0, "3 "),
        "none of PLY");
    row("ply, CR", ".ply", replaced(plyHeader(8, 12) + vertices(kA, "") + faces(0, "3 "), "\n", "\r"));
    row("ply, Ctrl-Z", ".ply", plyHeader(8, 12) + vertices(kA, "") + faces(0, "3 ") + "\x1a");
    row("ply, binary", ".ply", boxPly());
    row("ply, binary, LF behind", ".ply", boxPly() + "\n");
    row("ply, binary, zeros behind", ".ply", boxPly() + std::string(100, '\0'), "100 bytes behind");
    row("ply, strips", ".ply", boxPly(true));

    row("vtp, two corners", ".vtp",
        replaced(replaced(replaced(xml("PolyData", false), "NumberOfPolys=\"12\"", "NumberOfPolys=\"13\""), "36 </Data",
                          "36 38 </Data"),
                 "</DataArray><DataArray type=\"Int64\" Name=\"offsets\"",
                 "0 1 </DataArray><DataArray type=\"Int64\" Name=\"offsets\""),
        "1 face of fewer than 3 corners");
    row("vtp, unused NaN", ".vtp",
        replaced(replaced(xml("PolyData", false), "NumberOfPoints=\"8\"", "NumberOfPoints=\"9\""),
                 "</DataArray></Points>", "nan nan nan </DataArray></Points>"),
        "1 vertex without finite");
    for (const char* number : {"nan", "NaN", "-nan", "inf", "-inf", "infinity", "nan(ind)", "1.#QNAN", "-1.#IND",
                               "-1.#INF", "1e999", "-1e30"}) {
        for (const std::string type : {"PolyData", "UnstructuredGrid"}) {
            for (const std::string end : {"", " ", "\n"}) {
                const std::string point = std::string(number) + " 1 " + number + end;
                QTest::addRow("%s, unused %s%s", type.c_str(), number,
                              end.empty()  ? ""
                              : end == " " ? " "
                                           : " line")
                    << std::string(type == "PolyData" ? "box.vtp" : "box.vtu")
                    << replaced(replaced(xml(type, false), "NumberOfPoints=\"8\"", "NumberOfPoints=\"9\""),
                                "</DataArray></Points>", point + "</DataArray></Points>")
                    << std::string("1 vertex without finite");
            }
        }
    }
    row("vtp, beyond the range of Float32", ".vtp",
        replaced(replaced(replaced(xml("PolyData", false), "NumberOfPoints=\"8\"", "NumberOfPoints=\"9\""),
                          "</DataArray></Points>", "1e39 0 0</DataArray></Points>"),
                 "Float64", "Float32"),
        "1 vertex without finite");
    for (const bool isBig : {false, true}) {
        for (const bool hasMark : {false, true}) {
            for (const std::string type : {"PolyData", "UnstructuredGrid"}) {
                const std::string declared = replaced(xml(type, false), "version=\"1.0\"?",
                                                      "version=\"1.0\" encoding='UTF-16' standalone='yes'?");
                const char* order = isBig ? "big" : "little";
                QTest::addRow("%s, UTF-16 %s %d", type.c_str(), order, hasMark ? 1 : 0)
                    << std::string(type == "PolyData" ? "box.vtp" : "box.vtu") << utf16(declared, isBig, hasMark)
                    << std::string();
                QTest::addRow("%s, UTF-16 %s %d, no declaration", type.c_str(), order, hasMark ? 1 : 0)
                    << std::string("box.dat")
                    << utf16(replaced(xml(type, false), "<?xml version=\"1.0\"?>", ""), isBig, hasMark)
                    << std::string();
            }
        }
    }
    row("vtp, empty piece", ".vtp",
        xml("PolyData", false, "", "<Piece NumberOfPoints=\"0\" NumberOfPolys=\"0\"><Points/><Polys/></Piece>"));
    row("vtp, empty piece first", ".vtp",
        replaced(xml("PolyData", false), "<PolyData>",
                 "<PolyData><Piece NumberOfPoints=\"0\" NumberOfPolys=\"0\"><Points></Points></Piece>"));
    row("vtp, hidden cells", ".vtp", xml("PolyData", true, ghosts("32")), "12 hidden cells left out");
    row("vtp, ghost cells", ".vtp", xml("PolyData", true, ghosts("1")), "12 hidden cells left out");
    row("vtp, zeros behind", ".vtp", xml("PolyData", false) + std::string(10, '\0'));
    row("vtu", ".vtu", xml("UnstructuredGrid", false));
    row("vtu, hidden cells", ".vtu", xml("UnstructuredGrid", true, ghosts("32")), "12 hidden cells left out");
    row("vtu, with a line", ".vtu",
        replaced(
            replaced(replaced(replaced(xml("UnstructuredGrid", false), "NumberOfCells=\"12\"", "NumberOfCells=\"13\""),
                              "36 </Data", "36 38 </Data"),
                     "5 </Data", "5 3 </Data"),
            "</DataArray><DataArray type=\"Int64\" Name=\"offsets\"",
            "0 1 </DataArray><DataArray type=\"Int64\" Name=\"offsets\""),
        "vertices and lines left out: 1");
    row("vtk, hidden cells", ".vtk", legacyHidden(false), "12 hidden cells left out");
    row("vtk grid, hidden cells", ".vtk", legacyHidden(true), "12 hidden cells left out");
    row("vtk grid", ".vtk", grid());
    row("vtk grid of polygons", ".vtk", grid("7"));
    row("vtk grid, CR", ".vtk", replaced(grid(), "\n", "\r"));
    row("vtk, unused NaN", ".vtk",
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 9 float\n" + vertices(kA, "") +
            "nan 0 -1.#INF\nPOLYGONS 12 48\n" + faces(0, "3 "),
        "1 vertex without finite");
    row("vtk grid, unused NaN", ".vtk",
        replaced(replaced(grid(), "POINTS 8", "POINTS 9"), "CELLS", "nan nan nan\nCELLS"), "1 vertex without finite");
    row("vtk grid with a line", ".vtk",
        replaced(replaced(replaced(grid(), "CELLS 12 48", "CELLS 13 51"), "CELL_TYPES 12\n", "2 0 1\nCELL_TYPES 13\n"),
                 "CELL_TYPES 13\n", "CELL_TYPES 13\n") +
            "3\n",
        "vertices and lines left out: 1");
    row("vtk, two corners", ".vtk",
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 9 float\n" + vertices(kA, "") +
            "nan 0 0\nPOLYGONS 13 51\n2 0 1\n" + faces(0, "3 ") + "\x1a",
        "1 face of fewer than 3 corners");
}

void ReportedFiles::opensAsTheBox()
{
    QFETCH(std::string, name);
    QFETCH(std::string, bytes);
    QFETCH(std::string, note);
    const test::Folder folder;
    const auto file = meshio::readMesh(folder.write(name, bytes));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QCOMPARE(file.value().structures.size(), std::size_t{1});
    verifyBox(file.value().structures[0].mesh, kA);
    QVERIFY2(note.empty() ? file.value().notes.empty() : hasNote(file.value().notes, note),
             core::joined(file.value().notes).english().c_str());
    QVERIFY(file.value().loss.isEmpty());
    for (const core::Message& one : file.value().notes) {
        QCOMPARE(std::ranges::count_if(file.value().notes,
                                       [&](const core::Message& other) { return other.english() == one.english(); }),
                 std::ptrdiff_t{1});
    }
}

void ReportedFiles::twoPartsStayTwo_data()
{
    QTest::addColumn<std::string>("name");
    QTest::addColumn<std::string>("bytes");
    QTest::addColumn<std::vector<std::string>>("names");
    const auto row = [](const char* title, const char* name, const std::string& bytes, const char* a, const char* b) {
        QTest::newRow(title) << std::string(name) << bytes << std::vector<std::string>{a, b};
    };
    row("solids of one name", "box.stl",
        "solid ascii\n" + facets() + "endsolid ascii\nsolid ascii\n" + facets(kB) + "endsolid ascii\n", "ascii",
        "ascii 2");
    row("solids without names", "box.stl", "solid\n" + facets() + "endsolid\nsolid\n" + facets(kB) + "endsolid\n",
        "box", "box 2");
    row("solids named at the end", "box.stl",
        "solid\n" + facets() + "endsolid a\nsolid\n" + facets(kB) + "endsolid b\n", "a", "b");
    row("a solid without an end", "box.stl", "solid a\n" + facets() + "solid b\n" + facets(kB) + "endsolid b\n", "a",
        "b");
    row("solids on one line", "box.stl",
        replaced("solid my a\n" + facets() + "endsolid my a\nsolid b\n" + facets(kB) + "endsolid b\n", "\n", " "),
        "my a", "b");
    row("objects of one name", "box.obj", "o part\n" + vertices() + faces() + "o part\n" + vertices(kB) + faces(9),
        "part", "part 2");
    row("groups of one name", "box.obj", "g part\n" + vertices() + faces() + "g part\n" + vertices(kB) + faces(9),
        "part", "part 2");
    row("groups of VTK's exporter", "box.obj", vertices() + "g grp0\n" + faces() + vertices(kB) + "g grp1\n" + faces(9),
        "part 0", "part 1");
    row("materials", "box.obj", vertices() + vertices(kB) + "usemtl Liver\n" + faces() + "usemtl Spleen\n" + faces(9),
        "Liver", "Spleen");
    for (const char* group : {"g", "g ", "g default", "g Default", "o", "o default"}) {
        QTest::addRow("materials in %s", group) << std::string("box.obj")
                                                << std::string(group) + "\nusemtl Liver\n" + vertices() + faces() +
                                                       group + "\nusemtl Spleen\n" + vertices(kB) + faces(9)
                                                << std::vector<std::string>{"Liver", "Spleen"};
    }
    row("materials in default groups of an object", "box.obj",
        "o Body\ng default\nusemtl Liver\n" + vertices() + faces() + "g default\nusemtl Spleen\n" + vertices(kB) +
            faces(9),
        "Liver", "Spleen");
    row("groups without names", "box.obj", "g\n" + vertices() + faces() + "g\n" + vertices(kB) + faces(9), "box",
        "box 2");
    row("a group and the default one", "box.obj",
        "g default\nusemtl red\n" + vertices() + faces() + "g Liver\nusemtl blue\n" + vertices(kB) + faces(9), "box",
        "Liver");
    row("named groups in objects without names", "box.obj",
        "o\ng Liver\n" + vertices() + faces() + "o\ng Spleen\n" + vertices(kB) + faces(9), "Liver", "Spleen");
}

void ReportedFiles::twoPartsStayTwo()
{
    QFETCH(std::string, name);
    QFETCH(std::string, bytes);
    QFETCH(std::vector<std::string>, names);
    const test::Folder folder;
    const auto file = meshio::readMesh(folder.write(name, bytes));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QCOMPARE(file.value().structures.size(), std::size_t{2});
    for (std::size_t i = 0; i < 2; ++i) {
        QCOMPARE(file.value().structures[i].name, names[i]);
        verifyBox(file.value().structures[i].mesh, i == 0 ? kA : kB);
    }
}

void ReportedFiles::usedVertexMustBeFinite_data()
{
    QTest::addColumn<std::string>("name");
    QTest::addColumn<std::string>("bytes");
    const std::string x = "10 20 30";
    QTest::newRow("obj") << std::string("a.obj") << replaced(vertices() + faces(), x, "nan 20 30");
    QTest::newRow("obj, faces first") << std::string("a.obj") << replaced(faces() + vertices(), x, "10 -nan(ind) 30");
    QTest::newRow("obj, -1.#INF") << std::string("a.obj") << replaced(vertices() + faces(), x, "-1.#INF 20 30");
    QTest::newRow("vtp, 1.#INF") << std::string("a.vtp") << replaced(xml("PolyData", false), x, "1.#INF 20 30");
    QTest::newRow("vtp, 1e999") << std::string("a.vtp") << replaced(xml("PolyData", false), x, "1e999 20 30");
    QTest::newRow("ply") << std::string("a.ply")
                         << replaced(plyHeader(8, 12) + vertices(kA, "") + faces(0, "3 "), x, "10 inf 30");
    QTest::newRow("vtp") << std::string("a.vtp") << replaced(xml("PolyData", false), x, "10 20 nan");
    QTest::newRow("vtu") << std::string("a.vtu") << replaced(xml("UnstructuredGrid", false), x, "10 20 nan");
    QTest::newRow("vtk") << std::string("a.vtk") << replaced(grid(), x, "10 20 nan");
}

void ReportedFiles::usedVertexMustBeFinite()
{
    QFETCH(std::string, name);
    QFETCH(std::string, bytes);
    const test::Folder folder;
    const auto file = meshio::readMesh(folder.write(name, bytes));
    QCOMPARE(file.status().code(), core::StatusCode::NonFinite);
    QVERIFY2(file.status().message().find("finite coordinates") != std::string::npos, file.status().message().c_str());
}

void ReportedFiles::refusalsNameTheNextStep_data()
{
    QTest::addColumn<std::string>("name");
    QTest::addColumn<std::string>("bytes");
    QTest::addColumn<std::vector<std::string>>("words");
    const auto row = [](const char* title, const char* name, const std::string& bytes, std::vector<std::string> found) {
        QTest::newRow(title) << std::string(name) << bytes << std::move(found);
    };
    row("cut off", "a.stl", binary().substr(0, 84 + 520), {"cut off", "--partial opens the first 10 of 12 triangles"});
    // Whole facets that form a closed surface: a second surface may be missing.
    row("cut off behind a surface", "a.stl", binary(13), {"cut off", "--partial opens the first 12 of 13 triangles"});
    row("a vast count", "a.stl", binary(0x7fffffffU), {"cut off", "--partial opens the first 12 of 2,147,483,647"});
    row("text in place of an STL", "a.stl", "STL will follow next week. " + std::string(200, '.'),
        {"a text without the facets of an STL", "\"facet\""});
    row("ascii stl on one line, cut off", "a.stl",
        replaced("solid a\n" + facets().substr(0, facets().rfind("outer")), "\n", " "),
        {"line 1: the file ends after 11 complete triangles", "--partial opens the complete triangles"});
    row("ascii stl with comments above, cut off", "a.stl",
        "# x\nsolid a\n" + facets().substr(0, facets().rfind("outer")),
        {"the file ends after 11 complete triangles", "--partial opens the complete triangles"});
    row("UTF-16 and raw data", "a.vtp", utf16("<VTKFile type=\"PolyData\"><AppendedData encoding=\"raw\">_", false),
        {"UTF-16", "raw", "UTF-8"});
    row("obj points", "a.obj", vertices(), {"point cloud", "MeshLab: Screened Poisson"});
    row("ply points", "a.ply",
        replaced(plyHeader(8, 0), "element face 0\nproperty list uchar int vertex_indices\n", "") + vertices(kA, ""),
        {"point cloud", "MeshLab: Screened Poisson"});
    row("vtk points", "a.vtk",
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 8 float\n" + vertices(kA, ""), {"point cloud"});
    row("tetrahedra", "a.vtk", grid("10"), {"type 10", "ParaView: Extract Surface"});
    row("tetrahedra, vtu", "a.vtu", replaced(xml("UnstructuredGrid", false), "5 5 5", "10 10 10"),
        {"type 10", "ParaView: Extract Surface"});
    const std::string dicom = std::string(128, '\0') + "DICM\x02";
    row("DICOM", "a.dcm", dicom, {"is a DICOM image", "3D Slicer", ".seg.nrrd", "TotalSegmentator"});
    row("DICOM without an extension", "IM0001", dicom, {"is a DICOM image", "3D Slicer"});
    row("DICOM without the free bytes", "IM0002", "DICM", {"is a DICOM image", "3D Slicer"});
    row("DICOM by its name", "old.DCM", std::string("\x08\x00\x05\x00", 4), {"is a DICOM image", "3D Slicer"});
    row("glTF", "a.glb", "glTF\x02 and more", {"glTF", "MeshLab or Blender"});
    row("glTF as text", "a.gltf", "{\n  \"asset\": {\"version\": \"2.0\"}\n}\n", {"glTF", "MeshLab or Blender"});
    row("Slicer scene", "a.xml", "<?xml version=\"1.0\"?>\n<MRML version=\"Slicer5\"></MRML>", {"3D Slicer", "models"});
    const auto vtk = [](const std::string& type) {
        return "<?xml version=\"1.0\"?>\n<VTKFile header_type=\"UInt32\" type=\"" + type + "\" version=\"1.0\"/>";
    };
    row("VTI", "a.vti", vtk("ImageData"), {"a volume of VTK", "maps.md"});
    row("structured points", "a.vtk",
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n",
        {"STRUCTURED_POINTS", "maps.md"});
    row("parallel VTP", "a.pvtp", vtk("PPolyData"), {".pvtp", "the .vtp files that it names"});
    row("parallel VTU", "a.pvtu", vtk("PUnstructuredGrid"), {".pvtu", "the .vtu files that it names"});
    row("partitioned", "a.vtpd", vtk("vtkPartitionedDataSet"), {".vtpd", ".vtm"});
    const std::string mgh =
        std::string("\0\0\0\1\0\0\1\0\0\0\1\0\0\0\1\0\0\0\0\1\0\0\0\0", 24) + std::string(300, '\0');
    row("FreeSurfer's volume", "a.mgh", mgh, {"FreeSurfer", "mri_convert", ".nii.gz"});
    row("AppleDouble", "._a.stl", std::string("\0\x05\x16\x07 and more", 13), {"macOS"});
}

void ReportedFiles::refusalsNameTheNextStep()
{
    QFETCH(std::string, name);
    QFETCH(std::string, bytes);
    QFETCH(std::vector<std::string>, words);
    const test::Folder folder;
    const auto file = meshio::readMesh(folder.write(name, bytes));
    QVERIFY(!file.isOk());
    for (const std::string& word : words) {
        QVERIFY2(file.status().message().find(word) != std::string::npos, file.status().message().c_str());
    }
}

void ReportedFiles::folderOfDicomIsNamed()
{
    const test::Folder folder;
    std::filesystem::create_directories(folder.path("study/series"));
    QVERIFY(meshio::dicomFolder(folder.path("study")).isOk());
    folder.write("study/README", "text");
    QVERIFY(meshio::dicomFolder(folder.path("study")).isOk());
    const auto file = folder.write("study/series/IM0001", std::string(128, '\0') + "DICM\x02");
    QVERIFY(meshio::dicomFolder(file).isOk()); // the file reports itself
    for (const char* name : {"study", "study/"}) {
        const core::Status status = meshio::dicomFolder(folder.path(name));
        QCOMPARE(status.code(), core::StatusCode::Unsupported);
        QVERIFY2(status.message().starts_with("study: is a folder of DICOM images") &&
                     status.message().find("3D Slicer") != std::string::npos,
                 status.message().c_str());
    }
}

void ReportedFiles::cutOffStlOpensInPart()
{
    const test::Folder folder;
    meshio::ReadOptions options;
    options.isPartial = true;
    for (const std::string& bytes :
         {binary().substr(0, 84 + 520), ("solid a\n" + facets()).substr(0, facets().rfind("outer"))}) {
        const auto file = meshio::readMesh(folder.write("a.stl", bytes), options);
        QVERIFY2(file.isOk(), file.status().message().c_str());
        QVERIFY(test::triangles(file.value()) == (bytes.starts_with("solid") ? 11U : 10U));
        QVERIFY(!file.value().loss.isEmpty());
    }
}

void ReportedFiles::stlColours()
{
    const test::Folder folder;
    const auto colourOf = [&](const std::string& bytes) {
        const auto file = meshio::readMesh(folder.write("a.stl", bytes));
        return file.isOk() ? file.value().structures[0].colour : std::nullopt;
    };
    const std::string magics("COLOR=\xc8\x32\x32\xff", 10);
    const auto half = [](int i) { return static_cast<std::uint16_t>(i < 6 ? 0x8000 : 0x001f); };
    QVERIFY(colourOf(binary(12, magics, half)) == Colour({200 / 255.0, 50 / 255.0, 50 / 255.0}));
    const auto noted = meshio::readMesh(folder.write("b.stl", binary(12, magics, half)));
    QVERIFY(hasNote(noted.value().notes, "colours not read: those of 6"));
    // All facets have a colour of their own, red; in VisCAM's order of bits the same bits are blue.
    QVERIFY(colourOf(binary(12, magics, [](int) { return std::uint16_t{0x001f}; })) == Colour({1, 0, 0}));
    QVERIFY(colourOf(binary(12, "viscam", [](int) { return std::uint16_t{0x801f}; })) == Colour({0, 0, 1}));
    QVERIFY(!colourOf(binary()));
    QVERIFY(!colourOf(binary(12, "a count", [](int) { return std::uint16_t{7}; })));
}

void ReportedFiles::materialColours()
{
    const test::Folder folder;
    const std::string obj = "mtllib C:\\anatomy\\my colours.mtl\r\n" + vertices() + vertices(kB) + "usemtl Liver\n" +
                            faces() + "usemtl Spleen\n" + faces(9);
    const auto path = folder.write("a.obj", obj);
    const auto without = meshio::readMesh(path);
    QVERIFY2(without.isOk(), without.status().message().c_str());
    QVERIFY(!without.value().structures[0].colour && hasNote(without.value().notes, "colours not read"));
    folder.write("my colours.mtl", "newmtl Liver\nKd 0.8 0.2 0.2\nnewmtl Spleen\nKa 1 1 1\nKd 0.5 0.1 0.4\nd 0.5\n");
    const auto file = meshio::readMesh(path);
    QCOMPARE(file.value().structures.size(), std::size_t{2});
    QVERIFY(file.value().structures[0].colour == Colour({0.8, 0.2, 0.2}));
    QVERIFY(file.value().structures[1].colour == Colour({0.5, 0.1, 0.4}));
    QVERIFY2(file.value().notes.empty(), core::joined(file.value().notes).english().c_str());
    // Colours out of range and broken numbers are left out.
    folder.write("my colours.mtl", "newmtl Liver\nKd 2 0 0\nnewmtl Spleen\nKd x 0 0\nKd 0.5\n");
    const auto broken = meshio::readMesh(path);
    QVERIFY(!broken.value().structures[0].colour && !broken.value().structures[1].colour);
}

void ReportedFiles::slicersColoursAreThirds()
{
    const test::Folder folder;
    folder.write("a.mtl", "newmtl mtl0\nKa 0.2 0.1 0.3\nKd 0.2 0.1 0.3\nKs 0.2 0.1 0.3\n");
    const auto file = meshio::readMesh(folder.write("a.obj", "# 3D Slicer output. SPACE=LPS\nmtllib a.mtl\n" +
                                                                 vertices() + "g grp0\nusemtl mtl0\n" + faces()));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    const Colour colour = file.value().structures[0].colour.value_or(Colour{});
    QVERIFY(std::abs(colour[0] - 0.6) < 1e-12 && std::abs(colour[1] - 0.3) < 1e-12 &&
            std::abs(colour[2] - 0.9) < 1e-12);
    QCOMPARE(file.value().structures[0].name, std::string("part 0"));
    for (const auto& [line, opacity] : {std::pair("d 0.25", 0.25), std::pair("Tr 0.25", 0.75), std::pair("d 0", 1.0),
                                        std::pair("d 7", 1.0), std::pair("d", 1.0)}) {
        folder.write("a.mtl", std::string("newmtl mtl0\n") + line + "\nKd 0.2 0.1 0.3\n");
        const auto scene = meshio::loadScene(folder.path("a.obj"));
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        QCOMPARE(scene.value().structures[0].description.opacity, opacity);
    }
}

void ReportedFiles::namesBecomeUtf8()
{
    const test::Folder folder;
    const auto file = meshio::readMesh(folder.write("a.obj", vertices() + vertices(kB) +
                                                                 "g Nebenniere_gr\xf6\xdf"
                                                                 "e\n" +
                                                                 faces() + "g Milz_ä \x80\n" + faces(9)));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QCOMPARE(file.value().structures[0].name, std::string("Nebenniere_größe"));
    // As a whole the second name is no UTF-8: Windows-1252.
    QCOMPARE(file.value().structures[1].name, std::string("Milz_Ã¤ €"));
}

void ReportedFiles::blockFilesNameStructures()
{
    const test::Folder folder;
    folder.write("a.vtp", xml("PolyData", false));
    folder.write("b.obj", vertices(kB) + faces());
    const std::string begin = "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\"><vtkMultiBlockDataSet>";
    const std::string end = "</vtkMultiBlockDataSet></VTKFile>";
    const auto scene = meshio::loadScene(
        folder.write("s.vtm", begin +
                                  "<Block name=\"liver\"><DataSet index=\"0\" file=\"a.vtp\"/></Block>"
                                  "<DataSet name=\"spleen\" file=\"b.obj\"/>" +
                                  end));
    QVERIFY2(scene.isOk(), scene.status().message().c_str());
    QCOMPARE(scene.value().structures.size(), std::size_t{2});
    QCOMPARE(scene.value().structures[0].description.name, std::string("liver"));
    QCOMPARE(scene.value().structures[1].description.name, std::string("spleen"));
    QVERIFY(scene.value().losses.empty());
    const std::string collection = "<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"0\" file=\"a.vtp\"/>"
                                   "<DataSet timestep=\"STEP\" part=\"1\" file=\"b.obj\"/></Collection></VTKFile>";
    const auto one = meshio::loadScene(folder.write("s.pvd", replaced(collection, "STEP", "0")));
    QVERIFY2(one.isOk(), one.status().message().c_str());
    QCOMPARE(one.value().structures.size(), std::size_t{2});
    // Block files may name others, with separators of Windows, and have empty blocks.
    const auto outer = [&](const char* name, const std::string& blocks) {
        return meshio::loadScene(folder.write(name, begin + blocks + end));
    };
    std::filesystem::create_directory(folder.path("in"));
    folder.write("in/a.vtp", xml("PolyData", false));
    folder.write("in/b.vtp", xml("PolyData", false));
    folder.write("in/in.vtm", begin + "<DataSet file=\"a.vtp\"/><DataSet name=\"own\" file=\"b.vtp\"/>" + end);
    const auto nested =
        outer("o.vtm", "<DataSet name=\"x\" file=\"in\\in.vtm\"/><DataSet index=\"1\"/><Block index=\"2\"/>"
                       "<DataSet name=\"x\" file=\"b.obj\"/>");
    QVERIFY2(nested.isOk(), nested.status().message().c_str());
    QCOMPARE(nested.value().structures.size(), std::size_t{3});
    QCOMPARE(nested.value().structures[0].description.name, std::string("x"));
    QCOMPARE(nested.value().structures[1].description.name, std::string("own"));
    QCOMPARE(nested.value().structures[2].description.name, std::string("x 2"));
    QVERIFY(nested.value().losses.empty());
    const auto endless = outer("e.vtm", "<DataSet file=\"e.vtm\"/><DataSet name=\"liver\" file=\"a.vtp\"/>");
    QVERIFY2(endless.isOk(), endless.status().message().c_str());
    QCOMPARE(endless.value().structures.size(), std::size_t{1});
    std::string itself;
    for (int i = 0; i < 64; ++i) {
        itself += "<DataSet file=\"m.vtm\"/>";
    }
    QVERIFY(!outer("m.vtm", itself).isOk());
    folder.write("l0.vtm", begin + "<DataSet file=\"a.vtp\"/>" + end);
    for (int level = 1; level < 12; ++level) {
        folder.write("l" + std::to_string(level) + ".vtm", begin + "<DataSet file=\"l" + std::to_string(level - 1) +
                                                               ".vtm\"/><DataSet file=\"b.obj\"/>" + end);
    }
    const auto deep = meshio::loadScene(folder.path("l11.vtm"));
    QVERIFY2(deep.isOk(), deep.status().message().c_str());
    QVERIFY(test::mentions(deep.value().losses, "a file in more than 8 levels"));
    const auto parts = meshio::loadScene(folder.write(
        "p.vtpd", "<VTKFile><vtkPartitionedDataSetCollection><Partitions name=\"liver\"><DataSet index=\"0\" "
                  "file=\"a.vtp\"/></Partitions></vtkPartitionedDataSetCollection></VTKFile>"));
    QVERIFY2(parts.isOk(), parts.status().message().c_str());
    QCOMPARE(parts.value().structures[0].description.name, std::string("liver"));
    const auto series = meshio::loadScene(folder.write("s.pvd", replaced(collection, "STEP", "1")));
    QVERIFY(!series.isOk() && series.status().message().find("2 time steps") != std::string::npos);
}

void ReportedFiles::blockFilesStayInTheirFolder()
{
    const test::Folder folder;
    for (const char* name : {"../a.vtp", "/etc/passwd", "a/../../b.vtp", "..\\a.vtp"}) {
        const auto scene = meshio::loadScene(
            folder.write("s.vtm", "<VTKFile><DataSet file=\"" + std::string(name) + "\"/></VTKFile>"));
        QVERIFY(!scene.isOk());
        QVERIFY2(scene.status().message().find("in this folder") != std::string::npos,
                 scene.status().message().c_str());
    }
    QVERIFY(!meshio::loadScene(folder.write("s.vtm", "<VTKFile><DataSet")).isOk());
    QVERIFY(!meshio::loadScene(folder.write("s.vtm", "<VTKFile/>")).isOk());
    QVERIFY(!meshio::loadScene(folder.write("s.vtm", "<VTKFile><DataSet file=\"\"/></VTKFile>")).isOk());
}

void ReportedFiles::foldersSkipHiddenFiles()
{
    const test::Folder folder;
    std::filesystem::create_directories(folder.path("case/inner/deepest"));
    folder.write("case/liver.stl", binary());
    folder.write("case/._liver.stl", std::string("\0\x05\x16\x07", 4));
    folder.write("case/inner/spleen.obj", vertices(kB) + faces());
    folder.write("case/inner/deepest/kidney.obj", vertices(kB) + faces());
    const auto scene = meshio::loadScene(folder.path("case"));
    QVERIFY2(scene.isOk(), scene.status().message().c_str());
    QVERIFY(scene.value().losses.empty());
    QCOMPARE(scene.value().structures.size(), std::size_t{2}); // one level down
    QCOMPARE(scene.value().structures[0].description.name, std::string("liver"));
    QCOMPARE(scene.value().structures[1].description.name, std::string("spleen"));
}

void ReportedFiles::commonPrefixIsNotShown()
{
    const test::Folder folder;
    for (const char* name : {"seg/Segmentation_1_liver.stl", "seg/Segmentation_1_spleen.stl", "lungs/lung_left.stl",
                             "lungs/lung_right.stl"}) {
        std::filesystem::create_directories(folder.path(name).parent_path());
        folder.write(name, binary());
    }
    const auto seg = meshio::loadScene(folder.path("seg"));
    QVERIFY2(seg.isOk(), seg.status().message().c_str());
    QCOMPARE(seg.value().structures[0].description.name, std::string("liver"));
    QCOMPARE(seg.value().structures[1].description.name, std::string("spleen"));
    QCOMPARE(seg.value().structures[1].description.mesh.filename(), std::filesystem::path("Segmentation_1_spleen.stl"));
    const auto lungs = meshio::loadScene(folder.path("lungs"));
    QCOMPARE(lungs.value().structures[0].description.name, std::string("lung_left"));
}

void ReportedFiles::sharedFilesGiveTheRightAnswer()
{
    PALPATE_SHARED_OR_SKIP(folder, "reports");
    const char* any = nullptr;
    const std::vector<Reported> rows{
        {"02_padded_to_1024.stl", {any}, "left out"},
        {"02_count_zero.stl", {any}, "the size of the file says 12"},
        {"03_end_solid.stl", {any}, nullptr},
        {"03_endsolid_glued_name.stl", {"AssimpScene"}, nullptr},
        {"03_no_endsolid.stl", {any}, "missing"},
        {"03_solid_twice.stl", {"M"}, nullptr},
        {"04_ctrl_z.stl", {any}, nullptr},
        {"04_nul_tail.obj", {any}, nullptr},
        {"04_cr_lines.obj", {any}, nullptr},
        {"04_newline_after_body.ply", {any}, nullptr},
        {"05_comment_backslash_vertex.obj", {any}, nullptr},
        {"05_comment_backslash_face.obj", {any}, nullptr},
        {"06_unused_nan.ply", {any}, "1 vertex without finite coordinates"},
        {"06_unused_nan_ind.obj", {any}, "1 vertex without finite coordinates"},
        {"07_two_corners.obj", {any}, "1 face of fewer than 3 corners left out"},
        {"07_two_corners.ply", {any}, "1 face of fewer than 3 corners left out"},
        {"07_two_corners.vtp", {any}, "1 face of fewer than 3 corners left out"},
        {"08_more_on_a_line.ply", {any}, "more numbers"},
        {"08_stray_header_line.ply", {any}, nullptr},
        {"09_tristrips.ply", {any}, nullptr},
        {"10_empty_piece.vtp", {any}, nullptr},
        {"10_ghost_hidden.vtp", {any}, "12 hidden cells left out"},
        {"11_latin1_names.obj", {"Nebenniere_größe", "Milz_ä"}, nullptr},
        {"12_two_solids_one_name.stl", {"ascii", "ascii 2"}, nullptr},
        {"13_magics_colours.stl", {any}, "colours not read"},
        {"14_materials_only.obj", {"Liver", "Spleen"}, nullptr},
        {"15_triangle_grid.vtk", {any}, nullptr},
        {"15_utf16.obj", {any}, nullptr},
        {"17_names/hip_left.stl", {"hip_left"}, nullptr},
    };
    for (const Reported& row : rows) {
        const auto file = meshio::readMesh(folder / row.file);
        QVERIFY2(file.isOk(), file.status().message().c_str());
        const auto& structures = file.value().structures;
        QVERIFY2(structures.size() == row.names.size(), row.file);
        for (std::size_t i = 0; i < structures.size(); ++i) {
            verifyBox(structures[i].mesh, i == 0 ? kA : kB);
            QVERIFY2(row.names[i] == nullptr || structures[i].name == row.names[i], structures[i].name.c_str());
        }
        QVERIFY2(row.note == nullptr || hasNote(file.value().notes, row.note),
                 core::joined(file.value().notes).english().c_str());
        if (QTest::currentTestFailed()) {
            QFAIL(row.file);
        }
    }
    const auto colour = [&](const char* file, std::size_t i) {
        return meshio::readMesh(folder / file).value().structures[i].colour;
    };
    QVERIFY(colour("13_magics_colours.stl", 0) == Colour({200 / 255.0, 50 / 255.0, 50 / 255.0}));
    QVERIFY(colour("14_materials_only.obj", 0) == Colour({0.8, 0.2, 0.2}));
    QVERIFY(colour("14_materials_only.obj", 1) == Colour({0.5, 0.1, 0.4}));

    const auto donut = meshio::readMesh(folder / "02_one_byte_more.stl");
    QVERIFY2(donut.isOk(), donut.status().message().c_str());
    const geometry::TriangleMesh& mesh = donut.value().structures[0].mesh;
    QCOMPARE(mesh.triangles.size(), std::size_t{288});
    QVERIFY((mesh.bounds().sizes() - Vec3(3, 0.5, 3)).norm() < 1e-5);
    QVERIFY((mesh.bounds().center() - Vec3(1.5, 0.25, 1.5)).norm() < 1e-5);
    QVERIFY(std::abs(test::area(mesh) - 15.773) < 5e-4 && std::abs(volumeOf(mesh) - 2.34315) < 5e-6);
    QVERIFY(hasNote(donut.value().notes, "1 byte"));

    // Inside out: as it is, and turned.
    for (const bool isTurned : {false, true}) {
        meshio::ReadOptions options;
        options.turnsOutwards = isTurned;
        const auto scene = meshio::loadScene(folder / "01_inside_out.stl", options);
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        const geometry::TriangleMesh& box = scene.value().structures[0].surface->mesh;
        QVERIFY(std::abs(volumeOf(box) - (isTurned ? 24000.0 : -24000.0)) < 1e-6);
    }
    for (const auto& [path, first, second] :
         {std::tuple("15_scene.vtm", "liver", "spleen"), std::tuple("16_mac_folder", "liver", "spleen")}) {
        const auto scene = meshio::loadScene(folder / path);
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        QVERIFY(scene.value().losses.empty());
        QCOMPARE(scene.value().structures.size(), std::size_t{2});
        verifyBox(scene.value().structures[0].surface->mesh, kA);
        verifyBox(scene.value().structures[1].surface->mesh, kB);
        QCOMPARE(scene.value().structures[0].description.name, std::string(first));
        QCOMPARE(scene.value().structures[1].description.name, std::string(second));
    }
}

PALPATE_TEST(ReportedFiles)
#include "tst_ReportedFiles.moc"
