// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/igtl/Wire.h"

#include <palpate/core/Status.h>
#include <palpate/core/Types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::igtl {

using core::Vec3;

// Contents of the messages. Functions named encode… return a content for `encodeMessage`; functions named decode…
// compare every size and count with the content before they read or allocate, and return BadFormat with the type, the
// value found and the value expected. Positions are in mm, in the frame of the peer, by custom RAS.

/// Position and orientation.
struct Pose
{
    Vec3 p_mm = Vec3::Zero();
    core::Quaternion q = core::Quaternion::Identity(); ///< unit quaternion
};

/// Converts a pose from RAS to LPS, or back: negates x and y, and turns the orientation with them, so that the identity
/// remains the identity.
[[nodiscard]] Pose toggleRas(const Pose& pose) noexcept;

/// Matrix of a TRANSFORM or TDATA, not checked.
struct WireMatrix
{
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    Vec3 t_mm = Vec3::Zero();
};

/// Coordinates beyond this are refused. [mm]
inline constexpr double kMaxCoordinate_mm = 1e6;

/// @return the pose of a finite, rigid, right-handed matrix within `kMaxCoordinate_mm`; nothing if the matrix is
/// singular, scaled by more than 0.1 % or mirrored, because the frame of the peer is then another one than expected
[[nodiscard]] std::optional<Pose> poseOf(const WireMatrix& transform) noexcept;
/// @return the matrix of a pose
[[nodiscard]] WireMatrix transformOf(const Pose& pose) noexcept;

[[nodiscard]] Bytes encodeTransform(const WireMatrix& transform);
[[nodiscard]] core::Result<WireMatrix> decodeTransform(ByteView content);

[[nodiscard]] Bytes encodePosition(const Pose& pose);
/// Some senders omit the orientation (12 bytes); a quaternion that cannot be normalised is refused.
[[nodiscard]] core::Result<Pose> decodePosition(ByteView content);

/// Entry of TDATA.
struct TrackedTool
{
    std::string name;
    std::uint8_t type = 2; ///< 1 tracker, 2 instrument with 6, 3 with 3, 4 with 5 degrees of freedom
    WireMatrix transform;
};
[[nodiscard]] Bytes encodeTrackingData(const std::vector<TrackedTool>& tools);
[[nodiscard]] core::Result<std::vector<TrackedTool>> decodeTrackingData(ByteView content);

/// Content of STATUS.
struct DeviceStatus
{
    std::uint16_t code = 1; ///< 1 OK, 7 timeout, 13 not ready, 16 not present, 18 hardware failure, 19 exiting
    std::int64_t subcode = 0;
    std::string error; ///< name of the error; at most 20 bytes
    std::string text;
};
[[nodiscard]] Bytes encodeStatus(const DeviceStatus& status);
[[nodiscard]] core::Result<DeviceStatus> decodeStatus(ByteView content);

/// Longest text of a STRING. [bytes]
inline constexpr std::size_t kMaxText_bytes = 65535;
/// @param text  US-ASCII or UTF-8; cut at `kMaxText_bytes`
[[nodiscard]] Bytes encodeString(std::string_view text);
[[nodiscard]] core::Result<std::string> decodeString(ByteView content);

/// Content of SENSOR.
struct SensorReading
{
    std::uint64_t unit = 0; ///< bit fields of the protocol's unit page; 0: none
    std::vector<double> values;
};
/// @pre at most 255 values
[[nodiscard]] Bytes encodeSensor(const SensorReading& reading);
[[nodiscard]] core::Result<SensorReading> decodeSensor(ByteView content);

/// Content of STT_TDATA: the request to send tracking data.
struct TrackingRequest
{
    std::uint32_t interval_ms = 0; ///< least time between two frames; 0: as fast as possible
    std::string frame;             ///< coordinate system; empty: default. At most 32 bytes
};
[[nodiscard]] Bytes encodeTrackingRequest(const TrackingRequest& request);
/// Accepts content without a frame.
[[nodiscard]] core::Result<TrackingRequest> decodeTrackingRequest(ByteView content);

/// Query by the prefix of its type.
enum class QueryKind : std::uint8_t
{
    Get,
    Start,
    Stop,
    Answer, ///< RTS_
};
struct Query
{
    QueryKind kind = QueryKind::Get;
    std::string type; ///< "TDATA"; "TRANSFORM" also for the shortened names on the wire
};
/// @return the query of a message type such as "STT_TDATA"; nothing for other types. Of GET_TRANSFORM, the twelve bytes
/// of a type hold "GET_TRANSFOR", and the reference library writes "GET_TRANS".
[[nodiscard]] std::optional<Query> queryOf(std::string_view type);

} // namespace palpate::igtl
