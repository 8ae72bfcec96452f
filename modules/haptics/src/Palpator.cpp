// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/Palpator.h"

#include "law/Foot.h"
#include "law/Law.h"
#include "law/SharedContact.h"
#include "solver/CarryOver.h"
#include "solver/GodObject.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace palpate::haptics {

using internal::GodObject;
using internal::GodObjectStep;
using internal::NearBall;
using internal::SharedWork;

namespace {

constexpr std::size_t kLayers = HapticScene::kMaxLayers;

/// Shape of a layer's motion, 0 without one.
std::uint64_t shapeOf(const HapticLayer& layer) noexcept
{
    return layer.motion == nullptr ? 0 : layer.motion->shape();
}

/// Layer that a god-object belongs to: the range of its numbers, empty: first > last, and its motion. Kept because the
/// scene may be gone when another is set and nothing is in contact.
struct Numbers
{
    std::uint32_t first = 1;
    std::uint32_t last = 0;
    std::uint64_t shape = 0; ///< see shapeOf
    bool isMoving = false;
};

/// Returns true if a structure of a layer is in a layer of another scene as well.
bool sharesStructure(const HapticScene& before, const HapticLayer& was, const HapticScene& after,
                     const HapticLayer& is) noexcept
{
    return std::any_of(is.structures.begin(), is.structures.end(), [&](std::uint32_t structure) {
        return std::find(was.structures.begin(), was.structures.end(), structure) != was.structures.end() &&
               before.structures()[structure].name == after.structures()[structure].name;
    });
}

/// Returns true if a ball has the same room in two layers: nothing was shown, hidden, replaced or resized.
bool hasSameSurfaces(const HapticLayer& was, const HapticLayer& is) noexcept
{
    return was.fingertip_mm == is.fingertip_mm && was.motion == is.motion &&
           std::equal(was.structures.begin(), was.structures.end(), is.structures.begin(), is.structures.end(),
                      [&](std::uint32_t a, std::uint32_t b) { return was.surfaces[a] == is.surfaces[b]; });
}

/// Fills a contact except for its force and layer.
/// @pre the god-object has an active constraint after its step
PALPATE_ALWAYS_INLINE law::Touch touchOf(Contact& contact, const GodObject& god, const HapticScene& scene,
                                         const Vec3& push_W, const law::Motion& hip) noexcept
{
    const ActiveConstraint& touched = god.active()[0];
    const HapticStructure& structure = scene.structures()[touched.structure];
    contact.p_WG = god.state().p_WG;
    contact.depth_mm = push_W.norm();
    contact.n_W = contact.depth_mm > 0.0 ? Vec3(push_W / contact.depth_mm) : touched.n_W;
    contact.friction = Friction::None;
    contact.stiffnessScale = 1.0;
    contact.structure = touched.structure;
    contact.triangle = structure.surface->sourceTriangle(touched.triangle);
    return {structure, god.facets()[0], scene.fingertip_mm(),  contact.p_WG, push_W, contact.depth_mm, contact.n_W,
            hip,       god.active(),    contact.stiffnessScale};
}

[[gnu::noinline]] Vec3 feltForce(const law::Touch& touch) noexcept
{
    const law::Foot foot(touch);
    return law::FeltLaw::force(law::MappedTouch{touch, foot});
}

// Not inlined, so that the cost of a plain layer does not depend on the other laws.
[[gnu::noinline]] void fillAny(Contact& contact, const GodObject& god, const HapticScene& scene, const Vec3& push_W,
                               const law::Motion& hip) noexcept
{
    const law::Touch touch = touchOf(contact, god, scene, push_W, hip);
    const HapticStructure& structure = touch.structure;
    if (!structure.maps.hasForceMaps()) {
        contact.f_W = law::UnmappedLaw::force(touch);
    } else if (structure.maps.hasFelt()) {
        contact.f_W = feltForce(touch);
    } else {
        const law::Foot foot(touch);
        contact.f_W = law::MappedLaw::force(law::MappedTouch{touch, foot});
    }
    if (structure.tissue.hasFriction()) { // friction tilts the spring, so its direction is not the contact normal
        contact.friction = god.state().slides != 0 ? Friction::Slides : Friction::Holds;
        const double length = god.state().constraints > 1 ? god.push_W().norm() : 0.0;
        contact.n_W = length > 0.0 ? Vec3(god.push_W() / length) : god.active()[0].n_W;
    }
}

/// Counts the contact that was filled last and makes its layer the reported one: layers are computed innermost first.
PALPATE_ALWAYS_INLINE void report(TickResult& result, const Contact& contact, const GodObject& god) noexcept
{
    ++result.contactCount;
    result.f_W += contact.f_W;
    result.p_WG = contact.p_WG;
    result.n_W = contact.n_W;
    result.structure = static_cast<std::int32_t>(contact.structure);
    result.triangle = contact.triangle;
    const std::span<const ActiveConstraint> active = god.active();
    for (std::size_t i = 0; i < active.size(); ++i) {
        result.active[i] = active[i];
    }
    result.constraints = god.state().constraints;
}

/// Adds the contacts of a layer whose god-object is constrained by several structures.
/// @return false if no structure exerts a force
[[gnu::noinline]] bool reportShared(TickResult& result, std::uint32_t layer, const GodObject& god,
                                    const HapticScene& scene, const Vec3& push_W, const law::Motion& hip) noexcept
{
    law::SharedContact shared = law::sharedContact(scene, god.active(), god.facets(), god.state().p_WG, push_W, hip);
    bool isRough = false;
    for (const Contact& one : std::span(shared.contacts).first(shared.count)) {
        Contact& contact = result.contacts[result.contactCount];
        contact = one;
        const bool hasFriction = scene.structures()[contact.structure].tissue.hasFriction();
        contact.layer = layer;
        contact.friction = !hasFriction ? Friction::None : god.state().slides != 0 ? Friction::Slides : Friction::Holds;
        isRough = isRough || hasFriction;
        report(result, contact, god);
    }
    if (shared.count > 0) {
        // Without friction the sum of the pushes equals the spring.
        result.n_W = isRough ? shared.n_W : Vec3(push_W / push_W.norm());
    }
    return shared.count > 0;
}

/// Reverses the contacts, which were computed innermost first, and sums the forces in the new order: floating-point
/// sums depend on the order, and recordings contain this one.
void putOutermostFirst(TickResult& result) noexcept
{
    const std::span<Contact> contacts(result.contacts.data(), result.contactCount);
    std::reverse(contacts.begin(), contacts.end());
    result.f_W.setZero();
    for (const Contact& contact : contacts) {
        result.f_W += contact.f_W;
    }
}

/// The hand as a moving layer meets it: in the rest shape.
struct HandAtRest
{
    geometry::SurfaceMotion::Moment moment;
    geometry::SurfaceMotion::Rest rest;
    Vec3 vTissue_W; ///< velocity of the tissue at the HIP [mm/s]; set if the layer has a damper or a contact
    Vec3 v_R;       ///< velocity of the hand relative to the tissue [mm/s]; set in a scene with dampers
};

/// Returns true if a stored contact may be restored by its age.
bool isRecent(const LostContact& one) noexcept
{
    constexpr double kLongest_s = 0.5;
    constexpr double kRounding = 1.0 + 1e-9; // rounding of a sum of tick periods
    return one.isOnSheet != 0 || one.age_s <= kRounding * kLongest_s;
}

/// Takes a vector of a plane or force from the rest shape to the world and keeps its length 1.
Vec3 turned(const HandAtRest& hand, const Vec3& n_R) noexcept
{
    const Vec3 n = hand.rest.force(n_R);
    const double length = n.norm();
    return length > 0.0 ? Vec3(n / length) : n_R;
}

/// Energy that a contact stores without the factor of a pulse [mJ].
double storedEnergy(const Contact& contact, const HapticScene& scene) noexcept
{
    return contact.stiffnessScale * scene.structures()[contact.structure].lawAt(contact.depth_mm).energy_mJ;
}

} // namespace

