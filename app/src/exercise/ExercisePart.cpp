// SPDX-License-Identifier: BSD-3-Clause
#include "exercise/ExercisePart.h"

#include "scene/DocumentPart.h"
#include "shell/Notices.h"
#include "touch/RecordingPart.h"
#include "touch/TouchPart.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/ExerciseBar.h>
#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QDockWidget>
#include <QLocale>
#include <QMainWindow>

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate::app {

using core::Vec3;
using ui::ActionGroup;

namespace {

constexpr int kTick_ms = 100;
constexpr double kFaded = 0.35; // opacity of the structures around the shown targets

/// Whole seconds as "04:12".
QString secondsText(double seconds)
{
    const long long whole = std::llround(std::ceil(std::max(0.0, seconds)));
    return QStringLiteral("%1:%2").arg(whole / 60, 2, 10, QLatin1Char('0')).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

/// Row of a target by its name; -1 if the scene has changed.
int rowOf(const ui::StructureModel& model, const std::string& name)
{
    for (int row = 0; row < model.rowCount(); ++row) {
        if (model.structure(row).name == name && model.isListed(row)) {
            return row;
        }
    }
    return -1;
}

/// Place on the surface around a target that is nearest to the target.
view::TargetMark markOf(const ui::StructureModel& model, int row, const study::TargetBall& ball)
{
    view::TargetMark mark;
    mark.radius_mm = ball.radius_mm;
    mark.p_W = ball.centre_W;
    if (row < 0) {
        return mark;
    }
    mark.structure = static_cast<std::size_t>(row);
    const auto& around = model.rows()[static_cast<std::size_t>(row)].in;
    if (!around.has_value() || !model.rows()[*around].isThere()) {
        return mark;
    }
    mark.structure = *around;
    const std::vector<Vec3>& vertices = model.rows()[*around].loaded.surface->mesh.vertices;
    mark.p_W = *std::min_element(vertices.begin(), vertices.end(), [&ball](const Vec3& a, const Vec3& b) {
        return (a - ball.centre_W).squaredNorm() < (b - ball.centre_W).squaredNorm();
    });
    const Vec3 outwards = mark.p_W - ball.centre_W;
    mark.n_W = outwards.norm() > 0.0 ? Vec3(outwards.normalized()) : Vec3(Vec3::UnitZ());
    return mark;
}

} // namespace

ExercisePart::ExercisePart(const WindowCore& core, DocumentPart& document, TouchPart& touch, RecordingPart& recording)
    : WindowPart(&core.window)
    , m_core(core)
    , m_document(document)
    , m_touch(touch)
    , m_recording(recording)
    , m_bar(new ui::ExerciseBar(core.viewport))
{
    m_clock.setInterval(kTick_ms);
    connect(&m_clock, &QTimer::timeout, this, &ExercisePart::follow);
    connect(&recording, &RecordingPart::begun, this, &ExercisePart::begin);
    connect(&recording, &RecordingPart::ended, this, &ExercisePart::takeEnd);
    connect(&touch.panel(), &ui::TouchPanel::changed, this, &ExercisePart::showBar);
    connect(&document.document(), &SceneDocument::findingsChanged, this, &ExercisePart::showBar);
}

ExercisePart::~ExercisePart()
{
    delete m_dialog;
    delete m_bar;
}

void ExercisePart::addActions()
{
    ui::ActionList& actions = m_core.actions;
    const QString start = tr("Search for the hidden targets: records the hand until the end");
    connect(actions.add("exercise", ActionGroup::Session, tr("Start the exercise"), start,
                        {QKeySequence(Qt::CTRL | Qt::Key_R)}),
            &QAction::triggered, this, &ExercisePart::toggle);
    connect(actions.add("exercise-show", ActionGroup::Session, tr("Show the targets…"),
                        tr("Give up the exercise without a search")),
            &QAction::triggered, this, &ExercisePart::askToReveal);
    connect(actions.add("exercise-again", ActionGroup::Session, tr("Do the exercise again"),
                        tr("Hide the targets again for another search")),
            &QAction::triggered, this, &ExercisePart::again);
    connect(actions.add("exercise-results", ActionGroup::Session, tr("Results of the exercise…"),
                        tr("Found and missed targets, time, coverage and force of the last search")),
            &QAction::triggered, this, &ExercisePart::showResults);
    actions.addSeparator(ActionGroup::Session);
}

void ExercisePart::showState(const WindowState& state)
{
    if (m_stage == Stage::Running && !state.isRecording) {
        takeEnd(); // the recording failed; the recorded part is scored
        return;
    }
    ui::ActionList& actions = m_core.actions;
    const bool isRunning = m_stage == Stage::Running;
    actions.at("exercise").setText(isRunning ? tr("End the exercise") : tr("Start the exercise"));
    actions.setEnabled({"exercise"}, isRunning || m_stage == Stage::Waiting);
    actions.setEnabled({"exercise-show"}, m_stage == Stage::Waiting);
    actions.setEnabled({"exercise-again"}, m_stage == Stage::Ended);
    actions.setEnabled({"exercise-results"}, m_stage == Stage::Ended && !m_file.empty());
    const bool isSecret = m_core.model.scene().hiddenTargets() > 0;
    if (isSecret) {
        const QString why = tr("Off until the exercise ends, because it could show the hidden targets");
        const auto keep = {"felt",           "distances",      "tape",           "touch-map",
                           "touch-map-next", "touch-map-back", "section",        "section-direction",
                           "section-side",   "section-here",   "section-deeper", "section-nearer",
                           "finger-section", "image",          "image-remove",   "peek",
                           "measures",       "compare",        "report",         "play",
                           "to-start"};
        if (!std::exchange(m_isBlocked, true)) {
            actions.withhold(keep, why);
        }
        if (isRunning) { // other coordinates would read the meshes again
            actions.setEnabled({"frame-lps", "frame-ras", "frame-y-up"}, false);
        } else if (!state.isRecording) {
            actions.at("record").setEnabled(false);
            actions.at("record").setToolTip(tr("The recording starts with the exercise (Session menu)"));
        }
    }
    showBar();
}

void ExercisePart::takeScene()
{
    m_file.clear();
    m_clock.stop();
    dropTargets();
    closeResults();
    const bool hasExercise = m_core.model.scene().exercise().has_value();
    m_stage = !hasExercise ? Stage::None : m_core.model.scene().hiddenTargets() > 0 ? Stage::Waiting : Stage::Ended;
    if (m_stage == Stage::Waiting) {
        hide();
        m_core.notices.say(tr("This scene is an exercise: find the hidden targets by touch. Start it in the view or in "
                              "the Session menu."),
                           60000);
    } else {
        unblock();
    }
    Q_EMIT stateChanged();
}

void ExercisePart::toggle()
{
    m_stage == Stage::Running ? end() : start();
}

void ExercisePart::start()
{
    if (m_recording.isRecording()) {
        m_core.notices.say(tr("Stop the recording before you start the exercise."));
        return;
    }
    m_document.document().setAside(true);
    m_recording.toggle();
    if (!m_recording.isRecording()) {
        return; // the reason is shown
    }
    m_stage = Stage::Running;
    m_clock.start();
    m_core.notices.say(tr("The exercise runs. Mark each place that you find (Mark in the tool bar or M)."), 15000);
    Q_EMIT stateChanged();
}

void ExercisePart::begin(const std::filesystem::path& recording)
{
    m_file = recording;
}

void ExercisePart::end()
{
    m_recording.toggle(); // takeEnd follows
}

/// Ends the search with its recording.
void ExercisePart::takeEnd()
{
    if (m_stage != Stage::Running) {
        return;
    }
    m_stage = Stage::Ended;
    m_clock.stop();
    reveal();
    QTimer::singleShot(0, this, &ExercisePart::showResults);
}

void ExercisePart::hide()
{
    m_recording.playback().setRecording(nullptr);
    m_touch.panel().showNoHand(); // the last moment of the recording names targets
    m_core.viewport.view().cursor().setState({});
    dropTargets();
    for (const char* name : {"felt", "distances"}) { // also when the stored layout shows them
        if (auto* dock = m_core.window.findChild<QDockWidget*>(QLatin1String(name))) {
            dock->hide();
        }
    }
    m_core.model.setTargetsHidden(true);
    m_document.document().setAside(true);
    m_core.notices.forgetIf( // messages from before the targets were hidden
        [this](const QString& text) { return m_core.model.scene().givesTargetAway(text.toStdString()); });
}

void ExercisePart::reveal()
{
    m_core.model.setTargetsHidden(false);
    m_document.document().setAside(false);
    unblock();
    Q_EMIT stateChanged();
}

void ExercisePart::unblock()
{
    if (std::exchange(m_isBlocked, false)) {
        m_core.actions.release();
    }
}

void ExercisePart::askToReveal()
{
    m_core.notices.bar().ask(
        tr("Show the targets without a search? Whoever has seen them cannot search for them any more."),
        tr("Show the targets"),
        [this] {
            if (m_stage == Stage::Waiting) {
                m_stage = Stage::Ended;
                reveal();
            }
        },
        tr("Keep them hidden"), [] {});
}

void ExercisePart::again()
{
    if (m_stage != Stage::Ended) {
        return;
    }
    if (m_recording.isRecording()) {
        m_core.notices.say(tr("Stop the recording before you do the exercise again."));
        return;
    }
    closeResults();
    m_stage = Stage::Waiting;
    m_file.clear();
    m_core.notices.bar().forgetScene();
    hide();
    m_core.viewport.setFocus();
    Q_EMIT stateChanged();
}

void ExercisePart::showResults()
{
    if (m_stage != Stage::Ended || m_file.empty()) {
        return; // another scene is open
    }
    if (m_dialog != nullptr) {
        m_dialog->raise();
        m_dialog->activateWindow();
        return;
    }
    session::MeshesByHash meshes;
    for (const study::OpenStructure& row : m_core.model.rows()) {
        if (!row.sha256.empty()) {
            meshes[row.sha256] = row.loaded.surface;
        }
    }
    m_dialog = new ExerciseDialog(
        m_file, std::move(meshes), *m_core.model.scene().exercise(),
        [this](const study::ExerciseScore& score) { return picture(score); }, &m_core.window);
    connect(m_dialog, &ExerciseDialog::againWanted, this, &ExercisePart::again);
    m_dialog->show();
}

void ExercisePart::closeResults()
{
    if (m_dialog != nullptr) {
        m_dialog->close(); // deletes the dialog later: it may be the sender of the current signal
        m_dialog = nullptr;
    }
}

/// Follows the recording, and ends the search at the time limit.
void ExercisePart::follow()
{
    const auto limit_s = m_core.model.scene().exercise()->time_s;
    if (limit_s && m_core.live.recording().duration_s >= *limit_s) {
        m_core.notices.say(tr("Time is up."));
        end();
        return;
    }
    showBar();
}

void ExercisePart::showBar()
{
    m_bar->setVisible(m_stage != Stage::None);
    if (m_stage == Stage::None || !m_core.model.scene().exercise()) {
        return;
    }
    const meshio::Exercise& exercise = *m_core.model.scene().exercise();
    const QLocale locale;
    const auto newtons = [&locale](double force_N) { return locale.toString(force_N, 'f', 1); };
    const auto hidden = static_cast<int>(m_core.model.scene().hiddenTargets());
    ui::ExerciseBar::Texts texts;
    ui::ActionList& actions = m_core.actions;
    switch (m_stage) {
    case Stage::Running: {
        const double passed_s = m_core.live.recording().duration_s, force_N = m_touch.panel().reading().force_N;
        texts.title =
            tr("%1 · %2").arg(tr("%n hidden target(s)", nullptr, hidden),
                              tr("%n marked", nullptr, static_cast<int>(m_document.document().findings().size())));
        texts.clock = exercise.time_s ? tr("%1 left").arg(secondsText(*exercise.time_s - passed_s))
                                      : secondsText(std::floor(passed_s));
        if (exercise.force_ceiling_N) {
            const double most_N = *exercise.force_ceiling_N;
            texts.isAbove = force_N > most_N;
            texts.force = texts.isAbove ? tr("%1 N: above the ceiling of %2 N").arg(newtons(force_N), newtons(most_N))
                                        : tr("%1 N, ceiling %2 N").arg(newtons(force_N), newtons(most_N));
        }
        texts.detail = tr("At each place that you find, click Mark or press M.");
        m_bar->setActions({&actions.at("mark"), &actions.at("exercise")});
        break;
    }
    case Stage::Waiting:
        texts.title = tr("Exercise: %n hidden target(s)", nullptr, hidden);
        texts.clock = exercise.time_s ? secondsText(*exercise.time_s) : QString();
        texts.force =
            exercise.force_ceiling_N ? tr("Force ceiling %1 N").arg(newtons(*exercise.force_ceiling_N)) : QString();
        texts.detail = tr("Find them by touch. The search is recorded. Sections, peek, maps, distances, results and "
                          "reports are off until the end.");
        m_bar->setActions({&actions.at("exercise"), &actions.at("exercise-show")});
        break;
    default:
        texts.title = tr("Exercise: the targets are shown");
        m_bar->setActions({&actions.at("exercise-results"), &actions.at("exercise-again")});
        break;
    }
    m_bar->setTexts(texts);
}

/// Marks the targets on the surface with their results, and draws the structures around them translucent.
void ExercisePart::showTargets(const study::ExerciseScore& score)
{
    dropTargets();
    const ui::StructureModel& model = m_core.model;
    view::SceneView& view = m_core.viewport.view();
    std::vector<view::TargetMark> marks;
    for (const study::ScoredTarget& one : score.targets) {
        const int row = rowOf(model, one.name);
        view::TargetMark mark = markOf(model, row, one.ball);
        const QString name = ui::readableName(one.name);
        mark.isFound = one.found_s.has_value();
        mark.text = (mark.isFound ? tr("%1: found after %2 s").arg(name, QLocale().toString(*one.found_s, 'f', 1))
                                  : tr("%1: missed").arg(name))
                        .toStdString();
        marks.push_back(std::move(mark));
        for (auto in = row < 0 ? std::nullopt : model.rows()[static_cast<std::size_t>(row)].in; in;
             in = model.rows()[*in].in) {
            view::Appearance look = model.appearanceOf(static_cast<int>(*in));
            look.opacity = std::min(look.opacity, kFaded);
            view.setAppearance(*in, look);
            m_faded.push_back(static_cast<int>(*in));
        }
    }
    view.targets().set(std::move(marks));
    m_core.viewport.update();
}

void ExercisePart::dropTargets()
{
    view::SceneView& view = m_core.viewport.view();
    for (const int row : std::exchange(m_faded, {})) {
        if (row < m_core.model.rowCount()) {
            view.setAppearance(static_cast<std::size_t>(row), m_core.model.appearanceOf(row));
        }
    }
    view.targets().set({});
    m_core.viewport.update();
}

QImage ExercisePart::picture(const study::ExerciseScore& score)
{
    showTargets(score);
    return m_core.viewport.picture(2.0);
}

} // namespace palpate::app

#include "moc_ExercisePart.cpp"
