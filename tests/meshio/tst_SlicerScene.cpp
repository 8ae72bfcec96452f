// SPDX-License-Identifier: BSD-3-Clause
// Scenes of 3D Slicer (.mrml): names, looks and transforms of the models.
#include "OtherSurfaces.h"
#include "TestRunner.h"

#include <palpate/meshio/LoadScene.h>

#include <cmath>

using namespace palpate;
using core::Vec3;

namespace {

/// A model with its nodes for display and storage.
std::string model(const std::string& number, const std::string& name, const std::string& file,
                  const std::string& transform = "",
                  const std::string& display = "visibility=\"true\" color=\"0.2 0.4 0.6\" opacity=\"0.5\"",
                  const std::string& storage = "coordinateSystem=\"LPS\"")
{
    const std::string references = "display:D" + number + ";storage:S" + number + ";" +
                                   (transform.empty() ? std::string() : "transform:" + transform + ";");
    return "<Model id=\"M" + number + "\" name=\"" + name + "\" hideFromEditors=\"false\" references=\"" + references +
           "\" userTags=\"\"></Model>\n<ModelDisplay id=\"D" + number + "\" name=\"d\" " + display +
           "></ModelDisplay>\n<ModelStorage id=\"S" + number + "\" fileName=\"" + file + "\" " + storage +
           "></ModelStorage>\n";
}

std::string transform(const std::string& id, const std::string& matrix, const std::string& parent = "")
{
    return "<LinearTransform id=\"" + id + "\" name=\"t\" matrixTransformToParent=\"" + matrix + "\"" +
           (parent.empty() ? std::string() : " references=\"transform:" + parent + ";\"") + "></LinearTransform>\n";
}

std::string mrml(const std::string& nodes, const std::string& version = "Slicer5")
{
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<MRML version=\"" + version + "\" userTags=\"\">\n" + nodes +
           "</MRML>\n";
}

const std::string kShift = "1 0 0 100 0 1 0 0 0 0 1 0 0 0 0 1";  // to the right, in RAS
const std::string kQuarter = "0 -1 0 0 1 0 0 0 0 0 1 5 0 0 0 1"; // a quarter about the long axis, and 5 mm up
const std::string kTwice = "2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1";
const std::string kSheared = "1 0.5 0 0 0 1 0 0 0 0 1 0 0 0 0 1";

} // namespace

class SlicerScene : public QObject
{
    Q_OBJECT

    test::Folder m_folder;

    core::Result<meshio::LoadedScene> open(const std::string& bytes)
    {
        m_folder.write("a b.off", test::offBox());
        m_folder.write("liver.off", test::offBox());
        return meshio::loadScene(m_folder.write("scene.mrml", bytes));
    }

  private Q_SLOTS:
    void filesOfOtherComputersAreBesideTheScene()
    {
        for (const char* file : {"/home/anna/case/a%20b.off", "C:/case/a%20b.off", "C:\\case\\a%20b.off",
                                 "\\\\server\\case\\a%20b.off", ".\\a%20b.off"}) {
            const auto scene = open(mrml(model("1", "liver", file)));
            QVERIFY2(scene.isOk() && scene.value().losses.empty(), file);
        }
    }

    void modelsHaveTheirNamesAndLooks()
    {
        const auto scene =
            open(mrml(model("1", "Leber &amp; Galle", "a%20b.off") +
                      model("2", "hidden", "liver.off", "", "visibility=\"false\" color=\"1 0 0\"", "")
                          .replace(0, 0, "<SceneView id=\"V\"><Model id=\"M9\" name=\"copy\"></Model></SceneView>\n") +
                      "<Model id=\"R\" name=\"Red Volume Slice\" hideFromEditors=\"true\"></Model>\n"));
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        QCOMPARE(scene.value().structures.size(), std::size_t{2});
        QVERIFY(scene.value().losses.empty());
        const meshio::SceneStructure& liver = scene.value().structures[0].description;
        QCOMPARE(liver.name, std::string("Leber & Galle"));
        QVERIFY((liver.colour == std::array<double, 3>{0.2, 0.4, 0.6}));
        QCOMPARE(liver.opacity, 0.5);
        QVERIFY(liver.visible);
        QVERIFY(liver.frame == core::FileFrame::Lps);
        const meshio::SceneStructure& hidden = scene.value().structures[1].description;
        QCOMPARE(hidden.name, std::string("hidden"));
        QVERIFY(!hidden.visible && hidden.opacity == 1.0 && hidden.frame == core::FileFrame::Untagged);
    }

