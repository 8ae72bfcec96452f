// SPDX-License-Identifier: BSD-3-Clause
#include "motion/MotionStrain.h"
#include "palpate/geometry/SurfaceMotion.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

namespace palpate::geometry {

using core::Status;
using core::StatusCode;

namespace {

constexpr std::size_t kCurveSteps = 256; ///< of a breath and of a pulse; error of the cubic below 1e-6 of the amplitude
constexpr double kLeastPeriod_s = 1e-3, kMostPeriod_s = 1e6, kMost_mm = 1e7;
constexpr std::size_t kMostControls = std::size_t{1} << 24; ///< over all frames: 512 MiB
constexpr int kMostExponent = 64;
constexpr double kMostPulse = 10.0;

Status outOf(const char* field, double found, double least, double most)
{
    return {std::isfinite(found) ? StatusCode::OutOfRange : StatusCode::NonFinite,
            PALPATE_TEXT("%1: found %2, expected %3 to %4"),
            field,
            found,
            least,
            most};
}

/// sin^exponent(π i / n) of one period.
std::vector<double> powersOfSine(int exponent)
{
    std::vector<double> curve(kCurveSteps);
    for (std::size_t i = 0; i < kCurveSteps; ++i) {
        const double turn = static_cast<double>(i) / static_cast<double>(kCurveSteps);
        curve[i] = std::pow(std::sin(std::numbers::pi * turn), exponent);
    }
    return curve;
}

bool isPeriod(double period_s)
{
    return period_s >= kLeastPeriod_s && period_s <= kMostPeriod_s;
}

/// Checks period and exponent of a breath.
Status checkCourse(double period_s, int exponent)
{
    if (!isPeriod(period_s)) {
        return outOf("period_s", period_s, kLeastPeriod_s, kMostPeriod_s);
    }
    if (exponent < 2 || exponent > kMostExponent || exponent % 2 != 0) {
        return {StatusCode::OutOfRange, PALPATE_TEXT("exponent: found %1, expected an even number from 2 to %2"),
                exponent, kMostExponent};
    }
    return {};
}

} // namespace

MotionLattice MotionLattice::around(const core::Box& box, double spacing_mm)
{
    MotionLattice lattice;
    lattice.spacing_mm = spacing_mm;
    for (int axis = 0; axis < 3; ++axis) {
        const double cells = std::ceil(std::max(1.0, box.sizes()[axis] / spacing_mm));
        lattice.cells[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(std::min(cells, 4096.0));
        lattice.origin_mm[axis] = box.center()[axis] - 0.5 * spacing_mm * cells;
    }
    return lattice;
}

SurfaceMotion::Made SurfaceMotion::poses(const std::vector<PoseKey>& keys, bool isPeriodic)
{
    if (keys.size() < 2) {
        return Status(StatusCode::OutOfRange, PALPATE_TEXT("found %1 poses, expected at least two"), keys.size());
    }
    auto motion = std::make_shared<SurfaceMotion>();
    motion->m_isPeriodic = isPeriodic;
    for (const PoseKey& key : keys) {
        core::Quaternion q(Eigen::Matrix3d(key.X_WR.linear()));
        if (!motion->m_keys.empty()) { // the shorter of the two ways
            const auto& last = motion->m_keys.back().value;
            q.coeffs() *= q.coeffs().dot(Eigen::Map<const Eigen::Vector4d>(last.data())) < 0.0 ? -1.0 : 1.0;
        }
        const Vec3 p = key.X_WR.translation();
        motion->m_keys.push_back({key.time_s, {q.x(), q.y(), q.z(), q.w(), p.x(), p.y(), p.z()}, {}});
    }
    if (Status status = motion->check(); !status.isOk()) {
        return status;
    }
    std::vector<Key>& made = motion->m_keys;
    const std::size_t last = made.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
        const bool isEnd = i == 0 || i == last;
        const Key& before = made[!isEnd ? i - 1 : isPeriodic ? last - 1 : i == 0 ? 0 : last - 1];
        const Key& after = made[!isEnd ? i + 1 : isPeriodic ? 1 : i == 0 ? 1 : last];
        double span_s = after.time_s - before.time_s;
        double turned = 1.0; // a whole turn brings the quaternion back with the other sign
        if (isEnd && isPeriodic) {
            span_s += made[last].time_s - made[0].time_s;
            turned = Eigen::Map<const Eigen::Vector4d>(made[0].value.data())
                                 .dot(Eigen::Map<const Eigen::Vector4d>(made[last].value.data())) < 0.0
                         ? -1.0
                         : 1.0;
        }
        for (std::size_t n = 0; n < 7; ++n) {
            const double sign = n < 4 ? turned : 1.0;
            const double to = i == last ? sign * after.value[n] : after.value[n];
            const double from = i == 0 ? sign * before.value[n] : before.value[n];
            made[i].slope[n] = (to - from) / span_s;
        }
    }
    return std::shared_ptr<const SurfaceMotion>(std::move(motion));
}

SurfaceMotion::Made SurfaceMotion::breath(const Breath& breath, const core::Box& bounds)
{
    if (Status status = checkCourse(breath.period_s, breath.exponent); !status.isOk()) {
        return status;
    }
    auto motion = std::make_shared<SurfaceMotion>();
    motion->m_period_s = breath.period_s;
    motion->m_curve = powersOfSine(breath.exponent);
    const Vec3 along = breath.full_W - breath.still_W;
    if (!breath.amplitude_mm.allFinite() || !along.allFinite()) {
        return Status(StatusCode::NonFinite,
                      PALPATE_TEXT("amplitude_mm, still or full: found a number that is not finite"));
    }
    const double length_mm = along.norm();
    if (!(length_mm > 0.0)) {
        motion->m_shift = breath.amplitude_mm;
    } else {
        constexpr double kUsual_mm = 10.0, kPerRamp = 8.0, kMostCells = 64.0;
        const double spacing_mm =
            std::max(std::min(kUsual_mm, length_mm / kPerRamp), bounds.sizes().maxCoeff() / kMostCells);
        const core::Box padded(bounds.min().array() - spacing_mm, bounds.max().array() + spacing_mm);
        motion->m_lattice = MotionLattice::around(padded, spacing_mm);
        motion->m_frames = 1;
        const MotionLattice& lattice = motion->m_lattice;
        for (std::size_t k = 0; k < lattice.cells[2] + 2; ++k) {
            for (std::size_t j = 0; j < lattice.cells[1] + 2; ++j) {
                for (std::size_t i = 0; i < lattice.cells[0] + 2; ++i) {
                    const double s = along.dot(lattice.place(i, j, k) - breath.still_W) / (length_mm * length_mm);
                    const double t = std::clamp(s, 0.0, 1.0), share = t * t * (3.0 - 2.0 * t);
                    const Vec3 u = share * breath.amplitude_mm;
                    motion->m_controls.push_back({u.x(), u.y(), u.z(), 0.0});
                }
            }
        }
        internal::closeRim(lattice, motion->m_controls);
    }
    if (Status status = motion->check(); !status.isOk()) {
        return status;
    }
    return std::shared_ptr<const SurfaceMotion>(std::move(motion));
}

SurfaceMotion::Made SurfaceMotion::breath(double period_s, int exponent, const MotionLattice& lattice,
                                          const std::vector<Vec3>& displacements)
{
    if (Status status = checkCourse(period_s, exponent); !status.isOk()) {
        return status;
    }
    if (displacements.size() != lattice.controlCount()) {
        return Status(StatusCode::OutOfRange, PALPATE_TEXT("frame %1: found %2 control points, expected %3"), 0,
                      displacements.size(), lattice.controlCount());
    }
    auto motion = std::make_shared<SurfaceMotion>();
    motion->m_period_s = period_s;
    motion->m_curve = powersOfSine(exponent);
    motion->m_lattice = lattice;
    motion->m_frames = 1;
    for (const Vec3& u : displacements) {
        motion->m_controls.push_back({u.x(), u.y(), u.z(), 0.0});
    }
    internal::closeRim(lattice, motion->m_controls);
    if (Status status = motion->check(); !status.isOk()) {
        return status;
    }
    return std::shared_ptr<const SurfaceMotion>(std::move(motion));
}

SurfaceMotion::Made SurfaceMotion::frames(double period_s, const MotionLattice& lattice,
                                          const std::vector<std::vector<Vec3>>& frames)
{
    if (!isPeriod(period_s)) {
        return outOf("period_s", period_s, kLeastPeriod_s, kMostPeriod_s);
    }
    auto motion = std::make_shared<SurfaceMotion>();
    motion->m_period_s = period_s;
    motion->m_lattice = lattice;
    motion->m_frames = frames.size();
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (frames[i].size() != lattice.controlCount()) {
            return Status(StatusCode::OutOfRange, PALPATE_TEXT("frame %1: found %2 control points, expected %3"), i,
                          frames[i].size(), lattice.controlCount());
        }
        for (const Vec3& u : frames[i]) {
            motion->m_controls.push_back({u.x(), u.y(), u.z(), 0.0});
        }
    }
    if (frames.size() >= 2) {
        internal::closeRim(lattice, motion->m_controls);
    }
    if (Status status = motion->check(); !status.isOk()) {
        return status;
    }
    return std::shared_ptr<const SurfaceMotion>(std::move(motion));
}

