// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/device/DevicePresets.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/study/MapEdges.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Largest stable stiffness of a surface, found by closing the loop of device, hand and sampled force in virtual time:
/// the tick of the servo (gate, god-object, tissue, passivity controller) runs against a simulated device held by a
/// simulated hand. Deterministic.
namespace palpate::evaluation::stability {

using core::Vec3;

/// Defined in the study module with the check of stiffness maps, which the user interface also needs.
using study::Grip;
using study::grips;
using study::MapEdge;

/// Place and direction of a press.
struct Hold
{
    Vec3 p_W = Vec3::Zero();   ///< contact point at rest on the surface [mm]
    Vec3 d_W = -Vec3::UnitZ(); ///< unit press direction, into the surface
    /// Offset of the touchdown point from `p_W`, followed by a slide to `p_W`; zero: no slide.
    Vec3 slideFrom_mm = Vec3::Zero();
};

/// Geometry and tissue to press.
struct Shape
{
    std::string name;
    std::vector<haptics::HapticStructure> structures; ///< stiffness, damping and law are replaced
    /// Fraction of the total contact stiffness for each structure; overlapping layers add up.
    std::vector<double> share;
    std::vector<Hold> holds;
    double own_N_per_mm = 0.0; ///< largest stiffness of an unmodified scene; 0: not a scene
};

/// Returns the standard shapes: wall, inner corner, edge, 10 degree groove, stiffness step at the border of a lump,
/// fine sphere of 327,680 triangles, two layers that share the stiffness, wall with a map that steps 2 : 1 over 10 mm,
/// wall with friction.
[[nodiscard]] std::vector<Shape> standardShapes();
/// Converts a scene to a shape. The stiffnesses of its tissues keep their proportions and are scaled together; the
/// stiffness of the shape is the largest one in the scene. Holds are placed on a few triangles of each structure, and
/// at the largest value and the largest gradient of its maps. A force law counts with its largest slope.
[[nodiscard]] Shape shapeOf(std::string name, const haptics::HapticScene& scene);

/// Device, loop and tissue of one trial.
struct Setup
{
    device::DevicePreset preset;
    double rate_Hz = 1000.0;
    int delayTicks = 1; ///< delay from computing a force to applying it, in ticks
    double tissueDamping_Ns_per_mm = 0.0;
    bool isControlled = true; ///< with the passivity controller
    double settle_s = 1.0;    ///< settling time of the hand
    std::vector<Grip> hands;  ///< grips that hold the device; empty: grips()
};

/// Largest peak-to-peak motion of the tip along any axis in the half second that starts `settle_s` after the hand has
/// stopped, over grips, holds, and approach speeds (30 and 200 mm/s). [mm] Holds that slip off a small object and end
/// in the air are ignored; infinite if all do.
[[nodiscard]] double restOscillation_mm(const Shape& shape, double stiffness_N_per_mm, const Setup& setup);

/// Smallest motion at rest that counts as a limit cycle. [mm]
inline constexpr double kLimitCycle_mm = study::kMinSwing_mm;
/// Upper limit of the search. [N/mm]
inline constexpr double kStiffest_N_per_mm = 25.0;

/// Largest stiffness without a limit cycle, to within 4 %; kStiffest_N_per_mm if no limit cycle was found at all.
/// @code
/// Setup setup;
/// setup.preset = *device::findDevicePreset("touch");
/// const double stiffest_N_per_mm = largestStiffness(standardShapes().front(), setup); // the wall
/// @endcode
[[nodiscard]] double largestStiffness(const Shape& shape, const Setup& setup);

/// @param setup  device, rate and delay; the tissue is that of the scene
/// @return the edge of the scene's stiffness maps with the largest swing over both grips, see study::mapEdges; empty
/// if no map can destabilise the contact
[[nodiscard]] std::optional<MapEdge> worstMapEdge(const haptics::HapticScene& scene, const Setup& setup);

/// Change of the force by the controller while a hand presses and slides over the shape at 100 mm/s.
struct Cost
{
    double mean_percent = 0.0; ///< of the force
    double p99_percent = 0.0;
};
[[nodiscard]] Cost controllerCost(const Shape& shape, double stiffness_N_per_mm, const Setup& setup);

/// Results of one shape with one device.
struct Row
{
    std::string device, shape;
    double stated_N_per_mm = 0.0;  ///< largest stiffness stated by the manufacturer
    double without_N_per_mm = 0.0; ///< largest stable stiffness without the controller
    double with_N_per_mm = 0.0;    ///< largest stable stiffness with the controller
    double restless_mm = 0.0;      ///< with the controller, at the stated stiffness
    Cost cost;                     ///< at the stated stiffness
    Cost costSoft;                 ///< at 0.3 N/mm (soft tissue), or at the stated stiffness if lower
    [[nodiscard]] bool isHeld() const { return restless_mm < kLimitCycle_mm; }
};

/// Largest stable stiffness on the wall as a function of one quantity.
struct SweepPoint
{
    double x = 0.0;
    double without_N_per_mm = 0.0;
    double with_N_per_mm = 0.0;
    double passive_N_per_mm = 0.0; ///< 2 (b - |B|) / T
    double held_N_per_mm = 0.0;    ///< limit in the user interface, servo::heldStiffness_N_per_mm
};
/// Series of points for one device; `what` and `unit` describe x.
struct Sweep
{
    std::string device, what, unit;
    std::vector<SweepPoint> points;
};

/// Results of `measure`.
struct Result
{
    std::string subject; ///< "standard shapes" or the scene
    double rate_Hz = 1000.0;
    int delayTicks = 1;
    std::vector<Row> rows;
    std::vector<Sweep> sweeps;
    double duration_s = 0.0;
};

/// Devices and control loop to measure.
struct Options
{
    std::vector<device::DevicePreset> presets; ///< devices to measure
    double rate_Hz = 1000.0;
    int delayTicks = 1;
    bool hasSweeps = true;
    /// Progress callback: fraction done (0 to 1) and current activity. May be empty.
    std::function<void(double share, const std::string& what)> progress;
};
/// Measures all shapes with all devices: about half a minute of one core per device for the standard shapes.
[[nodiscard]] Result measure(const std::string& subject, const std::vector<Shape>& shapes, const Options& options);

/// @return one line per device of `options` and structure whose stiffness maps can sustain an oscillation: structure,
/// device, place, jump and swing. See study::mapEdges.
[[nodiscard]] std::vector<std::string> mapWarnings(const haptics::HapticScene& scene, const Options& options);

/// Writes `stability.html` (self-contained) and `stability.csv` to a folder. Files are replaced atomically.
[[nodiscard]] core::Status writeReport(const std::filesystem::path& folder, const Result& result);
/// @return paths of the files written by writeReport
[[nodiscard]] std::vector<std::filesystem::path> reportFiles(const std::filesystem::path& folder);
/// Content of the individual files.
[[nodiscard]] std::string html(const Result& result);
[[nodiscard]] std::string csv(const Result& result);

} // namespace palpate::evaluation::stability
