// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/SurfaceIndex.h>

#include <functional>
#include <memory>

namespace palpate::test {

using core::Vec3;
using geometry::TriangleMesh;

/// Returns a sphere around the origin: each face of an icosahedron is split into n^2 triangles, 20 n^2 in total [mm].
TriangleMesh sphere(int n, double radius_mm);
/// Returns a sphere with its radius scaled by 1 + bump sin(20x) sin(20y) sin(20z) of the unit direction: hills and
/// hollows.
TriangleMesh bumpySphere(int n, double radius_mm, double bump);
/// Returns a closed box, each face split into n × n squares of two triangles, normals outwards [mm].
TriangleMesh box(const Vec3& low, const Vec3& high, int n = 1);
/// Returns a block with a V-groove along y whose walls meet at the origin with the given opening angle and rise to z =
/// height.
TriangleMesh groove(double openingAngle_rad, double height_mm = 20.0, double halfLength_mm = 30.0);
/// Returns an open square sheet in z = 0 around the origin, normal +z, n × n squares.
TriangleMesh sheet(double halfSize_mm, int n = 1);

void append(TriangleMesh& mesh, const TriangleMesh& other);
/// Returns the mesh with three separate vertices for each triangle.
TriangleMesh soup(const TriangleMesh& mesh);
TriangleMesh transformed(const TriangleMesh& mesh, const std::function<Vec3(const Vec3&)>& map);
TriangleMesh moved(const TriangleMesh& mesh, const Vec3& by);

/// Repairs and indexes a mesh.
std::shared_ptr<const geometry::SurfaceIndex> indexed(const TriangleMesh& mesh);

} // namespace palpate::test
