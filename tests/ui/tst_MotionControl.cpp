// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Motions.h"
#include "Rows.h"
#include "TestRunner.h"

#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/MotionControl.h>
#include <palpate/ui/MotionPanel.h>

#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QSlider>
#include <QToolButton>

#include <memory>

using namespace palpate;
using core::Vec3;
using geometry::SurfaceMotion;

/// The controls of moving tissue, with a running servo loop.
class MotionControl : public QObject
{
    Q_OBJECT

    std::unique_ptr<ui::StructureModel> m_model;
    std::unique_ptr<ui::LiveTouch> m_live;
    std::unique_ptr<ui::MotionControl> m_control;

    [[nodiscard]] const std::shared_ptr<const SurfaceMotion>& motion(std::size_t row) const
    {
        return m_model->rows()[row].loaded.motion;
    }
    /// Waits until the newest tick is after a time.
    void waitFor(double time_s)
    {
        servo::TickRecord tick;
        PALPATE_TRY_VERIFY((static_cast<void>(m_live->fetch(tick)), m_live->time_s() > time_s));
    }

  private Q_SLOTS:
    void init()
    {
        m_model = std::make_unique<ui::StructureModel>();
        m_live = std::make_unique<ui::LiveTouch>(*m_model);
        m_control = std::make_unique<ui::MotionControl>(*m_model, *m_live);
        geometry::Breath breath;
        breath.amplitude_mm = Vec3(0, 0, 15);
        const auto breathes = SurfaceMotion::breath(breath, {Vec3::Constant(-50), Vec3::Constant(50)}).value();
        std::vector<ui::StructureRow> rows = test::twoRows();
        rows.push_back(test::row("tool", test::ball(5.0, 2, Vec3(80, 0, 0))));
        rows[0].loaded.motion = SurfaceMotion::pulse(0.8, 0.1, breathes).value();
        rows[1].loaded.motion = rows[0].loaded.motion;
        rows[2].loaded.motion = test::oscillation({0, 0, 5}, 0.5);
        m_model->setRows(std::move(rows));
        QVERIFY(m_live->start().isOk());
    }
    void cleanup()
    {
        m_control.reset();
        m_live.reset();
        m_model.reset();
    }

    void heldBreathKeepsPulsesAndPoses()
    {
        QVERIFY(m_control->hasMotion() && m_control->hasBreath());
        waitFor(0.2);
        const auto before = motion(0);
        ui::MotionSettings settings;
        settings.isHeld = true;
        m_control->set(settings);
        QVERIFY(motion(0) == motion(1)); // still share a layer
        QVERIFY((motion(0)->pace() == SurfaceMotion::Pace{0.0, 1.0, 1.0}));
        QVERIFY((motion(2)->pace() == SurfaceMotion::Pace{1.0, 1.0, 1.0}));
        const double settled_s = motion(0)->settled_s(), start_s = settled_s - ui::MotionControl::kEase_s;
        // As before until the change begins, which is not yet.
        const Vec3 X(0, 0, 50);
        QVERIFY(start_s > m_live->time_s());
        QVERIFY((motion(0)->toWorld(motion(0)->at(start_s), X) - before->toWorld(before->at(start_s), X)).norm() <
                1e-9);
        // The hand gets the same motion in time.
        PALPATE_TRY_VERIFY(m_live->scene()->structures()[0].motion == motion(0));
        waitFor(settled_s);
        QVERIFY(motion(0)->toWorld(motion(0)->at(settled_s), X) ==
                motion(0)->toWorld(motion(0)->at(settled_s + 9.0), X));
        QVERIFY(motion(0)->at(settled_s + 0.1).factor != motion(0)->at(settled_s + 0.5).factor);
    }

    void pauseStopsEverything()
    {
        ui::MotionSettings settings;
        settings.isPlaying = false;
        settings.amplitude = 0.5;
        m_control->set(settings);
        QVERIFY((motion(0)->pace() == SurfaceMotion::Pace{0.0, 0.0, 0.5}));
        QVERIFY((motion(2)->pace() == SurfaceMotion::Pace{0.0, 0.0, 1.0})); // the amplitude is of breaths
        QVERIFY(m_model->undoStack().count() == 0);
    }

    /// A change during another one is not lost and does not cut it short.
    void changesFollowEachOther()
    {
        ui::MotionSettings settings;
        settings.amplitude = 0.2;
        m_control->set(settings);
        const auto first = motion(0);
        settings.amplitude = 0.6;
        m_control->set(settings);
        settings.amplitude = 0.9;
        m_control->set(settings);
        QVERIFY(motion(0) == first);
        PALPATE_TRY_COMPARE(motion(0)->pace().amplitude, 0.9);
        QVERIFY(motion(0)->settled_s() >= first->settled_s() + ui::MotionControl::kEase_s);
    }

    /// A loop that starts again counts from 0: tissue goes on from where it was.
    void tissueStaysWhenTheLoopRestarts()
    {
        ui::MotionSettings settings;
        settings.isHeld = true;
        m_control->set(settings);
        waitFor(motion(0)->settled_s());
        const Vec3 X(0, 0, 50);
        const Vec3 held = motion(0)->toWorld(motion(0)->at(m_live->time_s()), X);
        QVERIFY(m_live->setLoop(2000.0, -1).isOk());
        QCOMPARE(m_live->time_s(), 0.0);
        QVERIFY((motion(0)->toWorld(motion(0)->at(0.0), X) - held).norm() < 1e-9);
        QVERIFY((motion(0)->toWorld(motion(0)->at(5.0), X) - held).norm() < 1e-9);
    }

    void newSceneStartsAfresh()
    {
        ui::MotionSettings settings;
        settings.rate = 2.0;
        m_control->set(settings);
        QSignalSpy changed(m_control.get(), &ui::MotionControl::changed);
        m_model->setRows(test::twoRows());
        QCOMPARE(changed.count(), 1);
        QVERIFY(m_control->settings() == ui::MotionSettings() && !m_control->hasMotion());
    }

    void panelShowsAndSets()
    {
        ui::MotionPanel panel;
        ui::MotionSettings chosen;
        int count = 0;
        connect(&panel, &ui::MotionPanel::chosen, this, [&](const ui::MotionSettings& settings) {
            chosen = settings;
            ++count;
        });
        panel.show({true, true, 1.5, 0.4}, true);
        QCOMPARE(count, 0);
        QCOMPARE(panel.findChild<QDoubleSpinBox*>()->value(), 1.5);
        QCOMPARE(panel.findChild<QSlider*>()->value(), 40);
        const auto buttons = panel.findChildren<QToolButton*>();
        QVERIFY(buttons.size() == 2 && buttons[1]->isChecked());
        buttons[0]->click();
        QVERIFY((chosen == ui::MotionSettings{false, true, 1.5, 0.4}));
        panel.show(chosen, true);
        buttons[1]->click();
        QVERIFY((chosen == ui::MotionSettings{false, false, 1.5, 0.4}));
        panel.findChild<QSlider*>()->setValue(75);
        QCOMPARE(chosen.amplitude, 0.75);
        QCOMPARE(count, 3);
        panel.show({}, false); // only poses
        QVERIFY(!buttons[1]->isEnabled() && !panel.findChild<QSlider*>()->isEnabled() && buttons[0]->isEnabled());
    }
};

PALPATE_TEST(MotionControl)
#include "tst_MotionControl.moc"
