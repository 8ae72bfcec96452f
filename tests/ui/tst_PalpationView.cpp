// SPDX-License-Identifier: BSD-3-Clause
#include "Balls.h"
#include "TestRunner.h"

#include <palpate/device/PlaybackDevice.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/ui/PalpationView.h>
#include <palpate/ui/VtkViewport.h>
#include <palpate/vtk/PolyData.h>

#include <QSignalSpy>
#include <QTemporaryDir>

#include <cmath>
#include <limits>
#include <optional>

using namespace palpate;
using core::StatusCode;
using core::Vec3;

namespace {

vtkSmartPointer<vtkPolyData> inwardBall()
{
    geometry::TriangleMesh mesh = test::ball(50.0, 5);
    geometry::flip(mesh); // as of vtkMarchingCubes
    return palpate::vtk::polyDataOf(mesh);
}

/// Returns a hand that stays 4 mm below the top of the ball.
std::unique_ptr<device::PlaybackDevice> pressingHand()
{
    std::vector<Vec3> places;
    for (int i = 0; i < 2000; ++i) {
        places.emplace_back(0.0, 0.0, std::max(46.0, 51.0 - 0.01 * i));
    }
    auto hand = std::make_unique<device::PlaybackDevice>(places);
    hand->setLooping(true);
    return hand;
}

} // namespace

/// The widget for other programs: what a host sees and calls.
class PalpationViewTest : public QObject
{
    Q_OBJECT

    std::unique_ptr<ui::PalpationView> m_view;
    std::optional<ui::TouchReading> m_reading;
    QTemporaryDir m_folder;

    [[nodiscard]] bool isFelt(double force_N) const
    {
        return m_reading && std::abs(m_reading->force_N - force_N) < 0.03;
    }

  private Q_SLOTS:
    void init()
    {
        m_view = std::make_unique<ui::PalpationView>();
        m_view->resize(600, 400);
        connect(m_view.get(), &ui::PalpationView::touched, this,
                [this](const ui::TouchReading& reading) { m_reading = reading; });
    }
    void cleanup()
    {
        m_view.reset();
        m_reading.reset();
    }

    void refusesWhatCannotBeFeltAndStaysUsable()
    {
        QCOMPARE(m_view->add(nullptr, {.name = "liver"}).status().code(), StatusCode::Empty);
        const auto wrong = m_view->add(inwardBall(), {.name = "liver", .tissue = {.stiffness_N_per_mm = -1.0}});
        QCOMPARE(wrong.status().code(), StatusCode::OutOfRange);
        QCOMPARE(m_view->text(wrong.status()),
                 QStringLiteral("liver: stiffness_N_per_mm: found -1, expected 0 to 1000 N/mm"));
        QCOMPARE(m_view->setStiffness(0, 1.0).code(), StatusCode::OutOfRange);
        QCOMPARE(m_view->add(inwardBall(), {.name = "liver"}).value(), 0);
        QCOMPARE(m_view->setStiffness(0, std::nan("")).code(), StatusCode::NonFinite);
        QCOMPARE(m_view->setShown(1, false).code(), StatusCode::OutOfRange);
        QVERIFY(m_view->notes(1).isEmpty());
        QVERIFY(m_view->surface(1) == nullptr);
    }

    void turnsASurfaceOutwardsAndSaysSo()
    {
        QCOMPARE(m_view->add(inwardBall(), {.name = "liver"}).value(), 0);
        QCOMPARE(m_view->notes(0), QStringList{"1 closed part was inside out and turned to face outwards"});
        QVERIFY(m_view->surface(0)->report.volume_mm3 > 0.0);
    }

