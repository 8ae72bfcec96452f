// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Realtime.h>
#include <palpate/core/Status.h>
#include <palpate/core/Types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace palpate::geometry {

using core::Vec3;
using Mat3 = Eigen::Matrix3d;

/// Pose at a time.
struct PoseKey
{
    double time_s = 0.0;
    core::Transform X_WR = core::Transform::Identity(); ///< rest frame to world
};

/// Lattice of a free-form deformation: cubic cells with quadratic B-splines. Each axis has two more control points than
/// cells; control point (i, j, k) is at origin + spacing (i - 1/2, j - 1/2, k - 1/2).
struct MotionLattice
{
    Vec3 origin_mm = Vec3::Zero(); ///< lowest corner of the cells
    double spacing_mm = 10.0;      ///< edge of a cell, > 0
    std::array<std::uint32_t, 3> cells{};

    [[nodiscard]] std::size_t controlCount() const noexcept
    {
        return std::size_t{cells[0] + 2} * (cells[1] + 2) * (cells[2] + 2);
    }
    [[nodiscard]] std::size_t control(std::size_t i, std::size_t j, std::size_t k) const noexcept
    {
        return i + (cells[0] + 2) * (j + (cells[1] + 2) * k);
    }
    [[nodiscard]] Vec3 place(std::size_t i, std::size_t j, std::size_t k) const noexcept
    {
        return origin_mm + spacing_mm * Vec3(double(i) - 0.5, double(j) - 0.5, double(k) - 0.5);
    }
    /// Returns the lattice whose cells cover a box.
    [[nodiscard]] PALPATE_EXPORT static MotionLattice around(const core::Box& box, double spacing_mm);
};

/// Breathing: the rest shape is displaced by amplitude · sin^exponent(π t / period).
/// @par Source exponent 4: Lujan et al., Medical Physics 26 (1999) 715
struct Breath
{
    double period_s = 4.0;            ///< > 0; typical 3 to 5 s
    Vec3 amplitude_mm = Vec3::Zero(); ///< typical of a liver: 10 to 20 mm from head to foot
    int exponent = 4;                 ///< even, at least 2
    /// Without displacement at `still_W` and beyond, with all of it at `full_W` and beyond, a smooth ramp between.
    /// Equal: the structure moves as a whole.
    Vec3 still_W = Vec3::Zero(), full_W = Vec3::Zero();
};

/// Motion of a rest shape: time t and rest position X give the position now, φ(X, t) = pose(t) (X + u(X, t)), with a
/// displacement u of the lattice that is one-to-one. A force law in the rest shape then holds in the moving shape: the
/// hand is taken to X = φ⁻¹(p), and the force f_R found there is f = F⁻ᵀ f_R with F = ∂φ/∂X
/// (resources/docs/motion.md).
///
/// The motion only depends on the time that it is given. Its arithmetic uses + − × ÷ √ only, so that a replay gives the
/// same bits on every machine; everything else is tabulated when the motion is made.
/// @par Thread Immutable. Functions marked real-time: any thread.
class PALPATE_EXPORT SurfaceMotion
{
  public:
    /// Largest accepted principal value of the displacement gradient ∂u/∂X [1], at any time: the largest error of a
    /// length in the rest shape. Below 1 the motion is one-to-one, because u then moves two places apart or together by
    /// less than their distance.
    static constexpr double kMaxStrain = 0.3;
    /// Largest accepted distance between φ(φ⁻¹(p)) and p [mm].
    static constexpr double kInverse_mm = 1e-9;
    using Made = core::Result<std::shared_ptr<const SurfaceMotion>>;

    /// Rigid motion through poses, smooth between them. Before the first and after the last pose it rests; periodic: it
    /// repeats, with the first pose equal to the last.
    /// @return OutOfRange: fewer than two poses, or times that do not ascend; NonFinite; Mismatch: not periodic
    [[nodiscard]] static Made poses(const std::vector<PoseKey>& keys, bool isPeriodic = false);
    /// @param bounds  box of the rest shape, for the lattice of a ramp [mm]
    /// @return OutOfRange or NonFinite with the field, or the strain of a ramp that is too short
    [[nodiscard]] static Made breath(const Breath& breath, const core::Box& bounds);
    /// The same with the displacement of a lattice instead of an amplitude.
    /// @param exponent  even, at least 2
    /// @param displacements  one for each control point [mm]; the outermost take the values of their neighbours
    /// @return as breath and frames
    [[nodiscard]] static Made breath(double period_s, int exponent, const MotionLattice& lattice,
                                     const std::vector<Vec3>& displacements);
    /// Displacements of a lattice at equal steps of a period, with a periodic cubic between them.
    /// @param frames  one displacement per control point and frame [mm]. The outermost control points take the values
    /// of their neighbours, so that the displacement goes on smoothly and constant outside of the cells.
    /// @return OutOfRange with cell and frame if the strain exceeds kMaxStrain, or if the motion may fold; also for
    /// fewer than two frames or wrong counts; NonFinite
    [[nodiscard]] static Made frames(double period_s, const MotionLattice& lattice,
                                     const std::vector<std::vector<Vec3>>& frames);
    /// Adds a periodic factor on the stored energy, 1 + share · sin²(π t / period): an artery under the finger.
    /// @param of  motion of the shape; null: at rest
    /// @return OutOfRange with the field
    [[nodiscard]] static Made pulse(double period_s, double share,
                                    const std::shared_ptr<const SurfaceMotion>& of = nullptr);

