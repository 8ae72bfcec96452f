// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/Staircase.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace palpate::geometry {

namespace {

constexpr std::size_t kMostSamples = 8'000;  ///< maximum number of examined triangles
constexpr std::size_t kMostTrials = 1'000;   ///< subset of the samples used to evaluate each candidate grid
constexpr double kCosine = 0.99985;          ///< of 1°, maximum angle between normals of the same direction
constexpr double kSine = 0.01745;            ///< of 1°, tolerance of perpendicularity
constexpr double kLeastShare = 0.5;          ///< minimum fraction of the area: between 10 % (anatomy) and 100 % (masks)
constexpr double kPitchTolerance = 0.05;     ///< fraction of the pitch: above the rounding of files with two decimals
constexpr double kMinInnerShareCubes = 0.15; ///< minimum fraction of the area in steps; the mask of a box has 7 %
/// As above, without bevels; an angle bracket divided into squares has 20 %.
constexpr double kMinInnerShareFaces = 0.33;

/// Geometric properties of a triangle.
struct Facet
{
    std::array<Vec3, 3> edges;
    Vec3 normal, middle;
    double area = 0.0;
};

std::vector<Facet> sampleFacets(const TriangleMesh& mesh)
{
    const std::size_t triangles = mesh.triangles.size(), count = std::min(triangles, kMostSamples);
    std::vector<Facet> facets;
    facets.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Triangle& t = mesh.triangles[i * triangles / count];
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const Vec3 cross = (b - a).cross(c - a);
        const double twice = cross.norm();
        if (twice > 0.0) {
            facets.push_back({{b - a, c - b, a - c}, cross / twice, (a + b + c) / 3.0, 0.5 * twice});
        }
    }
    return facets;
}

/// Cluster of similar normals.
struct Direction
{
    Vec3 sum = Vec3::Zero(); ///< area-weighted sum of the normals
    double area = 0.0;
};

/// Index of the 0.9° cell that contains a normal; cells within 1° of each other are merged later.
std::uint32_t cellOf(const Vec3& normal)
{
    constexpr double kCells = 64.0;
    std::uint32_t number = 0;
    for (Eigen::Index k = 0; k < 3; ++k) {
        number = number * 256 + static_cast<std::uint32_t>(128 + std::lround(kCells * normal[k]));
    }
    return number;
}

/// @return up to Staircase::kDirections directions with the largest area, in descending order
std::vector<Direction> mainDirections(const std::vector<Facet>& facets)
{
    std::vector<std::pair<std::uint32_t, std::size_t>> byCell;
    for (std::size_t i = 0; i < facets.size(); ++i) {
        byCell.emplace_back(cellOf(facets[i].normal), i);
    }
    std::sort(byCell.begin(), byCell.end());
    std::vector<Direction> left;
    for (std::size_t i = 0; i < byCell.size(); ++i) {
        if (i == 0 || byCell[i].first != byCell[i - 1].first) {
            left.emplace_back();
        }
        const Facet& facet = facets[byCell[i].second];
        left.back().sum += facet.area * facet.normal;
        left.back().area += facet.area;
    }
    for (Direction& cell : left) {
        cell.sum.normalize();
    }
    std::stable_sort(left.begin(), left.end(), [](const Direction& a, const Direction& b) { return a.area > b.area; });
    std::vector<Direction> found;
    while (!left.empty() && found.size() < static_cast<std::size_t>(Staircase::kDirections)) {
        Direction one;
        const Vec3 peak = left.front().sum;
        const auto isNear = [&peak](const Direction& other) { return peak.dot(other.sum) >= kCosine; };
        for (const Direction& other : left) {
            if (isNear(other)) {
                one.sum += other.area * other.sum;
                one.area += other.area;
            }
        }
        std::erase_if(left, isNear);
        one.sum.normalize();
        found.push_back(one);
    }
    return found;
}

/// Spacing of the triangle corners along an axis.
struct Pitch
{
    double step_mm = 0.0; ///< half a voxel for marching cubes, a voxel for voxel faces; 0: no match
    bool isHalf = false;  ///< corner distances may span two steps

    /// @return number of steps, 0 to 2; -1 if the distance is not a multiple
    [[nodiscard]] int stepsIn(double distance_mm) const
    {
        const double steps = distance_mm / step_mm;
        const double nearest = std::round(steps);
        return nearest <= 2.0 && std::abs(steps - nearest) <= kPitchTolerance ? static_cast<int>(nearest) : -1;
    }
    [[nodiscard]] double voxel_mm() const { return isHalf ? 2.0 * step_mm : step_mm; }
};

