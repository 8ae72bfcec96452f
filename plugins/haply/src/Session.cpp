// SPDX-License-Identifier: BSD-3-Clause
#include "Session.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <set>
#include <utility>

namespace palpate::haply {

using core::Status;
using core::StatusCode;

namespace {

constexpr std::int64_t kConnectWithin_ns = 250'000'000;
constexpr std::int64_t kInventoryWithin_ns = 500'000'000;
constexpr std::int64_t kVersionWithin_ns = 250'000'000;
constexpr std::int64_t kGoodbyeWithin_ns = 20'000'000;
constexpr int kMajorVersion = 3;
constexpr int kOldestMinor = 1;
constexpr int kVectorMinor = 5; // from here on, the force is named "vector"

/// Devices that sessions of this process drive.
class Claims
{
  public:
    bool take(const std::string& id)
    {
        const std::lock_guard lock(m_mutex);
        return m_ids.insert(id).second;
    }
    void giveBack(const std::string& id) noexcept
    {
        const std::lock_guard lock(m_mutex);
        m_ids.erase(id);
    }

  private:
    std::mutex m_mutex;
    std::set<std::string> m_ids;
};

Claims& claims()
{
    static Claims all;
    return all;
}

/// Reads the version over HTTP. @return 0.0: no answer, as where the owner has moved the port
Version versionOf(const Settings& settings)
{
    for (const std::uint16_t port : {settings.port, settings.httpPort}) {
        const auto page = httpGet(port, "/version", core::monotonicNow_ns() + kVersionWithin_ns);
        const auto version = page ? readVersion(*page) : std::nullopt;
        if (version) {
            return *version;
        }
    }
    return {};
}

std::string nameOf(const Inventory::Device& device)
{
    return modelOf(device.type).name + " " + device.id;
}

} // namespace

core::Result<Service> Service::connect(const Settings& settings)
{
    const std::int64_t begin_ns = core::monotonicNow_ns();
    auto opened = WebSocket::open(settings.port, begin_ns + kConnectWithin_ns);
    if (!opened.isOk()) {
        return opened.status();
    }
    WebSocket socket = std::move(opened).value();
    std::string_view text;
    std::optional<Inventory> inventory;
    if (socket.receive(text, begin_ns + kInventoryWithin_ns) == WebSocket::Received::Text) {
        inventory = readInventory(text);
    }
    const Version version = versionOf(settings);
    if (version.major != 0 && (version.major != kMajorVersion || version.minor < kOldestMinor)) {
        return Status(StatusCode::Unsupported,
                      PALPATE_TEXT("haply: found version %1.%2 of the Inverse Service, expected 3.1 to 3.x; install "
                                   "version 3.5 with Haply Hub"),
                      version.major, version.minor);
    }
    if (!inventory) {
        return Status(
            StatusCode::Mismatch,
            PALPATE_TEXT("haply: the program at port %1 sends no list of devices as the Inverse Service does; "
                         "set \"port\" in ~/.config/Palpate/haply.json to the service's websocket port"),
            static_cast<int>(settings.port));
    }
    return Service{std::move(socket), version, *std::move(inventory)};
}

std::vector<device::FoundDevice> listDevices(const Settings& settings)
{
    const auto service = Service::connect(settings);
    if (!service.isOk()) {
        // Another program may listen at the port of a service that is not there.
        const bool isExpected = settings.hasFile || service.status().code() == StatusCode::Unsupported;
        return isExpected ? std::vector<device::FoundDevice>{{"Haply", "", service.status().message()}}
                          : std::vector<device::FoundDevice>();
    }
    std::vector<device::FoundDevice> found;
    for (const Inventory::Device& device : service.value().inventory.devices) {
        found.push_back({nameOf(device), device.id, ""});
    }
    return found;
}

core::Result<std::unique_ptr<Session>> Session::open(const Settings& settings, const std::string& deviceId)
{
    auto connected = Service::connect(settings);
    if (!connected.isOk()) {
        return connected.status();
    }
    Service service = std::move(connected).value();
    const std::vector<Inventory::Device>& there = service.inventory.devices;
    if (there.empty()) {
        return Status(StatusCode::NotFound, PALPATE_TEXT("haply: the Inverse Service has no device: connect its USB "
                                                         "cable and its power supply, and switch it on"));
    }
    if (deviceId.empty() && there.size() > 1) {
        return Status(StatusCode::NotFound,
                      PALPATE_TEXT("haply: %1 devices are connected, expected one: choose by \"device_id\" in "
                                   "~/.config/Palpate/haply.json; \"palpate devices\" lists the identifiers"),
                      there.size());
    }
    const auto chosen = std::find_if(there.begin(), there.end(), [&deviceId](const Inventory::Device& device) {
        return deviceId.empty() || device.id == deviceId;
    });
    if (chosen == there.end()) {
        return Status(StatusCode::NotFound,
                      PALPATE_TEXT("haply: found no device %1, but %2; \"palpate devices\" lists the identifiers"),
                      deviceId, there.front().id);
    }
    const Inventory::Device device = *chosen;
    if (!claims().take(device.id)) {
        return Status(StatusCode::NotFound, PALPATE_TEXT("haply: the device %1 is already in use by this program"),
                      device.id);
    }
    try {
        return std::unique_ptr<Session>(new Session(std::move(service), device, settings));
    } catch (const std::bad_alloc&) {
        claims().giveBack(device.id);
        throw;
    }
}

Session::Session(Service service, const Inventory::Device& device, const Settings& settings)
    : m_socket(std::move(service.socket))
    , m_deviceId(device.id)
    , m_type(device.type)
    , m_model(limited(modelOf(device.type), settings))
    , m_isShared(device.status.isInUse)
{
    const bool isNew = service.version.major != 0 ? service.version.minor >= kVectorMinor : service.inventory.isNew;
    m_key = isNew ? ForceKey::Vector : ForceKey::Values;
    m_isCentred = !m_model.isKnown;
    const std::vector<std::string>& grips = service.inventory.grips;
    if (!settings.gripId.empty()) {
        m_gripId = settings.gripId;
    } else if (grips.size() == 1) {
        m_gripId = grips.front();
    }
    m_isGripUndecided = m_gripId.empty() && grips.size() > 1;
}

Session::~Session()
{
    letGo();
    m_socket.sayGoodbye();
    claims().giveBack(m_deviceId);
}

bool Session::send(std::string_view text)
{
    if (m_unanswered == kMostUnanswered || !m_socket.send(text)) {
        return false;
    }
    m_lastSent_ns = core::monotonicNow_ns();
    m_sent_ns[m_unanswered++] = m_lastSent_ns;
    return true;
}

void Session::begin()
{
    m_isDriving = true;
    (void)send(firstCommand(m_deviceId, m_key, m_isCentred));
    (void)askForAll();
}

bool Session::push(const core::Vec3& f_N)
{
    return send(forceCommand(m_deviceId, f_N, m_key));
}

bool Session::askForAll()
{
    return send(fullStateRequest());
}

void Session::letGo() noexcept
{
    try {
        if (std::exchange(m_isDriving, false) && push(core::Vec3::Zero())) {
            Update ignored;
            std::int64_t asked_ns = 0;
            const std::int64_t until_ns = core::monotonicNow_ns() + kGoodbyeWithin_ns;
            while (m_unanswered > 0 && core::monotonicNow_ns() < until_ns &&
                   receive(ignored, asked_ns, until_ns) != Received::Closed) {
            }
        }
    } catch (const std::bad_alloc&) { // the end of the connection ends the session and its force
    }
}

void Session::switchKey() noexcept
{
    m_key = m_key == ForceKey::Vector ? ForceKey::Values : ForceKey::Vector;
}

Session::Received Session::receive(Update& update, std::int64_t& asked_ns, std::int64_t deadline_ns)
{
    std::string_view text;
    const WebSocket::Received received = m_socket.receive(text, deadline_ns);
    if (received == WebSocket::Received::Nothing || received == WebSocket::Received::Closed) {
        return received == WebSocket::Received::Nothing ? Received::Nothing : Received::Closed;
    }
    // A message that answers nothing is as old as the last question, or older.
    asked_ns = m_lastSent_ns;
    if (m_unanswered > 0) {
        asked_ns = m_sent_ns[0];
        std::shift_left(m_sent_ns.begin(), m_sent_ns.end(), 1);
        --m_unanswered;
    }
    if (received == WebSocket::Received::Other) {
        return Received::Refused;
    }
    switch (readUpdate(text, m_deviceId, m_gripId, m_isCentred, update)) {
    case Reading::Valid:
        return Received::State;
    case Reading::Absent:
        return Received::Other;
    case Reading::Refused:
        break;
    }
    return Received::Refused;
}

} // namespace palpate::haply
