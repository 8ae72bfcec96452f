// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

#include <vector>

/// Meshes made by formula, for hard cases and for evaluating without a file. [mm]
namespace palpate::evaluation::shapes {

using core::Vec3;
using geometry::TriangleMesh;

/// Closed box, each face n × n squares of two triangles, normals outwards.
[[nodiscard]] TriangleMesh box(const Vec3& low, const Vec3& high, int n = 1);
/// Sphere of 20 n² triangles around the origin, its radius scaled by 1 + bump sin(20x) sin(20y) sin(20z) of the unit
/// direction: hills and hollows.
[[nodiscard]] TriangleMesh bumpySphere(int n, double radius_mm, double bump);
/// Closed prism along y from -halfLength to halfLength. @param profile  x, z counter-clockwise seen from -y; the first
/// corner sees all others, which the caps are fanned from
[[nodiscard]] TriangleMesh prism(const std::vector<Eigen::Vector2d>& profile, double halfLength_mm, int ny = 1);
/// Block with a V-groove along y: its walls meet at the origin at the given angle and rise to z = height.
[[nodiscard]] TriangleMesh groove(double opening_rad, double height_mm = 20.0, double halfLength_mm = 30.0);
/// Block whose top is two planes that meet along y at the origin, `angle` apart: a ridge, or a valley when negative.
[[nodiscard]] TriangleMesh crease(double angle_rad, double halfWidth_mm = 20.0);
/// Block with a fan of n facets on top, apex at (0, 0, height) over a rim of the given radius at z = 0: a cone, or a
/// pit when the height is negative.
[[nodiscard]] TriangleMesh fan(int n, double height_mm, double radius_mm = 10.0);
/// Closed plate with its top at z = 0, cut along the given coordinates: close ones make slivers.
[[nodiscard]] TriangleMesh plate(const std::vector<double>& xs, const std::vector<double>& ys, double thickness_mm);
/// Open square sheet in z = 0, normal +z, n × n squares.
[[nodiscard]] TriangleMesh sheet(double halfSize_mm, int n = 1);

void append(TriangleMesh& mesh, const TriangleMesh& other);
/// Each triangle with three corners of its own.
[[nodiscard]] TriangleMesh soup(const TriangleMesh& mesh);

} // namespace palpate::evaluation::shapes
