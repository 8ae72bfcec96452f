// SPDX-License-Identifier: BSD-3-Clause
#include "window/MainWindow.h"

#include "compare/ComparisonPart.h"
#include "exercise/ExercisePart.h"
#include "inside/ImagePart.h"
#include "inside/PeekPart.h"
#include "inside/SectionPart.h"
#include "scene/CoordinatesPart.h"
#include "scene/DocumentPart.h"
#include "scene/LumpsPart.h"
#include "scene/RecentFiles.h"
#include "scene/SceneFiles.h"
#include "scene/StructuresPart.h"
#include "share/SharePart.h"
#include "shell/Docks.h"
#include "shell/HelpPart.h"
#include "shell/Language.h"
#include "shell/LegendPart.h"
#include "shell/MessagePlace.h"
#include "shell/Notices.h"
#include "shell/PicturePart.h"
#include "shell/ShowAround.h"
#include "shell/SoundChoice.h"
#include "shell/StatusProgress.h"
#include "shell/ViewPart.h"
#include "touch/DevicePart.h"
#include "touch/DistancesPart.h"
#include "touch/EngineeringPart.h"
#include "touch/FindingsPart.h"
#include "touch/FingertipPart.h"
#include "touch/MotionPart.h"
#include "touch/RecordingPart.h"
#include "touch/ReportPart.h"
#include "touch/ResultsPart.h"
#include "touch/TouchMapPart.h"
#include "touch/TouchPart.h"
#include "window/SceneChanges.h"
#include "window/ToolBar.h"

#include <palpate/device/PluginHost.h>
#include <palpate/ui/ChipRow.h>
#include <palpate/ui/HandControl.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/PanelScroll.h>
#include <palpate/ui/Pieces.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/Theme.h>
#include <palpate/ui/Tour.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>

#include <utility>

using namespace palpate;
using namespace palpate::app;
using namespace palpate::ui;

namespace {

constexpr auto kGeometryKey = "window/geometry";
constexpr auto kStateKey = "window/state";

} // namespace

MainWindow::MainWindow()
{
    setAcceptDrops(true);
    m_live.setLocksMemory(true);
    makeCentre();
    makeParts();
    makeMenus();
    addToolBar(makeToolBar(m_actions, *m_chips, this));
    makeStatusBar();
    connectParts();
    connectTour();
    showState();
    m_document->showTitle();
    QTimer::singleShot(0, m_document, &DocumentPart::offerLeftover);
    restoreLayout();
}

MainWindow::~MainWindow()
{
    // While the members are alive, which parts use and notify in their destructors.
    delete m_changes;
    while (!m_parts.empty()) {
        delete m_parts.back();
        m_parts.pop_back();
    }
}

/// Makes the view, the page shown without a scene, and the messages above them.
void MainWindow::makeCentre()
{
    m_viewport = new VtkViewport(this);
    m_welcome = new WelcomePage(this);
    m_pages = new QStackedWidget(this);
    m_pages->addWidget(new PanelScroll(m_welcome, this));
    m_pages->addWidget(m_viewport);
    m_notices = keep(new Notices(*this, m_actions, *m_viewport));
    auto* centre = new QWidget(this);
    auto* layout = new QGridLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new FocusFrame(m_pages, m_viewport, centre), 0, 0);
    layout->addWidget(&m_notices->bar(), 0, 0, Qt::AlignTop); // over the view, which keeps its place
    m_notices->bar().raise();
    new MessagePlace(m_notices->bar(), *m_viewport, *layout);
    setCentralWidget(centre);
}

