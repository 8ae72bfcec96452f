// SPDX-License-Identifier: BSD-3-Clause
#include "LayerJudge.h"

#include "TissueJudge.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::adversary {

namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

} // namespace

LayerJudge::LayerJudge(const RandomScene& scene, std::uint32_t layer, std::uint64_t seed)
    : m_scene(scene)
    , m_layer(scene, layer)
    , m_chance(seed)
    , m_magnitude_mm(std::max(scene.bounds.min().cwiseAbs().maxCoeff(), scene.bounds.max().cwiseAbs().maxCoeff()))
{
    for (const RandomStructure& one : scene.structures) {
        haptics::HapticStructure& structure = m_structures.emplace_back(one.structure());
        if (!structure.maps.stiffness.isEmpty() && structure.maps.stiffness.bends == nullptr) {
            structure.maps.stiffness = structure.maps.stiffness.withBends(*structure.surface);
        }
        m_isRough = m_isRough || (one.layer == layer && one.tissue.hasFriction());
        m_hasDrag = m_hasDrag || (one.layer == layer && one.tissue.friction_drag_Ns_per_mm > 0.0);
    }
    forget();
}

void LayerJudge::forget()
{
    m_isPlaced = m_isDeep = false;
    m_bodies.assign(m_layer.bodies.size(), {});
    m_sheets.assign(m_layer.sheets.size(), {});
    m_near_mm = 0.0;
    m_energy.forget();
    m_shared.forget();
}

void LayerJudge::look(const haptics::TickResult& tick, const Vec3& hip, const Vec3& v_WH, bool isRestJudged,
                      Faults& faults)
{
    const Vec3 god = tick.p_WG;
    if (!god.allFinite() || !tick.f_W.allFinite() || !tick.n_W.allFinite()) {
        faults.push_back({"not finite", 0.0, "", m_god, god});
        forget();
        return;
    }
    if (tick.status == haptics::TickStatus::InvalidInput) {
        faults.push_back({"refused a HIP that is not far away", (hip - god).norm(), "mm", m_god, god});
        return;
    }
    m_rounding_mm = 8.0 * kEps * (m_magnitude_mm + hip.cwiseAbs().maxCoeff());
    const std::size_t before = faults.size();
    judgeDistance(god, hip, faults);
    judgeForce(tick, hip, v_WH, faults);
    judgeBodies(god, faults);
    for (std::size_t i = 0; i < m_sheets.size(); ++i) {
        judgeSheet(m_layer.sheets[i], m_sheets[i], god, hip, faults);
    }
    if (m_scene.fingertip_mm > 0.0) {
        judgeBall(god, faults);
    }
    // may have touched another facet during the tick
    const bool mayHaveTouched = m_scene.fingertip_mm > 0.0 && tick.iterations > 2;
    const double place_mm = m_rounding_mm + aside_mm(tick, hip);
    if (m_isDeep || mayHaveTouched) { // A ball that starts too deep is pushed out; nothing constrains the path out.
        m_energy.forget();
    } else if (const double made = m_energy.made_mJ(m_structures, tick, hip, v_WH, place_mm); made > 0.0) {
        faults.push_back({"energy from nothing", made, "mJ", m_god, god});
    }
    // At the iteration bound the god-object may still be moving.
    if (m_isRough) {
        judgeFriction(tick, hip, faults); // friction: rests where the cone holds it
    } else if (isRestJudged && tick.status == haptics::TickStatus::Converged && !m_isDeep && faults.size() == before) {
        judgeRest(god, hip, faults);
    }
    m_god = god;
    m_isPlaced = true;
}

