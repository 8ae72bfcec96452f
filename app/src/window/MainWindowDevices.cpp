// SPDX-License-Identifier: BSD-3-Clause
// Device selection in the window.
#include "window/MainWindow.h"

#include <palpate/ui/EngineTexts.h>

#include <QMenu>
#include <QMenuBar>

using namespace palpate;
using namespace palpate::ui;

void MainWindow::setPlugins(std::unique_ptr<device::PluginHost> plugins)
{
    m_devices->setPlugins(std::move(plugins));
    auto* menu = new QMenu(tr("&Device"), this);
    menuBar()->insertMenu(menuBar()->actions().constLast(), menu); // before the Help menu
    m_devices->fill(*menu);
    menu->addSeparator();
    for (QAction* action : {m_fitSceneAction, m_fitOrganAction, m_fitLumpAction}) {
        menu->addAction(action);
    }
    connect(m_devices, &DeviceChoice::refused, this, &MainWindow::showError);
    connect(m_devices, &DeviceChoice::pushed, m_palpation, &PalpationController::push);
    connect(m_devices, &DeviceChoice::pressingWanted, this, [this] {
        m_effortAction->setChecked(true);
        say(tr("The pointer says where, the SpaceMouse how hard: push its puck down. P palpate, wheel for the hardest "
               "press"),
            60000);
    });
    connect(m_devices, &DeviceChoice::changed, this, [this] {
        m_structures->setGreatest(m_live.maxTissue(), m_live.limitText());
        showWhatPlays();
        showStatus();
        say(howToTouch(), 60000);
    });
}

QString MainWindow::howToTouch() const
{
    if (!m_live.usesPointer()) {
        return tr("Touch with the device; O or L zooms its space to the organ or lump, C lifts the hand");
    }
    return m_hand->settings().isByEffort ? tr("P palpate, hold to press harder, wheel for the hardest press")
                                         : tr("P palpate, drag to press, wheel for depth");
}

void MainWindow::useCpu(int cpu)
{
    m_handControl->useCpu(cpu);
}

void MainWindow::chooseDevice(const std::string& id)
{
    // Choose the device once all is loaded: the simulated hand needs a scene, and the playback device an open
    // recording.
    const auto take = [this, id] {
        if (const core::Status status = m_devices->choose(id); !status.isOk()) {
            showError(ui::engineText(status));
            Q_EMIT deviceRefused(ui::engineText(status));
        }
    };
    if (m_model.rowCount() > 0) {
        take();
    } else {
        connect(this, &MainWindow::ready, this, take, Qt::SingleShotConnection);
    }
}

void MainWindow::tellFault(const QString& line)
{
    if (m_live.usesPointer()) {
        say(line);
        return;
    }
    m_message->offer(line, tr("Feel again"), [this] { m_live.rearm(); });
}
