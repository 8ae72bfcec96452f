// SPDX-License-Identifier: BSD-3-Clause
#include "Samples.h"
#include "TestRunner.h"

#include <palpate/meshio/CurveFile.h>

#include <numbers>
#include <sys/stat.h>

using namespace palpate;

class SceneFile : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void givesBackWhatWasWritten();
    void anExerciseHidesItsTargets();
    void meshPathsAreRelative();
    void keepsFieldsThatItDoesNotKnow();
    void absentFieldsHaveDefaults();
    void wrongFieldIsNamedByItsPath_data();
    void wrongFieldIsNamedByItsPath();
    void lawsComeBackAsTheyWere();
    void aCurveInAFileIsKeptAsPoints();
    void aWrongCurveIsNamedByItsLine_data();
    void aWrongCurveIsNamedByItsLine();
    void newerVersionIsRefused();
    void aPipeIsNotReplaced();
    void onlyJsonIsAScene();
};

void SceneFile::givesBackWhatWasWritten()
{
    const test::Folder folder;
    meshio::SceneFile scene;
    meshio::SceneStructure s;
    s.mesh = folder.path("liver ä.vtp");
    s.part = "lobe";
    s.unit_mm = 1000.0;
    s.name = "left lobe";
    s.colour = {0.1, 1.0 / 3.0, 1.0};
    s.opacity = 0.3;
    s.visible = false;
    s.palpable = false;
    s.flipped = true;
    s.tissue.stiffness_N_per_mm = 0.7;
    s.tissue.damping_Ns_per_mm = 1e-3;
    s.layer = 2;
    s.X_WM = Eigen::Translation3d(1.0 / 3.0, -2.0, 1e6) *
             Eigen::AngleAxisd(std::numbers::pi / 7.0, core::Vec3(1, 2, 3).normalized());
    scene.structures = {s};
    scene.camera = meshio::SceneCamera{{{1, 2, 3}, {4, 5, 6}, {0, 1, 0}, 25.0}, {}};
    scene.shownMap = meshio::ShownMap{"left lobe", "felt:stiffness"};
    scene.image = folder.path("images/ct.nii.gz");
    scene.imageWindow = geometry::GreyWindow{40.5, 350.0};
    scene.section = meshio::SceneSection{meshio::SectionDirection::Coronal, {1, -2.5, 1.0 / 3.0}, {0, -1, 0}, {}};
    scene.findings = {{"lump", {7, 8, 9.25}, "hard", "left lobe", 1.75, 0.0}, {"bare", {1, 0, 0}}};
    scene.tapes = {{"Tape 1", {1, 2, 3.125}, {4, 5, 1.0 / 3.0}, "left lobe", "lump", {}}};
    const auto path = folder.path("a.palpate.json");
    QVERIFY(meshio::writeScene(path, scene).isOk());
    const auto back = meshio::readScene(path);
    QVERIFY2(back.isOk(), back.status().message().c_str());
    QCOMPARE(back.value().structures.size(), std::size_t{1});
    QVERIFY(back.value().tapes == scene.tapes);
    const meshio::SceneStructure& b = back.value().structures[0];
    QCOMPARE(b.mesh, s.mesh);
    QCOMPARE(b.part, s.part);
    QVERIFY(b.unit_mm == s.unit_mm && b.name == s.name && b.colour == s.colour && b.opacity == s.opacity);
    QVERIFY(!b.visible && !b.palpable && b.flipped && b.layer == 2U);
    QVERIFY(b.tissue.stiffness_N_per_mm == 0.7 && b.tissue.damping_Ns_per_mm == 1e-3);
    QVERIFY(b.X_WM.matrix() == s.X_WM.matrix());
    QVERIFY(back.value().camera.has_value());
    QVERIFY(back.value().camera->position_W == core::Vec3(1, 2, 3) && back.value().camera->viewAngle_deg == 25.0);
    QVERIFY(back.value().camera->focus_W == core::Vec3(4, 5, 6) && back.value().camera->up_W == core::Vec3(0, 1, 0));
    QVERIFY(back.value().shownMap == scene.shownMap);
    QCOMPARE(back.value().image, scene.image);
    QVERIFY(back.value().section == scene.section && back.value().imageWindow == scene.imageWindow);
    QCOMPARE(back.value().findings.size(), std::size_t{2});
    const core::Finding& found = back.value().findings[0];
    QVERIFY(found.p_W == core::Vec3(7, 8, 9.25) && found.note == "hard" && found.extra.empty());
    QVERIFY(found.structure == "left lobe" && found.force_N == 1.75 && found.depth_mm == 0.0);
    const core::Finding& bare = back.value().findings[1];
    QVERIFY(bare.structure.empty() && !bare.force_N && !bare.depth_mm);
}

