// SPDX-License-Identifier: BSD-3-Clause
#include "English.h"
#include "Samples.h"
#include "TestRunner.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>

using namespace palpate;
using core::Vec3;

namespace {

std::array<double, 3> rgb(int r, int g, int b)
{
    return {r / 255.0, g / 255.0, b / 255.0};
}

void writeVtp(const std::filesystem::path& path, std::initializer_list<std::string> names)
{
    std::vector<meshio::MeshStructure> structures;
    for (const std::string& name : names) {
        structures.push_back(test::tetrahedron(name, Vec3(100.0 * static_cast<double>(structures.size()), 0, 0)));
    }
    const core::Status status = meshio::writeMesh(path, structures);
    QVERIFY2(status.isOk(), status.message().c_str());
}

} // namespace

class LoadScene : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void meshFileBecomesAScene();
    void coloursFollowTheNames_data();
    void coloursFollowTheNames();
    void unknownNamesGetDifferentColours();
    void poseFlipAndPartAreApplied();
    void emptyPartMeansAllOfTheFile();
    void folderIsOneScene();
    void missingMeshIsALossAndTheRestOpens();
    void changedMeshIsNamedAndOpened();
    void nothingReadableIsAnError();
    void repairsAreSaid();
    void frameAndUnitAreSaid();
    void cancelStopsIt();
    void progressStaysOnTheCallersThread();
};

void LoadScene::meshFileBecomesAScene()
{
    const test::Folder folder;
    writeVtp(folder.path("both.vtp"), {"liver", "hepatic artery"});
    const auto scene = meshio::loadScene(folder.path("both.vtp"));
    QVERIFY2(scene.isOk(), scene.status().message().c_str());
    QCOMPARE(scene.value().structures.size(), std::size_t{2});
    QCOMPARE(scene.value().scene.structures.size(), std::size_t{2});
    const meshio::SceneStructure& d = scene.value().structures[1].description;
    QCOMPARE(d.part, std::string("hepatic artery"));
    QCOMPARE(d.name, d.part);
    QCOMPARE(d.mesh, folder.path("both.vtp"));
    QVERIFY(d.visible && d.palpable && d.layer == 0U && d.tissue.stiffness_N_per_mm == 0.5 &&
            d.tissue.damping_Ns_per_mm == 0.0);
    QCOMPARE(scene.value().structures[0].surface->mesh.triangles.size(), std::size_t{4});
    QVERIFY(scene.value().warnings.empty());
    QVERIFY(scene.value().losses.empty());
}

void LoadScene::coloursFollowTheNames_data()
{
    QTest::addColumn<std::array<double, 3>>("colour");
    const auto row = [](const char* name, int r, int g, int b) { QTest::newRow(name) << rgb(r, g, b); };
    row("Liver", 221, 130, 101);
    row("capsule_of_the_liver", 221, 130, 101);
    row("right_hepatic_artery", 216, 101, 79);
    row("hepatic_portal_vein", 110, 64, 170);
    row("hepatic_veins", 0, 151, 206);
    row("femur_R", 241, 214, 145);
    row("kidney_capsule_L", 185, 102, 83);
    row("Skin", 177, 122, 101);
    row("Tumour 2", 144, 238, 144);
    row("liver tumors", 144, 238, 144);
    row("lesion-3", 144, 238, 144);
}

void LoadScene::coloursFollowTheNames()
{
    using Colour = std::array<double, 3>;
    QFETCH(const Colour, colour);
    const test::Folder folder;
    writeVtp(folder.path("a.vtp"), {QTest::currentDataTag()});
    const auto scene = meshio::loadScene(folder.path("a.vtp"));
    QVERIFY2(scene.isOk(), scene.status().message().c_str());
    QVERIFY(scene.value().structures[0].description.colour == colour);
}

void LoadScene::unknownNamesGetDifferentColours()
{
    const test::Folder folder;
    writeVtp(folder.path("a.vtp"), {"w1", "w2", "w3", "w4", "w5", "w6", "w7"});
    const auto scene = meshio::loadScene(folder.path("a.vtp"));
    const auto& s = scene.value().structures;
    for (std::size_t i = 0; i < s.size(); ++i) {
        for (std::size_t k = i + 1; k < s.size(); ++k) {
            QVERIFY(s[i].description.colour != s[k].description.colour);
        }
    }
}