struct Palpator::Impl
{
    GodObjectLimits limits;
    const HapticScene* scene = nullptr;
    std::array<GodObject, kLayers> gods;
    std::unique_ptr<std::array<NearBall, kLayers>> balls; ///< null with Fingertips::Points
    std::array<Numbers, kLayers> numbers;
    std::array<LostContact, kLayers> left; ///< in any order
    bool hasLeft = false;                  ///< at least one entry is in use
    Vec3 p_WH = Vec3::Zero();              ///< HIP of the previous tick [mm]
    bool started = false;
    bool isMoving = false;  ///< HapticScene::isMoving
    bool isBall = false;    ///< the scene's probe is a ball
    std::size_t layers = 0; ///< of the scene
    std::array<Vec3, kLayers> p_RH{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}; ///< see PalpatorState
    double tissuePower_mW = 0.0;
    std::shared_ptr<const HapticScene> owned; ///< see setScene

    void leaveContacts(const HapticScene* after) noexcept;
    [[nodiscard]] std::optional<std::size_t> previousLayer(std::size_t layer, const HapticScene* before,
                                                           const std::array<Numbers, kLayers>& known) const noexcept;
    template<class HipOf>
    void feelLayer(TickResult& result, std::size_t i, const Vec3& p_H, double dt_s, SharedWork& work,
                   HipOf hipOf) noexcept;
    [[nodiscard]] bool takeToRest(const Vec3& p, double dt_s, const Vec3* v_WH, double time_s,
                                  std::array<HandAtRest, kLayers>& hands) const noexcept;
    void takeToWorld(TickResult& result, std::size_t i, std::size_t firstContact, const Vec3& p,
                     const HandAtRest& hand) noexcept;
    void stepMoving(TickResult& result, const Vec3& p, double dt_s, const Vec3* v_WH, double time_s) noexcept;
    [[nodiscard]] bool giveBack() noexcept;
    void giveBack(LostContact& one, std::size_t layer) noexcept;
    void giveBackMoving(const std::array<HandAtRest, kLayers>& hands) noexcept;
    void noteLeft() noexcept
    {
        hasLeft = std::any_of(left.begin(), left.end(), [](const LostContact& one) { return one.isKept != 0; });
    }

