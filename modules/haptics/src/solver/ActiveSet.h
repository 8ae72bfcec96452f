// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "probe/ConstrainedPoint.h"
#include "probe/Skin.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>

namespace palpate::haptics::internal {

/// Zilles & Salisbury's active constraints of a point or a ball: the facets whose planes currently limit the
/// god-object, at most three, and the plane met last.
/// @tparam Contact  with members `facet` and `side`
template<class Contact>
class ActiveSet
{
  public:
    static constexpr std::size_t kMost = 4;

    [[nodiscard]] std::size_t count() const noexcept { return m_count; }
    [[nodiscard]] bool isEmpty() const noexcept { return m_count == 0; }
    [[nodiscard]] Contact& operator[](std::size_t i) noexcept { return m_contacts[i]; }
    [[nodiscard]] const Contact& operator[](std::size_t i) const noexcept { return m_contacts[i]; }
    [[nodiscard]] Contact* begin() noexcept { return m_contacts.data(); }
    [[nodiscard]] Contact* end() noexcept { return m_contacts.data() + m_count; }
    [[nodiscard]] const Contact* begin() const noexcept { return m_contacts.data(); }
    [[nodiscard]] const Contact* end() const noexcept { return m_contacts.data() + m_count; }

    void clear() noexcept { m_count = 0; }

    /// Adds a contact. If the set is full, the oldest contact is removed.
    /// @return the new entry, to be filled
    Contact& add() noexcept
    {
        if (m_count == kMost) {
            std::move(begin() + 1, end(), begin());
            --m_count;
        }
        return m_contacts[m_count++];
    }

    /// Removes each contact for which `isLost(contact)` is true.
    template<class IsLost>
    void release(IsLost&& isLost) noexcept
    {
        m_count = static_cast<std::size_t>(std::remove_if(begin(), end(), isLost) - begin());
    }

    /// Finds the allowed displacement nearest to `wanted`, and removes the inactive contacts.
    /// @param wanted  unconstrained displacement [mm]
    /// @param planeOf  returns the HalfSpace of displacements that a contact allows
    /// @return the displacement [mm]
    template<class PlaneOf>
    [[nodiscard]] Vec3 constrain(const Vec3& wanted, PlaneOf&& planeOf) noexcept
    {
        std::array<HalfSpace, kMost> planes;
        // Minimum skin, so that no contact is lost to the tolerance of another.
        double skin_mm = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < m_count; ++i) {
            planes[i] = planeOf(m_contacts[i]);
            skin_mm = std::min(skin_mm, m_contacts[i].facet.skin_mm);
        }
        const ConstrainedPoint point =
            constrainedPoint(wanted, std::span<const HalfSpace>(planes).first(m_count), allowance(skin_mm, wanted));
        m_count = static_cast<std::size_t>(point.count);
        for (std::size_t i = 0; i < m_count; ++i) {
            // `active` is ascending, so entries are read before they are overwritten.
            const std::size_t kept = point.active[i];
            if (kept != i) {
                m_contacts[i] = m_contacts[kept];
            }
            m_lambda_mm[i] = point.lambda_mm[i];
        }
        return point.u;
    }

    /// Returns the component of `v` along which the contacts permit motion.
    /// @pre at most three contacts, as after `constrain`
    [[nodiscard]] Vec3 freePart(const Vec3& v) const noexcept
    {
        std::array<Vec3, 3> normals;
        const std::size_t count = std::min(m_count, normals.size());
        for (std::size_t i = 0; i < count; ++i) {
            normals[i] = m_contacts[i].normal();
        }
        return internal::freePart(v, std::span<const Vec3>(normals).first(count));
    }

    /// Returns the multiplier of a contact kept by the last `constrain` [mm].
    [[nodiscard]] double lambda_mm(std::size_t i) const noexcept { return m_lambda_mm[i]; }

  private:
    std::array<Contact, kMost> m_contacts;
    std::array<double, 3> m_lambda_mm;
    std::size_t m_count = 0;
};

} // namespace palpate::haptics::internal