/// Checks that no tick ends farther from the HIP than it began (staying is a legal move), except for the lift at new
/// contacts. One skin away from both walls of a groove means skin / sin(angle / 2) away from the bottom.
void LayerJudge::judgeDistance(const Vec3& god, const Vec3& hip, Faults& faults)
{
    if (!m_isPlaced) {
        return;
    }
    const double more = (god - hip).norm() - (m_god - hip).norm();
    constexpr double kLift = 64.0; // in skins: corresponds to a groove of 1.8 degrees
    if (more > kLift * m_layer.skin_mm + m_rounding_mm) {
        faults.push_back({"ends farther from the HIP than it began", more, "mm", m_god, god});
    }
}

/// Checks that the force is that of the tissue of a touched structure. Zero force is correct only at the HIP.
void LayerJudge::judgeForce(const haptics::TickResult& tick, const Vec3& hip, const Vec3& v_WH, Faults& faults)
{
    const Vec3 spring = tick.p_WG - hip;
    const double length = spring.norm();
    if (tick.f_W.isZero(0.0)) {
        if (length > m_rounding_mm) {
            faults.push_back({"no force away from the HIP", length, "mm", m_god, tick.p_WG});
        }
        return;
    }
    const double skins_mm = m_rounding_mm + m_layer.skin_mm;
    if (const char* fault = m_shared.look(m_structures, tick, hip, skins_mm, m_scene.fingertip_mm == 0.0)) {
        faults.push_back({fault, tick.f_W.norm(), "N", m_god, tick.p_WG});
    }
    if (isOfSeveral(tick)) {
        return;
    }
    // At the iteration bound the contacts may belong to an intermediate position.
    const double touching = tick.status == haptics::TickStatus::IterationLimit
                                ? std::numeric_limits<double>::infinity()
                                : m_scene.fingertip_mm + 64.0 * m_layer.skin_mm + m_rounding_mm + 1e-6 * m_scene.scale;
    bool isNear = false;
    std::vector<char> isTried(m_scene.structures.size());
    for (const JudgedTriangle& t : m_layer.triangles) {
        if (isTried[t.structure] != 0 || t.box.exteriorDistance(tick.p_WG) > touching ||
            distanceToTriangle_mm(tick.p_WG, t.corner) > touching) {
            continue;
        }
        isTried[t.structure] = 1;
        isNear = true;
        for (std::size_t k = 0; k < tick.constraints; ++k) {
            const haptics::ActiveConstraint& plane = tick.active[k];
            if (plane.structure == t.structure &&
                ForceOfTissue(m_structures[t.structure], plane, tick.p_WG, hip).is(tick.f_W, v_WH)) {
                return;
            }
        }
    }
    faults.push_back({isNear ? "force of no tissue that is touched" : "force where nothing is touched", tick.f_W.norm(),
                      "N", m_god, tick.p_WG});
}

/// Checks the winding number around each closed surface: a fall is allowed, since points inside leave freely; a rise
/// never is. The number must not change for a two-sided surface.
void LayerJudge::judgeBodies(const Vec3& god, Faults& faults)
{
    const double onSurface = m_layer.skin_mm + m_rounding_mm;
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        const Body& body = m_layer.bodies[i];
        BodyWatch& watch = m_bodies[i];
        const std::optional<int> turns = body.winding(god);
        watch.outsideTicks = turns == 0 ? watch.outsideTicks + 1 : 0;
        if (!turns) {
            continue; // on the surface: the side is unchanged
        }
        if (!watch.isKnown) {
            if (body.distance_mm(god) > 2.0 * onSurface) {
                watch.isKnown = true;
                watch.most = *turns;
            }
            continue;
        }
        if (*turns > watch.most || (!body.isOneSided && *turns != watch.most)) {
            const double depth = body.distance_mm(god);
            if (depth > onSurface) {
                faults.push_back({"popped through a closed surface", depth, "mm", m_god, god});
                watch.most = *turns;
            }
        } else {
            watch.most = *turns;
        }
    }
}

double LayerJudge::distance_mm(const Sheet& sheet, const Vec3& p) const
{
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : sheet.triangles) {
        const JudgedTriangle& t = m_layer.triangles[i];
        if (t.box.exteriorDistance(p) < least) {
            least = std::min(least, distanceToTriangle_mm(p, t.corner));
        }
    }
    return least;
}