    [[nodiscard]] bool canFeel(const Vec3& hip) const noexcept
    {
        return scene != nullptr ? scene->reaches(hip) && (balls != nullptr || scene->fingertip_mm() == 0.0)
                                : hip.allFinite();
    }
};

Palpator::Palpator(Fingertips fingertips, const GodObjectLimits& limits)
    : m_impl(std::make_unique<Impl>())
{
    m_impl->limits = limits;
    if (fingertips == Fingertips::Any) {
        m_impl->balls = std::make_unique<std::array<NearBall, kLayers>>();
    }
}

Palpator::~Palpator() = default;
Palpator::Palpator(Palpator&&) noexcept = default;
Palpator& Palpator::operator=(Palpator&&) noexcept = default;

const HapticScene* Palpator::scene() const noexcept
{
    return m_impl->scene;
}

std::size_t Palpator::byteSize() const noexcept
{
    return sizeof(Palpator) + sizeof(Impl) + (m_impl->balls == nullptr ? 0 : sizeof *m_impl->balls);
}

/// Stores the contacts of structures that the next scene does not contain.
void Palpator::Impl::leaveContacts(const HapticScene* after) noexcept
{
    for (std::size_t i = 0; i < kLayers; ++i) {
        const LostContact now =
            internal::lostContact(*scene, after, gods[i].state(), numbers[i].isMoving ? p_RH[i] : p_WH);
        if (now.isKept != 0) {
            // Hiding a layer shifts the others, so entries are not bound to layers: use a free or the oldest entry.
            *std::max_element(left.begin(), left.end(), [](const LostContact& a, const LostContact& b) {
                return a.isKept != b.isKept ? a.isKept > b.isKept : a.age_s < b.age_s;
            }) = now;
        }
    }
    noteLeft();
}

