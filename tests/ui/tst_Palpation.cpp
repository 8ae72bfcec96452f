// SPDX-License-Identifier: BSD-3-Clause
#include "Rows.h"
#include "TestRunner.h"

#include <palpate/device/DevicePresets.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/ui/PalpationController.h>

#include <QTemporaryDir>

#include <algorithm>
#include <atomic>
#include <optional>

using namespace palpate;

/// Tests the whole path from pointer to displayed number without rendering: view, hand, device, servo thread, snapshot,
/// reading.
class Palpation : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void init()
    {
        m_model = std::make_unique<ui::StructureModel>();
        m_live = std::make_unique<ui::LiveTouch>(*m_model);
        m_viewport = std::make_unique<ui::VtkViewport>();
        m_viewport->resize(600, 400);
        m_palpation = std::make_unique<ui::PalpationController>(*m_viewport, *m_live, *m_model);
        std::vector<ui::StructureRow> rows;
        rows.push_back(test::row("liver", test::ball(50.0, 5)));
        std::vector<view::ViewStructure> pictures;
        pictures.push_back({view::StructureActor(rows[0].picture), rows[0].touch});
        m_viewport->view().setStructures(std::move(pictures));
        m_model->setRows(std::move(rows));
        (void)m_viewport->rayAt({0, 0}); // sets the size of the window
        m_viewport->view().look(view::ViewFrom::Front);
        m_palpation->setSceneSize(200.0);
        QVERIFY(m_live->start().isOk());
        connect(m_palpation.get(), &ui::PalpationController::touched, this,
                [this](const ui::TouchReading& reading) { m_reading = reading; });
        connect(m_palpation.get(), &ui::PalpationController::handGone, this, [this] { m_reading.reset(); });
    }
    void cleanup()
    {
        m_palpation.reset();
        m_live.reset();
        m_viewport.reset();
        m_model.reset();
        m_reading.reset();
    }
    void pressInTheMiddleIsFeltAsStiffnessTimesDepth()
    {
        m_palpation->setPalpating(true);
        m_palpation->pressAt({300, 200});
        PALPATE_TRY_VERIFY(m_reading && m_reading->depth_mm > 3.9);
        QCOMPARE(m_reading->structure, QStringLiteral("liver"));
        // Straight onto the sphere: 4 mm at 0.5 N/mm, except for the tilt of the facet.
        PALPATE_TRY_VERIFY2(m_reading && std::abs(m_reading->force_N - 2.0) < 0.02,
                            qPrintable(QString::number(m_reading->force_N))); // the approach is slow near its end
        QVERIFY(m_reading->constraints >= 1);
        const view::TouchState& shown = m_viewport->view().cursor().state();
        QVERIFY(shown.isInContact);
        QVERIFY(std::abs(shown.p_WG.norm() - 50.0) < 0.1);
    }
    /// The same depth and force as with a point, straight on and on a slope of 45 degrees.
    void aFingertipBeginsOutsideToo()
    {
        m_live->setFingertip(8.0);
        PALPATE_TRY_VERIFY(m_live->scene() != nullptr && m_live->scene()->fingertip_mm() == 8.0);
        m_palpation->setPalpating(true);
        const view::TouchState& shown = m_viewport->view().cursor().state();
        for (const QPointF place : {QPointF(300, 200), m_viewport->placeOf(50.0 * core::Vec3(1, -1, 0).normalized())}) {
            m_palpation->moveTo(place);
            const core::Vec3 d_W = m_viewport->rayAt(place).d_W;
            const auto slantNow = [&] { return -d_W.dot(shown.p_WH.normalized()); };
            // 2 mm before the touch along the line of sight
            PALPATE_TRY_VERIFY2(std::abs(shown.p_WH.norm() - 58.0 - 2.0 * slantNow()) < 0.2,
                                qPrintable(QString::number(shown.p_WH.norm())));
            const double slant = slantNow();
            m_palpation->pressAt(place);
            PALPATE_TRY_VERIFY2(m_reading && std::abs(m_reading->force_N - 2.0 * slant) < 0.1,
                                qPrintable(QString::number(m_reading ? m_reading->force_N : -1.0)));
            QVERIFY(std::abs(m_reading->depth_mm - 4.0 * slant) < 0.2);
            QVERIFY(std::abs(shown.p_WG.norm() - 58.0) < 0.2 && std::abs(shown.onSurface_W().norm() - 50.0) < 0.2);
            QVERIFY((shown.n_W - shown.p_WG.normalized()).norm() < 0.1);
            QVERIFY(std::abs(m_live->newest().felt.touched_W().norm() - 50.0) < 0.2);
            m_palpation->letGo();
            PALPATE_TRY_VERIFY(m_reading && m_reading->structure.isEmpty());
        }
    }
    /// The next step of the keys moves the hand by that step, not to where the larger ball would have touched first.
    void aLargerFingertipKeepsThePress()
    {
        const auto hasRadius = [this](double radius_mm) {
            return m_live->scene() != nullptr && m_live->scene()->fingertip_mm() == radius_mm;
        };
        for (const bool isByEffort : {false, true}) {
            ui::HandSettings settings;
            settings.isByEffort = isByEffort;
            settings.effort_N = 2.0;
            m_palpation->setPress(settings);
            m_live->setFingertip(2.0);
            PALPATE_TRY_VERIFY(hasRadius(2.0));
            m_palpation->setPalpating(true);
            m_palpation->togglePress();
            PALPATE_TRY_VERIFY(m_reading && m_reading->depth_mm > 3.9);
            const view::TouchState& shown = m_viewport->view().cursor().state();
            const core::Vec3 before_W = shown.p_WH;
            m_live->setFingertip(12.0);
            PALPATE_TRY_VERIFY(hasRadius(12.0));
            constexpr double kStride_mm = 2.0; // of the keys, see PointerHandSettings
            m_palpation->stepAlongScreen(1, 0);
            PALPATE_TRY_VERIFY((shown.p_WH - before_W).norm() > 0.9 * kStride_mm);
            QVERIFY2((shown.p_WH - before_W).norm() < 1.1 * kStride_mm,
                     qPrintable(QString::number((shown.p_WH - before_W).norm())));
            QVERIFY(shown.isInContact && !m_palpation->isSlidOff());
            m_palpation->letGo();
            PALPATE_TRY_VERIFY((m_live->newest().flags & servo::kNoHand) != 0); // lifted off
            // The next press begins outside.
            m_palpation->togglePress();
            PALPATE_TRY_VERIFY(m_reading && m_reading->depth_mm > 3.9);
            PALPATE_TRY_VERIFY2(std::abs(shown.p_WG.norm() - 62.0) < 0.2,
                                qPrintable(QString::number(shown.p_WG.norm())));
            m_palpation->letGo();
            PALPATE_TRY_VERIFY((m_live->newest().flags & servo::kNoHand) != 0);
        }
    }
    void hoverIsShownButNotFelt()
    {
        m_palpation->setPalpating(true);
        m_palpation->moveTo({300, 200});
        PALPATE_TRY_VERIFY(m_reading.has_value());
        QVERIFY(m_reading->structure.isEmpty());
        const view::TouchState& shown = m_viewport->view().cursor().state();
        QVERIFY(shown.isPresent && !shown.isInContact);
        QVERIFY(std::abs(shown.p_WH.norm() - 52.0) < 0.1);
    }
    void stiffnessChangesUnderThePressedHand()
    {
        m_palpation->setPalpating(true);
        m_palpation->pressAt({300, 200});
        PALPATE_TRY_VERIFY(m_reading && m_reading->depth_mm > 3.9);
        meshio::SceneStructure harder = m_model->structure(0);
        harder.tissue.stiffness_N_per_mm = 1.0;
        m_model->edit(0, harder);
        PALPATE_TRY_VERIFY(m_reading && std::abs(m_reading->force_N - 4.0) < 0.05);
    }
    void escapeLetsGoThenTheHandIsGone()
    {
        m_palpation->setPalpating(true);
        m_palpation->pressAt({300, 200});
        PALPATE_TRY_VERIFY(m_reading && m_reading->depth_mm > 3.0);
        QVERIFY(m_palpation->letGo());
        PALPATE_TRY_VERIFY(m_reading && m_reading->structure.isEmpty());
        QVERIFY(!m_palpation->letGo()); // nothing was pressed
        m_palpation->setPalpating(false);
        PALPATE_TRY_VERIFY(!m_reading.has_value());
        QVERIFY(!m_viewport->view().cursor().state().isPresent);
    }
    /// Deep near the ball's rim: the surface deflects the finger, with a message.
    void slidingOffIsSaid()
    {
        m_palpation->setPalpating(true);
        QCOMPARE(m_palpation->text(), QStringLiteral("presses 4.0 mm"));
        m_palpation->pressAt({300, 200});
        PALPATE_TRY_COMPARE(m_palpation->text(), QStringLiteral("pressing 4.0 mm"));
        QVERIFY(!m_palpation->isSlidOff() && !m_reading->isSlidOff);
        m_palpation->letGo();
        PALPATE_TRY_VERIFY(m_reading && m_reading->structure.isEmpty());
        double rim = 300.0;
        while (m_viewport->view().pick(m_viewport->rayAt({rim + 1.0, 200}))) {
            rim += 1.0;
        }
        m_palpation->stepDepth(52); // 30 mm
        m_palpation->pressAt({rim, 200});
        PALPATE_TRY_VERIFY(m_palpation->isSlidOff() && m_palpation->text().startsWith("pressing 30 mm, slid"));
        QVERIFY(m_reading->isSlidOff && m_reading->depth_mm < 12.0);
        m_palpation->letGo();
        QVERIFY(!m_palpation->isSlidOff());
    }
    /// A 6-axis mouse presses at the pointer with a fraction of the maximum press, and releases at rest.
    void aPuckPressesWithItsPush()
    {
        ui::HandSettings byEffort;
        byEffort.isByEffort = true;
        byEffort.effort_N = 4.0;
        m_palpation->setPress(byEffort);
        m_palpation->push(0.5); // palpation is off
        m_palpation->setPalpating(true);
        m_palpation->push(0.5); // no pointer position
        QTest::qWait(50);
        QVERIFY(!m_reading);
        m_palpation->moveTo({300, 200});
        for (const double share : {0.25, 1.0, 0.5}) {
            m_palpation->push(share);
            PALPATE_TRY_VERIFY2(m_reading && std::abs(m_reading->force_N - share * 4.0) < 0.05,
                                qPrintable(QString::number(m_reading ? m_reading->force_N : -1.0)));
        }
        m_palpation->push(0.0);
        PALPATE_TRY_VERIFY(m_reading && m_reading->structure.isEmpty());
        // The puck does not release a press by the pointer.
        m_palpation->pressAt({300, 200});
        m_palpation->push(0.0);
        PALPATE_TRY_VERIFY(m_reading && m_reading->force_N > 1.0);
    }
    void theDeepestPressIsSaid()
    {
        QSignalSpy said(m_palpation.get(), &ui::PalpationController::said);
        m_palpation->setPalpating(true);
        Q_EMIT m_viewport->depthTurned(40.0);
        QCOMPARE(said.count(), 0);
        Q_EMIT m_viewport->depthTurned(400.0);
        QCOMPARE(m_palpation->depth_mm(), 200.0); // the scene's size
        QCOMPARE(said.count(), 1);
        QCOMPARE(said.first().first().toString(),
                 QStringLiteral("200 mm is the maximum depth, limited by the size of the scene."));
        Q_EMIT m_viewport->depthTurned(-400.0);
        QCOMPARE(said.count(), 1); // zero depth gives no message
    }
    /// The hand is placed in the middle, moved, pressed and released without a pointer.
    void keysPressWithoutAPointer()
    {
        connect(m_palpation.get(), &ui::PalpationController::palpationWanted, this,
                [this] { m_palpation->setPalpating(true); });
        m_palpation->stepAlongScreen(1, 0);
        QVERIFY(m_palpation->isPalpating() && m_palpation->isByKeys());
        PALPATE_TRY_VERIFY(m_reading.has_value());
        const view::TouchState& shown = m_viewport->view().cursor().state();
        PALPATE_TRY_VERIFY(shown.isPresent && shown.hasCrosshair && std::abs(shown.p_WH.x()) > 1.0);
        // Seen from the front, 2 mm to the right is 2 mm to the patient's left.
        QVERIFY2(std::abs(shown.p_WH.x() - 2.0) < 0.2 && std::abs(shown.p_WH.z()) < 0.2,
                 qPrintable(QString::number(shown.p_WH.x())));
        m_palpation->stepAlongScreen(0, 2);
        PALPATE_TRY_VERIFY(std::abs(shown.p_WH.z() - 4.0) < 0.3);
        m_palpation->togglePress();
        PALPATE_TRY_VERIFY(m_reading && m_reading->depth_mm > 3.9);
        m_palpation->stepDepth(4);
        PALPATE_TRY_VERIFY(m_reading && m_reading->depth_mm > 5.8);
        QTest::qWait(300); // the approach is slow near its end
        // Turning the camera leaves a pressed hand in place; steps follow the new screen axes.
        const core::Vec3 before = shown.p_WH;
        view::turn(m_viewport->view().camera(), 15.0, 0.0);
        m_palpation->followCamera();
        Q_EMIT m_viewport->pointerMoved();
        QTest::qWait(100);
        QVERIFY((shown.p_WH - before).norm() < 0.01);
        m_palpation->stepAlongScreen(-1, 0);
        QTest::qWait(100);
        QVERIFY((shown.p_WH - before).norm() < 3.0 && shown.p_WH.x() < before.x() - 1.0);
        m_palpation->togglePress();
        PALPATE_TRY_VERIFY(m_reading && m_reading->structure.isEmpty());
        Q_EMIT m_viewport->pointerMoved();
        QVERIFY(!m_palpation->isByKeys());
    }
    void everyPressBeginsOutside()
    {
        m_palpation->setPalpating(true);
        for (int i = 0; i < 5; ++i) {
            m_palpation->pressAt({250.0 + 20.0 * i, 200.0});
            QTest::qSleep(200); // a slow frame, longer than the press ramp
            PALPATE_TRY_VERIFY(m_reading && m_reading->depth_mm > 3.0);
            m_palpation->letGo();
            PALPATE_TRY_VERIFY(m_reading && m_reading->structure.isEmpty());
        }
    }
    void theForceShownIsWhatTheHandGets()
    {
        /// Presses 4 mm deep with a force limit of 1 N, then repeats the same state for ever.
        struct Stuck final : palpate::device::HapticDevice
        {
            explicit Stuck(const std::atomic<bool>& isStuck)
                : m_isStuck(isStuck)
            {
            }
            palpate::device::DeviceInfo info() const override
            {
                auto info = palpate::device::deviceInfo(*palpate::device::findDevicePreset("omega"));
                info.maxForce_N = 1.0;
                return info;
            }
            palpate::core::Status start() override { return {}; }
            void stop() noexcept override {}
            palpate::device::DeviceState read(std::int64_t now_ns) noexcept override
            {
                if (!m_isStuck) {
                    m_state.p_D = {std::max(46.0, 60.0 - 0.01 * m_ticks++), 0.0, 0.0};
                    m_state.time_ns = now_ns;
                    m_state.isPresent = true;
                }
                return m_state;
            }
            void write(const palpate::core::Vec3& /*f_D*/) noexcept override {}

            const std::atomic<bool>& m_isStuck;
            palpate::device::DeviceState m_state;
            int m_ticks = 0;
        };
        std::atomic<bool> isStuck = false;
        QVERIFY(m_live->useDevice(std::make_unique<Stuck>(isStuck)).isOk());
        QVERIFY(m_live->start().isOk());
        // The model force is 2 N; the device output is half.
        PALPATE_TRY_VERIFY(m_reading && m_reading->depth_mm > 3.9);
        PALPATE_TRY_VERIFY2(std::abs(m_reading->force_N - 1.0) < 0.02, qPrintable(QString::number(m_reading->force_N)));
        isStuck = true;
        PALPATE_TRY_VERIFY2(m_reading && m_reading->force_N == 0.0, qPrintable(QString::number(m_reading->force_N)));
        QVERIFY(m_reading->depth_mm > 3.9);
        m_live->stop();
        QVERIFY(m_live->useDevice(nullptr).isOk());
    }

    void aChangeOfLayerIsRecorded()
    {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.path().toStdString() + "/touch.palpate";
        QVERIFY(m_live->startRecording(file).isOk());
        m_palpation->setPalpating(true);
        m_palpation->pressAt({300, 200});
        PALPATE_TRY_VERIFY(m_reading && m_reading->depth_mm > 3.9);
        m_model->setLayers({1}, QStringLiteral("Feel below"));
        QTest::qWait(300);
        QVERIFY(m_live->stopRecording().isOk());
        const auto reader = session::RecordingReader::open(file);
        QVERIFY(reader.isOk());
        const auto& events = reader.value()->events();
        const auto layer = std::find_if(events.begin(), events.end(), [](const auto& e) { return e.kind == "layer"; });
        QVERIFY(layer != events.end());
        QVERIFY2(layer->json.find("[0,1]") != std::string::npos, layer->json.c_str());
        QCOMPARE(reader.value()->scenes().back().structures.front().layer, 1u);
    }

    /// 12 mm deep over the phantom's larger lump: the reading contains liver and lump.
    void aLumpBelowTheSurfaceIsNamed()
    {
        /// Moves straight down to a position and stays there.
        struct Press final : palpate::device::HapticDevice
        {
            palpate::device::DeviceInfo info() const override
            {
                return palpate::device::deviceInfo(*palpate::device::findDevicePreset("omega"));
            }
            palpate::core::Status start() override { return {}; }
            void stop() noexcept override {}
            palpate::device::DeviceState read(std::int64_t now_ns) noexcept override
            {
                palpate::device::DeviceState state;
                m_above_mm = std::max(-12.0, m_above_mm - 0.02);
                state.p_D = top_W + m_above_mm * out_W;
                state.time_ns = now_ns;
                state.isPresent = true;
                return state;
            }
            void write(const palpate::core::Vec3& /*f_D*/) noexcept override {}

            palpate::core::Vec3 top_W, out_W;
            double m_above_mm = 3.0;
        };
        const auto scene = meshio::loadScene(PALPATE_PHANTOM);
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        std::vector<ui::StructureRow> rows;
        for (const meshio::LoadedStructure& loaded : scene.value().structures) {
            ui::StructureRow& row = rows.emplace_back();
            row.loaded = loaded;
            row.picture = view::makeSurface(*loaded.surface);
            if (loaded.description.palpable) {
                row.touch =
                    std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(*loaded.surface));
            }
        }
        auto device = std::make_unique<Press>();
        const core::Vec3 centre_W = rows[1].loaded.surface->report.bounds.center();
        double nearest_mm = 1e9;
        for (const core::Vec3& p_W : rows[0].loaded.surface->mesh.vertices) {
            if ((p_W - centre_W).norm() < nearest_mm) {
                nearest_mm = (p_W - centre_W).norm();
                device->top_W = p_W;
                device->out_W = (p_W - centre_W).normalized();
            }
        }
        m_model->setRows(std::move(rows));
        QVERIFY(m_live->useDevice(std::move(device)).isOk());
        QVERIFY(m_live->start().isOk());
        PALPATE_TRY_VERIFY(m_reading && m_reading->depth_mm > 11.9);
        PALPATE_TRY_COMPARE(m_reading->layers.size(), std::size_t{2});
        const std::vector<ui::LayerShare>& layers = m_reading->layers;
        QCOMPARE(m_reading->structure, QStringLiteral("liver"));
        QCOMPARE(layers[0].name, QStringLiteral("liver"));
        QCOMPARE(layers[1].name, QStringLiteral("lump 20 mm"));
        QCOMPARE(layers[1].colour, ui::colourOf(m_model->structure(1)));
        // The damper acts until the hand rests.
        PALPATE_TRY_VERIFY(std::abs(layers[0].force_N - 0.2 * layers[0].depth_mm) < 0.02);
        PALPATE_TRY_VERIFY(std::abs(layers[1].force_N - 0.6 * layers[1].depth_mm) < 0.02);
        QVERIFY(std::abs(layers[0].along_N + layers[1].along_N - m_reading->force_N) < 0.02);
        QVERIFY(m_reading->force_N > 1.3 * layers[0].force_N);
        QCOMPARE(m_reading->stiffness_N_per_mm, 0.8);
        const view::TouchState& shown = m_viewport->view().cursor().state();
        QCOMPARE(shown.innerCount, std::size_t{1});
        QVERIFY(std::abs((shown.inner[0].p_WG - centre_W).norm() - 10.0) < 0.5);
        m_live->stop();
        QVERIFY(m_live->useDevice(nullptr).isOk());
    }

    void recordsWhatWasFelt()
    {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.path().toStdString() + "/touch.palpate";
        QVERIFY(m_live->startRecording(file).isOk());
        m_palpation->setPalpating(true);
        m_palpation->pressAt({300, 200});
        PALPATE_TRY_VERIFY(m_reading && m_reading->depth_mm > 3.9);
        QTest::qWait(300);
        QVERIFY(m_live->stopRecording().isOk());
        const auto reader = session::RecordingReader::open(file);
        QVERIFY(reader.isOk());
        QVERIFY(reader.value()->extent().ticks > 300);
        QCOMPARE(reader.value()->scenes().front().structures.front().name, std::string("liver"));
        const auto last = reader.value()->at(reader.value()->extent().lastTick);
        QVERIFY(last.has_value());
        QVERIFY(std::abs(last->felt.f_W.norm() - 2.0) < 0.02);
    }

  private:
    std::unique_ptr<ui::StructureModel> m_model;
    std::unique_ptr<ui::LiveTouch> m_live;
    std::unique_ptr<ui::VtkViewport> m_viewport;
    std::unique_ptr<ui::PalpationController> m_palpation;
    std::optional<ui::TouchReading> m_reading;
};

PALPATE_TEST(Palpation)
#include "tst_Palpation.moc"