std::optional<bool> LayerJudge::isCrossed(const Sheet& sheet, const Vec3& from, const Vec3& to) const
{
    bool isOdd = false;
    const core::Box box(from.cwiseMin(to), from.cwiseMax(to));
    for (const std::uint32_t i : sheet.triangles) {
        const JudgedTriangle& t = m_layer.triangles[i];
        if (!t.box.intersects(box)) {
            continue;
        }
        const std::optional<bool> isThrough = crosses(from, to, t.corner);
        if (!isThrough) {
            return std::nullopt;
        }
        isOdd = isOdd != *isThrough;
    }
    return isOdd;
}

/// Checks that no sheet was crossed. The god-object may go around a rim, and only the positions at the ends of ticks
/// are known. All moves of a tick bring the god-object no farther from the HIP, so they stay within the ball around the
/// HIP through the start position. If no rim reaches into that ball, all paths between the two positions cross the
/// sheet with the same parity, and the straight path decides. If the god-object is on the sheet, any position next to
/// it will do as long as the next path starts there; the parity is summed between positions that are clear of the
/// sheet.
void LayerJudge::judgeSheet(const Sheet& sheet, SheetWatch& watch, const Vec3& god, const Vec3& hip, Faults& faults)
{
    const double beside = 32.0 * (m_layer.skin_mm + m_rounding_mm);
    if (m_isPlaced && god == m_god) {
        return;
    }
    const double far = std::max((god - hip).norm(), m_isPlaced ? (m_god - hip).norm() : 0.0);
    const double reach = far * (1.0 + 1e-3) + 4.0 * beside;
    const double apart = sheet.box.exteriorDistance(god);
    const double distance = apart > beside ? apart : distance_mm(sheet, god);
    const bool isClear = distance > 2.0 * (m_layer.skin_mm + m_rounding_mm);
    const bool isBesideRim = std::any_of(sheet.rim.begin(), sheet.rim.end(), [&](const auto& edge) {
        return distanceToSegment_mm(hip, edge[0], edge[1]) <= reach ||
               distanceToSegment_mm(god, edge[0], edge[1]) <= 2.0 * beside;
    });
    if (isBesideRim || !watch.isKnown) {
        watch = {isClear, god, false};
        return;
    }
    Vec3 place = god;
    for (int attempt = 0; !isClear && attempt < 8; ++attempt) {
        place = god + 0.5 * beside * m_chance.direction();
        if (distance_mm(sheet, place) > 0.05 * beside) {
            break;
        }
    }
    std::optional<bool> isOdd = isCrossed(sheet, watch.place, place);
    for (int attempt = 0; !isOdd && attempt < 4; ++attempt) { // passes through an edge: try a detour
        const Vec3 way = place - watch.place;
        const Vec3 middle = watch.place + 0.5 * way + 1e-4 * way.norm() * m_chance.direction();
        const auto first = isCrossed(sheet, watch.place, middle), second = isCrossed(sheet, middle, place);
        if (first && second) {
            isOdd = *first != *second;
        }
    }
    ++m_sheetTicks;
    if (!isOdd) {
        watch = {isClear, god, false};
        return;
    }
    watch.isOdd = watch.isOdd != *isOdd;
    watch.place = place;
    if (isClear && watch.isOdd) {
        faults.push_back({"popped through a sheet", distance, "mm", m_god, god});
        watch.isOdd = false;
    }
}