    void transformsAreApplied_data()
    {
        QTest::addColumn<std::string>("nodes");
        QTest::addColumn<Vec3>("low");
        QTest::addColumn<Vec3>("high");
        const Vec3 low(10, 20, 30), high(50, 50, 50);
        QTest::newRow("none") << model("1", "a", "liver.off") << low << high;
        // x and y point the other way in LPS.
        QTest::newRow("shift") << model("1", "a", "liver.off", "T") + transform("T", kShift) << Vec3(-90, 20, 30)
                               << Vec3(-50, 50, 50);
        QTest::newRow("shift below a quarter")
            << model("1", "a", "liver.off", "T") + transform("T", kShift, "U") + transform("U", kQuarter)
            << Vec3(-50, -90, 35) << Vec3(-20, -50, 55);
        QTest::newRow("twice as large") << model("1", "a", "liver.off", "T") + transform("T", kTwice) << Vec3(2.0 * low)
                                        << Vec3(2.0 * high);
        QTest::newRow("RAS") << model("1", "a", "liver.off", "", "", "coordinateSystem=\"RAS\"") << Vec3(-50, -50, 30)
                             << Vec3(-10, -20, 50);
    }

    void transformsAreApplied()
    {
        QFETCH(std::string, nodes);
        QFETCH(Vec3, low);
        QFETCH(Vec3, high);
        const auto scene = open(mrml(nodes));
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        const geometry::MeshReport& report = scene.value().structures[0].surface->report;
        QVERIFY((report.bounds.min() - low).norm() < 1e-9 && (report.bounds.max() - high).norm() < 1e-9);
        QVERIFY(report.volume_mm3 > 0.0); // not mirrored
        // A scene that is saved has the same surface.
        const auto path = m_folder.path("saved.palpate.json");
        QVERIFY(meshio::writeScene(path, scene.value().scene).isOk());
        const auto again = meshio::loadScene(path);
        QVERIFY2(again.isOk(), again.status().message().c_str());
        QVERIFY((again.value().structures[0].surface->report.bounds.min() - low).norm() < 1e-9);
    }

    void modelsOfSlicer4AreInRas()
    {
        const auto scene = open(mrml(model("1", "a", "liver.off", "", "", ""), "Slicer4.4.0"));
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        QCOMPARE(scene.value().structures[0].surface->report.bounds.min().x(), -50.0);
    }

    void whatIsNotOpenedIsALoss_data()
    {
        QTest::addColumn<std::string>("nodes");
        QTest::addColumn<std::string>("words");
        const auto row = [](const char* title, const std::string& nodes, const char* words) {
            QTest::newRow(title) << nodes << std::string(words);
        };
        row("sheared", model("1", "bad", "liver.off", "T") + transform("T", kSheared), "harden it in 3D Slicer");
        row("mirrored", model("1", "bad", "liver.off", "T") + transform("T", "-1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"),
            "harden it in 3D Slicer");
        row("not a number", model("1", "bad", "liver.off", "T") + transform("T", "nan 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"),
            "harden it in 3D Slicer");
        row("a circle of transforms",
            model("1", "bad", "liver.off", "T") + transform("T", kShift, "U") + transform("U", kShift, "T"),
            "harden it in 3D Slicer");
        row("a grid transform", model("1", "bad", "liver.off", "T") + "<GridTransform id=\"T\"></GridTransform>",
            "harden it in 3D Slicer");
        row("no such transform", model("1", "bad", "liver.off", "T"), "harden it in 3D Slicer");
        row("no file", "<Model id=\"M1\" name=\"bad\"></Model>", "names no file");
        row("elsewhere", model("1", "bad", "../liver.off"), "not in the folder of the scene");
        row("missing file", model("1", "bad", "none.off"), "none.off: ");
        row("a moved folder", model("1", "bad", "/somewhere/none.off"), "none.off: ");
    }

    void whatIsNotOpenedIsALoss()
    {
        QFETCH(std::string, nodes);
        QFETCH(std::string, words);
        const auto scene = open(mrml(nodes + model("7", "good", "/moved/liver.off")));
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        QCOMPARE(scene.value().structures.size(), std::size_t{1});
        QCOMPARE(scene.value().structures[0].description.name, std::string("good"));
        QCOMPARE(scene.value().losses.size(), std::size_t{1});
        const std::string loss = scene.value().losses[0].english();
        QVERIFY2(loss.find(words) != std::string::npos, loss.c_str());
    }

    void brokenAndEmptyScenesAreRefused()
    {
        for (const std::string& bytes :
             {mrml(""), mrml("<Model id=\"M1\" name=\"a\"></Model>"), std::string("<MRML><Model"),
              mrml(model("1", "bad", "none.off")), std::string(), std::string("PK\3\4")}) {
            const auto scene = open(bytes);
            QVERIFY(!scene.isOk());
            QVERIFY2(!scene.status().message().empty(), bytes.c_str());
        }
    }
};

PALPATE_TEST(SlicerScene)
#include "tst_SlicerScene.moc"