    /// Returns the motion with another clock: its own time is offset_s + rate (t − start_s). Rate 0 holds it.
    [[nodiscard]] std::shared_ptr<const SurfaceMotion> withClock(double start_s, double offset_s, double rate) const;
    /// Returns the motion with a part of its displacement. @pre 0 <= share <= 1
    [[nodiscard]] std::shared_ptr<const SurfaceMotion> withAmplitude(double share) const;
    /// Rates and amplitude that a motion can be given while it is felt.
    struct Pace
    {
        double rate = 1.0;      ///< of displacement and poses; 0 holds them
        double pulseRate = 1.0; ///< of the pulse; 0 holds it
        double amplitude = 1.0; ///< share of the displacement, 0 to 1

        friend bool operator==(const Pace&, const Pace&) = default;
    };
    /// Returns a motion that agrees with this one up to start_s and then changes to another pace smoothly, within
    /// ease_s: place and velocity of the tissue do not jump, whichever tick the new motion takes effect at, if that is
    /// not after start_s.
    /// @param start_s  at or after the end of an earlier change of this motion
    /// @param ease_s  > 0; typical 0.3
    [[nodiscard]] std::shared_ptr<const SurfaceMotion> changedAt(double start_s, double ease_s, const Pace& pace) const;
    /// Returns the motion that is at time 0 where this one is at `time_s`, for a servo loop that starts to count again.
    [[nodiscard]] std::shared_ptr<const SurfaceMotion> startingAt(double time_s) const;
    /// Returns the rates and the amplitude after the last change.
    [[nodiscard]] Pace pace() const noexcept { return {m_rate, m_pulseRate, m_amplitude}; }
    /// Returns the time at which the last change has ended [s].
    [[nodiscard]] double settled_s() const noexcept { return m_start_s + m_ease_s; }
    /// Returns the motion's own time at time t, of displacement and poses [s].
    [[nodiscard]] double phase_s(double time_s) const noexcept { return courseAt(time_s).phase_s; }

    /// Everything that depends on the time only. Make one per tick with `at`.
    struct Moment
    {
        Mat3 turn;                              ///< of the pose
        Vec3 shift;                             ///< of the pose [mm]
        Vec3 spin;                              ///< angular velocity of the pose [rad/s]
        Vec3 drift;                             ///< velocity of the pose's origin [mm/s]
        std::array<std::size_t, 4> frame;       ///< first control point of each frame of the lattice
        std::array<double, 4> weight, slope;    ///< of these frames [1], and their change [1/s]
        std::size_t frames = 0;                 ///< number of valid entries of these three
        double factor = 1.0, factorSlope = 0.0; ///< on the stored energy [1], and its change [1/s]
        bool isTurned = false;
    };
    /// @par Real-time Wait-free, no allocation.
    [[nodiscard]] Moment at(double time_s) const noexcept PALPATE_NONBLOCKING;

    /// A place in the rest shape and the motion there.
    struct Rest
    {
        Vec3 X; ///< rest position [mm]
        Mat3 F; ///< ∂φ/∂X, at most 1e-4 mm from X
        Mat3 invF;
        Vec3 arm;           ///< from the pose's origin to the position asked for, in the world [mm]
        Vec3 u;             ///< displacement of a single frame of weight 1 [mm]
        double residual_mm; ///< bound on the distance between φ(X) and the position asked for

