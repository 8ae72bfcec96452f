// SPDX-License-Identifier: BSD-3-Clause
#include "Samples.h"
#include "TestRunner.h"

#include <palpate/meshio/MeshFile.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>

using namespace palpate;

namespace {

enum Mode
{
    Ascii,
    Binary,
    AppendedRaw,
    AppendedBase64
};

/// Optional content besides points and triangles.
enum Extra : unsigned
{
    kRanges = 1,  ///< precomputed ranges of every array, which VTK writes as information keys
    kKeys = 2,    ///< component names and information keys of the points
    kArrays = 4,  ///< arrays of points, cells and the data set: numbers and strings
    kDoubles = 8, ///< coordinates as Float64, else Float32
};

/// A ring of 50 points with 48 triangles that fan out from one point.
vtkSmartPointer<vtkPolyData> fan(unsigned extra)
{
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataType((extra & kDoubles) != 0 ? VTK_DOUBLE : VTK_FLOAT);
    constexpr int kPoints = 50;
    for (int i = 0; i < kPoints; ++i) {
        const double angle = 2.0 * i * 3.14159265358979 / kPoints;
        points->InsertNextPoint(30.0 * std::cos(angle), 30.0 * std::sin(angle), 0.1 * (i % 7));
    }
    vtkNew<vtkCellArray> polygons;
    for (vtkIdType i = 1; i + 1 < kPoints; ++i) {
        polygons->InsertNextCell({0, i, i + 1});
    }
    data->SetPoints(points);
    data->SetPolys(polygons);
    if ((extra & kArrays) != 0) {
        vtkNew<vtkDoubleArray> speed;
        speed->SetName("speed");
        speed->SetNumberOfComponents(3);
        vtkNew<vtkStringArray> label;
        label->SetName("label");
        for (int i = 0; i < kPoints; ++i) {
            speed->InsertNextTuple3(0.5 * i, -1.0, i * i);
            label->InsertNextValue("point " + std::to_string(i));
        }
        data->GetPointData()->SetScalars(speed);
        data->GetPointData()->AddArray(label);
        vtkNew<vtkIdTypeArray> origin;
        origin->SetName("origin");
        vtkNew<vtkIntArray> structure;
        structure->SetName("StructureId");
        for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i) {
            origin->InsertNextValue(1000 + i);
            structure->InsertNextValue(i < 20 ? 0 : 1);
        }
        data->GetCellData()->AddArray(origin);
        data->GetCellData()->AddArray(structure);
        vtkNew<vtkStringArray> names;
        names->SetName("StructureNames");
        names->InsertNextValue("liver");
        names->InsertNextValue("lump");
        data->GetFieldData()->AddArray(names);
    }
    if ((extra & kKeys) != 0) {
        vtkDataArray* array = points->GetData();
        array->SetComponentName(0, "left");
        array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "mm");
        const double lengths[]{29.0, 31.0};
        array->GetInformation()->Set(vtkDataArray::L2_NORM_RANGE(), lengths, 2);
    }
    if ((extra & kRanges) != 0) {
        double range[2];
        vtkDataArray* array = points->GetData();
        for (int component = -1; component < 3; ++component) { // -1: range of the magnitude
            array->GetRange(range, component);
            array->GetFiniteRange(range, component);
        }
        for (vtkFieldData* all :
             {static_cast<vtkFieldData*>(data->GetPointData()), static_cast<vtkFieldData*>(data->GetCellData())}) {
            for (int i = 0; i < all->GetNumberOfArrays(); ++i) {
                if (vtkDataArray* numbers = all->GetArray(i)) {
                    numbers->GetRange(range, -1);
                }
            }
        }
    }
    return data;
}

void write(const std::filesystem::path& path, vtkPolyData* data, Mode mode, int compressor, int width)
{
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(path.c_str());
    writer->SetInputData(data);
    switch (mode) {
    case Ascii:
        writer->SetDataModeToAscii();
        break;
    case Binary:
        writer->SetDataModeToBinary();
        break;
    case AppendedRaw:
    case AppendedBase64:
        writer->SetDataModeToAppended();
        writer->SetEncodeAppendedData(mode == AppendedBase64);
        break;
    }
    writer->SetCompressorType(compressor);
    writer->SetHeaderType(width);
    writer->Write();
}

/// @return largest distance of a triangle corner from the written position; large if triangles are missing [mm]
double worstCorner(vtkPolyData& data, const meshio::MeshFile& file)
{
    vtkIdType triangle = 0;
    double worst = 0.0;
    for (const meshio::MeshStructure& structure : file.structures) {
        for (const geometry::Triangle& corners : structure.mesh.triangles) {
            vtkIdType count = 0;
            const vtkIdType* expected = nullptr;
            data.GetCellPoints(triangle++, count, expected);
            for (std::size_t k = 0; k < 3; ++k) {
                core::Vec3 p;
                data.GetPoint(expected[k], p.data());
                worst = std::max(worst, (structure.mesh.vertices[corners[k]] - p).norm());
            }
        }
    }
    return triangle == 48 ? worst : 1e9;
}

} // namespace

