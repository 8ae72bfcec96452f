// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/SurfaceMotion.h"

#include "motion/PeriodicCubic.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace palpate::geometry {

namespace {

constexpr int kMaxSteps = 32;
/// The steps end when at most this distance is left [mm], half of SurfaceMotion::kInverse_mm.
constexpr double kEnough_mm = 5e-10;

using Two = Eigen::Array2d;

/// The coordinates of a control point in registers: x and y, z and 0.
struct Lanes
{
    Two xy, z;
};
PALPATE_ALWAYS_INLINE Lanes operator*(const Two& w, const Lanes& a) noexcept
{
    return {w * a.xy, w * a.z};
}
PALPATE_ALWAYS_INLINE Lanes operator+(const Lanes& a, const Lanes& b) noexcept
{
    return {a.xy + b.xy, a.z + b.z};
}
PALPATE_ALWAYS_INLINE Lanes read(const std::array<double, 4>& control) noexcept
{
    return {Eigen::Map<const Two>(control.data()), Eigen::Map<const Two>(control.data() + 2)};
}
Vec3 vectorOf(const Lanes& a) noexcept
{
    return {a.xy[0], a.xy[1], a.z[0]};
}

/// Position along one axis: cell, and weights of its three control points, each in both lanes.
struct Along
{
    int cell = 0;
    std::array<Two, 3> weight, slope;

    /// @param s  position in cells; outside of 0 … cells the nearest place, without slope
    Along(double s, std::uint32_t cells, double perCell) noexcept
    {
        const int count = static_cast<int>(cells);
        const double most = count;
        const bool isInside = s > 0.0 && s < most;
        const double at = isInside ? s : s >= most ? most : 0.0; // 0 for NaN
        cell = std::min(static_cast<int>(at), count - 1);
        const double t = at - cell, r = 1.0 - t;
        weight = {Two::Constant(0.5 * r * r), Two::Constant(0.5 + t * r), Two::Constant(0.5 * t * t)};
        const double steep = isInside ? perCell : 0.0;
        slope = {Two::Constant(-r * steep), Two::Constant((r - t) * steep), Two::Constant(t * steep)};
    }
};

} // namespace

/// The displacement near one place at one moment. For a single frame it is read in place, several frames are summed for
/// one cell at a time.
class SurfaceMotion::Patch
{
  public:
    Patch(const SurfaceMotion& motion, const Moment& moment, const std::array<double, 4>& weight) noexcept
        : m_motion(motion)
        , m_moment(moment)
        , m_weight(weight)
    {
    }

    /// @tparam kSlopes  false: only the displacement
    template<bool kSlopes>
    [[nodiscard]] PALPATE_ALWAYS_INLINE Value at(const Vec3& X) noexcept
    {
        const MotionLattice& lattice = m_motion.m_lattice;
        const double perCell = 1.0 / lattice.spacing_mm;
        const Vec3 s = perCell * (X - lattice.origin_mm);
        const Along x(s.x(), lattice.cells[0], perCell), y(s.y(), lattice.cells[1], perCell),
            z(s.z(), lattice.cells[2], perCell);
        const std::size_t first = lattice.control(static_cast<std::size_t>(x.cell), static_cast<std::size_t>(y.cell),
                                                  static_cast<std::size_t>(z.cell));
        const std::array<double, 4>* controls = m_motion.m_controls.data() + m_moment.frame[0] + first;
        std::size_t row = lattice.cells[0] + 2, slab = row * (lattice.cells[1] + 2);
        double scale = m_weight[0];
        if (m_moment.frames > 1) {
            gather(first, row, slab);
            controls = m_sum.data();
            row = 3;
            slab = 9;
            scale = 1.0;
        }
        const auto mean = [](const std::array<Two, 3>& w, const Lanes& a, const Lanes& b, const Lanes& c) {
            return w[0] * a + w[1] * b + w[2] * c;
        };
        std::array<Lanes, 3> inSlab, slabX, slabY;
        for (std::size_t k = 0; k < 3; ++k) {
            std::array<Lanes, 3> value, change;
            for (std::size_t j = 0; j < 3; ++j) {
                const std::array<double, 4>* at = controls + j * row + k * slab;
                const Lanes a = read(at[0]), b = read(at[1]), c = read(at[2]);
                value[j] = mean(x.weight, a, b, c);
                if constexpr (kSlopes) {
                    change[j] = mean(x.slope, a, b, c);
                }
            }
            inSlab[k] = mean(y.weight, value[0], value[1], value[2]);
            if constexpr (kSlopes) {
                slabX[k] = mean(y.weight, change[0], change[1], change[2]);
                slabY[k] = mean(y.slope, value[0], value[1], value[2]);
            }
        }
        Value value;
        value.raw = vectorOf(mean(z.weight, inSlab[0], inSlab[1], inSlab[2]));
        value.u = scale * value.raw;
        if constexpr (kSlopes) {
            value.gradient.col(0) = scale * vectorOf(mean(z.weight, slabX[0], slabX[1], slabX[2]));
            value.gradient.col(1) = scale * vectorOf(mean(z.weight, slabY[0], slabY[1], slabY[2]));
            value.gradient.col(2) = scale * vectorOf(mean(z.slope, inSlab[0], inSlab[1], inSlab[2]));
        }
        return value;
    }