SurfaceMotion::Made SurfaceMotion::pulse(double period_s, double share, const std::shared_ptr<const SurfaceMotion>& of)
{
    if (!isPeriod(period_s)) {
        return outOf("period_s", period_s, kLeastPeriod_s, kMostPeriod_s);
    }
    if (!(share >= 0.0 && share <= kMostPulse)) {
        return outOf("share", share, 0.0, kMostPulse);
    }
    auto motion = of == nullptr ? std::make_shared<SurfaceMotion>() : std::make_shared<SurfaceMotion>(*of);
    motion->m_pulse_s = period_s;
    motion->m_pulse = powersOfSine(2);
    for (double& factor : motion->m_pulse) {
        factor = 1.0 + share * factor;
    }
    return std::shared_ptr<const SurfaceMotion>(std::move(motion));
}

std::shared_ptr<const SurfaceMotion> SurfaceMotion::withClock(double start_s, double offset_s, double rate) const
{
    auto motion = std::make_shared<SurfaceMotion>(*this);
    motion->m_start_s = start_s;
    motion->m_offset_s = offset_s;
    motion->m_rate = rate;
    motion->m_pulseOffset_s = offset_s;
    motion->m_pulseRate = rate;
    motion->m_ease_s = 0.0;
    motion->m_before = {};
    return motion;
}

