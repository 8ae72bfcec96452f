// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

namespace palpate::session::internal {

// Encoding of numbers and texts in the blobs and checksums of a recording.
static_assert(std::endian::native == std::endian::little, "the format is little-endian");

template<class T>
void put(std::string& out, T value)
{
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    out.append(bytes, sizeof value);
}

/// Normalizes NaN: tables store every NaN as NULL, so its bits must not affect the checksum.
inline void putNumber(std::string& out, double value)
{
    put(out, std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value);
}

inline void put(std::string& out, const core::Vec3& v)
{
    for (const double value : v) {
        putNumber(out, value);
    }
}

inline void putText(std::string& out, std::string_view text)
{
    put(out, static_cast<std::uint64_t>(text.size()));
    out += text;
}

/// Removes a value from the front. @pre `in` is long enough
template<class T>
void take(std::string_view& in, T& value)
{
    std::memcpy(&value, in.data(), sizeof value);
    in.remove_prefix(sizeof value);
}

inline void take(std::string_view& in, core::Vec3& v)
{
    for (double& value : v) {
        take(in, value);
    }
}

} // namespace palpate::session::internal
