// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Types.h"

#include <optional>
#include <string>

namespace palpate::core {

/// A place on tissue that a person marked; scene files and recordings hold the same.
struct Finding
{
    std::string name{};
    Vec3 p_W = Vec3::Zero();          ///< god-object when it was marked [mm]
    std::string note{};               ///< what a person wrote about it
    std::string structure{};          ///< name of the one that was touched there, may be empty
    std::optional<double> force_N{};  ///< with which it was touched
    std::optional<double> depth_mm{}; ///< to which
    std::string extra{};              ///< fields of a scene file that this version does not know, as a JSON object
};

} // namespace palpate::core
