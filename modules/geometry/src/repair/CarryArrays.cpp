// SPDX-License-Identifier: BSD-3-Clause
#include "CarryArrays.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::geometry {

namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
constexpr float kMixed = 0.1F; ///< relative tolerance of differing values at one place

MeshArray weldArray(const MeshArray& input, std::span<const std::uint32_t> weldedTo, std::size_t vertices,
                    std::size_t& mixed)
{
    struct Place
    {
        double sum = 0.0;
        float least = std::numeric_limits<float>::infinity(), most = -least;
        std::uint32_t count = 0;
    };
    std::vector<Place> places(vertices);
    for (std::size_t i = 0; i < weldedTo.size(); ++i) {
        const float value = input.values[i];
        if (std::isfinite(value)) {
            Place& place = places[weldedTo[i]];
            place.sum += double{value};
            place.least = std::min(place.least, value);
            place.most = std::max(place.most, value);
            ++place.count;
        }
    }
    MeshArray out{input.name, false, {}};
    out.values.reserve(vertices);
    for (const Place& place : places) {
        const float largest = std::max(std::abs(place.least), std::abs(place.most));
        mixed += place.count > 1 && place.most - place.least > kMixed * largest ? 1 : 0;
        out.values.push_back(place.count == 0 ? kUnknown : static_cast<float>(place.sum / place.count));
    }
    return out;
}

} // namespace

std::vector<MeshArray> weldArrays(const std::vector<MeshArray>& input, std::span<const std::uint32_t> weldedTo,
                                  std::size_t vertices, std::size_t& mixed)
{
    std::vector<MeshArray> out;
    for (const MeshArray& array : input) {
        out.push_back(array.isPerTriangle ? array : weldArray(array, weldedTo, vertices, mixed));
    }
    return out;
}

void keepTriangles(std::vector<MeshArray>& arrays, std::span<const std::uint32_t> source)
{
    for (MeshArray& array : arrays) {
        if (array.isPerTriangle) {
            for (std::size_t i = 0; i < source.size(); ++i) {
                array.values[i] = array.values[source[i]]; // safe in place: `source` is ascending
            }
            array.values.resize(source.size());
        }
    }
}

} // namespace palpate::geometry