/// Makes the parts, each after the parts that it uses, and puts their commands and panels in order.
void MainWindow::makeParts()
{
    statusBar()->addWidget(&m_notices->hint(), 1);
    auto* progress = new StatusProgress(*statusBar(), m_notices->hint(), this);
    m_chips = new ChipRow(this);
    m_recentMenu = new QMenu(tr("Open recent"), this);
    auto* recent = new RecentFiles(*m_recentMenu, *m_welcome, this);
    const WindowCore core{*this, m_actions, *m_chips, *m_viewport, m_model, m_live, *m_notices};
    m_docks = keep(new Docks(*this, m_actions));
    auto* structures = keep(new StructuresPart(core));
    m_document = keep(new DocumentPart(core, structures->maps(), *recent));
    m_touch = keep(new TouchPart(core, structures->panel()));
    auto* fingertip = keep(new FingertipPart(core));
    m_recording = keep(new RecordingPart(core, *m_document, *m_touch));
    m_device = keep(new DevicePart(core, *structures, *m_touch, *m_recording));
    auto* findings = keep(new FindingsPart(core, *m_document, *m_touch, *m_recording));
    auto* motion = keep(new MotionPart(core, m_recording->playback(), m_touch->palpation()));
    auto* results = keep(new ResultsPart(core, m_recording->playback()));
    auto* report = keep(new ReportPart(core, *m_document, m_recording->playback()));
    m_files = keep(new SceneFiles(core, *m_document, *progress, *m_welcome));
    m_coordinates = keep(new CoordinatesPart(core, *m_document, *m_files));
    auto* share = keep(new SharePart(core, *m_document, *m_files));
    auto* lumps = keep(new LumpsPart(core, {structures->maps(), structures->pointed(), m_files->loader(), *progress}));
    auto* touchMap = keep(new TouchMapPart(core, structures->maps(), m_recording->playback()));
    auto* legend = keep(new LegendPart(core));
    auto* comparison = keep(new ComparisonPart(core, m_recording->playback(), *touchMap));
    m_distances =
        keep(new DistancesPart(core, {*m_document, *m_touch, structures->maps(), structures->pointed(), *progress}));
    auto* engineering = keep(new EngineeringPart(core, m_touch->panel(), m_device->hand()));
    auto* picture = keep(new PicturePart(core));
    auto* section = keep(new SectionPart(core, m_document->document()));
    auto* image = keep(new ImagePart(core, *m_document, *m_files, *section));
    auto* peek = keep(new PeekPart(core, structures->panel(), m_touch->panel()));
    m_view = keep(new ViewPart(core, m_touch->panel()));
    m_help = keep(new HelpPart(core));
    auto* exercise = keep(new ExercisePart(core, *m_document, *m_touch, *m_recording)); // last: may disable commands
    m_changes = new SceneChanges(core, {*m_document, *m_files, *m_coordinates, *progress, *structures, *m_touch,
                                        *m_recording, *m_device, *exercise});
    connect(m_files, &SceneFiles::markupsWanted, findings, &FindingsPart::importFrom);
    connect(findings, &FindingsPart::placesChanged, &m_device->hand(), &HandControl::setFindings);

    // The order of the commands in each menu and on the key card.
    const Parts menuOrder{m_files,    m_document, picture,       report,      structures,  m_touch,  m_device,
                          share,      fingertip,  motion,        m_recording, findings,    exercise, results,
                          comparison, lumps,      m_distances,   touchMap,    legend,      section,  image,
                          peek,       m_view,     m_coordinates, m_notices,   engineering, m_docks,  m_help};
    for (WindowPart* part : menuOrder) {
        part->addActions();
    }
    // The order of the tabs, of the entries in the View menu and of F6.
    for (WindowPart* part : Parts{structures, m_touch, findings, m_device, m_recording, motion, engineering, lumps,
                                  m_distances, m_notices}) {
        part->addPanel(*m_docks);
    }
    recent->refresh();
}

void MainWindow::makeMenus()
{
    m_actions.addSubmenu(ActionGroup::View, tr("Appearance"), ActionGroup::Appearance);
    m_actions.addSubmenu(ActionGroup::View, tr("Text size"), ActionGroup::TextSize);
    m_actions.addSeparator(ActionGroup::File);
    connect(
        m_actions.add("quit", ActionGroup::File, tr("Quit"), tr("Quit Palpate"), {QKeySequence(Qt::CTRL | Qt::Key_Q)}),
        &QAction::triggered, this, &QWidget::close);
    QMenu* file = menuBar()->addMenu(tr("&File"));
    m_actions.fill(*file, ActionGroup::File);
    file->insertMenu(&m_actions.at("save"), m_recentMenu);
    m_actions.fill(*menuBar()->addMenu(tr("&Edit")), ActionGroup::Edit);
    QMenu* view = menuBar()->addMenu(tr("&View"));
    m_actions.fill(*view, ActionGroup::View);
    m_view->sound().watch(*view);
    m_docks->fill(*m_actions.submenuOf(*view, ActionGroup::Panels));
    addLanguageMenu(*view, *this, [this](const QString& line) { m_notices->say(line); });
    m_actions.fill(*menuBar()->addMenu(tr("&Session")), ActionGroup::Session);
    m_actions.fill(*menuBar()->addMenu(tr("&Help")), ActionGroup::Help);
}

void MainWindow::makeStatusBar()
{
    auto* notice = new QLabel(tr("Research, training and planning rehearsal. Not a medical device."), this);
    notice->setContentsMargins(8, 2, 10, 2);
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setContentsMargins(8, 0, 0, 0);
    statusBar()->addPermanentWidget(&m_coordinates->button());
    statusBar()->addPermanentWidget(notice);
}