void SceneFile::anExerciseHidesItsTargets()
{
    const test::Folder folder;
    const auto path = folder.write("a.json", R"({"version": 1, "structures": [{"mesh": "a.stl", "name": "a"},
        {"mesh": "b.stl", "name": "b"}], "exercise": {"targets": ["b"], "time_s": 300, "force_ceiling_N": 4.5,
        "coverage_goal": 0.9, "level": "hard"}})");
    auto scene = meshio::readScene(path);
    QVERIFY2(scene.isOk(), scene.status().message().c_str());
    QVERIFY(!scene.value().structures[0].isHiddenTarget && scene.value().structures[1].isHiddenTarget);
    QVERIFY(scene.value().structures[1].visible);
    const meshio::Exercise exercise = scene.value().exercise.value();
    QVERIFY(exercise.targets == std::vector<std::string>{"b"});
    QVERIFY(exercise.time_s == 300.0 && exercise.force_ceiling_N == 4.5 && exercise.coverage_goal == 0.9);
    QVERIFY(meshio::unknownFields(scene.value()) == std::vector<std::string>{"exercise.level"});
    QVERIFY(meshio::writeScene(path, scene.value()).isOk());
    QVERIFY(meshio::readScene(path).value().exercise == exercise);

    const auto bare = meshio::readScene(folder.write(
        "b.json", R"({"version": 1, "structures": [{"mesh": "a.stl", "name": "a"}], "exercise": {"targets": ["a"]}})"));
    const meshio::Exercise& open = bare.value().exercise.value();
    QVERIFY(!open.time_s && !open.force_ceiling_N && !open.coverage_goal);
}

void SceneFile::meshPathsAreRelative()
{
    const test::Folder folder;
    std::filesystem::create_directories(folder.path("scenes/deep"));
    meshio::SceneFile scene;
    scene.structures.resize(1);
    scene.structures[0].mesh = folder.path("meshes/a.stl");
    const auto path = folder.path("scenes/deep/a.palpate.json");
    QVERIFY(meshio::writeScene(path, scene).isOk());
    QVERIFY(test::fileBytes(path).find("\"../../meshes/a.stl\"") != std::string::npos);
    QCOMPARE(meshio::readScene(path).value().structures[0].mesh, folder.path("meshes/a.stl"));
}

void SceneFile::keepsFieldsThatItDoesNotKnow()
{
    const test::Folder folder;
    const auto path = folder.write("a.json", R"({"version": 1, "author": {"name": "ä"}, "structures":
        [{"mesh": "a.stl", "breathing": [0.5, 1]}], "camera": {"lens": 2},
        "section": {"direction": "free", "point": [0, 0, 1], "normal": [0, 3, 4], "thick": 2},
        "findings": [{"name": "a", "size": 3}], "tapes": [{"from": [0, 0, 0], "to": [0, 0, 1], "along": true}]})");
    const auto scene = meshio::readScene(path);
    QVERIFY2(scene.isOk(), scene.status().message().c_str());
    QVERIFY(meshio::writeScene(path, scene.value()).isOk());
    const std::string text = test::fileBytes(path);
    QVERIFY2(text.find("\"breathing\"") != std::string::npos && text.find("\"name\": \"ä\"") != std::string::npos,
             text.c_str());
    const auto again = meshio::readScene(path);
    QCOMPARE(again.value().extra, scene.value().extra);
    QCOMPARE(again.value().structures[0].extra, scene.value().structures[0].extra);
    QCOMPARE(again.value().camera->extra, std::string("{\"lens\":2}"));
    QCOMPARE(again.value().section->extra, std::string("{\"thick\":2}"));
    QVERIFY((again.value().section->n_W - core::Vec3(0, 0.6, 0.8)).norm() < 1e-15);
    QCOMPARE(again.value().findings[0].extra, std::string("{\"size\":3}"));
    QCOMPARE(again.value().tapes[0].extra, std::string("{\"along\":true}"));
}

