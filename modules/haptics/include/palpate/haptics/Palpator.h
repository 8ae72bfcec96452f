// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/GodObject.h"
#include "palpate/haptics/HapticScene.h"

#include <array>
#include <cstdint>

namespace palpate::haptics {

/// What one servo tick gives.
struct TickResult
{
    Vec3 p_WG = Vec3::Zero();    ///< god-object of the layer that is reported (see `structure`) [mm]
    Vec3 f_W = Vec3::Zero();     ///< force on the hand, summed over the layers, unbounded [N]
    Vec3 n_W = Vec3::Zero();     ///< unit direction of the contact, from surface to free space; zero in free space
    std::int32_t structure = -1; ///< number of the touched structure in the scene, -1 in free space; with several
                                 ///< layers in contact, the outermost one
    std::uint32_t triangle = 0;  ///< touched triangle, index in the structure's mesh as given to `repair`
    std::array<ActiveConstraint, 3> active{};  ///< planes that hold the god-object of the reported layer
    std::uint8_t constraints = 0;              ///< active constraints of the reported layer, 0 to 3
    TickStatus status = TickStatus::Converged; ///< worst over the layers
    std::uint32_t iterations = 0;              ///< summed over the layers
};

/// Everything that decides the coming ticks besides the scene and the HIP. Trivially copyable, so that a recording can
/// carry it and a replay can start from it bit for bit.
struct PalpatorState
{
    std::array<GodObjectState, HapticScene::kMaxLayers> layers{};
    Vec3 p_WH = Vec3::Zero();  ///< HIP of the previous tick [mm]
    std::uint32_t started = 0; ///< 0 before the first tick
};

/// Feels a scene with one HIP: moves each layer's god-object and adds up the layers' forces. The same code serves the
/// servo thread, replays and reports.
class Palpator
{
  public:
    Palpator();

    /// Lets the coming ticks feel another scene. God-objects stay where they are, each with the layer of its number (a
    /// structure that appears around one lets it out freely); that of a layer whose number is new starts at the HIP.
    /// @param scene  only read; must outlive its use here; null = nothing to touch
    /// @par Real-time Wait-free.
    void setScene(const HapticScene* scene) noexcept PALPATE_NONBLOCKING;
    [[nodiscard]] const HapticScene* scene() const noexcept { return m_scene; }

    /// Forgets all contacts: the next tick starts every god-object at its HIP.
    /// @par Real-time Wait-free.
    void reset() noexcept PALPATE_NONBLOCKING;

    /// Feels one servo tick.
    /// @param p_WH  HIP [mm]; one that is not finite, or farther away than HapticScene::reaches, leaves everything as
    ///              it was and gives zero force
    /// @param dt_s  time since the previous tick [s], > 0; gives the damper its velocity, zero on the first tick
    /// @par Real-time Wait-free, no allocation; bounded by GodObjectLimits for each layer.
    [[nodiscard]] TickResult step(const Vec3& p_WH, double dt_s) noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] PalpatorState state() const noexcept;
    /// Continues from a recorded state. @pre the scene is the one the state was taken on
    void restore(const PalpatorState& state) noexcept;

  private:
    /// The numbers of the layer that a god-object belongs to.
    struct Numbers
    {
        std::uint32_t first = 1;
        std::uint32_t last = 0;
    };

    const HapticScene* m_scene = nullptr;
    std::array<GodObject, HapticScene::kMaxLayers> m_layers;
    std::array<Numbers, HapticScene::kMaxLayers> m_numbers; ///< none: first > last
    Vec3 m_p_WH = Vec3::Zero();
    bool m_started = false;
};

} // namespace palpate::haptics
