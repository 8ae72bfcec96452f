// SPDX-License-Identifier: BSD-3-Clause
#include "Rows.h"
#include "TestRunner.h"

#include <palpate/ui/VtkViewport.h>

#include <QGuiApplication>
#include <QWheelEvent>

using namespace palpate;

/// Tests the bridge from VTK to Qt with a real OpenGL context.
class Viewport : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void init()
    {
        if (QGuiApplication::platformName() != QStringLiteral("xcb")) {
            QSKIP("no OpenGL without a display: run under xvfb-run with QT_QPA_PLATFORM=xcb");
        }
        QSurfaceFormat::setDefaultFormat(ui::VtkViewport::surfaceFormat());
        m_viewport = std::make_unique<ui::VtkViewport>();
        m_viewport->resize(500, 400);
        std::vector<view::ViewStructure> pictures;
        const ui::StructureRow row = test::row("ball", test::ball(20.0, 4));
        pictures.push_back({view::StructureActor(row.picture, {{0.9, 0.1, 0.1}, 1.0, true}), row.touch});
        m_viewport->view().setStructures(std::move(pictures));
        m_viewport->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_viewport.get(), test::kPatience_ms));
        m_viewport->view().look(view::ViewFrom::Front);
    }
    void cleanup() { m_viewport.reset(); }

    void picturesReachTheWidget()
    {
        const QImage image = m_viewport->grabFramebuffer();
        const QColor middle = image.pixelColor(image.width() / 2, image.height() / 2);
        QVERIFY(middle.red() > 2 * middle.green());
        const QColor corner = image.pixelColor(image.width() - 5, 5);
        QVERIFY(std::abs(corner.red() - corner.green()) < 40);
    }
    void pictureIsUprightAndWhole()
    {
        m_viewport->view().setBackground({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, {1.0, 1.0, 1.0});
        const QImage image = m_viewport->grabFramebuffer();
        QVERIFY(image.pixelColor(3, 3).green() > 230);
        QVERIFY(image.pixelColor(3, image.height() - 3).green() < 25);
    }
    void followsItsSize()
    {
        m_viewport->resize(300, 260);
        PALPATE_TRY_COMPARE(m_viewport->grabFramebuffer().width(), 300);
        QVERIFY(m_viewport->view().pick(m_viewport->rayAt({150, 130})).has_value());
        QVERIFY(!m_viewport->view().pick(m_viewport->rayAt({3, 3})).has_value());
    }
    void dragTurnsTheCamera()
    {
        const core::Vec3 before(m_viewport->view().camera().GetPosition());
        QTest::mousePress(m_viewport.get(), Qt::LeftButton, {}, {200, 200});
        QTest::mouseMove(m_viewport.get(), {260, 200});
        QTest::mouseRelease(m_viewport.get(), Qt::LeftButton, {}, {260, 200});
        const core::Vec3 after(m_viewport->view().camera().GetPosition());
        QVERIFY((after - before).norm() > 5.0);
        QVERIFY(std::abs(after.norm() - before.norm()) < 1e-6 * before.norm());
    }
    void palpateModeGivesPressesInsteadOfTurns()
    {
        m_viewport->setMode(ui::VtkViewport::Mode::Palpate);
        QSignalSpy pressed(m_viewport.get(), &ui::VtkViewport::pointerPressed);
        QSignalSpy released(m_viewport.get(), &ui::VtkViewport::pointerReleased);
        const core::Vec3 before(m_viewport->view().camera().GetPosition());
        QTest::mousePress(m_viewport.get(), Qt::LeftButton, {}, {200, 200});
        QTest::mouseMove(m_viewport.get(), {260, 200});
        QTest::mouseRelease(m_viewport.get(), Qt::LeftButton, {}, {260, 200});
        QCOMPARE(pressed.count(), 1);
        QCOMPARE(released.count(), 1);
        QCOMPARE(core::Vec3(m_viewport->view().camera().GetPosition()), before);
    }
    void wheelZoomsOrSetsTheDepth()
    {
        QSignalSpy depth(m_viewport.get(), &ui::VtkViewport::depthTurned);
        const auto turn = [this] {
            QWheelEvent event(QPointF(250, 200), m_viewport->mapToGlobal(QPointF(250, 200)), {}, {0, 120}, Qt::NoButton,
                              {}, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(m_viewport.get(), &event);
        };
        const double before = m_viewport->view().camera().GetDistance();
        turn();
        QVERIFY(m_viewport->view().camera().GetDistance() < before);
        QCOMPARE(depth.count(), 0);
        m_viewport->setMode(ui::VtkViewport::Mode::Palpate);
        turn();
        QCOMPARE(depth.count(), 1);
        QCOMPARE(depth.first().first().toDouble(), 1.0);
    }
    void aClickIsNoDrag()
    {
        QSignalSpy clicked(m_viewport.get(), &ui::VtkViewport::clicked);
        QSignalSpy hovered(m_viewport.get(), &ui::VtkViewport::hovered);
        QTest::mouseMove(m_viewport.get(), {210, 190});
        PALPATE_TRY_VERIFY(hovered.count() > 0);
        QTest::mouseClick(m_viewport.get(), Qt::LeftButton, Qt::ControlModifier, {210, 190});
        QCOMPARE(clicked.count(), 1);
        QCOMPARE(clicked.first().first().toPointF(), QPointF(210, 190));
        QCOMPARE(clicked.first().last().value<Qt::KeyboardModifiers>(), Qt::KeyboardModifiers(Qt::ControlModifier));
        QTest::mousePress(m_viewport.get(), Qt::LeftButton, {}, {210, 190});
        QTest::mouseMove(m_viewport.get(), {240, 190});
        QTest::mouseRelease(m_viewport.get(), Qt::LeftButton, {}, {240, 190});
        QCOMPARE(clicked.count(), 1);
        m_viewport->setMode(ui::VtkViewport::Mode::Palpate);
        QTest::mouseClick(m_viewport.get(), Qt::LeftButton, {}, {210, 190});
        QCOMPARE(clicked.count(), 1);
    }
    void translucencyIsTheSameAtRestAndInMotion()
    {
        const ui::StructureRow row = test::row("ball", test::ball(20.0, 4));
        std::vector<view::ViewStructure> pictures;
        pictures.push_back({view::StructureActor(row.picture, {{0.9, 0.4, 0.3}, 0.45, true}, true), row.touch});
        m_viewport->view().setStructures(std::move(pictures));
        m_viewport->refineNext();
        const QImage still = m_viewport->grabFramebuffer();
        m_viewport->view().setSortedTransparency(false);
        const QImage moving = m_viewport->grabFramebuffer();
        const QPoint middle(still.width() / 2, still.height() / 2);
        QVERIFY(still.pixelColor(middle).red() > still.pixelColor(middle).blue() + 20);
        for (int dy = -60; dy <= 60; dy += 3) { // well inside the ball
            for (int dx = -60; dx <= 60; dx += 3) {
                const QColor a = still.pixelColor(middle + QPoint(dx, dy)),
                             b = moving.pixelColor(middle + QPoint(dx, dy));
                QVERIFY(std::abs(a.red() - b.red()) <= 2 && std::abs(a.green() - b.green()) <= 2 &&
                        std::abs(a.blue() - b.blue()) <= 2);
            }
        }
    }
    void placesAndRaysAreInverse()
    {
        const view::Ray ray = m_viewport->rayAt({320, 110});
        const QPointF place = m_viewport->placeOf(ray.p_W + 40.0 * ray.d_W);
        QVERIFY((place - QPointF(320, 110)).manhattanLength() < 1e-6);
        const auto palpable = m_viewport->palpablePlace();
        QVERIFY(palpable && (*palpable - QPointF(250, 200)).manhattanLength() < 1.0);
    }
    /// The view handles Space; Tab moves the focus as usual.
    void spaceIsTheViewsAndTabLeavesIt()
    {
        QSignalSpy space(m_viewport.get(), &ui::VtkViewport::spaceHeld);
        QTest::keyPress(m_viewport.get(), Qt::Key_Space);
        QTest::keyRelease(m_viewport.get(), Qt::Key_Space);
        QCOMPARE(space.count(), 2);
        QKeyEvent tab(QEvent::KeyPress, Qt::Key_Tab, Qt::NoModifier);
        QCoreApplication::sendEvent(m_viewport.get(), &tab);
        QVERIFY(!tab.isAccepted()); // no other widget in this window takes keys
    }

  private:
    std::unique_ptr<ui::VtkViewport> m_viewport;
};

PALPATE_TEST(Viewport)
#include "tst_Viewport.moc"
