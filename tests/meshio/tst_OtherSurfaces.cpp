// SPDX-License-Identifier: BSD-3-Clause
// Formats that meshio reads itself, OFF, MNI, FreeSurfer and GIFTI, and meshes packed by gzip.
#include "OtherSurfaces.h"
#include "TestRunner.h"

#include <cmath>

using namespace palpate;
using core::Vec3;
using meshio::FileFrame;
using test::Gifti;

namespace {

double enclosed_mm3(const geometry::TriangleMesh& mesh)
{
    double sum = 0.0;
    for (const geometry::Triangle& t : mesh.triangles) {
        sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
    }
    return sum;
}

/// The transform to scanner coordinates that FreeSurfer writes.
std::string toScanner(const std::string& from = "NIFTI_XFORM_UNKNOWN", const std::string& last = "-3")
{
    return "<CoordinateSystemTransformMatrix><DataSpace><![CDATA[" + from +
           "]]></DataSpace><TransformedSpace><![CDATA[NIFTI_XFORM_SCANNER_ANAT]]></TransformedSpace><MatrixData>1 0 0 "
           "1 "
           "0 1 0 2 0 0 1 " +
           last + " 0 0 0 1</MatrixData></CoordinateSystemTransformMatrix>";
}

std::string withWord(std::string text, const std::string& word, const std::string& other)
{
    const std::size_t at = text.find(word);
    return at == std::string::npos ? std::string() : text.replace(at, word.size(), other);
}

std::string cut(const std::string& bytes, std::size_t fewer)
{
    return bytes.substr(0, bytes.size() - fewer);
}

} // namespace

class OtherSurfaces : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void opensTheBox_data();
    void opensTheBox();
    void refuses_data();
    void refuses();
    void cutAnywhereIsRefused_data();
    void cutAnywhereIsRefused();
    void packedFilesKeepTheirNames();
};

void OtherSurfaces::opensTheBox_data()
{
    QTest::addColumn<std::string>("name");
    QTest::addColumn<std::string>("bytes");
    QTest::addColumn<std::string>("format");
    QTest::addColumn<bool>("isRas");
    QTest::addColumn<Vec3>("shift_mm"); // in the axes of the file
    QTest::addColumn<std::string>("note");
    const auto row = [](const char* title, const char* name, const std::string& bytes, const char* format, bool isRas,
                        const Vec3& shift_mm = Vec3::Zero(), const char* note = "") {
        QTest::newRow(title) << std::string(name) << bytes << std::string(format) << isRas << shift_mm
                             << std::string(note);
    };
    const std::string off = test::offBox(), points = test::rowsOf(test::kBoxPoints);
    row("off", "a.off", off, "OFF", false);
    row("off, counts on the first line, no edges", "a.off", withWord(off, "OFF\n8 12 0", "# b\n\nOFF 8 12"), "OFF",
        false);
    row("off, CR LF and comments", "a.off", withWord(off, "50 20 30\n", "50 20 30 # c\r\n\r\n#\r\n"), "OFF", false);
    row("off, colours", "a.off", withWord(withWord(off, "OFF", "COFF"), "0 3 2\n", "0 3 2 255 0 0\n"), "OFF", false,
        Vec3::Zero(), "colours, normals and further numbers");
    row("off, unused vertex without place", "a.off",
        "OFF\n9 12 0\n" + points + "nan nan nan\n" + off.substr(11 + points.size()), "OFF", false, Vec3::Zero(),
        "1 vertex without finite coordinates left out");
    row("off, face of two corners", "a.off", withWord(off, "8 12 0", "8 13 0") + "2 0 1\n", "OFF", false, Vec3::Zero(),
        "1 face of fewer than 3 corners left out");
    row("off, quadrangle", "a.off", withWord(withWord(off, "8 12 0", "8 11 0"), "3 0 3 2\n3 0 2 1\n", "4 0 3 2 1\n"),
        "OFF", false);
    row("off as .stl", "a.stl", off, "OFF", false);
    row("mni", "a.obj", test::mniBox(), "MNI OBJ", true);
    row("mni, colours of the polygons", "a.obj",
        withWord(test::mniBox(), "0 1 1 1 1\n", "1 " + test::rowsOf(test::kBoxPoints) + test::rowsOf(test::kBoxPoints)),
        "MNI OBJ", true);
    row("freesurfer", "lh.pial", test::freeSurferBox(), "FreeSurfer", true);
    row("freesurfer, volume", "lh.pial", test::freeSurferBox() + test::freeSurferVolume(), "FreeSurfer", true,
        Vec3(1, 2, -3), "moved by the centre of its volume, (1, 2, -3) mm");
    row("freesurfer, invalid volume", "lh.pial", test::freeSurferBox() + test::freeSurferVolume("0"), "FreeSurfer",
        true);
    for (const auto& [title, kind] : {std::pair("gifti, text", Gifti::Ascii), std::pair("gifti, base64", Gifti::Base64),
                                      std::pair("gifti, packed", Gifti::Packed)}) {
        row(title, "a.surf.gii", test::giftiBox(kind), "GIFTI", true);
    }
    row("gifti, way to the scanner", "a.gii", test::giftiBox(Gifti::Packed, toScanner()), "GIFTI", true, Vec3(1, 2, -3),
        "moved to the coordinates of the scanner");
    row("gifti, already there", "a.gii", test::giftiBox(Gifti::Packed, toScanner("NIFTI_XFORM_SCANNER_ANAT")), "GIFTI",
        true);
    row("gifti, with values", "a.gii",
        test::giftiFile("<DataArray Intent=\"NIFTI_INTENT_SHAPE\"><Data>1 2</Data></DataArray>" +
                        test::giftiArray(Gifti::Ascii, true) + test::giftiArray(Gifti::Ascii, false)),
        "GIFTI", true);
    row("gifti, columns first", "a.gii",
        test::giftiFile(withWord(withWord(test::giftiArray(Gifti::Ascii, true), "RowMajor", "ColumnMajor"), points,
                                 "10 50 50 10 10 50 50 10 20 20 50 50 20 20 50 50 30 30 30 30 50 50 50 50") +
                        test::giftiArray(Gifti::Ascii, false)),
        "GIFTI", true);
    row("gzip", "a.off.gz", test::gzipped(off), "OFF", false);
    row("gzip of another name", "a.stl", test::gzipped(off), "OFF", false);
    row("gzip of gifti", "a.gii.gz", test::gzipped(test::giftiBox(Gifti::Ascii)), "GIFTI", true);
}

