// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One small volume in every supported format: 12 x 3 x 2 voxels of 1 + i + 20 j + 100 k, 1 x 2 x 3 mm apart, the first
// at (10, 20, 30) mm in LPS.
#include "Samples.h"

#include <palpate/core/Types.h>

#include <QByteArray>

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace palpate::test {

struct VolumeSample
{
    std::string name; ///< file name
    std::string bytes;
    std::string dataName{}, data{}; ///< companion file with the voxels; empty if there is none
};

inline float volumeValue(int i, int j, int k)
{
    return 1.0F + static_cast<float>(i + 20 * j + 100 * k);
}

/// @return position of a voxel in LPS [mm]
inline core::Vec3 volumePlace(int i, int j, int k)
{
    return {10.0 + i, 20.0 + 2.0 * j, 30.0 + 3.0 * k};
}

/// Returns the voxels in file order, as `T`.
template<class T = float>
std::string volumeNumbers()
{
    std::string out;
    for (int k = 0; k < 2; ++k) {
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 12; ++i) {
                appendRaw(out, static_cast<T>(volumeValue(i, j, k)));
            }
        }
    }
    return out;
}

/// @return a zlib stream
inline std::string zlibbed(const std::string& bytes)
{
    return qCompress(QByteArray::fromStdString(bytes)).mid(4).toStdString();
}

/// @return a gzip file
inline std::string gzipped(const std::string& bytes)
{
    std::uint32_t crc = ~0U;
    for (const char c : bytes) {
        crc ^= static_cast<std::uint8_t>(c);
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
        }
    }
    const std::string stream = zlibbed(bytes);
    std::string out("\x1f\x8b\x08\0\0\0\0\0\0\x03", 10);
    out += stream.substr(2, stream.size() - 6); // without the header and checksum of zlib
    appendRaw(out, ~crc);
    appendRaw(out, static_cast<std::uint32_t>(bytes.size()));
    return out;
}

inline std::string metaHeader(const std::string& type, const std::string& data, const std::string& more = "")
{
    return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n" + more +
           "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 10 20 30\nElementSpacing = 1 2 3\nDimSize = 12 3 2\n"
           "ElementType = " +
           type + "\nElementDataFile = " + data + "\n";
}

inline std::string nrrdHeader(const std::string& encoding, const std::string& more = "")
{
    return "NRRD0004\ntype: float\ndimension: 3\nspace: left-posterior-superior\nsizes: 12 3 2\n"
           "space directions: (1,0,0) (0,2,0) (0,0,3)\nkinds: domain domain domain\nendian: little\nencoding: " +
           encoding + "\nspace origin: (10,20,30)\n" + more + "\n";
}

/// Returns the header of a NIfTI file whose matrix maps to RAS.
inline std::string niftiHeader()
{
    std::string out(352, '\0');
    const auto put = [&out](std::size_t at, auto value) { std::memcpy(&out[at], &value, sizeof(value)); };
    put(0, std::int32_t{348});
    const std::array<std::int16_t, 8> dim{3, 12, 3, 2, 1, 1, 1, 1};
    put(40, dim);
    put(70, std::int16_t{16}); // float
    put(72, std::int16_t{32});
    const std::array<float, 8> pixdim{1, 1, 2, 3, 1, 1, 1, 1};
    put(76, pixdim);
    put(108, 352.0F);
    put(254, std::int16_t{1});
    const std::array<float, 12> toRas{-1, 0, 0, -10, 0, -2, 0, -20, 0, 0, 3, 30};
    put(280, toRas);
    std::memcpy(&out[344], "n+1", 4);
    return out;
}

/// Returns the header of a NIfTI-2 file, which has 64-bit counts.
inline std::string niftiWideHeader(std::int64_t numbersOfOne = 1, std::int64_t across = 12)
{
    std::string out(544, '\0');
    const auto put = [&out](std::size_t at, auto value) { std::memcpy(&out[at], &value, sizeof(value)); };
    put(0, std::int32_t{540});
    put(4, std::array<char, 8>{'n', '+', '2', '\0', '\r', '\n', '\x1a', '\n'});
    put(12, std::int16_t{16}); // float
    put(14, std::int16_t{32});
    put(16, std::array<std::int64_t, 8>{5, across, 3, 2, 1, numbersOfOne, 1, 1});
    put(104, std::array<double, 8>{1, 1, 2, 3, 1, 1, 1, 1});
    put(168, std::int64_t{544});
    put(348, std::int32_t{1});
    put(400, std::array<double, 12>{-1, 0, 0, -10, 0, -2, 0, -20, 0, 0, 3, 30});
    return out;
}

/// Returns a VTI with the voxels as raw data behind the XML.
inline std::string vtiAppended(const std::string& numbers)
{
    std::string out =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "<ImageData WholeExtent=\"0 11 0 2 0 1\" Origin=\"10 20 30\" Spacing=\"1 2 3\">\n"
        "<Piece Extent=\"0 11 0 2 0 1\">\n<PointData Scalars=\"s\"><DataArray type=\"Float32\" Name=\"s\" "
        "format=\"appended\" offset=\"0\"/></PointData>\n</Piece>\n</ImageData>\n"
        "<AppendedData encoding=\"raw\">\n_";
    appendRaw(out, static_cast<std::uint32_t>(numbers.size()));
    return out + numbers + "\n</AppendedData>\n</VTKFile>\n";
}

inline std::string vtiText(const std::string& numbers, const std::string& extent = "0 11 0 2 0 1")
{
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
           "<ImageData WholeExtent=\"" +
           extent + "\" Origin=\"10 20 30\" Spacing=\"1 2 3\">\n<Piece Extent=\"" + extent +
           "\">\n<PointData Scalars=\"s\"><DataArray type=\"Float32\" Name=\"s\" format=\"ascii\">" + numbers +
           "</DataArray></PointData>\n</Piece>\n</ImageData>\n</VTKFile>\n";
}

/// Returns a sample of each format.
inline std::vector<VolumeSample> volumeSamples()
{
    const std::string floats = volumeNumbers();
    std::string text;
    for (int n = 0; n < 72; ++n) {
        text += std::to_string(static_cast<int>(volumeValue(n % 12, n / 12 % 3, n / 36))) + " ";
    }
    const std::string packed = zlibbed(floats);
    return {{"raw.mha", metaHeader("MET_FLOAT", "LOCAL", "CompressedData = False\n") + floats},
            {"short.mha", metaHeader("MET_SHORT", "LOCAL") + volumeNumbers<std::int16_t>()},
            {"packed.mha",
             metaHeader("MET_FLOAT", "LOCAL",
                        "CompressedData = True\nCompressedDataSize = " + std::to_string(packed.size()) + "\n") +
                 packed},
            {"beside.mhd", metaHeader("MET_FLOAT", "beside.raw"), "beside.raw", floats},
            {"raw.nrrd", nrrdHeader("raw") + floats},
            {"packed.nrrd", nrrdHeader("gzip") + gzipped(floats)},
            {"beside.nhdr", nrrdHeader("raw", "data file: beside.img\n"), "beside.img", floats},
            {"plain.nii", niftiHeader() + floats},
            {"wide.nii", niftiWideHeader() + floats},
            {"packed.nii.gz", gzipped(niftiHeader() + floats)},
            {"text.vti", vtiText(text)},
            {"appended.vti", vtiAppended(floats)}};
}

} // namespace palpate::test
