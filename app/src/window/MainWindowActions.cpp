// SPDX-License-Identifier: BSD-3-Clause
// Commands of the window. Menus and the list of keys are built from these.
#include "shell/Help.h"
#include "shell/Language.h"
#include "touch/FingertipMenu.h"
#include "window/MainWindow.h"

#include <palpate/ui/ViewKeys.h>

#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>

using namespace palpate;
using namespace palpate::ui;

namespace {

constexpr auto kDent = "view/dent"; // settings key

} // namespace

void MainWindow::makeActions()
{
    makeFileAndEditActions();
    makeViewActions();
    makeShellActions();
    makeSessionActions();
    makeDeviceAndHelpActions();
}

void MainWindow::makeFileAndEditActions()
{
    m_openAction = m_actions.add("open", ActionGroup::File, tr("Open…"), tr("Open meshes, a scene or a recording"),
                                 {QKeySequence(Qt::CTRL | Qt::Key_O)}, Symbol::Open);
    m_addAction = m_actions.add("add", ActionGroup::File, tr("Add to the scene…"),
                                tr("Open more meshes or a scene beside what is open"),
                                {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O)});
    m_closeAction = m_actions.add("close", ActionGroup::File, tr("Close the scene"), tr("Close what is open"),
                                  {QKeySequence(Qt::CTRL | Qt::Key_W)});
    m_saveAction = m_actions.add("save", ActionGroup::File, tr("Save scene"), tr("Save the scene with its tissue"),
                                 {QKeySequence(Qt::CTRL | Qt::Key_S)});
    // Not QKeySequence::SaveAs, which is empty without a platform theme.
    m_saveAsAction = m_actions.add("save-as", ActionGroup::File, tr("Save scene as…"),
                                   tr("Save the scene with its tissue to another file"),
                                   {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)});
    m_snapshotAction = m_actions.add("snapshot", ActionGroup::File, tr("Snapshot"), tr("Save a picture of the view"),
                                     {QKeySequence(Qt::Key_S)}, Symbol::Snapshot);
    m_importFindingsAction = m_actions.add("import-findings", ActionGroup::File, tr("Import findings…"),
                                           tr("Take the points of a 3D Slicer markups file (.mrk.json) as findings"));
    m_exportFindingsAction =
        m_actions.add("export-findings", ActionGroup::File, tr("Export findings…"),
                      tr("Write findings and notes as a table (CSV) or as 3D Slicer markups (.mrk.json)"));
    m_actions.addSeparator(ActionGroup::File);
    connect(
        m_actions.add("quit", ActionGroup::File, tr("Quit"), tr("End Palpate"), {QKeySequence(Qt::CTRL | Qt::Key_Q)}),
        &QAction::triggered, this, &QWidget::close);
    m_undoAction = m_actions.add("undo", ActionGroup::Edit, tr("Undo"), tr("Undo the newest change"),
                                 {QKeySequence(Qt::CTRL | Qt::Key_Z)}, Symbol::Undo);
    m_redoAction = m_actions.add("redo", ActionGroup::Edit, tr("Redo"), tr("Do it again"),
                                 {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)},
                                 Symbol::Redo);
    m_actions.addSeparator(ActionGroup::Edit);
    m_filterAction =
        m_actions.add("filter", ActionGroup::Edit, tr("Find a structure…"),
                      tr("List only structures with these words in their names"), {QKeySequence(Qt::CTRL | Qt::Key_F)});
    // F2 and Del are handled by the focused list: see ActionGroup::InList.
    m_renameAction = m_actions.add("rename", ActionGroup::Edit, tr("Rename the structure…"),
                                   tr("Write another name for the selected structure"));
    m_removeAction = m_actions.add("remove", ActionGroup::Edit, tr("Remove from the scene"),
                                   tr("Take the selected structures out of the scene; their files stay"));
}

