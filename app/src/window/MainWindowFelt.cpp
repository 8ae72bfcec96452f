// SPDX-License-Identifier: BSD-3-Clause
// Palpability of lumps through an organ: map colours, table beside the session panel, progress and messages.
#include "window/MainWindow.h"

#include <palpate/ui/PanelScroll.h>

#include <QDockWidget>
#include <QProgressBar>
#include <QToolButton>

#include <algorithm>

using namespace palpate;
using namespace palpate::ui;

void MainWindow::makeFelt()
{
    auto* lumps = new LumpMaps(m_model, this);
    m_felt = new FeltOverlay(*m_viewport, m_model, *lumps, *m_maps, this);
    m_feltDock = new QDockWidget(tr("What can be felt"), this);
    m_feltDock->setObjectName(QStringLiteral("felt"));
    m_feltDock->setWidget(new PanelScroll(new FeltPanel(*m_felt, m_model, this), this));
    addDockWidget(Qt::BottomDockWidgetArea, m_feltDock);
    m_feltDock->hide();
    connect(m_feltAction, &QAction::toggled, this, &MainWindow::showFelt);
    connect(m_feltDock->toggleViewAction(), &QAction::toggled, m_felt, &FeltOverlay::setTabled);
    connect(m_cancel, &QToolButton::clicked, lumps, &LumpMaps::cancel);
    connect(lumps, &LumpMaps::progressed, this, [this](const QString& what, double share) {
        m_hint->setText(what);
        m_progress->setRange(0, 1000);
        m_progress->setValue(static_cast<int>(share * 1000.0));
        m_progress->show();
        m_cancel->show();
    });
    connect(lumps, &LumpMaps::ended, this, [this] {
        if (!m_loader.isBusy() && m_progress->isVisible()) {
            m_progress->hide();
            m_cancel->hide();
            m_hint->say({});
        }
    });
    connect(lumps, &LumpMaps::cancelled, this, [this](const QString& line) {
        m_feltAction->setChecked(false);
        say(line);
    });
    connect(lumps, &LumpMaps::noted, this, [this](const QStringList& lines) {
        for (const QString& line : lines) {
            m_messages.add(Messages::Kind::Warning, line);
        }
        m_hint->say(lines.front());
    });
}

void MainWindow::showFelt(bool isShown)
{
    m_felt->setShown(isShown);
    m_feltDock->setVisible(isShown);
    if (isShown) {
        if (dockWidgetArea(m_feltDock) == Qt::BottomDockWidgetArea && !m_feltDock->isFloating()) {
            // Only once visible: tabified while hidden, the dock would leave a tab bar with a single tab.
            tabifyDockWidget(m_docks.back(), m_feltDock);
        }
        m_feltDock->raise();
        constexpr int kHeight_px = 200; // two lumps and the details of one
        resizeDocks({m_feltDock}, {std::max(kHeight_px, m_feltDock->height())}, Qt::Vertical);
    }
}