void LoadScene::poseFlipAndPartAreApplied()
{
    const test::Folder folder;
    writeVtp(folder.path("a.vtp"), {"one", "two"});
    meshio::SceneFile scene;
    meshio::SceneStructure s;
    s.mesh = folder.path("a.vtp");
    s.part = "two"; // 100 … 124, 0 … 24, 0 … 24
    s.name = "mine";
    s.unit_mm = 10.0;
    s.flipped = true;
    s.X_WM = Eigen::Translation3d(5, 0, 0) * Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()); // x → y, y → −x
    scene.structures = {s};
    QVERIFY(meshio::writeScene(folder.path("a.palpate.json"), scene).isOk());
    const auto loaded = meshio::loadScene(folder.path("a.palpate.json"), {1000.0, {}}); // the scene's unit applies
    QVERIFY2(loaded.isOk(), loaded.status().message().c_str());
    QCOMPARE(loaded.value().structures.size(), std::size_t{1});
    const geometry::RepairedMesh& surface = *loaded.value().structures[0].surface;
    QVERIFY((surface.report.bounds.min() - Vec3(5 - 240, 1000, 0)).norm() < 1e-9);
    QVERIFY((surface.report.bounds.max() - Vec3(5, 1240, 240)).norm() < 1e-9);
    QVERIFY(surface.report.volume_mm3 < 0.0); // reversed
    QCOMPARE(surface.report.insideOutComponents, std::size_t{1});
    QCOMPARE(loaded.value().structures[0].description.name, std::string("mine"));
}

void LoadScene::emptyPartMeansAllOfTheFile()
{
    const test::Folder folder;
    writeVtp(folder.path("a.vtp"), {"one", "two"});
    const auto path =
        folder.write("a.json", R"({"version": 1, "note": 5, "structures": [{"mesh": "a.vtp", "opacity": 0.5}]})");
    const auto loaded = meshio::loadScene(path);
    QVERIFY2(loaded.isOk(), loaded.status().message().c_str());
    QCOMPARE(loaded.value().structures.size(), std::size_t{2});
    QCOMPARE(loaded.value().scene.structures[1].part, std::string("two"));
    QCOMPARE(loaded.value().scene.structures[1].opacity, 0.5);
    QVERIFY(!loaded.value().scene.extra.empty());
}

void LoadScene::folderIsOneScene()
{
    const test::Folder folder;
    folder.write("b.obj", test::kObj);
    folder.write("a.stl", test::asciiStl("x"));
    folder.write("notes.txt", "not a mesh");
    const auto loaded = meshio::loadScene(folder.path(""));
    QVERIFY2(loaded.isOk(), loaded.status().message().c_str());
    QCOMPARE(loaded.value().structures.size(), std::size_t{2});
    QCOMPARE(loaded.value().structures[0].description.mesh.filename(), std::filesystem::path("a.stl"));
    QCOMPARE(loaded.value().structures[1].description.name, std::string("b"));
    const test::Folder none;
    QCOMPARE(meshio::loadScene(none.path("")).status().code(), core::StatusCode::Empty);
}

void LoadScene::missingMeshIsALossAndTheRestOpens()
{
    const test::Folder folder;
    writeVtp(folder.path("a.vtp"), {"one", "two"});
    const auto path = folder.write("a.json", R"({"version": 1, "structures": [{"mesh": "none.stl"},
        {"mesh": "a.vtp", "part": "three"}, {"mesh": "a.vtp", "part": "two"}]})");
    const auto loaded = meshio::loadScene(path);
    QVERIFY2(loaded.isOk(), loaded.status().message().c_str());
    QCOMPARE(loaded.value().structures.size(), std::size_t{1});
    QCOMPARE(loaded.value().losses.size(), std::size_t{2});
    QVERIFY(test::mentions(loaded.value().losses, "none.stl: "));
    QVERIFY(test::mentions(loaded.value().losses, "no structure \"three\""));
}

void LoadScene::changedMeshIsNamedAndOpened()
{
    const test::Folder folder;
    writeVtp(folder.path("a.vtp"), {"one"});
    meshio::SceneFile file;
    file.structures.resize(2);
    file.structures[0].mesh = folder.path("a.vtp");
    file.structures[0].sha256 = meshio::fileHash(folder.path("a.vtp"));
    file.structures[1].mesh = folder.path("gone.stl");
    file.structures[1].tissue.stiffness_N_per_mm = 0.123;
    QCOMPARE(file.structures[0].sha256.size(), std::size_t{64});
    QVERIFY(meshio::writeScene(folder.path("s.palpate.json"), file).isOk());
    const auto same = meshio::loadScene(folder.path("s.palpate.json"));
    QVERIFY2(same.isOk(), same.status().message().c_str());
    QCOMPARE(same.value().losses.size(), std::size_t{1}); // the missing mesh, which a later save must keep
    QCOMPARE(same.value().unopened.size(), std::size_t{1});
    QCOMPARE(same.value().unopened[0].tissue.stiffness_N_per_mm, 0.123);
    QCOMPARE(same.value().structures[0].description.sha256, file.structures[0].sha256);

    writeVtp(folder.path("a.vtp"), {"another", "two"});
    const auto changed = meshio::loadScene(folder.path("s.palpate.json"));
    QVERIFY2(changed.isOk(), changed.status().message().c_str());
    QCOMPARE(changed.value().structures.size(), std::size_t{2});
    QVERIFY(test::mentions(changed.value().losses, "a.vtp: changed since the scene was saved: found SHA-256 "));
    QCOMPARE(meshio::fileHash(folder.path("gone.stl")), std::string());
}

