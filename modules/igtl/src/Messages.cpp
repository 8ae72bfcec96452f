// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/igtl/Messages.h"

#include <array>
#include <cmath>
#include <utility>

namespace palpate::igtl {

using core::Result;
using core::Status;
using core::StatusCode;

namespace {

constexpr std::size_t kTransform_bytes = 48;
constexpr std::size_t kPosition_bytes = 28;
constexpr std::size_t kPositionOnly_bytes = 12;
constexpr std::size_t kTool_bytes = 70;
constexpr std::size_t kStatus_bytes = 30;
constexpr std::size_t kSensor_bytes = 10;
constexpr std::size_t kFrameLength = 32;
constexpr std::uint16_t kUsAscii = 3; // MIBenum; the only encoding that peers set, also for UTF-8

Status wrongSize(const char* type, std::size_t found, std::size_t expected)
{
    return {StatusCode::BadFormat, PALPATE_TEXT("%1: found %2 bytes, expected %3"), type, core::Count(found),
            core::Count(expected)};
}

bool isInReach(const Vec3& p_mm) noexcept
{
    return p_mm.allFinite() && p_mm.cwiseAbs().maxCoeff() <= kMaxCoordinate_mm;
}

/// @pre 48 bytes are left.
WireMatrix readMatrix(FieldReader& fields)
{
    WireMatrix transform;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            transform.R(row, column) = static_cast<double>(fields.real32());
        }
    }
    for (int row = 0; row < 3; ++row) {
        transform.t_mm[row] = static_cast<double>(fields.real32());
    }
    return transform;
}

void writeMatrix(FieldWriter& fields, const WireMatrix& transform)
{
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            fields.real32(transform.R(row, column));
        }
    }
    for (int row = 0; row < 3; ++row) {
        fields.real32(transform.t_mm[row]);
    }
}

} // namespace

Pose toggleRas(const Pose& pose) noexcept
{
    // Conjugation with the half turn about z, diag(-1, -1, 1).
    return {Vec3(-pose.p_mm.x(), -pose.p_mm.y(), pose.p_mm.z()),
            core::Quaternion(pose.q.w(), -pose.q.x(), -pose.q.y(), pose.q.z())};
}

std::optional<Pose> poseOf(const WireMatrix& transform) noexcept
{
    constexpr double kTolerance = 2e-3; // of R^T R, so 0.1 % of a length; single precision needs 1e-6
    const Eigen::Matrix3d& R = transform.R;
    if (!R.allFinite() || !isInReach(transform.t_mm)) {
        return std::nullopt;
    }
    const Eigen::Matrix3d error = R.transpose() * R - Eigen::Matrix3d::Identity();
    if (error.cwiseAbs().maxCoeff() > kTolerance || R.col(0).cross(R.col(1)).dot(R.col(2)) <= 0.0) {
        return std::nullopt;
    }
    return Pose{transform.t_mm, core::Quaternion(R).normalized()};
}

WireMatrix transformOf(const Pose& pose) noexcept
{
    return {pose.q.toRotationMatrix(), pose.p_mm};
}

Bytes encodeTransform(const WireMatrix& transform)
{
    FieldWriter fields;
    writeMatrix(fields, transform);
    return std::move(fields).bytes();
}

Result<WireMatrix> decodeTransform(ByteView content)
{
    if (content.size() != kTransform_bytes) {
        return wrongSize("TRANSFORM", content.size(), kTransform_bytes);
    }
    FieldReader fields(content);
    return readMatrix(fields);
}

Bytes encodePosition(const Pose& pose)
{
    FieldWriter fields;
    for (const double number :
         {pose.p_mm.x(), pose.p_mm.y(), pose.p_mm.z(), pose.q.x(), pose.q.y(), pose.q.z(), pose.q.w()}) {
        fields.real32(number);
    }
    return std::move(fields).bytes();
}

Result<Pose> decodePosition(ByteView content)
{
    if (content.size() != kPosition_bytes && content.size() != kPositionOnly_bytes) {
        return wrongSize("POSITION", content.size(), kPosition_bytes);
    }
    FieldReader fields(content);
    Pose pose;
    for (int i = 0; i < 3; ++i) {
        pose.p_mm[i] = static_cast<double>(fields.real32());
    }
    if (fields.left() > 0) {
        for (int i = 0; i < 4; ++i) { // x, y, z, w, in the order of Eigen's coefficients
            pose.q.coeffs()[i] = static_cast<double>(fields.real32());
        }
    }
    constexpr double kTolerance = 0.01;
    if (!isInReach(pose.p_mm) || !(std::abs(pose.q.norm() - 1.0) <= kTolerance)) {
        return Status(StatusCode::BadFormat,
                      PALPATE_TEXT("POSITION: expected finite numbers within 1,000,000 mm and a unit quaternion"));
    }
    pose.q.normalize();
    return pose;
}

