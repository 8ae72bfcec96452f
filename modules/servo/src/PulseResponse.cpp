// SPDX-License-Identifier: BSD-3-Clause
#include "PulseResponse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace palpate::servo {

namespace {

constexpr double kBefore_s = 0.008;
constexpr double kJudged_s = 0.024;
constexpr double kShown_s = 0.04;
constexpr double kFitted_s = 0.04;
constexpr double kMostDelay_s = 0.02;
constexpr double kLeastFriction_N = 1e-3;
constexpr double kUnmoved_mm = 1e-6;

using PulseSamples = std::span<const SelfTestSample>;

bool isPulseStart(PulseSamples samples, std::size_t i) noexcept
{
    const SelfTestSample& s = samples[i];
    return s.step == SelfTestStep::RoundTrip && s.part != 0 && i > 0 &&
           (samples[i - 1].step != s.step || samples[i - 1].part != s.part);
}

/// Straight line through the positions before a pulse, those of `kBefore_s` and of the tick that sends it.
class LineBefore
{
  public:
    LineBefore(PulseSamples samples, std::size_t start, const Vec3& u_D) noexcept
        : m_samples(samples)
        , m_u_D(u_D)
        , m_start_s(samples[start].time_s)
    {
        constexpr std::size_t kLeast = 4;
        double count = 0.0, t = 0.0, x = 0.0, tt = 0.0, tx = 0.0;
        for (std::size_t i = start + 1; i-- > 0 && (start - i < kLeast || m_start_s - samples[i].time_s < kBefore_s);) {
            const double ti = samples[i].time_s - m_start_s, xi = u_D.dot(samples[i].p_D);
            count += 1.0;
            t += ti;
            x += xi;
            tt += ti * ti;
            tx += ti * xi;
        }
        const double spread = count * tt - t * t;
        m_v = spread > 0.0 ? (count * tx - t * x) / spread : 0.0;
        m_x = (x - m_v * t) / count;
    }
    [[nodiscard]] double since_s(std::size_t i) const noexcept { return m_samples[i].time_s - m_start_s; }
    [[nodiscard]] double deviation_mm(std::size_t i) const noexcept
    {
        return m_u_D.dot(m_samples[i].p_D) - m_x - m_v * since_s(i);
    }

  private:
    PulseSamples m_samples;
    const Vec3& m_u_D;
    double m_start_s;
    double m_x = 0.0, m_v = 0.0;
};

/// Mean deviation after the pulses, turned so that the first half is positive: time [ms], way [mm].
std::vector<std::array<double, 2>> meanResponse(PulseSamples samples, const std::vector<std::size_t>& starts,
                                                const Vec3& u_D)
{
    std::vector<std::array<double, 2>> mean;
    std::vector<double> counts;
    for (const std::size_t start : starts) {
        const LineBefore line(samples, start, u_D);
        const double sign = samples[start].force_N < 0.0 ? -1.0 : 1.0;
        for (std::size_t k = 0; start + k < samples.size() && line.since_s(start + k) <= kShown_s; ++k) {
            if (k == mean.size()) {
                mean.push_back({});
                counts.push_back(0.0);
            }
            mean[k][0] += 1000.0 * line.since_s(start + k);
            mean[k][1] += sign * line.deviation_mm(start + k);
            counts[k] += 1.0;
        }
    }
    const double all = static_cast<double>(starts.size());
    std::size_t size = 0;
    for (; size < mean.size() && counts[size] == all; ++size) {
        mean[size] = {mean[size][0] / all, mean[size][1] / all};
    }
    mean.resize(size);
    return mean;
}

/// Handle and hand: damping and stiffness per mass, and the Coulomb friction.
struct HandleModel
{
    double damping_per_s = 0.0;
    double stiffness_per_s2 = 0.0;
    double friction_N = 0.0;
};

/// Position of 1 kg under the forces of all pulses, in steps of kModelStep_s from the first sample on [mm].
constexpr double kModelStep_s = 2e-4;
std::vector<double> simulated(PulseSamples samples, const HandleModel& model)
{
    std::vector<double> way;
    const double end_s = samples.back().time_s - samples.front().time_s;
    way.reserve(static_cast<std::size_t>(end_s / kModelStep_s) + 2);
    const double lost = model.friction_N * kModelStep_s;
    double x = 0.0, v = 0.0;
    std::size_t i = 0;
    for (double t = 0.0; t <= end_s; t += kModelStep_s) {
        way.push_back(1000.0 * x);
        while (i + 1 < samples.size() && samples[i + 1].time_s - samples[0].time_s <= t + 0.5 * kModelStep_s) {
            ++i;
        }
        v += (samples[i].force_N - model.damping_per_s * v - model.stiffness_per_s2 * x) * kModelStep_s;
        v = std::abs(v) > lost ? v - std::copysign(lost, v) : 0.0;
        x += v * kModelStep_s;
    }
    return way;
}

/// Compares the positions around the pulses with a model. A straight line is removed from each pulse, so that neither
/// the place nor a slow motion of the hand matters; the model contains what is left of earlier pulses.
class PulseFit
{
  public:
    struct Result
    {
        double delay_s = 0.0;
        double perMass = 0.0; ///< 1/kg
        double error = std::numeric_limits<double>::infinity();
    };

