// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Errors.h"

#include <palpate/core/Types.h>
#include <palpate/geometry/TriangleMesh.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace palpate::python {

// Arrays that come in may have any memory order, byte order and number type. Meshes are copied, because the engine's
// containers own their memory.

/// Converts an (n, 3) array of numbers. @param what  argument name, for messages
/// @throws TypeError for another type, ValueError for another shape
[[nodiscard]] std::vector<core::Vec3> pointsFrom(const py::object& array, const char* what);

/// A path of (n, 3) finite positions: the memory of an array of aligned float64 in C order, a converted copy of others.
class Path
{
  public:
    /// @throws TypeError, ValueError as `pointsFrom`; ValueError also for NaN and infinity, with the place
    Path(const py::object& array, const char* what);
    /// Valid for the lifetime of this object.
    [[nodiscard]] std::span<const core::Vec3> points() const noexcept { return m_points; }

  private:
    py::array m_array;
    std::span<const core::Vec3> m_points;
};

/// Converts an (n, 3) array of whole numbers. @throws ValueError for a number that is no index of a vertex
[[nodiscard]] std::vector<geometry::Triangle> trianglesFrom(const py::object& array, const char* what);

/// Converts an array or a sequence of three finite numbers.
[[nodiscard]] core::Vec3 pointFrom(const py::handle& point, const char* what);

/// Returns a copy of a vector.
[[nodiscard]] py::array toPython(const core::Vec3& v);

/// Returns a read-only view of memory that `owner` keeps alive.
template<class T>
py::array viewOf(const T* data, std::vector<py::ssize_t> shape, const py::object& owner)
{
    py::array view(py::dtype::of<T>(), std::move(shape), data, owner);
    view.attr("setflags")(py::arg("write") = false);
    return view;
}

/// Returns an (n, 3) read-only view of points, or of triangles.
[[nodiscard]] py::array viewOf(const std::vector<core::Vec3>& points, const py::object& owner);
[[nodiscard]] py::array viewOf(const std::vector<geometry::Triangle>& triangles, const py::object& owner);
/// Returns an (n,) read-only view.
template<class T>
py::array viewOf(const std::vector<T>& values, const py::object& owner)
{
    return viewOf(values.data(), {static_cast<py::ssize_t>(values.size())}, owner);
}

/// Returns an owner for views of `data`.
template<class T>
py::capsule ownerOf(std::shared_ptr<T> data)
{
    auto kept = std::make_unique<std::shared_ptr<T>>(std::move(data));
    py::capsule owner(kept.get(), [](void* pointer) { delete static_cast<std::shared_ptr<T>*>(pointer); });
    (void)kept.release();
    return owner;
}

} // namespace palpate::python
