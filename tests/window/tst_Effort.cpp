// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"

#include <palpate/meshio/MeshFile.h>
#include <palpate/ui/HintLine.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/ui/VtkViewport.h>

#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QTabletEvent>
#include <QWheelEvent>

#include <cmath>

using namespace palpate;

/// Presses the phantom by effort, with the pointer alone: the same hold penetrates less over the lump than beside.
class Effort : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;
    ui::TouchReading m_touch;

    [[nodiscard]] MainWindow& window() const { return m_desk->window(); }
    [[nodiscard]] ui::VtkViewport& viewport() const { return window().viewport(); }

    template<class Field>
    [[nodiscard]] Field& field(const char* name) const
    {
        for (Field* one : window().findChildren<Field*>()) {
            if (one->accessibleName() == QLatin1String(name)) {
                return *one;
            }
        }
        qFatal("no field \"%s\"", name);
    }

    void turnWheel(int notches) const
    {
        const QPointF middle = viewport().rect().center();
        QWheelEvent event(middle, viewport().mapToGlobal(middle), {}, QPoint(0, 120 * notches), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&viewport(), &event);
    }

    /// Holds the button until the force is at its bound and the hand has settled.
    ui::TouchReading held(const QPointF& place, double most_N)
    {
        m_touch = {};
        QTest::mouseMove(&viewport(), place.toPoint());
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, place.toPoint());
        QTest::qWait(static_cast<int>(1000.0 * (most_N + 1.0)));
        const ui::TouchReading reading = m_touch;
        if (const QByteArray folder = qgetenv("PALPATE_PICTURES"); !folder.isEmpty()) {
            m_desk->picture().save(
                QStringLiteral("%1/effort-%2.png").arg(QString::fromLocal8Bit(folder)).arg(qRound(place.x())));
        }
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, place.toPoint());
        QTest::qWait(300);
        return reading;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->openPhantom());
        connect(&window().palpation(), &ui::PalpationController::touched, this,
                [this](const ui::TouchReading& touch) { m_touch = touch; });
    }
    void cleanupTestCase() { m_desk.reset(); }

    void itIsChosenByKeyAndByPanel()
    {
        QVERIFY(!window().palpation().isByEffort());
        viewport().setFocus();
        m_desk->pressKeyOf("effort");
        QVERIFY(window().palpation().isByEffort());
        QCOMPARE(field<QComboBox>("Press mode").currentIndex(), 1);
        m_desk->pressKeyOf("effort");
        QVERIFY(!window().palpation().isByEffort());
        auto& choice = field<QComboBox>("Press mode");
        choice.setCurrentIndex(1);
        Q_EMIT choice.activated(1);
        QVERIFY(window().palpation().isByEffort() && m_desk->command("effort").isChecked());
        if (const QByteArray folder = qgetenv("PALPATE_PICTURES"); !folder.isEmpty()) {
            auto* dock = window().findChild<QDockWidget*>(QStringLiteral("device"));
            dock->raise();
            QTest::qWait(200);
            m_desk->picture().save(QString::fromLocal8Bit(folder) + QStringLiteral("/effort-panel.png"));
            window().findChild<QDockWidget*>(QStringLiteral("touch"))->raise();
        }
    }
    void theHintSaysWhatTheWheelDoes()
    {
        const auto* hint = window().findChild<ui::HintLine*>();
        QVERIFY2(hint->said().contains(QStringLiteral("wheel for the force limit")), qPrintable(hint->said()));
        m_desk->pressKeyOf("effort");
        QVERIFY2(hint->said().contains(QStringLiteral("wheel for depth")), qPrintable(hint->said()));
        m_desk->pressKeyOf("effort");
        QVERIFY2(hint->said().contains(QStringLiteral("wheel for the force limit")), qPrintable(hint->said()));
        QVERIFY(m_desk->openPhantom());
        QVERIFY2(hint->said().contains(QStringLiteral("wheel for the force limit")), qPrintable(hint->said()));
    }
    void theWheelSetsTheBound()
    {
        m_desk->pressKeyOf("palpate");
        QCOMPARE(field<QDoubleSpinBox>("Maximum force").value(), 5.0);
        const double depth_mm = window().palpation().depth_mm();
        turnWheel(-2);
        QCOMPARE(field<QDoubleSpinBox>("Maximum force").value(), 4.0);
        QCOMPARE(window().palpation().depth_mm(), depth_mm);
        QCOMPARE(window().palpation().text(), QStringLiteral("presses up to 4.0 N"));
    }
    void theSameHoldSinksLessOverTheLump()
    {
        viewport().view().look(view::ViewFrom::Front);
        QTest::qWait(300);
        const core::Vec3 lump_W = lumpCentre();
        const QPointF over = viewport().placeOf(lump_W);
        const QPointF aside = viewport().placeOf(lump_W + core::Vec3(35, 0, 0));
        const ui::TouchReading beside = held(aside, 4.0), lump = held(over, 4.0);
        QVERIFY2(std::abs(beside.force_N - 4.0) < 0.4, qPrintable(QString::number(beside.force_N)));
        // The effort is along the press; the sideways force of the lump (maps.md) is added.
        QVERIFY2(lump.force_N > 3.6 && lump.force_N < 5.2, qPrintable(QString::number(lump.force_N)));
        const QString depths =
            QStringLiteral("%1 mm over the lump, %2 mm beside it").arg(lump.depth_mm).arg(beside.depth_mm);
        QVERIFY2(lump.depth_mm > 2.0 && lump.depth_mm < 0.85 * beside.depth_mm, qPrintable(depths));
    }
    /// A pen sets the force directly: half pressure is half the bound.
    void aPenSaysTheForce()
    {
        const QPointF place = viewport().placeOf(lumpCentre() + core::Vec3(35, 0, 0));
        const QPointingDevice pen(QStringLiteral("pen"), 77, QInputDevice::DeviceType::Stylus,
                                  QPointingDevice::PointerType::Pen,
                                  QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 1);
        const auto send = [&](QEvent::Type type, double pressure) {
            QTabletEvent event(type, &pen, place, viewport().mapToGlobal(place), pressure, 0, 0, 0, 0, 0,
                               Qt::NoModifier, Qt::LeftButton,
                               type == QEvent::TabletRelease ? Qt::NoButton : Qt::LeftButton);
            QApplication::sendEvent(&viewport(), &event);
            QVERIFY(!event.isAccepted()); // so that Qt synthesises the mouse event
        };
        send(QEvent::TabletPress, 0.5);
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, place.toPoint());
        PALPATE_TRY_VERIFY(std::abs(m_touch.force_N - 2.0) < 0.2);
        QTest::qWait(1500);
        QVERIFY(std::abs(m_touch.force_N - 2.0) < 0.2); // and stays
        send(QEvent::TabletMove, 0.25);
        PALPATE_TRY_VERIFY(std::abs(m_touch.force_N - 1.0) < 0.2);
        send(QEvent::TabletRelease, 0.0);
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, place.toPoint());
    }
    void theChoiceIsKept()
    {
        QVERIFY(m_desk->show());
        QVERIFY(window().palpation().isByEffort());
        QCOMPARE(field<QDoubleSpinBox>("Maximum force").value(), 4.0);
        m_desk->pressKeyOf("effort");
        QVERIFY(!window().palpation().isByEffort());
    }

  private:
    /// Returns the centre of the phantom's larger lump [mm].
    [[nodiscard]] core::Vec3 lumpCentre() const
    {
        const auto lump = meshio::readMesh(m_desk->folder() / "phantom" / "lump-20-mm.stl");
        if (lump.isOk()) {
            return lump.value().structures[0].mesh.bounds().center();
        }
        qFatal("no lump");
    }
};

PALPATE_TEST(Effort)
#include "tst_Effort.moc"
