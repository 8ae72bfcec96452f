// SPDX-License-Identifier: BSD-3-Clause
// Tests volumes for maps, read in this process: every format gives the same values at the same positions, and invalid
// files are rejected.
#include "TestRunner.h"
#include "Volumes.h"
#include "read/VolumeFile.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

using namespace palpate;
using meshio::internal::readVolumeHere;
using meshio::internal::VoxelGrid;

namespace {

core::Result<VoxelGrid> readSample(const test::Folder& folder, const test::VolumeSample& sample)
{
    if (!sample.dataName.empty()) {
        (void)folder.write(sample.dataName, sample.data);
    }
    return readVolumeHere(folder.write(sample.name, sample.bytes), core::FileFrame::Untagged, {});
}

bool isWhole(const VoxelGrid& grid)
{
    bool isRight = grid.size == std::array<std::uint32_t, 3>{12, 3, 2} && grid.values.size() == 72;
    for (int n = 0; isRight && n < 72; ++n) {
        const int i = n % 12, j = n / 12 % 3, k = n / 36;
        isRight = grid.values[static_cast<std::size_t>(n)] == test::volumeValue(i, j, k) &&
                  (grid.toVoxel * test::volumePlace(i, j, k) - core::Vec3(i, j, k)).norm() < 1e-6;
    }
    return isRight;
}

} // namespace