void MainWindow::connectParts()
{
    connect(&m_looks, &Looks::textSizeChanged, m_docks, &Docks::scale);
    for (QAction* action : m_actions.all()) {
        connect(action, &QAction::triggered, m_recording, &RecordingPart::acknowledge);
    }
    for (WindowPart* part : m_parts) {
        connect(part, &WindowPart::stateChanged, this, &MainWindow::showState);
    }
    connect(m_changes, &SceneChanges::stateChanged, this, &MainWindow::showState);
    connect(m_changes, &SceneChanges::viewChanged, this, &MainWindow::showPage);
    connect(m_changes, &SceneChanges::ready, this, &MainWindow::ready);
    connect(m_recording, &RecordingPart::shownAlone, this, [this] {
        showPage(true);
        Q_EMIT ready();
    });
    connect(m_recording, &RecordingPart::meshesFound, this, [this](const auto& files) { m_files->open(files); });
    connect(m_files, &SceneFiles::recordingWanted, m_recording, &RecordingPart::open);
    connect(m_files, &SceneFiles::openFailed, this, &MainWindow::openFailed);
    connect(m_recording, &RecordingPart::openFailed, this, &MainWindow::openFailed);
    connect(m_device, &DevicePart::refused, this, &MainWindow::deviceRefused);
    connect(this, &MainWindow::ready, m_device, &DevicePart::chooseWaiting);
    connect(m_touch, &TouchPart::letGoWanted, this, [this] {
        if (!m_help->closeOverlay() && !m_distances->cancelTape()) {
            m_touch->letGo();
        }
    });
}

void MainWindow::connectTour()
{
    ShowAround* around = &m_help->showAround();
    connect(around, &ShowAround::wanted, this,
            [this, around] { around->begin(m_pages->currentWidget() == m_viewport, m_files->loader().isBusy()); });
    connect(around, &ShowAround::phantomWanted, m_welcome, &WelcomePage::phantomWanted);
    connect(this, &MainWindow::ready, around, &ShowAround::goOn);
    connect(this, &MainWindow::openFailed, around, &ShowAround::giveUp);
    connect(&m_files->loader(), &SceneLoader::cancelled, around, &ShowAround::giveUp);
}

/// Sets the order of F6, and the layout as the user left it.
void MainWindow::restoreLayout()
{
    m_docks->addToRound(findChild<QWidget*>(QStringLiteral("tools")));
    m_docks->addToRound(&m_notices->bar());
    m_docks->addToRound(m_viewport);
    m_docks->addPanelsToRound();
    m_docks->addToRound(&m_help->showAround().tour());
    const QSize room = screen()->availableSize() - QSize(16, 40); // size of the window frame
    resize(QSize(1280, 800).boundedTo(room));
    m_docks->fit(withText_px(264), withText_px(292), withText_px(152));
    const QSettings settings;
    restoreGeometry(settings.value(QLatin1String(kGeometryKey)).toByteArray());
    restoreState(settings.value(QLatin1String(kStateKey)).toByteArray());
}

void MainWindow::showState()
{
    const WindowState state = m_recording->windowState();
    for (WindowPart* part : m_parts) {
        part->showState(state);
    }
}

void MainWindow::showPage(bool isView)
{
    m_pages->setCurrentIndex(isView ? 1 : 0);
    if (isView) {
        // Drop the minimum size of the welcome page, or a message above the view would enlarge the window.
        m_pages->setMinimumSize(1, 1);
    }
}

void MainWindow::open(const std::vector<std::filesystem::path>& files, const meshio::ReadOptions& options)
{
    m_files->open(files, options);
}

PalpationController& MainWindow::palpation() noexcept
{
    return m_touch->palpation();
}

Playback& MainWindow::playback() noexcept
{
    return m_recording->playback();
}

void MainWindow::setPalpating(bool isPalpating)
{
    m_touch->setPalpating(isPalpating);
}

void MainWindow::setPlugins(std::unique_ptr<device::PluginHost> plugins)
{
    m_device->setPlugins(std::move(plugins));
}

void MainWindow::chooseDevice(const std::string& id)
{
    m_device->choose(id);
}

void MainWindow::useCpu(int cpu)
{
    m_device->hand().useCpu(cpu);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (event->mimeData()->hasUrls()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event)
{
    const std::vector<std::filesystem::path> files = SceneFiles::filesIn(*event->mimeData());
    if (!files.empty()) {
        event->acceptProposedAction();
        m_files->drop(files);
    }
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_recording->mayEnd() || !m_document->confirmDiscard()) {
        event->ignore();
        return;
    }
    QSettings settings;
    settings.setValue(QLatin1String(kGeometryKey), saveGeometry());
    settings.setValue(QLatin1String(kStateKey), saveState());
    m_live.stop();
    event->accept();
}

#include "moc_MainWindow.cpp"
