// SPDX-License-Identifier: BSD-3-Clause
#include "Driver.h"

#include <palpate/core/Clock.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <new>
#include <pthread.h>
#include <sched.h>
#include <utility>

namespace palpate::haply {

using core::Status;
using core::StatusCode;
using core::Vec3;
using device::DeviceCondition;
using Received = Session::Received;

namespace {

constexpr std::int64_t kMillisecond_ns = 1'000'000;
constexpr std::int64_t kPeriod_ns = kMillisecond_ns / 4; // shortest time between two messages
constexpr std::int64_t kFindEvery_ns = 250 * kMillisecond_ns;
// A force expires unless the servo thread renews it: zero is on its way to the device within 10 ms.
constexpr std::int64_t kForceTimeout_ns = 8 * kMillisecond_ns;
// As old as the safety gate accepts a state.
constexpr std::int64_t kStateTimeout_ns = 5 * kMillisecond_ns;
// Without an answer for so long, zero follows the force that is still on its way.
constexpr std::int64_t kSilentAfter_ns = 4 * kMillisecond_ns;
// Without a valid state for so long, the driver connects anew.
constexpr std::int64_t kLostAfter_ns = 100 * kMillisecond_ns;
constexpr std::int64_t kAskAllEvery_ns = 1000 * kMillisecond_ns;
// The service must drive a force of this size within this time.
constexpr double kNoticeable_N = 0.2;
constexpr double kFollowingRatio = 0.05; // its filters and the owner's scale may take most of a force away
constexpr std::int64_t kFollowWithin_ns = 100 * kMillisecond_ns;
constexpr std::int64_t kAwayAfterSwitch_ns = 50 * kMillisecond_ns;
constexpr int kMostMessages = 32; // taken in one iteration, of a service that sends unasked
constexpr int kButtons = 4;
constexpr int kPriority = 75; // above the servo thread; each iteration is short

/// Instruction for the user; empty without trouble.
const char* troubleText(Trouble trouble)
{
    switch (trouble) {
    case Trouble::NoPower:
        return "The device has no power. Connect its power supply and switch it on.";
    case Trouble::NotCalibrated:
        return "The device is not calibrated. Attach its grip, and calibrate it as Haply Hub shows.";
    case Trouble::NotReady:
        return "The device is not ready. Wait until its light is steady; if it stays so, unplug it and plug it in "
               "again.";
    case Trouble::OtherAxes:
        return "The Inverse Service turns, scales or moves the axes of the device. Reset its basis, mount and "
               "workspace in Haply Hub.";
    case Trouble::None:
    case Trouble::Starting:
        break;
    }
    return "";
}

Trouble troubleOf(const DeviceStatus& status)
{
    if (!status.hasPower) {
        return Trouble::NoPower;
    }
    if (!status.isCalibrated) {
        return Trouble::NotCalibrated;
    }
    return status.isReady ? Trouble::None : Trouble::NotReady;
}

} // namespace

Driver::Driver(Settings settings, std::string deviceId)
    : m_settings(std::move(settings))
    , m_deviceId(std::move(deviceId))
    , m_model(limited(modelOf("device"), m_settings))
{
    // Callers need the limits before `start`, which connects again and reports the reason where that fails.
    if (const auto opened = Session::open(m_settings, m_deviceId); opened.isOk()) {
        adopt(*opened.value());
    }
}

Driver::~Driver()
{
    stop();
}

void Driver::adopt(const Session& session)
{
    m_type = session.type();
    m_model = session.model();
    m_hasGrip = session.hasGrip();
    m_isGripUndecided = session.isGripUndecided();
}

device::DeviceInfo Driver::info() const
{
    device::DeviceInfo info;
    info.id = "haply";
    info.name = m_model.name;
    info.sensesOrientation = m_hasGrip;
    info.buttons = m_hasGrip ? kButtons : 0;
    info.actuatedAxes = 3;
    info.maxForce_N = m_model.maxForce_N;
    info.maxStiffness_N_per_mm = m_model.maxStiffness_N_per_mm;
    info.maxDamping_Ns_per_mm = m_model.maxDamping_Ns_per_mm;
    info.workspaceRadius_mm = m_model.workspaceRadius_mm;
    // In the service's frame, x points to the right, y away from the user, z up.
    Eigen::Matrix3d R_UD;
    R_UD << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    info.q_UD = core::Quaternion(R_UD);
    return info;
}

Status Driver::start()
{
    if (m_thread.joinable()) {
        return {StatusCode::Internal, PALPATE_TEXT("%1: already started"), "haply"};
    }
    auto opened = Session::open(m_settings, m_deviceId);
    if (!opened.isOk()) {
        return opened.status();
    }
    std::unique_ptr<Session> session = std::move(opened).value();
    adopt(*session);
    m_deviceId = session->deviceId();
    m_sensed = {};
    m_isStopWanted = false;
    m_isLost = false;
    m_states = 0;
    m_refused = 0;
    m_losses = 0;
    m_latency.clear();
    m_readState_ns = 0;
    m_answered_ns = 0;
    m_push.write(ForceCommand{});
    m_state.write(device::DeviceState{});
    m_thread = std::thread([this, first = std::move(session)]() mutable { run(std::move(first)); });
    return {};
}

void Driver::stop() noexcept
{
    if (m_thread.joinable()) {
        m_isStopWanted = true;
        m_thread.join();
    }
}

void Driver::run(std::unique_ptr<Session> session) noexcept
{
    pthread_setname_np(pthread_self(), "palpate-haply");
    sched_param param{};
    param.sched_priority = kPriority;
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &param); // without permission the policy stays unchanged
    while (!m_isStopWanted) {
        if (session != nullptr) {
            try {
                serve(*session);
            } catch (const std::bad_alloc&) { // as a lost connection
            }
            session.reset(); // zero force
            if (m_isStopWanted) {
                return;
            }
            m_isLost = true;
            ++m_losses;
            publish(false, true);
        }
        core::sleepUntil_ns(core::monotonicNow_ns() + kFindEvery_ns);
        session = reopen();
    }
}