/// Tests files from VTK's own writer in all modes.
class VtkWriter : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void isReadInEveryMode_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<int>("compressor");
        QTest::addColumn<int>("width");
        QTest::addColumn<unsigned>("extra");
        const std::pair<const char*, Mode> modes[]{
            {"ASCII", Ascii}, {"binary", Binary}, {"appended raw", AppendedRaw}, {"appended base64", AppendedBase64}};
        const std::pair<const char*, int> compressors[]{{"plain", vtkXMLWriter::NONE},
                                                        {"zlib", vtkXMLWriter::ZLIB},
                                                        {"LZ4", vtkXMLWriter::LZ4},
                                                        {"LZMA", vtkXMLWriter::LZMA}};
        const std::pair<const char*, unsigned> extras[]{{"surface alone", 0},
                                                        {"ranges", kRanges},
                                                        {"keys, doubles", kKeys | kDoubles},
                                                        {"arrays", kArrays},
                                                        {"all", kRanges | kKeys | kArrays | kDoubles}};
        for (const auto& [modeName, mode] : modes) {
            for (const auto& [compressorName, compressor] : compressors) {
                for (const int width : {vtkXMLWriter::UInt32, vtkXMLWriter::UInt64}) {
                    for (const auto& [extraName, extra] : extras) {
                        QTest::addRow("%s, %s, %d bits, %s", modeName, compressorName, width, extraName)
                            << static_cast<int>(mode) << compressor << width << extra;
                    }
                }
            }
        }
    }

    void legacyIsReadInEveryMode_data()
    {
        QTest::addColumn<bool>("isBinary");
        QTest::addColumn<int>("version");
        QTest::addColumn<unsigned>("extra");
        const std::pair<const char*, unsigned> extras[]{{"surface alone", 0},
                                                        {"keys, doubles", kKeys | kDoubles},
                                                        {"arrays", kArrays},
                                                        {"all", kRanges | kKeys | kArrays | kDoubles}};
        for (const bool isBinary : {false, true}) {
            for (const int version : {42, 51}) {
                for (const auto& [extraName, extra] : extras) {
                    QTest::addRow("%s, version %d, %s", isBinary ? "binary" : "ASCII", version, extraName)
                        << isBinary << version << extra;
                }
            }
        }
    }

    void legacyIsReadInEveryMode()
    {
        QFETCH(bool, isBinary);
        QFETCH(int, version);
        QFETCH(unsigned, extra);
        const test::Folder folder;
        const auto path = folder.path("a.vtk");
        const auto data = fan(extra);
        vtkNew<vtkPolyDataWriter> writer;
        writer->SetFileName(path.c_str());
        writer->SetInputData(data);
        writer->SetFileVersion(version);
        writer->SetFileType(isBinary ? VTK_BINARY : VTK_ASCII);
        QVERIFY(writer->Write() == 1);
        const std::string bytes = test::fileBytes(path); // otherwise the row would not test its case
        QCOMPARE(bytes.find("METADATA") != std::string::npos, (extra & kKeys) != 0);
        QCOMPARE(bytes.find("OFFSETS") != std::string::npos, version == 51);
        QCOMPARE(bytes.find("FIELD FieldData 1\nStructureNames") != std::string::npos, (extra & kArrays) != 0);

        const auto file = meshio::readMesh(path);
        QVERIFY2(file.isOk(), file.status().message().c_str());
        QCOMPARE(file.value().structures.size(), std::size_t{1}); // this format does not name the parts
        const double worst = worstCorner(*data, file.value());
        // VTK writes enough digits for a float, and all but the last digit of a double.
        QVERIFY2(worst <= (isBinary ? 0.0 : 1e-4), qPrintable(QString::number(worst)));
    }

    void isReadInEveryMode()
    {
        QFETCH(int, mode);
        QFETCH(int, compressor);
        QFETCH(int, width);
        QFETCH(unsigned, extra);
        const test::Folder folder;
        const auto path = folder.path("a.vtp");
        const auto data = fan(extra);
        write(path, data, static_cast<Mode>(mode), compressor, width);
        if ((extra & (kRanges | kKeys)) != 0) { // otherwise the row would not test its case
            QVERIFY(test::fileBytes(path).find("<InformationKey") != std::string::npos);
        }

        const auto file = meshio::readMesh(path);
        QVERIFY2(file.isOk(), file.status().message().c_str());
        for (const core::Message& message : file.value().notes) {
            const std::string note = message.english();
            QVERIFY2(note.find("damaged") == std::string::npos, note.c_str());
        }
        const auto& structures = file.value().structures;
        const double worst = worstCorner(*data, file.value());
        // VTK writes enough digits for a float, and all but the last digit of a double.
        QVERIFY2(worst <= 1e-5, qPrintable(QString::number(worst)));
        if (mode != Ascii) {
            QCOMPARE(worst, 0.0);
        }
        if ((extra & kArrays) != 0) {
            QCOMPARE(structures.size(), std::size_t{2});
            QCOMPARE(structures[0].name, std::string("liver"));
            QCOMPARE(structures[1].name, std::string("lump"));
            QCOMPARE(structures[0].mesh.triangles.size(), std::size_t{20});
        } else {
            QCOMPARE(structures.size(), std::size_t{1});
        }
    }
};

PALPATE_TEST(VtkWriter)
#include "tst_VtkWriter.moc"