    void isFeltSoftenedAndHiddenWhileTouched()
    {
        const int liver = m_view->add(inwardBall(), {.name = "liver", .tissue = {.stiffness_N_per_mm = 0.4}}).value();
        QVERIFY(m_view->useDevice(pressingHand()).isOk());
        PALPATE_TRY_VERIFY(isFelt(1.6)); // 4 mm
        QCOMPARE(m_reading->structure, QStringLiteral("liver"));
        QVERIFY(m_view->setStiffness(liver, 0.2).isOk());
        PALPATE_TRY_VERIFY(isFelt(0.8));
        QVERIFY(m_view->setShown(liver, false).isOk());
        PALPATE_TRY_VERIFY(isFelt(0.0));
        QVERIFY(m_view->setShown(liver, true).isOk());
        PALPATE_TRY_VERIFY(isFelt(0.8));
    }

    void isPressedWithThePointer()
    {
        QVERIFY(m_view->add(inwardBall(), {.name = "liver", .tissue = {.stiffness_N_per_mm = 0.5}}).isOk());
        auto* viewport = m_view->findChild<ui::VtkViewport*>();
        m_view->show(); // picking needs a drawn view
        QVERIFY(QTest::qWaitForWindowExposed(m_view.get()));
        m_view->setPalpating(true);
        const QPoint middle = viewport->rect().center();
        QTest::mouseMove(viewport, middle);
        QTest::mousePress(viewport, Qt::LeftButton, {}, middle);
        PALPATE_TRY_VERIFY(m_reading && m_reading->depth_mm > 1.0 && m_reading->force_N > 0.5);
        QTest::mouseRelease(viewport, Qt::LeftButton, {}, middle);
        PALPATE_TRY_VERIFY(m_reading && m_reading->depth_mm == 0.0);
    }

    void aSecondStructureKeepsTheFirst()
    {
        QCOMPARE(m_view->add(inwardBall(), {.name = "liver", .tissue = {.stiffness_N_per_mm = 0.4}}).value(), 0);
        const auto lump = palpate::vtk::polyDataOf(test::ball(5.0, 3));
        QCOMPARE(m_view->add(lump, {.name = "lump", .layer = 1}).value(), 1);
        QVERIFY(m_view->useDevice(pressingHand()).isOk());
        PALPATE_TRY_VERIFY(isFelt(1.6));
    }

    void recordsWithTheSurfaces()
    {
        QVERIFY(m_view->add(inwardBall(), {.name = "liver", .tissue = {.stiffness_N_per_mm = 0.4}}).isOk());
        QVERIFY(m_view->useDevice(pressingHand()).isOk());
        const std::filesystem::path path = m_folder.filePath("r.palpate").toStdString();
        QVERIFY(!m_view->isRecording());
        QVERIFY(m_view->startRecording(path, ui::Embed::Yes).isOk());
        PALPATE_TRY_VERIFY(isFelt(1.6));
        QVERIFY(m_view->isRecording());
        QVERIFY(m_view->stopRecording().isOk());
        const auto opened = session::RecordingReader::open(path);
        QVERIFY2(opened.isOk(), opened.status().message().c_str());
        QVERIFY(opened.value()->verify().isOk());
        QCOMPARE(opened.value()->embeddedHashes().size(), std::size_t{1});
        QCOMPARE(opened.value()->scenes()[0].structures.at(0).name, std::string("liver"));
    }

    void reportsFaults()
    {
        QVERIFY(m_view->add(inwardBall(), {.name = "liver"}).isOk());
        QSignalSpy faults(m_view.get(), &ui::PalpationView::faulted);
        std::vector<Vec3> places(300, Vec3(0, 0, 51));
        places.push_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
        auto hand = std::make_unique<device::PlaybackDevice>(places);
        hand->setLooping(true);
        QVERIFY(m_view->useDevice(std::move(hand)).isOk());
        PALPATE_TRY_VERIFY(!faults.isEmpty());
        QVERIFY(!faults[0][0].toString().isEmpty());
        m_view->rearm();
        const auto before = faults.size();
        PALPATE_TRY_VERIFY(faults.size() > before);
    }
};

PALPATE_TEST_NAMED("PalpationView", PalpationViewTest)
#include "tst_PalpationView.moc"