/// Places the god-object of a layer where a stored contact left it.
void Palpator::Impl::giveBack(LostContact& one, std::size_t layer) noexcept
{
    GodObjectState god;
    god.p_WG = one.p_WG;
    god.placed = GodObjectState::kTight; // other surfaces may have come since
    gods[layer].restore(god);
    one = {};
}

/// Restores the stored contacts of structures that the scene contains again. Those of moving layers are left to the
/// next tick, whose time decides where the hand is in the rest shape.
/// @return true if a god-object took over a contact, or may do so in the next tick
bool Palpator::Impl::giveBack() noexcept
{
    bool isGiven = false;
    for (LostContact& one : left) {
        const auto layer =
            one.isKept != 0 && scene != nullptr ? internal::layerOf(*scene, one.structure) : std::nullopt;
        if (!layer) {
            continue;
        }
        if (!isRecent(one)) {
            one = {};
        } else if (scene->layer(*layer).motion != nullptr) {
            isGiven = true;
        } else if ((p_WH - one.p_WH).norm() <= kNear_mm) {
            giveBack(one, *layer);
            isGiven = true;
        } else {
            one = {};
        }
    }
    noteLeft();
    return isGiven;
}

/// Restores the stored contacts of moving layers, in the first tick with them.
void Palpator::Impl::giveBackMoving(const std::array<HandAtRest, kLayers>& hands) noexcept
{
    for (LostContact& one : left) {
        const auto layer = one.isKept != 0 ? internal::layerOf(*scene, one.structure) : std::nullopt;
        if (!layer || scene->layer(*layer).motion == nullptr) {
            continue;
        }
        if ((hands[*layer].rest.X - one.p_WH).norm() <= kNear_mm) {
            giveBack(one, *layer);
        } else {
            one = {};
        }
    }
    noteLeft();
}

bool Palpator::setScene(std::shared_ptr<const HapticScene> scene, Continuity continuity) noexcept
{
    const bool isRestored = borrowScene(scene.get(), continuity);
    m_impl->owned = std::move(scene); // after the contacts have left the previous scene
    return isRestored;
}

bool Palpator::setScene(const HapticScene* scene, Continuity continuity) noexcept
{
    const bool isRestored = borrowScene(scene, continuity);
    m_impl->owned.reset();
    return isRestored;
}

/// Finds the layer of the scene before with the same number. Several layers of one number differ by their motion; then
/// the structures decide, because motions that differ by clock or pulse only have the same shape.
/// @param before  scene of the known layers; null: not available
std::optional<std::size_t> Palpator::Impl::previousLayer(std::size_t layer, const HapticScene* before,
                                                         const std::array<Numbers, kLayers>& known) const noexcept
{
    const HapticLayer& now = scene->layer(layer);
    const auto hasNumber = [&now](const Numbers& one) { return one.first <= now.number && now.number <= one.last; };
    std::size_t rivals = 0; // layers of this scene with the same number
    for (std::size_t i = 0; i < scene->layerCount(); ++i) {
        rivals += scene->layer(i).number == now.number ? 1 : 0;
    }
    const bool isAmbiguous = rivals > 1 || std::count_if(known.begin(), known.end(), hasNumber) > 1;
    std::optional<std::size_t> found;
    for (std::size_t j = 0; j < kLayers; ++j) {
        if (!hasNumber(known[j])) {
            continue;
        }
        if (isAmbiguous && before != nullptr) {
            if (sharesStructure(*before, before->layer(j), *scene, now)) {
                return j;
            }
        } else if (known[j].shape == shapeOf(now) || (!isAmbiguous && !found)) {
            found = j;
        }
    }
    return found;
}

