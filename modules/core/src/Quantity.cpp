// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/core/Quantity.h"

#include <cmath>

namespace palpate::core {

namespace {

constexpr double kMl_mm3 = 1e3, kLitre_mm3 = 1e6, kCubicMetre_mm3 = 1e9, kCm2_mm2 = 1e2, kSquareMetre_mm2 = 1e6,
                 kMetre_mm = 1e3;

/// Rounds as the text does, so that 999.99 ml is "1 l" and not "1000 ml".
double roundedTo(double value, int digits)
{
    if (value == 0.0 || !std::isfinite(value)) {
        return value;
    }
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1.0 - digits);
    return std::round(value / unit) * unit;
}

} // namespace

Message volumeText(double volume_mm3, int digits)
{
    const double size_mm3 = std::abs(roundedTo(volume_mm3, digits));
    if (size_mm3 >= kCubicMetre_mm3) {
        return {PALPATE_TEXT("%1 m³"), Rounded{volume_mm3 / kCubicMetre_mm3, digits}};
    }
    if (size_mm3 >= 10.0 * kLitre_mm3) { // organs are compared in ml
        return {PALPATE_TEXT("%1 l"), Rounded{volume_mm3 / kLitre_mm3, digits}};
    }
    if (size_mm3 >= 0.1 * kMl_mm3 || size_mm3 == 0.0) {
        return {PALPATE_TEXT("%1 ml"), Rounded{volume_mm3 / kMl_mm3, digits}};
    }
    return {PALPATE_TEXT("%1 mm³"), Rounded{volume_mm3, digits}};
}

Message areaText(double area_mm2, int digits)
{
    const double size_mm2 = std::abs(roundedTo(area_mm2, digits));
    if (size_mm2 >= kSquareMetre_mm2) {
        return {PALPATE_TEXT("%1 m²"), Rounded{area_mm2 / kSquareMetre_mm2, digits}};
    }
    if (size_mm2 >= kCm2_mm2 || size_mm2 == 0.0) {
        return {PALPATE_TEXT("%1 cm²"), Rounded{area_mm2 / kCm2_mm2, digits}};
    }
    return {PALPATE_TEXT("%1 mm²"), Rounded{area_mm2, digits}};
}

Message pathText(double length_mm, int digits)
{
    return std::abs(roundedTo(length_mm, digits)) >= 10.0 * kMetre_mm
               ? Message(PALPATE_TEXT("%1 m"), Rounded{length_mm / kMetre_mm, digits})
               : Message(PALPATE_TEXT("%1 mm"), Rounded{length_mm, digits});
}

} // namespace palpate::core
