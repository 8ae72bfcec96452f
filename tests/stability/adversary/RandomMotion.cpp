// SPDX-License-Identifier: BSD-3-Clause
#include "RandomMotion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace palpate::adversary {

namespace {

using geometry::Breath;
using geometry::MotionLattice;
using geometry::PoseKey;
using geometry::SurfaceMotion;
using LongQuaternion = Eigen::Quaternion<long double>;

constexpr std::size_t kSteps = 256; ///< of a tabulated curve

std::vector<double> powersOfSine(int exponent)
{
    std::vector<double> table(kSteps);
    for (std::size_t i = 0; i < kSteps; ++i) {
        table[i] = std::pow(std::sin(std::numbers::pi * static_cast<double>(i) / double(kSteps)), exponent);
    }
    return table;
}

/// Cubic Hermite interpolation between two values with slopes per step.
long double hermite(long double s, long double a, long double b, long double atA, long double atB)
{
    const long double r = 1 - s;
    return a * (1 + 2 * s) * r * r + b * s * s * (3 - 2 * s) + atA * s * r * r - atB * s * s * r;
}

/// Cell and place in it of a periodic quantity.
std::pair<std::size_t, long double> stepOf(long double turns, std::size_t steps)
{
    const long double at = (turns - std::floor(turns)) * static_cast<long double>(steps);
    const auto cell = std::min(static_cast<std::size_t>(at), steps - 1);
    return {cell, at - static_cast<long double>(cell)};
}

/// The uniform quadratic B-spline around its centre, in cells.
long double spline(long double r)
{
    r = std::abs(r);
    return r < 0.5L ? 0.75L - r * r : r < 1.5L ? 0.5L * (1.5L - r) * (1.5L - r) : 0.0L;
}

} // namespace

RandomMotion::RandomMotion(const core::Box& box, Chance& chance)
{
    m_period_s = chance.magnitude(0.02, 8.0);
    switch (chance.below(6)) {
    case 0:
    case 1:
        makePoses(box, chance);
        break;
    case 2:
    case 3:
        makeBreath(box, chance);
        break;
    default:
        makeFrames(box, chance);
        break;
    }
}

void RandomMotion::makePoses(const core::Box& box, Chance& chance)
{
    const double size_mm = box.diagonal().norm(), far_mm = box.center().norm();
    m_kind = chance.is(0.4) ? Kind::Glide : Kind::Poses;
    m_name = m_kind == Kind::Glide ? "glide" : "poses";
    m_isPeriodic = chance.is(0.7);
    // Far from the origin a turn is a shift: the interpolation of a turn about the centre is not one.
    const double turn = m_kind == Kind::Glide ? 0.0 : 0.6 * std::min(1.0, size_mm / (1e-3 + far_mm));
    const double amount_mm = chance.magnitude(1e-3, 1.0) * size_mm;
    const int keys = chance.whole(3, 9);
    for (int i = 0; i < keys; ++i) {
        core::Transform pose = core::Transform::Identity();
        pose.linear() = Eigen::AngleAxisd(turn * chance.between(-1, 1), chance.direction()).matrix();
        pose.translation() = box.center() - pose.linear() * box.center() + amount_mm * chance.inCube();
        const double spread = m_kind == Kind::Glide ? 0.0 : chance.between(-0.3, 0.3);
        m_keys.push_back({m_period_s * (i + spread) / (keys - 1), pose});
    }
    m_keys.front().time_s = 0.0;
    m_keys.back().time_s = m_period_s;
    if (m_isPeriodic) {
        m_keys.back().X_WR = m_keys.front().X_WR;
    }
    m_engine = SurfaceMotion::poses(m_keys, m_isPeriodic).value();
}

void RandomMotion::makeBreath(const core::Box& box, Chance& chance)
{
    const double size_mm = box.diagonal().norm();
    Breath breath;
    breath.period_s = m_period_s;
    breath.exponent = 2 * chance.whole(1, 3);
    breath.amplitude_mm = chance.magnitude(1e-3, 1.0) * size_mm * chance.direction();
    m_curve = powersOfSine(breath.exponent);
    m_shift = breath.amplitude_mm;
    m_kind = Kind::Breath;
    m_name = "breath";
    if (chance.is(0.5)) {
        m_kind = Kind::Ramp;
        m_name = "ramp";
        const Vec3 along = chance.direction();
        breath.still_W = box.center() - chance.between(0.3, 0.6) * size_mm * along;
        breath.full_W = box.center() + chance.between(0.3, 0.6) * size_mm * along;
        // The ramp's steepest slope is 1.5 of its mean, and the coefficients bound it from above.
        breath.amplitude_mm *= std::min(1.0, 0.17 * (breath.full_W - breath.still_W).norm() / m_shift.norm());
        m_shift = breath.amplitude_mm;
        m_lattice.spacing_mm =
            std::max(std::min(10.0, (breath.full_W - breath.still_W).norm() / 8.0), box.sizes().maxCoeff() / 64.0);
    }
    m_engine = SurfaceMotion::breath(breath, box).value();
}

