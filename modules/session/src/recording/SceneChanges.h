// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recording.h"

#include <vector>

namespace palpate::session::internal {

/// Returns the haptic changes of a scene: "tissue", "hidden", "shown" or "layer" for each changed structure, or
/// "structures" if the list of structures differs.
/// @param tick  first tick with `after`
[[nodiscard]] std::vector<RecordingEvent> sceneChanges(std::int64_t tick, const SceneRecord& before,
                                                       const SceneRecord& after);

} // namespace palpate::session::internal