void MainWindow::makeViewActions()
{
    m_fitAction = m_actions.add("fit", ActionGroup::View, tr("Fit"), tr("Fit everything into the view"),
                                {QKeySequence(Qt::Key_F)}, Symbol::Fit);
    m_showFindingsAction =
        m_actions.add("show-findings", ActionGroup::View, tr("Findings"), tr("Show the places marked as findings"));
    m_showFindingsAction->setCheckable(true);
    m_showFindingsAction->setChecked(true);
    m_showFindingsAction->setEnabled(false);
    m_feltAction = m_actions.add("felt", ActionGroup::View, tr("What can be felt here"),
                                 tr("Colour organs by how much of the lumps below a hand feels, with a table"),
                                 {QKeySequence(Qt::Key_B)});
    m_feltAction->setCheckable(true);
    m_feltAction->setEnabled(false);
    QAction* dent = m_actions.add("dent", ActionGroup::View, tr("Dent under the finger"),
                                  tr("Draw soft tissue bent where it is pressed, with a fine grid on it"));
    dent->setCheckable(true);
    dent->setChecked(QSettings().value(kDent, true).toBool());
    m_viewport->view().setBending(dent->isChecked());
    connect(dent, &QAction::toggled, this, [this](bool isOn) {
        m_viewport->view().setBending(isOn);
        m_viewport->update();
        QSettings().setValue(kDent, isOn);
    });
    m_sound = new palpate::app::SoundChoice(m_actions, this);
    connect(m_sound, &palpate::app::SoundChoice::said, this, [this](const QString& line) { say(line); });
    m_actions.addSeparator(ActionGroup::View);
    const auto addView = [this](const char* id, const QString& text, const QKeySequence& key, view::ViewFrom from) {
        connect(m_actions.add(id, ActionGroup::View, text, text, {key}), &QAction::triggered, this, [this, from] {
            m_viewport->view().look(from);
            m_viewport->update();
        });
    };
    addView("view-front", tr("From the front (A)"), Qt::Key_1, view::ViewFrom::Front);
    addView("view-back", tr("From the back (P)"), Qt::CTRL | Qt::Key_1, view::ViewFrom::Back);
    addView("view-left", tr("From the left (L)"), Qt::Key_3, view::ViewFrom::Left);
    addView("view-right", tr("From the right (R)"), Qt::CTRL | Qt::Key_3, view::ViewFrom::Right);
    addView("view-head", tr("From the head (S)"), Qt::Key_7, view::ViewFrom::Head);
    addView("view-feet", tr("From the feet (I)"), Qt::CTRL | Qt::Key_7, view::ViewFrom::Feet);
    addView("view-oblique", tr("Oblique"), Qt::Key_0, view::ViewFrom::Oblique);
    m_actions.addSeparator(ActionGroup::View);
    m_coordinates = new CoordinatesChoice(m_actions, this);
    m_actions.addSeparator(ActionGroup::View);
    m_actions.addGesture(ActionGroup::InView, tr("hold Space"), tr("palpate while it is held"));
    m_actions.addGesture(ActionGroup::InView, tr("drag"), tr("camera: rotate · palpate: press and slide"));
    m_actions.addGesture(ActionGroup::InView, tr("click"), tr("camera: select the structure (with Ctrl: one more)"));
    m_actions.addGesture(ActionGroup::InView, tr("right drag"), tr("camera: zoom · palpate: rotate"));
    m_actions.addGesture(ActionGroup::InView, tr("middle drag"), tr("pan"));
    m_actions.addGesture(ActionGroup::InView, tr("wheel"),
                         tr("camera: zoom · palpate: depth in mm, or effort in N (with Ctrl: zoom)"));
    m_actions.addGesture(ActionGroup::InView, tr("double-click"), tr("centre the view on the point"));
    ViewKeys::describe(m_actions);
    connect(m_actions.add("let-go", ActionGroup::InView, tr("Let go"), tr("let go, then back to the camera"),
                          {QKeySequence(Qt::Key_Escape)}),
            &QAction::triggered, this, &MainWindow::letGo);
    m_actions.addGesture(ActionGroup::InList, tr("Ctrl+E  Ctrl+H"), tr("show or hide, feel or not"));
    m_actions.addGesture(ActionGroup::InList, tr("letters"), tr("go to the structure that begins so"));
    m_actions.addGesture(ActionGroup::InList, tr("F2  Del"), tr("rename, remove from the scene"));
    m_actions.addGesture(ActionGroup::InList, tr("Ctrl+↓  ↑"), tr("felt a layer deeper, farther out"));
    m_actions.addGesture(ActionGroup::InView, tr("Enter  F2  Del"), tr("in the findings: go there, edit, delete"));
    m_actions.addGesture(ActionGroup::InView, tr("Shift+Enter"), tr("in the findings: play where it was marked"));
}