void RandomMotion::makeFrames(const core::Box& box, Chance& chance)
{
    m_kind = Kind::Frames;
    m_name = "frames";
    const double size_mm = box.diagonal().norm();
    const double spacing_mm = size_mm * chance.magnitude(0.06, 0.5), around_mm = size_mm * chance.between(0.0, 0.3);
    m_lattice =
        MotionLattice::around(core::Box(box.min().array() - around_mm, box.max().array() + around_mm), spacing_mm);
    m_frames.resize(chance.is(0.5) ? 4 : static_cast<std::size_t>(chance.whole(2, 9)));
    const bool isSmooth = chance.is(0.3); // waves through the whole instead of independent control points
    for (std::vector<Vec3>& frame : m_frames) {
        const Vec3 amount = chance.inCube(), wave = 2.0 / size_mm * chance.inCube();
        for (std::size_t i = 0; i < m_lattice.controlCount(); ++i) {
            const std::size_t row = m_lattice.cells[0] + 2, slab = row * (m_lattice.cells[1] + 2);
            const Vec3 p = m_lattice.place(i % row, i % slab / row, i / slab) - box.center();
            frame.push_back(isSmooth ? Vec3(amount * std::sin(wave.dot(p) * 6.0)) : chance.inCube());
        }
    }
    const auto scale = [this](double by) {
        for (std::vector<Vec3>& frame : m_frames) {
            for (Vec3& u : frame) {
                u *= by;
            }
        }
    };
    scale(1e-3 * spacing_mm);
    const double strain = SurfaceMotion::frames(m_period_s, m_lattice, m_frames).value()->strain();
    scale((chance.is(0.5) ? 0.999 : chance.share()) * SurfaceMotion::kMaxStrain / strain);
    m_engine = SurfaceMotion::frames(m_period_s, m_lattice, m_frames).value();
    for (std::vector<Vec3>& frame : m_frames) { // the outermost control points take the values of their neighbours
        for (std::size_t i = 0; i < frame.size(); ++i) {
            const std::size_t row = m_lattice.cells[0] + 2, slab = row * (m_lattice.cells[1] + 2);
            const auto inner = [&](std::size_t at, std::size_t axis) {
                return std::clamp<std::size_t>(at, 1, m_lattice.cells[axis]);
            };
            frame[i] = frame[m_lattice.control(inner(i % row, 0), inner(i % slab / row, 1), inner(i / slab, 2))];
        }
    }
}

void RandomMotion::addPulse(Chance& chance)
{
    m_name += ", pulse";
    m_pulse_s = chance.magnitude(0.05, 2.0);
    m_pulse = chance.between(0.0, 2.0);
    m_engine = SurfaceMotion::pulse(m_pulse_s, m_pulse, m_engine).value();
}

void RandomMotion::setClock(double start_s, double offset_s, double rate, double amplitude)
{
    m_start_s = start_s;
    m_offset_s = offset_s;
    m_rate = rate;
    m_amplitude = amplitude;
}

std::shared_ptr<const SurfaceMotion> RandomMotion::engine() const
{
    return m_engine == nullptr ? nullptr
                               : m_engine->withClock(m_start_s, m_offset_s, m_rate)->withAmplitude(m_amplitude);
}

long double RandomMotion::curve(const std::vector<double>& table, long double turns) const
{
    const auto [cell, s] = stepOf(turns, kSteps);
    const auto value = [&table, cell = cell](std::size_t steps) {
        return static_cast<long double>(table[(cell + kSteps + steps - 1) % kSteps]);
    };
    return hermite(s, value(1), value(2), (value(2) - value(0)) / 2, (value(3) - value(1)) / 2);
}

/// Weight of one frame: the periodic cubic through 1 at this frame and 0 at the others.
long double RandomMotion::weightOf(std::size_t frame, long double turns) const
{
    const std::size_t count = m_frames.size();
    const auto [cell, s] = stepOf(turns, count);
    const auto value = [=, cell = cell](std::size_t steps) {
        return (cell + count + steps - 1) % count == frame ? 1.0L : 0.0L;
    };
    return hermite(s, value(1), value(2), (value(2) - value(0)) / 2, (value(3) - value(1)) / 2);
}

