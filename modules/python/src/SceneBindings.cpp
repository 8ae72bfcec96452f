// SPDX-License-Identifier: BSD-3-Clause
#include "Bindings.h"
#include "Errors.h"
#include "LongCall.h"
#include "Scene.h"
#include "Surface.h"

#include <palpate/core/FileFrame.h>
#include <palpate/core/Tissue.h>
#include <palpate/meshio/MeshFile.h>
#include <palpate/meshio/SceneFile.h>
#include <palpate/session/Findings.h>
#include <palpate/study/BuriedLumps.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/RecordedScene.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace palpate::python {

Scene::Scene(meshio::LoadedScene loaded, double fingertip_mm, std::vector<std::shared_ptr<Surface>> surfaces)
    : m_loaded(std::make_shared<const meshio::LoadedScene>(std::move(loaded)))
    , m_surfaces(std::move(surfaces))
    , m_fingertip_mm(fingertip_mm)
{
    for (std::size_t i = m_surfaces.size(); i < m_loaded->structures.size(); ++i) {
        m_surfaces.push_back(std::make_shared<Surface>(m_loaded->structures[i].surface));
    }
}

Scene::Scene(const Scene& from, double fingertip_mm, const session::TissueOverride& tissue)
    : m_loaded(from.m_loaded)
    , m_surfaces(from.m_surfaces)
    , m_fingertip_mm(fingertip_mm)
    , m_tissue(tissue)
{
}

Structure Scene::structure(std::size_t number) const
{
    return {m_loaded->structures[number], m_surfaces[number]};
}

std::shared_ptr<const haptics::HapticScene> Scene::haptic() const
{
    const std::lock_guard lock(m_mutex);
    if (m_haptic == nullptr) {
        auto made = study::hapticScene(*m_loaded, [this](std::size_t i) { return m_surfaces[i]->index(); });
        if (study::triangleCount(*made) == 0) {
            throw py::value_error("scene: found nothing palpable, expected a structure that is");
        }
        if (m_fingertip_mm != 0.0) {
            made = std::make_shared<const haptics::HapticScene>(made->structures(), m_fingertip_mm);
        }
        if (m_tissue != session::TissueOverride()) {
            made = std::make_shared<const haptics::HapticScene>(session::withTissue(*made, m_tissue));
        }
        m_haptic = std::move(made);
    }
    return m_haptic;
}

