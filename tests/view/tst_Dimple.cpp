// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/view/Dimple.h>
#include <palpate/view/SceneView.h>
#include <palpate/view/SurfaceMesh.h>

#include <vtkNew.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRendererCollection.h>
#include <vtkUnsignedCharArray.h>

#include <QImage>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

using namespace palpate;
using core::Vec3;

namespace {

constexpr double kAcross_mm = 0.4, kThick_mm = 2.0, kHalf_mm = 20.0;

/// Returns a bar along x with its top at z = 0, so narrow that its outline is that of the surface along y = 0.
geometry::TriangleMesh bar(double step_mm)
{
    geometry::TriangleMesh mesh;
    const int n = static_cast<int>(std::lround(2.0 * kHalf_mm / step_mm));
    for (int i = 0; i <= n; ++i) {
        const double x = -kHalf_mm + i * step_mm, y = 0.5 * kAcross_mm;
        mesh.vertices.insert(mesh.vertices.end(), {{x, -y, 0.0}, {x, y, 0.0}, {x, y, -kThick_mm}, {x, -y, -kThick_mm}});
    }
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    for (int i = 0; i < n; ++i) {
        const auto at = static_cast<std::uint32_t>(4 * i);
        for (std::uint32_t k = 0; k < 4; ++k) {
            quad(at + k, at + 4 + k, at + 4 + (k + 1) % 4, at + (k + 1) % 4);
        }
    }
    const auto last = static_cast<std::uint32_t>(4 * n);
    quad(0, 1, 2, 3);
    quad(last + 3, last + 2, last + 1, last);
    return mesh;
}

view::TouchState pressed(double depth_mm, double fingertip_mm)
{
    view::TouchState state;
    state.n_W = Vec3::UnitZ();
    state.p_WG = Vec3(0, 0, fingertip_mm);
    state.p_WH = state.p_WG - Vec3(0, 0, depth_mm);
    state.f_W = Vec3(0, 0, 1);
    state.fingertip_mm = fingertip_mm;
    state.isPresent = state.isInContact = state.bends = true;
    return state;
}

/// Leaves only the outline of one structure visible.
void hideAllBut(vtkRenderWindow& window, vtkProp* shown)
{
    for (int i = 0; i < window.GetRenderers()->GetNumberOfItems(); ++i) {
        auto* renderer = vtkRenderer::SafeDownCast(window.GetRenderers()->GetItemAsObject(i));
        for (int k = 0; k < renderer->GetViewProps()->GetNumberOfItems(); ++k) {
            auto* prop = vtkProp::SafeDownCast(renderer->GetViewProps()->GetItemAsObject(k));
            prop->SetVisibility(prop == shown);
        }
    }
}

} // namespace