class Volumes : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void everyFormSaysTheSame()
    {
        for (const test::VolumeSample& sample : test::volumeSamples()) {
            const test::Folder folder;
            const auto grid = readSample(folder, sample);
            QVERIFY2(grid.isOk(), grid.status().message().c_str());
            QVERIFY2(isWhole(grid.value()), sample.name.c_str());
        }
    }

    void aFileForEachSliceSaysTheSame()
    {
        const std::string floats = test::volumeNumbers();
        const std::string list = "LIST\nfirst.raw\nsecond.raw\n";
        const test::Folder folder;
        (void)folder.write("first.raw", floats.substr(0, floats.size() / 2));
        (void)folder.write("second.raw", floats.substr(floats.size() / 2));
        const std::string meta = test::metaHeader("MET_FLOAT", list);
        for (const test::VolumeSample& sample :
             {test::VolumeSample{"list.nhdr", test::nrrdHeader("raw", "data file: " + list)},
              test::VolumeSample{"list.mhd", meta}}) {
            const auto grid = readSample(folder, sample);
            QVERIFY2(grid.isOk(), grid.status().message().c_str());
            QVERIFY2(isWhole(grid.value()), sample.name.c_str());
        }
        (void)folder.write("second.raw", floats.substr(0, 10));
        const auto cut = readSample(folder, {"list.mhd", meta});
        QVERIFY(!cut.isOk());
        QCOMPARE(cut.status().message(),
                 std::string("list.mhd: 72 voxels declared; expected as many as its 154 bytes can hold"));
    }

    void whatIsCutShortIsRefused()
    {
        for (const test::VolumeSample& sample : test::volumeSamples()) {
            const bool isBeside = !sample.dataName.empty();
            const std::size_t size = isBeside ? sample.data.size() : sample.bytes.size();
            for (std::size_t kept = 0; kept < size; ++kept) {
                const test::Folder folder;
                test::VolumeSample cut = sample;
                (isBeside ? cut.data : cut.bytes).resize(kept);
                const auto grid = readSample(folder, cut);
                // Some losses are harmless: the end of an XML text, gzip's checksum.
                QVERIFY2(!grid.isOk() || isWhole(grid.value()),
                         (sample.name + " cut at " + std::to_string(kept) + " of " + std::to_string(size)).c_str());
                if (!grid.isOk()) {
                    const std::string& said = grid.status().message();
                    QVERIFY2(said.starts_with(sample.name + ": ") && said.find("; expected ") != std::string::npos &&
                                 said.find('\n') == std::string::npos,
                             said.c_str());
                }
            }
        }
    }

    void whatIsWrongIsRefused_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* what, const char* name, const std::string& bytes, const char* said) {
            QTest::newRow(what) << QString(name) << QByteArray::fromStdString(bytes) << QString(said);
        };
        const std::string floats = test::volumeNumbers();
        const auto meta = [&floats](const std::string& from, const std::string& to) {
            std::string text = test::metaHeader("MET_FLOAT", "LOCAL");
            return text.replace(text.find(from), from.size(), to) + floats;
        };
        const auto nifti = [&floats](std::size_t at, auto value) {
            std::string text = test::niftiHeader();
            std::memcpy(&text[at], &value, sizeof(value));
            return text + floats;
        };
        row("more voxels than bytes", "v.mha", meta("DimSize = 12 3 2", "DimSize = 12 3 3"),
            "v.mha: 108 voxels declared; expected as many as its 288 bytes can hold");
        row("a product beyond 32 bits", "v.mha", meta("DimSize = 12 3 2", "DimSize = 65536 65536 2"),
            "v.mha: 8,589,934,592 voxels declared");
        row("a product beyond 64 bits", "v.mha", meta("DimSize = 12 3 2", "DimSize = 2000000000 2000000000 2000000000"),
            "v.mha: 1,000,000,000,000,000,000 voxels declared");
        row("no voxel along an axis", "v.mha", meta("DimSize = 12 3 2", "DimSize = 12 0 2"), "v.mha: ");
        row("less than none", "v.mha", meta("DimSize = 12 3 2", "DimSize = 12 -3 2"), "v.mha: ");
        row("a distance of 0", "v.mha", meta("ElementSpacing = 1 2 3", "ElementSpacing = 1 0 3"), "v.mha: ");
        row("a distance that is no number", "v.mha", meta("ElementSpacing = 1 2 3", "ElementSpacing = 1 nan 3"),
            "v.mha: ");
        row("axes in a plane", "v.mha", meta("1 0 0 0 1 0 0 0 1", "1 0 0 0 1 0 1 1 0"),
            "v.mha: header: unreadable directions of its axes");
        row("three numbers a voxel", "v.mha",
            meta("ElementType = MET_FLOAT", "ElementNumberOfChannels = 3\nElementType = MET_FLOAT") + floats + floats,
            "v.mha: 3 components per voxel; expected one number for each voxel");
        row("a header without an end", "v.mha", "ObjectType = Image\nNDims = 3\n", "v.mha: header: it has no end");
        row("packed, and too few", "v.mha",
            test::metaHeader("MET_FLOAT", "LOCAL", "CompressedData = True\n") + test::zlibbed(floats.substr(0, 100)),
            "v.mha: 100 bytes when unpacked; expected 288 bytes of voxels");
        row("packed, and broken", "v.mha",
            test::metaHeader("MET_FLOAT", "LOCAL", "CompressedData = True\n") + std::string(200, 'x'),
            "v.mha: its compressed voxels are cut off or broken");
        row("NRRD, a header without an end", "v.nrrd", "NRRD0004\ntype: float\ndimension: 3\n",
            "v.nrrd: header: it has no end");
        row("NRRD, text", "v.nrrd", test::nrrdHeader("ascii") + "1 2 3",
            "v.nrrd: header: voxels in another encoding; expected `raw` or `gzip`");
        row("NRRD, packed, and too few", "v.nrrd", test::nrrdHeader("gzip") + test::gzipped(floats.substr(0, 100)),
            "v.nrrd: ");
        row("NIfTI, packed, and too few", "v.nii.gz", test::gzipped(test::niftiHeader() + floats.substr(0, 100)),
            "v.nii.gz: ");
        row("NIfTI, more voxels than bytes", "v.nii", nifti(42, std::int16_t{32767}), "v.nii: ");
        row("NIfTI, less than none", "v.nii", nifti(44, std::int16_t{-3}), "v.nii: ");
        row("NIfTI, a matrix in a plane", "v.nii", nifti(320, 0.0F), "v.nii: ");
        row("NIfTI, a matrix of no numbers", "v.nii", nifti(280, std::nanf("")), "v.nii: ");
        // Findings of fuzzing: VTK's readers loop for ever or crash.
        const auto nrrd = [&floats](const std::string& from, const std::string& to) {
            std::string text = test::nrrdHeader("raw");
            return text.replace(text.find(from), from.size(), to) + floats;
        };
        const auto vti = [](const std::string& from, const std::string& to) {
            std::string text = test::vtiText("1 2 3");
            return text.replace(text.find(from), from.size(), to);
        };
        row("dimensions beyond counting", "v.mha", meta("NDims = 3", "NDims = 1e308"),
            "v.mha: header: NDims: not a digit; expected 1 to 4");
        row("NRRD, a 0 in its header", "v.nrrd", nrrd("kinds", std::string("ki\0ds", 5)),
            "v.nrrd: header: a byte of 0 in its text");
        row("NRRD, an end of another kind", "v.nrrd", "NRRD0004\ndimension: 3\nElementDataFile =\n" + floats,
            "v.nrrd: ");
        row("NRRD, a size that is no number", "v.nrrd", nrrd("sizes: 12", "sizes: 1e308"),
            "v.nrrd: header: sizes: \"1e308 3 2\"; expected three numbers of voxels");
        row("NRRD, a dimension that is no number", "v.nrrd", nrrd("dimension: 3", "dimension: three"),
            "v.nrrd: header: dimension: \"three\"; expected 3");
        row("NRRD, a field twice", "v.nrrd", nrrd("endian: little", "endian: little\nsizes: 9 9 9"),
            "v.nrrd: header: \"sizes\" twice; expected each field once");
        row("NRRD, a pattern", "v.nrrd", nrrd("endian: little", "endian: little\ndata file: %s%n 1 9 0"),
            "v.nrrd: header: data file: \"%s%n 1 9 0\"; expected the name of one file");
        row("NRRD, the name of a data file twice", "v.nrrd",
            nrrd("endian: little", "endian: little\ndata file: a\ndatafile: b"),
            "v.nrrd: header: both \"data file\" and \"datafile\"; expected one of the two");
        row("MetaImage, text", "v.mha", meta("BinaryData = True", "BinaryData = False"),
            "v.mha: header: voxels in another encoding; expected `BinaryData = True`");
        row("MetaImage, a long word", "v.mha", meta("NDims", "NDims = 3\n" + std::string(300, 'x')),
            "v.mha: header: a line of 304 characters; expected at most 254");
        row("NRRD, a blank line that is not empty", "v.nrrd",
            test::nrrdHeader("raw").substr(0, test::nrrdHeader("raw").size() - 1) + " \n" + floats.substr(0, 8),
            "v.nrrd: header: it has no end");
        row("NRRD, an empty list", "v.nhdr", test::nrrdHeader("raw", "data file: LIST\n"),
            "v.nhdr: header: the file of its voxels: an empty LIST");
        row("NRRD, a list of files that are not there", "v.nhdr", test::nrrdHeader("raw", "data file: LIST\na\nb\n"),
            "v.nhdr: header: the file of its voxels: no file \"a\"; expected this file in the folder of the header");
        row("NRRD, a list of compressed files", "v.nhdr", test::nrrdHeader("gzip", "data file: LIST\na\nb\n"),
            "v.nhdr: header: the file of its voxels: a LIST of compressed files");
        row("a file that is not there", "v.mhd", test::metaHeader("MET_FLOAT", "beside.raw"),
            "v.mhd: header: the file of its voxels: no file \"beside.raw\"; expected this file in the folder of the "
            "header");
        row("a pattern", "v.mhd", test::metaHeader("MET_FLOAT", "slice%d.raw 0 1 0"),
            "v.mhd: header: the file of its voxels: \"slice%d.raw 0 1 0\"; expected the name of one file");
        row("an empty line before the file", "v.mha", meta("ElementDataFile", "\nElementDataFile = z%d\n#"),
            "v.mha: header: the file of its voxels: \"z%d\"");
        row("NIfTI, a word of another header", "v.nii",
            std::string(nifti(42, std::int16_t{8195})) + "\ndata file: a\n\n", "v.nii: 49,170 voxels declared");
        row("VTI, an XML error of two lines", "v.vti", vti("<Piece", "<Pi\nece\n&#0;"), "v.vti: line ");
        row("NRRD, a word with a control character", "v.nrrd", nrrd("encoding: raw", "encoding: gzip\x02z"),
            "v.nrrd: ");
        row("NIfTI, a kind beyond the table", "v.nii", nifti(70, std::int16_t{16400}),
            "v.nii: header: voxels of type 16400; expected a type of the NIfTI format");
        row("NIfTI, packed, a kind beyond the table", "v.nii.gz", test::gzipped(nifti(70, std::int16_t{16400})),
            "v.nii.gz: header: voxels of type 16400");
        row("NIfTI, many numbers a voxel", "v.nii", test::niftiWideHeader(832586256) + floats,
            "v.nii: 832586256 components per voxel; expected one number for each voxel");
        row("NIfTI-2, a count beyond 32 bits", "v.nii", test::niftiWideHeader(1, (std::int64_t{1} << 32) + 12) + floats,
            "v.nii: header: 4294967308 voxels along axis 1; expected 1 to 2147483647");
        row("NIfTI-2, less than none", "v.nii", test::niftiWideHeader(1, -12) + floats,
            "v.nii: header: -12 voxels along axis 1; expected 1 to 2147483647");
        const char* beyond = "v.vti: line 5: an array with more numbers than its file can hold; expected values "
                             "of NumberOfComponents and NumberOfTuples that match the data";
        row("VTI, many numbers a voxel", "v.vti", vti("Name=", "NumberOfComponents=\"200000000\" Name="), beyond);
        row("VTI, many numbers of each cell", "v.vti",
            vti("</PointData>", "</PointData><CellData><DataArray type=\"Int8\" Name=\"t\" "
                                "NumberOfComponents=\"200000000\"/></CellData>"),
            beyond);
        row("VTI, many numbers of a field", "v.vti",
            vti("<PointData", "<FieldData><DataArray type=\"Int8\" Name=\"t\" NumberOfTuples=\"2000000000\"/>"
                              "</FieldData><PointData"),
            beyond);
        row("VTI, less than no number", "v.vti", vti("Name=", "NumberOfComponents=\"-1\" Name="), beyond);
        std::string arrays;
        for (int n = 0; n < 200; ++n) {
            arrays += "<DataArray type=\"Int8\" Name=\"t" + std::to_string(n) + "\" NumberOfComponents=\"1000\"/>";
        }
        row("VTI, many arrays", "v.vti", vti("</PointData>", arrays + "</PointData>"),
            "v.vti: 72 voxels declared; expected as many as its ");
        row("VTI, a document type", "v.vti", vti("<VTKFile", "<!DOCTYPE VTKFile>\n<VTKFile"),
            "v.vti: line 2: a document type or an entity; expected a VTI file without these");
        row("VTI, fewer numbers than voxels", "v.vti", test::vtiText("1 2 3"), "v.vti: ");
        row("VTI, a vast extent", "v.vti", test::vtiText("1 2 3", "0 2000000000 0 2000000000 0 2000000000"),
            "v.vti: 1,000,000,000,000,000,000 voxels declared");
        row("VTI, a bomb", "v.vti", test::vtiText("1 2 3", "0 999 0 999 0 999"),
            "v.vti: 1,000,000,000 voxels declared");
        row("VTI, fewer numbers behind it", "v.vti", test::vtiAppended(floats.substr(0, 100)), "v.vti: ");
        row("VTI, no image", "v.vti", "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\"></VTKFile>", "v.vti: ");
        row("VTI, cut off", "v.vti", test::vtiText("1 2 3").substr(0, 300),
            "v.vti: it does not end with its last tag; expected `</VTKFile>` at the end");
        std::string flat = test::vtiAppended(floats);
        row("VTI, a distance of 0", "v.vti", flat.replace(flat.find("1 2 3"), 5, "1 0 3"),
            "v.vti: axes or spacings of its voxels that do not define positions");
        row("nothing", "v.vti", "", "v.vti: ");
    }
    void whatIsWrongIsRefused()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QFETCH(QString, said);
        const test::Folder folder;
        const auto grid = readSample(folder, {name.toStdString(), bytes.toStdString()});
        QVERIFY(!grid.isOk());
        const std::string& message = grid.status().message();
        QVERIFY2(QString::fromStdString(message).startsWith(said), message.c_str());
        QVERIFY2(message.find("; expected ") != std::string::npos, message.c_str());
        QVERIFY(
            std::none_of(message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }));
    }

    void whatIsNoNumberIsKept()
    {
        const test::Folder folder;
        std::string bytes = test::metaHeader("MET_FLOAT", "LOCAL") + test::volumeNumbers();
        const float kNot = std::nanf("");
        std::memcpy(&bytes[bytes.size() - sizeof(float)], &kNot, sizeof(kNot));
        const auto grid = readSample(folder, {"v.mha", bytes});
        QVERIFY2(grid.isOk(), grid.status().message().c_str());
        QVERIFY(std::isnan(grid.value().values.back()));
        QCOMPARE(grid.value().values[70], test::volumeValue(10, 2, 1));
    }
};

PALPATE_TEST(Volumes)
#include "tst_Volumes.moc"
