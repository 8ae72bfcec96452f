// SPDX-License-Identifier: BSD-3-Clause
#include "repair/Weld.h"

#include "repair/FirstSeen.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <unordered_map>

namespace palpate::geometry {

namespace {

std::vector<std::uint32_t> weldEqual(const std::vector<Vec3>& in, std::vector<Vec3>& out)
{
    const auto hash = [&in](std::uint32_t i) {
        std::uint64_t h = 0;
        for (int axis = 0; axis < 3; ++axis) {
            h = mix(h ^ std::bit_cast<std::uint64_t>(in[i][axis] + 0.0)); // + 0.0 maps -0 to 0
        }
        return h;
    };
    const auto equal = [&in](std::uint32_t a, std::uint32_t b) { return in[a] == in[b]; };
    FirstSeen seen(in.size(), hash, equal);
    std::vector<std::uint32_t> renumbered(in.size());
    out.reserve(in.size());
    for (std::uint32_t i = 0; i < in.size(); ++i) {
        const std::uint32_t first = seen.insert(i);
        if (first == i) {
            renumbered[i] = static_cast<std::uint32_t>(out.size());
            out.push_back(in[i]);
        } else {
            renumbered[i] = renumbered[first];
        }
    }
    return renumbered;
}

/// Representatives in a grid of cells that are at least as wide as the welding distance, so that all candidates for a
/// vertex are in its cell and the 26 cells around.
class CloseVertices
{
  public:
    CloseVertices(const std::vector<Vec3>& in, double within_mm)
        : m_within_mm(within_mm)
    {
        core::Box box;
        for (const Vec3& p : in) {
            box.extend(p);
        }
        m_origin = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.min());
        // A narrower cell would be lost in the rounding of the coordinates.
        const double least_mm = box.isEmpty() ? 1.0 : 0x1p-40 * box.sizes().maxCoeff();
        m_cell_mm = std::max(within_mm, least_mm);
    }
    /// @return index in `out` of the first representative close to `p`; empty if none is
    [[nodiscard]] std::optional<std::uint32_t> find(const Vec3& p, const std::vector<Vec3>& out) const
    {
        std::optional<std::uint32_t> first;
        const Cell middle = cellOf(p);
        for (std::int64_t n = 0; n < 27; ++n) {
            const auto found = m_cells.find({middle[0] + n % 3 - 1, middle[1] + n / 3 % 3 - 1, middle[2] + n / 9 - 1});
            if (found == m_cells.end()) {
                continue;
            }
            for (const std::uint32_t i : found->second) {
                if ((out[i] - p).norm() <= m_within_mm && (!first || i < *first)) {
                    first = i;
                }
            }
        }
        return first;
    }
    void add(const Vec3& p, std::uint32_t i) { m_cells[cellOf(p)].push_back(i); }

  private:
    using Cell = std::array<std::int64_t, 3>;
    struct HashOfCell
    {
        std::size_t operator()(const Cell& cell) const noexcept
        {
            std::uint64_t h = 0;
            for (const std::int64_t number : cell) {
                h = mix(h ^ static_cast<std::uint64_t>(number));
            }
            return h;
        }
    };
    [[nodiscard]] Cell cellOf(const Vec3& p) const
    {
        const Vec3 cells = (p - m_origin) / m_cell_mm;
        return {static_cast<std::int64_t>(std::floor(cells.x())), static_cast<std::int64_t>(std::floor(cells.y())),
                static_cast<std::int64_t>(std::floor(cells.z()))};
    }

    double m_within_mm;
    double m_cell_mm;
    Vec3 m_origin;
    std::unordered_map<Cell, std::vector<std::uint32_t>, HashOfCell> m_cells;
};

} // namespace

std::vector<std::uint32_t> weld(const std::vector<Vec3>& in, double within_mm, std::vector<Vec3>& out)
{
    if (!(within_mm > 0.0)) {
        return weldEqual(in, out);
    }
    CloseVertices close(in, within_mm);
    std::vector<std::uint32_t> renumbered(in.size());
    for (std::size_t i = 0; i < in.size(); ++i) {
        if (const std::optional<std::uint32_t> first = close.find(in[i], out)) {
            renumbered[i] = *first;
        } else {
            renumbered[i] = static_cast<std::uint32_t>(out.size());
            close.add(in[i], renumbered[i]);
            out.push_back(in[i]);
        }
    }
    return renumbered;
}

} // namespace palpate::geometry