        [[nodiscard]] bool isExact() const noexcept { return residual_mm <= kInverse_mm; }
        /// Force in the world from a force in the rest shape [N].
        [[nodiscard]] Vec3 force(const Vec3& f_R) const noexcept { return invF.transpose() * f_R; }
    };
    /// Returns the rest position of a place now, by at most 32 Newton steps, which contract from any start.
    /// @param near  start, best the rest position one tick ago [mm]
    /// @par Real-time Wait-free, no allocation.
    [[nodiscard]] Rest toRest(const Moment& moment, const Vec3& p_W,
                              const Vec3& near) const noexcept PALPATE_NONBLOCKING;
    /// Returns where a rest position is now [mm].
    /// @par Real-time Wait-free, no allocation.
    [[nodiscard]] Vec3 toWorld(const Moment& moment, const Vec3& X) const noexcept PALPATE_NONBLOCKING;
    /// As above, and sets F = ∂φ/∂X there.
    [[nodiscard]] Vec3 toWorld(const Moment& moment, const Vec3& X, Mat3& F) const noexcept PALPATE_NONBLOCKING;
    /// Returns the velocity of the material at a rest position [mm/s].
    /// @par Real-time Wait-free, no allocation.
    [[nodiscard]] Vec3 velocity(const Moment& moment, const Vec3& X) const noexcept PALPATE_NONBLOCKING;
    /// As above, with less work.
    [[nodiscard]] Vec3 velocity(const Moment& moment, const Rest& rest) const noexcept PALPATE_NONBLOCKING;

    /// Returns where the vertices of the rest shape are at a time, for drawing.
    [[nodiscard]] std::vector<Vec3> placesAt(double time_s, std::span<const Vec3> rest) const;
    /// Returns true if the shape moves. A pulse alone only changes the force.
    [[nodiscard]] bool isMoving() const noexcept;
    [[nodiscard]] double period_s() const noexcept { return m_period_s; } ///< 0: not periodic
    /// Largest principal value of the displacement gradient over all places and times, as a bound [1].
    [[nodiscard]] double strain() const noexcept { return m_strain; }
    /// Largest displacement of the lattice or of a breath at a control point and time [mm]; without poses.
    [[nodiscard]] double reach_mm() const noexcept;
    /// Returns a hash of the motion without clock, amplitude and pulse: equal for motions that take the rest shape
    /// through the same places.
    [[nodiscard]] std::uint64_t shape() const noexcept { return m_shape; }
    [[nodiscard]] bool operator==(const SurfaceMotion& other) const noexcept;

    /// Serializes the motion for a recording: little-endian doubles.
    [[nodiscard]] std::vector<std::byte> bytes() const;
    /// Reads `bytes`, with all checks of the functions above.
    [[nodiscard]] static Made fromBytes(std::span<const std::byte> bytes);

  private:
    struct Key ///< pose with its change
    {
        double time_s;
        std::array<double, 7> value, slope; ///< quaternion x, y, z, w and translation
    };
    struct Value
    {
        Vec3 u;
        Vec3 raw; ///< u of a single frame of weight 1
        Mat3 gradient;
    };
    class Patch;

    [[nodiscard]] core::Status check();
    [[nodiscard]] core::Status checkStrain();
    void setShape() noexcept;
    /// Own times with their rates, and the share of the displacement with its change [1/s], at a time.
    struct Course
    {
        double phase_s, rate, pulse_s, pulseRate, amplitude, amplitudeSlope;
    };
    [[nodiscard]] Course courseAt(double time_s) const noexcept;
    void applyPose(double t, Moment& moment) const noexcept;
    void applyBreath(const Course& course, Moment& moment) const noexcept;

    double m_period_s = 0.0;
    std::vector<double> m_curve; ///< share of the displacement at equal steps of the period; empty: frames
    Vec3 m_shift = Vec3::Zero(); ///< displacement of the whole by the curve [mm]
    MotionLattice m_lattice;     ///< without cells: none
    std::size_t m_frames = 0;    ///< of the lattice
    std::vector<std::array<double, 4>> m_controls; ///< displacements of all frames [mm]; the fourth value is 0
    std::vector<Key> m_keys;                       ///< poses
    bool m_isPeriodic = false;                     ///< the poses repeat
    double m_pulse_s = 0.0;                        ///< period of the pulse; 0: none
    std::vector<double> m_pulse;                   ///< factor at equal steps of that period
    double m_start_s = 0.0, m_offset_s = 0.0, m_rate = 1.0, m_amplitude = 1.0;
    double m_pulseOffset_s = 0.0, m_pulseRate = 1.0;
    double m_ease_s = 0.0; ///< duration of the change to these from `m_before`; 0: they hold at all times
    Pace m_before;
    double m_strain = 0.0;
    double m_bend = 0.0; ///< bound on the change of the displacement gradient per length [1/mm]
    std::uint64_t m_shape = 0;
};

} // namespace palpate::geometry
