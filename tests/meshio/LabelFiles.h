// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Writers of label maps in each format.
#include "Volumes.h"

#include <palpate/core/Numbers.h>
#include <palpate/core/Types.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace palpate::test {

/// A label map in LPS. Steps and origin are exact in float, so that every format stores the same place.
struct LabelGrid
{
    std::array<int, 3> size{};
    Eigen::Matrix3d steps = Eigen::Matrix3d::Identity(); ///< columns: from a voxel to the next [mm]
    core::Vec3 origin = core::Vec3::Zero();              ///< centre of the first voxel [mm]
    int layers = 1;
    std::vector<int> values; ///< layer by layer, x fastest

    [[nodiscard]] std::size_t voxels() const { return static_cast<std::size_t>(size[0] * size[1] * size[2]); }
    [[nodiscard]] core::Vec3 place(int i, int j, int k) const { return steps * core::Vec3(i, j, k) + origin; }
    int& at(int i, int j, int k, int layer = 0)
    {
        return values[static_cast<std::size_t>(i + size[0] * (j + size[1] * (k + size[2] * layer)))];
    }
    /// Sets all voxels of a layer by the place of their centres.
    void fill(const std::function<int(const core::Vec3& place)>& labelAt, int layer = 0)
    {
        values.resize(voxels() * static_cast<std::size_t>(layers), 0);
        for (int k = 0; k < size[2]; ++k) {
            for (int j = 0; j < size[1]; ++j) {
                for (int i = 0; i < size[0]; ++i) {
                    at(i, j, k, layer) = labelAt(place(i, j, k));
                }
            }
        }
    }
};

/// @return axes turned by 20° about (1, 2, 3) with these voxel sizes, rounded to float
inline Eigen::Matrix3d obliqueSteps(const core::Vec3& voxel_mm)
{
    const Eigen::AngleAxisd turn(20.0 * std::numbers::pi / 180.0, core::Vec3(1, 2, 3).normalized());
    const Eigen::Matrix3d steps = turn.toRotationMatrix() * voxel_mm.asDiagonal();
    return steps.cast<float>().cast<double>();
}

/// @return the values in file order as `T`; the layers of a voxel one after the other if interleaved
template<class T>
std::string labelNumbers(const LabelGrid& grid, bool isBigEndian = false, bool isInterleaved = false)
{
    std::string out;
    for (std::size_t n = 0; n < grid.values.size(); ++n) {
        const auto layers = static_cast<std::size_t>(grid.layers);
        const std::size_t from = isInterleaved ? n / layers + grid.voxels() * (n % layers) : n;
        const T value = static_cast<T>(grid.values[from]);
        std::array<char, sizeof(T)> raw{};
        std::memcpy(raw.data(), &value, sizeof(T));
        if (isBigEndian) {
            std::reverse(raw.begin(), raw.end());
        }
        out.append(raw.data(), raw.size());
    }
    return out;
}

inline std::string words(const core::Vec3& v, const char* between = " ")
{
    std::string out;
    for (int i = 0; i < 3; ++i) {
        out += i == 0 ? "" : between;
        core::appendNumber(out, v[i]);
    }
    return out;
}

/// @param more  further lines, as fields of 3D Slicer
inline std::string labelNrrd(const LabelGrid& grid, const std::string& type, const std::string& encoding,
                             const std::string& more = "", bool isRas = false, bool isInterleaved = false)
{
    const core::Vec3 sign = isRas ? core::Vec3(-1, -1, 1) : core::Vec3(1, 1, 1);
    std::string sizes, directions;
    for (int axis = 0; axis < 3; ++axis) {
        sizes.append(" ").append(std::to_string(grid.size[static_cast<std::size_t>(axis)]));
        directions.append(" (").append(words(sign.cwiseProduct(grid.steps.col(axis)), ",")).append(")");
    }
    std::string kinds = " domain domain domain";
    if (grid.layers > 1) {
        const std::string count = std::string(" ").append(std::to_string(grid.layers));
        sizes = isInterleaved ? count + sizes : sizes + count;
        directions = isInterleaved ? std::string(" none").append(directions) : directions.append(" none");
        kinds = isInterleaved ? " list domain domain domain" : " domain domain domain list";
    }
    return "NRRD0004\n# a label map\ntype: " + type + "\ndimension: " + (grid.layers > 1 ? "4" : "3") +
           "\nspace: " + (isRas ? "right-anterior-superior" : "left-posterior-superior") + "\nsizes:" + sizes +
           "\nspace directions:" + directions + "\nkinds:" + kinds + "\nendian: little\nencoding: " + encoding +
           "\nspace origin: (" + words(sign.cwiseProduct(grid.origin), ",") + ")\n" + more + "\n";
}

