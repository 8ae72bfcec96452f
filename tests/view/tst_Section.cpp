// SPDX-License-Identifier: BSD-3-Clause
#include "Balls.h"
#include "TestRunner.h"

#include <palpate/geometry/Repair.h>
#include <palpate/view/SceneView.h>

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

using namespace palpate;
using core::Vec3;
using geometry::SectionPlane;

namespace {

view::ViewStructure structureOf(const geometry::TriangleMesh& mesh, const view::Colour& colour)
{
    auto surface = std::make_shared<const geometry::RepairedMesh>(geometry::repair(mesh));
    return {view::StructureActor(view::makeSurface(*surface), {colour, 1.0, true}, true), nullptr, surface};
}

} // namespace

/// Draws a red ball of 20 mm with a blue ball of 8 mm inside, seen from the front, into a window that is never shown.
class Section : public QObject
{
    Q_OBJECT

    using Pixel = std::array<int, 3>;
    vtkSmartPointer<vtkRenderWindow> m_window;
    std::unique_ptr<view::SceneView> m_view;

    /// @param p_W  place, drawn where the camera projects it
    Pixel at(const Vec3& p_W)
    {
        m_view->prepareFrame(1.0);
        m_window->Render();
        vtkNew<vtkUnsignedCharArray> pixels;
        const Eigen::Vector2d px = view::ViewFrame::of(m_view->renderer(), 1.0).pixelOf(p_W);
        const int x = static_cast<int>(std::lround(200 + px.x())), y = static_cast<int>(std::lround(150 + px.y()));
        m_window->GetPixelData(x, y, x, y, 1, pixels, 0);
        return {pixels->GetValue(0), pixels->GetValue(1), pixels->GetValue(2)};
    }
    static bool isNear(const Pixel& a, const Pixel& b)
    {
        return std::abs(a[0] - b[0]) < 4 && std::abs(a[1] - b[1]) < 4 && std::abs(a[2] - b[2]) < 4;
    }
    static constexpr Pixel kRed{204, 51, 51}, kBlue{51, 51, 204}; // unlit

  private Q_SLOTS:
    void init()
    {
        if (std::getenv("DISPLAY") == nullptr) {
            QSKIP("no display: run under xvfb-run to test what is drawn");
        }
        m_window = vtkSmartPointer<vtkRenderWindow>::New();
        m_window->SetOffScreenRendering(1);
        m_window->SetSize(400, 300);
        m_view = std::make_unique<view::SceneView>();
        m_view->attach(*m_window);
        std::vector<view::ViewStructure> structures;
        structures.push_back(structureOf(test::ball(20.0, 5), {0.8, 0.2, 0.2}));
        structures.push_back(structureOf(test::ball(8.0, 4), {0.2, 0.2, 0.8}));
        m_view->setStructures(std::move(structures));
        m_view->look(view::ViewFrom::Front);
    }
    void cleanup()
    {
        m_view.reset();
        m_window = nullptr;
    }

    void fillsNestedStructuresWithTheInnerOnTop()
    {
        const Pixel whole = at(Vec3(0, 0, 0));
        m_view->setSection(SectionPlane::through(Vec3(0, 1, 0), -Vec3::UnitY())); // hides the front
        QVERIFY(isNear(at(Vec3(0, 1, 0)), kBlue));
        QVERIFY(isNear(at(Vec3(5, 1, 4)), kBlue));
        QVERIFY(isNear(at(Vec3(-14, 1, 0)), kRed) && isNear(at(Vec3(0, 1, 15)), kRed));
        const view::SectionPicture& section = m_view->sectionPicture();
        QCOMPARE(section.structureAt(Vec3(1, 1, 1)), std::optional<std::size_t>(1));
        QCOMPARE(section.structureAt(Vec3(12, 1, 1)), std::optional<std::size_t>(0));
        QVERIFY(!section.structureAt(Vec3(25, 1, 1)));
        const double disc_mm2 = std::numbers::pi * (400.0 - 1.0);
        QVERIFY(section.area_mm2(0) < disc_mm2 && section.area_mm2(0) > 0.99 * disc_mm2);
        // Without a section the picture is as before.
        m_view->setSection(std::nullopt);
        QCOMPARE(at(Vec3(0, 0, 0)), whole);
        QVERIFY(m_view->sectionPicture().isEmpty());
    }

    void followsVisibilityAndColour()
    {
        m_view->setSection(SectionPlane::through(Vec3(0, 1, 0), -Vec3::UnitY()));
        m_view->setAppearance(1, {{0.2, 0.2, 0.8}, 1.0, false});
        QVERIFY(isNear(at(Vec3(0, 1, 0)), kRed));
        m_view->setAppearance(0, {{0.2, 0.2, 0.8}, 0.3, true}); // translucent tissue has an opaque cut
        QVERIFY(isNear(at(Vec3(0, 1, 0)), kBlue));
        m_view->setAppearance(0, {{0.2, 0.2, 0.8}, 0.2, true}); // nearly transparent tissue has an outline
        QVERIFY(!isNear(at(Vec3(0, 1, 0)), kBlue));
        QCOMPARE(m_view->sectionPicture().area_mm2(0), 0.0);
    }

    void outsideOfEverythingHidesOrShowsEverything()
    {
        const Pixel whole = at(Vec3(0, 0, 0)), background = at(Vec3(24, 0, 16));
        m_view->setSection(SectionPlane::through(Vec3(0, -30, 0), -Vec3::UnitY()));
        QCOMPARE(at(Vec3(0, 0, 0)), whole);
        QVERIFY(m_view->sectionPicture().isEmpty());
        m_view->setSection(SectionPlane::through(Vec3(0, 30, 0), -Vec3::UnitY()));
        QVERIFY(!isNear(at(Vec3(0, 0, 0)), whole) && isNear(at(Vec3(24, 0, 16)), background));
    }

    void openStructuresAreOutlinesOnly()
    {
        geometry::TriangleMesh open = test::ball(20.0, 5);
        std::erase_if(open.triangles, [&](const geometry::Triangle& t) { return open.vertices[t[0]].y() > 18.0; });
        m_view->setStructure(0, structureOf(open, {0.8, 0.2, 0.2}));
        m_view->setAppearance(1, {{0.2, 0.2, 0.8}, 1.0, false});
        m_view->setSection(SectionPlane::through(Vec3(0, 1, 0), -Vec3::UnitY()));
        QVERIFY(!isNear(at(Vec3(-14, 1, 0)), kRed));
        QVERIFY(!m_view->sectionPicture().isEmpty());
        QCOMPARE(m_view->sectionPicture().area_mm2(0), 0.0);
    }
};

PALPATE_TEST(Section)
#include "tst_Section.moc"
