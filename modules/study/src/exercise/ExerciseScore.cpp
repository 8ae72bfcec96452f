// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/ExerciseScore.h"

#include <palpate/core/Text.h>
#include <palpate/session/Findings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace palpate::study {

using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;

TargetBall ballAround(const geometry::TriangleMesh& mesh)
{
    TargetBall ball;
    double area = 0.0;
    for (const geometry::Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const double weight = (b - a).cross(c - a).norm();
        ball.centre_W += weight / 3.0 * (a + b + c);
        area += weight;
    }
    ball.centre_W /= area;
    for (const geometry::Triangle& t : mesh.triangles) {
        for (const std::uint32_t corner : t) {
            ball.radius_mm = std::max(ball.radius_mm, (mesh.vertices[corner] - ball.centre_W).norm());
        }
    }
    return ball;
}

std::size_t ExerciseScore::found() const noexcept
{
    return static_cast<std::size_t>(
        std::count_if(targets.begin(), targets.end(), [](const ScoredTarget& one) { return one.found_s.has_value(); }));
}

std::size_t ExerciseScore::count(FindingVerdict verdict) const noexcept
{
    return static_cast<std::size_t>(std::count_if(
        findings.begin(), findings.end(), [verdict](const ScoredFinding& one) { return one.verdict == verdict; }));
}

std::optional<double> ExerciseScore::coverage() const noexcept
{
    return searched_mm2 > 0.0 ? std::optional(covered_mm2 / searched_mm2) : std::nullopt;
}

const char* nameOf(FindingVerdict verdict) noexcept
{
    constexpr std::array kNames{"found", "again", "false alarm", "late", "not counted"};
    return kNames[static_cast<std::size_t>(verdict)];
}

std::vector<ScoredFinding> matchFindings(const std::vector<std::pair<double, core::Finding>>& findings,
                                         std::vector<ScoredTarget>& targets, double within_mm,
                                         std::optional<double> time_s)
{
    std::vector<ScoredFinding> out;
    for (const auto& [marked_s, finding] : findings) {
        if (!finding.hasPlace) {
            continue;
        }
        ScoredFinding& scored = out.emplace_back(ScoredFinding{finding, marked_s, FindingVerdict::FalseAlarm, {}});
        if (finding.type == core::FindingType::Landmark || finding.type == core::FindingType::KeepAway) {
            scored.verdict = FindingVerdict::NotCounted;
            continue;
        }
        if (time_s && marked_s > *time_s) {
            scored.verdict = FindingVerdict::Late;
            continue;
        }
        std::pair<bool, double> best{};
        for (std::size_t i = 0; i < targets.size(); ++i) {
            const double distance_mm = (finding.p_W - targets[i].ball.centre_W).norm() - targets[i].ball.radius_mm;
            const std::pair rank(targets[i].found_s.has_value(), distance_mm);
            if (distance_mm <= within_mm && (!scored.target || rank < best)) {
                best = rank;
                scored.target = i;
            }
        }
        if (scored.target && best.first) {
            scored.verdict = FindingVerdict::Again;
        } else if (scored.target) {
            scored.verdict = FindingVerdict::Found;
            targets[*scored.target].found_s = marked_s;
            targets[*scored.target].distance_mm = best.second;
        }
    }
    return out;
}

namespace {

/// Finds the surface of a target under the hash in the recording.
Result<TargetBall> recordedBall(const session::RecordingReader& reader, const session::MeshesByHash& meshes,
                                const std::string& name)
{
    for (const session::SceneRecord& scene : reader.scenes()) {
        for (const session::StructureRecord& structure : scene.structures) {
            if (structure.name != name) {
                continue;
            }
            const auto mesh = meshes.find(structure.source.sha256);
            if (mesh == meshes.end() || mesh->second->mesh.triangles.empty()) {
                return Status(StatusCode::NotFound,
                              PALPATE_TEXT("target %1: its surface is missing or another one now; say where the scene "
                                           "is with --scene"),
                              core::inQuotes(name));
            }
            return ballAround(mesh->second->mesh);
        }
    }
    return Status(StatusCode::NotFound,
                  PALPATE_TEXT("target %1: found no structure of that name in the recording, expected the scene that "
                               "it was made on"),
                  core::inQuotes(name));
}

std::int64_t lastTickOf(const session::RecordingReader& reader, std::optional<double> time_s)
{
    const std::int64_t most = reader.extent().lastTick;
    if (!time_s) {
        return most;
    }
    const double ticks = std::round(*time_s / reader.info().dt_s);
    return ticks < static_cast<double>(most - reader.extent().firstTick)
               ? reader.extent().firstTick + static_cast<std::int64_t>(ticks) - 1
               : most;
}

Result<ForceAbove> forceAbove(const session::RecordingReader& reader, std::int64_t last, double ceiling_N)
{
    ForceAbove out;
    const double dt_s = reader.info().dt_s;
    const Status status = reader.forEach(reader.extent().firstTick, last, [&](const servo::TickRecord& tick) {
        const double above_N = tick.felt.f_W.norm() - ceiling_N;
        if (above_N > 0.0) {
            out.time_s += dt_s;
            out.impulse_Ns += above_N * dt_s;
        }
        return true;
    });
    return status.isOk() ? Result<ForceAbove>(out) : Result<ForceAbove>(status);
}

} // namespace

Result<ExerciseScore> scoreExercise(const session::RecordingReader& reader, const session::MeshesByHash& meshes,
                                    const meshio::Exercise& exercise, const ExerciseOptions& options)
{
    ExerciseScore out;
    out.exercise = exercise;
    out.within_mm = options.within_mm;
    out.coverageDistance_mm = options.coverageDistance_mm;
    for (const std::string& name : exercise.targets) {
        const auto ball = recordedBall(reader, meshes, name);
        if (!ball.isOk()) {
            return ball.status();
        }
        out.targets.push_back({name, ball.value(), {}, {}});
    }
    std::vector<std::pair<double, core::Finding>> findings;
    for (auto& [tick, finding] : session::findingsOf(reader.events())) {
        findings.emplace_back(static_cast<double>(tick - reader.extent().firstTick) * reader.info().dt_s, finding);
    }
    out.findings = matchFindings(findings, out.targets, options.within_mm, exercise.time_s);

    const std::int64_t last = lastTickOf(reader, exercise.time_s);
    session::MeasureOptions how;
    how.distance_mm = options.coverageDistance_mm;
    how.lastTick = last;
    const auto measures = session::measureSession(reader, meshes, how);
    if (!measures.isOk()) {
        return measures.status();
    }
    const session::SessionMeasures& m = measures.value();
    out.duration_s = m.sums.duration_s;
    out.peakForce_N = m.sums.contact.peakForce_N;
    out.lostTicks = m.lostTicks;
    out.unmeasured = m.unmeasured;
    out.damaged = m.damaged;
    for (const session::SurfaceMeasures& surface : m.surfaces) {
        if (std::find(exercise.targets.begin(), exercise.targets.end(), surface.structure) == exercise.targets.end()) {
            out.searched_mm2 += surface.area_mm2;
            out.covered_mm2 += surface.coveredArea_mm2;
        }
    }
    if (exercise.force_ceiling_N) {
        const auto above = forceAbove(reader, last, *exercise.force_ceiling_N);
        if (!above.isOk()) {
            return above.status();
        }
        out.above = above.value();
    }
    return out;
}

} // namespace palpate::study
