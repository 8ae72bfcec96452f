// SPDX-License-Identifier: BSD-3-Clause
#include "lumps/LumpGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace palpate::evaluation {

namespace {

constexpr double kPi = std::numbers::pi;

/// Divides an interval into steps of the local length `size`; the last step is up to half longer.
template<class Size>
std::vector<double> march(double from, double to, const Size& size)
{
    std::vector<double> values{from};
    const double direction = to > from ? 1.0 : -1.0;
    while (true) {
        const double step = size(values.back());
        if (std::abs(to - values.back()) <= 1.5 * step) {
            values.push_back(to);
            return values;
        }
        values.push_back(values.back() + direction * step);
    }
}

/// Grid lines in bispherical coordinates.
struct Lines
{
    std::vector<double> xi;  ///< 0 to pi; the punch covers the largest values
    std::vector<double> eta; ///< 0 is the surface
    double focus = 0.0;      ///< depth of the focus, eta = infinity
    double rim = 0.0;        ///< xi of the rim of the punch
    std::size_t lump = 0;    ///< index of the eta line on the sphere
    std::size_t far = 0;     ///< index of the eta line below which the first cell is omitted
};

Lines linesOf(double sphereRadius, double cover, const LumpResolution& fineness)
{
    constexpr double kInside = 3.5, kLargest = 0.35; // eta; the region closer to the focus is a single ring of cells
    Lines lines;
    lines.focus = std::sqrt(cover * (cover + 2.0 * sphereRadius));
    lines.rim = 2.0 * std::atan(lines.focus);
    const double atLump = std::asinh(lines.focus / sphereRadius);
    const double far = 2.0 * lines.focus / fineness.farEdge;
    const double atRim = fineness.rimEdge * (1.0 - std::cos(lines.rim)) / lines.focus;
    const double growth = fineness.growth - 1.0;

    lines.eta = march(0.0, atLump, [&](double eta) {
        return std::min(atLump / fineness.acrossCover, std::max(std::min(far, atRim), growth * eta));
    });
    lines.lump = lines.eta.size() - 1;
    const double last = lines.eta[lines.lump] - lines.eta[lines.lump - 1];
    const auto inside = march(atLump, std::max(atLump + kInside, kInside),
                              [&](double eta) { return std::min(kLargest, last + 0.6 * growth * (eta - atLump)); });
    lines.eta.insert(lines.eta.end(), inside.begin() + 1, inside.end());

    const auto size = [&](double xi) {
        const double finest = 0.5 * std::min(far, atRim);
        return std::max(finest,
                        std::min({fineness.angle, atRim + 0.8 * growth * std::abs(xi - lines.rim),
                                  (kPi - lines.rim) / fineness.acrossCover + growth * (kPi - xi), 0.8 * growth * xi}));
    };
    const auto outwards = march(lines.rim, far, size), inwards = march(lines.rim, kPi, size);
    lines.xi = {0.0};
    lines.xi.insert(lines.xi.end(), outwards.rbegin(), outwards.rend());
    lines.xi.insert(lines.xi.end(), inwards.begin() + 1, inwards.end());
    while (lines.eta[lines.far] < 0.99 * far) {
        ++lines.far;
    }
    return lines;
}

/// Creates nodes on first use by a cell.
class GridBuilder
{
  public:
    explicit GridBuilder(Lines lines)
        : m_lines(std::move(lines))
        , m_columns(2 * m_lines.xi.size() - 1)
        , m_rows(2 * m_lines.eta.size() - 1)
        , m_index(m_columns * m_rows, kNone)
    {
    }

    LumpGrid build()
    {
        for (std::size_t j = 0; j + 1 < m_lines.eta.size(); ++j) {
            for (std::size_t i = j < m_lines.far ? 1 : 0; i + 1 < m_lines.xi.size(); ++i) {
                LumpGrid::Cell cell{};
                for (std::size_t n = 0; n < cell.size(); ++n) {
                    cell[n] = node(2 * i + n % 3, 2 * j + n / 3);
                }
                m_grid.cells.push_back(cell);
                m_grid.isCellInLump.push_back(j >= m_lines.lump ? 1 : 0);
                if (j == 0) {
                    m_grid.surface.push_back({cell[0], cell[1], cell[2]});
                }
            }
        }
        return std::move(m_grid);
    }

  private:
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    /// Value of a line, or the midpoint between two lines for odd `half`.
    static double at(const std::vector<double>& lines, std::size_t half)
    {
        return half % 2 == 0 ? lines[half / 2] : 0.5 * (lines[half / 2] + lines[half / 2 + 1]);
    }

    std::size_t node(std::size_t column, std::size_t row)
    {
        const bool isFocus = row == m_rows - 1;
        std::size_t& index = m_index[row * m_columns + (isFocus ? 0 : column)];
        if (index != kNone) {
            return index;
        }
        index = m_grid.nodes.size();
        const double xi = at(m_lines.xi, column), eta = at(m_lines.eta, row);
        const bool isOnAxis = isFocus || column == 0 || column == m_columns - 1;
        const double below = 2.0 * (std::pow(std::sinh(0.5 * eta), 2) + std::pow(std::sin(0.5 * xi), 2));
        m_grid.nodes.emplace_back(isOnAxis ? 0.0 : m_lines.focus * std::sin(xi) / below,
                                  isFocus ? m_lines.focus : m_lines.focus * std::sinh(eta) / below);
        m_grid.isOnAxis.push_back(isOnAxis ? 1 : 0);
        m_grid.isFar.push_back(column <= 2 && row <= 2 * m_lines.far ? 1 : 0);
        m_grid.isUnderPunch.push_back(row == 0 && xi >= m_lines.rim - 1e-13 ? 1 : 0);
        m_grid.isInLump.push_back(row >= 2 * m_lines.lump ? 1 : 0);
        return index;
    }

    Lines m_lines;
    std::size_t m_columns, m_rows;
    std::vector<std::size_t> m_index;
    LumpGrid m_grid;
};

} // namespace

LumpGrid lumpGrid(double sphereRadius, double cover, const LumpResolution& fineness)
{
    return GridBuilder(linesOf(sphereRadius, cover, fineness)).build();
}

} // namespace palpate::evaluation
