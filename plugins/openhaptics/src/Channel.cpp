// SPDX-License-Identifier: BSD-3-Clause
#include "Channel.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate::openhaptics {

namespace {

constexpr unsigned kCheckEvery = 10;                         // frames
constexpr std::int64_t kForceOff_ns = 500 * kMillisecond_ns; // after the library refused a force
constexpr std::int64_t kWarm_ns = 10'000 * kMillisecond_ns;  // after the last warning of warm motors
constexpr std::int64_t kCalibrateEvery_ns = 500 * kMillisecond_ns;
constexpr std::int64_t kLostAfter_ns = 100 * kMillisecond_ns; // of readings that fail
constexpr double kWarmRamp_s = 0.5;                           // from the maximum to the continuous force
constexpr int kGoodFrames = 50;                               // until a lost device counts as back
constexpr int kRateFrames = 256;
constexpr double kFarthest_mm = 600.0; // the largest device of the maker reaches 420 mm
constexpr double kFrameTolerance = 1e-2;

} // namespace

Channel::Channel(std::shared_ptr<const Hd> hd, std::string name, Hd::Device device, Statement statement, Limits limits)
    : m_hd(std::move(hd))
    , m_name(std::move(name))
    , m_device(device)
    , m_statement(std::move(statement))
    , m_limits(limits)
    , m_limit_N(limits.maxForce_N)
{
}

void Channel::setDevice(Hd::Device device) noexcept
{
    m_device = device;
    m_goodFrames = 0;
    m_failedSince_ns = 0;
    m_calibration = Trouble::None;
    m_frames = 0;
}

void Channel::enableForces() noexcept
{
    m_hd->enable(kForceOutput);
    m_hd->enable(kMaxForceClamping);
    m_hd->enable(kForceRamping);
}

void Channel::reset()
{
    m_exchange.reset();
    m_sensed = {};
    m_calibration = m_force = Trouble::None;
    m_forceOffUntil_ns = m_warmUntil_ns = m_calibrated_ns = m_frame_ns = m_rateFrom_ns = m_failedSince_ns = 0;
    m_rateFrames = m_goodFrames = 0;
    m_frames = 0;
    m_limit_N = m_limits.maxForce_N;
    m_isFrameClosed = false;
    m_isCalibrationWanted = false;
    m_lostSince_ns = 0;
    m_trouble = Trouble::Starting;
    m_isWarm = false;
    m_rate_Hz = 0.0;
    m_states = 0;
    m_refused = 0;
    m_losses = 0;
}

void Channel::hold(bool isHeld) noexcept
{
    m_heldFrames = 0;
    m_isHeld = isHeld;
}

void Channel::markLost(std::int64_t now_ns) noexcept
{
    std::int64_t never = 0;
    if (m_lostSince_ns.compare_exchange_strong(never, now_ns)) {
        ++m_losses;
    }
}

void Channel::frame(bool isEnding) noexcept
{
    const std::int64_t begin_ns = core::monotonicNow_ns();
    if (m_device == Hd::kNoDevice) {
        publish(false, true);
        return;
    }
    measureRate(begin_ns);
    const Hd& hd = *m_hd;
    hd.makeCurrentDevice(m_device);
    hd.beginFrame(m_device);
    const bool isRead = sense();
    const bool isCheckDue = m_frames++ % kCheckEvery == 0;
    if (isCheckDue && isRead) {
        checkCalibration();
    }
    if (m_isCalibrationWanted) {
        m_calibration = Trouble::NeedsUpdate; // with zero force first
    }
    const bool isGood = heedErrors(begin_ns);
    if (std::exchange(m_isFrameClosed, false)) {
        m_goodFrames = 0;
        ++m_refused;
        return;
    }
    const bool isSensed = isRead && isGood;
    if (isCheckDue && m_force == Trouble::None && hd.isEnabled(kForceOutput) == 0) {
        // Another part of the library or its user has switched forces off.
        enableForces();
        m_forceOffUntil_ns = begin_ns + kForceOff_ns;
        m_force = Trouble::Starting;
    }
    if (isSensed) {
        m_failedSince_ns = 0;
        m_goodFrames = std::min(m_goodFrames + 1, kGoodFrames);
        if (m_goodFrames == kGoodFrames) {
            m_lostSince_ns = 0;
        }
        ++m_states;
        m_sensed.time_ns = begin_ns; // the device may have measured it any time during the calls
    } else {
        m_goodFrames = 0;
        ++m_refused;
        m_failedSince_ns = m_failedSince_ns == 0 ? begin_ns : m_failedSince_ns;
        if (begin_ns - m_failedSince_ns > kLostAfter_ns) {
            markLost(begin_ns);
        }
    }
    const Trouble trouble = troubleAt(begin_ns);
    const bool isHeld = m_isHeld || m_isRetired || isEnding;
    const bool isLost = m_lostSince_ns != 0;
    if (isSensed || isLost) { // otherwise the last state ages, and the safety gate sees it
        publish(trouble == Trouble::None && !isHeld && !isLost, isLost && !isHeld);
    }
    const std::int64_t now_ns = core::monotonicNow_ns();
    const core::Vec3 wanted_N = m_exchange.wantedForce(now_ns, limitAt(now_ns));
    const bool isDriven = isSensed && trouble == Trouble::None && !isHeld && !isLost;
    const core::Vec3 f_N = isDriven ? wanted_N : core::Vec3(core::Vec3::Zero());
    hd.setDoublev(kCurrentForce, f_N.data());
    hd.endFrame(m_device);
    m_trouble = trouble;
    if (heedErrors(now_ns)) {
        m_exchange.noteSent(f_N, core::monotonicNow_ns());
        m_heldFrames += isHeld ? 1 : 0;
    } else {
        m_goodFrames = 0;
    }
    updateCalibration(now_ns);
}

