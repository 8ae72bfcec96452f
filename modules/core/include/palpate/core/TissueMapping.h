// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace palpate::core {

/// Tissue property controlled by a map; its properties are in kMappedQuantities.
enum class MappedQuantity : std::uint8_t
{
    Stiffness,
    Damping,
    Friction,
};

/// Unit of a map's values.
enum class MapUnit : std::uint8_t
{
    Scale,    ///< factor on the tissue's own value [1]
    NPerMm,   ///< contact stiffness [N/mm]
    NsPerMm,  ///< contact damping [N·s/mm]
    YoungKPa, ///< Young's modulus [kPa]; converted for a contact radius
    ShearKPa, ///< shear modulus [kPa], a third of Young's modulus; converted likewise
};

/// Spatial variation of a tissue property over a surface, from a mesh array or a volume.
struct TissueMapping
{
    MappedQuantity quantity = MappedQuantity::Stiffness;
    MapUnit unit = MapUnit::Scale;
    std::string array;                            ///< array name in the mesh file; empty: use the volume
    std::string file;                             ///< path of the volume; empty: use the array
    double contactRadius_mm = 5.0;                ///< contact radius for moduli
    std::optional<std::array<double, 2>> clamp{}; ///< minimum and maximum to which map values are clamped

    friend bool operator==(const TissueMapping&, const TissueMapping&) = default;

    /// Converts a map value to the unit of the servo loop: a scale [1], N/mm or N·s/mm.
    /// @par Source Flat rigid punch of radius a on an incompressible half-space: k = 2aE / (1 - nu^2) = 8a mu (Sneddon,
    /// Int. J. Eng. Sci. 3 (1965) 47, doi:10.1016/0020-7225(65)90019-4; nu = 1/2).
    [[nodiscard]] double felt(double value) const noexcept
    {
        constexpr double kPerKPa = 1e-3; // N/mm^2
        switch (unit) {
        case MapUnit::YoungKPa:
            return 8.0 / 3.0 * contactRadius_mm * value * kPerKPa;
        case MapUnit::ShearKPa:
            return 8.0 * contactRadius_mm * value * kPerKPa;
        default:
            return value;
        }
    }
};

/// What distinguishes the mapped quantities, in the order of MappedQuantity. haptics::TissueMaps::of has the map of
/// each.
struct QuantityTraits
{
    std::string_view name; ///< in scene files, recordings and reports
    MapUnit unit;          ///< of values without a stated unit
    bool isAboveZero;      ///< zero is not a valid value
};
inline constexpr std::array kMappedQuantities{
    QuantityTraits{"stiffness", MapUnit::Scale, true},
    QuantityTraits{"damping", MapUnit::NsPerMm, false},
    QuantityTraits{"friction", MapUnit::Scale, false},
};
[[nodiscard]] constexpr const QuantityTraits& traitsOf(MappedQuantity quantity) noexcept
{
    return kMappedQuantities[static_cast<std::size_t>(quantity)];
}
/// Names of units in files.
inline constexpr std::array<std::string_view, 5> kMapUnitNames{"scale", "N_per_mm", "Ns_per_mm", "young_kPa",
                                                               "shear_kPa"};
/// @return true if the unit is valid for the quantity.
[[nodiscard]] constexpr bool fits(MappedQuantity quantity, MapUnit unit) noexcept
{
    switch (quantity) {
    case MappedQuantity::Stiffness:
        return unit != MapUnit::NsPerMm;
    case MappedQuantity::Damping:
        return unit == MapUnit::NsPerMm;
    case MappedQuantity::Friction:
        break;
    }
    return unit == MapUnit::Scale;
}

/// Array recognised by name and applied automatically unless the scene overrides the mapping.
struct KnownMap
{
    std::string_view array;
    MappedQuantity quantity;
    MapUnit unit;
};
inline constexpr std::array kKnownMaps{
    KnownMap{"StiffnessScale", MappedQuantity::Stiffness, MapUnit::Scale},
    KnownMap{"Stiffness_N_per_mm", MappedQuantity::Stiffness, MapUnit::NPerMm},
    KnownMap{"Damping_Ns_per_mm", MappedQuantity::Damping, MapUnit::NsPerMm},
    KnownMap{"Friction", MappedQuantity::Friction, MapUnit::Scale},
    KnownMap{"YoungsModulus_kPa", MappedQuantity::Stiffness, MapUnit::YoungKPa},
    KnownMap{"ShearModulus_kPa", MappedQuantity::Stiffness, MapUnit::ShearKPa},
};

} // namespace palpate::core