  private:
    /// Sums the frames, of which there are four, at the 27 control points of a cell.
    void gather(std::size_t first, std::size_t row, std::size_t slab) noexcept
    {
        if (m_hasSum && first == m_first) {
            return;
        }
        m_hasSum = true;
        m_first = first;
        const auto weightOf = [this](std::size_t f) { return Two(Two::Constant(m_weight[f])); };
        const Two w0 = weightOf(0), w1 = weightOf(1), w2 = weightOf(2), w3 = weightOf(3);
        const auto frameOf = [&](std::size_t f) { return m_motion.m_controls.data() + first + m_moment.frame[f]; };
        const auto *f0 = frameOf(0), *f1 = frameOf(1), *f2 = frameOf(2), *f3 = frameOf(3);
        std::array<double, 4>* sum = m_sum.data();
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t j = 0; j < 3; ++j) {
                for (std::size_t i = j * row + k * slab, end = i + 3; i < end; ++i, ++sum) {
                    const Lanes u = w0 * read(f0[i]) + w1 * read(f1[i]) + w2 * read(f2[i]) + w3 * read(f3[i]);
                    Eigen::Map<Two>(sum->data()) = u.xy;
                    Eigen::Map<Two>(sum->data() + 2) = u.z;
                }
            }
        }
    }

    const SurfaceMotion& m_motion;
    const Moment& m_moment;
    const std::array<double, 4>& m_weight;
    std::array<std::array<double, 4>, 27> m_sum;
    std::size_t m_first = 0;
    bool m_hasSum = false;
};

/// Cubic Hermite interpolation of the poses; the quaternion is normalised.
void SurfaceMotion::applyPose(double t, Moment& moment) const noexcept
{
    const double first_s = m_keys.front().time_s, last_s = m_keys.back().time_s;
    if (m_isPeriodic) {
        const double turns = (t - first_s) / (last_s - first_s);
        t = first_s + (turns - std::floor(turns)) * (last_s - first_s);
    }
    const bool rests = !m_isPeriodic && !(t > first_s && t < last_s);
    t = std::clamp(t, first_s, last_s);
    const auto next = std::upper_bound(m_keys.begin() + 1, m_keys.end() - 1, t,
                                       [](double time_s, const Key& key) { return time_s < key.time_s; });
    const Key &a = *(next - 1), &b = *next;
    const double h = b.time_s - a.time_s, s = (t - a.time_s) / h, r = 1.0 - s;
    const double a0 = r * r * (1.0 + 2.0 * s), b0 = s * s * (1.0 + 2.0 * r), a1 = h * s * r * r, b1 = -h * s * s * r;
    const double da0 = -6.0 * s * r / h, da1 = r * (r - 2.0 * s), db1 = s * (s - 2.0 * r);
    Eigen::Matrix<double, 7, 1> value, slope;
    for (int i = 0; i < 7; ++i) {
        const auto n = static_cast<std::size_t>(i);
        value[i] = a0 * a.value[n] + b0 * b.value[n] + a1 * a.slope[n] + b1 * b.slope[n];
        slope[i] = rests ? 0.0 : da0 * (a.value[n] - b.value[n]) + da1 * a.slope[n] + db1 * b.slope[n];
    }
    const Eigen::Vector4d q = value.head<4>(), dq = slope.head<4>();
    const double length = q.norm();
    const Eigen::Vector4d unit = q / length, turning = (dq - unit * unit.dot(dq)) / length;
    const core::Quaternion now(unit[3], unit[0], unit[1], unit[2]);
    const core::Quaternion change(turning[3], turning[0], turning[1], turning[2]);
    moment.turn = now.toRotationMatrix();
    moment.isTurned = !(unit.head<3>().array() == 0.0).all();
    moment.spin = 2.0 * (change * now.conjugate()).vec();
    moment.shift = value.tail<3>();
    moment.drift = slope.tail<3>();
}