void OtherSurfaces::opensTheBox()
{
    QFETCH(std::string, name);
    QFETCH(std::string, bytes);
    QFETCH(std::string, format);
    QFETCH(bool, isRas);
    QFETCH(Vec3, shift_mm);
    QFETCH(std::string, note);
    const test::Folder folder;
    const auto file = meshio::readMesh(folder.write(name, bytes));
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QCOMPARE(file.value().format, format);
    QVERIFY(file.value().frame == (isRas ? FileFrame::Ras : FileFrame::Untagged));
    QCOMPARE(file.value().structures.size(), std::size_t{1});
    const geometry::TriangleMesh& mesh = file.value().structures[0].mesh;
    QCOMPARE(mesh.triangles.size(), std::size_t{12});
    const Vec3 low = Vec3(10, 20, 30) + shift_mm, high = Vec3(50, 50, 50) + shift_mm;
    QVERIFY(mesh.bounds().min() == (isRas ? Vec3(-high.x(), -high.y(), low.z()) : low));
    QVERIFY(mesh.bounds().max() == (isRas ? Vec3(-low.x(), -low.y(), high.z()) : high));
    QVERIFY(std::abs(enclosed_mm3(mesh) - 24000.0) < 1e-6);
    std::string notes;
    for (const core::Message& line : file.value().notes) {
        notes += line.english() + "\n";
    }
    QVERIFY2(note.empty() ? notes.empty() : notes.find(note) != std::string::npos, notes.c_str());
    QCOMPARE(file.value().structures[0].name, name == "lh.pial" ? std::string("lh.pial") : std::string("a"));
}

