// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/MeasureRecording.h"

#include "palpate/study/BuriedLumps.h"
#include "palpate/study/RecordedScene.h"
#include "palpate/study/SearchedLumps.h"

#include <utility>
#include <vector>

namespace palpate::study {

core::Result<MeasuredRecording> measureRecording(const session::RecordingReader& reader,
                                                 const RecordingMeasureOptions& options)
{
    const auto surfaces = recordedSurfaces(reader, options.scene);
    if (!surfaces.isOk() && !options.scene.empty()) {
        return surfaces.status();
    }
    const session::MeshesByHash meshes = surfaces.isOk() ? surfaces.value() : session::MeshesByHash{};
    session::MeasureOptions how;
    how.distance_mm = options.distance_mm.value_or(defaultDistance_mm(reader, meshes));
    const auto scene = options.scene.empty() ? sceneOfRecording(reader.path()) : openScene(options.scene);
    std::vector<OrganPalpability> organs;
    if (scene.isOk()) {
        constexpr double kLumpsShare = 0.2; // of the progress
        auto computed = computePalpability(scene.value(), {}, nullptr, [&](double share) {
            return !options.progress || options.progress(kLumpsShare * share);
        });
        if (!computed.isOk()) {
            return computed.status();
        }
        organs = std::move(computed).value();
        how.progress = [&](double share) {
            return !options.progress || options.progress(kLumpsShare + (1.0 - kLumpsShare) * share);
        };
    } else {
        how.progress = options.progress;
    }
    auto measures = scene.isOk() ? measureSearch(reader, meshes, scene.value(), std::move(organs), std::move(how))
                                 : session::measureSession(reader, meshes, how);
    if (!measures.isOk()) {
        return measures.status();
    }
    MeasuredRecording out{std::move(measures).value(), {}};
    if (!out.measures.unmeasured.empty()) {
        out.unmeasured =
            surfaces.isOk() ? core::Message(PALPATE_TEXT("its surface is another one now")) : surfaces.status().text();
    }
    return out;
}

} // namespace palpate::study