bool Palpator::borrowScene(const HapticScene* scene, Continuity continuity) noexcept
{
    Impl& me = *m_impl;
    // Contacts follow structures from this scene; setting the same scene again moves nothing.
    const bool isOther = me.scene != scene;
    const bool keeps = continuity == Continuity::Contacts && isOther;
    const HapticScene* const old = keeps ? me.scene : nullptr;
    const HapticScene* const before = continuity == Continuity::Contacts ? me.scene : nullptr;
    if (old != nullptr) {
        me.leaveContacts(scene);
    }
    me.scene = scene;
    me.isMoving = scene != nullptr && scene->isMoving();
    me.isBall = scene != nullptr && scene->fingertip_mm() > 0.0;
    me.layers = scene == nullptr ? 0 : scene->layerCount();
    me.tissuePower_mW = 0.0;
    const PalpatorState last = state();
    me.p_RH.fill(Vec3::Zero());
    const std::array<Numbers, kLayers> numbers = std::exchange(me.numbers, {});
    for (std::size_t i = 0; i < kLayers; ++i) {
        GodObjectState kept;
        if (scene != nullptr && i < scene->layerCount()) {
            const HapticLayer& layer = scene->layer(i);
            me.numbers[i] = {layer.number, layer.lastNumber, shapeOf(layer), layer.motion != nullptr};
            Vec3 hip = last.p_WH;
            const auto j = me.previousLayer(i, before, numbers);
            if (j) {
                kept = last.layers[*j];
                hip = numbers[*j].isMoving ? last.p_RH[*j] : hip;
            }
            if (old != nullptr && kept.placed != GodObjectState::kNotPlaced) {
                kept.p_WG = internal::carryOverPosition(*old, *scene, layer, kept, hip);
            }
            if (kept.placed != GodObjectState::kNotPlaced && isOther && me.isBall &&
                !(old != nullptr && hasSameSurfaces(old->layer(*j), layer))) {
                kept.placed = GodObjectState::kTight;
            }
            if (layer.motion != nullptr) {
                me.p_RH[i] = hip;
            }
        }
        me.gods[i].restore(kept);
        me.gods[i].forgetContacts();
        if (me.balls != nullptr) {
            (*me.balls)[i].clear();
        }
    }
    return me.hasLeft && me.giveBack();
}

bool Palpator::isOnSheet() const noexcept
{
    return m_impl->scene != nullptr && std::any_of(m_impl->gods.begin(), m_impl->gods.end(), [&](const GodObject& god) {
               return internal::touchesSheet(*m_impl->scene, god.state());
           });
}

void Palpator::reset() noexcept
{
    for (GodObject& god : m_impl->gods) {
        god.restore({});
    }
    m_impl->left = {};
    m_impl->hasLeft = false;
    m_impl->started = false;
}

/// Moves the god-object of a layer and adds its contacts.
/// @param p_H  HIP, in moving tissue in the rest shape of the layer [mm]; the same frame as the contacts
/// @param hipOf  returns the motion of the HIP in that frame
template<class HipOf>
PALPATE_ALWAYS_INLINE void Palpator::Impl::feelLayer(TickResult& result, std::size_t i, const Vec3& p_H, double dt_s,
                                                     SharedWork& work, HipOf hipOf) noexcept
{
    const HapticLayer& layer = scene->layer(i);
    GodObject& god = gods[i];
    const GodObjectStep step =
        god.step(p_H, dt_s, layer, {limits.iterations, work.next()}, isBall ? &(*balls)[i] : nullptr);
    work.spend(step.work);
    result.iterations += step.iterations;
    result.status = std::max(result.status, step.status);
    if (god.state().constraints == 0) {
        // Free, or stopped at the iteration limit on the way: no active constraint, so no force.
        if (i == 0 && result.contactCount == 0) {
            result.p_WG = god.state().p_WG;
        }
        return;
    }
    const law::Motion hip = hipOf();
    const Vec3 push = god.state().p_WG - p_H;
    const auto number = static_cast<std::uint32_t>(i);
    if (god.state().constraints > 1 && law::hasSeveralStructures(god.active()) &&
        reportShared(result, number, god, *scene, push, hip)) {
        return;
    }
    Contact& contact = result.contacts[result.contactCount];
    contact.layer = number;
    if (layer.isPlain) {
        contact.f_W = law::LinearLaw::force(touchOf(contact, god, *scene, push, hip));
    } else {
        fillAny(contact, god, *scene, push, hip);
    }
    report(result, contact, god);
}

