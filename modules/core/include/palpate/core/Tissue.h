// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Export.h"
#include "palpate/core/ForceLaw.h"
#include "palpate/core/Message.h"
#include "palpate/core/Status.h"

#include <array>
#include <limits>
#include <string_view>

namespace palpate::core {

/// Haptic properties of a structure: parameters of the contact force as perceived at the tip, not material moduli. A
/// zero value disables a term at no cost. Stiffness of a liver: about 0.1 to 0.3 N/mm.
struct Tissue
{
    double stiffness_N_per_mm = 0.5; ///< k: force per penetration depth
    double damping_Ns_per_mm = 0.0;  ///< b: force per speed
    /// Coulomb coefficients of static and dynamic friction, relative to the normal force; dynamic is at most static.
    /// See docs/friction.md.
    double friction_static = 0.0, friction_dynamic = 0.0;
    double friction_drag_Ns_per_mm = 0.0; ///< viscous friction: force per sliding speed
    /// Force law; linear uses only the stiffness. Absolute stiffness maps are relative to `stiffness_N_per_mm`.
    ForceLaw law{};

    [[nodiscard]] bool hasFriction() const noexcept { return friction_static > 0.0 || friction_drag_Ns_per_mm > 0.0; }
    friend bool operator==(const Tissue&, const Tissue&) = default;
};

/// Metadata of a tissue property, for files, recordings, the command line and panels. All values are at least 0.
struct TissueTerm
{
    std::string_view key;    ///< key in events and recording columns, and in scene files if `group` is empty
    std::string_view option; ///< command-line option; empty: none
    double Tissue::*member;
    MessageText<> name;    ///< display name
    MessageText<> meaning; ///< description as part of a sentence
    std::string_view unit;
    MessageText<> accessibleUnit;
    double most;              ///< maximum value in files and panels
    int decimals;             ///< decimals in panels
    double step;              ///< step of the panel's field
    std::string_view group{}; ///< parent object in scene files; empty: the structure itself
    std::string_view field{}; ///< key within `group`
};

/// All tissue properties, in the order of the recording columns. Append new ones at the end.
inline constexpr std::array kTissueTerms{
    TissueTerm{"stiffness_N_per_mm", "--stiffness", &Tissue::stiffness_N_per_mm, PALPATE_TEXT("Stiffness"),
               PALPATE_TEXT("force per millimetre of depth"), "N/mm", PALPATE_TEXT("newton per millimetre"), 1000.0, 2,
               0.05},
    TissueTerm{"damping_Ns_per_mm", "--damping", &Tissue::damping_Ns_per_mm, PALPATE_TEXT("Damping"),
               PALPATE_TEXT("resisting force per mm/s of movement"), "N·s/mm",
               PALPATE_TEXT("newton seconds per millimetre"), 1000.0, 4, 0.0005},
    TissueTerm{"friction_static", "", &Tissue::friction_static, PALPATE_TEXT("Static friction"),
               PALPATE_TEXT("tangential force that starts sliding, as a fraction of the normal force"), "",
               MessageText<>(), 5.0, 2, 0.05, "friction", "static"},
    TissueTerm{"friction_dynamic", "", &Tissue::friction_dynamic, PALPATE_TEXT("Sliding friction"),
               PALPATE_TEXT("tangential force while sliding, as a fraction of the normal force"), "", MessageText<>(),
               5.0, 2, 0.05, "friction", "dynamic"},
    TissueTerm{"friction_drag_Ns_per_mm", "", &Tissue::friction_drag_Ns_per_mm, PALPATE_TEXT("Drag"),
               PALPATE_TEXT("resisting force per mm/s of sliding"), "N·s/mm",
               PALPATE_TEXT("newton seconds per millimetre"), 1000.0, 4, 0.0005, "friction", "drag_Ns_per_mm"},
};

/// Validates a tissue from memory: every term finite and within 0 to TissueTerm::most, sliding friction at most static
/// friction, and the force law (ForceLaw.h). Scene files have the same bounds.
/// @return OutOfRange or NonFinite with the term, the value found and the value expected
[[nodiscard]] PALPATE_EXPORT Status check(const Tissue& tissue);

/// @return upper bounds that do not limit any tissue.
[[nodiscard]] inline Tissue unbounded()
{
    Tissue most;
    for (const TissueTerm& term : kTissueTerms) {
        most.*term.member = std::numeric_limits<double>::infinity();
    }
    return most;
}

} // namespace palpate::core
