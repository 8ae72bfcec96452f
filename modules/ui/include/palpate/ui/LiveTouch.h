// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <palpate/core/Export.h>
#include <palpate/device/PointerDevice.h>
#include <palpate/session/LiveSession.h>

#include <QObject>
#include <QTimer>

#include <filesystem>
#include <memory>
#include <string>

namespace palpate::ui {

/// Live touch session: device, servo loop and recorder. Builds the haptic scene from the structure table and passes a
/// new scene to the servo loop after each change.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT LiveTouch : public QObject
{
    Q_OBJECT
  public:
    /// @param model  must outlive this object
    explicit LiveTouch(StructureModel& model, QObject* parent = nullptr);
    ~LiveTouch() override;

    /// Starts the servo thread unless already running. If an external device fails to start, the pointer is started
    /// instead and the device's error is returned.
    core::Status start();
    /// Switches to another device; null: the pointer. Fails while a recording runs; otherwise as `start`.
    core::Status useDevice(std::unique_ptr<device::HapticDevice> device);
    [[nodiscard]] bool usesPointer() const noexcept { return m_device == nullptr; }
    /// The device, for other uses between `stop` and `start`; null: the pointer.
    [[nodiscard]] device::HapticDevice* device() noexcept { return m_device.get(); }
    [[nodiscard]] device::DeviceReport deviceReport() const;
    core::Status calibrate();
    /// Restores the force after a fault with a ramp.
    void rearm() { m_session.loop().rearm(); }
    void stop();
    [[nodiscard]] device::PointerDevice& pointer() noexcept { return m_pointer; }
    [[nodiscard]] const device::DeviceInfo& deviceInfo() const noexcept { return m_info; }
    /// Upper bound of the tissue parameters that the device renders stably at the servo rate, in scene units.
    [[nodiscard]] haptics::Tissue maxTissue() const;
    /// Stiffness of that bound; infinite for a device without motors. [N/mm]
    [[nodiscard]] double heldStiffness_N_per_mm() const;
    /// Delay of the device's force in ticks: the slowest since the device was started.
    [[nodiscard]] int delayTicks() const noexcept { return m_delayTicks; }
    /// Explanation of `maxTissue` for the user: device, limit, cause of the limit and remedy.
    [[nodiscard]] QString limitText() const;
    /// Sets the map from the device's workspace to the scene.
    void setMap(const servo::MapSettings& map);
    [[nodiscard]] const servo::MapSettings& map() const noexcept { return m_map; }
    /// Sets the radius of the probe sphere from the next tick on; 0: a point. [mm]
    void setFingertip(double radius_mm);
    /// The scene that was last passed to the servo loop; null before the first.
    [[nodiscard]] const std::shared_ptr<const haptics::HapticScene>& scene() const noexcept { return m_scene; }
    [[nodiscard]] double fingertip_mm() const noexcept { return m_fingertip_mm; }

    /// Lets the hand touch another scene, such as the wall of a threshold series, instead of the open one; null:
    /// returns to the open scene. Panels and view show no hand meanwhile. Fails while a recording runs.
    core::Status lend(std::shared_ptr<const haptics::HapticScene> scene);
    [[nodiscard]] bool isLent() const noexcept { return m_isLent; }

    /// Copies the newest tick to `tick`. Returns false when no tick has arrived since the previous call.
    bool fetch(servo::TickRecord& tick);
    /// The tick of the last successful `fetch`, by any caller.
    [[nodiscard]] const servo::TickRecord& newest() const noexcept { return m_newest; }
    /// Time of the newest tick, at which its moving tissue is. [s]
    [[nodiscard]] double time_s() const { return timeOf_s(m_newest); }
    /// Time of a tick of the running loop. [s]
    [[nodiscard]] double timeOf_s(const servo::TickRecord& tick) const
    {
        return static_cast<double>(tick.tick) * (1.0 / rate_Hz());
    }
    [[nodiscard]] servo::TimingReport timing() const { return m_session.loop().timing(); }
    /// Rate of the running loop, or of the next start. [Hz]
    [[nodiscard]] double rate_Hz() const;
    /// CPU reserved for the loop; -1: any.
    [[nodiscard]] int cpu() const noexcept { return m_options.cpu; }
    /// Sets rate and CPU of the loop. When a value changes, a running loop restarts while the device stays open. Fails
    /// while a recording runs, when `servo::checkCpu` rejects the CPU, or as `start`.
    core::Status setLoop(double rate_Hz, int cpu);
    /// Sets whether the loop locks the memory of the whole program, from the next start; off by default. See
    /// `servo::makeThreadRealtime`.
    void setLocksMemory(bool locks) noexcept { m_options.lockMemory = locks; }
    /// Measured tick rate over the last half second. [Hz]
    [[nodiscard]] double measuredRate_Hz() const noexcept { return m_rate_Hz; }
    [[nodiscard]] servo::RealtimeReport realtime() const { return m_session.loop().realtime(); }
    [[nodiscard]] bool isRunning() const noexcept { return m_session.loop().isRunning(); }

    /// Starts a recording.
    /// @param scene  file that was opened; empty for several files
    /// @param embeds  also stores the surfaces in the recording
    core::Status startRecording(const std::filesystem::path& path, const std::filesystem::path& scene = {},
                                bool embeds = false);
    /// Adds an event to the recording at the current tick. No effect without a recording. @param json  a JSON object
    void note(const std::string& kind, const std::string& json) { m_session.note(kind, json); }
    /// Ends the recording. An error lists lost data.
    core::Status stopRecording();
    [[nodiscard]] session::RecorderStatus recording() const { return m_session.recording(); }

  Q_SIGNALS:
    /// Emitted after a new scene was passed on, or after a change of device, rate, delay or scale.
    void handedOver();
    /// Emitted twice a second to refresh rate, timing and recording status.
    void statusChanged();
    /// Emitted when the servo loop cut the force. @param line  cause and remedy, for the user
    void faulted(const QString& line);
    void deviceChanged();
    /// Emitted when `maxTissue` changed.
    void greatestChanged();
    /// Emitted when a structure is stiffer than the device can render and is therefore softened. @param line  structure
    /// and applied limit
    void stiffnessRefused(const QString& line);

  private:
    void handOverScene();
    void carryMotions();
    void reportSoftenedStructure();
    void measure();
    void setDelay(int ticks);

    StructureModel& m_model;
    device::PointerDevice m_pointer;
    std::unique_ptr<device::HapticDevice> m_device; ///< null: the pointer
    device::DeviceInfo m_info;
    session::LiveSession m_session;
    std::shared_ptr<const haptics::HapticScene> m_scene;
    QTimer m_meter;
    QTimer m_handOver;     ///< coalesces the changes of one event into one new scene
    bool m_isLent = false; ///< the hand touches a scene of `lend`
    double m_fingertip_mm = 0.0;
    servo::ServoOptions m_options;
    std::uint64_t m_ticks = 0;
    std::int64_t m_measured_ns = 0;
    double m_rate_Hz = 0.0;
    int m_delayTicks = 1;
    servo::MapSettings m_map;
    servo::TickRecord m_newest;
    QString m_refused; ///< last message of `stiffnessRefused`
};

} // namespace palpate::ui
