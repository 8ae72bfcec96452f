// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <palpate/device/PointerDevice.h>
#include <palpate/study/LiveSession.h>

#include <QObject>
#include <QTimer>

#include <filesystem>
#include <memory>
#include <string>

namespace palpate::ui {

/// The running touch: device, servo loop and recorder, fed with what the structure table says can be felt.
class LiveTouch : public QObject
{
    Q_OBJECT
  public:
    /// @param model  must outlive this
    explicit LiveTouch(StructureModel& model, QObject* parent = nullptr);
    ~LiveTouch() override;

    /// Starts the servo thread if it does not run. When another device than the pointer does not start, the pointer is
    /// used and the reason returned.
    core::Status start();
    /// Takes another device for the hand; null: the pointer. Refused while a recording runs. On failure as `start`.
    core::Status useDevice(std::unique_ptr<device::HapticDevice> device);
    [[nodiscard]] bool usesPointer() const noexcept { return m_device == nullptr; }
    [[nodiscard]] device::DeviceReport deviceReport() const;
    core::Status calibrate();
    /// Gives the force back after a fault, eased in.
    void rearm() { m_session.loop().rearm(); }
    void stop();
    [[nodiscard]] device::PointerDevice& pointer() noexcept { return m_pointer; }
    [[nodiscard]] const device::DeviceInfo& deviceInfo() const noexcept { return m_info; }
    /// What is felt of a tissue at most: what the device holds stably at its rate, in the scene's lengths.
    [[nodiscard]] haptics::Tissue greatestTissue() const;
    /// The stiffness alone; infinite for a device without motors. [N/mm]
    [[nodiscard]] double heldStiffness_N_per_mm() const;
    /// Ticks after which the device's force acts: the slowest measured since it was started.
    [[nodiscard]] int delayTicks() const noexcept { return m_delayTicks; }
    /// Why no more than `greatestTissue` is felt, for a person: the device, its limit, what sets it, what to do.
    [[nodiscard]] QString limitText() const;
    /// Lays the device's workspace into the scene.
    void setMap(const servo::MapSettings& map);
    [[nodiscard]] const servo::MapSettings& map() const noexcept { return m_map; }
    /// Touches with a ball of this radius from the next tick on; 0 = a point. [mm]
    void setFingertip(double radius_mm);
    /// What can be touched, as handed over last; null before that.
    [[nodiscard]] const std::shared_ptr<const haptics::HapticScene>& scene() const noexcept { return m_scene; }
    [[nodiscard]] double fingertip_mm() const noexcept { return m_fingertip_mm; }

    /// @return true when a tick newer than the last one fetched was written to `tick`.
    bool fetch(servo::TickRecord& tick);
    /// The tick last fetched by anyone.
    [[nodiscard]] const servo::TickRecord& newest() const noexcept { return m_newest; }
    [[nodiscard]] servo::TimingReport timing() const { return m_session.loop().timing(); }
    /// Of the running loop, or of the one to come. [Hz]
    [[nodiscard]] double rate_Hz() const;
    /// CPU that the loop runs on alone; -1: on any.
    [[nodiscard]] int cpu() const noexcept { return m_options.cpu; }
    /// Runs the loop at a rate and on a CPU: a running one begins anew, with the device kept open, when one of them is
    /// another. Refused while a recording runs, and by `servo::checkCpu`. On failure as `start`.
    core::Status setLoop(double rate_Hz, int cpu);
    /// Ticks per second over the last half second. [Hz]
    [[nodiscard]] double measuredRate_Hz() const noexcept { return m_rate_Hz; }
    [[nodiscard]] servo::RealtimeReport realtime() const { return m_session.loop().realtime(); }
    [[nodiscard]] bool isRunning() const noexcept { return m_session.loop().isRunning(); }

    /// @param scene   file that was opened; empty when it is several
    /// @param embeds  put the surfaces into the recording too
    core::Status startRecording(const std::filesystem::path& path, const std::filesystem::path& scene = {},
                                bool embeds = false);
    /// Notes something in the recording, at this tick; nothing when there is none. @param json  an object
    void note(const std::string& kind, const std::string& json) { m_session.note(kind, json); }
    /// @return what was lost, if anything
    core::Status stopRecording();
    [[nodiscard]] session::RecorderStatus recording() const { return m_session.recording(); }

  Q_SIGNALS:
    /// `scene` is another one, or is felt with another device, rate, delay or scale.
    void handedOver();
    /// Twice a second: rate, timing and recording are worth showing anew.
    void statusChanged();
    /// The servo took the force away. @param line  what happened and what to do
    void faulted(const QString& line);
    void deviceChanged();
    /// `greatestTissue` is another one.
    void greatestChanged();
    /// A structure is to be stiffer than the device holds, and is felt softer. @param line  which and what is done
    void stiffnessRefused(const QString& line);

  private:
    void handOverScene();
    void tellRefused();
    void measure();
    void setDelay(int ticks);

    StructureModel& m_model;
    device::PointerDevice m_pointer;
    std::unique_ptr<device::HapticDevice> m_device; ///< null: the pointer
    device::DeviceInfo m_info;
    study::LiveSession m_session;
    std::shared_ptr<const haptics::HapticScene> m_scene;
    QTimer m_meter;
    QTimer m_handOver; ///< gathers changes of one event into one new scene
    double m_fingertip_mm = 0.0;
    servo::ServoOptions m_options;
    std::uint64_t m_ticks = 0;
    std::int64_t m_measured_ns = 0;
    double m_rate_Hz = 0.0;
    int m_delayTicks = 1;
    bool m_wasFaulted = false;
    servo::MapSettings m_map;
    servo::TickRecord m_newest;
    QString m_refused; ///< said last
};

} // namespace palpate::ui
