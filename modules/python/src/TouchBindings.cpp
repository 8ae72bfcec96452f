// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"
#include "Bindings.h"
#include "Errors.h"
#include "LongCall.h"
#include "Scene.h"
#include "TickTable.h"

#include <palpate/core/Types.h>
#include <palpate/haptics/Contact.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/session/MotionFile.h>
#include <palpate/session/Replay.h>

#include <pybind11/stl.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace palpate::python {

namespace {

/// The range of readMotion.
double periodFrom(double dt_s)
{
    constexpr double kLeast_s = 1e-5, kMost_s = 1.0;
    if (!(dt_s >= kLeast_s && dt_s <= kMost_s)) {
        throw py::value_error("dt: found " + numberText(dt_s) + ", expected 1e-05 to 1 s");
    }
    return dt_s;
}

std::shared_ptr<const haptics::HapticScene> hapticOf(const Scene& scene)
{
    return longCall([&](const std::atomic<bool>&) { return scene.haptic(); });
}

/// Result of a step. Keeps the names of the structures alive.
struct Tick
{
    std::shared_ptr<const haptics::HapticScene> scene;
    std::int64_t tick;
    core::Vec3 p_WH, p_WG, f_W, n_W;
    std::vector<haptics::Contact> contacts;
    std::int32_t structure;
    std::uint32_t solve_ns;
    std::uint8_t constraints;
    haptics::TickStatus status;

    [[nodiscard]] py::str name(std::int32_t number) const
    {
        return toPython(number < 0 ? std::string_view() : scene->structures()[static_cast<std::size_t>(number)].name);
    }
};

/// Palpator with its scene. Every method holds the GIL: a step takes less time than releasing it.
class HeldPalpator
{
  public:
    explicit HeldPalpator(const std::shared_ptr<Scene>& scene)
        : m_scene(scene)
        , m_haptic(hapticOf(*scene))
    {
        m_hand.borrowScene(m_haptic.get());
    }

    [[nodiscard]] const std::shared_ptr<Scene>& scene() const noexcept { return m_scene; }
    void setScene(const std::shared_ptr<Scene>& scene)
    {
        auto haptic = hapticOf(*scene);
        m_hand.borrowScene(haptic.get());
        m_haptic = std::move(haptic); // frees the scene before, which is no longer borrowed
        m_scene = scene;
    }
    void reset() noexcept { m_hand.reset(); }

    [[nodiscard]] Tick step(const py::object& hip, double dt_s)
    {
        const core::Vec3 p_WH = pointFrom(hip, "hip");
        const servo::TickRecord record = m_hand.step(p_WH, periodFrom(dt_s));
        const haptics::TickResult& felt = record.felt;
        return {m_haptic,
                record.tick,
                record.p_WH,
                felt.p_WG,
                felt.f_W,
                felt.n_W,
                std::vector<haptics::Contact>(felt.contacts.begin(), felt.contacts.begin() + felt.contactCount),
                felt.structure,
                record.solve_ns,
                felt.constraints,
                felt.status};
    }