/// During a change of pace the rate and the amplitude follow the cubic w = s² (3 − 2 s) of the share s of its duration,
/// and the own time its integral.
SurfaceMotion::Course SurfaceMotion::courseAt(double time_s) const noexcept
{
    const double since_s = time_s - m_start_s;
    if (m_ease_s == 0.0) {
        return {m_offset_s + m_rate * since_s,
                m_rate,
                m_pulseOffset_s + m_pulseRate * since_s,
                m_pulseRate,
                m_amplitude,
                0.0};
    }
    if (since_s >= m_ease_s) {
        const double half_s = 0.5 * m_ease_s; // the change took this long at the rates before, and at the new ones
        return {m_offset_s + m_before.rate * half_s + m_rate * (since_s - half_s),
                m_rate,
                m_pulseOffset_s + m_before.pulseRate * half_s + m_pulseRate * (since_s - half_s),
                m_pulseRate,
                m_amplitude,
                0.0};
    }
    const double s = std::max(0.0, since_s / m_ease_s);
    const double share = s * s * (3.0 - 2.0 * s), integral_s = m_ease_s * s * s * s * (1.0 - 0.5 * s);
    const double rate = m_rate - m_before.rate, pulseRate = m_pulseRate - m_before.pulseRate;
    const double amplitude = m_amplitude - m_before.amplitude;
    return {m_offset_s + m_before.rate * since_s + rate * integral_s,
            m_before.rate + rate * share,
            m_pulseOffset_s + m_before.pulseRate * since_s + pulseRate * integral_s,
            m_before.pulseRate + pulseRate * share,
            m_before.amplitude + amplitude * share,
            amplitude * 6.0 * s * (1.0 - s) / m_ease_s};
}

/// Time factors of the displacement.
void SurfaceMotion::applyBreath(const Course& course, Moment& moment) const noexcept
{
    const double t = course.phase_s;
    if (m_curve.empty()) {
        const internal::PeriodicCubic now(t, m_period_s, m_frames);
        moment.frames = 4;
        for (std::size_t i = 0; i < 4; ++i) {
            moment.frame[i] = now.step[i] * m_lattice.controlCount();
            moment.weight[i] = course.amplitude * now.weight[i];
            moment.slope[i] = course.rate * course.amplitude * now.slope[i] + course.amplitudeSlope * now.weight[i];
        }
        return;
    }
    const internal::PeriodicCubic now(t, m_period_s, m_curve.size());
    const double value = now.value(m_curve);
    moment.weight[0] = course.amplitude * value;
    moment.slope[0] = course.rate * course.amplitude * now.change(m_curve) + course.amplitudeSlope * value;
    moment.frames = m_frames;
    moment.frame[0] = 0;
    if (m_shift.isZero(0.0)) { // a ramp
        return;
    }
    const Vec3 shift = moment.turn * (moment.weight[0] * m_shift);
    moment.shift += shift;
    moment.drift += moment.spin.cross(shift) + moment.turn * (moment.slope[0] * m_shift);
}