std::shared_ptr<const SurfaceMotion> SurfaceMotion::changedAt(double start_s, double ease_s, const Pace& pace) const
{
    const Course before = courseAt(start_s);
    auto motion = std::make_shared<SurfaceMotion>(*this);
    motion->m_start_s = start_s;
    motion->m_offset_s = before.phase_s;
    motion->m_rate = pace.rate;
    motion->m_amplitude = pace.amplitude;
    motion->m_pulseOffset_s = before.pulse_s;
    motion->m_pulseRate = pace.pulseRate;
    motion->m_ease_s = ease_s;
    motion->m_before = {before.rate, before.pulseRate, before.amplitude};
    return motion;
}

std::shared_ptr<const SurfaceMotion> SurfaceMotion::startingAt(double time_s) const
{
    auto motion = std::make_shared<SurfaceMotion>(*this);
    motion->m_start_s -= time_s;
    return motion;
}

std::shared_ptr<const SurfaceMotion> SurfaceMotion::withAmplitude(double share) const
{
    auto motion = std::make_shared<SurfaceMotion>(*this);
    motion->m_amplitude = share;
    if (motion->m_ease_s > 0.0) {
        motion->m_before.amplitude = share;
    }
    return motion;
}

bool SurfaceMotion::isMoving() const noexcept
{
    return !m_keys.empty() || m_period_s > 0.0;
}

double SurfaceMotion::reach_mm() const noexcept
{
    double most = m_shift.norm();
    for (const std::array<double, 4>& u : m_controls) {
        most = std::max(most, std::hypot(u[0], u[1], u[2]));
    }
    return m_amplitude * most;
}

bool SurfaceMotion::operator==(const SurfaceMotion& other) const noexcept
{
    return m_shape == other.m_shape && m_start_s == other.m_start_s && m_offset_s == other.m_offset_s &&
           m_ease_s == other.m_ease_s && pace() == other.pace() && m_before == other.m_before &&
           m_pulseOffset_s == other.m_pulseOffset_s && m_pulse_s == other.m_pulse_s && m_pulse == other.m_pulse;
}