void MainWindow::makeSessionActions()
{
    m_palpateAction = m_actions.add(
        "palpate", ActionGroup::Session, tr("Palpate"),
        tr("Palpate with the pointer: drag to press, wheel for depth or effort; off: the pointer moves the camera"),
        {QKeySequence(Qt::Key_P)}, Symbol::Hand);
    m_palpateAction->setCheckable(true);
    m_effortAction = m_actions.add("effort", ActionGroup::Session, tr("Press by effort"),
                                   tr("Effort in, depth out: the force rises while the button is held, or is a pen's "
                                      "pressure, and a stiff place gives way less; off: the wheel says how deep"),
                                   {QKeySequence(Qt::Key_E)});
    m_effortAction->setCheckable(true);
    m_clutchAction =
        m_actions.add("clutch", ActionGroup::Session, tr("Lift the hand"),
                      tr("Move the device without the hand in the scene, as a mouse is lifted; again to go on"),
                      {QKeySequence(Qt::Key_C)}, Symbol::Hand);
    m_clutchAction->setCheckable(true);
    m_recordAction =
        m_actions.add("record", ActionGroup::Session, tr("Record"), tr("Record what the hand feels, at every moment"),
                      {QKeySequence(Qt::Key_R)}, Symbol::Record);
    m_recordAction->setCheckable(true);
    m_playAction = m_actions.add("play", ActionGroup::Session, tr("Play"), tr("Play or pause the recording"),
                                 {QKeySequence(Qt::Key_K)}, Symbol::Play);
    m_restartAction = m_actions.add("to-start", ActionGroup::Session, tr("To the start"),
                                    tr("Back to the recording's start"), {QKeySequence(Qt::Key_Home)}, Symbol::Restart);
    m_actions.addSeparator(ActionGroup::Session);
    m_findingAction = m_actions.add("mark", ActionGroup::Session, tr("Mark a finding"),
                                    tr("Mark the place that is touched, in the scene and in the recording"),
                                    {QKeySequence(Qt::Key_M)});
    m_findingNoteAction =
        m_actions.add("mark-and-write", ActionGroup::Session, tr("Mark a finding and write…"),
                      tr("Mark the place that is touched and write about it"), {QKeySequence(Qt::CTRL | Qt::Key_M)});
    m_noteAction = m_actions.add("note", ActionGroup::Session, tr("Note…"), tr("Write a note without a place"),
                                 {QKeySequence(Qt::Key_N)});
    m_nextFindingAction =
        m_actions.add("next-finding", ActionGroup::Session, tr("Next finding"),
                      tr("Go to the next finding, in the view from which it was marked"), {QKeySequence(Qt::Key_J)});
    m_previousFindingAction = m_actions.add("previous-finding", ActionGroup::Session, tr("Previous finding"),
                                            tr("Go to the finding before"), {QKeySequence(Qt::SHIFT | Qt::Key_J)});
    m_measuresAction =
        m_actions.add("measures", ActionGroup::Session, tr("Results…"),
                      tr("Forces, coverage and findings of the recording, and exports"), {QKeySequence(Qt::Key_I)});
    m_embedAction = m_actions.add("embed", ActionGroup::Session, tr("Keep the surfaces inside recordings"),
                                  tr("One file then holds the whole session; it grows by what the meshes take"));
    m_embedAction->setCheckable(true);
    m_embedAction->setChecked(QSettings().value(QStringLiteral("session/embed")).toBool());
    m_actions.addSeparator(ActionGroup::Session);
}

void MainWindow::makeDeviceAndHelpActions()
{
    m_fitSceneAction = m_actions.add("fit-device-all", ActionGroup::Device, tr("Zoom the hand's space to everything"),
                                     tr("The device's whole way goes through all that is shown"),
                                     {QKeySequence(Qt::Key_W)}, Symbol::Fit);
    m_fitOrganAction = m_actions.add("fit-device-organ", ActionGroup::Device, tr("Zoom the hand's space to the organ"),
                                     tr("The device's whole way goes through the organ that is touched or pointed at"),
                                     {QKeySequence(Qt::Key_O)}, Symbol::Fit);
    m_fitLumpAction = m_actions.add("fit-device-lump", ActionGroup::Device, tr("Zoom the hand's space to the lump"),
                                    tr("The device's whole way is 10 mm, about what is touched, pointed at or found"),
                                    {QKeySequence(Qt::Key_L)}, Symbol::Fit);
    // "?" on all keyboard layouts, with F1 as alternative.
    m_keysAction = m_actions.add(
        "keys", ActionGroup::Help, tr("All keys"), tr("Show all keys"),
        {QKeySequence(QStringLiteral("?")), QKeySequence(Qt::SHIFT | Qt::Key_Question), QKeySequence(Qt::Key_F1)},
        Symbol::Keys);
    m_around = new palpate::app::ShowAround(this, m_actions, m_viewport);
    auto* help = new palpate::app::Help(this, m_actions);
    connect(help, &palpate::app::Help::said, this, [this](const QString& line) { say(line); });
}

void MainWindow::makeMenus()
{
    QMenu* file = menuBar()->addMenu(tr("&File"));
    m_actions.fill(*file, ActionGroup::File);
    m_recentMenu = new QMenu(tr("Open recent"), file);
    file->insertMenu(m_saveAction, m_recentMenu);
    m_actions.fill(*menuBar()->addMenu(tr("&Edit")), ActionGroup::Edit);
    QMenu* view = menuBar()->addMenu(tr("&View"));
    m_actions.fill(*view, ActionGroup::View);
    m_sound->watch(*view);
    for (QDockWidget* dock : m_docks) {
        view->addAction(dock->toggleViewAction());
    }
    view->addSeparator();
    m_actions.fill(*view->addMenu(tr("Appearance")), ActionGroup::Appearance);
    m_actions.fill(*view->addMenu(tr("Text size")), ActionGroup::TextSize);
    palpate::app::addLanguageMenu(*view, *this, [this](const QString& line) { say(line); });
    QMenu* session = menuBar()->addMenu(tr("&Session"));
    m_actions.fill(*session, ActionGroup::Session);
    palpate::app::addFingertipMenu(*session, m_live);
    m_actions.fill(*menuBar()->addMenu(tr("&Help")), ActionGroup::Help);
}
