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

/// How stiff a surface may be before device, hand and sampled force oscillate, found by closing the loop in virtual
/// time: the servo's own tick (gate, god-object, tissue, passivity controller) against a simulated device held by a
/// simulated hand. Deterministic.
namespace palpate::evaluation::stability {

using core::Vec3;

/// Defined beside the judgement of maps, which the window needs, too.
using study::Grip;
using study::grips;
using study::MapEdge;

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
    double own_N_per_mm = 0.0; ///< stiffness of a scene as it is, where it is stiffest; 0: not a scene
};

/// Wall, inner corner, edge, 10 degree groove, stiffness step at a lump's border, fine sphere of 327,680 triangles, two
/// layers that share the stiffness, a wall whose map steps by 2 : 1 over 10 mm, a wall with friction.
[[nodiscard]] std::vector<Shape> standardShapes();
/// A scene as a shape: its tissues as stiff in proportion to each other as they are, scaled together; the stiffness of
/// the whole is that of the stiffest place of the stiffest one. It is held at a few triangles of each structure, and
/// where its maps say most and change most. Of a law its greatest slope counts.
[[nodiscard]] Shape shapeOf(std::string name, const haptics::HapticScene& scene);

/// Device, loop and tissue of one trial.
struct Setup
{
    device::DevicePreset preset;
    double rate_Hz = 1000.0;
    int delayTicks = 1; ///< after the tick that computed it, a force acts so many ticks late
    double tissueDamping_Ns_per_mm = 0.0;
    bool isControlled = true; ///< with the passivity controller
    double settle_s = 1.0;    ///< that the hand has to come to rest
};

/// Largest peak-to-peak motion of the tip along any axis in the half second that begins `settle_s` after the hand
/// rests, over grips, holds, and speeds of approach (30 and 200 mm/s). [mm] A hold that slips off something small and
/// rests in the air counts for nothing; infinite when all do.
[[nodiscard]] double restlessness_mm(const Shape& shape, double stiffness_N_per_mm, const Setup& setup);

/// Motion at rest from which on it counts as a limit cycle. [mm]
inline constexpr double kLimitCycle_mm = study::kLeastSwing_mm;
/// The search ends here. [N/mm]
inline constexpr double kStiffest_N_per_mm = 25.0;

/// The largest stiffness below which no limit cycle was found, to 4 %; kStiffest_N_per_mm when none at all was.
[[nodiscard]] double largestStiffness(const Shape& shape, const Setup& setup);

/// @param setup  its device, rate and delay; the tissue is the scene's own
/// @return the edge of the scene's maps with the largest swing over both grips, see study::mapEdges; nothing without a
/// map that bends that way
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

/// @return one line for each device of `options` and each structure whose maps can keep it swinging: structure, device,
/// place, jump and swing. See study::mapEdges.
[[nodiscard]] std::vector<std::string> mapWarnings(const haptics::HapticScene& scene, const Options& options);

/// `stability.html` (self-contained) and `stability.csv` in a folder, each only when whole.
[[nodiscard]] core::Status writeReport(const std::filesystem::path& folder, const Result& result);
/// @return these files
[[nodiscard]] std::vector<std::filesystem::path> reportFiles(const std::filesystem::path& folder);
[[nodiscard]] std::string html(const Result& result);
[[nodiscard]] std::string csv(const Result& result);

} // namespace palpate::evaluation::stability
