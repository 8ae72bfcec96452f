// SPDX-License-Identifier: BSD-3-Clause
// Tests arrays and volumes that describe how a tissue varies: from the file through mesh repair to the force, and the
// rejected cases.
#include "English.h"
#include "Samples.h"
#include "TestRunner.h"

#include <palpate/meshio/SurfaceMaps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>

using namespace palpate;

namespace {

/// Returns a tetrahedron as an ASCII VTP, with the given point and cell data.
std::string vtp(const std::string& pointData, const std::string& cellData = "")
{
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
           "byte_order=\"LittleEndian\">\n<PolyData>\n"
           "<Piece NumberOfPoints=\"4\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
           "NumberOfPolys=\"4\">\n<PointData>" +
           pointData + "</PointData>\n<CellData>" + cellData +
           "</CellData>\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">"
           "0 0 0 24 0 0 0 24 0 0 0 24</DataArray></Points>\n"
           "<Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 2 1 0 1 3 0 3 2 1 2 3</DataArray>"
           "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3 6 9 12</DataArray></Polys>\n"
           "</Piece>\n</PolyData>\n</VTKFile>\n";
}

std::string array(const std::string& name, const std::string& values, int components = 1,
                  const std::string& type = "Float64")
{
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" + std::to_string(components) +
           "\" format=\"ascii\">" + values + "</DataArray>";
}

/// Converts JSON with apostrophes to quotes: moc mishandles raw strings that contain quotes.
std::string json(std::string text)
{
    std::replace(text.begin(), text.end(), '\'', '"');
    return text;
}

std::string sceneWith(const std::string& maps, const std::string& more = "")
{
    return json("{'version': 1, 'structures': [{'mesh': 'm.vtp', 'stiffness_N_per_mm': 0.4") + more +
           json(", 'maps': ") + maps + "}]}";
}

const meshio::SurfaceMap* mapOf(const meshio::LoadedScene& scene, core::MappedQuantity quantity)
{
    for (const meshio::SurfaceMap& map : scene.structures[0].maps) {
        if (map.mapping.quantity == quantity) {
            return &map;
        }
    }
    return nullptr;
}

/// Returns a MetaImage of 41^3 voxels of 2 mm about (12, 12, 12), with values by position.
std::string metaImage(const std::function<double(const core::Vec3&)>& value)
{
    std::string out = "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
                      "CompressedData = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = -28 -28 -28\n"
                      "ElementSpacing = 2 2 2\nDimSize = 41 41 41\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n";
    for (int k = 0; k < 41; ++k) {
        for (int j = 0; j < 41; ++j) {
            for (int i = 0; i < 41; ++i) {
                test::appendRaw(out, static_cast<float>(value(core::Vec3(i, j, k) * 2.0 - core::Vec3::Constant(28.0))));
            }
        }
    }
    return out;
}

} // namespace

