// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"
#include "Bindings.h"
#include "Errors.h"
#include "LongCall.h"
#include "Surface.h"

#include <palpate/geometry/MeshReport.h>
#include <palpate/study/HapticCopy.h>

#include <cstdint>
#include <string>

namespace palpate::python {

std::shared_ptr<const geometry::SurfaceIndex> Surface::index()
{
    const std::lock_guard lock(m_mutex);
    if (m_index == nullptr) {
        m_index = study::indexed(*m_mesh);
    }
    return m_index;
}

namespace {

std::shared_ptr<Surface> surfaceFrom(const py::object& points, const py::object& triangles, double weldWithin_mm,
                                     const std::string& facing)
{
    geometry::RepairOptions options;
    options.weldWithin_mm = weldWithin_mm;
    if (facing == "as given") {
        options.facing = geometry::Facing::AsGiven;
    } else if (facing != "outward") {
        throw py::value_error("facing: found \"" + facing + "\", expected \"outward\" or \"as given\"");
    }
    geometry::TriangleMesh mesh;
    mesh.vertices = pointsFrom(points, "points");
    mesh.triangles = trianglesFrom(triangles, "triangles");
    auto repaired = longCall([&](const std::atomic<bool>&) { return geometry::surfaceOf(mesh, options); });
    return std::make_shared<Surface>(std::make_shared<const geometry::RepairedMesh>(valueOf(std::move(repaired))));
}

const geometry::RepairedMesh& meshOf(const py::object& self)
{
    return *self.cast<const Surface&>().mesh();
}

std::string surfaceText(const Surface& self)
{
    return "<palpate.Surface of " + std::to_string(self.mesh()->mesh.triangles.size()) + " triangles, " +
           (self.mesh()->report.isClosed() ? "closed>" : "open>");
}

} // namespace

void bindSurface(py::module_& module)
{
    using py::arg;
    py::class_<Surface, std::shared_ptr<Surface>>(
        module, "Surface",
        "Triangle mesh, checked and repaired for touch. Immutable; any number "
        "of scenes can share a surface.")
        .def(py::init(&surfaceFrom), arg("points"), arg("triangles"), py::kw_only(), arg("weld_within_mm") = 0.0,
             arg("facing") = "outward",
             "Make a surface.\n\n"
             "points: (n, 3) array of real numbers [mm], LPS. triangles: (m, 3) array of whole numbers, each the\n"
             "number of a point, counter-clockwise seen from outside. Both are copied.\n"
             "weld_within_mm: points nearer than this become one; 0: equal points only.\n"
             "facing: \"outward\" turns closed parts that are inside out, \"as given\" leaves them, as for files.\n"
             "Equal points are welded, and triangles without area and duplicates removed: see `notes`.")
        .def_property_readonly(
            "points", [](const py::object& self) { return viewOf(meshOf(self).mesh.vertices, self); },
            "(n, 3) float64 [mm], after the repair. Read-only view without a copy; keeps the surface alive.")
        .def_property_readonly(
            "triangles", [](const py::object& self) { return viewOf(meshOf(self).mesh.triangles, self); },
            "(m, 3) uint32, after the repair. Read-only view without a copy.")
        .def_property_readonly(
            "triangle_source", [](const py::object& self) { return viewOf(meshOf(self).source, self); },
            "(m,) uint32: number of each triangle in the input. Read-only view without a copy.")
        .def_property_readonly(
            "point_source", [](const py::object& self) { return viewOf(meshOf(self).vertexSource, self); },
            "(n,) uint32: number of each point in the input, the lowest of welded ones; 0xffffffff: added by a\n"
            "subdivision. Empty for the surfaces of recordings. Read-only view without a copy.")
        .def_property_readonly(
            "two_sided", [](const py::object& self) { return viewOf(meshOf(self).twoSided, self); },
            "(m,) uint8: 1 for the triangles of open parts, which are touched from both sides. Read-only view.")
        .def_property_readonly(
            "is_closed", [](const Surface& self) { return self.mesh()->report.isClosed(); },
            "True if all parts are closed and oriented: touched from outside only.")
        .def_property_readonly(
            "area_mm2", [](const Surface& self) { return self.mesh()->report.area_mm2; }, "Area [mm2].")
        .def_property_readonly(
            "volume_mm3", [](const Surface& self) { return self.mesh()->report.volume_mm3; },
            "Volume of the closed parts [mm3], negative if they are inside out.")
        .def_property_readonly(
            "notes", [](const Surface& self) { return toPython(self.mesh()->report.sentences()); },
            "Repairs and defects, one sentence each; empty for a clean mesh.")
        .def("__repr__", &surfaceText);
}

} // namespace palpate::python