namespace {

double fingertipFrom(double radius_mm)
{
    if (!(radius_mm >= 0.0 && radius_mm <= haptics::HapticScene::kMostFingertip_mm)) {
        throw py::value_error("radius_mm: found " + numberText(radius_mm) + ", expected 0 to " +
                              numberText(haptics::HapticScene::kMostFingertip_mm));
    }
    return radius_mm;
}

/// Keyword arguments of a structure; empty: the default, or for `replace` as before.
struct StructureOptions
{
    std::optional<std::string> name;
    std::array<std::optional<double>, core::kTissueTerms.size()> tissue;
    std::optional<std::uint32_t> layer;
    std::optional<bool> palpable;
    std::optional<std::string> inside;
    std::optional<double> young_ratio, young_kPa, contactRadius_mm;
};

std::optional<double> positive(const char* what, const std::optional<double>& value)
{
    if (value && !(*value > 0.0 && std::isfinite(*value))) {
        throw py::value_error(std::string(what) + ": found " + numberText(*value) + ", expected a number above 0");
    }
    return value;
}

void apply(const StructureOptions& options, meshio::SceneStructure& description)
{
    description.name = options.name.value_or(description.name);
    if (description.name.empty()) {
        throw py::value_error("name: found an empty text, expected a name");
    }
    for (std::size_t i = 0; i < core::kTissueTerms.size(); ++i) {
        double& own = description.tissue.*core::kTissueTerms[i].member;
        own = options.tissue[i].value_or(own);
    }
    throwUnlessOk(core::check(description.tissue).at(description.name));
    description.layer = options.layer.value_or(description.layer);
    description.palpable = options.palpable.value_or(description.palpable);
    description.inside = options.inside.value_or(description.inside);
    const auto set = [](std::optional<double>& own, const char* what, const std::optional<double>& value) {
        own = value ? positive(what, value) : own;
    };
    set(description.young_ratio, "young_ratio", options.young_ratio);
    set(description.young_kPa, "young_kPa", options.young_kPa);
    set(description.felt_contact_radius_mm, "contact_radius_mm", options.contactRadius_mm);
}

/// Adds the keyword arguments of StructureOptions to a function `call(first, options)`.
template<class First, class Call>
auto withOptions(Call call)
{
    using Number = std::optional<double>;
    using Text = std::optional<std::string>;
    return [call](First first, Text name, Number stiffness, Number damping, Number frictionStatic,
                  Number frictionDynamic, Number drag, std::optional<std::uint32_t> layer, std::optional<bool> palpable,
                  Text inside, Number youngRatio, Number young, Number contactRadius) {
        return call(first, StructureOptions{std::move(name),
                                            {stiffness, damping, frictionStatic, frictionDynamic, drag},
                                            layer,
                                            palpable,
                                            std::move(inside),
                                            youngRatio,
                                            young,
                                            contactRadius});
    };
}

Structure structureFrom(const std::shared_ptr<Surface>& surface, const StructureOptions& options)
{
    Structure out;
    out.surface = surface;
    out.loaded.surface = surface->mesh();
    out.loaded.asRead = surface->mesh();
    out.loaded.description.name = "surface";
    apply(options, out.loaded.description);
    return out;
}

Structure replaced(const Structure& self, const StructureOptions& options)
{
    Structure out = self;
    apply(options, out.loaded.description);
    return out;
}

py::dict tissueOf(const core::Tissue& tissue)
{
    py::dict out;
    for (const core::TissueTerm& term : core::kTissueTerms) {
        out[toPython(term.key)] = tissue.*term.member;
    }
    return out;
}

void checkNames(const std::vector<Structure>& structures)
{
    std::set<std::string> names;
    for (const Structure& one : structures) {
        if (!names.insert(one.loaded.description.name).second) {
            throw py::value_error("structures: found \"" + one.loaded.description.name +
                                  "\" twice, expected names that differ");
        }
    }
    for (const Structure& one : structures) {
        const std::string& inside = one.loaded.description.inside;
        if (!inside.empty() && !names.contains(inside)) {
            throw py::value_error(one.loaded.description.name + ": inside: found \"" + inside +
                                  "\", expected the name of another structure");
        }
    }
}

std::shared_ptr<Scene> sceneFrom(const std::vector<Structure>& structures, double radius_mm, const std::string& buried)
{
    const auto* const mode = std::find(meshio::kBuriedNames.begin(), meshio::kBuriedNames.end(), buried);
    if (mode == meshio::kBuriedNames.end()) {
        throw py::value_error("buried: found \"" + buried + "\", expected \"layers\" or \"felt\"");
    }
    if (structures.empty()) {
        throw py::value_error("structures: found an empty list, expected at least one palpate.Structure");
    }
    checkNames(structures);
    meshio::LoadedScene loaded;
    std::vector<std::shared_ptr<Surface>> surfaces;
    loaded.scene.buried = static_cast<meshio::BuriedTouch>(mode - meshio::kBuriedNames.begin());
    for (const Structure& one : structures) {
        loaded.scene.structures.push_back(one.loaded.description);
        loaded.structures.push_back(one.loaded);
        loaded.structures.back().feltBelow.clear(); // of the scene that the structure comes from
        loaded.structures.back().isTransmitted = false;
        surfaces.push_back(one.surface);
    }
    throwUnlessOk(longCall([&](const std::atomic<bool>& isCancelled) {
        return study::applyBuriedLumps(loaded, [&](double) { return !isCancelled; });
    }));
    return std::make_shared<Scene>(std::move(loaded), fingertipFrom(radius_mm), std::move(surfaces));
}

double unitFrom(const std::string& unit)
{
    constexpr std::array<std::pair<std::string_view, double>, 3> kUnits{{{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}}};
    for (const auto& [name, size_mm] : kUnits) {
        if (name == unit) {
            return size_mm;
        }
    }
    throw py::value_error("unit: found \"" + unit + "\", expected \"m\", \"cm\" or \"mm\"");
}

core::FileFrame frameFrom(const std::string& frame)
{
    const auto named = core::frameNamed(frame);
    if (!named && !frame.empty()) {
        throw py::value_error("frame: found \"" + frame + "\", expected \"LPS\", \"RAS\" or \"Y-up\"");
    }
    return named.value_or(core::FileFrame::Untagged);
}

std::shared_ptr<Scene> load(const std::filesystem::path& path, const std::string& unit, const std::string& frame,
                            double radius_mm, bool isPartial, bool isSmoothed, bool isCurved,
                            std::optional<double> smoothing, bool turnsOutwards, double closeHoles_mm)
{
    meshio::ReadOptions options;
    options.unit_mm = unitFrom(unit);
    options.frame = frameFrom(frame);
    options.isPartial = isPartial;
    options.isSmoothed = isSmoothed;
    options.isCurved = isCurved;
    if (smoothing && !(*smoothing >= 0.0 && *smoothing <= 1.0)) {
        throw py::value_error("smoothing: found " + numberText(*smoothing) + ", expected 0 to 1");
    }
    options.smoothing = smoothing;
    options.turnsOutwards = turnsOutwards;
    options.closeHoles_mm = closeHoles_mm == 0.0 ? 0.0 : positive("close_holes_mm", closeHoles_mm).value();
    const double fingertip_mm = fingertipFrom(radius_mm);
    auto loaded = valueOf(longCall([&](const std::atomic<bool>& isCancelled) {
        options.progress = [&isCancelled](double) { return !isCancelled; };
        return study::openScene(path, options);
    }));
    for (const core::Message& loss : loaded.losses) { // easily missed in a list
        if (PyErr_WarnEx(PyExc_UserWarning, toPython(loss.english()).cast<std::string>().c_str(), 1) != 0) {
            throw py::error_already_set();
        }
    }
    return std::make_shared<Scene>(std::move(loaded), fingertip_mm);
}

session::TissueOverride overridesFrom(const Scene& self, std::optional<double> stiffness, std::optional<double> damping)
{
    session::TissueOverride out = self.tissue();
    const std::array<std::optional<double>, 2> given{stiffness, damping};
    for (std::size_t i = 0; i < given.size(); ++i) {
        const core::TissueTerm& term = core::kTissueTerms[i];
        const bool isStiffness = term.member == &core::Tissue::stiffness_N_per_mm; // zero stiffness gives no contact
        if (given[i] && !(*given[i] >= 0.0 && *given[i] <= term.most && !(isStiffness && *given[i] == 0.0))) {
            throw py::value_error(std::string(term.key) + ": found " + numberText(*given[i]) + ", expected " +
                                  (isStiffness ? "above 0 and" : "at least 0 and") + " at most " +
                                  numberText(term.most));
        }
        out[i] = given[i] ? given[i] : out[i];
    }
    return out;
}

std::size_t numberOf(const Scene& self, const py::object& key)
{
    const auto& all = self.loaded().structures;
    if (py::isinstance<py::str>(key)) {
        const auto name = key.cast<std::string>();
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.description.name == name; });
        if (found == all.end()) {
            throw py::key_error("found no structure \"" + name + "\"");
        }
        return static_cast<std::size_t>(found - all.begin());
    }
    const auto count = static_cast<py::ssize_t>(all.size());
    const py::ssize_t given = PyNumber_AsSsize_t(key.ptr(), PyExc_IndexError);
    if (given == -1 && PyErr_Occurred() != nullptr) {
        throw py::error_already_set();
    }
    const py::ssize_t number = given < 0 ? given + count : given;
    if (number < 0 || number >= count) {
        throw py::index_error("found structure " + std::to_string(given) + ", expected a number below " +
                              std::to_string(count));
    }
    return static_cast<std::size_t>(number);
}