class SurfaceMaps : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void arraysComeWithTheMesh()
    {
        const test::Folder folder;
        const auto file = meshio::readMesh(
            folder.write("m.vtp", vtp(array("heat", "1 2 3 4") + array("v", "1 2 3 4 5 6 7 8 9 10 11 12", 3),
                                      array("q", "5 6 7 8", 1, "Int16"))));
        QVERIFY2(file.isOk(), file.status().message().c_str());
        const auto& arrays = file.value().structures[0].mesh.arrays;
        QCOMPARE(arrays.size(), std::size_t{2});
        QVERIFY(arrays[0].name == "heat" && !arrays[0].isPerTriangle);
        QVERIFY(arrays[1].name == "q" && arrays[1].isPerTriangle);
        // Vertices are in the order of their first use: 0 2 1 3.
        QVERIFY((arrays[0].values == std::vector<float>{1, 3, 2, 4}));
        QVERIFY((arrays[1].values == std::vector<float>{5, 6, 7, 8}));
    }

    void namesThatSayItAreFelt()
    {
        const test::Folder folder;
        const auto scene = meshio::loadScene(
            folder.write("m.vtp", vtp(array("StiffnessScale", "1 2 0.5 4"),
                                      array("Friction", "1 1 2 2") + array("Damping_Ns_per_mm", "0 0 0.001 0.002"))));
        QVERIFY(scene.isOk());
        using core::MappedQuantity;
        const auto* s = mapOf(scene.value(), MappedQuantity::Stiffness);
        QVERIFY(s != nullptr && !s->isPerTriangle && (s->values == std::vector<float>{1, 0.5, 2, 4}));
        const auto* f = mapOf(scene.value(), MappedQuantity::Friction);
        QVERIFY(f != nullptr && f->isPerTriangle && f->values[2] == 2.0F);
        const auto* b = mapOf(scene.value(), MappedQuantity::Damping);
        QVERIFY(b != nullptr && b->values[3] == 0.002F);
        QVERIFY(!scene.value().scene.structures[0].maps.has_value()); // the saved scene contains no additional maps
    }

    void moduliBecomeWhatAContactFeels()
    {
        const test::Folder folder;
        (void)folder.write("m.vtp", vtp(array("mre", "2 4 100 2.3")));
        const auto felt = [&](const std::string& unit, const std::string& more = "") {
            const auto scene = meshio::loadScene(folder.write(
                "s.palpate.json",
                sceneWith(json("[{'quantity': 'stiffness', 'array': 'mre', 'unit': '") + unit + "\"" + more + "}]")));
            return scene.value().structures[0].maps[0].values;
        };
        // 8 a mu, and 2aE / (1 - nu^2): the same for E = 3 mu.
        QVERIFY(std::abs(felt("shear_kPa")[3] - 8.0 * 5.0 * 2.3e-3) < 1e-7);
        QVERIFY(std::abs(felt("young_kPa")[0] * 3.0 - felt("shear_kPa")[0]) < 1e-7);
        QVERIFY(std::abs(felt("shear_kPa", json(", 'contact_radius_mm': 10"))[0] - 8.0 * 10.0 * 2e-3) < 1e-7);
        QVERIFY(std::abs(felt("shear_kPa", json(", 'clamp': [0.5, 60]"))[1] - 8.0 * 5.0 * 60e-3) < 1e-6);
        QVERIFY(felt("N_per_mm")[1] == 100.0F);
    }

    void unknownValuesAreTheStructuresOwnAndCounted()
    {
        const test::Folder folder;
        const auto scene = meshio::loadScene(folder.write("m.vtp", vtp(array("Stiffness_N_per_mm", "1 nan -3 2"))));
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        const auto& values = scene.value().structures[0].maps[0].values;
        QVERIFY(values[0] == 1.0F && std::isnan(values[1]) && std::isnan(values[2]) && values[3] == 2.0F);
        QVERIFY(test::mentions(scene.value().warnings,
                               "m: the array \"Stiffness_N_per_mm\" has no value at 2 of 4 places, more than a fifth: "
                               "the structure's own value is felt there"));
        const auto masked = meshio::loadScene(folder.write(
            "k.vtp", vtp(array("StiffnessScale", "1 2 0.5 4") + array("vtkValidPointMask", "1 1 1 0", 1, "Int8"))));
        QVERIFY(std::isnan(masked.value().structures[0].maps[0].values[3]));
        QCOMPARE(masked.value().structures[0].surface->mesh.arrays.size(), std::size_t{1});
    }

    /// VTK fails on these files and reports a short array.
    void whatNoStreamReadsIsNamed_data()
    {
        QTest::addColumn<QString>("type");
        QTest::addColumn<QString>("values");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* type, const char* values, const char* said) {
            QTest::newRow(values) << QString(type) << QString(values) << QString(said);
        };
        row("Float64", "1 2 1 inf", ""); // made readable before
        row("Float64", "1 2 1 -INF", "");
        row("Float32", "1 2 1 nan", "");
        row("Float32", "1 -1.#IND 1 1.#INF", "");
        row("Float64", "1 1e999 1 2", "value 1 is \"1e999\"; expected a number in the range of Float64");
        row("Float32", "1 2 -1e39 2", "value 2 is \"-1e39\"; expected a number in the range of Float32");
        row("Int32", "1 9999999999 1 2", "value 1 is \"9999999999\"; expected a number in the range of Int32");
        row("Float64", "1 inf 1 nan ", "");
        row("Float64", "1 2 1e-999 1e5", "");
    }
    void whatNoStreamReadsIsNamed()
    {
        QFETCH(QString, type);
        QFETCH(QString, values);
        QFETCH(QString, said);
        const test::Folder folder;
        const auto scene = meshio::loadScene(
            folder.write("m.vtp", vtp(array("StiffnessScale", values.toStdString(), 1, type.toStdString()))));
        const QString message = QString::fromStdString(scene.status().message());
        QVERIFY2(scene.isOk() == said.isEmpty(), qPrintable(message));
        QVERIFY2(said.isEmpty() || (message.startsWith(QStringLiteral("m.vtp: line ")) &&
                                    message.contains(QStringLiteral("array \"StiffnessScale\": ") + said)),
                 qPrintable(message));
        if (scene.isOk() && !values.contains(QLatin1Char('e'))) { // in the order 0, 2, 1, 3; the last is unknown
            const auto& array = scene.value().structures[0].surface->mesh.arrays.at(0);
            QCOMPARE(array.values.size(), std::size_t{4});
            QVERIFY(array.values[0] == 1.0F && array.values[1] == 1.0F && std::isnan(array.values[3]));
        }
    }

    /// Stiffness values that are not above 0, and others below 0, are unknown; a factor of 0 removes friction.
    void whatCantBeFeltIsNotKnown_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("values");
        QTest::addColumn<QString>("known"); // 1 or 0 for each vertex, in file order
        QTest::newRow("scale") << "StiffnessScale"
                               << "0 -1 inf 2"
                               << "0001";
        QTest::newRow("stiffness") << "Stiffness_N_per_mm"
                                   << "nan 0 -0.5 2"
                                   << "0001";
        QTest::newRow("beyond a float") << "Stiffness_N_per_mm"
                                        << "1e39 -1e39 1 2"
                                        << "0011";
        QTest::newRow("Young") << "YoungsModulus_kPa"
                               << "0 -3 10 inf"
                               << "0010";
        QTest::newRow("shear") << "ShearModulus_kPa"
                               << "-inf 2.3 0 nan"
                               << "0100";
        QTest::newRow("damping") << "Damping_Ns_per_mm"
                                 << "0 -0.001 nan 0.002"
                                 << "1001";
        QTest::newRow("friction") << "Friction"
                                  << "0 -1 inf 2"
                                  << "1001";
    }
    void whatCantBeFeltIsNotKnown()
    {
        QFETCH(QString, name);
        QFETCH(QString, values);
        QFETCH(QString, known);
        const test::Folder folder;
        const auto scene =
            meshio::loadScene(folder.write("m.vtp", vtp(array(name.toStdString(), values.toStdString() + "\n"))));
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        const meshio::SurfaceMap& map = scene.value().structures[0].maps.at(0);
        const std::array<int, 4> order{0, 2, 1, 3}; // order of first use, which is the vertex order
        std::ptrdiff_t unknown = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const bool isKnown = known[order[i]] == QLatin1Char('1');
            QCOMPARE(std::isfinite(map.values[i]), isKnown);
            QVERIFY(!isKnown || map.values[i] >= 0.0F);
            unknown += isKnown ? 0 : 1;
        }
        QCOMPARE(meshio::missingValues(map), static_cast<std::size_t>(unknown));
        const std::string said = "m: the array \"" + name.toStdString() + "\" has no value at " +
                                 std::to_string(unknown) + " of 4 places, more than a fifth";
        QVERIFY2(test::mentions(scene.value().warnings, said), said.c_str());
    }

    void aFifthIsManyAndLessIsNot()
    {
        geometry::TriangleMesh mesh; // a strip of ten vertices
        for (int i = 0; i < 10; ++i) {
            mesh.vertices.emplace_back(10.0 * (i / 2), 10.0 * (i % 2), 0.0);
        }
        for (std::uint32_t i = 0; i + 2 < 10; ++i) {
            mesh.triangles.push_back(i % 2 == 0 ? geometry::Triangle{i, i + 2, i + 1}
                                                : geometry::Triangle{i, i + 1, i + 2});
        }
        for (const int missing : {0, 1, 2, 3}) {
            mesh.arrays = {{"StiffnessScale", false, std::vector<float>(10, 1.0F)}};
            std::fill_n(mesh.arrays[0].values.begin(), missing, std::numeric_limits<float>::quiet_NaN());
            meshio::LoadedStructure structure;
            structure.description.name = "liver";
            structure.surface = std::make_shared<const geometry::RepairedMesh>(geometry::repair(mesh));
            std::vector<core::Message> warnings, losses;
            meshio::resolveMaps(structure, warnings, losses);
            QVERIFY(losses.empty());
            QCOMPARE(warnings.size(), std::size_t{missing > 0 ? 1U : 0U});
            if (missing > 0) {
                const std::string line = warnings[0].english();
                QCOMPARE(line.find("more than a fifth") != std::string::npos, missing == 3);
                QVERIFY2(line.starts_with("liver: the array \"StiffnessScale\" has no value at " +
                                          std::to_string(missing) + " of 10 places"),
                         line.c_str());
            }
        }
    }

    void weldingTakesTheMeanAndCounts()
    {
        geometry::TriangleMesh mesh;
        mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {9, 9, 9}};
        mesh.triangles = {{0, 1, 2}, {0, 0, 1}, {3, 4, 5}};
        constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
        mesh.arrays = {{"a", false, {1, 2, 4, 3, 5, kNan, 8}}, {"t", true, {7, 8, 9}}};
        const geometry::RepairedMesh repaired = geometry::repair(mesh);
        QVERIFY((repaired.mesh.arrays[0].values == std::vector<float>{1, 2.5, 4, 5}));
        QVERIFY((repaired.mesh.arrays[1].values == std::vector<float>{7, 9}));
        QCOMPARE(repaired.report.mixedValues, std::size_t{1});
        QVERIFY(!repaired.report.isClean());
    }

    void badArraysAreRefused_data()
    {
        QTest::addColumn<QString>("pointData");
        QTest::addColumn<QString>("cellData");
        QTest::addColumn<QString>("said");
        const auto q = [](const std::string& text) { return QString::fromStdString(text); };
        QTest::newRow("too short") << q(array("Friction", "1 2 3")) << ""
                                   << "array \"Friction\": number of values: 3;";
        QTest::newRow("three components") << q(array("StiffnessScale", "1 2 3 4 5 6 7 8 9 1 2 3", 3)) << ""
                                          << "array \"StiffnessScale\": number of components: 3; expected exactly 1";
        QTest::newRow("cells too long") << "" << q(array("Friction", "1 2 3 4 5"))
                                        << "array \"Friction\": number of values: 5; expected 4, one for each polygon";
        QTest::newRow("three components of a cell")
            << "" << q(array("Damping_Ns_per_mm", "1 2 3 4 5 6 7 8 9 1 2 3", 3))
            << "array \"Damping_Ns_per_mm\": number of components: 3; expected exactly 1";
        QTest::newRow("none") << q(array("Friction", "")) << ""
                              << "array \"Friction\": number of values: 0;";
        QTest::newRow("no number") << q(array("ShearModulus_kPa", "1 2 soft 4")) << ""
                                   << "array \"ShearModulus_kPa\": value 2 is \"soft\"";
    }
    void badArraysAreRefused()
    {
        QFETCH(QString, pointData);
        QFETCH(QString, cellData);
        QFETCH(QString, said);
        const test::Folder folder;
        const auto file = meshio::readMesh(folder.write("m.vtp", vtp(pointData.toStdString(), cellData.toStdString())));
        QVERIFY(!file.isOk());
        QVERIFY2(QString::fromStdString(file.status().message()).contains(said), file.status().message().c_str());
    }

    void aScenesMapsAreRead_data()
    {
        QTest::addColumn<QString>("maps");
        QTest::addColumn<QString>("said");
        QTest::newRow("no unit") << QString::fromStdString(json("[{'quantity': 'stiffness', 'array': 'mre'}]"))
                                 << "maps[0].unit: found nothing";
        QTest::newRow("unit of another") << QString::fromStdString(
                                                json("[{'quantity': 'friction', 'array': 'mre', 'unit': 'young_kPa'}]"))
                                         << "maps[0].unit: found \"young_kPa\"";
        QTest::newRow("no such unit") << QString::fromStdString(
                                             json("[{'quantity': 'stiffness', 'array': 'mre', 'unit': 'kPa'}]"))
                                      << "expected one of scale, N_per_mm, Ns_per_mm, young_kPa, shear_kPa";
        QTest::newRow("no such quantity") << QString::fromStdString(json("[{'quantity': 'heat', 'array': 'mre'}]"))
                                          << "maps[0].quantity: found \"heat\"";
        QTest::newRow("neither") << QString::fromStdString(json("[{'quantity': 'friction'}]"))
                                 << "neither `array` nor `file`";
        QTest::newRow("clamp") << QString::fromStdString(
                                      json("[{'quantity': 'friction', 'array': 'a', 'clamp': [3, 1]}]"))
                               << "maps[0].clamp";
        QTest::newRow("clamp below nothing")
            << QString::fromStdString(json("[{'quantity': 'friction', 'array': 'a', 'clamp': [-1, 1]}]"))
            << "maps[0].clamp[0]: found -1";
        QTest::newRow("clamp of one") << QString::fromStdString(
                                             json("[{'quantity': 'friction', 'array': 'a', 'clamp': [1]}]"))
                                      << "maps[0].clamp: found an array of 1";
        QTest::newRow("both") << QString::fromStdString(
                                     json("[{'quantity': 'friction', 'array': 'a', 'file': 'v.mha'}]"))
                              << "maps[0]";
        QTest::newRow("no list") << QString::fromStdString(json("{'quantity': 'friction', 'array': 'a'}"))
                                 << "maps: found an object";
        QTest::newRow("radius")
            << QString::fromStdString(
                   json("[{'quantity': 'stiffness', 'array': 'a', 'unit': 'young_kPa', 'contact_radius_mm': 0}]"))
            << "maps[0].contact_radius_mm: found 0";
    }
    void aScenesMapsAreRead()
    {
        QFETCH(QString, maps);
        QFETCH(QString, said);
        const test::Folder folder;
        const auto scene = meshio::readScene(folder.write("s.palpate.json", sceneWith(maps.toStdString())));
        QVERIFY(!scene.isOk());
        QVERIFY2(QString::fromStdString(scene.status().message()).contains(said), scene.status().message().c_str());
    }

    void aScenesMapsAreWrittenAgain()
    {
        const test::Folder folder;
        const auto scene = meshio::readScene(folder.write(
            "s.palpate.json", sceneWith(json("[{'quantity': 'stiffness', 'array': 'mre', 'unit': 'shear_kPa', 'clamp': "
                                             "[0.5, 60]}, {'quantity': 'friction', 'file': 'v/f.nrrd'}]"))));
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        QVERIFY(meshio::writeScene(folder.path("t.palpate.json"), scene.value()).isOk());
        const auto back = meshio::readScene(folder.path("t.palpate.json"));
        QVERIFY2(back.isOk(), back.status().message().c_str());
        QVERIFY(back.value().structures[0].maps == scene.value().structures[0].maps);
        QCOMPARE(back.value().structures[0].maps->at(1).file, folder.path("v/f.nrrd").string());
    }

    void anArrayThatIsNotThereIsALoss()
    {
        const test::Folder folder;
        (void)folder.write("m.vtp", vtp(array("heat", "1 2 3 4")));
        const auto scene = meshio::loadScene(folder.write(
            "s.palpate.json", sceneWith(json("[{'quantity': 'stiffness', 'array': 'mre', 'unit': 'scale'}]"))));
        QVERIFY(scene.isOk());
        QCOMPARE(scene.value().losses.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(scene.value().losses[0].english()),
                 QString("m.vtp: m: no array \"mre\"; expected one of \"heat\""));
        const auto none = meshio::loadScene(folder.write("n.palpate.json", sceneWith("[]")));
        QVERIFY(none.value().structures[0].maps.empty() && none.value().losses.empty());
    }

    void aVolumeIsFeltThroughTheTissueBelow()
    {
        const test::Folder folder;
        (void)folder.write("m.vtp", vtp(""));
        const auto at = [&](const std::function<double(const core::Vec3&)>& value, double radius) {
            (void)folder.write("v.mha", metaImage(value));
            const auto scene = meshio::loadScene(folder.write(
                "s.palpate.json",
                sceneWith(json("[{'quantity': 'stiffness', 'file': 'v.mha', 'unit': 'scale', 'contact_radius_mm': ") +
                          std::to_string(radius) + "}]")));
            return scene.value().structures[0].maps.at(0).values;
        };
        // A uniform value is unchanged.
        for (const float v : at([](const core::Vec3&) { return 3.0; }, 1.0)) {
            QVERIFY(std::abs(v - 3.0F) < 1e-5F);
        }
        // Stiff tissue deeper than a few contact radii contributes less than shallow tissue: below the corner (24, 0,
        // 0).
        const auto half = [](double depth) {
            return [depth](const core::Vec3& p) {
                return p.sum() / std::sqrt(3.0) < 24.0 / std::sqrt(3.0) - depth ? 10.0 : 1.0;
            };
        };
        const float near = at(half(1.0), 1.0)[2], far = at(half(5.0), 1.0)[2];
        QVERIFY2(near > far && far > 1.0F && near < 10.0F, qPrintable(QString("%1 %2").arg(near).arg(far)));
        // Air below most of the area: unknown.
        QVERIFY(std::isnan(at([](const core::Vec3&) { return 0.0; }, 1.0)[0]));
    }

    void aVolumeIsNotSampledOnceThatIsCancelled()
    {
        const test::Folder folder;
        (void)folder.write("m.vtp", vtp(""));
        (void)folder.write("v.mha", metaImage([](const core::Vec3&) { return 3.0; }));
        const auto scene = meshio::loadScene(folder.write(
            "s.palpate.json",
            sceneWith(json("[{'quantity': 'stiffness', 'file': 'v.mha', 'unit': 'scale', 'contact_radius_mm': 1}]"))));
        meshio::LoadedStructure structure = scene.value().structures[0];
        for (const int asks : {0, 1}) { // cancelled at once, and during reading
            int asked = 0;
            std::vector<core::Message> warnings, losses;
            meshio::resolveMaps(structure, warnings, losses, [&] { return asked++ < asks; });
            QCOMPARE(asked, asks + 1); // no further calls
            QVERIFY(structure.maps.empty());
            QCOMPARE(losses.size(), std::size_t{1});
            QVERIFY2(test::mentions(losses, "v.mha: reading was cancelled"), losses[0].english().c_str());
        }
    }

    void badVolumesAreLosses_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("said");
        QTest::newRow("missing") << "gone.mha" << QByteArray() << "no such file";
        QTest::newRow("another kind") << "v.dcm" << QByteArray("x") << "expected a volume";
        QTest::newRow("no image") << "v.nii" << QByteArray("not an image")
                                  << "v.nii: an unknown format; expected a volume";
        QTest::newRow("cut short") << "v.mha"
                                   << QByteArray(
                                          metaImage([](const core::Vec3&) { return 1.0; }).substr(0, 900).c_str())
                                   << "";
    }
    void badVolumesAreLosses()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QFETCH(QString, said);
        const test::Folder folder;
        (void)folder.write("m.vtp", vtp(""));
        if (!bytes.isEmpty()) {
            (void)folder.write(name.toStdString(), bytes.toStdString());
        }
        const auto scene = meshio::loadScene(folder.write(
            "s.palpate.json", sceneWith(json("[{'quantity': 'friction', 'file': '") + name.toStdString() + "\"}]")));
        QVERIFY(scene.isOk());
        QVERIFY(scene.value().structures[0].maps.empty());
        QCOMPARE(scene.value().losses.size(), std::size_t{1});
        QVERIFY2(test::mentions(scene.value().losses, said.toStdString()), scene.value().losses[0].english().c_str());
    }
};

PALPATE_TEST(SurfaceMaps)
#include "tst_SurfaceMaps.moc"
