// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

#include <vector>

/// Procedural meshes for the hard cases and for evaluation without input files. [mm]
namespace palpate::evaluation::shapes {

using core::Vec3;
using geometry::TriangleMesh;

/// Closed box with n × n squares of two triangles per face and outward normals.
[[nodiscard]] TriangleMesh box(const Vec3& low, const Vec3& high, int n = 1);
/// Sphere around the origin with 20 n² triangles. The radius is multiplied by 1 + bump sin(20x) sin(20y) sin(20z) of
/// the unit direction, which makes bumps and dents.
[[nodiscard]] TriangleMesh bumpySphere(int n, double radius_mm, double bump);
/// Closed prism along y from -halfLength to halfLength. @param profile  x, z counter-clockwise seen from -y; all
/// corners must be visible from the first one, the apex of the cap's triangle fan
[[nodiscard]] TriangleMesh prism(const std::vector<Eigen::Vector2d>& profile, double halfLength_mm, int ny = 1);
/// Block with a V-groove along y; the walls meet at the origin at the given angle and rise to z = height.
[[nodiscard]] TriangleMesh groove(double opening_rad, double height_mm = 20.0, double halfLength_mm = 30.0);
/// Block whose top consists of two planes that meet along y at the origin, `angle` apart: a ridge, or a valley if
/// negative.
[[nodiscard]] TriangleMesh crease(double angle_rad, double halfWidth_mm = 20.0);
/// Block with a fan of n facets on top, apex at (0, 0, height), rim of the given radius at z = 0: a cone, or a pit for
/// a negative height.
[[nodiscard]] TriangleMesh fan(int n, double height_mm, double radius_mm = 10.0);
/// Closed plate with its top at z = 0, divided at the given coordinates; small differences produce slivers.
[[nodiscard]] TriangleMesh plate(const std::vector<double>& xs, const std::vector<double>& ys, double thickness_mm);
/// Open square sheet at z = 0, normal +z, n × n squares.
[[nodiscard]] TriangleMesh sheet(double halfSize_mm, int n = 1);

/// Appends the vertices and triangles of `other` to `mesh`.
void append(TriangleMesh& mesh, const TriangleMesh& other);
/// Copies the mesh with three separate vertices per triangle.
[[nodiscard]] TriangleMesh soup(const TriangleMesh& mesh);

} // namespace palpate::evaluation::shapes