class Dimple : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void surfaceGoesStraightInAsTheElasticSolutionSays()
    {
        const auto dimple = view::Dimple::of(pressed(3.0, 4.0));
        const double c = 4.0 / std::numbers::pi;
        QCOMPARE(dimple.depth_mm, 3.0);
        for (const double r : {0.0, 0.5, 2.0, 10.0}) {
            const Vec3 u = dimple.displacement_W(Vec3(0.6 * r, 0.8 * r, 0.0));
            QVERIFY((u - Vec3(0, 0, -3.0 * c / std::sqrt(r * r + c * c))).norm() < 1e-12);
        }
    }
    void pointPressesLikeAFingertipOfFiveMillimetres()
    {
        QCOMPARE(view::Dimple::of(pressed(3.0, 0.0)).radius_mm, 5.0);
        QVERIFY(view::Dimple::of(pressed(3.0, 0.0)).p_W.norm() < 1e-12);
    }
    /// Below the surface too, the volume is preserved.
    void tissueIsNotCompressed()
    {
        const auto dimple = view::Dimple::of(pressed(1.0, 5.0));
        constexpr double h = 1e-4;
        for (const Vec3& p : {Vec3(1, 2, -0.5), Vec3(3, -1, -4), Vec3(0.1, 0, -10)}) {
            double divergence = 0.0, largest = 0.0;
            for (int i = 0; i < 3; ++i) {
                const Vec3 step = h * Vec3::Unit(i);
                const Vec3 slope = (dimple.displacement_W(p + step) - dimple.displacement_W(p - step)) / (2.0 * h);
                divergence += slope[i];
                largest = std::max(largest, slope.norm());
            }
            QVERIFY2(std::abs(divergence) < 1e-7 * largest + 1e-9, qPrintable(QString::number(divergence)));
        }
    }
    void aLumpIsPushedAheadOfTheSurface()
    {
        const auto dimple = view::Dimple::of(pressed(20.0, 4.0));
        double above = dimple.displacement_W(Vec3::Zero()).z();
        for (double z = -0.1; z > -40.0; z -= 0.1) {
            const double now = z + dimple.displacement_W(Vec3(0, 0, z)).z();
            QVERIFY2(now < above, qPrintable(QString::number(z)));
            above = now;
        }
    }
    void nothingBendsWithoutContactOrWhereTissueIsRigid()
    {
        for (auto change :
             {+[](view::TouchState& s) { s.isInContact = false; }, +[](view::TouchState& s) { s.bends = false; },
              +[](view::TouchState& s) { s.isPresent = false; }, +[](view::TouchState& s) { s.n_W = Vec3::Zero(); },
              +[](view::TouchState& s) { s.p_WH.z() = std::nan(""); }}) {
            view::TouchState state = pressed(3.0, 4.0);
            change(state);
            QCOMPARE(view::Dimple::of(state).depth_mm, 0.0);
            QVERIFY(view::Dimple::of(state).displacement_W(Vec3::Zero()).isZero());
        }
    }
    void outlineFollowsTheFormulaToAPixel_data()
    {
        QTest::addColumn<double>("depth_mm");
        QTest::addColumn<double>("fingertip_mm");
        QTest::addColumn<bool>("isOn");
        QTest::newRow("point, 3 mm") << 3.0 << 0.0 << true;
        QTest::newRow("ball of 4 mm, 6 mm") << 6.0 << 4.0 << true;
        QTest::newRow("ball of 8 mm, 2 mm") << 2.0 << 8.0 << true;
        QTest::newRow("not wanted") << 6.0 << 4.0 << false;
    }
    void outlineFollowsTheFormulaToAPixel()
    {
        if (std::getenv("DISPLAY") == nullptr) {
            QSKIP("no display: run under xvfb-run to test what is drawn");
        }
        QFETCH(double, depth_mm);
        QFETCH(double, fingertip_mm);
        QFETCH(bool, isOn);
        constexpr int kWidth = 600, kHeight = 400;
        constexpr double kView_mm = 20.0; // height of the view
        vtkNew<vtkRenderWindow> window;
        window->SetOffScreenRendering(1);
        window->SetSize(kWidth, kHeight);
        view::SceneView scene;
        scene.attach(*window);
        // Far from the origin, as in scans of patients.
        const Vec3 at(180.0, -240.0, -900.0);
        geometry::TriangleMesh mesh = bar(0.1);
        for (Vec3& v : mesh.vertices) {
            v += at;
        }
        std::vector<view::ViewStructure> structures;
        structures.push_back(
            {view::StructureActor(view::makeSurface(geometry::repair(mesh)), {{1, 1, 1}, 1.0, true}), nullptr});
        scene.setStructures(std::move(structures));
        scene.setBackground({0, 0, 0}, {0, 0, 0}, {0, 0, 0});
        scene.setBending(isOn);
        view::TouchState state = pressed(depth_mm, fingertip_mm);
        state.p_WG += at;
        state.p_WH += at;
        scene.cursor().setState(state);
        vtkCamera& camera = scene.camera();
        camera.SetParallelProjection(1);
        camera.SetParallelScale(0.5 * kView_mm);
        camera.SetFocalPoint(at.x(), at.y(), at.z());
        camera.SetPosition(at.x(), at.y() - 100.0, at.z());
        camera.SetViewUp(0, 0, 1);
        scene.prepareFrame(1.0);
        hideAllBut(*window, scene.structure(0).picture.actor());
        vtkNew<vtkUnsignedCharArray> pixels;
        window->Render();
        window->GetPixelData(0, 0, kWidth - 1, kHeight - 1, 0, pixels);
        if (const char* folder = std::getenv("PALPATE_TEST_PICTURES")) {
            QImage image(pixels->GetPointer(0), kWidth, kHeight, 3 * kWidth, QImage::Format_RGB888);
            image.mirrored().save(
                QStringLiteral("%1/dimple %2.png")
                    .arg(QString::fromLocal8Bit(folder), QString::fromLatin1(QTest::currentDataTag())));
        }
        const double perPixel_mm = kView_mm / kHeight;
        const double c = (fingertip_mm > 0.0 ? fingertip_mm : 5.0) / std::numbers::pi;
        double worst_px = 0.0;
        for (int x = 60; x < kWidth - 60; ++x) {
            const double r = (x + 0.5 - 0.5 * kWidth) * perPixel_mm;
            const double z = isOn ? -depth_mm * c / std::sqrt(r * r + c * c) : 0.0;
            int top = kHeight - 1;
            while (top > 0 && pixels->GetTypedComponent(top * kWidth + x, 0) < 20) {
                --top;
            }
            worst_px = std::max(worst_px, std::abs(top + 0.5 - (0.5 * kHeight + z / perPixel_mm)));
        }
        QVERIFY2(worst_px <= 1.5, qPrintable(QString::number(worst_px)));
        scene.detach();
    }
};

PALPATE_TEST(Dimple)
#include "tst_Dimple.moc"
