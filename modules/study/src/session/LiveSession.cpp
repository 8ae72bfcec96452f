// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/LiveSession.h"

#include "palpate/study/RecordedScene.h"

#include <utility>

namespace palpate::study {

using core::Status;
using core::StatusCode;

session::SceneRecord LiveSession::sceneRecord() const
{
    if (m_scene == nullptr) {
        return {};
    }
    session::SceneRecord record = session::describeScene(m_generation, *m_scene, m_sources);
    for (session::StructureRecord& structure : record.structures) {
        structure.source.embed = m_embeds ? structure.source.embed : nullptr;
    }
    return record;
}

void LiveSession::setScene(std::shared_ptr<const haptics::HapticScene> scene,
                           std::vector<session::StructureSource> sources)
{
    m_scene = std::move(scene);
    m_sources = std::move(sources);
    m_generation = m_loop.setScene(m_scene);
    if (m_recorder.status().isRecording) {
        m_recorder.addScene(sceneRecord());
    }
}

Status LiveSession::start(device::HapticDevice& device, const servo::ServoOptions& options)
{
    m_device = device.info();
    return m_loop.start(device, options);
}

void LiveSession::stop()
{
    if (m_recorder.status().isRecording) {
        (void)m_recorder.stop(); // no caller left to receive an error
    }
    m_loop.stop();
}

Status LiveSession::startRecording(const std::filesystem::path& path, const std::filesystem::path& scene, bool embeds,
                                   std::string looks)
{
    m_embeds = embeds;
    session::RecordingInfo info;
    info.looks = std::move(looks);
    setSceneSource(info, scene, path);
    info.device = m_device;
    return m_recorder.start(path, info, sceneRecord());
}

core::Result<servo::RecordingStart> LiveSession::takeTicks()
{
    const auto start = session::beginRecording(m_loop);
    return start ? core::Result<servo::RecordingStart>(*start)
                 : Status(StatusCode::Internal, PALPATE_TEXT("the servo thread does not answer"));
}

} // namespace palpate::study
