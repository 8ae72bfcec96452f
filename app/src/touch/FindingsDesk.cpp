// SPDX-License-Identifier: BSD-3-Clause
#include "touch/FindingsDesk.h"

#include "shared/Console.h"
#include "shared/Paths.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/session/Findings.h>
#include <palpate/study/FindingsFile.h>
#include <palpate/ui/FeltWords.h>
#include <palpate/ui/Translated.h>

#include <QDateTime>
#include <QLocale>

#include <algorithm>
#include <cstddef>
#include <utility>

using namespace palpate;
using namespace palpate::ui;

FindingsDesk::FindingsDesk(const Parts& parts, QObject* parent)
    : QObject(parent)
    , m_parts(parts)
    , m_flight(parts.viewport)
{
    m_show.setSingleShot(true);
    m_show.setInterval(0);
    connect(&m_show, &QTimer::timeout, this, &FindingsDesk::show);
    connect(&parts.document, &SceneDocument::findingsChanged, &m_show, qOverload<>(&QTimer::start));
    connect(&parts.panel, &FindingsPanel::selected, this, [this](int row) {
        m_parts.viewport.view().findings().select(static_cast<std::size_t>(row + 1));
        m_parts.viewport.update();
    });
    connect(&parts.panel, &FindingsPanel::flightWanted, this, &FindingsDesk::flyTo);
    connect(&parts.panel, &FindingsPanel::playWanted, this, &FindingsDesk::playFrom);
    connect(&parts.panel, &FindingsPanel::noteWritten, this, &FindingsDesk::addNote);
    const auto record = [this](const char* kind, const core::Finding& finding) {
        m_parts.live.note(kind, session::findingJson(finding));
    };
    FindingsModel& model = parts.document.findingsModel();
    connect(&model, &FindingsModel::marked, this,
            [record](const core::Finding& one) { record(one.hasPlace ? "finding" : "note", one); });
    connect(&model, &FindingsModel::unmarked, this,
            [record](const core::Finding& one) { record("finding-undone", one); });
    connect(&model, &FindingsModel::edited, this,
            [record](const core::Finding& one) { record("finding-edited", one); });
    connect(&model, &FindingsModel::refused, this, &FindingsDesk::failed);
}

const core::Finding& FindingsDesk::finding(int row) const
{
    return m_parts.document.findings()[static_cast<std::size_t>(row)];
}

/// Makes a finding with the properties common to findings and notes.
/// @param tick  of the live hand, in the running recording
core::Finding FindingsDesk::markedAt(std::int64_t tick) const
{
    core::Finding now;
    now.camera = viewPose(m_parts.viewport);
    now.marked_utc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    const session::RecorderStatus recording = m_parts.live.recording();
    const RecordedTouch* played = m_parts.playback.recording();
    const bool isLiveHand = m_parts.palpation.isPalpating() || !m_parts.live.usesPointer();
    if (recording.isRecording) {
        const double ago_s =
            static_cast<double>(m_parts.live.newest().tick - tick) / std::max(1.0, m_parts.live.rate_Hz());
        now.recording =
            core::RecordedMoment{m_recording.string(), {}, tick, std::max(0.0, recording.duration_s - ago_s)};
    } else if (played != nullptr && (m_parts.playback.isPlaying() || !isLiveHand)) {
        const double time_s = m_parts.playback.position_s();
        const auto shown = played->at(time_s);
        const std::filesystem::path file = std::filesystem::absolute(played->path());
        now.recording = core::RecordedMoment{file.string(), hashOf(file), shown ? shown->tick : 0, time_s};
    }
    return now;
}

