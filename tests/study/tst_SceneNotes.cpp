// SPDX-License-Identifier: BSD-3-Clause
#include "English.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/study/HapticCopy.h>
#include <palpate/study/SceneNotes.h>

using namespace palpate;
using core::Vec3;

namespace {

void add(meshio::LoadedScene& scene, const std::string& name, const geometry::TriangleMesh& mesh,
         std::uint32_t layer = 0, bool palpable = true, double stiffness_N_per_mm = 0.5)
{
    meshio::LoadedStructure& one = scene.structures.emplace_back();
    one.description.name = name;
    one.description.layer = layer;
    one.description.palpable = palpable;
    one.description.tissue.stiffness_N_per_mm = stiffness_N_per_mm;
    one.surface = std::make_shared<const geometry::RepairedMesh>(geometry::repair(mesh));
    scene.scene.structures.push_back(one.description);
}

std::vector<std::string> notesOf(const meshio::LoadedScene& scene)
{
    return test::english(study::neighbourNotes(scene, *study::hapticScene(scene)));
}

} // namespace

class SceneNotes : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void namesStructuresWithANarrowGap()
    {
        meshio::LoadedScene scene;
        add(scene, "liver", test::box(Vec3::Zero(), Vec3(10, 10, 10), 3));
        add(scene, "kidney", test::box(Vec3(10.05, 0, 0), Vec3(20, 10, 10), 4));
        add(scene, "spleen", test::box(Vec3(20.3, 0, 0), Vec3(30, 10, 10), 4)); // too far away to have an effect
        const auto notes = notesOf(scene);
        QCOMPARE(notes.size(), std::size_t{1});
        QVERIFY2(notes[0].starts_with("liver and kidney come within 0.05 mm of each other at ("), notes[0].c_str());
        QVERIFY(notes[0].find("a point falls into the gap") != std::string::npos);
    }

    void saysNothingOfWhatTouchesOrCannotMeet()
    {
        meshio::LoadedScene scene;
        add(scene, "a", test::box(Vec3::Zero(), Vec3(10, 10, 10), 3));
        add(scene, "touching", test::box(Vec3(10, 0, 0), Vec3(20, 10, 10), 3));
        add(scene, "deeper", test::box(Vec3(0, 10.1, 0), Vec3(10, 20, 10), 3), 1);
        add(scene, "not felt", test::box(Vec3(0, 0, 10.1), Vec3(10, 10, 20), 3), 0, false);
        QVERIFY(notesOf(scene).empty());
    }

    void namesASeamWhereTheForceSteps()
    {
        meshio::LoadedScene scene;
        const double soft = 0.1;
        add(scene, "liver", test::box(Vec3::Zero(), Vec3(10, 10, 10), 3), 0, true, soft);
        add(scene, "tumour", test::box(Vec3(10, 0, 0), Vec3(20, 10, 10), 3), 0, true, 8.0 * soft);
        add(scene, "fat", test::box(Vec3(0, -10, 0), Vec3(9, 0, 10), 3), 0, true, 2.0 * soft); // at most twice
        add(scene, "bone", test::box(Vec3(0, 10, 0), Vec3(10, 20, 10), 3), 1, true, 20.0 * soft);
        add(scene, "far", test::box(Vec3(0, 0, 11), Vec3(10, 10, 20), 3), 0, true, 20.0 * soft);
        QCOMPARE(notesOf(scene), std::vector<std::string>{"liver and tumour touch in one layer and differ 8-fold in "
                                                          "stiffness: the force steps at the seam"});
        scene.structures[1].description.tissue.stiffness_N_per_mm = 2.0 * soft;
        QVERIFY(notesOf(scene).empty());
    }

    /// The comparison uses the stiffness at a light press and not the coefficient in the file.
    void comparesLawsAtALightPress()
    {
        meshio::LoadedScene scene;
        add(scene, "liver", test::box(Vec3::Zero(), Vec3(10, 10, 10), 3));
        add(scene, "bone", test::box(Vec3(10, 0, 0), Vec3(20, 10, 10), 3));
        QVERIFY(notesOf(scene).empty());
        core::Tissue& tissue = scene.structures[0].description.tissue;
        tissue.law.kind = core::LawKind::Points;
        tissue.law.points = {{0.0, 0.0}, {2.0, 0.1}, {4.0, 4.0}}; // 0.05 N/mm compared to the bone's 0.5
        const auto notes = notesOf(scene);
        QCOMPARE(notes.size(), std::size_t{1});
        QVERIFY2(notes[0].find("differ 10-fold") != std::string::npos, notes[0].c_str());
    }

    /// A lump that protrudes from its organ has a border, too.
    void namesTheSeamAroundALumpThatReachesOut()
    {
        meshio::LoadedScene scene;
        add(scene, "liver", test::sphere(20, 40.0));
        add(scene, "lump", test::moved(test::sphere(8, 10.0), Vec3(0, 0, 31)), 0, true, 2.0);
        const auto notes = notesOf(scene);
        QCOMPARE(notes.size(), std::size_t{2});
        QVERIFY2(notes[1].starts_with("liver and lump touch in one layer and differ 4-fold"), notes[1].c_str());
    }

    void namesALumpInItsOrgansLayer()
    {
        meshio::LoadedScene scene;
        add(scene, "liver", test::sphere(20, 40.0));
        add(scene, "lump", test::sphere(8, 10.0));
        auto notes = notesOf(scene);
        QCOMPARE(notes.size(), std::size_t{1});
        QVERIFY2(notes[0].starts_with("lump lies in liver and in the same layer: it is never felt"), notes[0].c_str());
        scene.structures[1].description.layer = 1;
        QVERIFY(notesOf(scene).empty());
        scene.structures[1].description.layer = 0;
        scene.structures[1].isTransmitted = true; // already transmitted
        QVERIFY(notesOf(scene).empty());
    }

    void aLumpThatReachesOutIsFeltThere()
    {
        meshio::LoadedScene scene;
        add(scene, "liver", test::sphere(20, 40.0));
        add(scene, "lump", test::moved(test::sphere(8, 10.0), Vec3(0, 0, 31)));
        const auto notes = notesOf(scene);
        QCOMPARE(notes.size(), std::size_t{1});
        QVERIFY2(notes[0].find("it is felt only where it reaches out") != std::string::npos, notes[0].c_str());
    }
};

PALPATE_TEST(SceneNotes)
#include "tst_SceneNotes.moc"
