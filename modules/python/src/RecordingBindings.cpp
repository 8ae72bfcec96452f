// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"
#include "Bindings.h"
#include "Errors.h"
#include "LongCall.h"
#include "Scene.h"
#include "TickTable.h"

#include <palpate/session/Recording.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/Replay.h>
#include <palpate/study/CompareRecordings.h>
#include <palpate/study/FindingsFile.h>
#include <palpate/study/MeasureRecording.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/study/SessionExport.h>
#include <palpate/study/StructureSources.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace palpate::python {

namespace {

namespace fs = std::filesystem;

/// Recording that one thread at a time reads.
class Recording
{
  public:
    explicit Recording(const fs::path& path)
        : m_reader(valueOf(session::RecordingReader::open(path)))
    {
    }
    /// For constant data.
    [[nodiscard]] const session::RecordingReader& reader() const noexcept { return *m_reader; }
    /// Calls `use(reader)` while no other thread reads.
    /// @pre the GIL is not held
    template<class Use>
    auto locked(Use use) const
    {
        const std::lock_guard lock(m_mutex);
        return use(*m_reader);
    }

  private:
    std::unique_ptr<session::RecordingReader> m_reader;
    mutable std::mutex m_mutex;
};

std::optional<double> distanceFrom(std::optional<double> distance_mm)
{
    if (distance_mm && !(*distance_mm > 0.0 && std::isfinite(*distance_mm))) {
        throw py::value_error("distance_mm: found " + numberText(*distance_mm) + ", expected a number above 0");
    }
    return distance_mm;
}

py::dict infoOf(const Recording& self)
{
    const session::RecordingInfo& info = self.reader().info();
    const session::RecordingExtent& extent = self.reader().extent();
    py::dict out;
    out["version"] = info.version;
    out["palpate"] = toPython(info.palpate);
    out["started_utc"] = toPython(info.startedUtc);
    out["scene"] = toPython(info.scene);
    out["device"] = toPython(info.device.name);
    out["rate_Hz"] = info.rate_Hz;
    out["dt_s"] = info.dt_s;
    out["first_tick"] = extent.firstTick;
    out["last_tick"] = extent.lastTick;
    out["ticks"] = extent.ticks;
    out["dropped"] = extent.dropped;
    out["duration_s"] = extent.duration_s;
    out["is_complete"] = extent.isComplete;
    out["ending"] = toPython(session::endingText(extent).english());
    const auto& scenes = self.reader().scenes();
    out["radius_mm"] = scenes.empty() ? 0.0 : scenes.front().fingertip_mm;
    return out;
}

py::list eventsOf(const Recording& self)
{
    py::list out;
    for (const session::RecordingEvent& event : self.reader().events()) {
        py::dict one;
        one["tick"] = event.tick;
        one["kind"] = toPython(event.kind);
        one["data"] = parsedJson(event.json);
        out.append(one);
    }
    return out;
}

py::object recordedFindings(const Recording& self)
{
    QJsonArray findings;
    for (const auto& [tick, finding] : session::findingsOf(self.reader().events())) {
        QJsonObject one = session::toJson(finding);
        one["marked_s"] = static_cast<double>(tick - self.reader().extent().firstTick) * self.reader().info().dt_s;
        findings.append(one);
    }
    return parsedJson(QJsonDocument(findings).toJson(QJsonDocument::Compact).toStdString());
}

py::array ticksOf(const Recording& self, std::optional<std::int64_t> first, std::optional<std::int64_t> last,
                  bool hasLayers)
{
    const session::RecordingExtent& extent = self.reader().extent();
    TickTable table(TickTable::Columns::Session, hasLayers);
    core::Status status;
    {
        const py::gil_scoped_release released;
        status = self.locked([&](const session::RecordingReader& reader) {
            SignalCheck signals;
            return reader.forEach(
                first.value_or(extent.firstTick), last.value_or(extent.lastTick), [&](const servo::TickRecord& tick) {
                    table.add(tick, [&](std::uint32_t number) { return reader.structureName(tick.scene, number); });
                    return signals.goesOn();
                });
        });
    }
    throwIfRaised();
    throwUnlessOk(status);
    std::span<const session::RecordingEvent> events(self.reader().events()); // by tick, constant
    const auto firstAfter = [&events](std::int64_t tick) {
        return static_cast<std::size_t>(
            std::upper_bound(events.begin(), events.end(), tick,
                             [](std::int64_t t, const session::RecordingEvent& event) { return t < event.tick; }) -
            events.begin());
    };
    if (last.value_or(extent.lastTick) < extent.lastTick) {
        events = events.first(firstAfter(*last));
    }
    if (first.value_or(extent.firstTick) > extent.firstTick) {
        events = events.subspan(firstAfter(*first - 1));
    }
    return table.toArray(events);
}

py::array hipsOf(const Recording& self)
{
    auto motion = valueOf(longCall([&](const std::atomic<bool>&) {
        return self.locked([](const session::RecordingReader& reader) { return reader.motion(); });
    }));
    const auto kept = std::make_shared<const std::vector<core::Vec3>>(std::move(motion.p_WH));
    return viewOf(*kept, ownerOf(kept));
}

py::list faultsOf(const Recording& self)
{
    return toPython(longCall([&](const std::atomic<bool>&) {
        return self.locked([](const session::RecordingReader& reader) { return reader.faults(); });
    }));
}

std::shared_ptr<Scene> sceneOf(const Recording& self)
{
    auto loaded = valueOf(longCall([&](const std::atomic<bool>& isCancelled) {
        meshio::ReadOptions options;
        options.progress = [&isCancelled](double) { return !isCancelled; };
        return study::sceneOfRecording(self.reader().path(), options);
    }));
    const auto& scenes = self.reader().scenes();
    return std::make_shared<Scene>(std::move(loaded), scenes.empty() ? 0.0 : scenes.front().fingertip_mm);
}

py::object measuresOf(const Recording& self, std::optional<double> distance_mm, const std::optional<fs::path>& scene)
{
    study::RecordingMeasureOptions options;
    options.scene = scene.value_or(fs::path());
    options.distance_mm = distanceFrom(distance_mm);
    const auto measured = valueOf(longCall([&](const std::atomic<bool>& isCancelled) {
        options.progress = [&isCancelled](double) { return !isCancelled; };
        return self.locked(
            [&](const session::RecordingReader& reader) { return study::measureRecording(reader, options); });
    }));
    return parsedJson(study::measuresJson(measured.measures));
}

py::dict verify(const Recording& self, const std::optional<fs::path>& scene)
{
    const session::Resimulation result = valueOf(longCall([&](const std::atomic<bool>& isCancelled) {
        return self.locked([&](const session::RecordingReader& reader) -> core::Result<session::Resimulation> {
            if (core::Status status = reader.verify([&](double) { return !isCancelled; }); !status.isOk()) {
                return status;
            }
            const auto surfaces = study::recordedSurfaces(reader, scene.value_or(fs::path()));
            if (!surfaces.isOk()) {
                return surfaces.status();
            }
            return session::resimulate(reader, study::indexedByHash(surfaces.value()),
                                       [&](const servo::TickRecord&) { return !isCancelled; });
        });
    }));
    py::dict out;
    out["compared"] = result.compared;
    out["differing"] = result.differing;
    out["unverified"] = result.unverified;
    out["is_same"] = result.isSame();
    out["is_within_rounding"] = result.isWithinRounding();
    out["farthest_mm"] = result.farthest_mm;
    out["farthest_N"] = result.farthest_N;
    return out;
}

py::object compare(const fs::path& first, const fs::path& second, std::optional<double> distance_mm,
                   const std::optional<fs::path>& scene)
{
    study::CompareOptions options;
    options.scene = scene.value_or(fs::path());
    options.distance_mm = distanceFrom(distance_mm);
    const auto compared = valueOf(longCall([&](const std::atomic<bool>& isCancelled) {
        options.progress = [&isCancelled](double) { return !isCancelled; };
        return study::compareRecordings(first, second, options);
    }));
    return parsedJson(study::comparisonJson(compared));
}

} // namespace