/// Checks that the ball is no nearer to a facet than its radius, or than the smallest distance since a start that was
/// too near. Only facets that the ball can touch count: two-sided surfaces, and facets of a body that the centre is
/// outside of (some facet always faces the centre there). A centre that leaves a body from within passes the surface
/// freely and is then too near.
void LayerJudge::judgeBall(const Vec3& god, Faults& faults)
{
    const double radius = m_scene.fingertip_mm;
    const double slack = 4.0 * m_layer.skin_mm + m_rounding_mm + 1e-8 * m_scene.scale;
    double least = radius, leastTouchable = radius;
    for (const JudgedTriangle& t : m_layer.triangles) {
        const double apart = t.box.exteriorDistance(god);
        if (apart >= leastTouchable) {
            continue;
        }
        const double distance = distanceToTriangle_mm(god, t.corner);
        least = std::min(least, distance);
        const bool isOutside = t.solid >= 0 && m_bodies[static_cast<std::size_t>(t.solid)].outsideTicks > 1;
        if (t.isTwoSided || isOutside) {
            leastTouchable = std::min(leastTouchable, distance);
        }
    }
    const double deeper = std::min(radius, m_near_mm) - leastTouchable;
    if (m_isPlaced && deeper > slack) {
        faults.push_back({"ball nearer than allowed", deeper, "mm", m_god, god});
    }
    m_near_mm = least;
    m_isDeep = least < radius - slack;
}

/// Returns the allowed sideways deviation. A ball has converged when it comes nearer by less than 1e-8 of the distance
/// (resources/docs/fingertip.md); the gain of a sideways move grows with the square of that move.
double LayerJudge::aside_mm(const haptics::TickResult& tick, const Vec3& hip) const
{
    return m_scene.fingertip_mm > 0.0 ? std::sqrt(2e-8) * (tick.p_WG - hip).norm() : 0.0;
}

/// Checks that a single facet holds the god-object within the friction cone; a tick that stopped early reports that in
/// the status.
void LayerJudge::judgeFriction(const haptics::TickResult& tick, const Vec3& hip, Faults& faults) const
{
    const bool isConverged = tick.status == haptics::TickStatus::Converged;
    if (isConverged && tick.iterations >= haptics::GodObjectLimits{}.iterations) {
        faults.push_back({"more moves than the bound, not reported", double(tick.iterations), "", m_god, tick.p_WG});
    }
    if (tick.constraints == 0 && !((tick.p_WG - hip).norm() <= m_rounding_mm && tick.f_W.isZero(0.0))) {
        faults.push_back({"free, but not at the HIP", (tick.p_WG - hip).norm(), "mm", m_god, tick.p_WG});
    }
    if (tick.constraints != 1 || !isConverged || m_isDeep || m_hasDrag) {
        return;
    }
    const double outside = outsideCone_mm(m_structures[tick.active[0].structure], tick, hip);
    const double slack = 64.0 * m_layer.skin_mm + m_rounding_mm + aside_mm(tick, hip);
    if (outside > slack) {
        faults.push_back({"outside the cone of friction", outside, "mm", m_god, tick.p_WG});
    }
}

void LayerJudge::judgeRest(const Vec3& god, const Vec3& hip, Faults& faults)
{
    ++m_restTicks;
    // Look only for moves that gain more than the threshold of the engine's own moves.
    const double enough = std::max(1e-6 * m_scene.scale, 128.0 * m_layer.skin_mm) + 8.0 * m_rounding_mm;
    // In the slot between two touching bodies, a point one skin away from one wall is one skin behind the other. No
    // facet blocks the way into that body from there, but the move is still illegal.
    const auto mayEnd = [this](const Vec3& place) {
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            const std::optional<int> turns = m_layer.bodies[i].winding(place);
            const int most = m_bodies[i].most;
            if (!m_bodies[i].isKnown || !turns || *turns > most || (!m_layer.bodies[i].isOneSided && *turns != most)) {
                return false;
            }
        }
        return true;
    };
    const WayCloser way = wayCloser(m_layer, god, hip, m_scene.fingertip_mm, enough, mayEnd, m_chance);
    if (way.gain_mm > enough) {
        faults.push_back({"not at rest: a straight legal move leads closer", way.gain_mm, "mm", god, way.to});
    }
}

} // namespace palpate::adversary