SurfaceMotion::Moment SurfaceMotion::at(double time_s) const noexcept PALPATE_NONBLOCKING
{
    Moment moment;
    moment.turn.setIdentity();
    moment.shift.setZero();
    moment.spin.setZero();
    moment.drift.setZero();
    const Course course = courseAt(time_s);
    if (!m_keys.empty()) {
        applyPose(course.phase_s, moment);
        moment.spin *= course.rate;
        moment.drift *= course.rate;
    }
    if (m_period_s > 0.0) {
        applyBreath(course, moment);
    }
    if (m_pulse_s > 0.0) {
        const internal::PeriodicCubic now(course.pulse_s, m_pulse_s, m_pulse.size());
        moment.factor = now.value(m_pulse);
        moment.factorSlope = course.pulseRate * now.change(m_pulse);
    }
    return moment;
}

SurfaceMotion::Rest SurfaceMotion::toRest(const Moment& moment, const Vec3& p_W,
                                          const Vec3& near) const noexcept PALPATE_NONBLOCKING
{
    Rest rest;
    rest.arm = p_W - moment.shift;
    const Vec3 target = moment.isTurned ? Vec3(moment.turn.transpose() * rest.arm) : rest.arm;
    if (moment.frames == 0) {
        rest.X = target;
        rest.F = moment.turn;
        rest.invF = moment.turn.transpose();
        rest.residual_mm = 0.0;
        return rest;
    }
    Patch patch(*this, moment, moment.weight);
    rest.X = near;
    for (int steps = 1;; ++steps) {
        const Value value = patch.at<true>(rest.X);
        rest.u = value.raw;
        rest.F = value.gradient;
        rest.F.diagonal().array() += 1.0;
        rest.invF = rest.F.inverse();
        const Vec3 step = rest.invF * (target - rest.X - value.u);
        rest.X += step;
        // The gradient changes by at most m_bend per length: what a Newton step leaves needs no other evaluation.
        rest.residual_mm = 0.5 * m_bend * step.squaredNorm();
        if (!(rest.residual_mm > kEnough_mm) || steps == kMaxSteps) {
            break;
        }
    }
    if (moment.isTurned) {
        rest.F = moment.turn * rest.F;
        rest.invF = rest.invF * moment.turn.transpose();
    }
    return rest;
}

Vec3 SurfaceMotion::toWorld(const Moment& moment, const Vec3& X) const noexcept PALPATE_NONBLOCKING
{
    const Vec3 moved = moment.frames == 0 ? X : Vec3(X + Patch(*this, moment, moment.weight).at<false>(X).u);
    return (moment.isTurned ? Vec3(moment.turn * moved) : moved) + moment.shift;
}

Vec3 SurfaceMotion::toWorld(const Moment& moment, const Vec3& X, Mat3& F) const noexcept PALPATE_NONBLOCKING
{
    F = moment.turn;
    Vec3 moved = X;
    if (moment.frames > 0) {
        const Value value = Patch(*this, moment, moment.weight).at<true>(X);
        F += moment.turn * value.gradient;
        moved += value.u;
    }
    return (moment.isTurned ? Vec3(moment.turn * moved) : moved) + moment.shift;
}

Vec3 SurfaceMotion::velocity(const Moment& moment, const Vec3& X) const noexcept PALPATE_NONBLOCKING
{
    Rest rest;
    rest.X = X;
    rest.arm = toWorld(moment, X) - moment.shift;
    if (moment.frames == 1) {
        rest.u = Patch(*this, moment, moment.weight).at<false>(X).raw;
    }
    return velocity(moment, rest);
}

Vec3 SurfaceMotion::velocity(const Moment& moment, const Rest& rest) const noexcept PALPATE_NONBLOCKING
{
    Vec3 v = moment.drift;
    if (!m_keys.empty()) {
        v += moment.spin.cross(rest.arm);
    }
    if (moment.frames > 0) {
        const Vec3 change = moment.frames == 1 ? Vec3(moment.slope[0] * rest.u)
                                               : Patch(*this, moment, moment.slope).at<false>(rest.X).u;
        v += moment.isTurned ? Vec3(moment.turn * change) : change;
    }
    return v;
}

std::vector<Vec3> SurfaceMotion::placesAt(double time_s, std::span<const Vec3> rest) const
{
    const Moment moment = at(time_s);
    std::vector<Vec3> places(rest.size());
    std::transform(rest.begin(), rest.end(), places.begin(), [&](const Vec3& X) { return toWorld(moment, X); });
    return places;
}

} // namespace palpate::geometry
