// SPDX-License-Identifier: BSD-3-Clause
#include "SessionReport.h"

#include "Console.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <map>

namespace palpate::app {

void printRecording(const std::filesystem::path& file, const session::RecordingReader& reader)
{
    const session::RecordingInfo& info = reader.info();
    const session::RecordingExtent& extent = reader.extent();
    print("%s: recording of version %d\n", file.string().c_str(), info.version);
    print("  made %s by Palpate %s (%s)\n", info.startedUtc.c_str(), info.palpate.c_str(), info.build.c_str());
    print("  %s, %s ticks (%lld to %lld) at %g Hz, %.3f s\n", extent.isComplete ? "complete" : "cut off by a crash",
          grouped(extent.ticks).c_str(), static_cast<long long>(extent.firstTick),
          static_cast<long long>(extent.lastTick), info.rate_Hz, extent.duration_s);
    print("  %s ticks missing\n", grouped(extent.dropped).c_str());
    print("  device: %s, up to %g N\n", info.device.name.c_str(), info.device.maxForce_N);
    print("  scene: %s, %zu generation%s\n", info.scene.empty() ? "not said" : info.scene.c_str(),
          reader.scenes().size(), reader.scenes().size() == 1 ? "" : "s");
    if (!reader.scenes().empty()) {
        constexpr std::size_t kShown = 4;
        const auto& structures = reader.scenes().front().structures;
        for (std::size_t i = 0; i < std::min(kShown, structures.size()); ++i) {
            const session::StructureRecord& structure = structures[i];
            print("    %s: %g N/mm, %g N s/mm, layer %u%s, geometry %.12s\n", structure.name.c_str(),
                  structure.tissue.stiffness_N_per_mm, structure.tissue.damping_Ns_per_mm, structure.layer,
                  structure.palpable ? "" : ", not palpable", structure.source.sha256.c_str());
        }
        if (structures.size() > kShown) {
            print("    and %zu more\n", structures.size() - kShown);
        }
    }
    std::map<std::string, int> kinds;
    for (const session::RecordingEvent& event : reader.events()) {
        ++kinds[event.kind];
    }
    std::string list;
    for (const auto& [kind, count] : kinds) {
        list += (list.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
    }
    print("  events: %s\n", list.empty() ? "none" : list.c_str());
}

void printMeasures(const session::Measures& m)
{
    print("duration %.3f s, contact %.3f s\n", m.duration_s, m.contactTime_s);
    print("path of the hand %.4g mm, on the surface %.4g mm\n", m.pathLength_mm, m.contactPath_mm);
    print("force in contact: peak %.4g N, mean %.4g N, 95th percentile %.4g N; peak depth %.4g mm\n", m.peakForce_N,
          m.meanForce_N, m.p95Force_N, m.peakDepth_mm);
    for (const auto& [name, part] : m.structures) {
        print("  %s: contact %.3f s, force peak %.4g N, mean %.4g N, peak depth %.4g mm\n", name.c_str(),
              part.contactTime_s, part.peakForce_N, part.meanForce_N, part.peakDepth_mm);
    }
}

std::string measuresJson(const session::Measures& m)
{
    QJsonObject structures;
    for (const auto& [name, part] : m.structures) {
        structures[QString::fromStdString(name)] = QJsonObject{{"contact_time_s", part.contactTime_s},
                                                               {"peak_force_N", part.peakForce_N},
                                                               {"mean_force_N", part.meanForce_N},
                                                               {"peak_depth_mm", part.peakDepth_mm}};
    }
    const QJsonObject root{
        {"ticks", static_cast<qint64>(m.ticks)},
        {"contact_ticks", static_cast<qint64>(m.contactTicks)},
        {"duration_s", m.duration_s},
        {"contact_time_s", m.contactTime_s},
        {"path_length_mm", m.pathLength_mm},
        {"contact_path_mm", m.contactPath_mm},
        {"peak_force_N", m.peakForce_N},
        {"mean_force_N", m.meanForce_N},
        {"p95_force_N", m.p95Force_N},
        {"peak_depth_mm", m.peakDepth_mm},
        {"structures", structures},
    };
    return QJsonDocument(root).toJson().toStdString();
}

std::string builtDifferently(const session::RecordingInfo& info)
{
    return info.build == session::buildId()
               ? std::string()
               : "; recorded by another build (" + info.build + "), this one is " + session::buildId();
}

} // namespace palpate::app
