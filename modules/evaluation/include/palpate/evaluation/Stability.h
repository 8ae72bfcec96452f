// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/device/DevicePresets.h>
#include <palpate/haptics/HapticScene.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// How stiff a surface may be before device, hand and sampled force oscillate, found by closing the loop in virtual
/// time: the servo's own tick (gate, god-object, tissue, passivity controller) against a simulated device held by a
/// simulated hand. Deterministic.
namespace palpate::evaluation::stability {

using core::Vec3;

/// How a hand holds the device: a mass on the tip, a spring and a damper to where it wants to be.
struct Grip
{
    std::string name;
    double mass_kg = 0.0;
    double stiffness_N_per_mm = 0.0;
    double damping_Ns_per_mm = 0.0;
};

/// The two grips that every shape is held with. The light one is the hard case: little mass, little damping (0.16 of
/// critical on a Touch). It is a choice below what is published; "a fingertip" is of the middle of what Hajian & Howe
/// measured at low force, J. Biomech. Eng. 119 (1997) 109, doi:10.1115/1.2796052.
[[nodiscard]] const std::vector<Grip>& grips();

/// Where a hand presses.
struct Hold
{
    Vec3 p_W = Vec3::Zero();          ///< on the surface, where it rests in the end [mm]
    Vec3 d_W = -Vec3::UnitZ();        ///< unit, into the surface
    Vec3 slideFrom_mm = Vec3::Zero(); ///< touches down beside `p_W` by this and slides to it, when not zero
};

/// Something to press.
struct Shape
{
    std::string name;
    std::vector<haptics::HapticStructure> structures; ///< stiffness, damping and law are replaced
    std::vector<double> share; ///< of the stiffness that a hand meets in all, for each structure: layers add up
    std::vector<Hold> holds;
};

/// Wall, inner corner, edge, 10 degree groove, stiffness step at a lump's border, fine sphere of 327,680 triangles, two
/// layers that share the stiffness, a wall whose map steps by 2 : 1 over 10 mm, a wall with friction.
[[nodiscard]] std::vector<Shape> standardShapes();
/// A scene as a shape: every palpable structure equally stiff where it is stiffest, in whatever layer, held at a few
/// triangles of each, and where its maps say most and change most.
[[nodiscard]] Shape shapeOf(std::string name, const haptics::HapticScene& scene);

/// Device, loop and tissue of one trial.
struct Setup
{
    device::DevicePreset preset;
    double rate_Hz = 1000.0;
    int delayTicks = 1; ///< after the tick that computed it, a force acts so many ticks late
    double tissueDamping_Ns_per_mm = 0.0;
    bool isControlled = true; ///< with the passivity controller
};

/// Largest peak-to-peak motion of the tip along any axis from 1 s to 1.5 s after the hand rests, over grips, holds,
/// and speeds of approach (30 and 200 mm/s). [mm] A hold that slips off something small and rests in the air
/// counts for nothing; infinite when all do.
[[nodiscard]] double restlessness_mm(const Shape& shape, double stiffness_N_per_mm, const Setup& setup);

/// Motion at rest from which on it counts as a limit cycle. [mm]
inline constexpr double kLimitCycle_mm = 0.05;
/// The search ends here. [N/mm]
inline constexpr double kStiffest_N_per_mm = 25.0;

/// The largest stiffness below which no limit cycle was found, to 4 %; kStiffest_N_per_mm when none at all was.
[[nodiscard]] double largestStiffness(const Shape& shape, const Setup& setup);

/// Where a map of stiffness bends most for a device: at an edge of its triangles, from flat to rising or from rising
/// to steeper.
struct MapEdge
{
    std::size_t structure = 0;
    Vec3 p_W = Vec3::Zero(); ///< middle of the edge [mm]
    double jump_N = 0.0;     ///< by which the push aside `W grad s` jumps there, with a hand that rests there
    double swing_mm = 0.0;   ///< of the tip about it that the device can't be sure to damp, peak to peak
};

/// A tip that a map pushes aside comes to rest where that push begins, and the push switched on and off late is a relay
/// in the loop: it keeps the tip swinging, however soft the tissue. Where the swing is below kLimitCycle_mm the tip
/// rests. Friction of the tissue takes the push, and so all of this, away.
/// @param setup  its device, rate and delay; the tissue is the scene's own
/// @return the edge with the largest swing over both grips; nothing without a map of stiffness that bends that way
/// @par Source resources/docs/stability.md, "A map's edges": the relay's describing function against the damping, the
///             friction and the mass of device and hand.
[[nodiscard]] std::optional<MapEdge> worstMapEdge(const haptics::HapticScene& scene, const Setup& setup);

/// What the controller changes in the force while a hand presses and slides over the shape at 100 mm/s.
struct Cost
{
    double mean_percent = 0.0; ///< of the force
    double p99_percent = 0.0;
};
[[nodiscard]] Cost controllerCost(const Shape& shape, double stiffness_N_per_mm, const Setup& setup);

/// One shape with one device.
struct Row
{
    std::string device, shape;
    double stated_N_per_mm = 0.0;  ///< the most that the maker states
    double without_N_per_mm = 0.0; ///< held without the controller
    double with_N_per_mm = 0.0;    ///< held with it
    double restless_mm = 0.0;      ///< with it, at what is stated
    Cost cost;                     ///< at what is stated
    Cost costSoft;                 ///< at 0.3 N/mm, or what is stated when less: tissue
    [[nodiscard]] bool isHeld() const { return restless_mm < kLimitCycle_mm; }
};

/// Held stiffness on the wall against one quantity.
struct SweepPoint
{
    double x = 0.0;
    double without_N_per_mm = 0.0;
    double with_N_per_mm = 0.0;
    double passive_N_per_mm = 0.0; ///< 2 (b - |B|) / T
    double held_N_per_mm = 0.0;    ///< what the window allows, servo::heldStiffness_N_per_mm
};
struct Sweep
{
    std::string device, what, unit;
    std::vector<SweepPoint> points;
};

struct Result
{
    std::string subject; ///< "standard shapes" or the scene
    double rate_Hz = 1000.0;
    int delayTicks = 1;
    std::vector<Row> rows;
    std::vector<Sweep> sweeps;
    double duration_s = 0.0;
};

struct Options
{
    std::vector<device::DevicePreset> presets; ///< to measure
    double rate_Hz = 1000.0;
    int delayTicks = 1;
    bool hasSweeps = true;
    std::function<void(double share, const std::string& what)> progress;
};
[[nodiscard]] Result measure(const std::string& subject, const std::vector<Shape>& shapes, const Options& options);

/// @return one line for each device of `options` that a map of the scene can keep swinging: structure, device, place,
/// jump and swing. See worstMapEdge.
[[nodiscard]] std::vector<std::string> mapWarnings(const haptics::HapticScene& scene, const Options& options);

/// `stability.html` (self-contained) and `stability.csv` in a folder, each only when whole.
[[nodiscard]] core::Status writeReport(const std::filesystem::path& folder, const Result& result);
[[nodiscard]] std::string html(const Result& result);
[[nodiscard]] std::string csv(const Result& result);

} // namespace palpate::evaluation::stability
