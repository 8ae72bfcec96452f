// SPDX-License-Identifier: BSD-3-Clause
// Tests volumes for maps, read in this process: every format gives the same values at the same positions, and invalid
// files are rejected.
#include "MemoryLimit.h"
#include "TestRunner.h"
#include "Volumes.h"
#include "read/FieldFile.h"
#include "read/VolumeFile.h"

#include <palpate/meshio/MeshFile.h>

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataWriter.h>

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
              test::VolumeSample{"named.nhdr", test::nrrdHeader("raw", "Data File: " + list)},
              test::VolumeSample{"list2.mhd", test::metaHeader("MET_FLOAT", "LIST 2\nfirst.raw\nsecond.raw\n")},
              test::VolumeSample{"list.mhd", meta}}) {
            const auto grid = readSample(folder, sample);
            QVERIFY2(grid.isOk(), grid.status().message().c_str());
            QVERIFY2(isWhole(grid.value()), sample.name.c_str());
        }
        // Files of other lengths would shift the voxels behind them, even if the sum is right.
        (void)folder.write("first.raw", floats.substr(0, floats.size() / 2 + 4));
        (void)folder.write("second.raw", floats.substr(floats.size() / 2 + 4));
        const auto shifted = readSample(folder, {"list.mhd", meta});
        QVERIFY(!shifted.isOk());
        QCOMPARE(
            shifted.status().message(),
            std::string("list.mhd: header: file of the voxels: \"first.raw\" with 148 bytes of voxels; expected 144 in "
                        "each of 2 files"));
    }

    void whatIsCutShortIsRefused()
    {
        for (const test::VolumeSample& sample : test::volumeSamples()) {
            const bool isBeside = !sample.dataName.empty();
            const std::size_t size = isBeside ? sample.data.size() : sample.bytes.size();
            const test::Folder folder;
            for (std::size_t kept = 0; kept < size; ++kept) {
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
            "v.mha: header: 65,536 × 65,536 × 2 voxels; expected 1 to 1,073,741,824 voxels");
        row("a product beyond 64 bits", "v.mha", meta("DimSize = 12 3 2", "DimSize = 2000000000 2000000000 2000000000"),
            "v.mha: header: DimSize: \"2000000000 2000000000 2000000000\"; expected a count from 1 to 1,073,741,824 "
            "for "
            "each of 3 axes");
        row("no voxel along an axis", "v.mha", meta("DimSize = 12 3 2", "DimSize = 12 0 2"), "v.mha: ");
        row("less than none", "v.mha", meta("DimSize = 12 3 2", "DimSize = 12 -3 2"), "v.mha: ");
        row("a distance of 0", "v.mha", meta("ElementSpacing = 1 2 3", "ElementSpacing = 1 0 3"), "v.mha: ");
        row("a distance that is no number", "v.mha", meta("ElementSpacing = 1 2 3", "ElementSpacing = 1 nan 3"),
            "v.mha: ");
        row("axes in a plane", "v.mha", meta("1 0 0 0 1 0 0 0 1", "1 0 0 0 1 0 1 1 0"),
            "v.mha: header: axes that lie in one plane; expected three axes that are not in one plane");
        row("three numbers a voxel", "v.mha",
            meta("ElementType = MET_FLOAT", "ElementNumberOfChannels = 3\nElementType = MET_FLOAT") + floats + floats,
            "v.mha: 3 components per voxel; expected one number for each voxel");
        row("a header without an end", "v.mha", "ObjectType = Image\nNDims = 3\n",
            "v.mha: header: the header does not end; expected a line with ElementDataFile");
        row("packed, and too few", "v.mha",
            test::metaHeader("MET_FLOAT", "LOCAL", "CompressedData = True\n") + test::zlibbed(floats.substr(0, 100)),
            "v.mha: 100 of 288 bytes of voxels; expected all");
        row("packed, and broken", "v.mha",
            test::metaHeader("MET_FLOAT", "LOCAL", "CompressedData = True\n") + std::string(200, 'x'),
            "v.mha: 0 of 288 bytes of voxels; expected compressed data that are complete and undamaged");
        row("NRRD, a header without an end", "v.nrrd", "NRRD0004\ntype: float\ndimension: 3\n",
            "v.nrrd: line 3: the header does not end; expected an empty line after it");
        row("NRRD, text", "v.nrrd", test::nrrdHeader("ascii") + "1 2 3",
            "v.nrrd: header: encoding: \"ascii\"; expected \"raw\" or \"gzip\"");
        row("NRRD, packed, and too few", "v.nrrd", test::nrrdHeader("gzip") + test::gzipped(floats.substr(0, 100)),
            "v.nrrd: ");
        row("NIfTI, packed, and too few", "v.nii.gz", test::gzipped(test::niftiHeader() + floats.substr(0, 100)),
            "v.nii.gz: ");
        row("NIfTI, more voxels than bytes", "v.nii", nifti(42, std::int16_t{32767}), "v.nii: ");
        row("NIfTI, less than none", "v.nii", nifti(44, std::int16_t{-3}), "v.nii: ");
        row("NIfTI, a matrix in a plane", "v.nii", nifti(320, 0.0F), "v.nii: ");
        row("NIfTI, a matrix of no numbers", "v.nii", nifti(280, std::nanf("")), "v.nii: ");
        // Findings of fuzzing: VTK's readers of these formats loop for ever or crash.
        const auto nrrd = [&floats](const std::string& from, const std::string& to) {
            std::string text = test::nrrdHeader("raw");
            return text.replace(text.find(from), from.size(), to) + floats;
        };
        const auto vti = [](const std::string& from, const std::string& to) {
            std::string text = test::vtiText("1 2 3");
            return text.replace(text.find(from), from.size(), to);
        };
        row("dimensions beyond counting", "v.mha", meta("NDims = 3", "NDims = 1e308"),
            "v.mha: header: NDims: \"1e308\"; expected 3 or 4");
        row("NRRD, a 0 in its header", "v.nrrd", nrrd("kinds", std::string("ki\0ds", 5)),
            "v.nrrd: line 7: a byte of 0 in the header; expected text");
        row("NRRD, an end of another kind", "v.nrrd", "NRRD0004\ndimension: 3\nElementDataFile =\n" + floats,
            "v.nrrd: ");
        row("NRRD, a size that is no number", "v.nrrd", nrrd("sizes: 12", "sizes: 1e308"),
            "v.nrrd: header: sizes: \"1e308 3 2\"; expected a count from 1 to 1,073,741,824 for each of 3 axes");
        row("NRRD, a dimension that is no number", "v.nrrd", nrrd("dimension: 3", "dimension: three"),
            "v.nrrd: header: dimension: \"three\"; expected 3 or 4");
        row("NRRD, a field twice", "v.nrrd", nrrd("endian: little", "endian: little\nsizes: 9 9 9"),
            "v.nrrd: line 9: \"sizes\" a second time; expected each field once");
        row("NRRD, a pattern", "v.nrrd", nrrd("endian: little", "endian: little\ndata file: %s%n 1 9 0"),
            "v.nrrd: header: data file: \"%s%n 1 9 0\"; expected the name of one file");
        row("NRRD, the name of a data file twice", "v.nrrd",
            nrrd("endian: little", "endian: little\ndata file: a\ndatafile: b"),
            "v.nrrd: line 10: \"datafile\" a second time; expected each field once");
        row("MetaImage, text", "v.mha", meta("BinaryData = True", "BinaryData = False"),
            "v.mha: header: BinaryData: \"False\"; expected True: voxels as binary numbers");
        row("MetaImage, a key in another spelling", "v.mha",
            meta("ElementType = MET_FLOAT", "ElemenTNumberOfChannels = 3\nElementType = MET_LONG_LONG"),
            "v.mha: 72 voxels declared; expected as many as its 288 bytes can hold");
        row("MetaImage, the end before other keys", "v.mha",
            meta("BinaryData =", "ElementDataFile = LOCAL\nBinaryData ="),
            "v.mha: header: DimSize: \"\"; expected a count from 1 to 1,073,741,824 for each of 3 axes");
        row("MetaImage, a key cut in the middle", "v.mha",
            meta("TransformMatrix", "ElementDataFilTransformMatrix = 0.9440003\xff\r\rD`Size = 6 5 4\nNDims"),
            "v.mha: line 8: \"NDims\" a second time; expected each field once");
        row("MetaImage, a header in the voxels", "v.mha", meta("Element", "HeaderSize = 20\nElement"),
            "v.mha: header: HeaderSize: \"20\"; expected 0, or the bytes before uncompressed voxels, or -1");
        row("MetaImage, an endless header", "v.mha", meta("Element", "HeaderSize = 99999999999\nElement"),
            "v.mha: 72 voxels declared; expected as many as its 0 bytes can hold");
        row("NRRD, less than no bytes to skip", "v.nrrd", nrrd("kinds", "byte skip: -2\nkinds"),
            "v.nrrd: header: byte skip: \"-2\"; expected 0, or the bytes before uncompressed voxels, or -1");
        row("NRRD, a blank line that is not empty", "v.nrrd",
            test::nrrdHeader("raw").substr(0, test::nrrdHeader("raw").size() - 1) + " \n" + floats.substr(0, 8),
            "v.nrrd: line 11: \" \"; expected a field and its value");
        row("NRRD, an empty list", "v.nhdr", test::nrrdHeader("raw", "data file: LIST\n"),
            "v.nhdr: header: data file: \"LIST\"; expected one name on each line after LIST");
        row("NRRD, a list of files that are not there", "v.nhdr", test::nrrdHeader("raw", "data file: LIST\na\nb\n"),
            "v.nhdr: header: file of the voxels: no file \"a\"; expected a file in this folder or below it");
        row("NRRD, a list of compressed files", "v.nhdr", test::nrrdHeader("gzip", "data file: LIST\na\nb\n"),
            "v.nhdr: header: data file: \"LIST\"; expected one file, or uncompressed files in a LIST");
        row("a file that is not there", "v.mhd", test::metaHeader("MET_FLOAT", "beside.raw"),
            "v.mhd: header: file of the voxels: no file \"beside.raw\"; expected a file in this folder or below it");
        row("a file elsewhere", "v.mhd", test::metaHeader("MET_FLOAT", "../beside.raw"),
            "v.mhd: header: file of the voxels: \"../beside.raw\"; expected a file in this folder or below it");
        row("a pattern", "v.mhd", test::metaHeader("MET_FLOAT", "slice%d.raw 0 1 0"),
            "v.mhd: header: ElementDataFile: \"slice%d.raw 0 1 0\"; expected the name of one file");
        row("an empty line before the file", "v.mha", meta("ElementDataFile", "\nElementDataFile = z%d\n#"),
            "v.mha: header: ElementDataFile: \"z%d\"");
        row("NIfTI, a word of another header", "v.nii",
            std::string(nifti(42, std::int16_t{8195})) + "\ndata file: a\n\n", "v.nii: 49,170 voxels declared");
        row("VTI, an XML error of two lines", "v.vti", vti("<Piece", "<Pi\nece\n&#0;"), "v.vti: line ");
        row("NRRD, a word with a control character", "v.nrrd", nrrd("encoding: raw", "encoding: gzip\x02z"),
            "v.nrrd: ");
        row("NIfTI, a kind beyond the table", "v.nii", nifti(70, std::int16_t{16400}),
            "v.nii: header: datatype: 16400; expected one number for each voxel");
        row("NIfTI, packed, a kind beyond the table", "v.nii.gz", test::gzipped(nifti(70, std::int16_t{16400})),
            "v.nii.gz: header: datatype: 16400");
        row("NIfTI, many numbers a voxel", "v.nii", test::niftiWideHeader(832586256) + floats,
            "v.nii: header: 12 × 3 × 2 voxels with 832,586,256 numbers each; expected 1 to 1,073,741,824 voxels");
        row("NIfTI, a volume for each time", "v.nii", test::niftiWideHeader(2) + floats + floats,
            "v.nii: 2 components per voxel; expected one number for each voxel");
        row("NIfTI-2, a count beyond 32 bits", "v.nii", test::niftiWideHeader(1, (std::int64_t{1} << 32) + 12) + floats,
            "v.nii: header: dim: 4,294,967,308 voxels along axis 1; expected 1 to 1,073,741,824");
        row("NIfTI-2, less than none", "v.nii", test::niftiWideHeader(1, -12) + floats,
            "v.nii: header: dim: -12 voxels along axis 1; expected 1 to 1,073,741,824");
        row("VTI, many numbers a voxel", "v.vti", vti("Name=", "NumberOfComponents=\"200000000\" Name="),
            "v.vti: line 5: 200,000,000 components per voxel; expected one number for each voxel");
        row("VTI, less than no number", "v.vti", vti("Name=", "NumberOfComponents=\"-1\" Name="),
            "v.vti: line 5: found NumberOfComponents=\"-1\"; expected a whole number from 0");
        std::string arrays;
        for (int n = 0; n < 200; ++n) {
            arrays += "<DataArray type=\"Int8\" Name=\"t" + std::to_string(n) + "\" NumberOfComponents=\"1000\"/>";
        }
        row("VTI, many arrays", "v.vti", vti("</PointData>", arrays + "</PointData>"),
            "v.vti: line 5: 3 numbers for 72 voxels; expected one number for each voxel");
        row("VTI, arrays without a mark", "v.vti",
            vti("<PointData Scalars=\"s\">", "<PointData><DataArray type=\"Int8\" Name=\"t\"/>"),
            "v.vti: line 4: 2 arrays, none of them marked as the scalars; expected one number for each voxel");
        row("VTI, a piece of the whole", "v.vti",
            vti("<Piece Extent=\"0 11 0 2 0 1\"", "<Piece Extent=\"0 11 0 2 0 0\""),
            "v.vti: 36 numbers for 72 voxels; expected pieces that cover the whole extent");
        row("VTI, a piece beside the whole", "v.vti", vti("<Piece Extent=\"0 11 0 2", "<Piece Extent=\"0 11 1 3"),
            "v.vti: line 4: found Extent=\"0 11 1 3 0 1\"; expected a part of the whole, \"0 11 0 2 0 1\"");
        const auto appended = [&floats](const std::string& from, const std::string& to) {
            std::string text = test::vtiAppended(floats);
            return text.replace(text.find(from), from.size(), to);
        };
        row("VTI, lengths of another width", "v.vti", appended("byte_order", "header_type=\"UInt64\" byte_order"),
            "v.vti: line 5: array \"s\": size of its data");
        row("VTI, another begin", "v.vti", appended("offset=\"0\"", "offset=\"-4\""),
            "v.vti: line 5: found offset=\"-4\"; expected a whole number from 0");
        row("VTI, more numbers behind it", "v.vti", test::vtiAppended(floats + "1234"),
            "v.vti: line 5: array \"s\": 292 bytes; expected 288 bytes of voxels");
        for (const char* spacing : {"1 nan 3", "1 inf 3", "a b c", "1 2", "1 2 3 4"}) {
            row(spacing, "v.vti", vti("Spacing=\"1 2 3\"", std::string("Spacing=\"") + spacing + "\""),
                "v.vti: header: Spacing: \"");
        }
        row("VTI, an origin without an axis", "v.vti", vti("10 20 30", "10 20"),
            "v.vti: header: Origin: \"10 20\"; expected 3 finite numbers");
        row("VTI, directions of two axes", "v.vti", vti("Origin=", "Direction=\"1 0 0 0 1 0\" Origin="),
            "v.vti: header: Direction: \"1 0 0 0 1 0\"; expected 9 finite numbers");
        row("VTI, a document type", "v.vti", vti("<VTKFile", "<!DOCTYPE VTKFile>\n<VTKFile"),
            "v.vti: line 2: found a document type or an entity; expected a file without them");
        row("VTI, fewer numbers than voxels", "v.vti", test::vtiText("1 2 3"), "v.vti: ");
        row("VTI, a vast extent", "v.vti", test::vtiText("1 2 3", "0 2000000000 0 2000000000 0 2000000000"),
            "v.vti: header: WholeExtent: \"0 2000000000 0 2000000000 0 2000000000\"; expected the first and last");
        row("VTI, a bomb", "v.vti", test::vtiText("1 2 3", "0 999 0 999 0 999"),
            "v.vti: 1,000,000,000 voxels declared");
        row("VTI, fewer numbers behind it", "v.vti", test::vtiAppended(floats.substr(0, 100)), "v.vti: ");
        row("VTI, no image", "v.vti", "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\"></VTKFile>", "v.vti: ");
        row("VTI, cut off", "v.vti", test::vtiText("1 2 3").substr(0, 300),
            "v.vti: line 6: invalid XML: \"Premature end of document.\"");
        std::string flat = test::vtiAppended(floats);
        row("VTI, a distance of 0", "v.vti", flat.replace(flat.find("1 2 3"), 5, "1 0 3"),
            "v.vti: header: voxels of 1 × 0 × 3 mm; expected three axes that are not in one plane");
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

    /// Voxels that are only declared need no memory, whatever they are read for.
    void aSmallFileNeedsLittleMemory_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        const auto row = [](const char* what, const char* name, const std::string& bytes) {
            QTest::newRow(what) << QString(name) << QByteArray::fromStdString(bytes);
        };
        const auto meta = [](const char* sizes, const std::string& more) {
            std::string text = test::metaHeader("MET_FLOAT", "LOCAL", more);
            return text.replace(text.find("12 3 2"), 6, sizes) + test::volumeNumbers();
        };
        row("voxels", "v.mha", meta("1024 1024 1024", ""));
        row("layers", "v.mha", meta("1 1 1", "ElementNumberOfChannels = 1073741824\n"));
        row("vectors", "v.mha", meta("1024 1024 300", "ElementNumberOfChannels = 3\n"));
        std::string nrrd = test::nrrdHeader("raw");
        row("NRRD", "v.nrrd", nrrd.replace(nrrd.find("12 3 2"), 6, "1024 1024 1024") + test::volumeNumbers());
        row("NIfTI, layers", "v.nii", test::niftiWideHeader(std::int64_t{1} << 27, 1) + test::volumeNumbers());
    }
    void aSmallFileNeedsLittleMemory()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        const test::Folder folder;
        const std::filesystem::path path = folder.write(name.toStdString(), bytes.toStdString());
        std::vector<std::string> messages;
        {
            const test::MemoryLimit limit(rlim_t{256} << 20);
            QVERIFY(limit.isSet());
            messages = {readVolumeHere(path, core::FileFrame::Untagged, {}).status().message(),
                        meshio::internal::readFieldHere(path, core::FileFrame::Untagged, {}).status().message(),
                        meshio::readMesh(path).status().message()};
        }
        for (const std::string& message : messages) {
            QVERIFY2(message.find(" voxels declared; expected as many as its 288 bytes can hold") !=
                             std::string::npos ||
                         message.find("components per voxel; expected") != std::string::npos,
                     message.c_str());
        }
        QVERIFY2(messages[2].find(" voxels declared; ") != std::string::npos, messages[2].c_str());
    }

    void voxelsBehindOtherBytesAreFound()
    {
        const std::string floats = test::volumeNumbers(), other = "0123456789";
        const auto meta = [](const std::string& skip, const std::string& data) {
            return test::metaHeader("MET_FLOAT", data, "HeaderSize = " + skip + "\n");
        };
        const auto nrrd = [](const std::string& skip, const std::string& data) {
            return test::nrrdHeader("raw", data + "byte skip: " + skip + "\n");
        };
        for (const test::VolumeSample& sample : {
                 test::VolumeSample{"ten.mhd", meta("10", "v.raw"), "v.raw", other + floats},
                 test::VolumeSample{"end.mhd", meta("-1", "v.raw"), "v.raw", other + floats},
                 test::VolumeSample{"end.mha", meta("-1", "LOCAL") + other + floats},
                 test::VolumeSample{"ten.nhdr", nrrd("10", "data file: v.raw\n"), "v.raw", other + floats},
                 test::VolumeSample{"end.nhdr", nrrd("-1", "data file: v.raw\n"), "v.raw", other + floats},
                 test::VolumeSample{"ten.nrrd", nrrd("10", "") + other + floats},
                 test::VolumeSample{"end.nrrd", nrrd("-1", "") + other + floats},
             }) {
            const test::Folder folder;
            const auto grid = readSample(folder, sample);
            QVERIFY2(grid.isOk(), grid.status().message().c_str());
            QVERIFY2(isWhole(grid.value()), sample.name.c_str());
        }
        const test::Folder folder;
        for (const std::string skip : {"10", "-1"}) {
            const auto grid = readSample(folder, {"v.mhd", meta(skip, "v.raw"), "v.raw", other.substr(1) + floats});
            QCOMPARE(grid.isOk(), skip == "-1");
        }
    }

    void namesOfAnNrrdHaveManySpellings()
    {
        const std::string floats = test::volumeNumbers(), plain = test::nrrdHeader("raw");
        const auto changed = [&](const std::vector<std::pair<std::string, std::string>>& words) {
            std::string text = plain;
            for (const auto& [from, to] : words) {
                text.replace(text.find(from), from.size(), to);
            }
            return text + floats;
        };
        const test::Folder folder;
        int number = 0;
        for (const std::string& bytes :
             {changed({{"space directions", "Space Directions"}, {"space origin", "Space Origin"}}),
              changed({{"space directions", "spacedirections"}, {"space origin", "spaceorigin"}}),
              changed({{"space directions:", "space directions :"}, {"encoding: raw", "Encoding: RAW"}}),
              changed({{"type: float", "Type: Float"}, {"endian: little", "endian: Little"}}),
              changed({{"space: left-posterior-superior", "Space: Left Posterior Superior"}}),
              changed({{"space: left-posterior-superior", "space: LPS\nspaceunits: \"mm\" \"mm\" \"mm\""}}),
              changed({{"left-posterior-superior", "lps"}})}) {
            const auto grid = readSample(folder, {"v" + std::to_string(number++) + ".nrrd", bytes});
            QVERIFY2(grid.isOk(), grid.status().message().c_str());
            QVERIFY2(isWhole(grid.value()), bytes.substr(0, plain.size()).c_str());
        }
        for (const char* ras : {"RAS", "ras", "right anterior superior", "Right-Anterior-Superior"}) {
            const auto grid = readSample(folder, {"r.nrrd", changed({{"left-posterior-superior", ras}})});
            QVERIFY2(grid.isOk(), grid.status().message().c_str());
            const core::Vec3 p_W = test::volumePlace(4, 1, 1).cwiseProduct(core::Vec3(-1, -1, 1));
            QVERIFY((grid.value().toVoxel * p_W - core::Vec3(4, 1, 1)).norm() < 1e-9);
        }
    }

    void anNrrdWithoutASpaceHasSpacingsUnitsAndMinima()
    {
        const auto header = [](const std::string& more) {
            return "NRRD0004\ntype: float\ndimension: 3\nsizes: 12 3 2\nendian: little\nencoding: raw\n" + more + "\n" +
                   test::volumeNumbers();
        };
        const test::Folder folder;
        const std::string spacings = "spacings: 0.1 0.2 0.3\nunits: \"cm\" \"cm\" \"cm\"\n";
        const auto at = [&](const std::string& more) {
            const auto grid = readSample(folder, {"v.nrrd", header(more)});
            return grid.isOk() ? core::Vec3(grid.value().toVoxel.inverse() * core::Vec3(4, 1, 1)) : core::Vec3::Zero();
        };
        QVERIFY((at(spacings) - core::Vec3(4, 2, 3)).norm() < 1e-9);
        QVERIFY((at(spacings + "axis mins: 1 2 3\ncenters: node node node\n") - core::Vec3(14, 22, 33)).norm() < 1e-9);
        const std::string las = "space: left-anterior-superior\n", inCm = "space units: \"cm\" \"cm\" \"cm\"\n";
        QVERIFY((at(las + spacings + "axis mins: 1 2 3\ncenters: node node node\n") - core::Vec3(14, -22, 33)).norm() <
                1e-9);
        QVERIFY((at(spacings + inCm) - core::Vec3(4, 2, 3)).norm() < 1e-9); // not twice
        QVERIFY((at("spacings: 4 2 3\nunits: \"pixel\" \"mm\" \"\"\n") - core::Vec3(16, 2, 3)).norm() < 1e-9);
        QVERIFY((at(spacings + "axismins: 1 2 3\n") - core::Vec3(14.5, 23, 34.5)).norm() < 1e-9);
        for (const char* bad : {"spacings: 1 nan 3\n", "spacings: 1 2\n"}) {
            QVERIFY2(!readSample(folder, {"v.nrrd", header(bad)}).isOk(), bad);
        }
    }

    void everyVtiOfVtkSaysTheSame()
    {
        vtkNew<vtkImageData> image;
        image->SetExtent(5, 16, -2, 0, 7, 8);
        image->SetOrigin(5, 24, 9);
        image->SetSpacing(1, 2, 3);
        const test::Folder folder;
        int number = 0;
        for (const int type : {VTK_FLOAT, VTK_SHORT, VTK_UNSIGNED_CHAR, VTK_DOUBLE, VTK_LONG_LONG}) {
            image->AllocateScalars(type, 1);
            for (int n = 0; n < 72; ++n) {
                image->GetPointData()->GetScalars()->SetTuple1(n, test::volumeValue(n % 12, n / 12 % 3, n / 36));
            }
            for (const int compressor :
                 {vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA}) {
                constexpr int kEncoded = -1;
                for (const int mode :
                     std::array<int, 4>{vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended, kEncoded}) {
                    vtkNew<vtkXMLImageDataWriter> writer;
                    const std::filesystem::path path = folder.path("v" + std::to_string(number++) + ".vti");
                    writer->SetFileName(path.c_str());
                    writer->SetInputData(image);
                    writer->SetCompressorType(compressor);
                    writer->SetDataMode(mode == kEncoded ? static_cast<int>(vtkXMLWriter::Appended) : mode);
                    writer->SetEncodeAppendedData(mode == kEncoded ? 1 : 0);
                    writer->SetHeaderType(number % 2 == 0 ? vtkXMLWriter::UInt32 : vtkXMLWriter::UInt64);
                    writer->SetByteOrder(number % 3 == 0 ? vtkXMLWriter::BigEndian : vtkXMLWriter::LittleEndian);
                    writer->SetNumberOfPieces(number % 5 == 0 ? 2 : 1);
                    QCOMPARE(writer->Write(), 1);
                    const auto grid = readVolumeHere(path, core::FileFrame::Untagged, {});
                    QVERIFY2(grid.isOk(), grid.status().message().c_str());
                    QVERIFY2(type == VTK_UNSIGNED_CHAR || isWhole(grid.value()), path.c_str());
                    QCOMPARE(grid.value().values[14], test::volumeValue(2, 1, 0));
                }
            }
        }
    }

    void emptyPiecesAndPrologsOfAVtiAreIgnored()
    {
        std::string numbers;
        for (int n = 0; n < 72; ++n) {
            numbers += std::to_string(static_cast<int>(test::volumeValue(n % 12, n / 12 % 3, n / 36))) + " ";
        }
        const std::string text = test::vtiText(numbers), piece = "<Piece Extent=\"0 11 0 2 0 1\">";
        const auto before = [](std::string whole, const std::string& word, const std::string& more) {
            return whole.insert(whole.find(word), more);
        };
        const test::Folder folder;
        for (const std::string& bytes :
             {before(text, piece, "<Piece Extent=\"0 -1 0 -1 0 -1\"></Piece>"), "\xef\xbb\xbf" + text,
              before(text, "<VTKFile", "<!--" + std::string(2000, 'x') + "-->\n")}) {
            const auto grid = readSample(folder, {"v.vti", bytes});
            QVERIFY2(grid.isOk(), grid.status().message().c_str());
            QVERIFY(isWhole(grid.value()));
        }
        std::string many = text;
        const std::size_t begin = text.find(piece), end = text.find("</Piece>") + 8;
        for (int i = 0; i < 20; ++i) {
            many.insert(begin, text.substr(begin, end - begin));
        }
        const auto grid = readSample(folder, {"v.vti", many});
        QVERIFY(!grid.isOk());
        QCOMPARE(grid.status().message(),
                 std::string("v.vti: 1,512 numbers for 72 voxels; expected pieces that cover the whole extent once"));
    }

    void aVtiOfCellsHasItsVoxelsBetweenThePoints()
    {
        std::string text = test::vtiText("1 2 3 4", "0 2 0 2 0 1");
        for (const std::string& word : {std::string("PointData"), std::string("/PointData")}) {
            text.replace(text.find(word), word.size(), word[0] == '/' ? "/CellData" : "CellData");
        }
        const test::Folder folder;
        const auto grid = readSample(folder, {"v.VTI", text});
        QVERIFY2(grid.isOk(), grid.status().message().c_str());
        QCOMPARE(grid.value().size, (std::array<std::uint32_t, 3>{2, 2, 1}));
        QVERIFY((grid.value().toVoxel * core::Vec3(10.5, 21, 31.5)).norm() < 1e-9);
    }

    void aVtiStatesExtentAndDirections()
    {
        std::string numbers;
        for (int n = 0; n < 72; ++n) {
            numbers += std::to_string(static_cast<int>(test::volumeValue(n % 12, n / 12 % 3, n / 36))) + " ";
        }
        const auto placed = [&numbers](const std::string& where) {
            std::string text = test::vtiText(numbers, "5 16 -2 0 7 8");
            const std::string origin = "Origin=\"10 20 30\"";
            return text.replace(text.find(origin), origin.size(), where);
        };
        const test::Folder folder;
        const auto moved = readSample(folder, {"moved.vti", placed("Origin=\"5 24 9\"")});
        QVERIFY2(moved.isOk(), moved.status().message().c_str());
        QVERIFY(isWhole(moved.value()));
        // Voxels along the first axis lie along y of the patient, then z, then x. Rows of the matrix.
        const auto turned =
            readSample(folder, {"turned.vti", placed("Origin=\"1 2 3\" Direction=\"0 0 1 1 0 0 0 1 0\"")});
        QVERIFY2(turned.isOk(), turned.status().message().c_str());
        for (const core::Vec3& voxel : {core::Vec3(0, 0, 0), core::Vec3(11, 0, 0), core::Vec3(0, 2, 1)}) {
            const core::Vec3 index = voxel + core::Vec3(5, -2, 7);
            const core::Vec3 p_W(1.0 + 3.0 * index.z(), 2.0 + index.x(), 3.0 + 2.0 * index.y());
            QVERIFY((turned.value().toVoxel * p_W - voxel).norm() < 1e-9);
        }
    }

    void aScaledNiftiHasTheNumbersItStandsFor()
    {
        std::string header = test::niftiHeader();
        const float slope = 0.5F, intercept = -3.0F;
        std::memcpy(&header[112], &slope, sizeof(slope));
        std::memcpy(&header[116], &intercept, sizeof(intercept));
        const test::Folder folder;
        const auto grid = readSample(folder, {"v.nii", header + test::volumeNumbers()});
        QVERIFY2(grid.isOk(), grid.status().message().c_str());
        QCOMPARE(grid.value().values[71], 0.5F * test::volumeValue(11, 2, 1) - 3.0F);
    }

    void aQuaternionOfANiftiIsAUnit()
    {
        const test::Folder folder;
        const auto place = [&folder](float d, float across) {
            std::string header = test::niftiHeader();
            header[254] = '\0'; // no sform
            const auto put = [&header](std::size_t at, auto value) { std::memcpy(&header[at], &value, sizeof(value)); };
            put(252, std::int16_t{1});
            put(80, across);
            put(264, d);
            const auto grid = readSample(folder, {"v.nii", header + test::volumeNumbers()});
            return grid.isOk() ? core::Vec3(grid.value().toVoxel.inverse() * core::Vec3(4, 1, 1)) : core::Vec3::Zero();
        };
        QVERIFY((place(0.0F, 1.0F) - core::Vec3(-4, -2, 3)).norm() < 1e-6); // RAS to LPS
        QVERIFY((place(1.0F, 1.0F) - core::Vec3(4, 2, 3)).norm() < 1e-6);   // half a turn about z
        QVERIFY((place(1.5F, 1.0F) - core::Vec3(4, 2, 3)).norm() < 1e-6);
        QVERIFY((place(1.0F, -1.0F) - core::Vec3(4, 2, 3)).norm() < 1e-6); // a size has no sign
    }

    void fillersBehindVoxelsAreIgnored()
    {
        const std::string floats = test::volumeNumbers();
        const test::Folder folder;
        for (const test::VolumeSample& sample :
             {test::VolumeSample{"a.nii.gz", test::gzipped(test::niftiHeader() + floats) + std::string(300, '\0')},
              test::VolumeSample{"b.mha", test::metaHeader("MET_FLOAT", "LOCAL") + floats + "\r\n"},
              test::VolumeSample{"f.mha",
                                 test::metaHeader("MET_FLOAT", "LOCAL", "Comment = a\nComment = b\n") + floats},
              test::VolumeSample{"g.nii", test::niftiHeader() + floats + std::string(300, '\0')}}) {
            const auto grid = readSample(folder, sample);
            QVERIFY2(grid.isOk(), grid.status().message().c_str());
            QVERIFY(isWhole(grid.value()));
        }
        std::string header = test::niftiHeader();
        const float none = 0.0F;
        std::memcpy(&header[108], &none, sizeof(none)); // no offset of the voxels
        const auto grid = readSample(folder, {"c.nii", header + floats});
        QVERIFY2(grid.isOk(), grid.status().message().c_str());
        QVERIFY(!readSample(folder, {"d.nii", test::niftiHeader() + floats + "1234"}).isOk());
        QVERIFY(!readSample(folder, {"h.nii", test::niftiHeader() + floats + std::string(600, '\0')}).isOk());
        QVERIFY(!readSample(folder, {"e.nii.gz", test::gzipped(test::niftiHeader() + floats) + "1234"}).isOk());
    }

    void aNiftiWithoutAPlaceIsInTheChosenFrame()
    {
        std::string header = test::niftiHeader();
        header[254] = '\0'; // no sform
        const test::Folder folder;
        const std::filesystem::path path = folder.write("v.nii", header + test::volumeNumbers());
        for (const core::FileFrame frame : {core::FileFrame::Untagged, core::FileFrame::Ras}) {
            const auto grid = readVolumeHere(path, frame, {});
            QVERIFY2(grid.isOk(), grid.status().message().c_str());
            const core::Vec3 p_W = core::toLps(frame, core::Vec3(4, 2, 3));
            QVERIFY((grid.value().toVoxel * p_W - core::Vec3(4, 1, 1)).norm() < 1e-9);
        }
    }

    void aNarrowNrrdHasOneNumberPerVoxel()
    {
        std::string text = test::nrrdHeader("raw");
        const std::string sizes = "sizes: 12 3 2";
        text.replace(text.find(sizes), sizes.size(), "sizes: 3 12 2");
        const test::Folder folder;
        const auto grid = readSample(folder, {"v.nrrd", text + test::volumeNumbers()});
        QVERIFY2(grid.isOk(), grid.status().message().c_str());
        QCOMPARE(grid.value().size, (std::array<std::uint32_t, 3>{3, 12, 2}));
    }

    void shearedAxesAreKept()
    {
        std::string text = test::nrrdHeader("raw");
        const std::string third = "(0,0,3)";
        text.replace(text.find(third), third.size(), "(0,1,3)"); // a tilted gantry
        const test::Folder folder;
        const auto grid = readSample(folder, {"v.nrrd", text + test::volumeNumbers()});
        QVERIFY2(grid.isOk(), grid.status().message().c_str());
        const core::Vec3 p_W(10.0 + 4.0, 20.0 + 2.0 + 1.0, 30.0 + 3.0);
        QVERIFY((grid.value().toVoxel * p_W - core::Vec3(4, 1, 1)).norm() < 1e-9);
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
