// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate::app {

/// Smallest extent of a scene with a plausible unit [mm]. No organ is smaller; some libraries write metres to formats
/// that cannot store a unit. A smaller scene is touched with a point and not searched for gaps: a fingertip would be
/// larger than the scene, and each structure would be next to every other.
inline constexpr double kSmallestScene_mm = 3.0;

} // namespace palpate::app
