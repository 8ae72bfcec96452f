// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/SurfaceSection.h"

#include <algorithm>
#include <cstddef>

namespace palpate::geometry {

namespace {

/// Side of a contour, from the lower to the upper end.
struct FillEdge
{
    Eigen::Vector2d low, high;
    int winding = 1; ///< -1: the contour runs downwards here

    [[nodiscard]] double at(double height) const
    {
        return low.x() + (height - low.y()) / (high.y() - low.y()) * (high.x() - low.x());
    }
};

/// Strip that is not ended yet, kept with its left edge.
struct OpenStrip
{
    std::size_t right = 0;
    double low = 0.0;
    std::size_t slab = 0; ///< newest slab that contains it; 0: none
};

std::vector<FillEdge> edgesOf(const std::vector<SectionContour>& contours)
{
    std::vector<FillEdge> edges;
    for (const SectionContour& contour : contours) {
        for (std::size_t i = 0; contour.isClosed && i < contour.points.size(); ++i) {
            const Eigen::Vector2d& a = contour.points[i];
            const Eigen::Vector2d& b = contour.points[(i + 1) % contour.points.size()];
            if (a.y() < b.y()) {
                edges.push_back({a, b, 1});
            } else if (a.y() > b.y()) {
                edges.push_back({b, a, -1});
            }
        }
    }
    std::sort(edges.begin(), edges.end(), [](const FillEdge& a, const FillEdge& b) { return a.low.y() < b.low.y(); });
    return edges;
}

/// Sweep over the slabs between neighbouring heights of contour points, from the bottom to the top.
class FillSweep
{
  public:
    explicit FillSweep(const std::vector<SectionContour>& contours)
        : m_edges(edgesOf(contours))
        , m_open(m_edges.size())
    {
        for (const FillEdge& edge : m_edges) {
            m_heights.push_back(edge.low.y());
            m_heights.push_back(edge.high.y());
        }
        std::sort(m_heights.begin(), m_heights.end());
        m_heights.erase(std::unique(m_heights.begin(), m_heights.end()), m_heights.end());
    }

    std::vector<SectionStrip> run()
    {
        std::size_t entered = 0;
        for (std::size_t slab = 1; slab < m_heights.size(); ++slab) {
            const double low = m_heights[slab - 1], middle = 0.5 * (low + m_heights[slab]);
            std::erase_if(m_active, [&](const Crossing& one) { return m_edges[one.edge].high.y() <= low; });
            for (; entered < m_edges.size() && m_edges[entered].low.y() <= low; ++entered) {
                m_active.push_back({entered, 0.0});
            }
            for (Crossing& one : m_active) {
                one.x = m_edges[one.edge].at(middle);
            }
            sortActive();
            addStrips(slab, low);
            endStrips(slab, low);
        }
        endStrips(m_heights.size(), m_heights.empty() ? 0.0 : m_heights.back());
        return std::move(m_strips);
    }

  private:
    struct Crossing
    {
        std::size_t edge = 0;
        double x = 0.0;
    };

    /// Insertion sort: the order hardly changes from slab to slab.
    void sortActive()
    {
        for (std::size_t i = 1; i < m_active.size(); ++i) {
            for (std::size_t k = i; k > 0 && m_active[k].x < m_active[k - 1].x; --k) {
                std::swap(m_active[k], m_active[k - 1]);
            }
        }
    }

    /// Continues the strips of this slab that have the same two sides as below, and begins the others.
    void addStrips(std::size_t slab, double low)
    {
        int winding = 0;
        std::size_t left = 0;
        for (const Crossing& one : m_active) {
            const int before = winding;
            winding += m_edges[one.edge].winding;
            if (before == 0) {
                left = one.edge;
            }
            if (before == 0 || winding != 0) {
                continue;
            }
            OpenStrip& strip = m_open[left];
            const bool isSame = strip.slab != 0 && strip.slab + 1 == slab && strip.right == one.edge;
            if (strip.slab != 0 && !isSame) {
                end(left, low);
            }
            if (!isSame) {
                strip = {one.edge, low, slab};
                m_lefts.push_back(left);
            }
            strip.slab = slab;
        }
    }

    /// Ends the strips that do not reach into a slab.
    void endStrips(std::size_t slab, double low)
    {
        std::erase_if(m_lefts, [&](std::size_t left) {
            if (m_open[left].slab == slab) {
                return false;
            }
            if (m_open[left].slab != 0) {
                end(left, low);
            }
            return true;
        });
    }

    void end(std::size_t left, double high)
    {
        OpenStrip& strip = m_open[left];
        const FillEdge &a = m_edges[left], &b = m_edges[strip.right];
        m_strips.push_back({strip.low, high, a.at(strip.low), b.at(strip.low), a.at(high), b.at(high)});
        strip.slab = 0;
    }

    std::vector<FillEdge> m_edges; ///< by the lower end
    std::vector<OpenStrip> m_open; ///< of the strips with this left edge
    std::vector<double> m_heights;
    std::vector<Crossing> m_active;     ///< edges in the current slab, from left to right
    std::vector<std::size_t> m_lefts{}; ///< left edges of the open strips
    std::vector<SectionStrip> m_strips;
};

} // namespace

bool SectionStrip::contains(const Eigen::Vector2d& q) const
{
    if (!(q.y() >= low && q.y() <= high) || !(high > low)) {
        return false;
    }
    const double part = (q.y() - low) / (high - low);
    return q.x() >= leftLow + part * (leftHigh - leftLow) && q.x() <= rightLow + part * (rightHigh - rightLow);
}

std::vector<SectionStrip> filled(const std::vector<SectionContour>& contours)
{
    return FillSweep(contours).run();
}

double areaOf(const std::vector<SectionStrip>& strips)
{
    double area_mm2 = 0.0;
    for (const SectionStrip& strip : strips) {
        area_mm2 += strip.area_mm2();
    }
    return area_mm2;
}

} // namespace palpate::geometry
