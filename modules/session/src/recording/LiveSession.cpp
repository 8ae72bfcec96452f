// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/LiveSession.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <utility>

namespace palpate::session {

using core::Status;
using core::StatusCode;

SceneRecord LiveSession::sceneRecord() const
{
    if (m_scene == nullptr) {
        return {};
    }
    SceneRecord record = describeScene(m_generation, *m_scene, m_sources);
    for (StructureRecord& structure : record.structures) {
        structure.source.embed = m_embed == Embed::Yes ? structure.source.embed : nullptr;
    }
    return record;
}

Status LiveSession::checkEmbedded() const
{
    for (std::size_t i = 0; m_scene != nullptr && i < m_scene->structures().size(); ++i) {
        const haptics::HapticStructure& one = m_scene->structures()[i];
        if (one.surface != nullptr && (i >= m_sources.size() || m_sources[i].embed == nullptr)) {
            return {
                StatusCode::Mismatch,
                PALPATE_TEXT("structure %1 (%2) has no surface to embed; pass StructureSource::embed to setScene, or "
                             "record without surfaces"),
                i, one.name};
        }
    }
    return {};
}

Status LiveSession::setScene(std::shared_ptr<const haptics::HapticScene> scene, std::vector<StructureSource> sources)
{
    m_scene = std::move(scene);
    m_sources = std::move(sources);
    m_generation = m_loop.setScene(m_scene);
    if (!m_recorder.status().isRecording) {
        return {};
    }
    m_recorder.addScene(sceneRecord());
    return m_embed == Embed::Yes ? checkEmbedded() : Status();
}

Status LiveSession::start(device::HapticDevice& device, const servo::ServoOptions& options)
{
    m_device = device.info();
    m_faultTick = -1;
    return m_loop.start(device, options);
}

void LiveSession::stop()
{
    if (m_recorder.status().isRecording) {
        (void)m_recorder.stop(); // no caller left to receive an error
    }
    m_loop.stop();
}

Status LiveSession::startRecording(const std::filesystem::path& path, Embed embed, RecordingInfo info)
{
    if (Status status = embed == Embed::Yes ? checkEmbedded() : Status(); !status.isOk()) {
        return status.at(path);
    }
    m_embed = embed;
    info.device = m_device;
    return m_recorder.start(path, info, sceneRecord());
}

std::optional<servo::FaultReport> LiveSession::poll()
{
    m_loop.collect();
    servo::FaultReport fault = m_loop.fault();
    if (!fault.isFaulted() || fault.fault.tick == m_faultTick) {
        return std::nullopt;
    }
    m_faultTick = fault.fault.tick;
    const bool isLost =
        fault.fault.kind == servo::FaultKind::DeviceLost || fault.fault.kind == servo::FaultKind::StaleInput;
    const QJsonObject what{{"what", QString::fromStdString(fault.message.english())}};
    note(isLost ? "device-lost" : "fault", QJsonDocument(what).toJson(QJsonDocument::Compact).toStdString());
    return fault;
}

core::Result<servo::RecordingStart> LiveSession::takeTicks()
{
    const auto start = beginRecording(m_loop);
    return start ? core::Result<servo::RecordingStart>(*start)
                 : Status(StatusCode::Internal, PALPATE_TEXT("the servo thread does not answer"));
}

} // namespace palpate::session
