// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Types.h>
#include <palpate/haptics/TickResult.h>

namespace palpate::session {

/// Place at which the hand touches a surface; all measures of place use the distance from it (docs/measures.md).
///
/// For a point this is the god-object. The god-object of a ball is its centre, one radius off the surface: the place is
/// the point of the ball that touches, and all of the surface inside the ball near the line from there to the centre.
/// Only a ball that started without room has surface inside. World frame.
class PALPATE_EXPORT TouchPlace
{
  public:
    /// A point contact. [mm]
    TouchPlace(const core::Vec3& p_WG)
        : m_p_W(p_WG)
        , m_centre_W(p_WG)
    {
    }
    /// @param contact  one of the contacts of `felt`
    TouchPlace(const haptics::TickResult& felt, const haptics::Contact& contact);

    /// The point that touches [mm].
    [[nodiscard]] const core::Vec3& p_W() const noexcept { return m_p_W; }
    /// The god-object [mm].
    [[nodiscard]] const core::Vec3& centre_W() const noexcept { return m_centre_W; }
    [[nodiscard]] bool isFinite() const noexcept;
    /// Square of the distance of a point of the surface from the touched place [mm²].
    [[nodiscard]] double squaredDistance_mm2(const core::Vec3& p_W) const noexcept;
    /// Returns true if a point of the surface is at most this far from the touched place. [mm]
    [[nodiscard]] bool reaches(const core::Vec3& p_W, double distance_mm) const noexcept;

  private:
    core::Vec3 m_p_W;
    core::Vec3 m_centre_W;
    double m_radius_mm = 0.0;
};

} // namespace palpate::session
