// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <cmath>
#include <cstdint>

namespace palpate::adversary {

using core::Vec3;

/// Random numbers from a seed, the same with every standard library.
/// @par Source
/// The generator "xorshift64*": Vigna, ACM Trans. Math. Softw. 42 (2016) 30.
class Chance
{
  public:
    explicit Chance(std::uint64_t seed)
        : m_state((seed + 1) * 0xa0761d6478bd642full | 1u)
    {
        for (int i = 0; i < 8; ++i) {
            (void)bits();
        }
    }
    std::uint64_t bits()
    {
        m_state ^= m_state >> 12;
        m_state ^= m_state << 25;
        m_state ^= m_state >> 27;
        return m_state * 0x2545f4914f6cdd1dull;
    }
    /// Returns a number in [0, 1).
    double share() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * share(); }
    /// Returns a log-uniform number.
    double magnitude(double low, double high) { return low * std::pow(high / low, share()); }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() >> 16) % count; }
    int whole(int low, int high) { return low + static_cast<int>(below(static_cast<std::size_t>(high - low + 1))); }
    bool is(double probability) { return share() < probability; }
    Vec3 inCube()
    {
        const double x = between(-1, 1), y = between(-1, 1);
        return {x, y, between(-1, 1)};
    }
    Vec3 direction()
    {
        for (;;) {
            const Vec3 v = inCube();
            if (v.squaredNorm() <= 1.0 && v.squaredNorm() > 1e-4) {
                return v.normalized();
            }
        }
    }
    /// Returns an approximately normal vector, each coordinate with variance 1.
    Vec3 noise() { return inCube() + inCube() + inCube(); }

  private:
    std::uint64_t m_state;
};

} // namespace palpate::adversary
