// SPDX-License-Identifier: BSD-3-Clause
// Window-wide features: messages, engineering panel, focus order of panels, window size.
#include "window/MainWindow.h"

#include <palpate/ui/MessageList.h>
#include <palpate/ui/PanelScroll.h>
#include <palpate/ui/Tour.h>
#include <palpate/ui/TypeAhead.h>
#include <palpate/ui/ViewVoice.h>

#include <QDockWidget>
#include <QLocale>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QTimer>

#include <algorithm>

using namespace palpate;
using namespace palpate::ui;

void MainWindow::makeShellActions()
{
    const auto add = [this](const char* id, ActionGroup group, const QString& text, const QString& tip,
                            const QKeySequence& key, auto act) {
        connect(m_actions.add(id, group, text, tip, {key}), &QAction::triggered, this, act);
    };
    add("next-panel", ActionGroup::View, tr("Next panel"), tr("The keys go to the next panel, and on to the view"),
        Qt::Key_F6, [this] { m_round.go(1); });
    add("previous-panel", ActionGroup::View, tr("Previous panel"), tr("The keys go to the panel before"),
        Qt::SHIFT | Qt::Key_F6, [this] { m_round.go(-1); });
    add("panels", ActionGroup::View, tr("Hide or show all panels"), tr("Hide or show all panels"), Qt::Key_F9,
        &MainWindow::togglePanels);
    add("messages", ActionGroup::View, tr("Messages"),
        tr("Show or hide the list of all messages since the start, with all notes on files"), Qt::Key_F4,
        &MainWindow::showMessages);
    m_engineeringAction = m_actions.add("engineering", ActionGroup::View, tr("Engineering"),
                                        tr("Show or hide solver, servo loop and device in numbers"));
    m_engineeringAction->setCheckable(true);
    m_actions.addSeparator(ActionGroup::View);
    m_actions.addSeparator(ActionGroup::Edit);
    QAction* letters = m_actions.add("letter-keys", ActionGroup::Edit, tr("Single-letter keys"),
                                     tr("Commands by one letter; off: letters do nothing, for speech input and for "
                                        "hands that touch keys by chance"));
    letters->setCheckable(true);
    connect(letters, &QAction::toggled, this, [this](bool isOn) {
        m_actions.setLetterKeys(isOn);
        QSettings().setValue(QStringLiteral("keys/letters"), isOn);
    });
    new TypeAhead(this);
}

void MainWindow::makeMessagesDock()
{
    m_messagesDock = new QDockWidget(tr("Messages"), this);
    m_messagesDock->setObjectName(QStringLiteral("messages"));
    m_messagesDock->setWidget(new MessageList(m_messages, this));
    addDockWidget(Qt::BottomDockWidgetArea, m_messagesDock);
    m_messagesDock->hide();
    connect(m_message, &MessageBar::listWanted, this, &MainWindow::showMessages);
    connect(m_hint, &HintLine::pressed, this, &MainWindow::showMessages);
}

void MainWindow::makeEngineeringDock()
{
    m_engineering = new EngineeringPanel(this);
    m_engineeringDock = new QDockWidget(tr("Engineering"), this);
    m_engineeringDock->setObjectName(QStringLiteral("engineering"));
    m_engineeringDock->setWidget(new PanelScroll(m_engineering, this));
    addDockWidget(Qt::LeftDockWidgetArea, m_engineeringDock);
    m_engineeringDock->hide();
    connect(m_engineeringDock->toggleViewAction(), &QAction::toggled, m_engineeringAction, &QAction::setChecked);
    connect(m_engineeringAction, &QAction::triggered, this, &MainWindow::showEngineering);
    connect(m_runningChip, &Chip::clicked, this, [this] { showEngineering(true); });
}

void MainWindow::showEngineering(bool isShown)
{
    m_engineeringDock->setVisible(isShown);
    if (isShown) {
        if (dockWidgetArea(m_engineeringDock) == Qt::LeftDockWidgetArea && !m_engineeringDock->isFloating()) {
            // Only once visible: tabified while hidden, the dock would leave a tab bar with a single tab.
            tabifyDockWidget(m_docks.front(), m_engineeringDock);
        }
        m_engineeringDock->raise();
        showStatus();
    }
}