std::unique_ptr<Session> Driver::reopen() noexcept
{
    try {
        // Only the same device: another device would have other limits.
        auto opened = Session::open(m_settings, m_deviceId);
        if (opened.isOk() && opened.value()->type() == m_type) {
            return std::move(opened).value();
        }
    } catch (const std::bad_alloc&) { // retried later
    }
    return nullptr;
}

void Driver::serve(Session& session)
{
    m_began_ns = core::monotonicNow_ns();
    m_sensed_ns = m_began_ns;
    m_askedAll_ns = m_began_ns;
    m_trouble = Trouble::Starting;
    m_axes = Axes::Unstated;
    m_isSilenced = false;
    m_isKeySwitched = false;
    m_isUnfollowed = false;
    m_unfollowed_ns = 0;
    m_awayUntil_ns = 0;
    m_isShared = session.isShared();
    session.begin();
    while (!m_isStopWanted) {
        const std::int64_t begin_ns = core::monotonicNow_ns();
        if (!pushNext(session, begin_ns)) {
            return;
        }
        // All that is there, so that the newest state counts.
        std::int64_t until_ns = begin_ns + kMillisecond_ns;
        Received received = Received::Other;
        for (int i = 0; i < kMostMessages && received != Received::Nothing; ++i) {
            Update update;
            std::int64_t asked_ns = 0;
            received = session.receive(update, asked_ns, until_ns);
            if (received == Received::Closed) {
                return;
            }
            if (received == Received::Refused) {
                ++m_refused;
            } else if (received == Received::State) {
                take(update, asked_ns, core::monotonicNow_ns());
                checkFollowing(session, update, core::monotonicNow_ns());
            }
            until_ns = session.unanswered() > 0 ? until_ns : begin_ns;
        }
        core::sleepUntil_ns(begin_ns + kPeriod_ns);
    }
}

bool Driver::pushNext(Session& session, std::int64_t now_ns)
{
    if (now_ns - m_sensed_ns > kLostAfter_ns) {
        return false;
    }
    if (session.unanswered() > 0) {
        if (!m_isSilenced && now_ns - session.lastSent_ns() > kSilentAfter_ns) {
            m_isSilenced = true;
            m_sent_N = Vec3::Zero();
            (void)session.push(m_sent_N);
        }
        return true;
    }
    m_isSilenced = false;
    if (m_axes != Axes::Default && now_ns - m_askedAll_ns > kAskAllEvery_ns) {
        m_askedAll_ns = now_ns;
        (void)session.askForAll();
        return true;
    }
    m_sent_N = wantedForce(now_ns);
    if (session.push(m_sent_N) && !m_sent_N.isZero(0.0) && m_push.value().get().answers_ns > m_answered_ns) {
        m_answered_ns = m_push.value().get().answers_ns;
        m_latency.add(core::monotonicNow_ns() - m_answered_ns);
    }
    return true;
}

