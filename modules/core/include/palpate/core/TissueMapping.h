// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace palpate::core {

/// What of a tissue a map says.
enum class MappedQuantity : std::uint8_t
{
    Stiffness,
    Damping,
    Friction,
};

/// What a map's numbers are.
enum class MapUnit : std::uint8_t
{
    Scale,    ///< times the tissue's own [1]
    NPerMm,   ///< stiffness as felt [N/mm]
    NsPerMm,  ///< damping as felt [N·s/mm]
    YoungKPa, ///< Young's modulus [kPa]; felt by a contact of a radius
    ShearKPa, ///< shear modulus [kPa], a third of Young's; the same
};

/// An array of a mesh, or a volume, that says how a quantity varies over a surface.
struct TissueMapping
{
    MappedQuantity quantity = MappedQuantity::Stiffness;
    MapUnit unit = MapUnit::Scale;
    std::string array;                            ///< name in the mesh file; empty: it is a volume
    std::string file;                             ///< path of a volume; empty: it is an array
    double contactRadius_mm = 5.0;                ///< for moduli
    std::optional<std::array<double, 2>> clamp{}; ///< numbers of the array are taken as at least and at most these

    friend bool operator==(const TissueMapping&, const TissueMapping&) = default;

    /// What a number of the array means to the tick: a scale [1], N/mm or N·s/mm.
    /// @par Source a rigid punch of radius a on an incompressible half-space: k = 2aE / (1 - nu^2) = 8a mu (Sneddon,
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

/// A name in files for each quantity and unit.
inline constexpr std::array<std::string_view, 3> kQuantityNames{"stiffness", "damping", "friction"};
inline constexpr std::array<std::string_view, 5> kMapUnitNames{"scale", "N_per_mm", "Ns_per_mm", "young_kPa",
                                                               "shear_kPa"};
/// @return true where numbers in this unit can say the quantity.
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

/// An array whose name says what it is: it is felt unless the scene says otherwise.
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
