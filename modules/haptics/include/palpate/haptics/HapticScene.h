// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/ForceTable.h"
#include "palpate/haptics/TickResult.h"
#include "palpate/haptics/Tissue.h"
#include "palpate/haptics/TissueMap.h"

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>
#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/geometry/SurfaceMotion.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace palpate::haptics {

/// One palpable structure. The surface is shared, so that changing the tissue does not rebuild the index.
struct HapticStructure
{
    std::string name;
    /// In the world frame [mm], with a motion the rest shape; null: hidden, not palpable
    std::shared_ptr<const geometry::SurfaceIndex> surface;
    Tissue tissue;
    std::uint32_t layer = 0; ///< 0 is the outermost; structures of the same layer share one god-object
    TissueMaps maps{};
    /// Tabulated force law; null: linear. If null and the tissue's law is not linear, the scene builds the table. A
    /// recording supplies its own table.
    std::shared_ptr<const ForceTable> law{};
    /// How the surface moves, see docs/motion.md; null: it rests. Structures of one layer number that move alike share
    /// a god-object, others get a layer of their own.
    std::shared_ptr<const geometry::SurfaceMotion> motion{};

    /// Returns true if the structure has no friction, no nonlinear law and no maps.
    [[nodiscard]] bool isPlain() const noexcept { return law == nullptr && maps.isEmpty() && !tissue.hasFriction(); }
    [[nodiscard]] bool isDamped() const noexcept { return tissue.damping_Ns_per_mm != 0.0 || !maps.damping.isEmpty(); }
    /// Returns force [N] and energy [mJ] at a depth [mm], without the maps.
    /// @par Real-time Wait-free.
    [[nodiscard]] ForceTable::Value lawAt(double depth_mm) const noexcept
    {
        const double force_N = tissue.stiffness_N_per_mm * depth_mm;
        return law == nullptr ? ForceTable::Value{force_N, 0.5 * force_N * depth_mm} : law->at(depth_mm);
    }
    /// Returns true if the force never decreases with depth.
    [[nodiscard]] bool isMonotonic() const noexcept { return law == nullptr || law->isMonotonic(); }
    /// Returns the integral of depth times the law's force from the surface to `depth_mm` [N·mm^2], without the maps.
    [[nodiscard]] double momentAt(double depth_mm) const noexcept
    {
        return law == nullptr ? tissue.stiffness_N_per_mm * depth_mm * depth_mm * depth_mm / 3.0
                              : law->moment(depth_mm);
    }
};

/// The structures that share one god-object. A god-object accesses the scene only through its layer.
struct HapticLayer
{
    std::uint32_t number = 0;     ///< layer number as given by the structures; if layers were merged, the lowest
    std::uint32_t lastNumber = 0; ///< if layers were merged, the highest number
    std::vector<std::uint32_t> structures; ///< indices in the scene, in the order of the hierarchy's leaves
    std::vector<const geometry::SurfaceIndex*>
        surfaces; ///< of all layers, indexed by structure; null for hidden structures
    geometry::BoxHierarchy
        hierarchy;             ///< over the bounding boxes of the structures: a tick only visits structures nearby
    double facetSize_mm = 0.0; ///< of the structure with the smallest facets
    double skin_mm = 0.0;      ///< maximum over the structures
    double fingertip_mm = 0.0; ///< radius of the ball-shaped probe; 0 = a point
    bool isPlain = true;       ///< all structures of the layer are plain (HapticStructure::isPlain)
    bool isLarge = false; ///< the hierarchy exceeds the private caches of a core: traversal is bound by memory latency
    /// The scene's array of structures, indexed by structure; null if no structure of the layer has friction.
    const HapticStructure* frictional = nullptr;
    bool drags = false; ///< friction of at least one structure drags the god-object
    /// Motion of all structures of the layer; null: they rest. Surfaces and god-object are in the rest shape.
    const geometry::SurfaceMotion* motion = nullptr;

    [[nodiscard]] const geometry::SurfaceIndex& surface(std::uint32_t structure) const noexcept
    {
        return *surfaces[structure];
    }
};