void SceneFile::absentFieldsHaveDefaults()
{
    const test::Folder folder;
    const auto scene =
        meshio::readScene(folder.write("a.json", R"({"version": 1, "structures": [{"mesh": "sub/liver.stl"}]})"));
    QVERIFY2(scene.isOk(), scene.status().message().c_str());
    const meshio::SceneStructure& s = scene.value().structures[0];
    QCOMPARE(s.name, std::string("liver"));
    QCOMPARE(s.mesh, folder.path("sub/liver.stl"));
    QVERIFY(s.unit_mm == 1.0 && s.opacity == 1.0 && s.visible && s.palpable && !s.flipped && s.layer == 0U);
    QVERIFY(s.tissue.stiffness_N_per_mm == 0.5 && s.tissue.damping_Ns_per_mm == 0.0 && s.extra.empty());
    QVERIFY(!scene.value().camera.has_value());
}

void SceneFile::wrongFieldIsNamedByItsPath_data()
{
    QTest::addColumn<std::string>("json");
    QTest::addColumn<std::string>("message");
    const auto field = [](const char* text, const char* message) {
        QTest::newRow(text) << R"({"version": 1, "structures": [{"mesh": "a.stl"}, {"mesh": "b.stl", )" +
                                   std::string(text) + "}]}"
                            << "a.json: structures[1]." + std::string(message);
    };
    const auto shown = [](const char* name, const char* text, const char* message) {
        QTest::newRow(name) << R"({"version": 1, "structures": [{"mesh": "a.stl", "name": "a"}], "shown_map": )" +
                                   std::string(text) + "}"
                            << "a.json: shown_map." + std::string(message);
    };
    shown("shown map of nothing", R"({"structure": "b", "numbers": "felt:stiffness"})",
          "structure: found \"b\", expected the name of a structure of this scene");
    shown("shown map of no kind", R"({"structure": "a", "numbers": "stiffness"})",
          "numbers: found \"stiffness\", expected `felt:` and a quantity, or `array:` and its name");
    field(R"("opacity": 3)", "opacity: found 3, expected 0 to 1");
    field(R"("opacity": "much")", "opacity: found \"much\", expected 0 to 1");
    field(R"("colour": [1, 0])", "colour: found an array of 2, expected 3 numbers");
    field(R"("colour": [1, 0, 2])", "colour[2]: found 2, expected 0 to 1");
    field(R"("visible": 1)", "visible: found 1, expected true or false");
    field(R"("layer": 1.5)", "layer: found a fraction, expected a whole number");
    field(R"("unit_mm": 0)", "unit_mm: found 0, expected 0.000001 to 1000000");
    field(R"("stiffness_N_per_mm": -1)", "stiffness_N_per_mm: found -1, expected 0 to 1000");
    field(R"("pose": [1,0,0,0, 0,2,0,0, 0,0,1,0, 0,0,0,1])", "pose: found a matrix that is not rigid");
    field(R"("pose": [1,0,0,0, 0,1,0,0, 0,0,-1,0, 0,0,0,1])", "pose: found a matrix that is not rigid");
    field(R"("name": null)", "name: found null, expected a text");
    field(R"("stiffness_N_per_mm": 1001)", "stiffness_N_per_mm: found 1001, expected 0 to 1000");
    field(R"("stiffness_N_per_mm": null)", "stiffness_N_per_mm: found null, expected 0 to 1000");
    field(R"("damping_Ns_per_mm": -0.001)", "damping_Ns_per_mm: found -0.001, expected 0 to 1000");
    field(R"("damping_Ns_per_mm": 1e4)", "damping_Ns_per_mm: found 10000, expected 0 to 1000");
    field(R"("friction": 0.3)", "friction: found 0.3, expected an object");
    field(R"("friction": {"static": -0.1})", "friction.static: found -0.1, expected 0 to 5");
    field(R"("friction": {"static": 5.1})", "friction.static: found 5.1, expected 0 to 5");
    field(R"("friction": {"static": null})", "friction.static: found null, expected 0 to 5");
    field(R"("friction": {"static": "nan"})", "friction.static: found \"nan\", expected 0 to 5");
    field(R"("friction": {"static": 0.3, "dynamic": -0.1})", "friction.dynamic: found -0.1, expected 0 to 5");
    field(R"("friction": {"static": 0.3, "dynamic": 0.31})",
          "friction.dynamic: found 0.31, expected at most `static`, which is 0.3");
    field(R"("friction": {"dynamic": 0.1})", "friction.dynamic: found 0.1, expected at most `static`, which is 0");
    field(R"("friction": {"static": 0.3, "drag_Ns_per_mm": -1})",
          "friction.drag_Ns_per_mm: found -1, expected 0 to 1000");
    field(R"("law": {"kind": "hertz", "young_kPa": 0})", "law.young_kPa: found 0, expected 0.001 to");
    field(R"("law": {"kind": "hertz", "radius_mm": -8})", "law.radius_mm: found -8, expected 0.001 to 1000");
    field(R"("law": {"kind": "layer", "thickness_mm": 0})", "law.thickness_mm: found 0, expected 0.01 to 1000");
    field(R"("law": {"kind": "click", "F1_N": 1, "F2_N": 2})", "law: F2_N: found 2, expected at most 1 (F1_N)");
    field(R"("law": {"kind": "click", "fall_mm": 0})", "law.fall_mm: found 0, expected 0.001 to 25");
    field(R"("law": "hertz")", "law: found \"hertz\", expected an object");
    field(R"("law": {})", "law.kind: found nothing, expected one of linear, exponential, hertz, layer, click, points");
    field(R"("law": {"kind": "fung"})", "law.kind: found \"fung\", expected one of linear, exponential");
    field(R"("law": {"kind": "exponential", "k0_N_per_mm": -0.1})",
          "law.k0_N_per_mm: found -0.1, expected 0.000001 to 1000");
    field(R"("law": {"kind": "exponential", "beta_per_mm": "steep"})", "law.beta_per_mm: found \"steep\"");
    field(R"("law": {"kind": "exponential", "k0_N_per_mm": 3})",
          "law: k0_N_per_mm: found 3, expected at most 2 (k_max_N_per_mm)");
    field(R"("law": {"kind": "layer", "bonded": 1})", "law.bonded: found 1, expected true or false");
    field(R"("law": {"kind": "points"})", "law.points: found nothing, expected points");
    field(R"("law": {"kind": "points", "points": [[0, 0], [1, 1]], "file": "a.csv"})", "law.points: found both");
    field(R"("law": {"kind": "points", "points": [[0, 0], [1]]})", "law.points[1]: found an array of 1");
    field(R"("law": {"kind": "points", "points": [[0, 0], [1, null]]})", "law.points[1]: found an array of 2");
    field(R"("law": {"kind": "points", "points": [[0, 0.2], [1, 1]]})", "law: point 1 of 2: found (0 mm, 0.2 N)");
    field(R"("law": {"kind": "points", "points": [[0, 0], [2, 1], [1, 2]]})", "law: point 3 of 3: found (1 mm, 2 N)");
    field(R"("law": {"kind": "points", "points": [[0, 0], [2, -1]]})", "law: point 2 of 2: found (2 mm, -1 N)");
    field(R"("law": {"kind": "points", "points": [[0, 0], [1, 2000]]})",
          "law: point 2 of 2: found (1 mm, 2000 N), a slope of 2000 N/mm");
    field(R"("law": {"kind": "points", "file": "none.csv"})", "law.file: none.csv");
    const auto whole = [](const char* json, const char* message) {
        QTest::newRow(message) << std::string(json) << std::string(message);
    };
    whole(R"({"version": 1, "structures": [{"name": "x"}]})",
          "a.json: structures[0].mesh: found nothing, expected the path of a mesh file");
    whole(R"({"version": 1, "structures": {}})", "a.json: structures: found an object, expected an array");
    whole(R"({"version": 1, "camera": {"position": [0, 0]}})", "a.json: camera.position: found an array of 2");
    whole(R"({"version": 1, "findings": [{"position": [0, 0, "x"]}]})", "a.json: findings[0].position[2]: found \"x\"");
    whole(R"({"version": 1, "findings": [{"position": [0, 0, 0], "force_N": -1}]})",
          "a.json: findings[0].force_N: found -1");
    whole(R"({"version": 1, "tapes": [{"from": [0, 0, 0]}]})", "a.json: tapes[0].to: found nothing, expected a place");
    whole(R"({"version": 1, "tapes": [{"from": [0, 0], "to": [0, 0, 0]}]})",
          "a.json: tapes[0].from: found an array of 2");
    const auto finding = [&whole](const char* text, const char* message) {
        const std::string json = R"({"version": 1, "findings": [{"name": "a"}, {)" + std::string(text) + "}]}";
        whole(json.c_str(), ("a.json: findings[1]." + std::string(message)).c_str());
    };
    finding(R"("type": "tumour")", "type: found \"tumour\", expected one of lump, hard area, soft area, landmark");
    finding(R"("size_mm": -3)", "size_mm: found -3, expected 0 to");
    finding(R"("camera": {"up": [0, 0]})", "camera.up: found an array of 2, expected 3 numbers");
    finding(R"("camera": {"viewAngle_deg": 200})", "camera.viewAngle_deg: found 200, expected 0.1 to 179");
    finding(R"("recording": {"tick": 3})", "recording.file: found nothing, expected the path of a recording");
    finding(R"("recording": {"file": "a.palpate", "tick": 1.5})", "recording.tick: found a fraction");
    finding(R"("recording": {"file": "a.palpate", "sha256": "12"})", "recording.sha256: found \"12\", expected 64 hex");
    finding(R"("marked_utc": "yesterday")", "marked_utc: found \"yesterday\", expected a time in UTC, e.g. 2026");
    finding(R"("layers": [{"force_N": "much"}])", "layers[0].force_N: found \"much\"");
    whole(R"({"structures": []})", "a.json: version: found nothing");
    whole(R"({"version": 1, "structures": [], "image": ""})", "a.json: image: found ");
    whole(R"({"version": 1, "image_window": {"level": 40}})", "a.json: image_window.width: found nothing");
    whole(R"({"version": 1, "image_window": {"level": 40, "width": 0}})", "a.json: image_window.width: found 0");
    whole(R"({"version": 1, "section": {"direction": "oblique"}})", "a.json: section.direction: found \"oblique\"");
    whole(R"({"version": 1, "section": {"normal": [0, 0, 1]}})", "a.json: section.point: found nothing");
    whole(R"({"version": 1, "section": {"point": [0, 0, 0]}})", "a.json: section.normal: found no direction");
    whole(R"({"version": 1, "section": {"direction": "axial", "point": [0, 0, 0], "normal": [1, 0, 0]}})",
          "a.json: section.normal: found no direction, expected three numbers that point to the hidden side");
    field(R"("name": "cut\u0000here")", "name: found \"cut?here\", expected a text without the character U+0000");
    field(R"("opacity": 1, "opacity": 0.5)", "opacity: found twice, expected it once");
    field(R"("friction": {"static": 0.1, "st\u0061tic": 0.2})", "friction.static: found twice, expected it once");
    whole(R"({"version": 1, "x": [{"y": {}}, {"z": "}{,\"", "z": []}], "structures": []})",
          "a.json: x[1].z: found twice, expected it once");
    whole("{\"version\": 1, \"a\\nb\": 1, \"a\\nb\": 2}", "a.json: a\\nb: found twice, expected it once");
    const auto lumps = [](const char* name, const char* structures, const char* message) {
        QTest::newRow(name) << R"({"version": 1, "structures": [)" + std::string(structures) + "]}"
                            << "a.json: structures[" + std::string(message);
    };
    lumps("a lump in nothing", R"({"mesh": "a.stl", "name": "a", "inside": "c"})",
          "0].inside: found \"c\", expected the name of a structure of this scene");
    lumps("two organs of one name",
          R"({"mesh": "a.stl", "name": "a"}, {"mesh": "b.stl", "name": "a"}, {"mesh": "c.stl", "inside": "a"})",
          "2].inside: found \"a\", the name of 2 structures, expected the name of one structure: rename the others");
    lumps("lumps in a circle",
          R"({"mesh": "a.stl", "name": "a", "inside": "b"}, {"mesh": "b.stl", "name": "b", "inside": "a"})",
          "0].inside: found \"b\", which lies inside \"a\", expected the outermost structure around it");
    lumps("a lump in a lump",
          R"({"mesh": "a.stl", "name": "a", "inside": "b"}, {"mesh": "b.stl", "name": "b", "inside": "c"},
             {"mesh": "c.stl", "name": "c"})",
          "0].inside: found \"b\", which lies inside \"c\", expected the outermost structure around it");
    const auto exercise = [](const char* name, const char* fields, const char* message) {
        QTest::newRow(name) << R"({"version": 1, "structures": [{"mesh": "a.stl", "name": "a"}, {"mesh": "b.stl",
            "name": "b"}, {"mesh": "b.stl", "name": "b"}, {"mesh": "c.stl", "name": "c", "palpable": false}],
            "exercise": {)" + std::string(fields) +
                                   "}}"
                            << "a.json: exercise." + std::string(message);
    };
    exercise("an exercise without targets", "", "targets: found nothing, expected the name of at least one structure");
    exercise("an empty list of targets", R"("targets": [])", "targets: found nothing, expected the name of at least");
    exercise("an unknown target", R"("targets": ["a", "d"])",
             "targets[1]: found \"d\", expected the name of a structure of this scene");
    exercise("an ambiguous target", R"("targets": ["b"])", "targets[0]: found \"b\", the name of several structures");
    exercise("a target that is not felt", R"("targets": ["c"])", "targets[0]: found \"c\", which is not palpable");
    exercise("a target twice", R"("targets": ["a", "a"])", "targets[1]: found \"a\" a second time");
    exercise("a negative time", R"("targets": ["a"], "time_s": -1)", "time_s: found -1, expected ");
    exercise("a time without end", R"("targets": ["a"], "time_s": 1e300)", "time_s: found 10³⁰⁰, expected ");
    whole(R"({"version": 1, "exercise": {"targets": ["a"], "time_s": 1e999}})", "a.json: byte ");
    exercise("no force at all", R"("targets": ["a"], "force_ceiling_N": 0)", "force_ceiling_N: found 0, expected ");
    exercise("a force in words", R"("targets": ["a"], "force_ceiling_N": "5")", "force_ceiling_N: found \"5\"");
    exercise("more than all", R"("targets": ["a"], "coverage_goal": 90)", "coverage_goal: found 90, expected ");
    whole(R"({"version": 1, )", "a.json: byte ");
    whole("", "a.json: byte 0: the file is empty");
    whole("[1]", "a.json: byte 0: no JSON object");
}