    PulseFit(PulseSamples samples, const std::vector<std::size_t>& starts, const Vec3& u_D, double dt_s)
        : m_samples(samples)
        , m_before(static_cast<std::size_t>(std::lround(kBefore_s / dt_s)))
        , m_length(m_before + static_cast<std::size_t>(std::lround(kFitted_s / dt_s)))
    {
        for (const std::size_t start : starts) {
            if (start >= m_before && start - m_before + m_length <= samples.size()) {
                m_from.push_back(start - m_before);
                for (std::size_t k = 0; k < m_length; ++k) {
                    m_measured.push_back(u_D.dot(samples[m_from.back() + k].p_D));
                }
                removeLine(std::span(m_measured).last(m_length));
            }
        }
    }
    [[nodiscard]] std::size_t pulses() const { return m_from.size(); }

    /// @param first, count  pulses to compare
    [[nodiscard]] Result at(const std::vector<double>& way, double delay_s, std::size_t first, std::size_t count) const
    {
        std::vector<double> line(m_length);
        double sx = 0.0, ss = 0.0, xx = 0.0;
        for (std::size_t pulse = first; pulse < first + count; ++pulse) {
            for (std::size_t k = 0; k < m_length; ++k) {
                line[k] = interpolated(way, m_samples[m_from[pulse] + k].time_s - m_samples[0].time_s - delay_s);
            }
            removeLine(line);
            for (std::size_t k = 0; k < m_length; ++k) {
                const double x = m_measured[pulse * m_length + k];
                sx += line[k] * x;
                ss += line[k] * line[k];
                xx += x * x;
            }
        }
        return {delay_s, ss > 0.0 ? sx / ss : 0.0, ss > 0.0 ? xx - sx * std::max(sx, 0.0) / ss : xx};
    }
    /// Best delay of the range.
    [[nodiscard]] Result best(const std::vector<double>& way, double from_s, double to_s, double step_s,
                              std::size_t first, std::size_t count) const
    {
        Result best;
        for (double delay_s = std::max(0.0, from_s); delay_s <= to_s; delay_s += step_s) {
            const Result result = at(way, delay_s, first, count);
            best = result.error < best.error ? result : best;
        }
        return best;
    }

  private:
    static double interpolated(const std::vector<double>& way, double time_s)
    {
        const double at = std::clamp(time_s / kModelStep_s, 0.0, static_cast<double>(way.size() - 1));
        const auto i = std::min(static_cast<std::size_t>(at), way.size() - 2);
        const double share = at - static_cast<double>(i);
        return way[i] + share * (way[i + 1] - way[i]);
    }
    static void removeLine(std::span<double> values)
    {
        const double middle = 0.5 * static_cast<double>(values.size() - 1);
        double mean = 0.0, slope = 0.0, spread = 0.0;
        for (std::size_t k = 0; k < values.size(); ++k) {
            const double t = static_cast<double>(k) - middle;
            mean += values[k];
            slope += t * values[k];
            spread += t * t;
        }
        mean /= static_cast<double>(values.size());
        slope /= spread;
        for (std::size_t k = 0; k < values.size(); ++k) {
            values[k] -= mean + slope * (static_cast<double>(k) - middle);
        }
    }