TickResult Palpator::step(const Vec3& p_WH, double dt_s, const Vec3* v_WH, double time_s) noexcept
{
    Impl& me = *m_impl;
    TickResult result;
    if (me.isMoving) [[unlikely]] {
        me.stepMoving(result, p_WH, dt_s, v_WH, time_s);
        return result;
    }
    if (!me.canFeel(p_WH)) {
        result.p_WG = me.gods[0].state().p_WG;
        result.status = TickStatus::InvalidInput;
        return result;
    }
    for (std::size_t i = 0; me.hasLeft && i < kLayers; ++i) {
        me.left[i].age_s += dt_s;
    }
    if (me.layers == 0) {
        result.p_WG = p_WH;
    }
    // Innermost layer first: its share of the work budget does not depend on outer layers.
    SharedWork work(me.isBall ? me.limits.ballWork : me.limits.work);
    if (me.isBall) {
        result.fingertip_mm = me.scene->fingertip_mm();
    }
    for (std::size_t i = me.layers; i-- > 0;) {
        me.feelLayer(result, i, p_WH, dt_s, work, [&] {
            return law::Motion{me.p_WH, p_WH, me.started ? dt_s : 0.0, v_WH};
        });
    }
    if (result.contactCount > 1) {
        putOutermostFirst(result);
    }
    me.p_WH = p_WH;
    me.started = true;
    return result;
}

/// Takes the hand to the rest shape of each layer.
/// @return false if a layer cannot be felt there
bool Palpator::Impl::takeToRest(const Vec3& p, double dt_s, const Vec3* v_WH, double time_s,
                                std::array<HandAtRest, kLayers>& hands) const noexcept
{
    for (std::size_t i = 0; i < layers; ++i) {
        const geometry::SurfaceMotion* const motion = scene->layer(i).motion;
        if (motion == nullptr) {
            continue;
        }
        HandAtRest& hand = hands[i];
        hand.moment = motion->at(time_s);
        hand.rest = motion->toRest(hand.moment, p, started ? p_RH[i] : p);
        if (!scene->reaches(hand.rest.X)) {
            return false;
        }
        if (scene->isDamped()) {
            hand.vTissue_W = motion->velocity(hand.moment, hand.rest);
            const Vec3 v = v_WH != nullptr ? *v_WH : started ? Vec3((p - p_WH) / dt_s) : hand.vTissue_W;
            hand.v_R = hand.rest.invF * (v - hand.vTissue_W);
        }
    }
    return true;
}

