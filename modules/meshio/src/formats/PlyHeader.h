// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "guard/PreScan.h"

#include <cstdint>
#include <string>
#include <vector>

namespace palpate::meshio::internal {

enum class PlyType : std::uint8_t
{
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Float32,
    Float64
};

[[nodiscard]] std::size_t plySize(PlyType type);

struct PlyProperty
{
    std::string name;
    PlyType type = PlyType::Float32;
    bool isList = false;
    PlyType countType = PlyType::UInt8; ///< of a list
};

struct PlyElement
{
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
    std::uint64_t line = 0; ///< of the declaration
};

enum class PlyEncoding : std::uint8_t
{
    Ascii,
    LittleEndian,
    BigEndian
};

struct PlyHeader
{
    PlyEncoding encoding = PlyEncoding::Ascii;
    std::vector<PlyElement> elements;
    std::size_t bodyBegin = 0;  ///< [bytes]
    std::uint64_t bodyLine = 0; ///< lines before the body
};

/// Reads a PLY header and checks that the declared counts fit into the remaining bytes; records the `SPACE=` comment.
[[nodiscard]] core::Result<PlyHeader> readPlyHeader(std::string_view bytes, const ScanContext& context, PreScan& scan);

} // namespace palpate::meshio::internal