void SceneFile::wrongFieldIsNamedByItsPath()
{
    QFETCH(std::string, json);
    QFETCH(std::string, message);
    const test::Folder folder;
    const auto scene = meshio::readScene(folder.write("a.json", json));
    QVERIFY(!scene.isOk());
    QVERIFY2(scene.status().message().starts_with(message), scene.status().message().c_str());
    QVERIFY(scene.status().message().find('\n') == std::string::npos);
}

void SceneFile::lawsComeBackAsTheyWere()
{
    const test::Folder folder;
    meshio::SceneFile scene;
    for (const core::LawKind kind : core::kLawKinds) {
        meshio::SceneStructure s;
        s.mesh = folder.path("a.stl");
        s.tissue.law = core::usualLaw(kind);
        for (double& number : s.tissue.law.numbers) {
            number *= 1.0 + 1e-3 / 3.0;
        }
        if (kind == core::LawKind::Layer) {
            s.tissue.law.numbers[3] = 0.0; // not bonded
        } else if (kind == core::LawKind::Points) {
            s.tissue.law.points[1] = {1.0 / 3.0, 0.1};
        }
        scene.structures.push_back(s);
    }
    scene.structures.back().extra = R"({"law": {"probe": "ball of 5 mm"}})";
    const auto path = folder.path("a.palpate.json");
    QVERIFY(meshio::writeScene(path, scene).isOk());
    const std::string text = test::fileBytes(path);
    QVERIFY(text.find("\"linear\"") == std::string::npos); // zero terms are omitted
    auto back = meshio::readScene(path);
    QVERIFY2(back.isOk(), back.status().message().c_str());
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        QVERIFY(back.value().structures[i].tissue == scene.structures[i].tissue);
    }
    QCOMPARE(back.value().structures.back().extra, std::string(R"({"law":{"probe":"ball of 5 mm"}})"));
    back.value().structures.back().tissue.law = {};
    QVERIFY(meshio::writeScene(path, back.value()).isOk());
    const auto again = meshio::readScene(path);
    QVERIFY2(again.isOk(), again.status().message().c_str());
    QVERIFY(again.value().structures.back().tissue.law == core::ForceLaw{});
    QCOMPARE(again.value().structures.back().extra, back.value().structures.back().extra);
}

