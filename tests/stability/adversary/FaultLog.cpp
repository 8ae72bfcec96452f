// SPDX-License-Identifier: BSD-3-Clause
#include "FaultLog.h"

#include <cstdio>

namespace palpate::adversary {

void FaultLog::add(const Fault& fault, std::int64_t tick, const Vec3& hip, const std::string& scene)
{
    if (!m_known.insert(fault.what).second) {
        return;
    }
    ++m_tally.seedsByFault[fault.what];
    char text[768];
    std::snprintf(text, sizeof text,
                  "adversary %s %llu: tick %lld, %s: %.4g %s, from (%.9g %.9g %.9g) to (%.9g %.9g %.9g), HIP (%.9g "
                  "%.9g %.9g); %s",
                  nameOf(m_family), static_cast<unsigned long long>(m_seed), static_cast<long long>(tick),
                  fault.what.c_str(), fault.amount, fault.unit.c_str(), fault.from.x(), fault.from.y(), fault.from.z(),
                  fault.to.x(), fault.to.y(), fault.to.z(), hip.x(), hip.y(), hip.z(), scene.c_str());
    m_tally.lines.emplace_back(text);
}

std::uint64_t firstOf(Family family, std::uint64_t seed)
{
    const auto number = static_cast<std::uint64_t>(family);
    return (number < 4 ? number : number << 48) + 4 * seed;
}

} // namespace palpate::adversary
