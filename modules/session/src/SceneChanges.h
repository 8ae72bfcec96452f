// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recording.h"

#include <vector>

namespace palpate::session::internal {

/// Says what is felt differently in `after`: "tissue", "hidden", "shown", "layer" for each structure concerned, or
/// "structures" when it is another list of them.
/// @param tick  first one on `after`
[[nodiscard]] std::vector<RecordingEvent> sceneChanges(std::int64_t tick, const SceneRecord& before,
                                                       const SceneRecord& after);

} // namespace palpate::session::internal