void SceneFile::aCurveInAFileIsKeptAsPoints()
{
    const test::Folder folder;
    folder.write("curve.csv", "\xEF\xBB\xBFtime_s, depth_mm,force_N\r\n0,0,0\r\n\r\n0.1, 1.5 ,0.25\r\n0.2,3,1e0");
    const auto path = folder.write("a.json", R"({"version": 1, "structures": [{"mesh": "a.stl", "law":
        {"kind": "points", "file": "curve.csv"}}]})");
    const auto scene = meshio::readScene(path);
    QVERIFY2(scene.isOk(), scene.status().message().c_str());
    const std::vector<core::ForceLaw::Point> expected{{0, 0}, {1.5, 0.25}, {3, 1}};
    QVERIFY(scene.value().structures[0].tissue.law.points == expected);
    QVERIFY(scene.value().structures[0].extra.empty());
    QVERIFY(meshio::writeScene(path, scene.value()).isOk());
    std::filesystem::remove(folder.path("curve.csv"));
    const auto again = meshio::readScene(path); // the file is no longer needed
    QVERIFY2(again.isOk(), again.status().message().c_str());
    QVERIFY(again.value().structures[0].tissue.law.points == expected);
}

void SceneFile::aWrongCurveIsNamedByItsLine_data()
{
    QTest::addColumn<std::string>("csv");
    QTest::addColumn<std::string>("message");
    const auto row = [](const char* name, const std::string& csv, const char* message) {
        QTest::newRow(name) << csv << "curve.csv: " + std::string(message);
    };
    const std::string head = "depth_mm,force_N\n";
    row("empty", "", "found 0 points, expected 2 to 64");
    row("no header", "0,0\n1,1\n", "line 1: no column depth_mm");
    row("another unit", "depth_m,force_N\n0,0\n", "line 1: no column depth_mm");
    row("no points", head, "found 0 points, expected 2 to 64");
    row("a word", head + "0,0\n1,much\n", "line 3: force_N is \"much\"");
    row("a cell too few", head + "0,0\n1\n", "line 3: force_N is \"\"");
    row("no number", head + "0,0\n1,nan\n", "line 3: point 2 of 2: found (1 mm, nan N)");
    row("does not ascend", head + "0,0\n\n2,1\n1,2\n", "line 5: point 3 of 3: found (1 mm, 2 N)");
    row("falls below nothing", head + "0,0\n1,-0.1\n", "line 3: point 2 of 2: found (1 mm, -0.1 N)");
    row("no end", head + "0,0\n1,inf\n", "line 3: point 2 of 2: found (1 mm, inf N)");
    row("twice the same depth", head + "0,0\n1,1\n1,1\n", "line 4: point 3 of 3: found (1 mm, 1 N)");
    row("begins with a force", head + "0,0.2\n1,1\n", "line 2: point 1 of 2: found (0 mm, 0.2 N)");
    row("begins in the air", head + "0.5,0\n1,1\n", "line 2: point 1 of 2: found (0.5 mm, 0 N)");
    row("too steep", head + "0,0\n1,1001\n", "line 3: point 2 of 2: found (1 mm, 1001 N), a slope of 1001 N/mm");
    std::string many = head;
    for (int i = 0; i < 65; ++i) {
        many += std::to_string(i) + "," + std::to_string(i) + "\n";
    }
    row("too many", many, "found more points, expected 2 to 64");
    row("bytes", std::string("\0\xFF\xFE,\n", 5), "line 1: no column");
}

