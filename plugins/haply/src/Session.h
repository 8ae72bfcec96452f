// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Messages.h"
#include "Models.h"
#include "WebSocket.h"

#include <palpate/device/DevicePlugin.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate::haply {

/// Connection to the Inverse Service, with its version and its devices.
struct Service
{
    WebSocket socket;
    Version version;
    Inventory inventory;

    /// Connects. Without a service this takes no longer than the system needs to refuse a connection.
    /// @return NotFound: no service; Mismatch: another program; Unsupported: another version
    [[nodiscard]] static core::Result<Service> connect(const Settings& settings);
};

/// Lists the devices of the service. Empty without a service, unless the user's settings name one.
[[nodiscard]] std::vector<device::FoundDevice> listDevices(const Settings& settings);

/// Session that drives one device. Forces of all sessions add up in the service, so that a device is driven by one
/// session of this process at most.
/// @par Thread One at a time.
class Session
{
  public:
    /// @param deviceId  empty: the only device
    [[nodiscard]] static core::Result<std::unique_ptr<Session>> open(const Settings& settings,
                                                                     const std::string& deviceId);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    [[nodiscard]] const std::string& deviceId() const noexcept { return m_deviceId; }
    [[nodiscard]] const std::string& type() const noexcept { return m_type; }
    [[nodiscard]] const Model& model() const noexcept { return m_model; }
    [[nodiscard]] bool hasGrip() const noexcept { return !m_gripId.empty(); }
    /// Several grips are connected and none was chosen.
    [[nodiscard]] bool isGripUndecided() const noexcept { return m_isGripUndecided; }
    /// Another program was driving the device when this session began.
    [[nodiscard]] bool isShared() const noexcept { return m_isShared; }

    /// Begins with default axes and zero force, and asks for a full message.
    void begin();
    /// Sends a force [N, service's axes]. @return false: not sent
    bool push(const core::Vec3& f_N);
    /// Asks for a full message. @return false: not sent
    bool askForAll();
    /// Drives zero, and waits at most 20 ms for the service to take it.
    void letGo() noexcept;
    /// Uses the other name of the force vector from now on.
    void switchKey() noexcept;

    /// Messages sent and not answered yet.
    [[nodiscard]] std::size_t unanswered() const noexcept { return m_unanswered; }
    [[nodiscard]] std::int64_t lastSent_ns() const noexcept { return m_lastSent_ns; }

    enum class Received : std::uint8_t
    {
        Nothing, ///< until the deadline
        State,
        Other, ///< a message without a state of this device, or an invalid one
        Refused,
        Closed,
    };
    /// Waits for a message.
    /// @param asked_ns  when the answered message was sent, which is before the state was measured
    [[nodiscard]] Received receive(Update& update, std::int64_t& asked_ns, std::int64_t deadline_ns);

  private:
    Session(Service service, const Inventory::Device& device, const Settings& settings);
    bool send(std::string_view text);

    static constexpr std::size_t kMostUnanswered = 4;

    WebSocket m_socket;
    std::string m_deviceId;
    std::string m_type;
    std::string m_gripId;
    Model m_model;
    ForceKey m_key;
    bool m_isCentred;
    bool m_isShared;
    bool m_isGripUndecided = false;
    bool m_isDriving = false;                              ///< between `begin` and `letGo`
    std::array<std::int64_t, kMostUnanswered> m_sent_ns{}; ///< oldest first
    std::size_t m_unanswered = 0;
    std::int64_t m_lastSent_ns = 0;
};

} // namespace palpate::haply
