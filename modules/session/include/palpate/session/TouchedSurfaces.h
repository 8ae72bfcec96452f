// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/TouchedSurface.h"

#include <palpate/core/Export.h>
#include <palpate/geometry/Repair.h>
#include <palpate/haptics/TickResult.h>
#include <palpate/servo/TickRecord.h>

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace palpate::session {

/// Repaired meshes, keyed by geometryHash.
using MeshesByHash = std::map<std::string, std::shared_ptr<const geometry::RepairedMesh>>;

/// Name of a structure and geometryHash of its surface.
using StructureKey = std::pair<std::string, std::string>;

/// The touched surfaces of all structures, from ticks. @par Thread Any, one at a time.
class PALPATE_EXPORT TouchedSurfaces
{
  public:
    /// Finds a structure by the scene of a tick and the number of a contact. An empty key: unknown.
    using KeyOf = std::function<StructureKey(std::uint32_t scene, std::uint32_t structure)>;

    /// @param meshes  contacts with other surfaces are not counted
    /// @param distance_mm  see TouchedSurface
    TouchedSurfaces(MeshesByHash meshes, KeyOf keyOf, double distance_mm);

    /// Adds the contacts of a tick. @param time_s  time of the tick, ascending @param dt_s  its duration
    void add(const servo::TickRecord& tick, double time_s, double dt_s);

    /// The structures touched so far.
    [[nodiscard]] const std::map<StructureKey, std::unique_ptr<TouchedSurface>>& touched() const noexcept
    {
        return m_touched;
    }
    /// Takes a surface out; null if the structure was never touched.
    [[nodiscard]] std::unique_ptr<TouchedSurface> take(const StructureKey& key);

  private:
    TouchedSurface* surfaceOf(std::uint32_t scene, std::uint32_t structure);

    MeshesByHash m_meshes;
    KeyOf m_keyOf;
    double m_distance_mm;
    std::map<StructureKey, std::unique_ptr<TouchedSurface>> m_touched;
    /// Cached lookup for one contact index.
    struct Last
    {
        std::uint32_t scene = 0;
        std::uint32_t structure = std::numeric_limits<std::uint32_t>::max(); ///< no cached structure
        TouchedSurface* surface = nullptr;
    };
    std::array<Last, haptics::kMaxContacts> m_last{};
};

} // namespace palpate::session
