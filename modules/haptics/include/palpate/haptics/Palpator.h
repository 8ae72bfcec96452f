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

/// What a change of scene does to contacts.
enum class Continuity : std::uint8_t
{
    Contacts, ///< they go along with what is touched, see Palpator::setScene
    Places,   ///< god-objects stay where they are, whatever the new scene has there; as recordings before version 4 do
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

    /// How far a hand may have moved to count as being where it was. [mm]
    static constexpr double kNear_mm = 5.0;

    /// Lets the coming ticks feel another scene. God-objects stay where they are, each with the layer of its number (a
    /// structure that appears around one lets it out freely); the god-object of a layer with a new number starts at the
    /// HIP.
    ///
    /// A structure is the same in both scenes when it has the same number and name. Where its surface is another one
    /// (it was moved, smoothed or read anew), a god-object that touches it goes along, and one that it would have come
    /// to lie around is put in front again if that is at most 1 mm away. A contact whose structure is taken out is
    /// remembered and given back with it, while the HIP is within kNear_mm of where it was: for 0.5 s of ticks, and
    /// without an end for a surface without an inside, of which the side would be lost.
    /// @param scene  only read; must outlive its use here, which ends when another one has been set; null = nothing to
    ///               touch
    /// @return true when a contact was given back: its force comes at once, so ease it in
    /// @par Real-time Wait-free; where surfaces were replaced, bounded by 4096 triangles of each that is near.
    bool setScene(const HapticScene* scene, Continuity continuity = Continuity::Contacts) noexcept PALPATE_NONBLOCKING;
    /// @return true when a god-object touches a surface without an inside.
    [[nodiscard]] bool isOnSheet() const noexcept PALPATE_NONBLOCKING;
    [[nodiscard]] const HapticScene* scene() const noexcept;

    /// Forgets all contacts: the next tick starts every god-object at its HIP.
    /// @par Real-time Wait-free.
    void reset() noexcept PALPATE_NONBLOCKING;

    /// Feels one servo tick.
    /// @param p_WH  HIP [mm]; one that is not finite, or farther away than HapticScene::reaches, leaves everything as
    ///              it was and gives zero force
    /// @param dt_s  time since the previous tick [s], > 0
    /// @param v_WH  the hand's velocity, for dampers [mm/s]; null: the difference from the HIP of the previous tick,
    ///              zero on the first. That is right for exact positions; those of an encoder come in steps, and their
    ///              differences are pulses: give what servo::MotionTrack makes of them
    /// @par Real-time Wait-free, no allocation; bounded by GodObjectLimits.
    [[nodiscard]] TickResult step(const Vec3& p_WH, double dt_s,
                                  const Vec3* v_WH = nullptr) noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] std::size_t byteSize() const noexcept; ///< of all that it holds, without the scene

    [[nodiscard]] PalpatorState state() const noexcept;
    /// Continues from a recorded state. @pre the scene is the one the state was taken on
    void restore(const PalpatorState& state) noexcept;

  private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace palpate::haptics