void MainWindow::finishShell()
{
    m_actions.find(QStringLiteral("letter-keys"))
        ->setChecked(QSettings().value(QStringLiteral("keys/letters"), true).toBool());
    m_round.add(findChild<QWidget*>(QStringLiteral("tools")));
    m_round.add(m_message);
    m_round.add(m_viewport);
    for (QDockWidget* dock : m_docks) {
        m_round.add(dock->widget());
    }
    m_round.add(m_engineeringDock->widget());
    m_round.add(m_feltDock->widget());
    m_round.add(m_messagesDock->widget());
    m_round.add(&m_around->tour());
    new ViewVoice(*m_viewport, *m_touch, this);
    connect(m_around, &app::ShowAround::wanted, this,
            [this] { m_around->begin(m_stack->currentWidget() == m_viewport, m_loader.isBusy()); });
    connect(m_around, &app::ShowAround::phantomWanted, m_welcome, &WelcomePage::phantomWanted);
    connect(this, &MainWindow::ready, m_around, &app::ShowAround::goOn);
    connect(this, &MainWindow::openFailed, m_around, &app::ShowAround::giveUp);
    connect(&m_loader, &SceneLoader::cancelled, m_around, &app::ShowAround::giveUp);
    const QSize room = screen()->availableSize() - QSize(16, 40); // size of the window frame
    resize(QSize(1280, 800).boundedTo(room));
}

void MainWindow::showMessages()
{
    const bool isShown = !m_messagesDock->isVisible();
    m_messagesDock->setVisible(isShown);
    if (isShown) {
        m_messagesDock->raise();
        m_messagesDock->widget()->setFocus(Qt::ShortcutFocusReason);
    } else {
        m_viewport->setFocus();
    }
}

void MainWindow::say(const QString& text, int forget_ms)
{
    m_messages.add(Messages::Kind::Told, text);
    m_hint->say(text);
    QTimer::singleShot(forget_ms, this, [this, text] {
        if (m_hint->said() == text) {
            m_hint->say({});
        }
    });
}

void MainWindow::showError(const QString& line)
{
    m_message->showError(line);
}

/// Adds notes from opening to the list of messages. @return the number of notes
int MainWindow::listNotes(const OpenedScene& scene)
{
    for (const QString& note : scene.warnings) {
        m_messages.add(Messages::Kind::Warning, note);
    }
    for (int row = 0; row < m_model.rowCount(); ++row) {
        const QStringList details = m_model.findings(row);
        if (!details.isEmpty()) {
            m_messages.add(Messages::Kind::Warning, tr("%1: %2 (%3)")
                                                        .arg(readableName(m_model.structure(row).name),
                                                             m_model.defects(row).join(QStringLiteral("; ")),
                                                             details.join(QStringLiteral("; "))));
        }
    }
    return static_cast<int>(scene.warnings.size());
}

/// Lists warnings, once per change, about settings that keep the servo thread from real-time operation, with remedies.
void MainWindow::listRealtimeWarnings(const servo::RealtimeReport& report)
{
    if (report.isRealtime) {
        m_realtimeWarnings.clear();
        return;
    }
    QStringList lines;
    for (const servo::RealtimeItem& item : report.items) {
        if (!item.isGranted && !item.remedy.empty()) {
            lines << tr("Forces may stutter: %1: %2. %3")
                         .arg(ui::translated(item.name), ui::translated(item.message),
                              QString::fromStdString(item.remedy));
        }
    }
    if (lines != m_realtimeWarnings) {
        m_realtimeWarnings = lines;
        for (const QString& line : lines) {
            m_messages.add(Messages::Kind::Warning, line);
        }
    }
}

/// State of pointer or device.
QString MainWindow::handText() const
{
    if (!m_live.usesPointer()) {
        return tr("Touching with the %1").arg(deviceName(m_live.deviceInfo()));
    }
    if (m_palpation == nullptr || !m_palpation->isPalpating()) {
        return tr("Turning the view");
    }
    return m_palpation->text();
}