inline std::string labelMeta(const LabelGrid& grid, const std::string& type, const std::string& more = "")
{
    std::string matrix;
    core::Vec3 spacing;
    for (int axis = 0; axis < 3; ++axis) { // the power of two keeps the product exact
        spacing[axis] = std::exp2(std::round(std::log2(grid.steps.col(axis).norm())));
        matrix.append(" ").append(words(grid.steps.col(axis) / spacing[axis]));
    }
    return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n" + more +
           "TransformMatrix =" + matrix + "\nOffset = " + words(grid.origin) + "\nElementSpacing = " + words(spacing) +
           "\nDimSize = " + std::to_string(grid.size[0]) + " " + std::to_string(grid.size[1]) + " " +
           std::to_string(grid.size[2]) + "\nElementType = " + type + "\nElementDataFile = LOCAL\n";
}

/// @return the header of a NIfTI file with an sform, and an extension with `xml` if not empty
inline std::string labelNifti(const LabelGrid& grid, std::int16_t datatype, bool isBigEndian = false,
                              const std::string& xml = "")
{
    std::string extension;
    if (!xml.empty()) {
        const std::size_t size = (xml.size() + 8 + 15) / 16 * 16;
        appendRaw(extension, static_cast<std::int32_t>(size));
        appendRaw(extension, std::int32_t{0});
        extension += xml;
        extension.resize(size, '\0');
    }
    std::string out(352, '\0');
    const auto put = [&](std::size_t at, auto value) {
        std::array<char, sizeof(value)> raw{};
        std::memcpy(raw.data(), &value, sizeof(value));
        if (isBigEndian) {
            std::reverse(raw.begin(), raw.end());
        }
        std::memcpy(&out[at], raw.data(), raw.size());
    };
    put(0, std::int32_t{348});
    put(40, static_cast<std::int16_t>(grid.layers > 1 ? 4 : 3));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        put(42 + 2 * axis, static_cast<std::int16_t>(grid.size[axis]));
        put(80 + 4 * axis, static_cast<float>(grid.steps.col(static_cast<Eigen::Index>(axis)).norm()));
    }
    put(48, static_cast<std::int16_t>(grid.layers));
    put(70, datatype);
    put(76, 1.0F);
    put(108, static_cast<float>(352 + extension.size()));
    put(254, std::int16_t{1});
    for (Eigen::Index row = 0; row < 3; ++row) {
        const double sign = row < 2 ? -1.0 : 1.0;
        for (Eigen::Index column = 0; column < 3; ++column) {
            put(280 + static_cast<std::size_t>(16 * row + 4 * column),
                static_cast<float>(sign * grid.steps(row, column)));
        }
        put(280 + static_cast<std::size_t>(16 * row + 12), static_cast<float>(sign * grid.origin[row]));
    }
    std::memcpy(&out[344], "n+1", 4);
    if (!xml.empty()) {
        out[348] = 1;
    }
    return out + extension;
}

/// @return the header of a NIfTI-2 file with an sform
inline std::string labelNiftiWide(const LabelGrid& grid, std::int16_t datatype, bool isBigEndian = false)
{
    std::string out(544, '\0');
    const auto put = [&](std::size_t at, auto value) {
        std::array<char, sizeof(value)> raw{};
        std::memcpy(raw.data(), &value, sizeof(value));
        if (isBigEndian) {
            std::reverse(raw.begin(), raw.end());
        }
        std::memcpy(&out[at], raw.data(), raw.size());
    };
    put(0, std::int32_t{540});
    std::memcpy(&out[4], "n+2\0\r\n\x1a\n", 8);
    put(12, datatype);
    put(16, std::int64_t{grid.layers > 1 ? 4 : 3});
    for (std::size_t axis = 0; axis < 3; ++axis) {
        put(24 + 8 * axis, std::int64_t{grid.size[axis]});
        put(112 + 8 * axis, grid.steps.col(static_cast<Eigen::Index>(axis)).norm());
    }
    put(48, std::int64_t{grid.layers});
    put(104, 1.0);
    put(168, std::int64_t{544});
    put(348, std::int32_t{1});
    for (Eigen::Index row = 0; row < 3; ++row) {
        const double sign = row < 2 ? -1.0 : 1.0;
        for (Eigen::Index column = 0; column < 3; ++column) {
            put(400 + static_cast<std::size_t>(32 * row + 8 * column), double{sign * grid.steps(row, column)});
        }
        put(400 + static_cast<std::size_t>(32 * row + 24), double{sign * grid.origin[row]});
    }
    return out;
}

} // namespace palpate::test
