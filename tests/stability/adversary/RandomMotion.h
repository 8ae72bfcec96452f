// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "JudgedLayer.h"

#include <palpate/geometry/SurfaceMotion.h>

#include <memory>

namespace palpate::adversary {

using geometry::Mat3;

/// A motion with an evaluation of its own, by the formulas of resources/docs/motion.md in long double. Nothing here
/// uses the engine's map of places, except for the displacement field of a ramp, whose lattice is not public.
class RandomMotion
{
  public:
    /// @param box  of the rest shape [mm]
    RandomMotion(const core::Box& box, Chance& chance);
    /// Only a pulse, if `isPulse`.
    RandomMotion() = default;

    void addPulse(Chance& chance);
    /// Sets the clock: own time = offset_s + rate (t - start_s), and the share of the displacement.
    void setClock(double start_s, double offset_s, double rate, double amplitude);
    [[nodiscard]] double phase_s(double t) const { return m_offset_s + m_rate * (t - m_start_s); }
    [[nodiscard]] double amplitude() const { return m_amplitude; }
    [[nodiscard]] bool isHeld() const { return m_rate == 0.0; }

    /// Returns the engine's motion with this clock.
    [[nodiscard]] std::shared_ptr<const geometry::SurfaceMotion> engine() const;
    [[nodiscard]] const std::string& name() const { return m_name; }
    /// Returns true for a motion that only translates.
    [[nodiscard]] bool isTranslation() const { return m_kind == Kind::Glide || m_kind == Kind::Breath; }

    /// Returns where a rest position is at a time.
    [[nodiscard]] Long3 toWorld(double t, const Long3& X) const { return place(t, X); }
    [[nodiscard]] Vec3 toWorld(double t, const Vec3& X) const { return place(t, X.cast<long double>()).cast<double>(); }
    /// Returns the rest position of a place, by fixed-point iteration: the displacement contracts.
    [[nodiscard]] Long3 toRest(double t, const Long3& p) const;
    /// ∂φ/∂X by central differences.
    [[nodiscard]] Mat3 gradient(double t, const Vec3& X) const;
    /// ∂φ/∂t by central differences [mm/s].
    [[nodiscard]] Vec3 velocity(double t, const Vec3& X) const;
    /// Step of the differences in time [s]; 0: nothing moves.
    [[nodiscard]] double timeStep_s() const;
    /// Factor on the stored energy, and its change [1/s].
    [[nodiscard]] double factor(double t) const;
    [[nodiscard]] double factorSlope(double t) const;
    /// Returns true if the factor changes with time.
    [[nodiscard]] bool isPulsing() const { return m_pulse_s != 0.0 && m_rate != 0.0; }

    [[nodiscard]] double strain() const { return m_engine == nullptr ? 0.0 : m_engine->strain(); }
    /// Bound on the second derivatives of the displacement [1/mm]: a quadratic in Bernstein form.
    [[nodiscard]] double bend_per_mm() const;
    [[nodiscard]] double spacing_mm() const { return m_lattice.spacing_mm; }
    /// Largest error of `gradient` by rounding.
    [[nodiscard]] double gradientError(const Vec3& X) const;
    /// Largest error of `velocity` by rounding and where the velocity jumps, as at the end of poses [mm/s].
    [[nodiscard]] double velocityError(double t, const Vec3& X) const;
    /// Largest error of a place by the rounding of the motion's own time in the engine [mm].
    [[nodiscard]] double placeError(double t, const Vec3& X) const;
    /// Largest velocity of a displacement of the size of the strain per length [1/s].
    [[nodiscard]] double rate_per_s() const;

  private:
    enum class Kind
    {
        None,
        Glide,  ///< poses that only translate
        Poses,  ///< of a rigid body
        Breath, ///< of the whole
        Ramp,   ///< breath with a ramp
        Frames,
    };
    void makePoses(const core::Box& box, Chance& chance);
    void makeBreath(const core::Box& box, Chance& chance);
    void makeFrames(const core::Box& box, Chance& chance);
    [[nodiscard]] long double ownTime(long double t) const { return m_offset_s + m_rate * (t - m_start_s); }
    [[nodiscard]] long double curve(const std::vector<double>& table, long double turns) const;
    [[nodiscard]] long double weightOf(std::size_t frame, long double turns) const;
    [[nodiscard]] Long3 displacement(long double t, const Long3& X) const;
    [[nodiscard]] Long3 place(long double t, const Long3& X) const;
    [[nodiscard]] Long3 posed(long double t, const Long3& X) const;
    /// @param own  the motion's own time
    [[nodiscard]] Long3 placeAt(long double own, const Long3& X) const;

    Kind m_kind = Kind::None;
    std::string m_name = "still";
    std::shared_ptr<const geometry::SurfaceMotion> m_engine; ///< with the clock at the start; null: none
    double m_period_s = 0.0;
    std::vector<geometry::PoseKey> m_keys;
    bool m_isPeriodic = false;
    std::vector<double> m_curve; ///< table of a breath
    Vec3 m_shift = Vec3::Zero(); ///< of a breath [mm]
    geometry::MotionLattice m_lattice;
    std::vector<std::vector<Vec3>> m_frames; ///< with a closed rim
    double m_pulse_s = 0.0, m_pulse = 0.0;
    double m_start_s = 0.0, m_offset_s = 0.0, m_rate = 1.0, m_amplitude = 1.0;
};

} // namespace palpate::adversary