/// Takes the contacts of a moving layer from its rest shape to the world, and adds the power of its tissue.
/// @param firstContact  the first contact of the layer
void Palpator::Impl::takeToWorld(TickResult& result, std::size_t i, std::size_t firstContact, const Vec3& p,
                                 const HandAtRest& hand) noexcept
{
    const geometry::SurfaceMotion& motion = *scene->layer(i).motion;
    const Vec3& p_RG = gods[i].state().p_WG;
    if (firstContact == result.contactCount) {
        if (i == 0 && firstContact == 0) { // free: at the HIP, bit for bit
            result.p_WG = p_RG == hand.rest.X ? p : motion.toWorld(hand.moment, p_RG);
        }
        return;
    }
    const Vec3 v = scene->isDamped() ? hand.vTissue_W : motion.velocity(hand.moment, hand.rest);
    const Vec3 p_WG = motion.toWorld(hand.moment, p_RG);
    const bool isAlone = result.contactCount == firstContact + 1;
    for (std::size_t c = firstContact; c < result.contactCount; ++c) {
        Contact& contact = result.contacts[c];
        if (hand.moment.factorSlope != 0.0) {
            tissuePower_mW += hand.moment.factorSlope * storedEnergy(contact, *scene);
        }
        contact.p_WG = p_WG;
        contact.n_W = turned(hand, contact.n_W);
        contact.f_W = hand.moment.factor * hand.rest.force(contact.f_W);
        contact.depth_mm = isAlone ? (p_WG - p).norm() : std::max(0.0, (p_WG - p).dot(contact.n_W));
        tissuePower_mW += contact.f_W.dot(v);
    }
    result.p_WG = p_WG;
    result.n_W = isAlone ? result.contacts[firstContact].n_W : turned(hand, result.n_W);
    for (std::size_t k = 0; k < result.constraints; ++k) {
        result.active[k].n_W = turned(hand, result.active[k].n_W);
    }
}

/// A step in a scene with motion: each layer is felt in its rest shape, where nothing moves but the hand.
[[gnu::noinline]] void Palpator::Impl::stepMoving(TickResult& result, const Vec3& p, double dt_s, const Vec3* v_WH,
                                                  double time_s) noexcept
{
    std::array<HandAtRest, kLayers> hands;
    tissuePower_mW = 0.0;
    if (!canFeel(p) || !takeToRest(p, dt_s, v_WH, time_s, hands)) {
        result.p_WG = p_WH;
        result.status = TickStatus::InvalidInput;
        return;
    }
    if (hasLeft) {
        giveBackMoving(hands);
        for (LostContact& one : left) {
            one.age_s += dt_s;
        }
    }
    SharedWork work(isBall ? limits.ballWork : limits.work);
    if (isBall) {
        result.fingertip_mm = scene->fingertip_mm();
    }
    for (std::size_t i = layers; i-- > 0;) {
        const HandAtRest& hand = hands[i];
        if (scene->layer(i).motion == nullptr) {
            feelLayer(result, i, p, dt_s, work, [&] { return law::Motion{p_WH, p, started ? dt_s : 0.0, v_WH}; });
            continue;
        }
        const std::size_t first = result.contactCount;
        feelLayer(result, i, hand.rest.X, dt_s, work, [&] {
            return law::Motion{hand.rest.X, hand.rest.X, dt_s, scene->isDamped() ? &hand.v_R : nullptr};
        });
        takeToWorld(result, i, first, p, hand);
        result.status = hand.rest.isExact() ? result.status : std::max(result.status, TickStatus::IterationLimit);
        p_RH[i] = hand.rest.X;
    }
    putOutermostFirst(result);
    p_WH = p;
    started = true;
}

double Palpator::tissuePower_mW() const noexcept PALPATE_NONBLOCKING
{
    return m_impl->tissuePower_mW;
}

PalpatorState Palpator::state() const noexcept
{
    PalpatorState state;
    for (std::size_t i = 0; i < kLayers; ++i) {
        state.layers[i] = m_impl->gods[i].state();
    }
    state.left = m_impl->left;
    state.p_RH = m_impl->p_RH;
    state.p_WH = m_impl->p_WH;
    state.started = m_impl->started ? 1 : 0;
    return state;
}

void Palpator::restore(const PalpatorState& state) noexcept
{
    for (std::size_t i = 0; i < kLayers; ++i) {
        m_impl->gods[i].restore(state.layers[i]);
    }
    m_impl->left = state.left;
    m_impl->noteLeft();
    m_impl->p_RH = state.p_RH;
    m_impl->p_WH = state.p_WH;
    m_impl->started = state.started != 0;
}

} // namespace palpate::haptics
