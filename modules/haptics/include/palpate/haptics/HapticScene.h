// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/ForceTable.h"
#include "palpate/haptics/TickResult.h"
#include "palpate/haptics/Tissue.h"
#include "palpate/haptics/TissueMap.h"

#include <palpate/geometry/SurfaceIndex.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace palpate::haptics {

/// One palpable structure. Its surface is shared, so that a change of tissue needs no new index.
struct HapticStructure
{
    std::string name;
    std::shared_ptr<const geometry::SurfaceIndex> surface; ///< world frame [mm]; never null in a scene
    Tissue tissue;
    std::uint32_t layer = 0; ///< 0 is the outermost; structures of one layer share one god-object
    TissueMaps maps{};
    /// The law by which the force rises; null: linear. A scene makes it of the tissue's law where that is another one
    /// and no table is given, as from a recording.
    std::shared_ptr<const ForceTable> law{};

    /// True without friction, a law of its own or a map.
    [[nodiscard]] bool isPlain() const noexcept { return law == nullptr && maps.isEmpty() && !tissue.hasFriction(); }
    [[nodiscard]] bool isDamped() const noexcept { return tissue.damping_Ns_per_mm != 0.0 || !maps.damping.isEmpty(); }
    /// Force and energy by depth, without the maps.
    /// @par Real-time Wait-free.
    [[nodiscard]] ForceTable::Value lawAt(double depth_mm) const noexcept
    {
        const double force_N = tissue.stiffness_N_per_mm * depth_mm;
        return law == nullptr ? ForceTable::Value{force_N, 0.5 * force_N * depth_mm} : law->at(depth_mm);
    }
    /// True when the force by depth falls nowhere.
    [[nodiscard]] bool neverFalls() const noexcept { return law == nullptr || law->neverFalls(); }
    /// The integral of depth times the law's force [N·mm^2], without the maps.
    [[nodiscard]] double momentAt(double depth_mm) const noexcept
    {
        return law == nullptr ? tissue.stiffness_N_per_mm * depth_mm * depth_mm * depth_mm / 3.0
                              : law->moment(depth_mm);
    }
};

/// The structures that share one god-object: all that a god-object knows of a scene.
struct HapticLayer
{
    std::uint32_t number = 0;              ///< that its structures give; the lowest of those that are merged into it
    std::uint32_t lastNumber = 0;          ///< the highest
    std::vector<std::uint32_t> structures; ///< numbers in the scene, in the order of the hierarchy's leaves
    std::vector<const geometry::SurfaceIndex*> surfaces; ///< by number in the scene; null where it has none
    geometry::BoxHierarchy hierarchy; ///< over the structures' boxes: a tick pays only for those near
    double facetSize_mm = 0.0;        ///< of the finest structure
    double skin_mm = 0.0;             ///< the largest of the structures'
    double fingertip_mm = 0.0;        ///< radius of the ball that touches; 0 = a point
    bool isPlain = true;              ///< all of its structures are
    bool isLarge = false;             ///< more nodes than a core's own caches hold: a visit waits for memory
    /// The scene's structures; null where none of the layer has friction.
    const HapticStructure* frictional = nullptr;
    bool drags = false; ///< some of its structures' friction does

    [[nodiscard]] const geometry::SurfaceIndex& surface(std::uint32_t structure) const noexcept
    {
        return *surfaces[structure];
    }
};

/// What the servo thread can touch: an immutable list of structures sorted into layers, outermost first. Built and
/// destroyed outside the servo thread, which only ever holds a pointer to it.
class HapticScene
{
  public:
    static constexpr std::size_t kMaxLayers = haptics::kMaxLayers;

    /// @param structures  those without a surface or without triangles are left out of every layer but keep their
    ///                    number. Layer numbers need not be contiguous: only their order counts.
    /// @param fingertip_mm  radius of the ball that touches, its centre being the god-object; 0 = a point
    /// @pre 0 <= fingertip_mm <= kMostFingertip_mm
    explicit HapticScene(std::vector<HapticStructure> structures, double fingertip_mm = 0.0);
    HapticScene(HapticScene&&) noexcept = default; // its layers point to its structures
    HapticScene& operator=(HapticScene&&) noexcept = default;
    ~HapticScene() = default;

    static constexpr double kMostFingertip_mm = 50.0;
    [[nodiscard]] double fingertip_mm() const noexcept { return m_fingertip_mm; }

    [[nodiscard]] const std::vector<HapticStructure>& structures() const noexcept { return m_structures; }
    [[nodiscard]] std::size_t layerCount() const noexcept { return m_layers.size(); }
    [[nodiscard]] const HapticLayer& layer(std::size_t layer) const noexcept { return m_layers[layer]; }
    /// @return true when the scene's numbers can hold what a HIP at `p_W` needs: it is finite and at most kFarthest
    /// times the scene's extent away from its middle. Beyond, a HIP's own last digit is larger than the skin: one
    /// in front of a surface can't be told from one behind it.
    [[nodiscard]] bool reaches(const Vec3& p_W) const noexcept PALPATE_NONBLOCKING
    {
        return ((p_W - m_middle).array().abs() <= m_farthest_mm).all(); // not for NaN either
    }
    /// The skin is at least 2^-40 of the extent, and a double has 53 bits: 2^13.
    static constexpr double kFarthest = 8192.0;
    /// True when a structure that can be touched has a damper, and ticks need the hand's velocity.
    [[nodiscard]] bool isDamped() const noexcept { return m_isDamped; }
    /// Bytes of all surfaces, counting a shared one once.
    [[nodiscard]] std::size_t byteSize() const;

  private:
    std::vector<HapticStructure> m_structures;
    std::vector<HapticLayer> m_layers;
    double m_fingertip_mm;
    Vec3 m_middle = Vec3::Zero();
    double m_farthest_mm = std::numeric_limits<double>::max();
    bool m_isDamped = false;
};

} // namespace palpate::haptics