void OtherSurfaces::refuses_data()
{
    QTest::addColumn<std::string>("name");
    QTest::addColumn<std::string>("bytes");
    QTest::addColumn<std::string>("words");
    const auto row = [](const char* title, const char* name, const std::string& bytes, const char* words) {
        QVERIFY(!bytes.empty());
        QTest::newRow(title) << std::string(name) << bytes << std::string(words);
    };
    const std::string off = test::offBox(), mni = test::mniBox(), surface = test::freeSurferBox();
    row("off, binary", "a.off", "OFF BINARY\n" + std::string(40, '\1'), "four dimensions, or binary");
    row("off, four coordinates", "a.off", "4OFF\n8 12 0\n", "four dimensions, or binary");
    row("off, many vertices", "a.off", test::offBox("100000000 12 0"), "declares 100,000,000 vertices and 12 faces");
    row("off, many faces", "a.off", test::offBox("8 9223372036854775807 0"), "the OFF file declares");
    row("off, negative count", "a.off", test::offBox("8 -12 0"), "\"-12\" is not a count");
    row("off, too few faces", "a.off", test::offBox("8 13 0"), "the file ends");
    row("off, more faces than declared", "a.off", test::offBox("8 11 0"), "behind the last face");
    row("off, index beyond", "a.off", withWord(off, "3 0 3 2", "3 0 3 8"), "polygon 0: it uses point 8");
    row("off, negative index", "a.off", withWord(off, "3 0 3 2", "3 0 3 -1"), "polygon 0: it uses point -1");
    row("off, corners missing", "a.off", withWord(off, "3 0 3 2", "4 0 3 2"), "fewer corners than it declares");
    row("off, many corners", "a.off", withWord(off, "3 0 3 2", "1000000000 0 3 2"), "fewer corners");
    row("off, used vertex without place", "a.off", withWord(off, "50 20 30", "nan 20 30"), "not finite numbers");
    row("off, far away", "a.off", withWord(off, "50 20 30", "1e300 20 30"), "farther than 10 km");
    row("off, word", "a.off", withWord(off, "50 20 30", "50 b 30"), "\"b\" is not a number");
    row("off, points alone", "a.off", "OFF\n1 0 0\n0 0 0\n", "a point cloud");
    row("mni, many points", "a.obj", test::mniBox("100000"), "the MNI object has \"100000\" in place of a count");
    row("mni, many polygons", "a.obj", test::mniBox("8", "100000"),
        "the MNI object has \"100000\" in place of a count");
    row("mni, index beyond", "a.obj", withWord(mni, "\n0 3 2", "\n0 3 8"), "it uses point 8");
    row("mni, ends that fall", "a.obj", withWord(mni, "3 6 9", "3 6 5"), "below the one before");
    row("mni, cut off", "a.obj", cut(mni, 7), "in place of a count");
    row("mni, more behind", "a.obj", mni + "L 1", "behind the last polygon");
    row("freesurfer, many points", "lh.pial", test::freeSurferBox(0xffffffffU), "vertices and 12 triangles declared");
    row("freesurfer, many triangles", "lh.pial", test::freeSurferBox(8, 1000), "1,000 triangles declared");
    row("freesurfer, cut off", "lh.pial", cut(surface, 1), "12 triangles declared");
    row("freesurfer, index beyond", "lh.pial", cut(surface, 1) + "\x09", "it uses point 9");
    row("freesurfer, no counts", "lh.pial", surface.substr(0, 30), "the FreeSurfer surface ends in its header");
    row("freesurfer, quadrangles", "lh.orig", "\xff\xff\xff" + surface.substr(3), "quadrangles, or its values");
    const std::string gifti = test::giftiBox(Gifti::Packed);
    row("gifti, values", "a.gii", test::giftiFile("<DataArray Intent=\"NIFTI_INTENT_SHAPE\"/>"), "without a surface");
    row("gifti, cut off", "a.gii", cut(gifti, 4), "the XML is broken");
    row("gifti, many points", "a.gii",
        test::giftiFile(test::giftiArray(Gifti::Packed, true, "", "1000000000000") +
                        test::giftiArray(Gifti::Packed, false)),
        "an array of 1000000000000 × 3 numbers");
    row("gifti, one point more", "a.gii",
        test::giftiFile(test::giftiArray(Gifti::Packed, true, "", "9") + test::giftiArray(Gifti::Packed, false)),
        "cut off, damaged or too long");
    row("gifti, one point fewer", "a.gii",
        test::giftiFile(test::giftiArray(Gifti::Base64, true, "", "7") + test::giftiArray(Gifti::Base64, false)),
        "cut off, damaged or too long");
    row("gifti, text of other length", "a.gii",
        test::giftiFile(test::giftiArray(Gifti::Ascii, true, "", "9") + test::giftiArray(Gifti::Ascii, false)),
        "24 numbers");
    row("gifti, two surfaces", "a.gii",
        test::giftiFile(test::giftiArray(Gifti::Ascii, true) + test::giftiArray(Gifti::Ascii, true)), "a second array");
    row("gifti, numbers elsewhere", "a.gii", withWord(gifti, "GZipBase64Binary", "ExternalFileBinary"),
        "ExternalFileBinary");
    row("gifti, no base64", "a.gii", withWord(gifti, "<Data>", "<Data>%"), "not base64");
    row("gifti, transform without numbers", "a.gii",
        test::giftiBox(Gifti::Ascii, toScanner("NIFTI_XFORM_UNKNOWN", "x")), "without 16 finite numbers");
    row("gifti, entities", "a.gii",
        "<?xml version=\"1.0\"?><!DOCTYPE GIFTI [<!ENTITY a \"aaaaaaaaaa\">]><GIFTI>&a;</GIFTI>", "");
    const std::string packed = test::gzipped(off);
    row("gzip, cut off", "a.off.gz", cut(packed, 9), "; expected ");
    row("gzip, wrong size", "a.off.gz", cut(packed, 4) + std::string("\1\0\0\0", 4), "more than 1 bytes when unpacked");
    row("gzip, impossible size", "a.off.gz", cut(packed, 4) + "\xff\xff\xff\xff", "4,294,967,295 bytes when unpacked");
    row("gzip, damaged", "a.off.gz", cut(packed, 8) + "1234" + packed.substr(packed.size() - 4), "cut off or damaged");
    row("gzip, more behind", "a.off.gz", packed + packed, "more than");
    row("gzip of zeros", "a.stl.gz", test::gzipped(std::string(10'000'000, '\0')), "at most 100 times the size");
    row("gzip of no mesh", "a.gz", test::gzipped("hello, hello"), "no known mesh format");
    row("gzip of gzip", "a.gz", test::gzipped(packed), "no known mesh format");
}

