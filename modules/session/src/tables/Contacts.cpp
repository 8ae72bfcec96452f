// SPDX-License-Identifier: BSD-3-Clause
#include "tables/Contacts.h"

#include "database/Bounds.h"
#include "database/Bytes.h"
#include "tables/Packing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace palpate::session::internal {

namespace {

using haptics::Contact;
using haptics::Friction;

constexpr std::size_t kContactBytes = 4 * sizeof(std::uint32_t) + 9 * sizeof(double);

bool isSame(const Contact& a, const Contact& b)
{
    const core::Vec3 zero = core::Vec3::Zero();
    return a.structure == b.structure && a.triangle == b.triangle && a.layer == b.layer && a.friction == b.friction &&
           sameBits(a.p_WG, b.p_WG) && sameBits(a.n_W, b.n_W) && sameBits(a.f_W + zero, b.f_W + zero);
}

/// Also false for NaN.
bool isWithin(const core::Vec3& v, double most)
{
    return std::all_of(v.begin(), v.end(), [most](double value) { return std::abs(value) <= most; });
}

double depth(const Contact& contact, const servo::TickRecord& tick)
{
    return (contact.p_WG - tick.p_WH).norm();
}

} // namespace

Contact ownContact(const servo::TickRecord& tick)
{
    Contact contact;
    contact.p_WG = tick.felt.p_WG;
    contact.n_W = tick.felt.n_W;
    contact.f_W = tick.felt.f_W;
    contact.depth_mm = depth(contact, tick);
    contact.structure = static_cast<std::uint32_t>(tick.felt.structure);
    contact.triangle = tick.felt.triangle;
    contact.layer = 0;
    contact.stiffnessScale = 1.0;
    contact.friction = (tick.flags & servo::kSlides) != 0  ? Friction::Slides
                       : (tick.flags & servo::kHolds) != 0 ? Friction::Holds
                                                           : Friction::None;
    return contact;
}

std::string packLayers(const servo::TickRecord& tick)
{
    std::string out;
    const std::size_t count = std::min<std::size_t>(tick.felt.contactCount, tick.felt.contacts.size());
    if (tick.felt.structure < 0 || count == 0 || (count == 1 && isSame(tick.felt.contacts[0], ownContact(tick)))) {
        return out;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const Contact& contact = tick.felt.contacts[i];
        put(out, contact.layer);
        put(out, contact.structure);
        put(out, contact.triangle);
        put(out, static_cast<std::uint32_t>(contact.friction));
        put(out, contact.p_WG);
        put(out, contact.n_W);
        put(out, contact.f_W);
    }
    return out;
}

bool unpackLayers(std::string_view layers, servo::TickRecord& tick)
{
    haptics::TickResult& felt = tick.felt;
    felt.contactCount = 0;
    if (felt.structure < 0) {
        return layers.empty();
    }
    felt.contacts[felt.contactCount++] = ownContact(tick);
    if (layers.size() % kContactBytes != 0 || layers.size() / kContactBytes > felt.contacts.size()) {
        return false;
    }
    if (layers.empty()) {
        return true;
    }
    felt.contactCount = static_cast<std::uint8_t>(layers.size() / kContactBytes);
    bool isPossible = true;
    for (std::size_t i = 0; i < felt.contactCount; ++i) {
        Contact& contact = felt.contacts[i];
        std::uint32_t friction = 0;
        take(layers, contact.layer);
        take(layers, contact.structure);
        take(layers, contact.triangle);
        take(layers, friction);
        take(layers, contact.p_WG);
        take(layers, contact.n_W);
        take(layers, contact.f_W);
        contact.depth_mm = depth(contact, tick);
        contact.stiffnessScale = 1.0;
        contact.friction = friction <= 2 ? static_cast<Friction>(friction) : Friction::None;
        isPossible = isPossible && friction <= 2 && isWithin(contact.p_WG, kMaxLength_mm) &&
                     isWithin(contact.n_W, kMaxNormal) && isWithin(contact.f_W, kMaxForce_N);
    }
    const std::span<Contact> contacts = std::span(felt.contacts).first(felt.contactCount);
    for (Contact& contact : contacts) {
        if (std::count_if(contacts.begin(), contacts.end(),
                          [&](const Contact& other) { return other.layer == contact.layer; }) > 1) {
            contact.depth_mm = std::max(0.0, (contact.p_WG - tick.p_WH).dot(contact.n_W));
        }
    }
    if (!isPossible) {
        felt.contactCount = 1; // from the tick's own columns
        felt.contacts[0] = ownContact(tick);
    }
    return isPossible;
}

bool sameContacts(const haptics::TickResult& a, const haptics::TickResult& b)
{
    return a.contactCount == b.contactCount &&
           std::equal(a.contacts.begin(), a.contacts.begin() + a.contactCount, b.contacts.begin(), isSame);
}

} // namespace palpate::session::internal
