// SPDX-License-Identifier: BSD-3-Clause
#include "SharedJudge.h"

#include <algorithm>
#include <cmath>

namespace palpate::adversary {

namespace {

std::span<const haptics::ActiveConstraint> planesOf(const haptics::TickResult& tick)
{
    return std::span(tick.active).first(tick.constraints);
}

/// Returns the sine of the angle between two normals, or the volume of three: 1 if orthogonal.
double spanOf(const std::vector<Vec3>& n)
{
    return n.size() == 1 ? 1.0 : n.size() == 2 ? n[0].cross(n[1]).norm() : std::abs(n[0].dot(n[1].cross(n[2])));
}

/// Returns whether each plane of one tick is also a plane of the other.
bool isWithin(const haptics::TickResult& one, const haptics::TickResult& other)
{
    return std::ranges::all_of(planesOf(one), [&](const haptics::ActiveConstraint& plane) {
        return std::ranges::any_of(planesOf(other), [&](const haptics::ActiveConstraint& known) {
            return known.structure == plane.structure && known.triangle == plane.triangle;
        });
    });
}

} // namespace

bool isOfSeveral(const haptics::TickResult& tick)
{
    return std::ranges::any_of(planesOf(tick), [&](const haptics::ActiveConstraint& plane) {
        return plane.structure != tick.active[0].structure;
    });
}

const char* SharedJudge::look(const std::vector<haptics::HapticStructure>& structures, const haptics::TickResult& tick,
                              const Vec3& hip, double rounding_mm, bool isPoint)
{
    const std::optional<Held> before = m_last;
    m_last.reset();
    double softest = 0.0, stiffest = 0.0;
    for (const haptics::ActiveConstraint& plane : planesOf(tick)) {
        const haptics::HapticStructure& on = structures[plane.structure];
        const double k = on.tissue.stiffness_N_per_mm;
        if (!on.isPlain() || on.tissue.damping_Ns_per_mm != 0.0) {
            return nullptr;
        }
        softest = stiffest == 0.0 ? k : std::min(softest, k);
        stiffest = std::max(stiffest, k);
    }
    if (tick.status != haptics::TickStatus::Converged || tick.constraints == 0) {
        return nullptr;
    }
    m_last = Held{tick, tick.p_WG - hip, stiffest};
    const Vec3& spring = m_last->spring;
    if (isPoint && before && (isOfSeveral(tick) || isOfSeveral(before->tick)) &&
        !changesAsMayBe(*before, *m_last, rounding_mm)) {
        return "force of a shared contact steps";
    }
    if (!isOfSeveral(tick)) {
        return nullptr;
    }
    ++m_ticks;
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < tick.contactCount; ++i) {
        sum += tick.contacts[i].f_W;
    }
    // A distance of the god-object from its contact planes contributes like a spring of the mean stiffness.
    const double slack_N = 256.0 * stiffest * rounding_mm + 1e-9 * stiffest * spring.norm();
    if ((sum - tick.f_W).norm() > slack_N) {
        return "parts of a shared contact do not add up";
    }
    if (tick.f_W.norm() > stiffest * spring.norm() + slack_N) {
        return "more force than the stiffest of a shared contact";
    }
    if (tick.f_W.dot(spring) < (softest * spring.norm() - slack_N) * spring.norm()) {
        return "less force than the softest of a shared contact";
    }
    return nullptr;
}

bool SharedJudge::changesAsMayBe(const Held& before, const Held& now, double rounding_mm)
{
    const bool isMore = isWithin(before.tick, now.tick);
    if (!isMore && !isWithin(now.tick, before.tick)) {
        return true; // another position
    }
    std::vector<Vec3> normals;
    for (const haptics::ActiveConstraint& plane : planesOf(isMore ? now.tick : before.tick)) {
        normals.push_back(plane.n_W);
    }
    const double span = spanOf(normals);
    if (span < 1e-3) {
        return true;
    }
    const double moved_mm = (now.spring - before.spring).norm();
    const double may_N =
        std::max(before.stiffest, now.stiffest) * (1.0 + 2.0 / span) * (moved_mm + 256.0 * rounding_mm);
    return (now.tick.f_W - before.tick.f_W).norm() <= may_N * (1.0 + 1e-9);
}

} // namespace palpate::adversary