  private:
    std::shared_ptr<Scene> m_scene;
    std::shared_ptr<const haptics::HapticScene> m_haptic;
    session::ReplayHand m_hand;
};

std::optional<bool> slides(haptics::Friction friction)
{
    return friction == haptics::Friction::None ? std::nullopt : std::optional(friction == haptics::Friction::Slides);
}

py::list contactsOf(const Tick& self)
{
    py::list out;
    for (const haptics::Contact& one : self.contacts) {
        py::dict contact;
        contact["structure"] = self.name(static_cast<std::int32_t>(one.structure));
        contact["god"] = toPython(one.p_WG);
        contact["normal"] = toPython(one.n_W);
        contact["force"] = toPython(one.f_W);
        contact["depth_mm"] = one.depth_mm;
        contact["triangle"] = one.triangle;
        contact["slides"] = slides(one.friction);
        out.append(contact);
    }
    return out;
}

const char* statusText(const Tick& self)
{
    switch (self.status) {
    case haptics::TickStatus::Converged:
        return "converged";
    case haptics::TickStatus::IterationLimit:
        return "iteration limit";
    case haptics::TickStatus::InvalidInput:
        break;
    }
    return "out of reach";
}

py::array replay(const Scene& scene, const py::object& hips, double dt_s, bool hasLayers)
{
    dt_s = periodFrom(dt_s);
    const Path path(hips, "hips");
    if (path.points().empty()) {
        throw py::value_error("hips: found no row, expected at least one position");
    }
    const auto haptic = hapticOf(scene);
    TickTable table(TickTable::Columns::Replay, hasLayers);
    {
        const py::gil_scoped_release released;
        table.reserve(path.points().size());
        const session::StructureNames names = [&](std::uint32_t number) -> std::string_view {
            return haptic->structures()[number].name;
        };
        SignalCheck signals;
        session::replay(*haptic, path.points(), dt_s, [&](const servo::TickRecord& tick) {
            table.add(tick, names);
            return signals.goesOn();
        });
    }
    throwIfRaised();
    return table.toArray();
}

void bindTick(py::module_& module)
{
    const auto vector = [](auto member) { return [member](const Tick& self) { return toPython(self.*member); }; };
    py::class_<Tick>(module, "Tick", "Result of one step.")
        .def_readonly("tick", &Tick::tick, "Number of the step, from 0.")
        .def_property_readonly("hip", vector(&Tick::p_WH), "(3,) float64: haptic interface point [mm].")
        .def_property_readonly("god", vector(&Tick::p_WG), "(3,) float64: god-object on the surface [mm].")
        .def_property_readonly("force", vector(&Tick::f_W), "(3,) float64: force on the hand, of all layers [N].")
        .def_property_readonly("normal", vector(&Tick::n_W),
                               "(3,) float64: unit normal of the contact; zero in free space.")
        .def_property_readonly(
            "structure", [](const Tick& self) { return self.name(self.structure); },
            "Name of the outermost structure touched, empty in free space.")
        .def_property_readonly(
            "depth_mm", [](const Tick& self) { return self.structure >= 0 ? (self.p_WG - self.p_WH).norm() : 0.0; },
            "Distance from the HIP to the god-object; 0 in free space [mm].")
        .def_readonly("constraints", &Tick::constraints, "Number of active planes, 0 to 3.")
        .def_property_readonly(
            "slides",
            [](const Tick& self) {
                return self.contacts.empty() ? std::nullopt : slides(self.contacts.front().friction);
            },
            "True while friction lets the god-object slide, False while it holds, None without friction.")
        .def_property_readonly("contacts", &contactsOf,
                               "One dictionary for each structure in contact, the outermost layer first: structure,\n"
                               "god, normal, force, depth_mm, triangle (number in the structure's surface), slides.")
        .def_property_readonly(
            "status", &statusText,
            "\"converged\"; \"iteration limit\"; \"out of reach\": too far from the scene, no force.")
        .def_readonly("solve_ns", &Tick::solve_ns, "Time of the solver [ns].")
        .def("__repr__", [](const Tick& self) {
            return toPython("<palpate.Tick " + std::to_string(self.tick) + ": " + numberText(self.f_W.norm()) + " N" +
                            (self.structure < 0 ? ">" : " at " + self.name(self.structure).cast<std::string>() + ">"));
        });
}

} // namespace

void bindTouch(py::module_& module)
{
    using py::arg;
    bindTick(module);
    py::class_<HeldPalpator>(module, "Palpator",
                             "Feels a scene step by step, with the code of the 1 kHz servo thread. Steps of several\n"
                             "threads take turns.")
        .def(py::init<const std::shared_ptr<Scene>&>(), arg("scene").none(false),
             "Make a palpator. The first use of a scene builds the index of its surfaces.")
        .def("step", &HeldPalpator::step, arg("hip"), arg("dt") = session::kNominalPeriod_s,
             "Move the hand and return the Tick.\n\n"
             "hip: (3,) array or sequence, position of the haptic interface point [mm].\n"
             "dt: time since the step before, 1e-5 to 1 [s]. In moving tissue keep dt constant.\n"
             "Steps along a path give the same bits as `replay` of this path.")
        .def("reset", &HeldPalpator::reset, "Start again: the next step is tick 0, without contact before.")
        .def_property(
            "scene", &HeldPalpator::scene,
            [](HeldPalpator& self, const std::shared_ptr<Scene>& scene) {
                if (scene == nullptr) {
                    throw py::type_error("scene: found None, expected a palpate.Scene");
                }
                self.setScene(scene);
            },
            "The scene. Setting another one keeps contacts with structures of the same name and number.");
    module.def("replay", &replay, arg("scene"), arg("hips"), arg("dt") = session::kNominalPeriod_s, py::kw_only(),
               arg("layers") = true,
               "Feel a motion and return a structured array with one item for each row of `hips`.\n\n"
               "hips: (n, 3) array of positions [mm]. An aligned float64 array in C order is read in place: no other "
               "thread may\n"
               "change it meanwhile. dt: time between rows, 1e-5 to 1 [s].\n"
               "Fields: the columns of `palpate replay --out TICKS.csv`, with the same values, in mm, N and ns. Texts\n"
               "are empty where the CSV is. layers=False leaves the texts of `layers` empty, which saves memory.\n"
               "Other threads continue meanwhile; Ctrl-C stops.");
}

} // namespace palpate::python