Bytes encodeTrackingData(const std::vector<TrackedTool>& tools)
{
    FieldWriter fields;
    for (const TrackedTool& tool : tools) {
        fields.text(tool.name, kNameLength);
        fields.number(tool.type, 1);
        fields.number(0, 1);
        writeMatrix(fields, tool.transform);
    }
    return std::move(fields).bytes();
}

Result<std::vector<TrackedTool>> decodeTrackingData(ByteView content)
{
    if (content.size() % kTool_bytes != 0) {
        return Status(StatusCode::BadFormat, PALPATE_TEXT("TDATA: found %1 bytes, expected a multiple of %2"),
                      core::Count(content.size()), core::Count(kTool_bytes));
    }
    FieldReader fields(content);
    std::vector<TrackedTool> tools(content.size() / kTool_bytes);
    for (TrackedTool& tool : tools) {
        tool.name = fields.text(kNameLength);
        tool.type = static_cast<std::uint8_t>(fields.number(1));
        fields.skip(1);
        tool.transform = readMatrix(fields);
    }
    return tools;
}

Bytes encodeStatus(const DeviceStatus& status)
{
    FieldWriter fields;
    fields.number(status.code, 2);
    fields.number(static_cast<std::uint64_t>(status.subcode), 8);
    fields.text(status.error, kNameLength);
    fields.text(status.text, status.text.size() + 1);
    return std::move(fields).bytes();
}

Result<DeviceStatus> decodeStatus(ByteView content)
{
    if (content.size() < kStatus_bytes) {
        return wrongSize("STATUS", content.size(), kStatus_bytes);
    }
    FieldReader fields(content);
    DeviceStatus status;
    status.code = static_cast<std::uint16_t>(fields.number(2));
    status.subcode = static_cast<std::int64_t>(fields.number(8));
    status.error = fields.text(kNameLength);
    status.text = fields.text(fields.left());
    return status;
}

Bytes encodeString(std::string_view text)
{
    text = text.substr(0, kMaxText_bytes);
    FieldWriter fields;
    fields.number(kUsAscii, 2);
    fields.number(text.size(), 2);
    fields.text(text, text.size());
    return std::move(fields).bytes();
}

Result<std::string> decodeString(ByteView content)
{
    constexpr std::size_t kFixed_bytes = 4;
    if (content.size() < kFixed_bytes) {
        return wrongSize("STRING", content.size(), kFixed_bytes);
    }
    FieldReader fields(content);
    fields.skip(2);
    const std::uint64_t length = fields.number(2);
    if (length != fields.left()) {
        return wrongSize("STRING", content.size(), kFixed_bytes + static_cast<std::size_t>(length));
    }
    return fields.text(fields.left());
}

Bytes encodeSensor(const SensorReading& reading)
{
    FieldWriter fields;
    fields.number(reading.values.size(), 1);
    fields.number(0, 1);
    fields.number(reading.unit, 8);
    for (const double value : reading.values) {
        fields.real64(value);
    }
    return std::move(fields).bytes();
}

Result<SensorReading> decodeSensor(ByteView content)
{
    if (content.size() < kSensor_bytes) {
        return wrongSize("SENSOR", content.size(), kSensor_bytes);
    }
    FieldReader fields(content);
    const auto count = static_cast<std::size_t>(fields.number(1));
    fields.skip(1);
    SensorReading reading;
    reading.unit = fields.number(8);
    if (fields.left() != count * sizeof(double)) {
        return wrongSize("SENSOR", content.size(), kSensor_bytes + count * sizeof(double));
    }
    reading.values.resize(count);
    for (double& value : reading.values) {
        value = fields.real64();
    }
    return reading;
}

Bytes encodeTrackingRequest(const TrackingRequest& request)
{
    FieldWriter fields;
    fields.number(request.interval_ms, 4);
    fields.text(request.frame, kFrameLength);
    return std::move(fields).bytes();
}

Result<TrackingRequest> decodeTrackingRequest(ByteView content)
{
    constexpr std::size_t kInterval_bytes = 4;
    if (content.size() != kInterval_bytes && content.size() != kInterval_bytes + kFrameLength) {
        return wrongSize("STT_TDATA", content.size(), kInterval_bytes + kFrameLength);
    }
    FieldReader fields(content);
    TrackingRequest request;
    request.interval_ms = static_cast<std::uint32_t>(fields.number(kInterval_bytes));
    request.frame = fields.text(fields.left());
    return request;
}

std::optional<Query> queryOf(std::string_view type)
{
    constexpr std::array<std::pair<std::string_view, QueryKind>, 4> kKinds{
        {{"GET_", QueryKind::Get}, {"STT_", QueryKind::Start}, {"STP_", QueryKind::Stop}, {"RTS_", QueryKind::Answer}}};
    for (const auto& [prefix, kind] : kKinds) {
        if (type.starts_with(prefix)) {
            const std::string_view rest = type.substr(prefix.size());
            const bool isTransform = rest == "TRANS" || rest == "TRANSFOR";
            return Query{kind, std::string(isTransform ? std::string_view("TRANSFORM") : rest)};
        }
    }
    return std::nullopt;
}

} // namespace palpate::igtl