/// Sets `m_shape` by FNV-1a over everything but clock, amplitude and pulse.
/// @par Source http://www.isthe.com/chongo/tech/comp/fnv
void SurfaceMotion::setShape() noexcept
{
    m_shape = 14695981039346656037U;
    const auto add = [this](const auto& values) {
        for (const double value : values) {
            m_shape = (m_shape ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211U;
        }
    };
    add(std::array{m_period_s, m_isPeriodic ? 1.0 : 0.0, m_lattice.spacing_mm, static_cast<double>(m_frames)});
    add(m_curve);
    add(m_shift);
    add(m_lattice.origin_mm);
    add(m_lattice.cells);
    for (const Key& key : m_keys) {
        add(std::array{key.time_s});
        add(key.value);
    }
    for (const std::array<double, 4>& u : m_controls) {
        add(u);
    }
}

/// Checks everything that a file can have wrong, and sets `m_strain` and `m_shape`.
Status SurfaceMotion::check()
{
    setShape();
    for (std::size_t i = 0; i < m_keys.size(); ++i) {
        const Key& key = m_keys[i];
        const bool isFinite = std::isfinite(key.time_s) && std::all_of(key.value.begin(), key.value.end(),
                                                                       [](double v) { return std::isfinite(v); });
        if (!isFinite) {
            return {StatusCode::NonFinite, PALPATE_TEXT("pose %1: found a number that is not finite"), i};
        }
        if (i > 0 && !(key.time_s - m_keys[i - 1].time_s >= 1e-6)) {
            return {StatusCode::OutOfRange,
                    PALPATE_TEXT("pose %1: found the time %2 s after %3 s, expected ascending times"), i, key.time_s,
                    m_keys[i - 1].time_s};
        }
    }
    if (m_isPeriodic) {
        const auto &first = m_keys.front().value, &last = m_keys.back().value;
        double apart = 0.0, turned = 0.0;
        for (std::size_t n = 0; n < 4; ++n) {
            turned += first[n] * last[n];
        }
        for (std::size_t n = 4; n < 7; ++n) {
            apart = std::max(apart, std::abs(first[n] - last[n]));
        }
        if (!(apart <= 1e-6) || !(std::abs(turned) >= 1.0 - 1e-9)) {
            return {StatusCode::Mismatch, PALPATE_TEXT("the last pose: found another than the first, expected the same "
                                                       "for a motion that repeats")};
        }
    }
    if (m_period_s > 0.0 && m_curve.empty() && m_frames < 2) {
        return {StatusCode::OutOfRange, PALPATE_TEXT("found %1 frames, expected at least two"), m_frames};
    }
    if (!m_shift.allFinite() || !(m_shift.norm() <= kMost_mm)) {
        return {StatusCode::OutOfRange, PALPATE_TEXT("amplitude_mm: found more than %1 mm"), kMost_mm};
    }
    if (m_frames == 0) {
        return {};
    }
    if (!(m_lattice.spacing_mm > 0.0) || !std::isfinite(m_lattice.spacing_mm) || !m_lattice.origin_mm.allFinite() ||
        std::find(m_lattice.cells.begin(), m_lattice.cells.end(), 0U) != m_lattice.cells.end()) {
        return {StatusCode::OutOfRange, PALPATE_TEXT("lattice: expected at least one cell of a positive size")};
    }
    if (m_lattice.controlCount() > kMostControls / m_frames) {
        return {StatusCode::OutOfRange,
                PALPATE_TEXT("lattice: found %1 control points in %2 frames, expected at most %3"),
                m_lattice.controlCount(), m_frames, kMostControls};
    }
    if (m_controls.size() != m_frames * m_lattice.controlCount()) {
        return {StatusCode::OutOfRange, PALPATE_TEXT("lattice: found %1 displacements, expected %2"), m_controls.size(),
                m_frames * m_lattice.controlCount()};
    }
    for (std::size_t i = 0; i < m_controls.size(); ++i) {
        for (const double u : m_controls[i]) {
            if (!std::isfinite(u) || std::abs(u) > kMost_mm) {
                return {StatusCode::NonFinite, PALPATE_TEXT("frame %1, control point %2: found the displacement %3 mm"),
                        i / m_lattice.controlCount(), i % m_lattice.controlCount(), u};
            }
        }
    }
    return checkStrain();
}

Status SurfaceMotion::checkStrain()
{
    double share = 1.0; // largest factor of a single frame
    if (!m_curve.empty()) {
        share = 0.0;
        for (std::size_t i = 0; i < m_curve.size(); ++i) {
            const std::size_t n = m_curve.size();
            const double third = (m_curve[(i + 1) % n] - m_curve[(i + n - 1) % n]) / 6.0;
            share = std::max(share, std::abs(m_curve[i]) + std::abs(third));
        }
    }
    const internal::WorstStrain worst = internal::worstStrain(m_lattice, m_frames, m_controls);
    m_strain = share * worst.strain;
    // A quadratic in Bernstein form changes along an axis by at most twice the difference of two coefficients per cell,
    // and along any direction by at most the square root of 3 of that.
    m_bend = 4.0 * std::sqrt(3.0) * m_strain / m_lattice.spacing_mm;
    if (m_strain <= kMaxStrain) {
        return {};
    }
    if (m_strain >= 1.0) {
        return {StatusCode::OutOfRange,
                PALPATE_TEXT("frame %1, cell (%2, %3, %4): found a strain of up to %5 %, where the tissue may fold; "
                             "expected at most %6 %"),
                worst.frame,
                worst.cell[0],
                worst.cell[1],
                worst.cell[2],
                100.0 * m_strain,
                100.0 * kMaxStrain};
    }
    return {StatusCode::OutOfRange,
            PALPATE_TEXT("frame %1, cell (%2, %3, %4): found a strain of up to %5 %, expected at most %6 %"),
            worst.frame,
            worst.cell[0],
            worst.cell[1],
            worst.cell[2],
            100.0 * m_strain,
            100.0 * kMaxStrain};
}

} // namespace palpate::geometry
