// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/ForceTable.h"

#include <cmath>

namespace palpate::haptics {

namespace {

using Knot = ForceTable::Knot;

/// Returns the depths t within (0, length) at which the slope of a cell is `slope`, in ascending order, with at least
/// the minimum cell length between each other and from the ends.
std::vector<double> whereSlopeIs(double slope, double rise, double square, double cube, double length)
{
    const double a = 3.0 * cube, half = square, c = rise - slope; // a t^2 + 2 half t + c = 0
    const double inside = half * half - a * c;
    if (inside <= 0.0) {
        return {};
    }
    const double q = -(half + std::copysign(std::sqrt(inside), half)); // avoids cancellation in both roots
    std::vector<double> found;
    for (const double t : {q / a, c / q}) {
        const double apart = 2.0 * ForceTable::kLeastCell_mm;
        if (t > apart && t < length - apart && (found.empty() || std::abs(t - found[0]) > apart)) {
            found.push_back(t);
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Builds the bounded force from the surface down, piece by piece.
class Bounding
{
  public:
    explicit Bounding(double most)
        : m_most(most)
    {
    }

    /// Adds a piece of the law from `from` to `to`, in which the slope does not cross `most`.
    /// @param forceAt  force of the law by depth
    /// @param slopeAt  slope of the law by depth
    template<class Force, class Slope>
    void add(const Knot& from, const Knot& to, const Force& forceAt, const Slope& slopeAt)
    {
        const bool isSteep = slopeAt(0.5 * (from.depth_mm + to.depth_mm)) > m_most;
        if (m_knots.empty()) {
            m_knots.push_back({0.0, 0.0, std::min(m_most, from.slopeBefore), 0.0});
        }
        if (m_isOnLaw && !isSteep) {
            follow(from.slopeAfter, to);
            return;
        }
        m_isOnLaw = false;
        const auto above = [&](double d) { return forceAt(d) - lineAt(d); };
        if (isSteep || above(to.depth_mm) > 0.0) {
            goStraight(to.depth_mm, lineAt(to.depth_mm));
            return;
        }
        double below_mm = from.depth_mm, above_mm = to.depth_mm;
        for (int halving = 0; halving < 100; ++halving) {
            const double middle = 0.5 * (below_mm + above_mm);
            (above(middle) > 0.0 ? below_mm : above_mm) = middle;
        }
        meet(above_mm, to, forceAt, slopeAt);
    }

    /// Continues linearly from the last knot of the law. A bounded force that is still below the law may meet the law
    /// later if the law is flatter.
    [[nodiscard]] std::vector<Knot> end(const Knot& last)
    {
        if (m_knots.empty()) {
            m_knots.push_back({0.0, 0.0, std::min(m_most, last.slopeBefore), 0.0});
        }
        m_knots.back().slopeAfter = m_isOnLaw ? std::min(m_most, last.slopeAfter) : m_most;
        if (!m_isOnLaw && last.slopeAfter < m_most) {
            const double further_mm = (last.force_N - last_N()) / (m_most - last.slopeAfter);
            if (further_mm > 2.0 * ForceTable::kLeastCell_mm && last_mm() + further_mm < kFarthest_mm) {
                goStraight(last_mm() + further_mm, last.force_N + last.slopeAfter * further_mm);
            }
            m_knots.back().slopeAfter = further_mm < kFarthest_mm ? last.slopeAfter : m_most;
        }
        return std::move(m_knots);
    }

  private:
    static constexpr double kFarthest_mm = 1e6;

    [[nodiscard]] double last_mm() const noexcept { return m_knots.back().depth_mm; }
    [[nodiscard]] double last_N() const noexcept { return m_knots.back().force_N; }
    [[nodiscard]] double lineAt(double depth_mm) const { return last_N() + m_most * (depth_mm - last_mm()); }
    void follow(double slopeAfter, const Knot& to)
    {
        m_knots.back().slopeAfter = std::min(m_most, slopeAfter);
        m_knots.push_back({to.depth_mm, to.force_N, std::min(m_most, to.slopeBefore), 0.0});
        m_endsLine = false;
    }
    void goStraight(double depth_mm, double force_N)
    {
        m_knots.back().slopeAfter = m_most;
        if (m_endsLine) {
            m_knots.pop_back(); // merge collinear segments
        }
        m_knots.push_back({depth_mm, force_N, m_most, 0.0});
        m_endsLine = true;
    }
    /// Ends the line where it meets the law, within a piece that ends at `to`.
    template<class Force, class Slope>
    void meet(double depth_mm, const Knot& to, const Force& forceAt, const Slope& slopeAt)
    {
        const double apart = 2.0 * ForceTable::kLeastCell_mm;
        m_isOnLaw = true;
        if (to.depth_mm - depth_mm < apart) {
            goStraight(to.depth_mm, std::min(to.force_N, lineAt(to.depth_mm)));
            return;
        }
        if (depth_mm - last_mm() >= apart) {
            goStraight(depth_mm, forceAt(depth_mm));
        }
        follow(slopeAt(depth_mm), to);
    }

    double m_most;
    bool m_isOnLaw = true;
    bool m_endsLine = false; ///< the last knot ends a line rather than a piece of the law
    std::vector<Knot> m_knots;
};

} // namespace

std::vector<ForceTable::Knot> ForceTable::boundedKnots(double most_N_per_mm) const
{
    Bounding bounding(most_N_per_mm);
    for (std::size_t i = 0; i + 1 < m_knots.size(); ++i) {
        const Cell& cell = m_cells[i];
        const auto forceAt = [&](double d) { return force(cell, d - cell.start_mm); };
        const auto slopeAt = [&](double d) {
            const double t = d - cell.start_mm;
            return cell.rise + t * (2.0 * cell.square + t * (3.0 * cell.cube));
        };
        Knot from = m_knots[i];
        for (const double t :
             whereSlopeIs(most_N_per_mm, cell.rise, cell.square, cell.cube, cell.end_mm - cell.start_mm)) {
            const double d = cell.start_mm + t;
            const Knot cut{d, forceAt(d), most_N_per_mm, most_N_per_mm};
            bounding.add(from, cut, forceAt, slopeAt);
            from = cut;
        }
        bounding.add(from, m_knots[i + 1], forceAt, slopeAt);
    }
    return bounding.end(m_knots.back());
}

std::shared_ptr<const ForceTable> ForceTable::bounded(const std::shared_ptr<const ForceTable>& table,
                                                      double most_N_per_mm)
{
    if (table == nullptr || table->m_greatestSlope <= most_N_per_mm) {
        return table;
    }
    return std::shared_ptr<const ForceTable>(new ForceTable(table->boundedKnots(most_N_per_mm)));
}

} // namespace palpate::haptics