/// All structures that the servo thread can touch: an immutable list sorted into layers, outermost first. Built and
/// destroyed outside the servo thread, which only holds a pointer.
///
/// @code
/// HapticStructure liver;
/// liver.name = "liver";
/// liver.surface = surface;               // std::shared_ptr<const geometry::SurfaceIndex>
/// liver.tissue.stiffness_N_per_mm = 0.2; // typical of a liver: 0.1 to 0.3 N/mm
/// const auto scene = HapticScene::make({liver});
/// if (!scene.isOk()) {
///     return scene.status();
/// }
/// loop.setScene(scene.value());
/// @endcode
///
/// Edits while touching make a new scene, which shares the surfaces, so that only the changed parts are computed:
///
/// @code
/// const auto softer = scene.value()->with(0, softTissue);
/// const auto hidden = softer.value()->without(0);
/// loop.setScene(hidden.value());
/// @endcode
class PALPATE_EXPORT HapticScene
{
  public:
    static constexpr std::size_t kMaxLayers = haptics::kMaxLayers;

    /// Builds the layers.
    /// @param structures  Structures without a surface or without triangles are left out of every layer but keep their
    /// index. Layer numbers need not be contiguous: only their order matters. Beyond kMaxLayers, structures join the
    /// last layer and its motion.
    /// @param fingertip_mm  radius of the ball-shaped probe, whose centre is the god-object; 0 = a point
    /// @pre 0 <= fingertip_mm <= kMostFingertip_mm
    explicit HapticScene(std::vector<HapticStructure> structures, double fingertip_mm = 0.0);
    /// Checks the structures and builds the layers. Tissues: core::check. The scene costs the same per tick as one from
    /// the constructor, which checks nothing.
    /// @return OutOfRange or NonFinite: a tissue or the radius of the probe; Empty: a structure without a surface or
    ///         without triangles. Hide structures with `without`. Unsupported: motions that need more layers than
    ///         kMaxLayers
    [[nodiscard]] static core::Result<std::shared_ptr<const HapticScene>> make(std::vector<HapticStructure> structures,
                                                                               double fingertip_mm = 0.0);
    /// Returns a scene with another tissue of one structure. The force law is computed from the tissue. A servo loop
    /// eases the change of the force in; a bare Palpator steps within one tick.
    /// @return OutOfRange: no structure of this number; or the error of the tissue
    [[nodiscard]] core::Result<std::shared_ptr<const HapticScene>> with(std::size_t number, const Tissue& tissue) const;
    /// Returns a scene in which one structure is hidden. The others keep their numbers.
    /// @return OutOfRange: no structure of this number
    [[nodiscard]] core::Result<std::shared_ptr<const HapticScene>> without(std::size_t number) const;

    HapticScene(HapticScene&&) noexcept = default; // not copyable: the layers point into m_structures
    HapticScene& operator=(HapticScene&&) noexcept = default;
    ~HapticScene() = default;

    /// Returns true if the surface or the stored energy of a palpable structure depends on the time.
    [[nodiscard]] bool isMoving() const noexcept { return m_isMoving; }

    static constexpr double kMostFingertip_mm = 50.0;
    [[nodiscard]] double fingertip_mm() const noexcept { return m_fingertip_mm; }

    [[nodiscard]] const std::vector<HapticStructure>& structures() const noexcept { return m_structures; }
    [[nodiscard]] std::size_t layerCount() const noexcept { return m_layers.size(); }
    [[nodiscard]] const HapticLayer& layer(std::size_t layer) const noexcept { return m_layers[layer]; }
    /// Returns true if a HIP at `p_W` can be simulated: finite and at most kFarthest times the scene's extent away from
    /// the centre. Beyond that distance the last bit of a coordinate exceeds the skin, and positions in front of and
    /// behind a surface become indistinguishable.
    [[nodiscard]] bool reaches(const Vec3& p_W) const noexcept PALPATE_NONBLOCKING
    {
        return ((p_W - m_middle).array().abs() <= m_farthest_mm).all(); // also false for NaN
    }
    /// The skin is at least 2^-40 of the extent and a double has a 53-bit significand: 2^(53 - 40) = 2^13.
    static constexpr double kFarthest = 8192.0;
    /// Returns true if a palpable structure has a damper, so that ticks need the velocity of the hand.
    [[nodiscard]] bool isDamped() const noexcept { return m_isDamped; }
    /// Memory of all surfaces in bytes; shared surfaces are counted once.
    [[nodiscard]] std::size_t byteSize() const;

  private:
    std::vector<HapticStructure> m_structures;
    std::vector<HapticLayer> m_layers;
    double m_fingertip_mm;
    Vec3 m_middle = Vec3::Zero();
    double m_farthest_mm = std::numeric_limits<double>::max();
    bool m_isDamped = false;
    bool m_isMoving = false;
};

} // namespace palpate::haptics
