// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Status.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::core {

/// By what law the force rises with the depth. resources/docs/laws.md has the formulas and their sources.
enum class LawKind : std::uint8_t
{
    Linear,      ///< stiffness times depth
    Exponential, ///< after Fung: soft at first, ever stiffer
    Hertz,       ///< a ball on a soft half-space
    Layer,       ///< a ball on a soft layer on something rigid
    Click,       ///< rises, snaps through, rises again
    Points,      ///< as measured
};

/// A law and its numbers. A value: what is felt is a table made of it (haptics::ForceTable).
struct ForceLaw
{
    static constexpr std::size_t kMostNumbers = 5;
    static constexpr std::size_t kMostPoints = 64;
    static constexpr double kMostSlope = 1000.0;    ///< of a law, up or down [N/mm]
    static constexpr double kMostDepth_mm = 1000.0; ///< of a measured point
    static constexpr double kLeastStep_mm = 1e-3;   ///< from one measured point to the next

    /// Depth [mm] and force [N].
    using Point = std::array<double, 2>;

    LawKind kind = LawKind::Linear;
    std::array<double, kMostNumbers> numbers{}; ///< by `lawTerms(kind)`; the others are 0
    std::vector<Point> points;                  ///< of LawKind::Points alone, ascending, the first (0, 0)

    friend bool operator==(const ForceLaw&, const ForceLaw&) = default;
};

/// One number of a law, as files and panels tell it.
struct LawTerm
{
    std::string_view key; ///< in scene files
    std::string_view name;
    std::string_view unit;
    double least, most;
    double usual;          ///< where a file does not say it
    bool isSwitch = false; ///< 0 or 1; true or false in files
};

/// The name of a law in files: "linear".
[[nodiscard]] std::string_view lawName(LawKind kind) noexcept;
/// All laws, in the order in which a person chooses among them.
inline constexpr std::array kLawKinds{LawKind::Linear, LawKind::Exponential, LawKind::Hertz,
                                      LawKind::Layer,  LawKind::Click,       LawKind::Points};
/// The numbers of a law, in the order of ForceLaw::numbers.
[[nodiscard]] std::span<const LawTerm> lawTerms(LawKind kind) noexcept;
/// A law as it is where nothing else is said.
[[nodiscard]] ForceLaw usualLaw(LawKind kind);
/// @return what is wrong with a law, by number or point and value: one that is not finite or out of its range, numbers
/// that contradict one another, points that do not ascend from (0, 0), fall below 0 or are too steep. Fine for linear.
[[nodiscard]] Status check(const ForceLaw& law);

/// The first of measured points that makes them no law, from 0, and what is wrong; nothing wrong: an empty text.
struct PointFault
{
    std::size_t point = 0;
    std::string what;
};
[[nodiscard]] PointFault firstFault(std::span<const ForceLaw::Point> points);

} // namespace palpate::core
