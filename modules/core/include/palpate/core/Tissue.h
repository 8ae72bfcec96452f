// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/ForceLaw.h"

#include <array>
#include <limits>
#include <string_view>

namespace palpate::core {

/// How a structure feels: the numbers of its force law, "as felt", no moduli of a material. One that is 0 is not there
/// and costs nothing.
struct Tissue
{
    double stiffness_N_per_mm = 0.5; ///< k: force for each mm pressed in
    double damping_Ns_per_mm = 0.0;  ///< b: force against each mm/s of movement
    /// Share of the normal force that holds the god-object, and that drags on it while it slides: Coulomb's, as in
    /// resources/docs/friction.md. The second is at most the first.
    double friction_static = 0.0, friction_dynamic = 0.0;
    double friction_drag_Ns_per_mm = 0.0; ///< force against each mm/s of sliding
    /// Force by depth; linear: the stiffness alone. A map's absolute stiffness is told against `stiffness_N_per_mm`.
    ForceLaw law{};

    [[nodiscard]] bool hasFriction() const noexcept { return friction_static > 0.0 || friction_drag_Ns_per_mm > 0.0; }
    friend bool operator==(const Tissue&, const Tissue&) = default;
};

/// One number of a tissue, as files, recordings, the command line and panels tell it. At least 0.
struct TissueTerm
{
    std::string_view key;    ///< in events, and the column of a recording; in scene files where it has no group
    std::string_view option; ///< on the command line; empty: none
    double Tissue::*member;
    std::string_view name;    ///< as a person reads it
    std::string_view meaning; ///< in a sentence's part
    std::string_view unit;
    std::string_view spokenUnit;
    double most;              ///< that a file may hold, and a panel
    int decimals;             ///< that a panel shows
    double step;              ///< of a panel's field
    std::string_view group{}; ///< object of a scene file that it stands in; empty: the structure itself
    std::string_view field{}; ///< its name there
};

/// All numbers of a tissue, in the order of a recording's columns: a new one comes last.
inline constexpr std::array kTissueTerms{
    TissueTerm{"stiffness_N_per_mm", "--stiffness", &Tissue::stiffness_N_per_mm, "Stiffness",
               "force for each mm pressed in", "N/mm", "newton per millimetre", 1000.0, 2, 0.05},
    TissueTerm{"damping_Ns_per_mm", "--damping", &Tissue::damping_Ns_per_mm, "Resists fast movement",
               "force against each mm/s of movement", "N·s/mm", "newton seconds per millimetre", 1000.0, 4, 0.0005},
    TissueTerm{"friction_static", "", &Tissue::friction_static, "Friction at rest",
               "share of the normal force that holds", "", "", 5.0, 2, 0.05, "friction", "static"},
    TissueTerm{"friction_dynamic", "", &Tissue::friction_dynamic, "Friction sliding",
               "share of the normal force that drags while it slides", "", "", 5.0, 2, 0.05, "friction", "dynamic"},
    TissueTerm{"friction_drag_Ns_per_mm", "", &Tissue::friction_drag_Ns_per_mm, "Drag",
               "force against each mm/s of sliding", "N·s/mm", "newton seconds per millimetre", 1000.0, 4, 0.0005,
               "friction", "drag_Ns_per_mm"},
};

/// @return what bounds no tissue.
[[nodiscard]] inline Tissue unbounded()
{
    Tissue most;
    for (const TissueTerm& term : kTissueTerms) {
        most.*term.member = std::numeric_limits<double>::infinity();
    }
    return most;
}

} // namespace palpate::core