Long3 RandomMotion::displacement(long double t, const Long3& X) const
{
    if (m_kind == Kind::Breath) {
        return m_amplitude * curve(m_curve, t / m_period_s) * m_shift.cast<long double>();
    }
    if (m_kind == Kind::Ramp) {
        const SurfaceMotion::Moment full = m_engine->at(0.5 * m_period_s);
        const Vec3 at = X.cast<double>();
        return m_amplitude * curve(m_curve, t / m_period_s) * (m_engine->toWorld(full, at) - at).cast<long double>();
    }
    if (m_kind != Kind::Frames) {
        return Long3::Zero();
    }
    std::array<std::size_t, 3> cell{};
    std::array<std::array<long double, 3>, 3> weight{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto n = static_cast<int>(axis);
        const long double cells = m_lattice.cells[axis];
        const long double at =
            std::clamp<long double>((X[n] - m_lattice.origin_mm[n]) / m_lattice.spacing_mm, 0.0L, cells);
        cell[axis] = std::min(static_cast<std::size_t>(at), std::size_t{m_lattice.cells[axis]} - 1);
        for (std::size_t i = 0; i < 3; ++i) { // control point i is at i - 1/2
            weight[axis][i] = spline(at - (static_cast<long double>(cell[axis] + i) - 0.5L));
        }
    }
    Long3 u = Long3::Zero();
    for (std::size_t f = 0; f < m_frames.size(); ++f) {
        const long double now = weightOf(f, t / m_period_s);
        for (std::size_t n = 0; now != 0 && n < 27; ++n) {
            const std::size_t i = n % 3, j = n / 3 % 3, k = n / 9;
            const Vec3& control = m_frames[f][m_lattice.control(cell[0] + i, cell[1] + j, cell[2] + k)];
            u += now * weight[0][i] * weight[1][j] * weight[2][k] * control.cast<long double>();
        }
    }
    return m_amplitude * u;
}

/// The pose at a time: cubic between the poses, with the mean slope of the two neighbours at each.
Long3 RandomMotion::posed(long double t, const Long3& X) const
{
    const std::size_t last = m_keys.size() - 1;
    const long double span = m_keys[last].time_s;
    if (m_isPeriodic) {
        t -= span * std::floor(t / span);
    }
    t = std::clamp<long double>(t, 0.0L, span);
    std::size_t i = 0;
    while (i + 1 < last && t >= m_keys[i + 1].time_s) {
        ++i;
    }
    using Seven = Eigen::Matrix<long double, 7, 1>;
    const auto valueOf = [this](std::size_t key) {
        const core::Transform& pose = m_keys[key].X_WR;
        LongQuaternion q(Eigen::Matrix<long double, 3, 3>(pose.linear().cast<long double>()));
        if (q.w() < 0) { // turns by less than half a circle
            q.coeffs() = -q.coeffs();
        }
        Seven value;
        value << q.x(), q.y(), q.z(), q.w(), pose.translation().cast<long double>();
        return value;
    };
    const auto slopeOf = [&](std::size_t key) -> Seven {
        if (m_isPeriodic && (key == 0 || key == last)) {
            return (valueOf(1) - valueOf(last - 1)) / (m_keys[1].time_s + (span - m_keys[last - 1].time_s));
        }
        const std::size_t a = key == 0 ? 0 : key - 1, b = key == last ? last : key + 1;
        return (valueOf(b) - valueOf(a)) / (static_cast<long double>(m_keys[b].time_s) - m_keys[a].time_s);
    };
    const long double h = static_cast<long double>(m_keys[i + 1].time_s) - m_keys[i].time_s;
    const long double s = (t - m_keys[i].time_s) / h;
    const Seven a = valueOf(i), b = valueOf(i + 1), da = slopeOf(i), db = slopeOf(i + 1);
    Seven now;
    for (int n = 0; n < 7; ++n) {
        now[n] = hermite(s, a[n], b[n], h * da[n], h * db[n]);
    }
    const LongQuaternion q = LongQuaternion(now[3], now[0], now[1], now[2]).normalized();
    return q.toRotationMatrix() * X + now.tail<3>();
}

Long3 RandomMotion::place(long double t, const Long3& X) const
{
    return placeAt(ownTime(t), X);
}

Long3 RandomMotion::placeAt(long double own, const Long3& X) const
{
    return m_keys.empty() ? Long3(X + displacement(own, X)) : posed(own, X);
}

