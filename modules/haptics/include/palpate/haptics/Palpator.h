// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"
#include "palpate/haptics/PalpatorState.h"
#include "palpate/haptics/TickResult.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace palpate::haptics {

/// Bounds on the work of one tick, in counts and never in time, so that a replay is exact.
struct GodObjectLimits
{
    std::uint32_t iterations = 512; ///< moves tried in a tick, for each layer; reaching it is reported
    /// Units of about 10 ns (resources/docs/cost.md) for a point; reaching it is reported, too. Layers share it, the
    /// innermost first, so that outer layers don't change the innermost one's result; each layer gets at least 1/32.
    std::uint32_t work = 20000;
    std::uint32_t ballWork = 22000; ///< the same for a ball
};

/// What a Palpator has room for.
enum class Fingertips : std::uint8_t
{
    Points, ///< at most 64 KiB; a scene that is touched with a ball gives InvalidInput
    Any,
};

/// Feels a scene with one HIP: moves each layer's god-object and adds up the layers' forces. The same code serves the
/// servo thread, replays and reports.
class Palpator
{
  public:
    /// Allocates all that the ticks will need, in the constructing thread.
    explicit Palpator(Fingertips fingertips, const GodObjectLimits& limits = {});
    Palpator()
        : Palpator(Fingertips::Any)
    {
    }
    ~Palpator();
    Palpator(Palpator&&) noexcept;
    Palpator& operator=(Palpator&&) noexcept;

    /// Lets the coming ticks feel another scene. God-objects stay where they are, each with the layer of its number (a
    /// structure that appears around one lets it out freely); the god-object of a layer with a new number starts at the
    /// HIP.
    /// @param scene  only read; must outlive its use here; null = nothing to touch
    /// @par Real-time Wait-free.
    void setScene(const HapticScene* scene) noexcept PALPATE_NONBLOCKING;
    [[nodiscard]] const HapticScene* scene() const noexcept;

    /// Forgets all contacts: the next tick starts every god-object at its HIP.
    /// @par Real-time Wait-free.
    void reset() noexcept PALPATE_NONBLOCKING;

    /// Feels one servo tick.
    /// @param p_WH  HIP [mm]; one that is not finite, or farther away than HapticScene::reaches, leaves everything as
    ///              it was and gives zero force
    /// @param dt_s  time since the previous tick [s], > 0; gives the damper its velocity, zero on the first tick
    /// @par Real-time Wait-free, no allocation; bounded by GodObjectLimits.
    [[nodiscard]] TickResult step(const Vec3& p_WH, double dt_s) noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] std::size_t byteSize() const noexcept; ///< of all that it holds, without the scene

    [[nodiscard]] PalpatorState state() const noexcept;
    /// Continues from a recorded state. @pre the scene is the one the state was taken on
    void restore(const PalpatorState& state) noexcept;

  private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace palpate::haptics
