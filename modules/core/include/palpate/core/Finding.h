// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Types.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate::core {

/// One of several layers that were felt in one place.
struct FeltLayer
{
    std::string structure{}; ///< its name
    double force_N = 0.0;    ///< its share
    double depth_mm = 0.0;   ///< to which it was pressed in

    friend bool operator==(const FeltLayer&, const FeltLayer&) = default;
};

/// A place on tissue that a person marked; scene files and recordings hold the same.
struct Finding
{
    std::string name{};
    Vec3 p_W = Vec3::Zero();          ///< god-object when it was marked [mm]
    std::string note{};               ///< what a person wrote about it
    std::string structure{};          ///< name of the one that was touched there, may be empty
    std::optional<double> force_N{};  ///< with which it was touched
    std::optional<double> depth_mm{}; ///< to which
    std::vector<FeltLayer> layers{};  ///< the outermost first, where more than one was felt
    std::string extra{};              ///< fields of a scene file that this version does not know, as a JSON object
};

} // namespace palpate::core