bool FindingsDesk::mark()
{
    const auto& pressed = m_parts.palpation.lastPress();
    const view::TouchState& now = m_parts.viewport.view().cursor().state();
    if (!now.isInContact && !pressed) {
        Q_EMIT said(tr("Nothing is touched. Press on a place first, then mark a finding (M)."));
        return false;
    }
    const view::TouchState& touch = pressed ? pressed->touch : now;
    const TouchReading& felt = pressed ? pressed->reading : m_parts.touch.reading();
    core::Finding one = markedAt(pressed ? pressed->tick : m_parts.live.newest().tick);
    one.name = tr("Finding %1").arg(m_parts.document.findings().size() + 1).toStdString();
    const PalpatedStructure on = palpatedStructure(felt);
    one.structure = on.name.toStdString();
    one.p_W = restOf(one.structure, touch.onSurface_W());
    one.force_N = on.force_N;
    one.depth_mm = on.depth_mm;
    for (const LayerShare& layer : felt.layers) {
        if (!on.inside.isEmpty()) { // lists all layers in contact, the organ first
            one.layers.push_back({layer.name.toStdString(), layer.along_N, layer.depth_mm});
        }
    }
    QString line = tr("%1 marked on %2 at %3 N")
                       .arg(QString::fromStdString(one.name), whereText(on), QLocale().toString(on.force_N, 'f', 2));
    if (on.stiffnessRatio) {
        line += tr(", stiffness %1").arg(responseChangeText(*on.stiffnessRatio));
    }
    Q_EMIT said(line);
    m_parts.document.addFinding(one);
    m_parts.panel.select(static_cast<int>(m_parts.document.findings().size()) - 1);
    return true;
}

/// Row of a structure by its name, as stored in the scene or as shown.
std::optional<std::size_t> FindingsDesk::rowOf(const std::string& structure) const
{
    const auto& rows = m_parts.structures.rows();
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const std::string& name = rows[row].loaded.description.name;
        if (name == structure || readableName(name).toStdString() == structure) {
            return row;
        }
    }
    return std::nullopt;
}

/// A place on moving tissue is kept on the rest shape, to which images, lumps and exports refer.
core::Vec3 FindingsDesk::restOf(const std::string& structure, const core::Vec3& p_W) const
{
    const auto row = rowOf(structure);
    return row && *row < m_parts.viewport.view().structureCount()
               ? m_parts.viewport.view().structure(*row).picture.restOf(p_W)
               : p_W;
}

void FindingsDesk::addNote(const QString& text)
{
    core::Finding one = markedAt(m_parts.live.newest().tick);
    one.hasPlace = false;
    one.name = tr("Note %1").arg(m_parts.document.findings().size() + 1).toStdString();
    one.note = text.toStdString();
    m_parts.document.addFinding(one);
    m_parts.panel.select(static_cast<int>(m_parts.document.findings().size()) - 1);
}

void FindingsDesk::step(int by)
{
    const auto count = static_cast<int>(m_parts.document.findings().size());
    if (count == 0) {
        Q_EMIT said(tr("No findings yet. Press on a place, then mark a finding (M)."));
        return;
    }
    const int at = m_parts.panel.current();
    const int next = at < 0 ? (by > 0 ? 0 : count - 1) : (at + by + count) % count;
    m_parts.panel.select(next);
    flyTo(next);
}

void FindingsDesk::flyTo(int row)
{
    const core::Finding& to = finding(row);
    core::ViewPose pose = viewPose(m_parts.viewport);
    if (to.camera) {
        pose = *to.camera;
    } else if (to.hasPlace) { // keep the viewing direction
        pose.position_W += to.p_W - pose.focus_W;
        pose.focus_W = to.p_W;
    } else {
        Q_EMIT said(tr("%1 has no saved view.").arg(QString::fromStdString(to.name)));
        return;
    }
    m_flight.flyTo(pose);
}

void FindingsDesk::playFrom(int row)
{
    constexpr double kBefore_s = 1.0;
    const core::Finding& one = finding(row);
    const QString name = QString::fromStdString(one.name);
    if (!one.recording) {
        Q_EMIT said(tr("%1 was not marked in a recording.").arg(name));
        return;
    }
    if (m_parts.live.recording().isRecording) {
        Q_EMIT said(tr("Recording in progress. Stop recording (R) before playing."));
        return;
    }
    const core::RecordedMoment moment = *one.recording; // copied, because opening may change the findings
    const std::filesystem::path file = moment.file;
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
        Q_EMIT failed(tr("%1: the recording with %2 was not found.").arg(toText(file), name));
        return;
    }
    if (!moment.sha256.empty() && hashOf(file) != moment.sha256) {
        Q_EMIT failed(tr("%1: this is not the recording in which %2 was marked.").arg(toText(file), name));
        return;
    }
    const auto isOpen = [&] {
        const RecordedTouch* played = m_parts.playback.recording();
        return played != nullptr && std::filesystem::equivalent(played->path(), file, error);
    };
    if (!isOpen()) {
        Q_EMIT recordingWanted(file);
    }
    if (isOpen()) {
        m_parts.playback.seek(std::max(0.0, moment.time_s - kBefore_s));
        m_parts.playback.play();
    }
}