void Driver::take(const Update& update, std::int64_t asked_ns, std::int64_t now_ns) noexcept
{
    ++m_states;
    m_sensed_ns = now_ns;
    m_sensed.p_D = (update.p_m - m_model.centre_m) * 1000.0;
    m_sensed.q_D = update.q.value_or(m_sensed.q_D);
    m_sensed.buttons = update.buttons.value_or(m_sensed.buttons);
    m_sensed.time_ns = asked_ns;
    if (update.axes != Axes::Unstated) {
        m_axes = update.axes;
    }
    Trouble trouble = troubleOf(update.status);
    if (trouble == Trouble::None && m_axes != Axes::Default) {
        const bool isWaiting = m_axes == Axes::Unstated && now_ns - m_began_ns < kAskAllEvery_ns;
        trouble = isWaiting ? Trouble::Starting : Trouble::OtherAxes;
    }
    m_trouble = trouble;
    m_isLost = false;
    publish(trouble == Trouble::None && now_ns >= m_awayUntil_ns, false);
}

void Driver::checkFollowing(Session& session, const Update& update, std::int64_t now_ns) noexcept
{
    const double sent_N = m_sent_N.norm();
    if (!update.f_N || sent_N < kNoticeable_N) { // not stated before 3.5
        m_unfollowed_ns = 0;
    } else if (update.f_N->norm() > kFollowingRatio * sent_N) {
        m_unfollowed_ns = 0;
        m_isUnfollowed = false;
    } else if (m_unfollowed_ns == 0) {
        m_unfollowed_ns = now_ns;
    } else if (now_ns - m_unfollowed_ns > kFollowWithin_ns) {
        if (!m_isKeySwitched) {
            // The hand is away for a moment, so that the gate eases the force in.
            m_isKeySwitched = true;
            m_unfollowed_ns = 0;
            m_awayUntil_ns = now_ns + kAwayAfterSwitch_ns;
            session.switchKey();
        } else {
            m_isUnfollowed = true;
        }
    }
}

Vec3 Driver::wantedForce(std::int64_t now_ns) noexcept
{
    m_push.fetch();
    const ForceCommand push = m_push.value().get();
    if (m_trouble != Trouble::None || now_ns < m_awayUntil_ns || now_ns - push.time_ns >= kForceTimeout_ns ||
        now_ns - m_sensed_ns >= kStateTimeout_ns || !push.f_D.allFinite()) {
        return Vec3::Zero();
    }
    const double force_N = push.f_D.norm();
    return force_N > m_model.maxForce_N ? Vec3(push.f_D * (m_model.maxForce_N / force_N)) : push.f_D;
}

void Driver::publish(bool isPresent, bool isLost) noexcept
{
    device::DeviceState state = m_sensed;
    state.isPresent = isPresent;
    state.isLost = isLost;
    m_state.write(state);
}

device::DeviceState Driver::read(std::int64_t) noexcept PALPATE_NONBLOCKING
{
    m_state.fetch();
    const device::DeviceState state = m_state.value().get();
    m_readState_ns = state.time_ns;
    return state;
}

void Driver::write(const Vec3& f_D) noexcept PALPATE_NONBLOCKING
{
    m_push.write(ForceCommand{f_D, m_readState_ns, core::monotonicNow_ns()});
}

device::DeviceReport Driver::report() const
{
    device::DeviceReport report;
    const Trouble trouble = m_trouble;
    if (m_isLost) {
        report.condition = DeviceCondition::Lost;
        report.text = "The Inverse Service does not answer, or has no such device. Check the cable, the power and the "
                      "service; the device is found by itself.";
    } else if (trouble != Trouble::None && trouble != Trouble::Starting) {
        report.condition = DeviceCondition::NeedsCalibration;
        report.text = troubleText(trouble);
    } else if (m_isUnfollowed) {
        report.text = "The device does not drive the force that it is sent. Check the force scale in Haply Hub, and "
                      "close other programs that use the device; if that does not help, update the Inverse Service.";
    } else if (m_isShared) {
        report.text = "Another program uses the device, and the forces of both add up. Close the other program.";
    } else if (!m_model.isKnown && m_settings.maxForce_N <= 0.0) {
        report.text = "The limits of this model are not known, so it is driven with 3 N. Set max_force_N, "
                      "max_stiffness_N_per_mm and workspace_radius_mm in haply.json.";
    } else if (m_isGripUndecided) {
        report.text = "Several VerseGrips are connected. Choose the one in this hand by grip_id in haply.json.";
    }
    report.latency = m_latency.summary();
    report.states = m_states;
    report.refused = m_refused;
    report.losses = m_losses;
    return report;
}

Status Driver::calibrate()
{
    return {StatusCode::Unsupported,
            PALPATE_TEXT("This device is calibrated by its maker's service: attach its grip, and calibrate it as Haply "
                         "Hub shows.")};
}

} // namespace palpate::haply