Long3 RandomMotion::toRest(double t, const Long3& p) const
{
    const long double own = ownTime(t);
    if (!m_keys.empty()) { // the transpose of the turn
        const Long3 shift = posed(own, Long3::Zero());
        Long3 X;
        for (int n = 0; n < 3; ++n) {
            X[n] = (posed(own, Long3::Unit(n)) - shift).dot(p - shift);
        }
        return X;
    }
    Long3 X = p;
    for (int i = 0; i < 60; ++i) { // 0.3 to the power of 60 is 4e-32
        X = p - displacement(own, X);
    }
    return X;
}

Mat3 RandomMotion::gradient(double t, const Vec3& X) const
{
    const long double h = (m_kind == Kind::Ramp ? 1e-4L : 1e-6L) * m_lattice.spacing_mm;
    Mat3 F;
    for (int n = 0; n < 3; ++n) {
        const Long3 step = h * Long3::Unit(n), at = X.cast<long double>();
        F.col(n) = ((place(t, at + step) - place(t, at - step)) / (2 * h)).cast<double>();
    }
    return F;
}

double RandomMotion::gradientError(const Vec3& X) const
{
    // A step across the face of a cell sees the change of a second derivative.
    const double h = (m_kind == Kind::Ramp ? 1e-4 : 1e-6) * m_lattice.spacing_mm;
    const double rounding = m_kind == Kind::Ramp ? std::numeric_limits<double>::epsilon()
                                                 : double(std::numeric_limits<long double>::epsilon());
    return h * bend_per_mm() + 16.0 * rounding * (X.norm() + m_lattice.spacing_mm) / h;
}

double RandomMotion::bend_per_mm() const
{
    return strain() == 0.0 ? 0.0 : 4.0 * std::sqrt(3.0) * strain() / m_lattice.spacing_mm;
}

double RandomMotion::rate_per_s() const
{
    return m_kind == Kind::Ramp || m_kind == Kind::Frames
               ? std::abs(m_rate) * strain() * 10.0 * double(std::max<std::size_t>(m_frames.size(), 1)) / m_period_s
               : 0.0;
}

double RandomMotion::timeStep_s() const
{
    return m_kind == Kind::None || m_rate == 0.0 ? 0.0 : 1e-7 * m_period_s / std::abs(m_rate);
}

Vec3 RandomMotion::velocity(double t, const Vec3& X) const
{
    const long double h = timeStep_s(), now = t;
    if (h == 0) {
        return Vec3::Zero();
    }
    const Long3 at = X.cast<long double>();
    return ((place(now + h, at) - place(now - h, at)) / (2 * h)).cast<double>();
}

double RandomMotion::velocityError(double t, const Vec3& X) const
{
    const long double h = timeStep_s(), now = t;
    if (h == 0) {
        return 0.0;
    }
    double most_mm = X.norm() + m_shift.norm();
    for (const PoseKey& key : m_keys) {
        most_mm = std::max(most_mm, X.norm() + key.X_WR.translation().norm());
    }
    const Long3 at = X.cast<long double>();
    const Long3 jump = (place(now + h, at) - 2 * place(now, at) + place(now - h, at)) / h;
    // The engine computes in double.
    return double(jump.norm()) + 1e-12 * std::abs(m_rate) * most_mm / m_period_s;
}

/// With the unit roundoff u, half an epsilon, the own time o + r (t - t0) has an error of u (2 |r (t - t0)| + |own|):
/// of difference, product and sum. The quotient by the period adds u |own|, and the place in the period, at most 1, u
/// for its difference and u for its product with the steps: together 2 u periods. A change of the own time moves the
/// place also while the motion is held.
double RandomMotion::placeError(double t, const Vec3& X) const
{
    if (m_kind == Kind::None) {
        return 0.0;
    }
    const long double own = ownTime(t), h = 1e-7L * m_period_s;
    const Long3 at = X.cast<long double>();
    const long double speed = (placeAt(own + h, at) - placeAt(own - h, at)).norm() / (2 * h);
    const double since_s = std::abs(m_rate * (t - m_start_s));
    return std::numeric_limits<double>::epsilon() * (since_s + std::abs(double(own)) + m_period_s) * double(speed);
}

double RandomMotion::factor(double t) const
{
    static const std::vector<double> kPulse = powersOfSine(2);
    return m_pulse_s > 0.0 ? double(1 + m_pulse * curve(kPulse, ownTime(t) / m_pulse_s)) : 1.0;
}

double RandomMotion::factorSlope(double t) const
{
    if (m_pulse_s == 0.0 || m_rate == 0.0) {
        return 0.0;
    }
    const double h = 1e-5 * m_pulse_s / std::abs(m_rate); // of a double: 1e-11 of rounding
    return (factor(t + h) - factor(t - h)) / (2.0 * h);
}

} // namespace palpate::adversary