void FindingsDesk::exportTo(const std::filesystem::path& path)
{
    const bool isTable = path.extension() == ".csv";
    const std::vector<core::Finding>& all = m_parts.document.findings();
    core::Status status = app::checkOutputs({m_parts.document.file()}, {path});
    if (status.isOk()) {
        status = core::writeAtomically(path, isTable ? study::findingsCsv(all) : study::findingsMarkups(all));
    }
    if (status.isOk()) {
        Q_EMIT said(tr("%n finding(s) exported to %1", nullptr, static_cast<int>(all.size())).arg(toText(path)));
    } else {
        Q_EMIT failed(ui::translated(status));
    }
}

void FindingsDesk::importFrom(const std::filesystem::path& path)
{
    auto markups = study::readMarkups(path);
    if (!markups.isOk()) {
        Q_EMIT failed(ui::translated(markups.status()));
        return;
    }
    const auto count = static_cast<int>(markups.value().findings.size());
    m_parts.document.findingsModel().add(std::move(markups.value().findings),
                                         tr("Import %n finding(s)", nullptr, count));
    Q_EMIT said(tr("%n finding(s) imported from %1", nullptr, count).arg(toText(path.filename())));
    QStringList losses;
    for (const core::Message& loss : markups.value().losses) {
        losses << ui::translated(loss);
    }
    if (!losses.isEmpty()) {
        Q_EMIT failed(losses.join(QLatin1Char('\n')));
    }
}

void FindingsDesk::beginRecording(const std::filesystem::path& path)
{
    m_recording = path;
    m_parts.palpation.forgetPress(); // the recording does not contain this press
}

void FindingsDesk::endRecording()
{
    const std::vector<core::Finding>& all = m_parts.document.findings();
    const std::string file = m_recording.string();
    const bool isUsed = std::any_of(
        all.begin(), all.end(), [&](const core::Finding& one) { return one.recording && one.recording->file == file; });
    if (isUsed) {
        m_parts.document.findingsModel().setRecordingHash(file, hashOf(m_recording));
    }
    m_recording.clear();
}

/// Hash of a recording, computed once per file: finished recordings do not change.
std::string FindingsDesk::hashOf(const std::filesystem::path& recording) const
{
    std::string& hash = m_hashes[recording];
    if (hash.empty()) {
        hash = meshio::fileHash(recording);
    }
    return hash;
}

void FindingsDesk::show()
{
    std::vector<view::FindingMark> marks;
    std::size_t number = 0;
    for (const core::Finding& one : m_parts.document.findings()) {
        ++number;
        if (one.hasPlace) {
            marks.push_back({one.p_W, one.type, number, one.name, rowOf(one.structure)});
        }
    }
    if (m_parts.playback.recording() != nullptr) { // also draw findings of the recording that are missing in the scene
        for (const core::Finding& one : m_parts.playback.recording()->findings()) {
            const bool isThere = std::any_of(marks.begin(), marks.end(),
                                             [&](const view::FindingMark& mark) { return mark.p_W == one.p_W; });
            if (one.hasPlace && !isThere) {
                marks.push_back({one.p_W, one.type, ++number, one.name, rowOf(one.structure)});
            }
        }
    }
    view::FindingMarkers& markers = m_parts.viewport.view().findings();
    markers.set(std::move(marks));
    markers.select(static_cast<std::size_t>(m_parts.panel.current() + 1));
    m_parts.viewport.update();
    Q_EMIT countChanged(markers.marks().size());
}

#include "moc_FindingsDesk.cpp"
