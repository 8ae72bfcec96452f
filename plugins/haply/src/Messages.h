// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Messages of the Inverse Service, versions 3.1 to 3.x: JSON objects in text messages. Metres, newtons, and the axes
/// x right, y away from the user, z up.
/// @par Source Pages of 3.1 and 3.5 at docs.haply.co/inverseSDK, compared with the clients of IsaacLab, ROS and SOFA
namespace palpate::haply {

/// Version of the service; 0.0: unknown.
struct Version
{
    int major = 0;
    int minor = 0;
};

/// Reads the answer to `GET /version`. @return nothing: not an answer of the service
[[nodiscard]] std::optional<Version> readVersion(std::string_view json);

/// Name of the force vector in a command. A service ignores the other name without an error.
enum class ForceKey : std::uint8_t
{
    Values, ///< 3.1 to 3.4
    Vector, ///< 3.5
};

/// Condition of a device, as reported by the service.
struct DeviceStatus
{
    bool hasPower = true;
    bool isCalibrated = true;
    bool isReady = true;
    bool isInUse = false;
};

/// Devices in a full message.
struct Inventory
{
    struct Device
    {
        std::string id;   ///< "049D"
        std::string type; ///< "inverse3"; empty: not stated
        DeviceStatus status;
    };
    std::vector<Device> devices;
    std::vector<std::string> grips; ///< identifiers of all VerseGrips
    bool isNew = false;             ///< has fields that versions before 3.5 lack
};

/// @return nothing: not a message of the service
[[nodiscard]] std::optional<Inventory> readInventory(std::string_view json);

/// Axes of positions and forces, as stated by a message.
enum class Axes : std::uint8_t
{
    Unstated,
    Default, ///< x right, y away from the user, z up, in metres
    Other,   ///< turned, scaled or moved
};

/// State of one device and the grip in the same hand.
struct Update
{
    core::Vec3 p_m = core::Vec3::Zero();
    std::optional<core::Vec3> f_N; ///< force that the service drives
    DeviceStatus status;
    Axes axes = Axes::Unstated;
    std::optional<core::Quaternion> q; ///< orientation of the grip
    std::optional<std::uint32_t> buttons;
};

enum class Reading : std::uint8_t
{
    Valid,
    Absent,  ///< a message without this device
    Refused, ///< not a message of the service, or a number that no device can have
};

/// Reads the state of a device.
/// @param gripId  empty: no grip
/// @param isCentred  the origin was moved to the centre of the workspace on request, which is not another axis
/// @param update  changed only if the result is Valid
[[nodiscard]] Reading readUpdate(std::string_view json, std::string_view deviceId, std::string_view gripId,
                                 bool isCentred, Update& update);

/// Command to drive a force, which each tick repeats.
[[nodiscard]] std::string forceCommand(std::string_view deviceId, const core::Vec3& f_N, ForceKey key);
/// First message of a session: name, default axes, zero force.
/// @param isCentred  asks for the origin in the centre of the workspace instead of the mounting plate
[[nodiscard]] std::string firstCommand(std::string_view deviceId, ForceKey key, bool isCentred);
/// Asks for a full message.
[[nodiscard]] std::string fullStateRequest();

} // namespace palpate::haply