/// Reads position, orientation and buttons. @return false: the position cannot be that of a device
bool Channel::sense() noexcept
{
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    double p[3] = {kNone, kNone, kNone};
    double T[16]; // column by column
    std::fill(std::begin(T), std::end(T), kNone);
    int buttons = 0;
    m_hd->getDoublev(kCurrentPosition, p);
    m_hd->getDoublev(kCurrentTransform, T);
    m_hd->getIntegerv(kCurrentButtons, &buttons);
    const core::Vec3 p_mm(p);
    if (!p_mm.allFinite() || p_mm.cwiseAbs().maxCoeff() > kFarthest_mm) {
        return false;
    }
    m_sensed.p_D = p_mm - m_limits.centre_mm;
    m_sensed.buttons = static_cast<std::uint32_t>(buttons) & ((1U << kButtons) - 1U);
    const Eigen::Matrix3d R{{T[0], T[4], T[8]}, {T[1], T[5], T[9]}, {T[2], T[6], T[10]}};
    // Of an invalid frame the last valid orientation stays; only the force has to be right.
    if (R.allFinite() && (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < kFrameTolerance &&
        R.determinant() > 0.0) {
        m_sensed.q_D = core::Quaternion(R).normalized();
    }
    return true;
}

bool Channel::heedErrors(std::int64_t now_ns) noexcept
{
    bool isGood = true;
    const auto forceOff = [&](Trouble trouble) {
        m_force = trouble;
        m_forceOffUntil_ns = now_ns + kForceOff_ns;
    };
    for (int i = 0; i < kMostErrors; ++i) {
        switch (m_hd->getError().code) {
        case kSuccess:
            return isGood;
        case kWarmMotors:
            m_warmUntil_ns = now_ns + kWarm_ns;
            break;
        case kExceededMaxVelocity:
            forceOff(Trouble::TooFast);
            break;
        case kExceededMaxForce:
        case kExceededMaxForceImpulse:
        case kForceError:
            forceOff(Trouble::TooMuchForce);
            break;
        case kInvalidLicense:
            forceOff(Trouble::NoLicence);
            break;
        case kIllegalBegin:
            m_hd->endFrame(m_device); // of a frame that was left open
            m_isFrameClosed = true;
            isGood = false;
            break;
        default:
            isGood = false;
            break;
        }
    }
    return false;
}

Trouble Channel::troubleAt(std::int64_t now_ns) noexcept
{
    if (m_force != Trouble::None) {
        if (now_ns < m_forceOffUntil_ns) {
            return m_force;
        }
        // Whether the library has switched forces off meanwhile depends on its version.
        enableForces();
        m_force = Trouble::None;
    }
    return m_calibration;
}

void Channel::checkCalibration() noexcept
{
    const unsigned styles = m_statement.calibrationStyles;
    switch (m_hd->checkCalibration()) {
    case kCalibrationNeedsUpdate:
        m_calibration =
            (styles & (kAutomatic | kInkwell)) != 0 || styles == 0 ? Trouble::NeedsUpdate : Trouble::NeedsReset;
        break;
    case kCalibrationNeedsManualInput:
        m_calibration = (styles & kInkwell) != 0 ? Trouble::NeedsInkwell : Trouble::NeedsReset;
        break;
    default:
        m_calibration = Trouble::None;
        break;
    }
}

void Channel::updateCalibration(std::int64_t now_ns) noexcept
{
    const bool isWanted = m_isCalibrationWanted.exchange(false);
    const bool isDue = m_calibration == Trouble::NeedsUpdate && now_ns - m_calibrated_ns > kCalibrateEvery_ns;
    if (!isWanted && !isDue) {
        return;
    }
    m_calibrated_ns = now_ns;
    const unsigned styles = m_statement.calibrationStyles;
    const unsigned style = isWanted && (styles & kEncoderReset) != 0 ? kEncoderReset
                           : (styles & kInkwell) != 0                ? kInkwell
                                                                     : kAutomatic;
    // Outside of a frame, with zero force: the positions jump.
    m_hd->updateCalibration(style);
    (void)heedErrors(now_ns);
    m_calibration = Trouble::NeedsUpdate; // until the next check
}

double Channel::limitAt(std::int64_t now_ns) noexcept
{
    const bool isWarm = now_ns < m_warmUntil_ns;
    const double passed_s = std::clamp(1e-9 * static_cast<double>(now_ns - m_frame_ns), 0.0, 0.01);
    const double change_N = (m_limits.maxForce_N - m_limits.continuousForce_N) * passed_s / kWarmRamp_s;
    m_limit_N = isWarm ? std::max(m_limits.continuousForce_N, m_limit_N - change_N)
                       : std::min(m_limits.maxForce_N, m_limit_N + change_N);
    m_frame_ns = now_ns;
    m_isWarm = isWarm;
    return m_limit_N;
}

void Channel::measureRate(std::int64_t now_ns) noexcept
{
    if (m_rateFrom_ns == 0 || ++m_rateFrames == kRateFrames) {
        if (m_rateFrom_ns != 0 && now_ns > m_rateFrom_ns) {
            m_rate_Hz = 1e9 * kRateFrames / static_cast<double>(now_ns - m_rateFrom_ns);
        }
        m_rateFrom_ns = now_ns;
        m_rateFrames = 0;
    }
}

void Channel::publish(bool isPresent, bool isLost) noexcept
{
    device::DeviceState state = m_sensed;
    state.isPresent = isPresent;
    state.isLost = isLost;
    m_exchange.publish(state);
}

} // namespace palpate::openhaptics
