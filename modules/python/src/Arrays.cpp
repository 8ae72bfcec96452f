// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

namespace palpate::python {

namespace {

constexpr int kPlain =
    py::array::c_style | py::array::forcecast | py::detail::npy_api::NPY_ARRAY_ALIGNED_; // can be read as a C array
using Doubles = py::array_t<double, kPlain>;
using Integers = py::array_t<std::int64_t, kPlain>;

/// @param kinds  accepted numpy.dtype.kind
py::array arrayOf(const py::handle& object, const char* what, std::string_view kinds, const char* expected)
{
    auto array = py::array::ensure(object);
    if (!array) {
        PyErr_Clear();
        throw py::type_error(std::string(what) + ": found " + std::string(Py_TYPE(object.ptr())->tp_name) +
                             ", expected an array of " + expected);
    }
    const bool isEmptyList = array.size() == 0 && !py::isinstance<py::array>(object); // has no number type of its own
    if (!isEmptyList && kinds.find(array.dtype().kind()) == std::string_view::npos) {
        throw py::type_error(std::string(what) + ": found numbers of type " +
                             py::str(array.dtype()).cast<std::string>() + ", expected " + expected);
    }
    return array;
}

/// Converts number type, byte order and memory order. Copies only if they differ.
template<class Target>
Target converted(const py::array& array)
{
    auto out = Target::ensure(array);
    if (!out) {
        throw py::error_already_set();
    }
    return out;
}

std::string shapeText(const py::array& array)
{
    std::string text = "(";
    for (py::ssize_t i = 0; i < array.ndim(); ++i) {
        text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
    }
    return text + (array.ndim() == 1 ? ",)" : ")");
}

void checkRowsOfThree(const py::array& array, const char* what)
{
    if (array.ndim() != 2 || array.shape(1) != 3) {
        throw py::value_error(std::string(what) + ": found an array of shape " + shapeText(array) +
                              ", expected (n, 3)");
    }
}

std::string placeText(const char* what, std::size_t row, std::size_t column)
{
    return std::string(what) + "[" + std::to_string(row) + ", " + std::to_string(column) + "]";
}

[[noreturn]] void throwNotFinite(const std::string& place, double value)
{
    throw py::value_error(place + ": found " +
                          (std::isnan(value) ? "nan"
                           : value > 0       ? "inf"
                                             : "-inf") +
                          ", expected a finite number");
}

constexpr const char* kNumbers = "real numbers";

} // namespace

std::vector<core::Vec3> pointsFrom(const py::object& array, const char* what)
{
    const py::array any = arrayOf(array, what, "fiu", kNumbers);
    checkRowsOfThree(any, what);
    const auto rows = converted<Doubles>(any);
    std::vector<core::Vec3> points(static_cast<std::size_t>(rows.shape(0)));
    static_assert(sizeof(core::Vec3) == 3 * sizeof(double));
    if (!points.empty()) {
        std::memcpy(static_cast<void*>(points.data()), rows.data(), points.size() * sizeof(core::Vec3));
    }
    return points;
}

Path::Path(const py::object& array, const char* what)
{
    const py::array any = arrayOf(array, what, "fiu", kNumbers);
    checkRowsOfThree(any, what);
    const auto rows = converted<Doubles>(any);
    m_array = rows;
    static_assert(sizeof(core::Vec3) == 3 * sizeof(double) && alignof(core::Vec3) == alignof(double));
    m_points = {reinterpret_cast<const core::Vec3*>(rows.data()), static_cast<std::size_t>(rows.shape(0))};
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            if (!std::isfinite(m_points[i][axis])) {
                throwNotFinite(placeText(what, i, static_cast<std::size_t>(axis)), m_points[i][axis]);
            }
        }
    }
}

std::vector<geometry::Triangle> trianglesFrom(const py::object& array, const char* what)
{
    const py::array any = arrayOf(array, what, "iu", "whole numbers");
    checkRowsOfThree(any, what);
    const auto rows = converted<Integers>(any); // numbers above 2^63 become negative
    std::vector<geometry::Triangle> triangles(static_cast<std::size_t>(rows.shape(0)));
    const std::int64_t* from = rows.data();
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t corner = 0; corner < 3; ++corner, ++from) {
            if (*from < 0 || *from > std::numeric_limits<std::uint32_t>::max()) {
                throw py::value_error(placeText(what, i, corner) + ": found " + std::to_string(*from) +
                                      ", expected the number of a point");
            }
            triangles[i][corner] = static_cast<std::uint32_t>(*from);
        }
    }
    return triangles;
}

core::Vec3 pointFrom(const py::handle& point, const char* what)
{
    const auto array = converted<Doubles>(arrayOf(point, what, "fiu", kNumbers));
    if (array.ndim() != 1 || array.shape(0) != 3) {
        throw py::value_error(std::string(what) + ": found an array of shape " + shapeText(array) + ", expected (3,)");
    }
    const core::Vec3 p(array.data()[0], array.data()[1], array.data()[2]);
    for (int axis = 0; axis < 3; ++axis) {
        if (!std::isfinite(p[axis])) {
            throwNotFinite(std::string(what) + "[" + std::to_string(axis) + "]", p[axis]);
        }
    }
    return p;
}

py::array toPython(const core::Vec3& v)
{
    return py::array_t<double>(3, v.data());
}

py::array viewOf(const std::vector<core::Vec3>& points, const py::object& owner)
{
    return viewOf(points.empty() ? nullptr : points.front().data(), {static_cast<py::ssize_t>(points.size()), 3},
                  owner);
}

py::array viewOf(const std::vector<geometry::Triangle>& triangles, const py::object& owner)
{
    return viewOf(triangles.empty() ? nullptr : triangles.front().data(),
                  {static_cast<py::ssize_t>(triangles.size()), 3}, owner);
}

} // namespace palpate::python