void bindRecording(py::module_& module)
{
    using py::arg;
    py::class_<Recording>(module, "Recording",
                          "Recording of a session (*.palpate). The file is only read. Several threads take turns.")
        .def(py::init<const fs::path&>(), arg("path"), "Open a recording.")
        .def_property_readonly(
            "path", [](const Recording& self) { return toPython(self.reader().path().string()); }, "Path of the file.")
        .def_property_readonly("info", &infoOf, "Dictionary: versions, device, rate_Hz, dt_s, ticks, duration_s, ….")
        .def_property_readonly("events", &eventsOf, "Events: list of dictionaries with tick, kind and data.")
        .def_property_readonly("findings", &recordedFindings,
                               "Findings and notes at the end: list of dictionaries, positions in mm, forces in N,\n"
                               "marked_s: time of marking [s].")
        .def_property_readonly("faults", &faultsOf, "Damage found so far, one sentence each.")
        .def("ticks", &ticksOf, py::kw_only(), arg("first") = py::none(), arg("last") = py::none(),
             arg("layers") = true,
             "Return the ticks from `first` to `last` as a structured array.\n\n"
             "Fields: the columns of `palpate session export --csv`, in mm, N, s and ns. Ticks without a hand have "
             "NaN and\n"
             "empty texts. Damaged blocks are left out: see `faults`. `events` has Python objects, str.\n"
             "layers=False leaves the texts of `layers` empty, which saves memory.")
        .def("hips", &hipsOf,
             "Return the path of the haptic interface point: (n, 3) float64 [mm], one row for each tick with a hand.\n"
             "`replay` takes it. Read-only, without a further copy.")
        .def("scene", &sceneOf, "Return the scene that was recorded, with its fingertip.")
        .def("measures", &measuresOf, py::kw_only(), arg("distance_mm") = py::none(), arg("scene") = py::none(),
             "Return the measures as a dictionary, as `palpate session measure --json` writes.\n\n"
             "distance_mm: how near a contact counts as touching [mm]; None: radius of the fingertip, 5 for a point.\n"
             "scene: where the scene is now; None: as stored in the recording.")
        .def("verify", &verify, py::kw_only(), arg("scene") = py::none(),
             "Check all checksums, compute the recording again and return a dictionary: compared, differing and\n"
             "unverified [ticks], is_same, is_within_rounding, farthest_mm, farthest_N.")
        .def("__repr__", [](const Recording& self) {
            return toPython("<palpate.Recording of " + std::to_string(self.reader().extent().ticks) + " ticks>");
        });
    module.def("compare", &compare, arg("first"), arg("second"), py::kw_only(), arg("distance_mm") = py::none(),
               arg("scene") = py::none(),
               "Compare two recordings of the same surfaces and return a dictionary, as\n"
               "`palpate session compare --json` writes. Arguments as for `Recording.measures`.");
}

} // namespace palpate::python
