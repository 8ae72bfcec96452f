// SPDX-License-Identifier: BSD-3-Clause
#include "commands/ReplayRun.h"

#include "reports/SessionReport.h"
#include "shared/Console.h"
#include "shared/Devices.h"
#include "shared/LayersOption.h"

#include <palpate/servo/PassivityController.h>
#include <palpate/study/DeviceLimit.h>
#include <palpate/study/FeltFile.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/RecordedLooks.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/study/StructureSources.h>

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace palpate::app {

using core::Status;
using core::StatusCode;

namespace {

namespace fs = std::filesystem;

double seconds(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Describes surface changes (smoothing, curved facets, orientation) relative to the files; empty without changes.
std::string surfaceChangesOf(const meshio::LoadedScene& scene)
{
    std::vector<study::RecordedLook> looks;
    bool isAny = false;
    for (const meshio::LoadedStructure& one : scene.structures) {
        looks.push_back(study::lookOf(one.description));
        isAny = isAny || one.description.outwards || one.closing || one.smoothing || one.curving;
    }
    return isAny ? study::looksText(looks) : std::string();
}

} // namespace

ReplayRun::~ReplayRun()
{
    if (m_writer) {
        m_writer->discard(); // never leave an incomplete recording under the final name
    }
}

int ReplayRun::run()
{
    for (const auto step : {&ReplayRun::checkOptions, &ReplayRun::openOutputs, &ReplayRun::loadMotion,
                            &ReplayRun::loadScene, &ReplayRun::feel, &ReplayRun::finish}) {
        if (const Status status = (this->*step)(); !status.isOk()) {
            return report(status);
        }
    }
    m_summary->print();
    int code = m_resimulation ? reportAgreement(m_options.motion, m_recording->info(), *m_resimulation) : kDone;
    if (const int losses = reportLosses(m_losses); code == kDone) {
        code = losses;
    }
    return m_recording ? reportDamage(m_options.motion, m_recording->faults(), code) : code;
}

Status ReplayRun::checkOptions()
{
    const auto unit = unitOption(m_options.unit);
    if (!unit.isOk()) {
        return unit.status();
    }
    m_unit_mm = unit.value();
    const auto frame = frameOption(m_options.frame);
    if (!frame.isOk()) {
        return frame.status();
    }
    m_frame = frame.value();
    if (Status layers = checkLayers(m_options.layers); !layers.isOk()) {
        return layers;
    }
    if (Status cpu = servo::checkCpu(m_options.cpu); !cpu.isOk()) {
        return cpu;
    }
    const auto number = [](std::string_view option, const std::string& text, const NumberRange& range,
                           std::optional<double>& out) {
        if (text.empty()) {
            return Status();
        }
        const auto value = numberOption(option, text, range);
        if (value.isOk()) {
            out = value.value();
        }
        return value.status();
    };
    for (std::size_t i = 0; i < m_tissue.size(); ++i) {
        const core::TissueTerm& term = core::kTissueTerms[i];
        const bool isAbove = term.member == &core::Tissue::stiffness_N_per_mm; // zero stiffness gives no contact
        const NumberRange range{.most = term.most, .isAbove = isAbove};
        if (Status status = number(term.option, m_options.tissue[i], range, m_tissue[i]); !status.isOk()) {
            return status;
        }
    }
    const NumberRange ofRadius{.most = haptics::HapticScene::kMostFingertip_mm};
    if (Status status = number("--radius", m_options.radius, ofRadius, m_radius); !status.isOk()) {
        return status;
    }
    std::vector<fs::path> outputs;
    for (const fs::path* path : {&m_options.out, &m_options.json, &m_options.record}) {
        if (!path->empty()) {
            outputs.push_back(*path);
        }
    }
    std::error_code error;
    for (const fs::path* path : {&m_options.scene, &m_options.motion}) {
        if (!fs::exists(*path, error)) {
            return {StatusCode::NotFound,
                    path == &m_options.scene
                        ? core::Message(
                              PALPATE_TEXT("%1: no such file, expected a mesh, a scene or a folder of meshes"), *path)
                        : core::Message(PALPATE_TEXT("%1: no such file, expected a motion CSV or a recording"), *path)};
        }
    }
    return checkOutputs({m_options.scene, m_options.motion}, outputs);
}

Status ReplayRun::openOutputs()
{
    if (!m_options.out.empty()) {
        using Rows = session::TickCsv::Rows;
        auto csv = session::TickCsv::create(m_options.out, hasDevice() ? Rows::Device : Rows::Ticks);
        if (!csv.isOk()) {
            return csv.status();
        }
        m_csv = std::move(csv).value();
    }
    if (!m_options.json.empty()) {
        auto file = core::AtomicFile::create(m_options.json);
        if (!file.isOk()) {
            return file.status();
        }
        m_json = std::move(file).value();
    }
    // The recording is created once the scene is known; check now whether this is possible, before the work.
    return m_options.record.empty() ? Status() : checkRecord();
}

Status ReplayRun::checkRecord() const
{
    std::error_code error;
    const auto kind = fs::symlink_status(m_options.record, error).type();
    if (kind == fs::file_type::not_found) {
        return core::AtomicFile::create(m_options.record, core::AtomicFile::Onto::Nothing).status();
    }
    if (kind != fs::file_type::regular && kind != fs::file_type::symlink) {
        return {StatusCode::BadCommandLine,
                PALPATE_TEXT("%1: cannot be written: not a file; a recording is one, expected its name"),
                m_options.record};
    }
    return m_options.isForced
               ? Status()
               : Status(StatusCode::BadCommandLine,
                        PALPATE_TEXT("%1: found a file of this name, expected a new one for the recording, or --force "
                                     "to replace it"),
                        m_options.record);
}

Status ReplayRun::loadMotion()
{
    if (!session::isRecordingByNameOrContent(m_options.motion)) {
        auto motion = session::readMotion(m_options.motion);
        if (motion.isOk()) {
            m_motion = std::move(motion).value();
        }
        return motion.status();
    }
    auto recording = session::RecordingReader::open(m_options.motion);
    if (!recording.isOk()) {
        return recording.status();
    }
    m_recording = std::move(recording).value();
    auto motion = m_recording->motion();
    if (motion.isOk()) {
        m_motion = std::move(motion).value();
    }
    return motion.status();
}

Status ReplayRun::loadScene()
{
    auto start = std::chrono::steady_clock::now();
    meshio::ReadOptions readOptions;
    readOptions.unit_mm = m_unit_mm;
    readOptions.frame = m_frame;
    readOptions.isPartial = m_options.isPartial;
    m_options.surfaces.applyTo(readOptions);
    std::vector<study::OrganPalpability> felt;
    auto loaded = study::openScene(m_options.scene, readOptions, &felt);
    if (!loaded.isOk()) {
        return loaded.status();
    }
    m_cost.load_s = seconds(start);
    start = std::chrono::steady_clock::now();
    m_scene = study::hapticScene(loaded.value());
    m_cost.index_s = seconds(start);
    m_cost.name = m_options.scene.filename().string();
    m_cost.structures = m_scene->structures().size();
    m_cost.triangles = study::triangleCount(*m_scene);
    m_cost.bytes = m_scene->byteSize();
    if (m_cost.triangles == 0) {
        return {StatusCode::Empty, PALPATE_TEXT("%1: found nothing palpable, expected a structure that is"),
                m_options.scene};
    }
    m_losses = loaded.value().losses;
    for (const std::string& field : meshio::unknownFields(loaded.value().scene)) {
        printError(PALPATE_TEXT("%1: %2: this version does not know this field; it is kept, but not used"),
                   m_options.scene.filename(), field);
    }
    if (!m_options.layers.empty()) {
        const auto before = m_scene;
        for (const core::Message& line : layOut(m_options.scene, loaded.value(), m_scene)) {
            print("layers: %s\n", line.english().c_str());
        }
        m_isRelayered = m_scene != before;
    }
    m_cost.notes = printTouchNotes(loaded.value(), *m_scene);
    if (m_radius) {
        m_scene = std::make_shared<haptics::HapticScene>(m_scene->structures(), *m_radius);
    }
    if (m_tissue != session::TissueOverride()) {
        m_scene = std::make_shared<haptics::HapticScene>(session::withTissue(*m_scene, m_tissue));
    }
    if (m_recording || !m_options.record.empty()) {
        m_sources = study::sourcesOf(loaded.value(), m_options.embeds);
        m_looks = surfaceChangesOf(loaded.value());
    }
    for (const meshio::LoadedStructure& structure : loaded.value().structures) {
        m_isTransmitted.push_back(structure.isTransmitted ? 1 : 0);
    }
    m_summary.emplace(m_cost, m_motion.dt_s);
    m_summary->reserve(m_motion.p_WH.size());
    const auto lumps = study::computePalpability(loaded.value(), std::move(felt));
    if (lumps.isOk()) {
        m_summary->setLumps(study::lumpLines(loaded.value(), lumps.value()),
                            study::lumpsJson(loaded.value(), lumps.value()));
    }
    return {};
}

Status ReplayRun::startRecording(const session::RecordingInfo& info)
{
    if (m_options.record.empty()) {
        return {};
    }
    const auto sync =
        m_options.isLive ? session::RecordingWriter::Sync::EachCommit : session::RecordingWriter::Sync::AtEnd;
    session::RecordingInfo whole = info;
    study::setSceneSource(whole, m_options.scene);
    whole.looks = m_looks;
    std::error_code error;
    const bool replaces = m_options.isForced && fs::exists(fs::symlink_status(m_options.record, error));
    auto writer =
        session::RecordingWriter::create(m_options.record, whole, sync, session::RecordingWriter::Events::Derived,
                                         replaces ? core::ExistingFile::Replace : core::ExistingFile::Refuse);
    if (!writer.isOk()) {
        return writer.status();
    }
    m_writer = std::move(writer).value();
    return m_writer->addScene(session::describeScene(1, *m_scene, m_sources));
}

bool ReplayRun::take(const servo::TickRecord& tick, const session::StructureNames& names)
{
    m_summary->add(tick, names);
    if (m_csv) {
        m_csv->write(tick, names);
    }
    if (m_writer) {
        m_writeStatus = m_writer->append(tick);
    }
    return m_writeStatus.isOk();
}

/// Returns an error if the recording touched a structure that is not palpable in the scene.
Status ReplayRun::checkPalpableMatches(const session::SceneRecord& record) const
{
    for (const session::StructureRecord& structure : record.structures) {
        for (std::size_t i = 0; structure.palpable && i < m_sources.size(); ++i) {
            if (m_sources[i].sha256 != structure.source.sha256 || m_scene->structures()[i].surface != nullptr) {
                continue;
            }
            const bool isTransmitted = m_isTransmitted[i] != 0;
            return {StatusCode::Mismatch,
                    isTransmitted
                        ? core::Message(
                              PALPATE_TEXT("%1: structure \"%2\" was touched by itself in the recording (layer %3), "
                                           "here it is felt through the structure around it; expected the scene "
                                           "that was recorded, or --force to replay the motion alone"),
                              m_options.scene, structure.name, structure.layer)
                        : core::Message(
                              PALPATE_TEXT("%1: structure \"%2\" was touched by itself in the recording (layer %3), "
                                           "here it is not palpable; expected the scene that was recorded, or "
                                           "--force to replay the motion alone"),
                              m_options.scene, structure.name, structure.layer)};
        }
    }
    return {};
}

Status ReplayRun::checkSameGeometry() const
{
    const session::SurfacesByHash surfaces = study::surfacesByHash(*m_scene, m_sources);
    for (const session::SceneRecord& record : m_recording->scenes()) {
        if (Status status = checkPalpableMatches(record); !status.isOk()) {
            return status;
        }
        if (const auto built = session::rebuildScene(record, surfaces); !built.isOk()) {
            return {built.status().code(), PALPATE_TEXT("%1: %2; expected the scene that was recorded, or --force"),
                    m_options.scene, built.status().text()};
        }
    }
    return {};
}

Status ReplayRun::feel()
{
    if (m_recording && !m_options.isForced) {
        if (Status status = checkSameGeometry(); !status.isOk()) {
            return status;
        }
        if (m_tissue == session::TissueOverride() && !m_radius && !m_isRelayered && !m_options.isLive &&
            m_options.record.empty()) {
            return feelRecording();
        }
    }
    if (m_options.isLive) {
        return feelLive();
    }
    session::RecordingInfo info;
    info.device.id = "replay";
    info.device.name = "Replay of " + m_options.motion.filename().string();
    info.dt_s = m_motion.dt_s;
    info.rate_Hz = 1.0 / m_motion.dt_s;
    info.firstGeneration = 1;
    if (Status status = startRecording(info); !status.isOk()) {
        return status;
    }
    session::replay(*m_scene, m_motion, [this](const servo::TickRecord& tick) {
        return take(tick, [this](std::uint32_t structure) { return name(structure); });
    });
    return m_writeStatus;
}

Status ReplayRun::feelRecording()
{
    const auto result = session::resimulate(
        *m_recording, study::surfacesByHash(*m_scene, m_sources), [this](const servo::TickRecord& tick) {
            return (tick.flags & servo::kNoHand) != 0 ||
                   take(tick, [&](std::uint32_t number) { return m_recording->structureName(tick.scene, number); });
        });
    if (!result.isOk()) {
        return result.status().at(m_options.motion);
    }
    m_resimulation = result.value();
    m_summary->setResimulation(*m_resimulation);
    if (m_resimulation->unverified > 0) {
        m_losses.push_back({PALPATE_TEXT("%1: %2 ticks skipped: ticks before them are missing in the recording"),
                            m_options.motion, m_resimulation->unverified});
    }
    return {};
}

core::Result<LiveHand> ReplayRun::liveHand()
{
    if (!hasDevice()) {
        return playbackHand(m_motion);
    }
    if (m_options.device == "simulated") {
        return simulatedHand(m_motion, *device::findDevicePreset("touch"));
    }
    m_plugins = findPlugins(m_options.pluginFolders);
    auto made = m_plugins->make(m_options.device);
    if (made.isOk()) {
        return realHand(m_motion, std::move(made).value());
    }
    const device::DevicePreset* const preset = device::findDevicePreset(m_options.device);
    if (preset != nullptr && made.status().code() == StatusCode::NotFound) {
        return simulatedHand(m_motion, *preset);
    }
    return made.status();
}

/// Limits tissue parameters to the device's limits, as the window does.
void ReplayRun::limitTissues(const device::DeviceInfo& info)
{
    const double rate_Hz = 1.0 / m_motion.dt_s;
    const haptics::Tissue greatest = study::maxTissue(info, servo::heldStiffness_N_per_mm(info, rate_Hz, true, 1));
    auto structures = m_scene->structures();
    study::limitTissues(greatest, structures);
    const std::string bounded = study::limitedText(m_scene->structures(), structures);
    if (!bounded.empty()) {
        print("device: %s can hold %s\n", info.name.c_str(), bounded.c_str());
    }
    m_scene = std::make_shared<haptics::HapticScene>(std::move(structures), m_scene->fingertip_mm());
}

Status ReplayRun::feelLive()
{
    auto made = liveHand();
    if (!made.isOk()) {
        return made.status();
    }
    LiveHand hand = std::move(made).value();
    if (hasDevice()) {
        limitTissues(hand.device->info());
    }
    const auto begin = [this, &hand](const servo::RecordingStart& start) {
        session::RecordingInfo info;
        info.device = hand.device->info();
        info.dt_s = m_motion.dt_s;
        info.rate_Hz = 1.0 / m_motion.dt_s;
        info.firstGeneration = start.scene;
        info.start = start.state;
        return startRecording(info);
    };
    auto lastCommit = std::chrono::steady_clock::now();
    const auto idle = [this, &lastCommit] {
        constexpr double kCommitInterval_s = 0.25;
        if (m_writer && seconds(lastCommit) > kCommitInterval_s) {
            lastCommit = std::chrono::steady_clock::now();
            m_writeStatus = m_writer->commit();
        }
    };
    servo::ServoOptions loop;
    loop.rate_Hz = 1.0 / m_motion.dt_s;
    loop.cpu = m_options.cpu;
    loop.lockMemory = true;
    const auto result = replayLive(
        m_scene, hand, loop, begin,
        [this](const servo::TickRecord& tick) {
            return take(tick, [this](std::uint32_t structure) { return name(structure); });
        },
        idle);
    if (!result.isOk()) {
        return result.status();
    }
    if (!m_writeStatus.isOk()) {
        return m_writeStatus;
    }
    m_summary->setLive(result.value().lost, result.value().overruns);
    if (result.value().lost != 0) {
        m_losses.push_back({PALPATE_TEXT("%1: %2 of %3 ticks were lost"), m_options.motion, result.value().lost,
                            m_motion.p_WH.size()});
    }
    if (!result.value().fault.isEmpty()) {
        m_losses.push_back({PALPATE_TEXT("the safety gate took the force away: %1"), result.value().fault});
    }
    return {};
}

Status ReplayRun::finish()
{
    if (m_writer) {
        if (Status status = m_writer->finish(); !status.isOk()) {
            return status;
        }
        m_writer.reset();
    }
    if (m_csv) {
        if (Status status = m_csv->finish(); !status.isOk()) {
            return status;
        }
    }
    if (m_json) {
        m_json->write(m_summary->json());
        return m_json->finish();
    }
    return {};
}

} // namespace palpate::app
