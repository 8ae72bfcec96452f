// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/meshio/LoadScene.h>
#include <palpate/session/MeasureSession.h>

#include <functional>
#include <vector>

namespace palpate::study {

/// Tells a search that could not have found a lump from one that missed it: where a trained hand tells each lump of a
/// scene when it presses, and over how much of that the hand of a recording pressed deep enough. Places that the model
/// does not judge are left out.
/// @param scene  that the recording was made on; @param distance_mm  how near the contact must come to a place
/// @param progress  told the share done; false cancels. May be empty
/// @return none for a scene without lumps; an organ that can't be judged has none; Cancelled, or what could not be read
/// @par Thread Any; the reader must serve no other meanwhile.
[[nodiscard]] core::Result<std::vector<session::LumpSearch>>
searchedLumps(const session::RecordingReader& reader, const meshio::LoadedScene& scene, double distance_mm,
              const std::function<bool(double)>& progress = {});

} // namespace palpate::study
