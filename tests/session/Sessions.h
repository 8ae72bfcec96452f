// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/HapticScene.h>
#include <palpate/servo/ServoLoop.h>
#include <palpate/servo/TickRecord.h>
#include <palpate/session/Recording.h>
#include <palpate/session/Replay.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace palpate::test {

/// Returns a box of 40 mm about the origin, called "box".
std::shared_ptr<const haptics::HapticScene> boxScene(double stiffness_N_per_mm, double damping_Ns_per_mm = 0.0);
/// Returns the surface of the box under its hash in these recordings.
session::SurfacesByHash boxSurfaces();

/// Returns the ServoCore ticks of a hand that presses, slides, releases (tick 400 to 420) and comes back, while the
/// scene gets stiffer at tick 250; deterministic.
std::vector<servo::TickRecord> palpationTicks(int ticks);
/// Returns the two scenes of palpationTicks, generations 1 and 2.
std::vector<session::SceneRecord> palpationScenes();
/// @return false, with the reason as a warning, if writing the recording failed
bool writeRecording(const std::filesystem::path& path, const std::vector<servo::TickRecord>& ticks,
                    bool isFinished = true);

/// Waits for that many further servo ticks.
/// @return false if they do not come within a minute
bool letPass(const servo::ServoLoop& loop, std::uint64_t ticks);

/// Compares all recorded data of two ticks bit for bit.
bool isSameTick(const servo::TickRecord& a, const servo::TickRecord& b);

/// Runs SQL on a file, as any other tool can.
bool runSql(const std::filesystem::path& path, const std::string& sql);

} // namespace palpate::test