    PulseSamples m_samples;
    std::size_t m_before, m_length; ///< samples of a pulse
    std::vector<std::size_t> m_from;
    std::vector<double> m_measured;
};

/// Model and delay that fit best.
struct FittedPulses
{
    HandleModel model;
    std::vector<double> way;
    PulseFit::Result fit;
};

/// Searches from a coarse grid on, then by a simplex in the logarithms of the model and the delay.
/// @par Source Nelder & Mead, Computer Journal 7 (1965) 308.
FittedPulses fitted(PulseSamples samples, const PulseFit& pulses, double friction_N)
{
    constexpr std::size_t kSize = 4;
    constexpr double kPerStep_s = 1e-3; // of delay, for a step of 1
    using Point = std::array<double, kSize>;
    const std::size_t all = pulses.pulses();
    FittedPulses best;
    const auto attempt = [&](const HandleModel& model, double from_s, double to_s) {
        std::vector<double> way = simulated(samples, model);
        const PulseFit::Result fit = pulses.best(way, from_s, to_s, kPerStep_s, 0, all);
        if (fit.error < best.fit.error) {
            best = {model, std::move(way), fit};
        }
        return fit.error;
    };
    const auto errorAt = [&](const Point& p) {
        return p[3] < 0.0
                   ? std::numeric_limits<double>::infinity()
                   : attempt({std::exp(p[0]), std::exp(p[1]), std::exp(p[2])}, kPerStep_s * p[3], kPerStep_s * p[3]);
    };
    for (const double damping : {1.0, 10.0, 40.0, 160.0}) {
        for (const double stiffness : {10.0, 500.0, 2e3, 6e3, 2e4}) {
            (void)attempt({damping, stiffness, friction_N}, 0.0, kMostDelay_s);
        }
    }
    struct Corner
    {
        Point p;
        double error;
    };
    const Point start{std::log(best.model.damping_per_s), std::log(best.model.stiffness_per_s2),
                      std::log(best.model.friction_N), best.fit.delay_s / kPerStep_s};
    std::array<Corner, kSize + 1> corners;
    for (std::size_t i = 0; i <= kSize; ++i) {
        Point p = start;
        if (i < kSize) {
            p[i] += i == 2 ? -1.0 : 0.7; // the friction of a held handle is measured too high
        }
        corners[i] = {p, errorAt(p)};
    }
    constexpr int kSteps = 150;
    for (int step = 0; step < kSteps; ++step) {
        std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) { return a.error < b.error; });
        Corner& worst = corners.back();
        Point centre{};
        for (std::size_t i = 0; i < kSize; ++i) {
            for (std::size_t k = 0; k < kSize; ++k) {
                centre[k] += corners[i].p[k] / static_cast<double>(kSize);
            }
        }
        const auto along = [&](double share) {
            Corner c{};
            for (std::size_t k = 0; k < kSize; ++k) {
                c.p[k] = centre[k] + share * (worst.p[k] - centre[k]);
            }
            c.error = errorAt(c.p);
            return c;
        };
        Corner tried = along(-1.0);
        if (tried.error < corners.front().error) {
            const Corner farther = along(-2.0);
            tried = farther.error < tried.error ? farther : tried;
        } else if (!(tried.error < corners[kSize - 1].error)) {
            tried = along(tried.error < worst.error ? -0.5 : 0.5);
        }
        if (tried.error < worst.error) {
            worst = tried;
            continue;
        }
        for (std::size_t i = 1; i <= kSize; ++i) { // shrink
            for (std::size_t k = 0; k < kSize; ++k) {
                corners[i].p[k] = 0.5 * (corners[i].p[k] + corners[0].p[k]);
            }
            corners[i].error = errorAt(corners[i].p);
        }
    }
    return best;
}

} // namespace

PulseVerdict verdictOf(PulseSamples samples, const Vec3& u_D) noexcept
{
    double with = 0.0, against = 0.0;
    for (std::size_t start = 1; start < samples.size(); ++start) {
        if (!isPulseStart(samples, start)) {
            continue;
        }
        const LineBefore line(samples, start, u_D);
        double sum_mm = 0.0;
        for (std::size_t i = start; i < samples.size() && line.since_s(i) <= kJudged_s; ++i) {
            sum_mm += line.deviation_mm(i);
        }
        if (std::abs(sum_mm) > kUnmoved_mm) {
            ((sum_mm > 0.0) == (samples[start].force_N > 0.0) ? with : against) += 1.0;
        }
    }
    constexpr double kDeviations = 4.0;
    const double bound = kDeviations * std::sqrt(with + against);
    const double excess = with - against;
    return std::abs(excess) < bound || excess == 0.0 ? PulseVerdict::Unclear
           : excess > 0.0                            ? PulseVerdict::Follows
                                                     : PulseVerdict::Reversed;
}

std::optional<RoundTripMeasure> roundTripOf(const SelfTestRecord& record, double friction_N)
{
    const auto isPulse = [](const SelfTestSample& s) { return s.step == SelfTestStep::RoundTrip; };
    const auto begin = std::find_if(record.samples.begin(), record.samples.end(), isPulse);
    const auto end = std::find_if_not(begin, record.samples.end(), isPulse);
    const PulseSamples samples(begin, end);
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (isPulseStart(samples, i)) {
            starts.push_back(i);
        }
    }
    const PulseFit pulses(samples, starts, record.u_D, 1.0 / record.rate_Hz);
    constexpr std::size_t kLeast = 5;
    if (pulses.pulses() < kLeast) {
        return std::nullopt;
    }
    const FittedPulses found = fitted(samples, pulses, std::max(friction_N, kLeastFriction_N));
    if (!(found.fit.perMass > 0.0) || found.fit.delay_s > kMostDelay_s) {
        return std::nullopt;
    }
    RoundTripMeasure out;
    out.pulses = static_cast<int>(pulses.pulses());
    out.median_ms = 1000.0 * found.fit.delay_s;
    out.mass_kg = 1.0 / found.fit.perMass;
    out.response_mm = meanResponse(samples, starts, record.u_D);
    constexpr double kCoarse_s = 5e-4, kFine_s = 5e-5;
    for (std::size_t pulse = 0; pulse < pulses.pulses(); ++pulse) {
        const double near_s = pulses.best(found.way, 0.0, kMostDelay_s, kCoarse_s, pulse, 1).delay_s;
        const auto one = pulses.best(found.way, near_s - kCoarse_s, near_s + kCoarse_s, kFine_s, pulse, 1);
        out.each_ms.push_back(1000.0 * one.delay_s);
    }
    std::vector<double> sorted = out.each_ms;
    std::sort(sorted.begin(), sorted.end());
    constexpr double kMost = 0.99;
    out.p99_ms = sorted[static_cast<std::size_t>(std::ceil(kMost * static_cast<double>(sorted.size() - 1)))];
    return out;
}

} // namespace palpate::servo
