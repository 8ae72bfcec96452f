// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate::geometry {

/// Mixes the bits of a number for a hash (the finaliser of MurmurHash3).
[[nodiscard]] inline std::uint64_t mix(std::uint64_t h)
{
    h ^= h >> 33;
    h *= 0xff51afd7ed558ccdull;
    h ^= h >> 33;
    h *= 0xc4ceb9fe1a85ec53ull;
    return h ^ (h >> 33);
}

/// Hash set that maps equal items to the index of the first occurrence.
template<class Hash, class Equal>
class FirstSeen
{
  public:
    FirstSeen(std::size_t n, Hash hash, Equal equal)
        : m_slots(std::bit_ceil(2 * n + 2), kFree)
        , m_hash(hash)
        , m_equal(equal)
    {
    }
    /// @return the first index equal to `i`, or `i` if new.
    std::uint32_t insert(std::uint32_t i)
    {
        for (std::size_t at = m_hash(i) & (m_slots.size() - 1);; at = (at + 1) & (m_slots.size() - 1)) {
            if (m_slots[at] == kFree) {
                m_slots[at] = i;
                return i;
            }
            if (m_equal(m_slots[at], i)) {
                return m_slots[at];
            }
        }
    }

  private:
    static constexpr std::uint32_t kFree = 0xffffffffu;
    std::vector<std::uint32_t> m_slots;
    Hash m_hash;
    Equal m_equal;
};

} // namespace palpate::geometry
