// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Settings.h"

#include <palpate/igtl/Messages.h>

#include <cstdint>
#include <string>

namespace palpate::openigtlink {

/// Takes the poses of one tool from received messages: TRANSFORM, POSITION or an entry of TDATA. No I/O and no clock:
/// times are passed in.
class PoseStream
{
  public:
    enum class Outcome : std::uint8_t
    {
        Other,    ///< another type or another tool
        Pose,     ///< `pose` is new
        Repeated, ///< the time stamp is that of the previous pose: the sender measured nothing new
        Refused,  ///< invalid content, or no rigid matrix; `problem` gives the reason
    };

    explicit PoseStream(const Settings& settings)
        : m_settings(settings)
        , m_tool(settings.tool)
    {
    }

    /// Forgets all poses.
    void reset();
    /// Without a tool in the settings, the first one counts until it is silent for `staleAfter_s`; names that Palpate
    /// itself shares are left out.
    Outcome take(const igtl::Message& message, std::int64_t now_ns);
    [[nodiscard]] const igtl::Pose& pose() const noexcept { return m_pose; } ///< in LPS [mm]
    [[nodiscard]] const std::string& tool() const noexcept { return m_tool; }
    [[nodiscard]] const std::string& problem() const noexcept { return m_problem; }
    /// Mean interval between the latest poses; 0: fewer than two. [ns]
    [[nodiscard]] std::int64_t interval_ns() const noexcept { return m_interval_ns; }

  private:
    [[nodiscard]] bool isWanted(const std::string& name, std::int64_t now_ns) const;
    Outcome takeMatrix(const std::string& name, const igtl::WireMatrix& transform, std::uint64_t timestamp,
                       std::int64_t now_ns);
    Outcome takePose(const std::string& name, const igtl::Pose& pose, std::uint64_t timestamp, std::int64_t now_ns);
    Outcome refuse(const core::Status& status);

    const Settings& m_settings;
    std::string m_tool; ///< empty: any
    igtl::Pose m_pose;
    std::string m_problem;
    std::uint64_t m_timestamp = 0;
    std::int64_t m_time_ns = 0; ///< of the last pose
    std::int64_t m_interval_ns = 0;
};

/// Consequences of this rate for touch, for the user. @param hasForce  the force goes back to the sender
[[nodiscard]] std::string feelText(double rate_Hz, bool hasForce);

} // namespace palpate::openigtlink