py::list namesOf(const Scene& self)
{
    py::list names;
    for (const meshio::LoadedStructure& one : self.loaded().structures) {
        names.append(toPython(one.description.name));
    }
    return names;
}

py::object sceneFindings(const Scene& self)
{
    QJsonArray findings;
    for (const core::Finding& one : self.loaded().scene.findings) {
        findings.append(session::toJson(one));
    }
    return parsedJson(QJsonDocument(findings).toJson(QJsonDocument::Compact).toStdString());
}

void bindStructure(py::module_& module)
{
    using py::arg;
    const auto description = [](auto member) {
        return [member](const Structure& self) { return self.loaded.description.*member; };
    };
    using Description = meshio::SceneStructure;
    const char* const kOptions =
        "stiffness_N_per_mm, damping_Ns_per_mm, friction_drag_Ns_per_mm: of the tissue at a fingertip [N/mm, N s/mm].\n"
        "friction_static, friction_dynamic: Coulomb coefficients. layer: 0 is the outermost.\n"
        "inside: name of the organ around a lump. young_ratio: Young's modulus of a lump over that of its organ;\n"
        "or young_kPa of both [kPa]. contact_radius_mm: of the finger on an organ with lumps [mm].";
    py::class_<Structure>(module, "Structure", "Surface with a name and a tissue. Immutable.")
        .def(py::init(withOptions<const std::shared_ptr<Surface>&>(
                 [](const std::shared_ptr<Surface>& surface, const StructureOptions& options) {
                     return structureFrom(surface, options);
                 })),
             arg("surface").none(false), py::kw_only(), arg("name") = py::none(),
             arg("stiffness_N_per_mm") = py::none(), arg("damping_Ns_per_mm") = py::none(),
             arg("friction_static") = py::none(), arg("friction_dynamic") = py::none(),
             arg("friction_drag_Ns_per_mm") = py::none(), arg("layer") = py::none(), arg("palpable") = py::none(),
             arg("inside") = py::none(), arg("young_ratio") = py::none(), arg("young_kPa") = py::none(),
             arg("contact_radius_mm") = py::none(),
             (std::string("Make a structure; without options of 0.5 N/mm, named \"surface\".\n\n") + kOptions).c_str())
        .def("replace", withOptions<const Structure&>([](const Structure& self, const StructureOptions& options) {
                 return replaced(self, options);
             }),
             py::kw_only(), arg("name") = py::none(), arg("stiffness_N_per_mm") = py::none(),
             arg("damping_Ns_per_mm") = py::none(), arg("friction_static") = py::none(),
             arg("friction_dynamic") = py::none(), arg("friction_drag_Ns_per_mm") = py::none(),
             arg("layer") = py::none(), arg("palpable") = py::none(), arg("inside") = py::none(),
             arg("young_ratio") = py::none(), arg("young_kPa") = py::none(), arg("contact_radius_mm") = py::none(),
             (std::string("Return a structure with other options and the same surface.\n\n") + kOptions).c_str())
        .def_property_readonly(
            "surface", [](const Structure& self) { return self.surface; }, "The surface, in LPS and mm.")
        .def_property_readonly(
            "name", [](const Structure& self) { return toPython(self.loaded.description.name); }, "Name.")
        .def_property_readonly(
            "tissue", [](const Structure& self) { return tissueOf(self.loaded.description.tissue); },
            "Dictionary of the tissue's numbers; further laws and maps come from scene files only.")
        .def_property_readonly("layer", description(&Description::layer), "Layer, 0 is the outermost.")
        .def_property_readonly("palpable", description(&Description::palpable), "False: touch ignores the structure.")
        .def_property_readonly(
            "inside", [](const Structure& self) { return toPython(self.loaded.description.inside); },
            "Name of the organ around a lump, or empty.")
        .def_property_readonly("young_ratio", description(&Description::young_ratio),
                               "Young's modulus of a lump over that of its organ, or None.")
        .def("__repr__", [](const Structure& self) {
            return toPython("<palpate.Structure \"" + self.loaded.description.name + "\">");
        });
}

} // namespace