/// @return the pitch with its step averaged over all matching distances, because files contain rounded coordinates
Pitch refined(Pitch pitch, const std::vector<double>& distances)
{
    double sum = 0.0, steps = 0.0;
    for (const double distance : distances) {
        if (const int found = pitch.stepsIn(distance); found > 0) {
            sum += distance;
            steps += found;
        }
    }
    pitch.step_mm = steps > 0.0 ? sum / steps : pitch.step_mm;
    return pitch;
}

/// Finds the step that matches most corner distances along an axis.
Pitch pitchAlong(const std::vector<Facet>& facets, std::size_t count, const Vec3& axis)
{
    std::vector<double> distances;
    distances.reserve(3 * count);
    for (std::size_t i = 0; i < count; ++i) {
        for (const Vec3& edge : facets[i * facets.size() / count].edges) {
            distances.push_back(std::abs(edge.dot(axis)));
        }
    }
    std::sort(distances.begin(), distances.end());
    constexpr double kNothing = 0.01; // relative to the largest distance: smaller values count as rounding errors
    const auto first = std::lower_bound(distances.begin(), distances.end(), kNothing * distances.back());
    Pitch best;
    std::size_t most = 0;
    constexpr std::ptrdiff_t kCandidates = 20;
    const std::ptrdiff_t apart = distances.end() - first;
    for (std::ptrdiff_t c = 0; c < kCandidates && apart > 0; ++c) {
        Pitch candidate{*(first + (2 * c + 1) * apart / (2 * kCandidates)), false};
        std::array<std::size_t, 3> found{};
        for (const double distance : distances) {
            if (const int steps = candidate.stepsIn(distance); steps >= 0) {
                ++found[static_cast<std::size_t>(steps)];
            }
        }
        const std::size_t sum = found[0] + found[1] + found[2];
        if (sum > most) {
            most = sum;
            candidate.isHalf = 100 * found[2] > sum;
            best = candidate;
        }
    }
    return refined(best, distances);
}

/// Three perpendicular axes with their pitches.
struct Grid
{
    std::array<Vec3, 3> axes;
    std::array<Pitch, 3> pitches;
    double share = 0.0; ///< fraction of the area that matches
};

/// @param count  number of evenly spread facets to examine
Grid gridAlong(const std::vector<Facet>& facets, std::size_t count, const std::array<Vec3, 3>& axes)
{
    Grid grid{axes, {}, 0.0};
    for (std::size_t k = 0; k < 3; ++k) {
        grid.pitches[k] = pitchAlong(facets, count, axes[k]);
        if (!(grid.pitches[k].step_mm > 0.0)) {
            return grid;
        }
    }
    double all = 0.0, fitting = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const Facet& facet = facets[i * facets.size() / count];
        const bool fits = std::all_of(facet.edges.begin(), facet.edges.end(), [&grid](const Vec3& edge) {
            bool isOn = true;
            for (std::size_t k = 0; k < 3 && isOn; ++k) {
                const int steps = grid.pitches[k].stepsIn(std::abs(edge.dot(grid.axes[k])));
                isOn = steps >= 0 && steps <= (grid.pitches[k].isHalf ? 2 : 1);
            }
            return isOn;
        });
        all += facet.area;
        fitting += fits ? facet.area : 0.0;
    }
    grid.share = all > 0.0 ? fitting / all : 0.0;
    return grid;
}

/// @return the perpendicular axes with the largest matching area; a share of 0 if there are no such axes
Grid bestGrid(const std::vector<Facet>& facets, const std::vector<Direction>& directions)
{
    std::vector<Vec3> lines; // opposite directions count as the same line
    for (const Direction& one : directions) {
        if (std::none_of(lines.begin(), lines.end(),
                         [&one](const Vec3& line) { return std::abs(line.dot(one.sum)) >= kCosine; })) {
            lines.push_back(one.sum);
        }
    }
    const auto arePerpendicular = [&lines](std::size_t i, std::size_t j) {
        return std::abs(lines[i].dot(lines[j])) <= kSine;
    };
    const std::size_t trials = std::min(facets.size(), kMostTrials);
    Grid best;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (std::size_t j = i + 1; j < lines.size(); ++j) {
            for (std::size_t k = j + 1; arePerpendicular(i, j) && k < lines.size(); ++k) {
                if (!arePerpendicular(i, k) || !arePerpendicular(j, k)) {
                    continue;
                }
                const Grid grid = gridAlong(facets, trials, {lines[i], lines[j], lines[k]});
                if (grid.share > best.share) {
                    best = grid;
                }
            }
        }
    }
    return best.share > 0.0 ? gridAlong(facets, facets.size(), best.axes) : best;
}

