// SPDX-License-Identifier: BSD-3-Clause
#include "PoseStream.h"

#include <palpate/core/Text.h>
#include <palpate/igtl/ShareServer.h>

#include <algorithm>
#include <cmath>

namespace palpate::openigtlink {

using core::Status;
using core::StatusCode;

void PoseStream::reset()
{
    m_tool = m_settings.tool;
    m_pose = {};
    m_problem.clear();
    m_timestamp = 0;
    m_time_ns = 0;
    m_interval_ns = 0;
}

bool PoseStream::isWanted(const std::string& name, std::int64_t now_ns) const
{
    if (!m_settings.tool.empty()) {
        return name == m_settings.tool;
    }
    const bool isSilent = now_ns - m_time_ns > static_cast<std::int64_t>(m_settings.staleAfter_s * 1e9);
    return name == m_tool || ((m_tool.empty() || isSilent) && !name.starts_with(igtl::kOwnPrefix));
}

PoseStream::Outcome PoseStream::refuse(const Status& status)
{
    m_problem = status.message();
    return Outcome::Refused;
}

PoseStream::Outcome PoseStream::take(const igtl::Message& message, std::int64_t now_ns)
{
    const igtl::MessageHeader& header = message.header;
    if (header.type == "TDATA") {
        const auto tools = igtl::decodeTrackingData(message.content);
        if (!tools.isOk()) {
            return refuse(tools.status());
        }
        for (const igtl::TrackedTool& tool : tools.value()) {
            if (isWanted(tool.name, now_ns)) {
                return takeMatrix(tool.name, tool.transform, header.timestamp, now_ns);
            }
        }
        return Outcome::Other;
    }
    const bool isTransform = header.type == "TRANSFORM";
    if ((!isTransform && header.type != "POSITION") || !isWanted(header.name, now_ns)) {
        return Outcome::Other;
    }
    if (isTransform) {
        const auto transform = igtl::decodeTransform(message.content);
        return transform.isOk() ? takeMatrix(header.name, transform.value(), header.timestamp, now_ns)
                                : refuse(transform.status());
    }
    const auto pose = igtl::decodePosition(message.content);
    return pose.isOk() ? takePose(header.name, pose.value(), header.timestamp, now_ns) : refuse(pose.status());
}

PoseStream::Outcome PoseStream::takeMatrix(const std::string& name, const igtl::WireMatrix& transform,
                                           std::uint64_t timestamp, std::int64_t now_ns)
{
    const auto pose = igtl::poseOf(transform);
    if (!pose) {
        return refuse({StatusCode::BadFormat,
                       PALPATE_TEXT("%1: found a matrix that is singular, scaled, mirrored or out of reach, expected "
                                    "a rotation and a position in mm"),
                       core::inQuotes(name)});
    }
    return takePose(name, *pose, timestamp, now_ns);
}

PoseStream::Outcome PoseStream::takePose(const std::string& name, const igtl::Pose& pose, std::uint64_t timestamp,
                                         std::int64_t now_ns)
{
    // Time stamps come from another clock, which may be wrong or set back, so only equality counts.
    if (timestamp != 0 && timestamp == m_timestamp && name == m_tool) {
        return Outcome::Repeated;
    }
    constexpr std::int64_t kPause_ns = 1'000'000'000;
    constexpr std::int64_t kMean = 8; // of about so many intervals
    const std::int64_t passed_ns = now_ns - m_time_ns;
    if (name != m_tool || m_time_ns == 0 || passed_ns > kPause_ns) {
        m_interval_ns = 0;
    } else {
        m_interval_ns = m_interval_ns == 0 ? passed_ns : m_interval_ns + (passed_ns - m_interval_ns) / kMean;
    }
    m_tool = name;
    m_timestamp = timestamp;
    m_time_ns = now_ns;
    m_pose = m_settings.isRas ? igtl::toggleRas(pose) : pose;
    return Outcome::Pose;
}

std::string feelText(double rate_Hz, bool hasForce)
{
    constexpr double kHard_Hz = 500.0; // from here on as with other devices
    constexpr double kSoft_Hz = 15.0;
    const std::string rate = core::grouped(std::lround(rate_Hz));
    const std::string lag = core::grouped(std::lround(1000.0 / std::max(rate_Hz, 1.0)));
    if (!hasForce) {
        return rate + " positions a second; the hand lags by at least " + lag +
               " ms. The force is displayed, not felt.";
    }
    if (rate_Hz < kSoft_Hz) {
        return rate + " positions a second: too few to feel a force. Ask the sender for 20 or more.";
    }
    if (rate_Hz < kHard_Hz) {
        return rate + " positions a second; the force lags by at least " + lag +
               " ms. Shape and soft tissue can be felt, hard contact, edges and vibration cannot.";
    }
    return rate + " positions a second.";
}

} // namespace palpate::openigtlink