void LoadScene::nothingReadableIsAnError()
{
    const test::Folder folder;
    QCOMPARE(meshio::loadScene(folder.path("none.vtp")).status().code(), core::StatusCode::NotFound);
    QCOMPARE(meshio::loadScene(folder.path("none.json")).status().code(), core::StatusCode::NotFound);
    const auto path = folder.write("a.json", R"({"version": 1, "structures": [{"mesh": "none.stl"}]})");
    const auto loaded = meshio::loadScene(path);
    QCOMPARE(loaded.status().code(), core::StatusCode::NotFound);
    QVERIFY2(loaded.status().message().starts_with("none.stl: "), loaded.status().message().c_str());
    const auto empty = meshio::loadScene(folder.write("b.json", R"({"version": 1, "structures": []})"));
    QCOMPARE(empty.status().code(), core::StatusCode::Empty);
}

void LoadScene::repairsAreSaid()
{
    const test::Folder folder;
    const auto loaded = meshio::loadScene(folder.write("a.obj", test::kObj + "f 1 3 2\nf 1 1 2\n"));
    QVERIFY2(loaded.isOk(), loaded.status().message().c_str());
    QVERIFY(test::mentions(loaded.value().warnings, "a: 1 duplicate triangle left out"));
    QVERIFY(test::mentions(loaded.value().warnings, "a: 1 triangle without area left out"));
    QVERIFY(test::mentions(loaded.value().warnings, "open edges"));
}

void LoadScene::frameAndUnitAreSaid()
{
    const test::Folder folder;
    const auto path = folder.write("a.obj", "v 0 0 0\nv 0.2 0 0\nv 0 0.1 0\nf 1 2 3\n");
    const auto mm = meshio::loadScene(path);
    QVERIFY(test::mentions(mm.value().warnings, "a.obj: no SPACE tag: coordinates taken as LPS"));
    QVERIFY(test::mentions(mm.value().warnings,
                           "a.obj: only 0.2 units wide, taken as mm; looks like metres: open with --unit m"));
    const auto m = meshio::loadScene(path, {1000.0, {}});
    QVERIFY(!test::mentions(m.value().warnings, "looks like"));
    const auto ras = meshio::loadScene(folder.write("r.obj", "# SPACE=RAS\n" + test::kObj));
    QVERIFY(test::mentions(ras.value().warnings, "r.obj: tagged SPACE=RAS"));
    QCOMPARE(ras.value().structures[0].frame, meshio::FileFrame::Ras);
}

void LoadScene::cancelStopsIt()
{
    const test::Folder folder;
    for (int i = 0; i < 6; ++i) {
        folder.write(std::to_string(i) + ".obj", test::kObj);
    }
    for (int stop = 0; stop < 5; ++stop) {
        int calls = 0;
        const auto loaded = meshio::loadScene(folder.path(""), {1.0, [&](double) { return calls++ < stop; }});
        QVERIFY(loaded.isOk() ? calls <= stop : loaded.status().code() == core::StatusCode::Cancelled);
    }
}

void LoadScene::progressStaysOnTheCallersThread()
{
    const test::Folder folder;
    for (int i = 0; i < 40; ++i) {
        folder.write(std::to_string(i) + ".obj", test::kObj);
    }
    const auto caller = std::this_thread::get_id();
    bool isElsewhere = false;
    double last = 0.0;
    const auto loaded = meshio::loadScene(folder.path(""), {1.0, [&](double share) {
                                                                isElsewhere |= std::this_thread::get_id() != caller;
                                                                last = share;
                                                                return true;
                                                            }});
    QVERIFY(loaded.isOk());
    QVERIFY(!isElsewhere);
    QVERIFY(last > 0.0 && last <= 1.0);
}

PALPATE_TEST(LoadScene)
#include "tst_LoadScene.moc"
