// SPDX-License-Identifier: BSD-3-Clause
#include "Balls.h"
#include "TestRunner.h"

#include <palpate/view/CoarseSurface.h>
#include <palpate/view/SceneView.h>
#include <palpate/view/SurfaceMesh.h>

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <QImage>

#include <cstdlib>

using namespace palpate;
using core::Vec3;

namespace {

view::ViewStructure makeStructure(const geometry::TriangleMesh& mesh, const view::Appearance& appearance)
{
    const auto repaired = geometry::repair(mesh);
    return {view::StructureActor(view::makeSurface(repaired), appearance),
            std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(repaired))};
}

} // namespace

/// Renders into a window that is never shown.
class SceneView : public QObject
{
    Q_OBJECT
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
        structures.push_back(makeStructure(test::ball(20.0, 4), {{0.9, 0.1, 0.1}, 1.0, true}));
        structures.push_back(makeStructure(test::ball(6.0, 3, Vec3(0, 10, 0)), {{0.1, 0.2, 0.9}, 1.0, true}));
        m_view->setStructures(std::move(structures));
        m_view->look(view::ViewFrom::Front);
    }
    void cleanup()
    {
        m_view.reset();
        m_window = nullptr;
    }
    void tissueIsDrawnInItsColour()
    {
        const auto middle = pixel(200, 150);
        QVERIFY(middle[0] > 2 * middle[1] && middle[0] > 2 * middle[2]);
        const auto corner = pixel(390, 290);
        QVERIFY(std::abs(corner[0] - corner[1]) < 40); // background, grey
    }
    void hiddenStructureShowsWhatIsBehind()
    {
        m_view->setAppearance(0, {{0.9, 0.1, 0.1}, 1.0, false});
        const auto middle = pixel(200, 150);
        QVERIFY(middle[2] > 2 * middle[0]);
    }
    void translucentStructureLetsTheInnerOneThrough()
    {
        const auto before = pixel(200, 150);
        m_view->setAppearance(0, {{0.9, 0.1, 0.1}, 0.4, true});
        const auto after = pixel(200, 150);
        QVERIFY(after[2] > before[2] + 20);
        QVERIFY(after[0] > after[1]); // still reddish
    }
    /// Depth peeling and unsorted rendering give the same colours, also for a translucent object inside another.
    void translucentColoursAreTheSameAtRestAndInMotion()
    {
        for (const bool isInnerFirst : {true, false}) {
            std::vector<view::ViewStructure> structures;
            const auto add = [&](double radius_mm, const view::Appearance& look) {
                const auto mesh = geometry::repair(test::ball(radius_mm, 4));
                structures.push_back({view::StructureActor(view::makeSurface(mesh), look, true), nullptr});
            };
            for (const bool isInner : {isInnerFirst, !isInnerFirst}) {
                isInner ? add(9.0, {{0.1, 0.2, 0.9}, 0.5, true}) : add(20.0, {{0.9, 0.3, 0.1}, 0.4, true});
            }
            m_view->setStructures(std::move(structures));
            m_view->setSortedTransparency(true);
            const auto still = picture();
            m_view->setSortedTransparency(false);
            const auto moving = picture();
            QVERIFY(still[150 * 400 + 200] != still[150 * 400 + 270]); // the inner object is visible
            int compared = 0;
            for (int y = 1; y < 299; ++y) {
                for (int x = 1; x < 399; ++x) {
                    if (isEdge(still, x, y) || isEdge(moving, x, y)) {
                        continue;
                    }
                    ++compared;
                    const auto &a = still[static_cast<std::size_t>(y * 400 + x)],
                               &b = moving[static_cast<std::size_t>(y * 400 + x)];
                    for (std::size_t c = 0; c < 3; ++c) {
                        QVERIFY2(std::abs(a[c] - b[c]) <= 2,
                                 qPrintable(QStringLiteral("%1 %2: %3 %4").arg(x).arg(y).arg(a[c]).arg(b[c])));
                    }
                }
            }
            QVERIFY2(compared > 100000, qPrintable(QString::number(compared)));
        }
    }
    void pointerFindsTheFrontOfTheNearestStructure()
    {
        (void)pixel(0, 0);
        const auto pick = m_view->pick(m_view->rayThrough(200, 150));
        QVERIFY(pick.has_value());
        QCOMPARE(pick->structure, std::size_t{0});
        QVERIFY((pick->hit.p_W - Vec3(0, -20, 0)).norm() < 0.3);
    }
    void pointerPassesThroughWhatIsHiddenOrNotPalpable()
    {
        (void)pixel(0, 0);
        m_view->setTouchable(0, nullptr);
        auto pick = m_view->pick(m_view->rayThrough(200, 150));
        QVERIFY(pick.has_value());
        QCOMPARE(pick->structure, std::size_t{1});
        m_view->setAppearance(1, {{0.1, 0.2, 0.9}, 1.0, false});
        QVERIFY(!m_view->pick(m_view->rayThrough(200, 150)).has_value());
    }
    void rayGoesThroughItsPixel()
    {
        (void)pixel(0, 0);
        const view::Ray ray = m_view->rayThrough(320, 90);
        const Vec3 p = ray.p_W + 50.0 * ray.d_W;
        m_view->renderer().SetWorldPoint(p.x(), p.y(), p.z(), 1.0);
        m_view->renderer().WorldToDisplay();
        const double* display = m_view->renderer().GetDisplayPoint();
        QVERIFY(std::abs(display[0] - 320) < 0.01 && std::abs(display[1] - 90) < 0.01);
    }
    void cursorIsDrawnOverTheTissueThatHidesIt()
    {
        const auto before = pixel(200, 150);
        view::TouchState state;
        state.isPresent = true;
        state.isInContact = true;
        state.p_WG = Vec3(0, 20, 0); // on the far side
        state.p_WH = Vec3(0, 12, 0);
        state.f_W = Vec3(0, 1, 0);
        m_view->cursor().setState(state);
        int changed = 0;
        for (int dy = -12; dy <= 12; ++dy) {
            for (int dx = -12; dx <= 12; ++dx) {
                const auto now = pixelOf(200 + dx, 150 + dy, dx == -12 && dy == -12);
                changed += std::abs(now[1] - before[1]) > 60 ? 1 : 0;
            }
        }
        QVERIFY2(changed > 30, qPrintable(QString::number(changed))); // the outline, light on red
    }
    void scaleBarSaysARoundLength()
    {
        (void)pixel(0, 0);
        QVERIFY(m_view->scaleBar().text().ends_with(" mm"));
        QCOMPARE(view::roundScaleLength(37.0), 20.0);
        QCOMPARE(view::roundScaleLength(50.0), 50.0);
        QCOMPARE(view::roundScaleLength(0.0123), 0.01);
    }
    void aMapColoursTheStructureAndTheLegendSaysIt()
    {
        const auto ball = geometry::repair(test::ball(20.0, 4));
        std::vector<float> values;
        for (const Vec3& p : ball.mesh.vertices) {
            values.push_back(p.x() < 0.0 ? 1.0F : 4.0F);
        }
        const view::ColourRange range = view::colourRange(values);
        const auto plain = view::makeSurface(ball);
        QVERIFY(!m_view->legend().isShown());
        const auto before = pixel(28, 151); // future position of the legend's bar
        m_view->setPicture(0, view::coloured(*plain, ball, values, false, range));
        m_view->legend().show({"ball: felt, N/mm", "not said", range});
        const auto soft = pixel(160, 150), stiff = pixel(240, 150), bar = pixel(28, 151);
        QVERIFY2(soft[2] > soft[0] + 15, "dark blue"); // 1
        QVERIFY2(stiff[0] > stiff[2] + 60 && stiff[1] > stiff[2] + 40, "yellow");
        QVERIFY2(std::abs(bar[0] - 46) < 8 && std::abs(bar[1] - 72) < 8 && bar[2] > bar[0] + 50 && bar != before,
                 "dark blue");
        const auto texts = m_view->legend().texts();
        QVERIFY(texts[0] == "ball: felt, N/mm" && texts[1] == "4" && texts[2] == "2.5" && texts[3] == "1");
        QVERIFY(texts[4].empty()); // no unknown values
        const auto pick = m_view->pick(m_view->rayThrough(200, 150));
        QVERIFY(pick && pick->structure == 0);
        // When translucent, the object keeps its colours and shows the inner object.
        m_view->setAppearance(0, {{0.9, 0.1, 0.1}, 0.4, true});
        const auto through = pixel(200, 150), side = pixel(252, 150);
        QVERIFY(through[2] > stiff[2]);
        QVERIFY(side[0] > side[2]);
        m_view->setAppearance(0, {{0.9, 0.1, 0.1}, 1.0, true});
        m_view->setPicture(0, plain);
        m_view->legend().hide();
        const auto red = pixel(240, 150);
        QVERIFY(red[0] > 2 * red[1]);
        QVERIFY(pixel(28, 151) == before);
    }
    /// The legend stands in the chosen corner, clear of covers, orientation cube and scale bar; otherwise in the corner
    /// where it hides the least tissue, and brief if it hides much there.
    void theLegendStandsInItsCorner()
    {
        using Corner = view::ColourLegend::Corner;
        view::ColourLegend& legend = m_view->legend();
        view::ColourLegend::Content content;
        content.title = "a long title of the legend";
        content.briefTitle = "brief";
        content.range = {0.0, 1.0};
        content.marks = {{0.0, "none at all, in many words", "0"}, {1.0, "all of it, in many words", "1"}};
        legend.show(content);
        m_view->setCoveredAbove(10.0, 30.0);
        for (const Corner corner : view::ColourLegend::kCorners) {
            m_view->setLegendCorner(corner);
            (void)pixel(0, 0);
            const Eigen::AlignedBox2d box = legend.box();
            const bool isRight = corner == Corner::UpperRight || corner == Corner::LowerRight;
            const bool isUpper = corner == Corner::UpperLeft || corner == Corner::UpperRight;
            QVERIFY(isRight ? box.center().x() > 0.0 : box.center().x() < 0.0);
            QVERIFY(isUpper ? box.max().y() <= 150.0 - (isRight ? 30.0 : 10.0)
                            : box.min().y() >= -150.0 + std::min(m_view->cube().top_px(), m_view->scaleBar().top()));
            QVERIFY(box.contains(legend.closeBox()));
        }
        m_view->setCoveredAbove(0.0, 0.0);
        m_view->setLegendCorner(std::nullopt);
        m_view->camera().Dolly(4.0); // tissue everywhere
        (void)pixel(0, 0);
        QVERIFY(legend.isBrief());
        const double wide = legend.box().sizes().x();
        legend.setHovered(true);
        (void)pixel(0, 0);
        QVERIFY(!legend.isBrief() && legend.box().sizes().x() > wide);
        legend.setHovered(false);
        legend.setClosed(true);
        QVERIFY(!legend.isShown() && legend.box().isEmpty());
        legend.show(content);
        QVERIFY(!legend.isShown()); // stays closed
        legend.setClosed(false);
        QVERIFY(legend.isShown());
        legend.hide();
        legend.setClosed(false);
        QVERIFY(!legend.isShown());
    }
    void occlusionAndSmoothEdgesKeepThePicture()
    {
        m_view->setAmbientOcclusion(true);
        m_view->setSmoothEdges(true);
        const auto middle = pixel(200, 150);
        QVERIFY(middle[0] > 2 * middle[1]);
    }
    void orientationCubeNamesTheSideSeen()
    {
        // The face of the orientation cube is in the lower left corner: light, with a dark letter.
        int light = 0;
        int dark = 0;
        for (int y = 25; y < 80; ++y) {
            for (int x = 25; x < 80; ++x) {
                const auto p = pixelOf(x, y, x == 25 && y == 25);
                light += p[1] > 150 ? 1 : 0;
                dark += p[1] < 60 ? 1 : 0;
            }
        }
        QVERIFY2(light > 800 && dark > 100, qPrintable(QStringLiteral("%1 %2").arg(light).arg(dark)));
    }
    void picturesForTheEye()
    {
        // Saved in the folder in PALPATE_TEST_PICTURES for visual inspection.
        const char* folder = std::getenv("PALPATE_TEST_PICTURES");
        if (folder == nullptr) {
            QSKIP("set PALPATE_TEST_PICTURES to a folder to keep pictures of each view");
        }
        const std::pair<const char*, view::ViewFrom> views[] = {
            {"front", view::ViewFrom::Front}, {"back", view::ViewFrom::Back}, {"left", view::ViewFrom::Left},
            {"right", view::ViewFrom::Right}, {"head", view::ViewFrom::Head}, {"feet", view::ViewFrom::Feet}};
        m_view->legend().show({"ball\ndamping felt, N·s/mm", "nothing said", {0.001, 0.02, true, true, true}});
        for (const auto& [name, from] : views) {
            m_view->look(from);
            (void)pixel(0, 0);
            QImage image(400, 300, QImage::Format_RGB888);
            for (int y = 0; y < 300; ++y) {
                for (int x = 0; x < 400; ++x) {
                    const auto p = pixelOf(x, 299 - y, false);
                    image.setPixel(x, y, qRgb(p[0], p[1], p[2]));
                }
            }
            QVERIFY(
                image.save(QStringLiteral("%1/%2.png").arg(QString::fromLocal8Bit(folder), QString::fromLatin1(name))));
        }
    }

    /// One point for each cluster of the ball's points.
    void theCoarsePictureOfABallIsABall()
    {
        const auto fine = view::makeSurface(geometry::repair(test::ball(20.0, 6)));
        const auto coarse = view::coarseSurface(*fine, 5.0);
        const double share =
            static_cast<double>(coarse->GetNumberOfPolys()) / static_cast<double>(fine->GetNumberOfPolys());
        QVERIFY2(share > 0.1 && share < 0.3, qPrintable(QString::number(share)));
        QCOMPARE(coarse->GetPointData()->GetNormals()->GetNumberOfTuples(), coarse->GetNumberOfPoints());
        // A cell is sqrt(2 * 5 * area / triangles) wide. Points of a sphere in it are at most its diagonal d apart, so
        // their mean is at most d^2 / (8 r) below the sphere.
        constexpr double kRadius_mm = 20.0, kPi = 3.14159265358979;
        const double width2_mm2 =
            10.0 * 4.0 * kPi * kRadius_mm * kRadius_mm / static_cast<double>(fine->GetNumberOfPolys());
        const double sag_mm = 3.0 * width2_mm2 / (8.0 * kRadius_mm);
        for (vtkIdType i = 0; i < coarse->GetNumberOfPoints(); ++i) {
            const Vec3 p(coarse->GetPoint(i)), n(coarse->GetPointData()->GetNormals()->GetTuple3(i));
            QVERIFY2(p.norm() < kRadius_mm + 1e-5 && p.norm() > kRadius_mm - sag_mm,
                     qPrintable(QString::number(p.norm())));
            QVERIFY(n.dot(p) > 0.95 * p.norm()); // the same mean, but for the facets' normals
        }
    }

    /// The two sides of a plate thinner than a cell stay apart: else they would share points, with holes between them.
    void theCoarsePictureOfAThinPlateHasTwoSides()
    {
        constexpr int kSide = 40;
        constexpr double kThickness_mm = 0.01;
        geometry::TriangleMesh plate;
        const auto number = [](int side, int i, int j) {
            return static_cast<std::uint32_t>((side * (kSide + 1) + i) * (kSide + 1) + j);
        };
        for (int side = 0; side < 2; ++side) {
            for (int i = 0; i <= kSide; ++i) {
                for (int j = 0; j <= kSide; ++j) {
                    plate.vertices.emplace_back(i, j, side * kThickness_mm);
                }
            }
            for (int i = 0; i < kSide; ++i) {
                for (int j = 0; j < kSide; ++j) {
                    const std::uint32_t a = number(side, i, j), b = number(side, i + 1, j), c = number(side, i, j + 1),
                                        d = number(side, i + 1, j + 1);
                    plate.triangles.push_back(side == 1 ? geometry::Triangle{a, b, d} : geometry::Triangle{a, d, b});
                    plate.triangles.push_back(side == 1 ? geometry::Triangle{a, d, c} : geometry::Triangle{a, c, d});
                }
            }
        }
        const auto coarse = view::coarseSurface(*view::makeSurface(geometry::repair(plate)), 5.0);
        int above = 0, below = 0;
        for (vtkIdType i = 0; i < coarse->GetNumberOfPoints(); ++i) {
            const double normal = coarse->GetPointData()->GetNormals()->GetTuple3(i)[2];
            QVERIFY2(std::abs(std::abs(normal) - 1.0) < 1e-5, qPrintable(QString::number(normal)));
            ++(normal > 0.0 ? above : below);
        }
        QVERIFY2(above == below && above > 100, qPrintable(QStringLiteral("%1 %2").arg(above).arg(below)));
    }

  private:
    using Picture = std::vector<std::array<int, 3>>;
    Picture picture()
    {
        (void)pixel(0, 0);
        Picture all;
        for (int i = 0; i < 400 * 300; ++i) {
            all.push_back(pixelOf(i % 400, i / 400, false));
        }
        return all;
    }
    /// Returns whether a neighbouring pixel differs: edges may fall on another pixel.
    static bool isEdge(const Picture& picture, int x, int y)
    {
        const auto& own = picture[static_cast<std::size_t>(y * 400 + x)];
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const auto& other = picture[static_cast<std::size_t>((y + dy) * 400 + x + dx)];
                for (std::size_t c = 0; c < 3; ++c) {
                    if (std::abs(own[c] - other[c]) > 5) {
                        return true;
                    }
                }
            }
        }
        return false;
    }
    std::array<int, 3> pixelOf(int x, int y, bool isDrawn)
    {
        if (isDrawn || m_pixels->GetNumberOfTuples() == 0) {
            m_view->prepareFrame(1.0);
            m_window->Render();
            m_window->GetPixelData(0, 0, 399, 299, 1, m_pixels, 0);
        }
        unsigned char rgb[3] = {0, 0, 0};
        m_pixels->GetTypedTuple(y * 400 + x, rgb);
        return {rgb[0], rgb[1], rgb[2]};
    }
    std::array<int, 3> pixel(int x, int y) { return pixelOf(x, y, true); }

    vtkSmartPointer<vtkRenderWindow> m_window;
    vtkNew<vtkUnsignedCharArray> m_pixels;
    std::unique_ptr<view::SceneView> m_view;
};

PALPATE_TEST(SceneView)
#include "tst_SceneView.moc"
