// SPDX-License-Identifier: BSD-3-Clause
#include "Driver.h"

#include <palpate/core/Clock.h>
#include <palpate/core/Text.h>
#include <palpate/device/DevicePresets.h>

#include <algorithm>
#include <new>
#include <poll.h>
#include <pthread.h>
#include <utility>

namespace palpate::openigtlink {

using core::Status;
using core::StatusCode;
using device::DeviceCondition;

namespace {

constexpr std::int64_t kMillisecond_ns = 1'000'000;
constexpr int kStartTimeout_ms = 1000;
constexpr int kConnectTimeout_ms = 200; // maximum delay of `stop`
constexpr std::int64_t kFindEvery_ns = 250 * kMillisecond_ns;
constexpr int kWait_ms = 5;
// The hand has moved towards a new pose for so long when the force is sent that answers it.
constexpr std::int64_t kAnswerAfter_ns = 3 * kMillisecond_ns;
// A force expires unless the servo thread renews it.
constexpr std::int64_t kForceTimeout_ns = 20 * kMillisecond_ns;

} // namespace

Driver::Driver(Settings settings)
    : m_settings(std::move(settings))
    , m_hand(m_settings.staleAfter_s)
    , m_stream(m_settings)
{
}

Driver::~Driver()
{
    stop();
}

device::DeviceInfo Driver::info() const
{
    device::DeviceInfo info;
    info.id = "openigtlink";
    info.name = "OpenIGTLink";
    info.sensesOrientation = true;
    info.maxForce_N = device::kShownForceLimit_N;
    if (hasForce()) {
        info.actuatedAxes = 3;
        info.maxForce_N = m_settings.maxForce_N;
        info.maxStiffness_N_per_mm = m_settings.maxStiffness_N_per_mm;
    }
    info.workspaceRadius_mm = m_settings.workspaceRadius_mm;
    if (m_settings.workspaceRadius_mm > 0.0) {
        // The axes of RAS before a user facing the front of the room: x right, y away, z up; D is LPS.
        Eigen::Matrix3d R_UD;
        R_UD << -1, 0, 0, 0, 0, 1, 0, 1, 0;
        info.q_UD = core::Quaternion(R_UD);
    }
    return info;
}

Status Driver::start()
{
    if (m_thread.joinable()) {
        return {StatusCode::Internal, PALPATE_TEXT("%1: already started"), "openigtlink"};
    }
    auto socket = igtl::connectTo(m_settings.host, m_settings.port, kStartTimeout_ms);
    if (!socket.isOk()) {
        const Status status = socket.status().at("openigtlink");
        return status.code() != StatusCode::NotFound
                   ? status
                   : Status(StatusCode::NotFound,
                            PALPATE_TEXT("%1. Start the server there, or set host and port in openigtlink.json."),
                            status.text());
    }
    m_isStopWanted = false;
    m_isCentreWanted = false;
    m_isConnected = true;
    m_poseTime_ns = 0;
    m_interval_ns = 0;
    m_states = 0;
    m_refused = 0;
    m_losses = 0;
    m_latency.clear();
    m_hand = SteppedHand(m_settings.staleAfter_s);
    m_reached_ns = 0;
    m_stream.reset();
    m_newest = {};
    m_centre_mm.setZero();
    m_answered_ns = 0;
    m_sample.write(Sample{});
    m_push.write(ForceCommand{});
    m_thread = std::thread([this, first = std::move(socket).value()]() mutable { run(std::move(first)); });
    return {};
}

void Driver::stop() noexcept
{
    if (m_thread.joinable()) {
        m_isStopWanted = true;
        m_thread.join();
    }
}

void Driver::run(igtl::Socket first) noexcept
{
    pthread_setname_np(pthread_self(), "palpate-igtl");
    igtl::Socket socket = std::move(first);
    while (!m_isStopWanted) {
        try {
            if (socket.isOpen()) {
                igtl::Connection connection(std::move(socket), false);
                m_isConnected = true;
                serve(connection);
                m_isConnected = false;
                if (m_isStopWanted) {
                    return;
                }
                ++m_losses;
            }
            socket = igtl::Socket();
            loseHand(hasForce());
            core::sleepUntil_ns(core::monotonicNow_ns() + kFindEvery_ns);
            if (auto found = igtl::connectTo(m_settings.host, m_settings.port, kConnectTimeout_ms); found.isOk()) {
                socket = std::move(found).value();
            }
        } catch (const std::bad_alloc&) { // retried later
            m_isConnected = false;
        }
    }
}

void Driver::serve(igtl::Connection& connection)
{
    m_isAnswerDue = false;
    bool isPushing = false; // the last force sent was not zero
    if (m_settings.requestEvery_ms > 0) {
        (void)connection.send(igtl::encodeMessage(
            "STT_TDATA", "", igtl::encodeTrackingRequest({m_settings.requestEvery_ms, {}}), igtl::timestampNow()));
    }
    std::uint64_t refused = 0;
    bool isOpen = true;
    while (!m_isStopWanted && isOpen) {
        pollfd waiting{connection.descriptor(), static_cast<short>(connection.hasQueue() ? POLLIN | POLLOUT : POLLIN),
                       0};
        (void)::poll(&waiting, 1, kWait_ms);
        isOpen = connection.receive([this](const igtl::Message& message) { take(message); });
        if (connection.refused() != refused) {
            m_refused += connection.refused() - refused;
            refused = connection.refused();
            noteProblem(connection.problem());
        }
        const std::int64_t now_ns = core::monotonicNow_ns();
        const bool isStale = now_ns - m_newest.time_ns > static_cast<std::int64_t>(m_settings.staleAfter_s * 1e9);
        if (hasForce() && ((m_isAnswerDue && now_ns - m_newest.time_ns >= kAnswerAfter_ns) || (isStale && isPushing))) {
            m_isAnswerDue = false;
            const core::Vec3 f_D = isStale ? core::Vec3(core::Vec3::Zero()) : wantedForce(now_ns);
            isPushing = !f_D.isZero(0.0);
            sendForce(connection, f_D);
        }
        isOpen = connection.flush() && isOpen;
    }
    if (hasForce()) {
        sendForce(connection, core::Vec3::Zero()); // also when Palpate ends
    }
}

void Driver::take(const igtl::Message& message)
{
    const std::int64_t now_ns = core::monotonicNow_ns();
    switch (m_stream.take(message, now_ns)) {
    case PoseStream::Outcome::Other:
    case PoseStream::Outcome::Repeated:
        return;
    case PoseStream::Outcome::Refused:
        ++m_refused;
        noteProblem(m_stream.problem());
        return;
    case PoseStream::Outcome::Pose:
        break;
    }
    if (m_settings.workspaceRadius_mm > 0.0 && m_isCentreWanted.exchange(false)) {
        m_centre_mm = m_stream.pose().p_mm;
        ++m_newest.origin;
    }
    ++m_states;
    m_newest.p_D = m_stream.pose().p_mm - m_centre_mm;
    m_newest.q_D = m_stream.pose().q;
    m_newest.time_ns = now_ns;
    m_newest.interval_ns = m_stream.interval_ns();
    ++m_newest.number;
    m_newest.isPresent = true;
    m_newest.isLost = false;
    m_sample.write(m_newest);
    m_isAnswerDue = true;
    m_poseTime_ns = now_ns;
    m_interval_ns = m_stream.interval_ns();
    const std::scoped_lock lock(m_mutex);
    m_tool = m_stream.tool();
}

void Driver::loseHand(bool isLost) noexcept
{
    m_newest.isPresent = false;
    m_newest.isLost = isLost;
    m_sample.write(m_newest);
}

core::Vec3 Driver::wantedForce(std::int64_t now_ns) noexcept
{
    m_push.fetch();
    const ForceCommand push = m_push.value().get();
    if (now_ns - push.time_ns >= kForceTimeout_ns || !push.f_D.allFinite()) {
        return core::Vec3::Zero();
    }
    const double force_N = push.f_D.norm();
    return force_N > m_settings.maxForce_N ? core::Vec3(push.f_D * (m_settings.maxForce_N / force_N)) : push.f_D;
}

void Driver::sendForce(igtl::Connection& connection, const core::Vec3& f_D)
{
    const igtl::Pose force{f_D, core::Quaternion::Identity()};
    const igtl::WireMatrix transform = igtl::transformOf(m_settings.isRas ? igtl::toggleRas(force) : force);
    const bool isSent = connection.send(
        igtl::encodeMessage("TRANSFORM", m_settings.force, igtl::encodeTransform(transform), igtl::timestampNow()));
    const std::int64_t answers_ns = m_push.value().get().answers_ns;
    if (isSent && !f_D.isZero(0.0) && answers_ns > m_answered_ns) {
        m_answered_ns = answers_ns;
        m_latency.add(core::monotonicNow_ns() - answers_ns);
    }
}

void Driver::noteProblem(const std::string& problem)
{
    const std::scoped_lock lock(m_mutex);
    m_problem = problem;
}

device::DeviceState Driver::read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING
{
    m_sample.fetch();
    const Sample newest = m_sample.value().get();
    const device::DeviceState state = m_hand.advance(newest, now_ns);
    if (m_hand.hasArrived()) {
        m_reached_ns = newest.time_ns;
    }
    return state;
}

void Driver::write(const core::Vec3& f_D) noexcept PALPATE_NONBLOCKING
{
    m_push.write(ForceCommand{f_D, m_reached_ns, core::monotonicNow_ns()});
}

device::DeviceReport Driver::report() const
{
    device::DeviceReport report;
    report.latency = m_latency.summary();
    report.states = m_states;
    report.refused = m_refused;
    report.losses = m_losses;
    const std::scoped_lock lock(m_mutex);
    const std::int64_t interval_ns = m_interval_ns;
    const std::int64_t age_ns = core::monotonicNow_ns() - m_poseTime_ns;
    if (!m_isConnected) {
        report.condition = DeviceCondition::Lost;
        report.text = "The OpenIGTLink server at " + m_settings.host + ", port " + std::to_string(m_settings.port) +
                      ", has closed the connection. It is found by itself when it is back.";
    } else if (m_poseTime_ns == 0 || age_ns > static_cast<std::int64_t>(m_settings.staleAfter_s * 1e9)) {
        const std::string& tool = m_settings.tool.empty() ? m_tool : m_settings.tool;
        report.text = (tool.empty() ? std::string("Connected, but no position arrives.")
                                    : "Connected, but no position of " + core::inQuotes(tool) + " arrives.") +
                      " Check that the tool is seen by the tracker and that the server sends it.";
        if (!m_problem.empty()) {
            report.text += " Latest error: " + m_problem;
        }
    } else {
        report.text = core::inQuotes(m_tool) + ": " +
                      (interval_ns > 0 ? feelText(1e9 / static_cast<double>(interval_ns), hasForce())
                                       : std::string("first position received."));
    }
    return report;
}

Status Driver::calibrate()
{
    if (!(m_settings.workspaceRadius_mm > 0.0)) {
        return {StatusCode::Unsupported,
                PALPATE_TEXT("The positions are those of the scene, so there is no centre to set. With "
                             "workspace_radius_mm in openigtlink.json, the current position becomes the centre.")};
    }
    m_isCentreWanted = true;
    return {};
}

} // namespace palpate::openigtlink