void OtherSurfaces::refuses()
{
    QFETCH(std::string, name);
    QFETCH(std::string, bytes);
    QFETCH(std::string, words);
    const test::Folder folder;
    const auto file = meshio::readMesh(folder.write(name, bytes));
    QVERIFY(!file.isOk());
    const std::string& message = file.status().message();
    QVERIFY2(message.starts_with(name + ": ") && message.find("; expected ") != std::string::npos, message.c_str());
    QVERIFY2(message.find(words) != std::string::npos && message.find('\n') == std::string::npos, message.c_str());
}

void OtherSurfaces::cutAnywhereIsRefused_data()
{
    QTest::addColumn<std::string>("name");
    QTest::addColumn<std::string>("bytes");
    QTest::newRow("off") << std::string("a.off") << test::offBox();
    QTest::newRow("mni") << std::string("a.obj") << test::mniBox();
    QTest::newRow("freesurfer") << std::string("lh.pial") << test::freeSurferBox();
    QTest::newRow("gifti") << std::string("a.gii") << test::giftiBox(Gifti::Packed);
    QTest::newRow("gzip") << std::string("a.stl.gz") << test::gzipped(test::offBox());
}

void OtherSurfaces::cutAnywhereIsRefused()
{
    QFETCH(std::string, name);
    QFETCH(std::string, bytes);
    const test::Folder folder;
    constexpr std::size_t kLastDigits = 3; // a number that loses a digit, or the end of the line, is a number
    for (std::size_t size = 0; size + kLastDigits < bytes.size(); ++size) {
        const auto file = meshio::readMesh(folder.write(name, bytes.substr(0, size)));
        QVERIFY2(!file.isOk(), std::to_string(size).c_str());
        QVERIFY(file.status().message().starts_with(name + ": "));
    }
}

void OtherSurfaces::packedFilesKeepTheirNames()
{
    const test::Folder folder;
    for (const char* name : {"liver.off.gz", "spleen.OFF.GZ"}) {
        (void)folder.write(name, test::gzipped(test::offBox()));
    }
    const auto scene = meshio::loadScene(folder.path(""));
    QVERIFY2(scene.isOk(), scene.status().message().c_str());
    QCOMPARE(scene.value().structures.size(), std::size_t{2});
    QCOMPARE(scene.value().structures[0].description.name, std::string("liver"));
    QCOMPARE(scene.value().structures[1].description.name, std::string("spleen"));
}

PALPATE_TEST(OtherSurfaces)
#include "tst_OtherSurfaces.moc"