/// Flat outer sides of the whole surface are not steps, however finely tessellated.
/// @return fraction of the area outside the outermost planes perpendicular to the axes
double innerShare(const std::vector<Facet>& facets, const Grid& grid)
{
    double all = 0.0, outer = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        std::map<long long, double> areas; // by level
        for (const Facet& facet : facets) {
            if (std::abs(facet.normal.dot(grid.axes[k])) >= kCosine) {
                areas[std::llround(facet.middle.dot(grid.axes[k]) / grid.pitches[k].step_mm)] += facet.area;
            }
            all += facet.area / 3.0;
        }
        if (!areas.empty()) {
            outer += areas.begin()->second + (areas.size() > 1 ? areas.rbegin()->second : 0.0);
        }
    }
    return all > 0.0 ? 1.0 - outer / all : 0.0;
}

/// Marching cubes bevels every edge of a mask; voxel faces and CAD parts do not have such facets.
bool hasBevels(const std::vector<Facet>& facets, const Grid& grid)
{
    double all = 0.0, oblique = 0.0;
    for (const Facet& facet : facets) {
        const bool isAlong = std::any_of(grid.axes.begin(), grid.axes.end(), [&facet](const Vec3& axis) {
            return std::abs(facet.normal.dot(axis)) >= kCosine;
        });
        all += facet.area;
        oblique += isAlong ? 0.0 : facet.area;
    }
    return oblique > 0.01 * all &&
           std::all_of(grid.pitches.begin(), grid.pitches.end(), [](const Pitch& pitch) { return pitch.isHalf; });
}

bool hasSteps(const std::vector<Facet>& facets, const Grid& grid)
{
    return innerShare(facets, grid) >= (hasBevels(facets, grid) ? kMinInnerShareCubes : kMinInnerShareFaces);
}

/// Sorts and flips the axes to match the world axes: the first is nearest to x, and so on.
void setAxes(const Grid& grid, Staircase& out)
{
    std::array<std::size_t, 3> order{0, 1, 2}, best = order;
    double most = -1.0;
    do {
        double sum = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            sum += std::abs(grid.axes[order[k]][static_cast<Eigen::Index>(k)]);
        }
        if (sum > most) {
            most = sum;
            best = order;
        }
    } while (std::next_permutation(order.begin(), order.end()));
    for (Eigen::Index k = 0; k < 3; ++k) {
        const std::size_t from = best[static_cast<std::size_t>(k)];
        const Vec3& axis = grid.axes[from];
        out.axes.col(k) = axis[k] < 0.0 ? Vec3(-axis) : axis;
        out.voxel_mm[k] = grid.pitches[from].voxel_mm();
    }
}

} // namespace

std::optional<Staircase> findStaircase(const TriangleMesh& mesh)
{
    const std::vector<Facet> facets = sampleFacets(mesh);
    if (facets.size() <= static_cast<std::size_t>(Staircase::kDirections)) {
        return std::nullopt; // a few triangles always have few directions
    }
    const std::vector<Direction> directions = mainDirections(facets);
    const auto add = [](double sum, const auto& one) { return sum + one.area; };
    const double area = std::accumulate(facets.begin(), facets.end(), 0.0, add);
    const double inDirections = std::accumulate(directions.begin(), directions.end(), 0.0, add);
    if (!(inDirections >= kLeastShare * area) || !(area > 0.0)) {
        return std::nullopt;
    }
    const Grid grid = bestGrid(facets, directions);
    if (!(grid.share >= kLeastShare) || !hasSteps(facets, grid)) {
        return std::nullopt;
    }
    Staircase out;
    out.areaShare = std::min(1.0, inDirections / area);
    setAxes(grid, out);
    return out;
}

core::Message Staircase::sentence() const
{
    if (isStated) {
        return {PALPATE_TEXT("surface from a label map of %1 × %2 × %3 mm voxels, with its steps"),
                core::Rounded{voxel_mm.x(), 3}, core::Rounded{voxel_mm.y(), 3}, core::Rounded{voxel_mm.z(), 3}};
    }
    return {PALPATE_TEXT("staircase of about %1 × %2 × %3 mm voxels (%4 % of the area in %5 directions)"),
            core::Rounded{voxel_mm.x(), 3},
            core::Rounded{voxel_mm.y(), 3},
            core::Rounded{voxel_mm.z(), 3},
            std::lround(100.0 * areaShare),
            kDirections};
}

} // namespace palpate::geometry
