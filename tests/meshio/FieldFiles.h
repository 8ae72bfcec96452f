// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Writers of displacement fields in each format, as ITK writes them.
#include "LabelFiles.h"

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace palpate::test {

/// A displacement field in LPS. Its axes are those of the patient in another order, with steps that are exact in float.
struct FieldSample
{
    std::array<int, 3> size{40, 44, 48};
    Eigen::Matrix3d steps{{0.0, 0.0, 2.0}, {-2.5, 0.0, 0.0}, {0.0, 3.0, 0.0}};
    core::Vec3 origin{-47.0, 48.75, -64.5};
    std::function<core::Vec3(const core::Vec3&)> u; ///< displacement at a position [mm]

    [[nodiscard]] core::Vec3 place(int i, int j, int k) const { return steps * core::Vec3(i, j, k) + origin; }
    /// Returns the numbers in file order.
    /// @param signs  by which the components are multiplied
    template<class T = float>
    [[nodiscard]] std::string numbers(bool isInterleaved, const core::Vec3& signs = core::Vec3::Ones()) const
    {
        std::vector<core::Vec3> all;
        for (int k = 0; k < size[2]; ++k) {
            for (int j = 0; j < size[1]; ++j) {
                for (int i = 0; i < size[0]; ++i) {
                    all.emplace_back(signs.cwiseProduct(u(place(i, j, k))));
                }
            }
        }
        std::string out;
        for (std::size_t n = 0; n < 3 * all.size(); ++n) {
            const std::size_t voxel = isInterleaved ? n / 3 : n % all.size();
            const auto component = static_cast<Eigen::Index>(isInterleaved ? n % 3 : n / all.size());
            appendRaw(out, static_cast<T>(all[voxel][component]));
        }
        return out;
    }
};

inline std::string vectorText(const core::Vec3& v, const char* between)
{
    std::string out;
    for (const double number : v) {
        out += out.empty() ? "" : between;
        core::appendNumber(out, number);
    }
    return out;
}

/// @param isRas  axes of the file; the components are in these as well
/// @param more  further lines of the header
inline std::string fieldNrrd(const FieldSample& field, bool isRas = false, const std::string& encoding = "raw",
                             const std::string& kind = "vector", const std::string& more = "")
{
    const core::Vec3 signs = isRas ? core::Vec3(-1, -1, 1) : core::Vec3::Ones();
    std::string out = std::string("NRRD0005\ntype: float\ndimension: 4\nspace: ") +
                      (isRas ? "right-anterior-superior" : "left-posterior-superior") + "\nsizes: 3";
    std::string directions = "none";
    for (std::size_t axis = 0; axis < 3; ++axis) {
        out += " " + std::to_string(field.size[axis]);
        directions +=
            " (" + vectorText(signs.cwiseProduct(field.steps.col(static_cast<Eigen::Index>(axis))), ",") + ")";
    }
    out += "\nspace directions: " + directions + "\nkinds: " + kind +
           " domain domain domain\nendian: little\nencoding: " + encoding + "\nspace origin: (" +
           vectorText(signs.cwiseProduct(field.origin), ",") + ")\n" + more + "\n";
    const std::string numbers = field.numbers(true, signs);
    return out + (encoding == "gzip" ? gzipped(numbers) : numbers);
}

inline std::string fieldMeta(const FieldSample& field, const std::string& channels = "3", bool isDouble = false)
{
    core::Vec3 spacing = field.steps.colwise().norm();
    std::string matrix, sizes;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        matrix += " " + vectorText(field.steps.col(axis) / spacing[axis], " ");
        sizes += " " + std::to_string(field.size[static_cast<std::size_t>(axis)]);
    }
    return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = False\n"
           "TransformMatrix =" +
           matrix + "\nOffset = " + vectorText(field.origin, " ") + "\nElementSpacing = " + vectorText(spacing, " ") +
           "\nDimSize =" + sizes + "\nElementNumberOfChannels = " + channels +
           "\nElementType = " + (isDouble ? "MET_DOUBLE" : "MET_FLOAT") + "\nElementDataFile = LOCAL\n" +
           (isDouble ? field.numbers<double>(true) : field.numbers(true));
}

/// @param intent  1006: components in RAS; 1007: in LPS, as ITK writes vectors
inline std::string fieldNifti(const FieldSample& field, int intent = 1007, bool isPlaced = true)
{
    std::string out(352, '\0');
    const auto put = [&out](std::size_t at, auto value) { std::memcpy(&out[at], &value, sizeof(value)); };
    put(0, std::int32_t{348});
    std::array<std::int16_t, 8> dim{5, 0, 0, 0, 1, 3, 1, 1};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        dim[axis + 1] = static_cast<std::int16_t>(field.size[axis]);
    }
    put(40, dim);
    put(68, static_cast<std::int16_t>(intent));
    put(70, std::int16_t{16});
    put(72, std::int16_t{32});
    put(76, std::array<float, 8>{1, 2.5F, 3.0F, 2.0F, 1, 1, 1, 1});
    put(108, 352.0F);
    put(123, std::int8_t{2}); // mm
    put(254, std::int16_t{static_cast<std::int16_t>(isPlaced ? 1 : 0)});
    Eigen::Matrix<double, 3, 4> toRas;
    toRas << field.steps, field.origin;
    toRas.topRows<2>() *= -1.0;
    std::array<float, 12> rows{};
    for (std::size_t n = 0; n < rows.size(); ++n) {
        rows[n] = static_cast<float>(toRas(static_cast<Eigen::Index>(n / 4), static_cast<Eigen::Index>(n % 4)));
    }
    put(280, rows);
    std::memcpy(&out[344], "n+1", 4);
    return out + field.numbers(false, intent == 1006 ? core::Vec3(-1, -1, 1) : core::Vec3::Ones());
}

/// The same field in each format.
struct FieldFile
{
    std::string name, bytes;
};
inline std::vector<FieldFile> fieldFiles(const FieldSample& field)
{
    return {{"u.nrrd", fieldNrrd(field)},
            {"packed.nrrd", fieldNrrd(field, false, "gzip", "covariant-vector")},
            {"ras.nrrd", fieldNrrd(field, true)},
            {"u.mha", fieldMeta(field)},
            {"double.mha", fieldMeta(field, "3", true)},
            {"u.nii", fieldNifti(field)},
            {"ras.nii", fieldNifti(field, 1006)},
            {"packed.nii.gz", gzipped(fieldNifti(field))}};
}

} // namespace palpate::test
