// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Samples.h"
#include "Volumes.h"

#include <QByteArray>

#include <array>
#include <bit>
#include <cstdint>
#include <string>

namespace palpate::test {

/// A box of twelve triangles from (10, 20, 30) to (50, 50, 50), normals outwards, in the formats of other programs.
inline constexpr std::array<std::array<int, 3>, 8> kBoxPoints{
    {{10, 20, 30}, {50, 20, 30}, {50, 50, 30}, {10, 50, 30}, {10, 20, 50}, {50, 20, 50}, {50, 50, 50}, {10, 50, 50}}};
inline constexpr std::array<std::array<int, 3>, 12> kBoxFaces{{{0, 3, 2},
                                                               {0, 2, 1},
                                                               {4, 5, 6},
                                                               {4, 6, 7},
                                                               {0, 1, 5},
                                                               {0, 5, 4},
                                                               {1, 2, 6},
                                                               {1, 6, 5},
                                                               {2, 3, 7},
                                                               {2, 7, 6},
                                                               {3, 0, 4},
                                                               {3, 4, 7}}};

/// Returns the rows of numbers, each after `before`.
template<class Rows>
std::string rowsOf(const Rows& rows, const std::string& before = "")
{
    std::string out;
    for (const auto& row : rows) {
        out += before + std::to_string(row[0]) + " " + std::to_string(row[1]) + " " + std::to_string(row[2]) + "\n";
    }
    return out;
}

inline std::string offBox(const std::string& counts = "8 12 0")
{
    return "OFF\n" + counts + "\n" + rowsOf(kBoxPoints) + rowsOf(kBoxFaces, "3 ");
}

/// Returns the box as MNI's polygons, with one colour for all.
inline std::string mniBox(const std::string& points = "8", const std::string& polygons = "12")
{
    std::string out = "P 0.3 0.7 0.5 100 1 " + points + "\n" + rowsOf(kBoxPoints) + "\n";
    for (std::size_t i = 0; i < kBoxPoints.size(); ++i) {
        out += "0 0 1\n";
    }
    out += "\n" + polygons + "\n0 1 1 1 1\n\n";
    for (std::size_t i = 1; i <= kBoxFaces.size(); ++i) {
        out += std::to_string(3 * i) + " ";
    }
    return out + "\n\n" + rowsOf(kBoxFaces);
}

inline void appendBig(std::string& out, std::uint32_t word)
{
    for (const int shift : {24, 16, 8, 0}) {
        out += static_cast<char>(word >> shift & 0xffU);
    }
}

inline std::string freeSurferBox(std::uint32_t points = 8, std::uint32_t triangles = 12)
{
    std::string out = "\xff\xff\xfe"
                      "created by test on Thu Jan  1 00:00:00 1970\n\n";
    appendBig(out, points);
    appendBig(out, triangles);
    for (const auto& p : kBoxPoints) {
        for (const int coordinate : p) {
            appendBig(out, std::bit_cast<std::uint32_t>(static_cast<float>(coordinate)));
        }
    }
    for (const auto& face : kBoxFaces) {
        for (const int corner : face) {
            appendBig(out, static_cast<std::uint32_t>(corner));
        }
    }
    return out;
}

/// Returns the description of the volume that FreeSurfer writes behind a surface.
inline std::string freeSurferVolume(const std::string& valid = "1")
{
    std::string out;
    for (const std::uint32_t tag : {2U, 0U, 20U}) {
        appendBig(out, tag);
    }
    return out + "valid = " + valid + "  # volume info valid\nfilename = a.mgz\nvolume = 256 256 256\n" +
           "voxelsize = 1.0e+00 1.0e+00 1.0e+00\nxras   = -1 0 0\nyras   = 0 0 -1\nzras   = 0 1 0\n" +
           "cras   = 1.000000000000000e+00 2 -3\n";
}

enum class Gifti
{
    Ascii,
    Base64,
    Packed
};

/// Returns the bytes of an array, as big-endian numbers when base64 alone.
inline std::string giftiData(Gifti kind, bool areFloats)
{
    if (kind == Gifti::Ascii) {
        return areFloats ? rowsOf(kBoxPoints) : rowsOf(kBoxFaces);
    }
    std::string bytes;
    const auto append = [&](int number) {
        const auto word =
            areFloats ? std::bit_cast<std::uint32_t>(static_cast<float>(number)) : static_cast<std::uint32_t>(number);
        if (kind == Gifti::Packed) {
            appendRaw(bytes, word);
        } else {
            appendBig(bytes, word);
        }
    };
    for (std::size_t i = 0; i < (areFloats ? 3 * kBoxPoints.size() : 3 * kBoxFaces.size()); ++i) {
        append(areFloats ? kBoxPoints[i / 3][i % 3] : kBoxFaces[i / 3][i % 3]);
    }
    const std::string stored = kind == Gifti::Packed ? zlibbed(bytes) : bytes;
    return QByteArray(stored.data(), static_cast<qsizetype>(stored.size())).toBase64().toStdString();
}

inline std::string giftiArray(Gifti kind, bool areFloats, const std::string& more = "", const std::string& tuples = "")
{
    const std::string count = tuples.empty() ? (areFloats ? "8" : "12") : tuples;
    const std::string encoding = kind == Gifti::Ascii    ? "ASCII"
                                 : kind == Gifti::Base64 ? "Base64Binary"
                                                         : "GZipBase64Binary";
    return "<DataArray Intent=\"NIFTI_INTENT_" + std::string(areFloats ? "POINTSET" : "TRIANGLE") +
           "\" DataType=\"NIFTI_TYPE_" + (areFloats ? "FLOAT32" : "INT32") +
           "\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"2\" Dim0=\"" + count +
           "\" Dim1=\"3\" Encoding=\"" + encoding + "\" Endian=\"" +
           (kind == Gifti::Base64 ? "BigEndian" : "LittleEndian") +
           "\" ExternalFileName=\"\" ExternalFileOffset=\"\"><MetaData/>" + more + "<Data>" +
           giftiData(kind, areFloats) + "</Data></DataArray>\n";
}

inline std::string giftiFile(const std::string& arrays)
{
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE GIFTI SYSTEM "
           "\"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n<GIFTI Version=\"1.0\" "
           "NumberOfDataArrays=\"2\">\n<MetaData/><LabelTable/>\n" +
           arrays + "</GIFTI>\n";
}

inline std::string giftiBox(Gifti kind, const std::string& more = "")
{
    return giftiFile(giftiArray(kind, true, more) + giftiArray(kind, false));
}

} // namespace palpate::test