void bindScene(py::module_& module)
{
    using py::arg;
    bindStructure(module);
    py::class_<Scene, std::shared_ptr<Scene>>(
        module, "Scene",
        "Structures that a hand can touch, and the fingertip. Immutable; any number of threads can use it.")
        .def(
            py::init(&sceneFrom), arg("structures"), py::kw_only(), arg("radius_mm") = 0.0, arg("buried") = "layers",
            "Make a scene.\n\n"
            "structures: sequence of Structure with names that differ.\n"
            "radius_mm: radius of the ball-shaped fingertip [mm], 0 to 50; 0 touches with a point.\n"
            "buried: \"layers\" touches a lump as a layer below its organ's surface, \"felt\" computes how it changes\n"
            "the stiffness of that surface.")
        .def("__len__", [](const Scene& self) { return self.loaded().structures.size(); })
        .def(
            "__getitem__", [](const Scene& self, const py::object& key) { return self.structure(numberOf(self, key)); },
            arg("key"), "Return the structure of a number or a name.")
        .def_property_readonly("names", &namesOf, "Names of the structures.")
        .def_property_readonly("radius_mm", &Scene::fingertip_mm, "Radius of the fingertip [mm]; 0: a point.")
        .def_property_readonly(
            "notes", [](const Scene& self) { return toPython(self.loaded().warnings); },
            "Repairs, assumptions and what could not be computed, one sentence each.")
        .def_property_readonly(
            "losses", [](const Scene& self) { return toPython(self.loaded().losses); },
            "What is missing or has changed, one sentence each; `load` also issues these as warnings.")
        .def_property_readonly("findings", &sceneFindings,
                               "Findings of the scene file: list of dictionaries, positions in mm, forces in N.")
        .def(
            "with_radius",
            [](const Scene& self, double radius_mm) {
                return std::make_shared<Scene>(self, fingertipFrom(radius_mm), self.tissue());
            },
            arg("radius_mm"), "Return the scene with another fingertip [mm]. Surfaces are shared.")
        .def(
            "with_tissue",
            [](const Scene& self, std::optional<double> stiffness, std::optional<double> damping) {
                return std::make_shared<Scene>(self, self.fingertip_mm(), overridesFrom(self, stiffness, damping));
            },
            py::kw_only(), arg("stiffness_N_per_mm") = py::none(), arg("damping_Ns_per_mm") = py::none(),
            "Return the scene with every structure a plain spring and damper, as `palpate replay --stiffness\n"
            "--damping` does: without friction, maps and other laws. None keeps a structure's own number.")
        .def("__repr__", [](const Scene& self) {
            return "<palpate.Scene of " + std::to_string(self.loaded().structures.size()) + " structures>";
        });
    module.def(
        "load", &load, arg("path"), py::kw_only(), arg("unit") = "mm", arg("frame") = "", arg("radius_mm") = 0.0,
        arg("partial") = false, arg("smooth") = false, arg("curved") = false, arg("smoothing") = py::none(),
        arg("outwards") = false, arg("close_holes_mm") = 0.0,
        "Open a mesh, a label map, a folder of them, a scene file (*.palpate.json) or the scene of a recording.\n\n"
        "unit: of a mesh file's numbers, \"m\", \"cm\" or \"mm\". frame: \"LPS\", \"RAS\" or \"Y-up\", overrides\n"
        "the file's. radius_mm: radius of the fingertip [mm]. partial: read what is whole of a truncated mesh.\n"
        "smooth, curved, smoothing (0 to 1), outwards, close_holes_mm [mm]: as the options of `palpate replay`.\n"
        "Missing and changed meshes are warnings. Ctrl-C stops.");
}

} // namespace palpate::python
