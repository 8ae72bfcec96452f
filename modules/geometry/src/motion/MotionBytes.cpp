// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/SurfaceMotion.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace palpate::geometry {

using core::Status;
using core::StatusCode;

namespace {

constexpr double kFormat = 1.0;
constexpr double kChangedFormat = 2.0; // with the numbers of a change of pace at the end

/// Reads numbers in sequence; NaN after the last one.
class NumberReader
{
  public:
    explicit NumberReader(std::span<const std::byte> bytes)
        : m_left(bytes)
    {
    }
    double next()
    {
        double value = std::numeric_limits<double>::quiet_NaN();
        if (m_left.size() >= sizeof value) {
            std::memcpy(&value, m_left.data(), sizeof value);
            m_left = m_left.subspan(sizeof value);
        }
        return value;
    }
    /// Returns a count of entries that each take `numbers` numbers; more than are left becomes one too many.
    std::size_t count(std::size_t numbers)
    {
        const double value = next();
        const std::size_t most = m_left.size() / (numbers * sizeof(double));
        return value >= 0.0 && value <= static_cast<double>(most) ? static_cast<std::size_t>(value) : most + 1;
    }
    void read(std::vector<double>& values)
    {
        values.resize(count(1));
        for (double& value : values) {
            value = next();
        }
    }
    [[nodiscard]] bool isAtEnd() const { return m_left.empty(); }

  private:
    std::span<const std::byte> m_left;
};

bool isShare(double share)
{
    return share >= 0.0 && share <= 1.0;
}

} // namespace

// The numbers are written in native order.
static_assert(std::endian::native == std::endian::little);

std::vector<std::byte> SurfaceMotion::bytes() const
{
    const bool isChanged = m_ease_s > 0.0;
    std::vector<double> out{
        isChanged ? kChangedFormat : kFormat, m_start_s, m_offset_s, m_rate, m_amplitude, m_period_s, m_pulse_s};
    const auto add = [&out](const auto& values) { out.insert(out.end(), values.begin(), values.end()); };
    const auto addCurve = [&](const std::vector<double>& curve) {
        out.push_back(static_cast<double>(curve.size()));
        add(curve);
    };
    addCurve(m_curve);
    addCurve(m_pulse);
    add(m_shift);
    out.push_back(m_isPeriodic ? 1.0 : 0.0);
    out.push_back(static_cast<double>(m_keys.size()));
    for (const Key& key : m_keys) {
        out.push_back(key.time_s);
        add(key.value);
        add(key.slope);
    }
    add(m_lattice.origin_mm);
    out.push_back(m_lattice.spacing_mm);
    add(m_lattice.cells);
    out.push_back(static_cast<double>(m_frames));
    out.push_back(static_cast<double>(m_controls.size()));
    for (const std::array<double, 4>& u : m_controls) {
        out.insert(out.end(), u.begin(), u.begin() + 3);
    }
    if (isChanged) {
        add(std::array{m_ease_s, m_before.rate, m_before.pulseRate, m_before.amplitude, m_pulseOffset_s, m_pulseRate});
    }
    const auto bytes = std::as_bytes(std::span(out));
    return {bytes.begin(), bytes.end()};
}

SurfaceMotion::Made SurfaceMotion::fromBytes(std::span<const std::byte> bytes)
{
    const Status wrong(
        StatusCode::BadFormat,
        PALPATE_TEXT("found %1 bytes that are no motion of this version, expected one that Palpate wrote"),
        bytes.size());
    NumberReader in(bytes);
    const double format = in.next();
    if (format != kFormat && format != kChangedFormat) {
        return wrong;
    }
    auto motion = std::make_shared<SurfaceMotion>();
    for (double* value : {&motion->m_start_s, &motion->m_offset_s, &motion->m_rate, &motion->m_amplitude,
                          &motion->m_period_s, &motion->m_pulse_s}) {
        *value = in.next();
        if (!std::isfinite(*value)) {
            return wrong;
        }
    }
    in.read(motion->m_curve);
    in.read(motion->m_pulse);
    for (double& value : motion->m_shift) {
        value = in.next();
    }
    motion->m_isPeriodic = in.next() == 1.0;
    motion->m_keys.resize(in.count(1 + 2 * 7));
    bool isFinite = true;
    for (Key& key : motion->m_keys) {
        key.time_s = in.next();
        for (double& value : key.value) {
            value = in.next();
        }
        for (double& value : key.slope) {
            value = in.next();
            isFinite = isFinite && std::isfinite(value);
        }
    }
    for (double& value : motion->m_lattice.origin_mm) {
        value = in.next();
    }
    motion->m_lattice.spacing_mm = in.next();
    for (std::uint32_t& cells : motion->m_lattice.cells) {
        const double count = in.next();
        isFinite = isFinite && count >= 0.0 && count <= 65536.0;
        cells = isFinite ? static_cast<std::uint32_t>(count) : 0;
    }
    const double frames = in.next();
    isFinite = isFinite && frames >= 0.0 && frames <= 65536.0;
    motion->m_frames = isFinite ? static_cast<std::size_t>(frames) : 0;
    motion->m_controls.resize(in.count(3));
    for (std::array<double, 4>& u : motion->m_controls) {
        u = {in.next(), in.next(), in.next(), 0.0};
    }
    motion->m_pulseOffset_s = motion->m_offset_s;
    motion->m_pulseRate = motion->m_rate;
    if (format == kChangedFormat) {
        for (double* value : {&motion->m_ease_s, &motion->m_before.rate, &motion->m_before.pulseRate,
                              &motion->m_before.amplitude, &motion->m_pulseOffset_s, &motion->m_pulseRate}) {
            *value = in.next();
            isFinite = isFinite && std::isfinite(*value);
        }
        isFinite = isFinite && motion->m_ease_s > 0.0;
    }
    for (const std::vector<double>* curve : {&motion->m_curve, &motion->m_pulse}) {
        for (const double value : *curve) {
            isFinite = isFinite && std::isfinite(value);
        }
    }
    const bool hasCurve = motion->m_period_s == 0.0 || !motion->m_curve.empty() || motion->m_frames >= 2;
    const bool hasPulse = motion->m_pulse_s == 0.0 || !motion->m_pulse.empty();
    const bool isOneFrame = motion->m_curve.empty() || motion->m_frames <= 1;
    const bool hasKeys = motion->m_keys.size() != 1 && (!motion->m_isPeriodic || !motion->m_keys.empty());
    if (!in.isAtEnd() || !isFinite || !hasCurve || !hasPulse || !isOneFrame || !hasKeys || motion->m_period_s < 0.0 ||
        motion->m_pulse_s < 0.0 || !isShare(motion->m_amplitude) || !isShare(motion->m_before.amplitude)) {
        return wrong;
    }
    if (Status status = motion->check(); !status.isOk()) {
        return status;
    }
    return std::shared_ptr<const SurfaceMotion>(std::move(motion));
}

} // namespace palpate::geometry
