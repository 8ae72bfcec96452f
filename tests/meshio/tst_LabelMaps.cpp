// SPDX-License-Identifier: BSD-3-Clause
// Tests label maps: surfaces, names, colours and places from every format, and files that are refused.
#include "English.h"
#include "LabelFiles.h"
#include "Samples.h"
#include "TestRunner.h"

#include <palpate/geometry/MeshReport.h>
#include <palpate/meshio/LoadScene.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

using namespace palpate;
using core::Vec3;
using meshio::MeshStructure;

namespace {

// The shapes, in LPS. [mm]
const Vec3 kBoxCentre(-14.1, 3.2, 5.3), kBoxHalf(9.7, 8.3, 11.1), kBallCentre(16.3, 2.1, 7.7),
    kRingCentre(1.2, -33.4, 2.8);
constexpr double kBallRadius_mm = 13.4, kRingRadius_mm = 18.2, kTubeRadius_mm = 7.3;

/// @return distance from the surface of the box, negative inside [mm]
double boxDistance(const Vec3& p)
{
    const Vec3 q = (p - kBoxCentre).cwiseAbs() - kBoxHalf;
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
}

/// @return true within two voxels of an edge of the box, which is as far as the filter rounds it
bool isNearEdge(const Vec3& p, double voxel_mm)
{
    const Vec3 q = (p - kBoxCentre).cwiseAbs() - kBoxHalf;
    return (q.array() > -2.0 * voxel_mm).count() >= 2;
}

double ballDistance(const Vec3& p)
{
    return (p - kBallCentre).norm() - kBallRadius_mm;
}

double ringDistance(const Vec3& p)
{
    const Vec3 q = p - kRingCentre;
    return std::hypot(std::hypot(q.x(), q.y()) - kRingRadius_mm, q.z()) - kTubeRadius_mm;
}

constexpr double kBoxVolume_mm3 = 8.0 * 9.7 * 8.3 * 11.1;
const double kBallVolume_mm3 = 4.0 / 3.0 * std::numbers::pi * std::pow(kBallRadius_mm, 3);
const double kRingVolume_mm3 = 2.0 * std::pow(std::numbers::pi, 2) * kRingRadius_mm * std::pow(kTubeRadius_mm, 2);

int shapeAt(const Vec3& p)
{
    return boxDistance(p) < 0.0 ? 1 : ballDistance(p) < 0.0 ? 2 : ringDistance(p) < 0.0 ? 7 : 0;
}

/// @param voxel_mm  a negative number mirrors the axis
test::LabelGrid shapes(const Vec3& voxel_mm = Vec3(1, 1, 1))
{
    test::LabelGrid grid;
    grid.steps = test::obliqueSteps(voxel_mm);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        constexpr double kExtent_mm = 96.0;
        grid.size[axis] = static_cast<int>(kExtent_mm / std::abs(voxel_mm[static_cast<Eigen::Index>(axis)]));
    }
    const Vec3 middle = Vec3(0, -10, 4) - grid.steps * Vec3(grid.size[0] / 2, grid.size[1] / 2, grid.size[2] / 2);
    grid.origin = middle.cast<float>().cast<double>();
    grid.fill(shapeAt);
    return grid;
}

const std::string kSegments =
    "Segment0_ID:=Segment_1\nSegment0_Name:=liver\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
    "Segment0_Color:=0.5 0.25 0.125\nSegment1_Name:=tumour\nSegment1_LabelValue:=2\n"
    "Segment1_Layer:=0\nSegment1_Color:=1 0 0\nSegment2_Name:=Milz rückwärts\n"
    "Segment2_LabelValue:=7\nSegment2_Layer:=0\n";

bool isSame(const MeshStructure& a, const MeshStructure& b)
{
    return a.mesh.vertices.size() == b.mesh.vertices.size() && a.mesh.triangles == b.mesh.triangles &&
           std::memcmp(a.mesh.vertices.data(), b.mesh.vertices.data(), a.mesh.vertices.size() * sizeof(Vec3)) == 0;
}

std::vector<std::string> namesOf(const meshio::MeshFile& file)
{
    std::vector<std::string> names;
    for (const MeshStructure& structure : file.structures) {
        names.push_back(structure.name);
    }
    return names;
}

using Names = std::vector<std::string>;

/// Returns a volume of 8 x 6 x 5 mm with two labels.
test::LabelGrid small()
{
    test::LabelGrid grid;
    grid.size = {8, 6, 5};
    grid.fill([](const Vec3& p) { return p.x() < 1.5 || p.x() > 6.5 ? 0 : p.x() < 4.0 ? 1 : 2; });
    return grid;
}

std::string withReplaced(std::string text, const std::string& from, const std::string& to)
{
    return text.replace(text.find(from), from.size(), to);
}

} // namespace

