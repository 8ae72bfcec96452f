// SPDX-License-Identifier: BSD-3-Clause
#include "HaplyBench.h"

#include <algorithm>

namespace standin {

namespace {

constexpr std::int64_t kHaplyStep_ns = 100'000;
// As the hand of the other stand-ins (Bench.h).
constexpr double kHandStiffness_N_per_m = 500.0;
constexpr double kHandDamping_Ns_per_m = 5.0;
constexpr double kHandMass_kg = 0.1;

void stepHaply(HaplyDevice& device, std::int64_t now_ns)
{
    const double dt_s = static_cast<double>(kHaplyStep_ns) * 1e-9;
    const double since_s = static_cast<double>(now_ns - device.begin_ns) * 1e-9;
    const double u = device.duration_s > 0.0 ? std::clamp(since_s / device.duration_s, 0.0, 1.0) : 1.0;
    const double share = u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
    const double rate = device.duration_s > 0.0 ? 30.0 * u * u * (1.0 - u) * (1.0 - u) / device.duration_s : 0.0;
    const double mass_kg = device.mass_kg + (device.isHeld ? kHandMass_kg : 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        double f = device.f[i] - device.viscosity_Ns_per_m * device.v[i];
        if (device.isHeld) {
            const double way = device.to[i] - device.from[i];
            f += kHandStiffness_N_per_m * (device.from[i] + way * share - device.p[i]) +
                 kHandDamping_Ns_per_m * (way * rate - device.v[i]);
        }
        device.v[i] += f / mass_kg * dt_s;
        device.p[i] += device.v[i] * dt_s;
    }
}

} // namespace

void advanceHaply(HaplyBench& bench, std::int64_t now_ns)
{
    if (bench.sim_ns == 0) {
        bench.sim_ns = now_ns / kHaplyStep_ns * kHaplyStep_ns;
    }
    while (bench.sim_ns + kHaplyStep_ns <= now_ns) {
        bench.sim_ns += kHaplyStep_ns;
        for (HaplyDevice& device : bench.devices) {
            stepHaply(device, bench.sim_ns);
        }
    }
}

} // namespace standin
