// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Export.h"
#include "palpate/core/Status.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::core {

/// Shape of the force over the penetration depth. Formulas and sources: docs/laws.md.
enum class LawKind : std::uint8_t
{
    Linear,      ///< stiffness times depth
    Exponential, ///< after Fung: soft initially, increasingly stiff
    Hertz,       ///< sphere on a soft half-space
    Layer,       ///< sphere on a soft layer over a rigid base
    Click,       ///< rises, snaps through, rises again
    Points,      ///< interpolates measured points
};

/// Force law and its parameters. A value type; the servo thread evaluates a table computed from this law
/// (haptics::ForceTable).
struct ForceLaw
{
    static constexpr std::size_t kMaxParameters = 5;
    static constexpr std::size_t kMaxPoints = 64;
    static constexpr double kMaxSlope = 1000.0;         ///< maximum absolute slope of a law [N/mm]
    static constexpr double kMaxPointDepth_mm = 1000.0; ///< maximum depth of a measured point
    static constexpr double kMinPointSpacing_mm = 1e-3; ///< minimum depth difference of consecutive measured points

    /// Depth [mm] and force [N].
    using Point = std::array<double, 2>;

    LawKind kind = LawKind::Linear;
    std::array<double, kMaxParameters>
        numbers{};             ///< parameters in the order of `lawParameters(kind)`; unused ones are 0
    std::vector<Point> points; ///< for LawKind::Points only; ascending, starting at (0, 0)

    friend bool operator==(const ForceLaw&, const ForceLaw&) = default;
};

/// Metadata of a law parameter, for files and panels.
struct LawParameter
{
    std::string_view key; ///< key in scene files
    MessageText<> name;
    std::string_view unit;
    double least, most;
    double usual;          ///< default if missing in a file
    bool isSwitch = false; ///< boolean parameter: 0 or 1; true or false in files
};

/// Name of a law in files, e.g. "linear".
[[nodiscard]] PALPATE_EXPORT std::string_view lawName(LawKind kind) noexcept;
/// All laws, in the order of the selection list.
inline constexpr std::array kLawKinds{LawKind::Linear, LawKind::Exponential, LawKind::Hertz,
                                      LawKind::Layer,  LawKind::Click,       LawKind::Points};
/// Parameters of a law, in the order of ForceLaw::numbers.
[[nodiscard]] PALPATE_EXPORT std::span<const LawParameter> lawParameters(LawKind kind) noexcept;
/// Law with default parameters.
[[nodiscard]] PALPATE_EXPORT ForceLaw usualLaw(LawKind kind);
/// Validates a law. Linear is always valid.
/// @return an error with parameter or point and value for: non-finite or out-of-range parameters, contradictory
/// parameters, points that do not ascend from (0, 0), negative forces, slopes above kMaxSlope
[[nodiscard]] PALPATE_EXPORT Status check(const ForceLaw& law);

/// First invalid point (index from 0) with the reason; the text is empty if all points are valid.
struct PointFault
{
    std::size_t point = 0;
    Message what;
};
[[nodiscard]] PALPATE_EXPORT PointFault firstFault(std::span<const ForceLaw::Point> points);

} // namespace palpate::core
