// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Shapes.h"
#include "Desk.h"
#include "TestRunner.h"

#include <palpate/geometry/SurfaceSection.h>
#include <palpate/meshio/SceneFile.h>
#include <palpate/ui/FingerInset.h>
#include <palpate/ui/SectionBar.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QToolButton>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>

using namespace palpate;
using core::Vec3;
using ui::SectionBar;

/// Section, peek and image in the whole window: a ball of 40 mm with a ball of 15 mm inside. With a folder in
/// PALPATE_TEST_PICTURES, `picturesForTheEye` draws the phantom and, from shared/anatomy, a liver.
class Inside : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;

    ui::VtkViewport& viewport() { return m_desk->window().viewport(); }
    view::SceneView& view() { return viewport().view(); }
    SectionBar& bar() { return *m_desk->window().findChild<SectionBar*>(); }
    QDoubleSpinBox& field(const QString& name)
    {
        for (QDoubleSpinBox* one : bar().findChildren<QDoubleSpinBox*>()) {
            if (one->accessibleName() == name) {
                return *one;
            }
        }
        qFatal("no such field");
    }
    double opacity(std::size_t i) { return view().structure(i).picture.appearance().opacity; }
    QColor colourAt(const Vec3& p_W)
    {
        viewport().refineNext();
        const QImage picture = viewport().grabFramebuffer();
        return picture.pixelColor((viewport().placeOf(p_W) * viewport().devicePixelRatioF()).toPoint());
    }
    void turnWheel(int notches, Qt::KeyboardModifiers modifiers)
    {
        const QPointF middle(0.5 * viewport().width(), 0.5 * viewport().height());
        QWheelEvent wheel(middle, viewport().mapToGlobal(middle), {}, {0, 120 * notches}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&viewport(), &wheel);
    }
    /// Writes a volume of 2 mm voxels about the origin: `value` of each place.
    template<class Value>
    std::filesystem::path writeImage(const char* name, int half, Value value)
    {
        const std::filesystem::path file = m_desk->folder() / name;
        std::ofstream out(file, std::ios::binary);
        out << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
            << "Offset = " << -2 * half << ' ' << -2 * half << ' ' << -2 * half << "\nElementSpacing = 2 2 2\n"
            << "DimSize = " << 2 * half + 1 << ' ' << 2 * half + 1 << ' ' << 2 * half + 1
            << "\nElementType = MET_SHORT\nElementDataFile = LOCAL\n";
        for (int z = -half; z <= half; ++z) {
            for (int y = -half; y <= half; ++y) {
                for (int x = -half; x <= half; ++x) {
                    const auto number = static_cast<std::int16_t>(value(Vec3(2 * x, 2 * y, 2 * z)));
                    out.write(reinterpret_cast<const char*>(&number), sizeof number);
                }
            }
        }
        return file;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
        m_desk->writeStl("organ.stl", test::sphere(16, 40.0));
        m_desk->writeStl("core.stl", test::sphere(8, 15.0));
        std::ofstream(m_desk->folder() / "balls.palpate.json") << R"({"version": 1, "structures": [
            {"mesh": "organ.stl", "name": "organ", "colour": [0.8, 0.2, 0.2]},
            {"mesh": "core.stl", "name": "core", "colour": [0.2, 0.2, 0.8], "layer": 1}]})";
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({m_desk->folder() / "balls.palpate.json"}));
        view().look(view::ViewFrom::Front);
        viewport().setFocus();
    }
    void cleanupTestCase() { m_desk.reset(); }

    void cutsThroughTheMiddleAndMovesInMillimetres()
    {
        QVERIFY(!bar().isVisible() && !m_desk->command("section-side").isEnabled());
        m_desk->pressKeyOf("section");
        QVERIFY(bar().isVisible() && view().section());
        QCOMPARE(bar().line(), QStringLiteral("coronal, 0.0 mm posterior · the hand still feels everything"));
        QVERIFY(colourAt(Vec3(0, 0, 0)).blue() > 190 && colourAt(Vec3(-28, 0, 0)).red() > 190);
        // The wheel: away from the user is away from the viewer, here to the back.
        const double step_mm = field("Position of the section").singleStep();
        QCOMPARE(step_mm, 0.5);
        turnWheel(3, Qt::ShiftModifier);
        QCOMPARE(view().section()->p_W.y(), 3.0 * step_mm);
        QCOMPARE(bar().line(), QStringLiteral("coronal, 1.5 mm posterior · the hand still feels everything"));
        m_desk->pressKeyOf("section-nearer");
        QCOMPARE(view().section()->p_W.y(), 2.0 * step_mm);
        field("Position of the section").setValue(-12.5);
        QCOMPARE(bar().line(), QStringLiteral("coronal, 12.5 mm anterior · the hand still feels everything"));
        field("Position of the section").setValue(55.0);
        QCOMPARE(bar().line(), QStringLiteral("coronal, 55.0 mm posterior · cuts no visible structure"));
        field("Position of the section").setValue(4.0);
        m_desk->pressKeyOf("section-side");
        QVERIFY(view().section()->n_W.y() > 0.0);
        m_desk->pressKeyOf("section-here");
        QVERIFY(std::abs(view().section()->p_W.y()) < 1e-9);
    }

    /// A field leaves Enter and some other keys to its parents, of which the view is one.
    void keysInTheFieldsOfTheBarAreNotForTheView()
    {
        m_desk->command("section").setChecked(true);
        QDoubleSpinBox& position = field("Position of the section");
        position.setFocus();
        PALPATE_TRY_VERIFY(position.hasFocus());
        const Vec3 camera_W(view().camera().GetPosition());
        QSignalSpy space(&viewport(), &ui::VtkViewport::spaceHeld), peek(&viewport(), &ui::VtkViewport::peekHeld);
        for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Space, Qt::Key_G, Qt::Key_Left, Qt::Key_Right,
                                  Qt::Key_Plus, Qt::Key_PageDown}) {
            m_desk->press(key);
        }
        m_desk->press(Qt::Key_Left, Qt::ShiftModifier);
        m_desk->press(Qt::Key_Right, Qt::ControlModifier);
        QVERIFY(!view().cursor().state().isPresent && !m_desk->command("palpate").isChecked());
        QVERIFY(space.isEmpty() && peek.isEmpty());
        QCOMPARE(Vec3(view().camera().GetPosition()), camera_W);
        for (QToolButton* button : bar().findChildren<QToolButton*>()) {
            button->setFocus();
            m_desk->press(Qt::Key_Return);
        }
        QVERIFY(!view().cursor().state().isPresent && !m_desk->command("palpate").isChecked());
        viewport().setFocus();
        m_desk->press(Qt::Key_Plus);
        QVERIFY(Vec3(view().camera().GetPosition()) != camera_W);
        view().look(view::ViewFrom::Front);
    }

    void directionsAreThoseOfThePatient()
    {
        m_desk->command("section").setChecked(true);
        auto& direction = *bar().findChild<QComboBox*>();
        const auto choose = [&](int index) {
            direction.setCurrentIndex(index);
            Q_EMIT direction.activated(index);
            field("Position of the section").setValue(-3.0);
        };
        choose(0);
        QVERIFY(std::abs(view().section()->n_W.z()) > 0.999 && bar().line().startsWith("axial, 3.0 mm inferior"));
        m_desk->pressKeyOf("section-direction");
        QVERIFY(std::abs(view().section()->n_W.y()) > 0.999);
        choose(2);
        QVERIFY(std::abs(view().section()->n_W.x()) > 0.999 && bar().line().startsWith("sagittal, 3.0 mm right"));
        view().look(view::ViewFrom::Oblique);
        choose(3);
        const Vec3 toViewer_W = -Vec3(view().camera().GetDirectionOfProjection());
        QVERIFY((view().section()->n_W - toViewer_W).norm() < 1e-9);
        QVERIFY(bar().line().startsWith("free, 3.0 mm nearer"));
        for (QToolButton* button : bar().findChildren<QToolButton*>()) {
            if (button->accessibleName() == "End the section") {
                button->click();
            }
        }
        QVERIFY(!view().section() && !bar().isVisible());
        view().look(view::ViewFrom::Front);
    }

    void movesAreOneUndoStepAndTheSceneFileKeepsThePlane()
    {
        const auto isAt = [this](double y) {
            return view().section() && std::abs(view().section()->p_W.y() - y) < 1e-9;
        };
        m_desk->command("section").setChecked(true);
        m_desk->pressKeyOf("section-here");
        const double start = view().section()->p_W.y();
        field("Position of the section").setValue(3.0);
        turnWheel(2, Qt::ShiftModifier);
        QVERIFY(isAt(4.0));
        m_desk->command("save").trigger();
        const auto saved = meshio::readScene(m_desk->folder() / "balls.palpate.json");
        QVERIFY(saved.isOk() && saved.value().section.has_value());
        QCOMPARE(saved.value().section->direction, meshio::SectionDirection::Coronal);
        QVERIFY(saved.value().section->n_W == -Vec3::UnitY());
        m_desk->command("undo").trigger();
        QVERIFY(isAt(start));
        m_desk->command("undo").trigger();
        QVERIFY(!view().section() && !m_desk->command("section").isChecked() && !bar().isVisible());
        m_desk->command("redo").trigger();
        m_desk->command("redo").trigger();
        QVERIFY(isAt(4.0) && bar().line().startsWith("coronal, 4.0 mm posterior"));

        QVERIFY(m_desk->open({m_desk->folder() / "balls.palpate.json"}));
        QVERIFY(isAt(4.0) && m_desk->command("section").isChecked() && bar().isVisible());
        QVERIFY(view().section()->n_W == -Vec3::UnitY());
        m_desk->pressKeyOf("section");
        QVERIFY(!view().section());
        m_desk->command("save").trigger();
        QVERIFY(m_desk->open({m_desk->folder() / "balls.palpate.json"}));
        QVERIFY(!view().section() && !bar().isVisible());
        view().look(view::ViewFrom::Front);
    }

    /// Pressed 5 mm into the front of the organ.
    void theInsetShowsWhatLiesBelowTheFinger()
    {
        auto& inset = *m_desk->window().findChild<ui::FingerInset*>();
        QVERIFY(!inset.isVisible());
        view::TouchState touch;
        touch.isPresent = touch.isInContact = true;
        touch.p_WG = Vec3(0, -44, 0); // centre of the fingertip
        touch.p_WH = Vec3(0, -39, 0);
        touch.n_W = -Vec3::UnitY();
        touch.fingertip_mm = 4.0;
        view().cursor().setState(touch);
        m_desk->pressKeyOf("finger-section");
        QVERIFY(inset.isVisible() && viewport().rect().contains(inset.geometry()));
        QVERIFY(inset.plane().p_W == Vec3(0, -40, 0) && (inset.plane().v_W - touch.n_W).norm() < 1e-12);
        QCOMPARE(inset.cuts().size(), std::size_t{2});
        // The section through both centres, the organ first.
        QVERIFY(std::abs(inset.cuts()[0].area_mm2 / (M_PI * 1600.0) - 1.0) < 0.05);
        QVERIFY(inset.cuts()[1].structure == 1);
        const QImage picture = inset.grab().toImage();
        const double scale = 0.5 * picture.width() / 25.0; // pixels per mm
        const auto colourAtDepth = [&](double x_mm, double depth_mm) {
            return picture.pixelColor(static_cast<int>(0.5 * picture.width() + scale * x_mm),
                                      static_cast<int>(0.35 * picture.height() + scale * depth_mm));
        };
        const QColor organ = colourAtDepth(10.0, 10.0);
        QVERIFY(std::abs(organ.red() - 204) < 4 && std::abs(organ.blue() - 51) < 4);
        QCOMPARE(colourAtDepth(10.0, -5.0), inset.palette().color(QPalette::Base));
        // It follows a hand that moves, and keeps the section of a hand that lifts off.
        touch.p_WG = Vec3(44, 0, 0);
        touch.p_WH = Vec3(39, 0, 0);
        touch.n_W = Vec3::UnitX();
        view().cursor().setState(touch);
        viewport().update();
        PALPATE_TRY_VERIFY(inset.plane().p_W.x() == 40.0);
        touch.isInContact = false;
        touch.p_WH = Vec3(50, 0, 0);
        view().cursor().setState(touch);
        viewport().update();
        QTest::qWait(100);
        QCOMPARE(inset.cuts().size(), std::size_t{2});
        // It moves away from the hand, and labels avoid it.
        touch.isInContact = true;
        touch.p_WG = touch.p_WH = viewport().rayAt(QPointF(inset.geometry().center())).p_W +
                                  400.0 * viewport().rayAt(QPointF(inset.geometry().center())).d_W;
        view().cursor().setState(touch);
        viewport().update();
        PALPATE_TRY_VERIFY(!inset.geometry().contains(viewport().placeOf(touch.p_WG).toPoint()));
        viewport().grabFramebuffer();
        const Eigen::Vector2d half(0.5 * viewport().width(), 0.5 * viewport().height());
        for (const Eigen::AlignedBox2d& label : view().cursor().labels().boxes()) {
            const QRectF shown(label.min().x() + half.x(), half.y() - label.max().y(), label.sizes().x(),
                               label.sizes().y());
            QVERIFY(!shown.intersects(inset.geometry()));
        }
        m_desk->pressKeyOf("finger-section");
        QVERIFY(!inset.isVisible());
        view().cursor().setState({});
    }

    void peekLastsWhileTheKeyIsHeld()
    {
        m_desk->window().findChild<ui::StructurePanel*>()->select(1);
        viewport().setFocus();
        QTest::keyPress(&viewport(), Qt::Key_G);
        QCOMPARE(opacity(0), 0.2);
        QCOMPARE(opacity(1), 1.0);
        QTest::keyRelease(&viewport(), Qt::Key_G);
        QCOMPARE(opacity(0), 1.0);
        QTest::keyPress(&viewport(), Qt::Key_G);
        QCOMPARE(opacity(0), 0.2);
        m_desk->window().findChild<ui::StructurePanel*>()->setFocus();
        PALPATE_TRY_VERIFY(opacity(0) == 1.0);
        QTest::keyRelease(&viewport(), Qt::Key_G);
        // Nothing is above the outer ball.
        m_desk->window().findChild<ui::StructurePanel*>()->select(0);
        viewport().setFocus();
        QTest::keyPress(&viewport(), Qt::Key_G);
        QVERIFY(opacity(0) == 1.0 && opacity(1) == 1.0);
        QTest::keyRelease(&viewport(), Qt::Key_G);
    }

    /// A message over the view does not cover the controls.
    void theBarStaysBelowMessages()
    {
        if (!view().section()) {
            m_desk->pressKeyOf("section");
        }
        auto& messages = *m_desk->window().findChild<ui::MessageBar*>();
        messages.offer(QStringLiteral("An offer"), QStringLiteral("Take it"), [] {});
        const auto globally = [](const QWidget& widget) { return QRect(widget.mapToGlobal(QPoint()), widget.size()); };
        PALPATE_TRY_VERIFY(messages.isVisible() && !globally(messages).intersects(globally(bar())));
        test::answerOf(messages)->click();
        PALPATE_TRY_VERIFY(bar().y() < 20);
        m_desk->pressKeyOf("section");
    }

    /// Numbers rise along z, from 0 at the feet to 200 at the head.
    void showsAnImageInTheSectionAndKeepsItInTheScene()
    {
        const auto file = writeImage("ct.mha", 25, [](const Vec3& p) { return 2.0 * p.z() + 100.0; });
        m_desk->window().open({file});
        auto& messages = *m_desk->window().findChild<ui::MessageBar*>();
        QVERIFY(test::newest(messages.text()).startsWith("ct.mha: is it an image"));
        test::answerOf(messages)->click();
        PALPATE_TRY_VERIFY(view().section() && bar().findChild<QCheckBox*>()->isVisible());
        field("Window").setValue(200.0);
        field("Level").setValue(100.0);
        const auto isGrey = [](const QColor& c, int value) {
            return std::abs(c.red() - value) < 5 && c.red() == c.green() && c.red() == c.blue();
        };
        QVERIFY(isGrey(colourAt(Vec3(5, 0, 0)), 128));
        QVERIFY(isGrey(colourAt(Vec3(5, 0, 25)), 191) && isGrey(colourAt(Vec3(5, 0, -25)), 64));
        field("Level").setValue(150.0);
        QVERIFY(isGrey(colourAt(Vec3(5, 0, 0)), 64));
        // The label at the pointer has the number: on a structure, beside all, and not beyond the image.
        auto* label = viewport().findChild<QLabel*>(QStringLiteral("pointed"));
        const auto textAt = [&](const Vec3& p_W) {
            label->setText(QStringLiteral("?"));
            label->show();
            Q_EMIT viewport().hovered(viewport().placeOf(p_W));
            (void)QTest::qWaitFor([&] { return !label->isVisible() || label->text() != "?"; }, 30000);
            return label->isVisible() ? label->text() : QString();
        };
        QVERIFY2(QRegularExpression("^core · image: 1(10|09|11)(\\.\\d+)?$").match(textAt(Vec3(2, 0, 5))).hasMatch(),
                 qPrintable(label->text()));
        QVERIFY2(QRegularExpression("^image: 1(80|79|81)(\\.\\d+)?$").match(textAt(Vec3(44, 0, 40))).hasMatch(),
                 qPrintable(label->text()));
        QCOMPARE(textAt(Vec3(60, 0, 0)), QString());
        // Nor when the pointer leaves for the bar.
        QVERIFY(!textAt(Vec3(44, 0, 40)).isEmpty());
        QEnterEvent enter(QPointF(5, 5), QPointF(5, 5), bar().mapToGlobal(QPointF(5, 5)));
        QCoreApplication::sendEvent(&bar(), &enter);
        QVERIFY(!label->isVisible());
        // Findings and lines far from the plane are faint: with the image on both sides of it.
        const Vec3 onPlane = view().section()->p_W, n_W = view().section()->n_W;
        const auto faintAt = [&](double inFront_mm) {
            const Vec3 p_W = onPlane + inFront_mm * n_W, q_W = p_W + 30.0 * n_W.unitOrthogonal();
            view().findings().set({{.p_W = p_W, .number = 1}});
            view().measures().set({{.from_W = p_W, .to_W = q_W}});
            viewport().grabFramebuffer();
            // Without a section the marks inside the organ are behind tissue, the others before it.
            return std::pair(view().findings().isHidden(0), view().measures().isFaint(0));
        };
        const std::pair isNear(false, false), isFar(true, true);
        QCOMPARE(faintAt(60.0), isFar);
        QCOMPARE(faintAt(-6.0), isFar);
        QVERIFY(!faintAt(3.0).second && !faintAt(-4.0).second);
        bar().findChild<QCheckBox*>()->setChecked(false);
        QVERIFY(colourAt(Vec3(5, 0, 0)).blue() > 190);
        QCOMPARE(faintAt(60.0), isFar);
        QVERIFY(!faintAt(-6.0).second);
        m_desk->command("section").setChecked(false);
        QCOMPARE(faintAt(60.0), isNear);
        m_desk->command("undo").trigger();
        view().findings().set({});
        view().measures().set({});
        bar().findChild<QCheckBox*>()->setChecked(true);
        // Undo takes back the window, ends the section and removes the image, redo shows all again, and the scene file
        // keeps all.
        const double usualWidth = [&] {
            m_desk->command("undo").trigger();
            return field("Window").value();
        }();
        QVERIFY(usualWidth < 190.0 && !isGrey(colourAt(Vec3(5, 0, 0)), 64));
        m_desk->command("undo").trigger();
        QVERIFY(!view().section());
        m_desk->command("undo").trigger();
        QVERIFY(!bar().findChild<QCheckBox*>()->isVisible());
        for (int i = 0; i < 3; ++i) {
            m_desk->command("redo").trigger();
        }
        PALPATE_TRY_VERIFY(bar().findChild<QCheckBox*>()->isVisible());
        m_desk->command("save").trigger();
        const auto saved = meshio::readScene(m_desk->folder() / "balls.palpate.json");
        QVERIFY(saved.isOk());
        QCOMPARE(saved.value().image, std::filesystem::absolute(file));
        QVERIFY((saved.value().imageWindow == geometry::GreyWindow{150.0, 200.0}));
        QVERIFY(m_desk->open({m_desk->folder() / "balls.palpate.json"}));
        QVERIFY(view().section() && m_desk->command("section").isChecked());
        PALPATE_TRY_VERIFY(bar().findChild<QCheckBox*>()->isVisible());
        QCOMPARE(field("Window").value(), 200.0);
        QVERIFY(isGrey(colourAt(Vec3(5, 0, 0)), 64));
        // A file that cannot be read says so.
        std::ofstream(m_desk->folder() / "broken.mha") << "NDims = 3\n";
        m_desk->window().open({m_desk->folder() / "broken.mha"});
        test::answerOf(messages)->click();
        PALPATE_TRY_VERIFY(messages.text().contains("broken.mha: "));
        QVERIFY(!bar().findChild<QCheckBox*>()->isVisible());
        m_desk->command("undo").trigger();
    }

    /// The picture of resources/docs/window.md.
    void drawsTheFigure()
    {
        const QString folder = qEnvironmentVariable("PALPATE_TEST_PICTURES");
        if (folder.isEmpty()) {
            QSKIP("set PALPATE_TEST_PICTURES to a folder to draw window-section.png");
        }
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->openPhantom());
        m_desk->command("section").setChecked(true);
        bar().findChild<QComboBox*>()->setCurrentIndex(0);
        Q_EMIT bar().findChild<QComboBox*>()->activated(0);
        QTest::qWait(1500);
        QVERIFY(viewport().grab().save(folder + QStringLiteral("/window-section.png")));
    }

    void picturesForTheEye()
    {
        const QString pictures = qEnvironmentVariable("PALPATE_TEST_PICTURES");
        if (pictures.isEmpty()) {
            QSKIP("set PALPATE_TEST_PICTURES to a folder to keep pictures");
        }
        const auto keep = [&](const char* name) {
            QTest::qWait(1500);
            QVERIFY(m_desk->picture().save(QStringLiteral("%1/%2.png").arg(pictures, QLatin1String(name))));
        };
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->openPhantom());
        m_desk->command("section").setChecked(true);
        keep("phantom-section");
        bar().findChild<QComboBox*>()->setCurrentIndex(0);
        Q_EMIT bar().findChild<QComboBox*>()->activated(0);
        keep("phantom-axial");
        const auto rows = m_desk->window().model().rows();
        // Numbers as in a portal venous CT.
        const auto image = writeImage(
            "ct.mha", 60,
            [&, z = 1e9, fills = std::vector<std::vector<geometry::SectionStrip>>()](const Vec3& p) mutable {
                const auto plane = geometry::SectionPlane::through(p, Vec3::UnitZ());
                static geometry::SectionPlane level;
                if (p.z() != z) {
                    z = p.z();
                    level = plane;
                    fills.clear();
                    for (const study::OpenStructure& row : rows) {
                        const auto& surface = *row.loaded.surface;
                        fills.push_back(geometry::filled(geometry::sectionOf(
                            surface.mesh.vertices, surface.mesh.triangles, surface.twoSided, level)));
                    }
                }
                double number = -80.0;
                for (std::size_t i = 0; i < fills.size(); ++i) {
                    const bool isIn = std::any_of(fills[i].begin(), fills[i].end(),
                                                  [&](const auto& one) { return one.contains(level.inPlane(p)); });
                    const QString name = QString::fromStdString(rows[i].loaded.description.name);
                    number = !isIn ? number : name.contains("vein") ? 170.0 : name.contains("lump") ? 60.0 : 110.0;
                }
                return number + 12.0 * std::sin(13.7 * p.x() + 3.1 * p.y()) * std::cos(7.9 * p.z() + 5.3 * p.y());
            });
        m_desk->window().open({image});
        test::answerOf(*m_desk->window().findChild<ui::MessageBar*>())->click();
        PALPATE_TRY_VERIFY(bar().findChild<QCheckBox*>()->isVisible());
        keep("phantom-image");
        m_desk->command("section").setChecked(false);
        m_desk->window().findChild<ui::StructurePanel*>()->select(1);
        m_desk->command("peek").setChecked(true);
        keep("phantom-peek");
        const std::filesystem::path liver = std::filesystem::path(PALPATE_SHARED_DIR) / "anatomy/vh_f_liver_scene";
        if (!std::filesystem::exists(liver)) {
            QSKIP("the reference anatomy is not there");
        }
        meshio::ReadOptions options;
        options.unit_mm = 1000.0;
        options.frame = core::FileFrame::YUp;
        QVERIFY(m_desk->show());
        QSignalSpy ready(&m_desk->window(), &MainWindow::ready);
        m_desk->window().open({liver}, options);
        PALPATE_TRY_VERIFY(ready.count() > 0);
        m_desk->command("section").setChecked(true);
        keep("liver-section");
    }
};

PALPATE_TEST(Inside)
#include "tst_Inside.moc"