void SceneFile::aWrongCurveIsNamedByItsLine()
{
    QFETCH(std::string, csv);
    QFETCH(std::string, message);
    const test::Folder folder;
    const auto points = meshio::readCurve(folder.write("curve.csv", csv));
    QVERIFY(!points.isOk());
    QVERIFY2(points.status().message().starts_with(message), points.status().message().c_str());
}

void SceneFile::newerVersionIsRefused()
{
    const test::Folder folder;
    const auto scene = meshio::readScene(folder.write("a.json", R"({"version": 2, "structures": []})"));
    QCOMPARE(scene.status().code(), core::StatusCode::Mismatch);
}

void SceneFile::aPipeIsNotReplaced()
{
    const test::Folder folder;
    const auto pipe = folder.path("pipe.palpate.json");
    QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
    const core::Status status = meshio::writeScene(pipe, {});
    QVERIFY2(status.message().find("cannot be written: not a file") != std::string::npos, status.message().c_str());
    QVERIFY(std::filesystem::is_fifo(pipe));
}

void SceneFile::onlyJsonIsAScene()
{
    QVERIFY(meshio::isSceneFile("a.palpate.json"));
    QVERIFY(meshio::isSceneFile("A.JSON"));
    QVERIFY(!meshio::isSceneFile("a.vtp"));
    QVERIFY(!meshio::isSceneFile("json"));
}

PALPATE_TEST(SceneFile)
#include "tst_SceneFile.moc"