class LabelMaps : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void shapesAreTrue_data()
    {
        QTest::addColumn<double>("across");
        QTest::addColumn<double>("slice");
        QTest::newRow("cubes") << 1.0 << 1.0;
        QTest::newRow("slices") << 1.0 << 2.0;
        QTest::newRow("mirrored") << -1.0 << 1.0;
    }
    void shapesAreTrue()
    {
        QFETCH(double, across);
        QFETCH(double, slice);
        const test::LabelGrid grid = shapes(Vec3(across, 1.0, slice));
        const test::Folder folder;
        const std::string packed = test::gzipped(test::labelNumbers<std::int16_t>(grid));
        const auto loaded = meshio::loadScene(
            folder.write("case.seg.nrrd", test::labelNrrd(grid, "short", "gzip", kSegments) + packed));
        QVERIFY2(loaded.isOk(), loaded.status().message().c_str());
        const auto& structures = loaded.value().structures;
        QCOMPARE(structures.size(), std::size_t{3});
        const std::array<double (*)(const Vec3&), 3> distances{boxDistance, ballDistance, ringDistance};
        const std::array<double, 3> volumes{kBoxVolume_mm3, kBallVolume_mm3, kRingVolume_mm3};
        for (std::size_t i = 0; i < 3; ++i) {
            const meshio::LoadedStructure& one = structures[i];
            QVERIFY(one.surface->report.isClosed());
            const double volume = one.surface->report.volume_mm3 / volumes[i]; // above 0: the normals point outwards
            double farthest_mm = 0.0, farthestOfEdge_mm = 0.0;                 // smoothing rounds the edges of the box
            for (const Vec3& p : one.surface->mesh.vertices) {
                double& most_mm = i == 0 && isNearEdge(p, slice) ? farthestOfEdge_mm : farthest_mm;
                most_mm = std::max(most_mm, std::abs(distances[i](p)));
            }
            qInfo("%s: volume %.4f, farthest %.3f mm", one.description.name.c_str(), volume, farthest_mm);
            QVERIFY2(std::abs(volume - 1.0) <= 0.03, one.description.name.c_str());
            QVERIFY2(farthest_mm <= 0.5 * slice, one.description.name.c_str());
            QVERIFY2(farthestOfEdge_mm <= 0.5 * std::hypot(1.0, 1.0, slice), one.description.name.c_str());
            QVERIFY(one.smoothing && one.smoothing->strength == 0.5);
            QCOMPARE(one.description.surface, meshio::SurfaceKind::Smoothed);
        }
        QCOMPARE(structures[0].description.name, std::string("liver"));
        QCOMPARE(structures[1].description.name, std::string("tumour"));
        QCOMPARE(structures[2].description.name, std::string("Milz rückwärts"));
        QCOMPARE(structures[0].description.colour, (std::array<double, 3>{0.5, 0.25, 0.125}));
        QCOMPARE(structures[1].description.colour, (std::array<double, 3>{1, 0, 0}));
    }

    void everyFormatGivesTheSameBits()
    {
        const test::LabelGrid grid = shapes(Vec3(2, 1, 2));
        const test::Folder folder;
        const std::string shorts = test::labelNumbers<std::int16_t>(grid), packed = test::zlibbed(shorts);
        const auto whole = meshio::readMesh(folder.write("a.nrrd", test::labelNrrd(grid, "short", "raw") + shorts));
        QVERIFY2(whole.isOk(), whole.status().message().c_str());
        QCOMPARE(namesOf(whole.value()), (Names{"label 1", "label 2", "label 7"}));
        QVERIFY(whole.value().voxels && whole.value().voxels->isStated);
        (void)folder.write("k.raw", shorts);
        const std::vector<std::pair<std::string, std::string>> files{
            {"b.nrrd",
             test::labelNrrd(grid, "double", "gzip", "", true) + test::gzipped(test::labelNumbers<double>(grid))},
            {"c.nii.gz", test::gzipped(test::labelNifti(grid, 2) + test::labelNumbers<std::uint8_t>(grid))},
            {"d.nii", test::labelNifti(grid, 4, true) + test::labelNumbers<std::int16_t>(grid, true)},
            {"e.nii", test::labelNifti(grid, 16) + test::labelNumbers<float>(grid)},
            {"f.mha", test::labelMeta(grid, "MET_USHORT") + shorts},
            {"g.mha",
             test::labelMeta(grid, "MET_SHORT",
                             "CompressedData = True\nCompressedDataSize = " + std::to_string(packed.size()) + "\n") +
                 packed},
            {"h.mhd", withReplaced(test::labelMeta(grid, "MET_SHORT"), "LOCAL", "k.raw")},
            {"i.nhdr", test::labelNrrd(grid, "short", "raw", "data file: k.raw\n")},
            {"j.nii", test::labelNifti(grid, 8) + test::labelNumbers<std::int32_t>(grid)},
            {"l.nii", test::labelNiftiWide(grid, 2) + test::labelNumbers<std::uint8_t>(grid)},
            {"m.nii.gz",
             test::gzipped(test::labelNiftiWide(grid, 4, true) + test::labelNumbers<std::int16_t>(grid, true))}};
        for (const auto& [name, bytes] : files) {
            const auto file = meshio::readMesh(folder.write(name, bytes));
            QVERIFY2(file.isOk(), file.status().message().c_str());
            QCOMPARE(file.value().structures.size(), std::size_t{3});
            for (std::size_t i = 0; i < 3; ++i) {
                QVERIFY2(isSame(file.value().structures[i], whole.value().structures[i]), name.c_str());
            }
        }
    }

    void layersOverlap_data()
    {
        QTest::addColumn<bool>("isInterleaved");
        QTest::newRow("list first") << true;
        QTest::newRow("list last") << false;
    }
    void layersOverlap()
    {
        QFETCH(bool, isInterleaved);
        test::LabelGrid grid;
        grid.size = {12, 10, 8};
        grid.layers = 2;
        grid.fill([](const Vec3& p) { return (p - Vec3(5, 5, 4)).norm() < 3.6 ? 1 : 0; });
        grid.fill([](const Vec3& p) { return (p - Vec3(5, 5, 4)).norm() < 2.4 ? 1 : p.x() > 10.5 ? 3 : 0; }, 1);
        const std::string names = "Segment0_Name:=organ\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
                                  "Segment1_Name:=lump\nSegment1_LabelValue:=1\nSegment1_Layer:=1\n"
                                  "Segment2_Name:=wall\nSegment2_LabelValue:=3\nSegment2_Layer:=1\n";
        const test::Folder folder;
        const auto file = meshio::readMesh(
            folder.write("a.seg.nrrd", test::labelNrrd(grid, "uchar", "raw", names, false, isInterleaved) +
                                           test::labelNumbers<std::uint8_t>(grid, false, isInterleaved)));
        QVERIFY2(file.isOk(), file.status().message().c_str());
        QCOMPARE(namesOf(file.value()), (Names{"organ", "lump", "wall"}));
        const auto volumeOf = [&file](std::size_t i) {
            return geometry::repair(file.value().structures[i].mesh).report.volume_mm3;
        };
        QVERIFY(volumeOf(0) > 2.0 * volumeOf(1) && volumeOf(1) > 0.0);
        // The fourth axis of NIfTI holds layers too, without names.
        for (const std::string& header : {test::labelNifti(grid, 2), test::labelNiftiWide(grid, 2)}) {
            const auto layers =
                meshio::readMesh(folder.write("a.nii", header + test::labelNumbers<std::uint8_t>(grid, false, false)));
            QVERIFY2(layers.isOk(), layers.status().message().c_str());
            QCOMPARE(namesOf(layers.value()),
                     (Names{"label 1 of layer 1", "label 1 of layer 2", "label 3 of layer 2"}));
            for (std::size_t i = 0; i < 3; ++i) {
                QVERIFY(layers.value().structures[i].mesh.triangles.size() ==
                        file.value().structures[i].mesh.triangles.size());
            }
        }
        // Files of old versions have no layers: each segment has its own.
        const auto old = meshio::readMesh(folder.write(
            "old.seg.nrrd",
            test::labelNrrd(grid, "uchar", "raw", "Segment0_Name:=organ\nSegment1_Name:=lump\n", false, isInterleaved) +
                test::labelNumbers<std::uint8_t>(grid, false, isInterleaved)));
        QVERIFY2(old.isOk(), old.status().message().c_str());
        QCOMPARE(namesOf(old.value()), (Names{"organ", "lump", "label 3 of layer 2"}));
    }

    void namesComeFromOtherPrograms()
    {
        const test::LabelGrid grid = small();
        const std::string bytes = test::labelNumbers<std::uint8_t>(grid);
        const test::Folder folder, beside, other;
        const std::string xml =
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?> <CaretExtension> <VolumeInformation Index=\"0\"> <LabelTable>"
            "<Label Key=\"1\" Red=\"1.0\" Green=\"0.5\" Blue=\"0\" Alpha=\"1\"><![CDATA[spleen]]></Label>\n"
            "<Label Key=\"2\" Red=\"0\" Green=\"0\" Blue=\"2\" Alpha=\"1\"><![CDATA[kidney_right]]></Label>"
            "<Label Key=\"3\" Red=\"0\" Green=\"0\" Blue=\"1\" Alpha=\"1\"><![CDATA[liver]]></Label>"
            "</LabelTable></VolumeInformation></CaretExtension>";
        const auto total =
            meshio::readMesh(folder.write("a.nii.gz", test::gzipped(test::labelNifti(grid, 2, false, xml) + bytes)));
        QVERIFY2(total.isOk(), total.status().message().c_str());
        QCOMPARE(namesOf(total.value()), (Names{"spleen", "kidney_right"}));
        QVERIFY((total.value().structures[0].colour == std::array<double, 3>{1.0, 0.5, 0.0}));
        QVERIFY(!total.value().structures[1].colour); // 2 is no brightness
        QCOMPARE(test::english(total.value().notes), (Names{"no voxels of \"liver\""}));

        const std::string snap =
            "################################################\n"
            "# ITK-SnAP Label Description File\n# File format:\n# IDX   -R-  -G-  -B-  -A--  VIS MSH  LABEL\n"
            "    0     0    0    0        0  0  0    \"Clear Label\"\n"
            "    1   255    0   51        1  1  1    \"left lobe\"\n"
            "    2     0  255    0        1  1  1    \"right lobe\"\n";
        (void)beside.write("labels.txt", snap);
        (void)beside.write("readme.txt", "nothing");
        const auto snapped = meshio::readMesh(beside.write("b.nii", test::labelNifti(grid, 2) + bytes));
        QVERIFY2(snapped.isOk(), snapped.status().message().c_str());
        QCOMPARE(namesOf(snapped.value()), (Names{"left lobe", "right lobe"}));
        QVERIFY((snapped.value().structures[0].colour == std::array<double, 3>{1.0, 0.0, 0.2}));
        QVERIFY(test::mentions(snapped.value().notes, "labels.txt"));
        (void)beside.write("other.label", snap); // now it is not certain which one belongs to the file
        const auto uncertain = meshio::readMesh(beside.path("b.nii"));
        QCOMPARE(namesOf(uncertain.value()), (Names{"label 1", "label 2"}));
        (void)beside.write("b.label", withReplaced(snap, "left lobe", "caudate"));
        QCOMPARE(namesOf(meshio::readMesh(beside.path("b.nii")).value()), (Names{"caudate", "right lobe"}));

        const auto table = meshio::readMesh(other.write("total_ct.nii", test::labelNifti(grid, 2) + bytes));
        QCOMPARE(namesOf(table.value()), (Names{"spleen", "kidney_right"}));
        QVERIFY(test::mentions(table.value().notes, "TotalSegmentator"));
        const auto brain = meshio::readMesh(other.write("aparc+aseg.nii", test::labelNifti(grid, 2) + bytes));
        QCOMPARE(namesOf(brain.value()), (Names{"label 1", "Left-Cerebral-White-Matter"}));
    }

    void aMaskHasTheNameOfItsFile()
    {
        test::LabelGrid grid = small();
        std::replace(grid.values.begin(), grid.values.end(), 2, 0);
        const test::Folder folder;
        const auto file = meshio::readMesh(folder.write(
            "liver.nii.gz", test::gzipped(test::labelNifti(grid, 2) + test::labelNumbers<std::uint8_t>(grid))));
        QVERIFY2(file.isOk(), file.status().message().c_str());
        QCOMPARE(namesOf(file.value()), (Names{"liver"}));
    }

    void equalNamesDiffer()
    {
        const test::LabelGrid grid = small();
        const test::Folder folder;
        const auto file = meshio::readMesh(
            folder.write("a.nrrd", test::labelNrrd(grid, "uchar", "raw",
                                                   "Segment0_Name:=cyst\nSegment0_LabelValue:=1\nSegment1_Name:=cyst\n"
                                                   "Segment1_LabelValue:=2\n") +
                                       test::labelNumbers<std::uint8_t>(grid)));
        QVERIFY2(file.isOk(), file.status().message().c_str());
        QCOMPARE(namesOf(file.value()), (Names{"cyst", "cyst 2"}));
    }

    void whatTouchesTheBorderIsClosed()
    {
        test::LabelGrid grid;
        grid.size = {5, 4, 3};
        grid.values.assign(60, 9);
        const test::Folder folder;
        const auto file = meshio::readMesh(
            folder.write("a.mha", test::labelMeta(grid, "MET_INT") + test::labelNumbers<std::int32_t>(grid)));
        QVERIFY2(file.isOk(), file.status().message().c_str());
        const geometry::MeshReport report = geometry::repair(file.value().structures.front().mesh).report;
        QVERIFY(report.isClosed());
        QVERIFY(report.volume_mm3 > 50.0 && report.volume_mm3 < 60.0); // 60 without the bevelled edges
        QVERIFY(report.bounds.min().isApprox(Vec3::Constant(-0.5)) &&
                report.bounds.max().isApprox(Vec3(4.5, 3.5, 2.5)));
    }

    void anOrganIncludesWhatItEncloses()
    {
        // A ball with a tumour (2), a hole (0), and a tumour at its border (3) that opens into the background.
        test::LabelGrid grid;
        grid.size = {44, 44, 44};
        grid.fill([](const Vec3& p) {
            const double all = (p - Vec3::Constant(22.0)).norm();
            return (p - Vec3(22, 22, 14)).norm() < 5.0   ? 2
                   : (p - Vec3(22, 22, 30)).norm() < 5.0 ? 0
                   : all < 20.0 && p.x() > 38.0          ? 3
                   : all < 20.0                          ? 1
                                                         : 0;
        });
        const test::Folder folder;
        const auto scene = meshio::loadScene(
            folder.write("a.nrrd", test::labelNrrd(grid, "uchar", "raw") + test::labelNumbers<std::uint8_t>(grid)));
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        const auto& structures = scene.value().structures;
        QCOMPARE(structures.size(), std::size_t{3});
        const geometry::MeshReport& organ = structures[0].surface->report;
        QCOMPARE(organ.components, std::size_t{2}); // with the hole, without a cavity for the tumour
        QVERIFY(organ.bounds.max().x() < 39.0);
        const double ball_mm3 = 4.0 / 3.0 * std::numbers::pi * std::pow(5.0, 3);
        const double all_mm3 = 64.0 * ball_mm3; // four times the radius
        constexpr double kCap = 4.0;            // height of the cap at the border
        const double cap_mm3 = std::numbers::pi * kCap * kCap * (20.0 - kCap / 3.0);
        QVERIFY2(std::abs(organ.volume_mm3 / (all_mm3 - cap_mm3 - ball_mm3) - 1.0) < 0.03,
                 qPrintable(QString::number(organ.volume_mm3)));
        QVERIFY(test::mentions(scene.value().warnings, "\"label 1\" includes what it encloses, "));
        QVERIFY(!test::mentions(scene.value().warnings, "\"label 2\" includes"));
    }

    void oneVoxelSurvives()
    {
        test::LabelGrid grid;
        grid.size = {9, 9, 9};
        grid.fill([](const Vec3&) { return 0; });
        grid.at(4, 4, 4) = 1;
        grid.at(1, 1, 1) = grid.at(1, 1, 2) = 2;
        const test::Folder folder;
        const auto scene = meshio::loadScene(
            folder.write("a.nrrd", test::labelNrrd(grid, "uchar", "raw") + test::labelNumbers<std::uint8_t>(grid)));
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        QCOMPARE(scene.value().structures.size(), std::size_t{2});
        for (const meshio::LoadedStructure& one : scene.value().structures) {
            QVERIFY(one.surface->report.volume_mm3 > 0.05);
        }
        QVERIFY(test::mentions(scene.value().warnings,
                               "structures of at most 8 voxels, whose shape is uncertain: \"label 1\""));
    }

    void sideAndFrame()
    {
        // A NIfTI without sform and qform, as VTK writes it, does not state its axes: they can be chosen.
        test::LabelGrid grid = small();
        std::string bytes = test::labelNifti(grid, 2);
        bytes[254] = 0;
        const test::Folder folder;
        const auto path = folder.write("a.nii", bytes + test::labelNumbers<std::uint8_t>(grid));
        const auto untagged = meshio::readMesh(path);
        QVERIFY2(untagged.isOk(), untagged.status().message().c_str());
        QCOMPARE(untagged.value().frame, core::FileFrame::Untagged);
        meshio::ReadOptions ras;
        ras.frame = core::FileFrame::Ras;
        const auto turned = meshio::readMesh(path, ras);
        const Vec3 a = untagged.value().structures[0].mesh.vertices[0],
                   b = turned.value().structures[0].mesh.vertices[0];
        QVERIFY((b - Vec3(-a.x(), -a.y(), a.z())).norm() == 0.0);
        QCOMPARE(
            meshio::readMesh(folder.write("b.nii", test::labelNifti(grid, 2) + test::labelNumbers<std::uint8_t>(grid)))
                .value()
                .frame,
            core::FileFrame::Ras);
    }

    void qformPlacesLikeSform()
    {
        // Half a turn about z, and the third axis mirrored (qfac = -1).
        test::LabelGrid grid = small();
        grid.steps = Vec3(1, 1, -1).asDiagonal(); // in LPS; in RAS: (-1, -1, -1)
        grid.origin = Vec3(3, 4, 5);
        const std::string numbers = test::labelNumbers<std::uint8_t>(grid);
        std::string header = test::labelNifti(grid, 2);
        const test::Folder folder;
        const auto sform = meshio::readMesh(folder.write("a.nii", header + numbers));
        const auto put = [&header](std::size_t at, auto value) { std::memcpy(&header[at], &value, sizeof(value)); };
        put(252, std::int16_t{1});
        put(254, std::int16_t{0});
        put(76, -1.0F);
        put(256, std::array<float, 6>{0, 0, 1, -3, -4, 5});
        const auto qform = meshio::readMesh(folder.write("b.nii", header + numbers));
        QVERIFY2(sform.isOk() && qform.isOk(), qform.status().message().c_str());
        QVERIFY(isSame(sform.value().structures[0], qform.value().structures[0]));
        QVERIFY(geometry::repair(qform.value().structures[0].mesh).report.volume_mm3 > 0.0);
    }

    void sceneKeepsPartAndSmoothing()
    {
        const test::Folder folder;
        (void)folder.write("case.seg.nrrd", test::labelNrrd(shapes(), "short", "raw", kSegments) +
                                                test::labelNumbers<std::int16_t>(shapes()));
        const auto path =
            folder.write("a.palpate.json", R"({"version": 1, "structures": [{"mesh": "case.seg.nrrd", "part": "tumour"},
            {"mesh": "case.seg.nrrd", "part": "liver", "smoothing": 0.25},
            {"mesh": "case.seg.nrrd", "part": "Milz rückwärts", "surface": "facets"}]})");
        const auto loaded = meshio::loadScene(path);
        QVERIFY2(loaded.isOk(), loaded.status().message().c_str());
        const auto& structures = loaded.value().structures;
        QCOMPARE(structures.size(), std::size_t{3});
        QCOMPARE(structures[0].smoothing->strength, 0.5);
        QCOMPARE(structures[1].smoothing->strength, 0.25);
        QVERIFY(!structures[2].smoothing && structures[2].staircase->isStated);
        QVERIFY(structures[1].smoothing->most_mm < structures[0].smoothing->most_mm + 1.0);
        const auto copy = folder.path("b.palpate.json");
        QVERIFY(meshio::writeScene(copy, loaded.value().scene).isOk());
        const auto again = meshio::readScene(copy);
        QVERIFY(again.isOk());
        for (std::size_t i = 0; i < 3; ++i) {
            QCOMPARE(again.value().structures[i].smoothing, structures[i].description.smoothing);
            QCOMPARE(again.value().structures[i].surface, structures[i].description.surface);
        }
        meshio::ReadOptions steps;
        steps.smoothing = 0.0;
        const auto unsmoothed = meshio::loadScene(folder.path("case.seg.nrrd"), steps);
        QVERIFY(unsmoothed.isOk() && !unsmoothed.value().structures[0].smoothing);
    }

    void theNoteNamesVoxelsAndChange()
    {
        const test::Folder folder;
        const test::LabelGrid grid = shapes(Vec3(1, 1, 2));
        const auto loaded = meshio::loadScene(folder.write("a.nrrd", test::labelNrrd(grid, "short", "raw", kSegments) +
                                                                         test::labelNumbers<std::int16_t>(grid)));
        QVERIFY(loaded.isOk());
        const meshio::LoadedStructure& one = loaded.value().structures[1];
        const std::vector<std::string> warnings = test::english(loaded.value().warnings);
        const auto note = std::find_if(warnings.begin(), warnings.end(), [](const std::string& line) {
            return line.starts_with(
                "tumour: surface from a label map of 1 × 1 × 2 mm voxels, smoothed by 0.5: volume changed by ");
        });
        QVERIFY(note != warnings.end());
        qInfo("%s", note->c_str());
        double farthest_mm = 0.0; // both numbers are measured
        for (std::size_t i = 0; i < one.surface->mesh.vertices.size(); ++i) {
            farthest_mm = std::max(farthest_mm, (one.surface->mesh.vertices[i] - one.asRead->mesh.vertices[i]).norm());
        }
        QCOMPARE(one.smoothing->most_mm, farthest_mm);
        QVERIFY(note->ends_with("at most " + core::shortNumber(farthest_mm, 2) + " mm from the voxel boundary"));
        QCOMPARE(one.smoothing->volumeAfter_mm3, one.surface->report.volume_mm3);
        QCOMPARE(one.smoothing->volumeBefore_mm3, one.asRead->report.volume_mm3);
    }

    void whatIsNoLabelMapIsNamed_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* what, const char* name, const std::string& bytes, const char* said) {
            QTest::newRow(what) << QString(name) << QByteArray::fromStdString(bytes) << QString(said);
        };
        test::LabelGrid grid = small();
        for (std::size_t n = 0; n < grid.values.size(); ++n) {
            grid.values[n] = static_cast<int>(n * 7919 % 101);
        }
        row("MR", "v.nii", test::labelNifti(grid, 4) + test::labelNumbers<std::int16_t>(grid),
            "v.nii: a NIfTI volume with 100 intensities, not labels; expected a label map: whole numbers from 0, one "
            "for "
            "each structure. A CT or MR image is segmented first (3D Slicer, TotalSegmentator), or shown in the "
            "sections of an open scene (View › Section plane › Show an image…).");
        grid.values[5] = -1000;
        row("CT", "v.mha", test::labelMeta(grid, "MET_SHORT") + test::labelNumbers<std::int16_t>(grid),
            "v.mha: a MetaImage volume with 101 intensities, not labels");
        std::string halves;
        for (int n = 0; n < 240; ++n) {
            test::appendRaw(halves, 0.5F * static_cast<float>(n % 4));
        }
        row("no whole numbers", "v.nrrd", test::labelNrrd(grid, "float", "raw") + halves,
            "v.nrrd: a NRRD volume with 3 intensities, not labels");
        row("nothing", "v.nii", test::labelNifti(grid, 2) + std::string(240, '\0'),
            "v.nii: a NIfTI volume without labels: every voxel is 0");
    }
    void whatIsNoLabelMapIsNamed() { refuse(); }

    void whatIsWrongIsRefused_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* what, const char* name, const std::string& bytes, const char* said) {
            QTest::newRow(what) << QString(name) << QByteArray::fromStdString(bytes) << QString(said);
        };
        test::LabelGrid grid = small();
        const std::string bytes = test::labelNumbers<std::uint8_t>(grid);
        const std::string nrrd = test::labelNrrd(grid, "uchar", "raw"), meta = test::labelMeta(grid, "MET_UCHAR");
        const auto nifti = [&](std::size_t at, auto value) {
            std::string text = test::labelNifti(grid, 2);
            std::memcpy(&text[at], &value, sizeof(value));
            return text + bytes;
        };
        row("sheared", "v.nrrd", withReplaced(nrrd, "(0,1,0)", "(0.5,1,0)") + bytes,
            "v.nrrd: header: axes 1 and 2 are sheared by 26.6°; expected perpendicular axes");
        row("sheared sform", "v.nii", nifti(284, 0.25F), "v.nii: header: axes 1 and 2 are sheared by 14°");
        row("in a plane", "v.nrrd", withReplaced(nrrd, "(0,1,0)", "(2,0,0)") + bytes,
            "v.nrrd: header: axes that lie in one plane");
        row("no length", "v.mha", withReplaced(meta, "ElementSpacing = 1 1 1", "ElementSpacing = 1 0 1") + bytes,
            "v.mha: header: voxels of 1 × 0 × 1 mm; expected three axes that are not in one plane, with a voxel size "
            "above 0");
        row("no numbers", "v.nii", nifti(280, std::nanf("")), "v.nii: header: voxels of ");
        row("cut off", "v.nrrd", nrrd + bytes.substr(0, 200),
            "v.nrrd: 240 voxels declared; expected as many as its 200 bytes can hold");
        row("cut off gzip", "v.nrrd", test::labelNrrd(grid, "uchar", "gzip") + test::gzipped(bytes).substr(0, 20),
            "v.nrrd: ");
        row("fewer in the gzip", "v.nii.gz", test::gzipped(test::labelNifti(grid, 2) + bytes.substr(0, 100)),
            "v.nii.gz: 100 of 240 bytes of voxels");
        row("more than declared", "v.nrrd", withReplaced(nrrd, "sizes: 8 6 5", "sizes: 8 6 4") + bytes,
            "v.nrrd: more bytes than its 192 voxels have; expected 192 bytes of voxels");
        row("more in the gzip", "v.nrrd",
            withReplaced(test::labelNrrd(grid, "uchar", "gzip"), "sizes: 8 6 5", "sizes: 8 6 4") + test::gzipped(bytes),
            "v.nrrd: more bytes than its 192 voxels have");
        row("too many", "v.mha", withReplaced(meta, "DimSize = 8 6 5", "DimSize = 80000 60000 5") + bytes,
            "v.mha: header: 80,000 × 60,000 × 5 voxels; expected 1 to 1,073,741,824 voxels");
        row("a bomb", "v.nrrd",
            withReplaced(test::labelNrrd(grid, "uchar", "gzip"), "sizes: 8 6 5", "sizes: 1000 1000 1000") +
                test::gzipped(bytes),
            "v.nrrd: 1,000,000,000 voxels declared");
        row("no count", "v.nii", nifti(42, std::int16_t{-3}), "v.nii: header: dim");
        row("no count, NIfTI-2", "v.nii", test::labelNiftiWide(grid, 2).replace(24, 8, std::string(8, '\xff')) + bytes,
            "v.nii: header: dim");
        row("too many, NIfTI-2", "v.nii", test::labelNiftiWide(grid, 2).replace(28, 4, std::string(4, '\x0f')) + bytes,
            "v.nii: header: ");
        row("no type", "v.nii", nifti(70, std::int16_t{128}), "v.nii: header: datatype: 128");
        row("voxels in the header", "v.nii", nifti(108, 8.0F), "v.nii: header: vox_offset: 8; expected the byte");
        row("five axes", "v.nrrd", withReplaced(nrrd, "dimension: 3", "dimension: 5") + bytes,
            "v.nrrd: header: dimension: \"5\"; expected 3 or 4");
        row("text", "v.nrrd", test::labelNrrd(grid, "uchar", "ascii") + "1 2 3",
            "v.nrrd: header: encoding: \"ascii\"; expected \"raw\" or \"gzip\"");
        row("no end", "v.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\n", "v.nrrd: line 3: the header does not end");
        row("a field twice", "v.nrrd", withReplaced(nrrd, "endian: little", "endian: little\nsizes: 1 1 1") + bytes,
            "v.nrrd: line 10: \"sizes\" a second time");
        row("no data file", "v.nhdr", withReplaced(nrrd, "encoding", "data file: away.raw\nencoding"),
            "v.nhdr: header: file of the voxels: no file \"away.raw\"");
        row("a file elsewhere", "v.nhdr", withReplaced(nrrd, "encoding", "data file: ../away.raw\nencoding"),
            "v.nhdr: header: file of the voxels: \"../away.raw\"; expected a file in this folder or below it");
        row("an absolute path", "v.mhd", withReplaced(meta, "LOCAL", "/dev/zero"),
            "v.mhd: header: file of the voxels: \"/dev/zero\"");
        row("a pattern", "v.mhd", withReplaced(meta, "LOCAL", "slice%d.raw 0 1 0"), "v.mhd: header: ElementDataFile: ");
        row("a pair of files", "v.nii", withReplaced(test::labelNifti(grid, 2), "n+1", "ni1") + bytes,
            "v.nii: header: voxels in a separate .img file");
    }
    void whatIsWrongIsRefused() { refuse(); }

    void anImageInAFolderIsLeftOut()
    {
        const test::LabelGrid grid = small();
        const test::Folder folder;
        (void)folder.write("liver.nii", test::labelNifti(grid, 2) + test::labelNumbers<std::uint8_t>(grid));
        test::LabelGrid image = grid;
        image.values[0] = -1000;
        (void)folder.write("ct.nii", test::labelNifti(image, 4) + test::labelNumbers<std::int16_t>(image));
        const auto loaded = meshio::loadScene(folder.path("."));
        QVERIFY2(loaded.isOk(), loaded.status().message().c_str());
        QCOMPARE(loaded.value().structures.size(), std::size_t{2});
        QVERIFY(loaded.value().losses.empty());
        QVERIFY(
            test::mentions(loaded.value().warnings, "left out: ct.nii: a NIfTI volume with 3 intensities, not labels"));
        // A structure that was not found: TotalSegmentator writes an empty mask for it.
        (void)folder.write("lung.nii", test::labelNifti(grid, 2) + std::string(grid.values.size(), '\0'));
        const auto empty = meshio::loadScene(folder.path("."));
        QVERIFY2(empty.isOk(), empty.status().message().c_str());
        QCOMPARE(empty.value().structures.size(), std::size_t{2});
        QVERIFY(empty.value().losses.empty());
        QVERIFY(test::mentions(empty.value().warnings, "left out: lung.nii: a NIfTI volume without labels"));
    }

    void aLabelMapOfTheReportsOpens()
    {
        PALPATE_SHARED_OR_SKIP(shared, "reports");
        const auto slicer = meshio::loadScene(shared / "15_case.seg.nrrd");
        QVERIFY2(slicer.isOk(), slicer.status().message().c_str());
        QCOMPARE(slicer.value().structures.size(), std::size_t{2});
        QCOMPARE(slicer.value().structures[0].description.name, std::string("liver"));
        QCOMPARE(slicer.value().structures[0].description.colour, (std::array<double, 3>{0.87, 0.72, 0.4}));
        QCOMPARE(slicer.value().structures[1].description.name, std::string("tumour"));
        const auto nifti = meshio::readMesh(shared / "15_labels.nii"),
                   nrrd = meshio::readMesh(shared / "15_case.seg.nrrd");
        QVERIFY2(nifti.isOk() && nrrd.isOk(), nifti.status().message().c_str());
        for (std::size_t i = 0; i < 2; ++i) {
            QVERIFY(isSame(nifti.value().structures[i], nrrd.value().structures[i]));
        }
    }

  private:
    static void refuse()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QFETCH(QString, said);
        const test::Folder folder;
        const auto file = meshio::readMesh(folder.write(name.toStdString(), bytes.toStdString()));
        QVERIFY(!file.isOk());
        const std::string& message = file.status().message();
        QVERIFY2(message.starts_with(said.toStdString()), message.c_str());
        QVERIFY(message.find('\n') == std::string::npos);
        QVERIFY2(message.find("; expected ") != std::string::npos, message.c_str());
    }
};

PALPATE_TEST(LabelMaps)
#include "tst_LabelMaps.moc"
