// SPDX-License-Identifier: BSD-3-Clause
#include "VesselTree.h"

#include "SurfaceSampler.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate::phantom {

namespace {

constexpr double kStep_mm = 3.0;    // distance between nodes of a branch
constexpr double kSettled_mm = 6.5; // a supply point this close to a node is reached
constexpr double kWall_mm = 4.0;    // minimum distance of branches from the organ's surface
constexpr double kTwig_mm = 1.25;   // radius at the tips

/// Element i of the Halton sequence in the given base, 0 to 1.
double halton(int i, int base)
{
    double result = 0.0;
    double share = 1.0;
    for (; i > 0; i /= base) {
        share /= base;
        result += share * (i % base);
    }
    return result;
}

/// Distance to the vessel wall. Segments are binned so that a query tests only a few.
class TreeField
{
  public:
    explicit TreeField(const VesselTree& tree)
        : m_tree(tree)
    {
        for (const VesselTree::Node& node : tree.nodes) {
            const Vec3 reach = Vec3::Constant(node.radius_mm + kReach_mm);
            m_box.extend(node.p_W - reach);
            m_box.extend(node.p_W + reach);
        }
        for (int axis = 0; axis < 3; ++axis) {
            m_bins[axis] = static_cast<int>(m_box.sizes()[axis] / kBin_mm) + 1;
        }
        m_segments.resize(static_cast<std::size_t>(m_bins[0]) * m_bins[1] * m_bins[2]);
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
            const VesselTree::Node& node = tree.nodes[i];
            if (node.parent < 0) {
                continue;
            }
            const VesselTree::Node& parent = tree.nodes[node.parent];
            const double reach = std::max(node.radius_mm, parent.radius_mm) + kReach_mm;
            const auto low = binOf(node.p_W.cwiseMin(parent.p_W) - Vec3::Constant(reach));
            const auto high = binOf(node.p_W.cwiseMax(parent.p_W) + Vec3::Constant(reach));
            for (int z = low[2]; z <= high[2]; ++z) {
                for (int y = low[1]; y <= high[1]; ++y) {
                    for (int x = low[0]; x <= high[0]; ++x) {
                        m_segments[index({x, y, z})].push_back(static_cast<int>(i));
                    }
                }
            }
        }
        for (std::vector<int>& bin : m_segments) {
            std::stable_sort(bin.begin(), bin.end(),
                             [&](int a, int b) { return tree.nodes[a].branch < tree.nodes[b].branch; });
        }
    }

    [[nodiscard]] const core::Box& box() const { return m_box; }

    [[nodiscard]] double operator()(const Vec3& p) const
    {
        // Blend between branches only: along a branch, blending would create beads.
        constexpr double kRounding_mm = 1.5;
        double result = kReach_mm;
        double branch = 2.0 * kReach_mm;
        int current = -1;
        const auto merge = [&] {
            const double h = std::max(kRounding_mm - std::abs(result - branch), 0.0) / kRounding_mm;
            result = std::min(result, branch) - h * h * h * kRounding_mm / 6.0;
            branch = 2.0 * kReach_mm;
        };
        for (const int i : m_segments[index(binOf(p))]) {
            const VesselTree::Node& a = m_tree.nodes[i];
            const VesselTree::Node& b = m_tree.nodes[a.parent];
            if (a.branch != current) {
                merge();
                current = a.branch;
            }
            const Vec3 axis = b.p_W - a.p_W;
            const double t = std::clamp((p - a.p_W).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
            branch = std::min(branch, (p - a.p_W - t * axis).norm() - (a.radius_mm + t * (b.radius_mm - a.radius_mm)));
        }
        merge();
        return result;
    }

  private:
    static constexpr double kBin_mm = 6.0;
    static constexpr double kReach_mm = 4.0;

    [[nodiscard]] std::array<int, 3> binOf(const Vec3& p) const
    {
        std::array<int, 3> bin;
        for (int axis = 0; axis < 3; ++axis) {
            bin[axis] = std::clamp(static_cast<int>((p[axis] - m_box.min()[axis]) / kBin_mm), 0, m_bins[axis] - 1);
        }
        return bin;
    }
    [[nodiscard]] std::size_t index(const std::array<int, 3>& bin) const
    {
        return (static_cast<std::size_t>(bin[2]) * m_bins[1] + bin[1]) * m_bins[0] + bin[0];
    }

    const VesselTree& m_tree;
    core::Box m_box;
    std::array<int, 3> m_bins{};
    std::vector<std::vector<int>> m_segments;
};

/// Smooths the zigzag of the growth; root and tips do not move.
void smooth(VesselTree& tree)
{
    for (int round = 0; round < 6; ++round) {
        std::vector<Vec3> sum(tree.nodes.size(), Vec3::Zero());
        std::vector<double> weight(tree.nodes.size(), 0.0);
        for (const VesselTree::Node& node : tree.nodes) {
            if (node.parent >= 0) {
                // Weighted by cross-section, so that a thick child continues in the direction of its parent.
                const double w = node.radius_mm * node.radius_mm;
                sum[node.parent] += w * node.p_W;
                weight[node.parent] += w;
            }
        }
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
            VesselTree::Node& node = tree.nodes[i];
            if (node.parent >= 0 && weight[i] > 0.0) {
                node.p_W = 0.5 * node.p_W + 0.25 * (tree.nodes[node.parent].p_W + sum[i] / weight[i]);
            }
        }
    }
}

} // namespace

std::vector<Vec3> scatter(const Distance& inside, double margin_mm, int count, int skip)
{
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const int n = skip + i + 1;
        const Vec3 p(-110 + 225 * halton(n, 2), -75 + 160 * halton(n, 3), -65 + 135 * halton(n, 5));
        if (inside(p) < -margin_mm) {
            points.push_back(p);
        }
    }
    return points;
}

namespace {

/// Supply points not reached yet, each with its nearest node, updated incrementally as nodes are added.
class Supply
{
  public:
    Supply(std::vector<Vec3> points, std::size_t firstSeen)
        : m_points(std::move(points))
        , m_nearest(m_points.size(), -1)
        , m_gap(m_points.size(), 1e9)
        , m_seen(firstSeen)
    {
    }

    [[nodiscard]] bool isEmpty() const { return m_points.empty(); }

    /// Processes new nodes and removes the points that they reach.
    void update(const VesselTree& tree)
    {
        for (std::size_t s = 0; s < m_points.size(); ++s) {
            for (std::size_t i = m_seen; i < tree.nodes.size(); ++i) {
                const double d = (m_points[s] - tree.nodes[i].p_W).norm();
                if (d < m_gap[s]) {
                    m_gap[s] = d;
                    m_nearest[s] = static_cast<int>(i);
                }
            }
        }
        m_seen = tree.nodes.size();
        for (std::size_t s = m_points.size(); s-- > 0;) {
            if (m_gap[s] < kSettled_mm) {
                m_points.erase(m_points.begin() + s);
                m_nearest.erase(m_nearest.begin() + s);
                m_gap.erase(m_gap.begin() + s);
            }
        }
    }

    /// Returns for each node the sum of the unit vectors to the points nearest to that node.
    [[nodiscard]] std::vector<Vec3> pull(const VesselTree& tree) const
    {
        std::vector<Vec3> pull(tree.nodes.size(), Vec3::Zero());
        for (std::size_t s = 0; s < m_points.size(); ++s) {
            pull[m_nearest[s]] += (m_points[s] - tree.nodes[m_nearest[s]].p_W).normalized();
        }
        return pull;
    }

  private:
    std::vector<Vec3> m_points;
    std::vector<int> m_nearest;
    std::vector<double> m_gap;
    std::size_t m_seen;
};

/// Adds a node next to each node with attracted points. @return false when no node could be added
bool grow(VesselTree& tree, const std::vector<Vec3>& pull, const Distance& inside)
{
    const std::size_t before = tree.nodes.size();
    for (std::size_t i = 0; i < before; ++i) {
        if (pull[i].norm() < 1e-9) {
            continue;
        }
        const VesselTree::Node& node = tree.nodes[i];
        Vec3 direction = pull[i].normalized();
        if (node.parent >= 0) {
            direction += 0.45 * (node.p_W - tree.nodes[node.parent].p_W).normalized();
        }
        Vec3 p = node.p_W + kStep_mm * direction.normalized();
        const double d = inside(p);
        if (d > -kWall_mm) {
            p -= (d + kWall_mm) * outward(inside, p);
        }
        // Two points that pull in opposite directions would add the same node repeatedly.
        const bool isNew = std::none_of(tree.nodes.begin(), tree.nodes.end(), [&](const VesselTree::Node& other) {
            return (other.p_W - p).norm() < 0.4 * kStep_mm;
        });
        if (isNew) {
            tree.nodes.push_back({p, static_cast<int>(i), 0.0});
        }
    }
    return tree.nodes.size() > before;
}

/// Sets the radius of each vessel from its subtree: the cubes of the radii add up (Murray's law).
void setRadii(VesselTree& tree, const Trunk& trunk)
{
    std::vector<double> flow(tree.nodes.size(), 0.0); // r^3
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        VesselTree::Node& node = tree.nodes[i];
        flow[i] = std::max(flow[i], std::pow(kTwig_mm, 3));
        node.radius_mm = std::cbrt(flow[i]);
        if (i < trunk.points_W.size()) {
            node.radius_mm = std::max(node.radius_mm, trunk.radius_mm);
        }
        if (node.parent >= 0) {
            flow[node.parent] += flow[i];
        }
    }
}

/// Continues a branch with the thickest child of each node.
void numberBranches(VesselTree& tree)
{
    std::vector<int> thickest(tree.nodes.size(), -1);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const int parent = tree.nodes[i].parent;
        if (parent >= 0 && (thickest[parent] < 0 || tree.nodes[thickest[parent]].radius_mm < tree.nodes[i].radius_mm)) {
            thickest[parent] = static_cast<int>(i);
        }
    }
    int branches = 1;
    for (std::size_t i = 1; i < tree.nodes.size(); ++i) {
        VesselTree::Node& node = tree.nodes[i];
        node.branch = thickest[node.parent] == static_cast<int>(i) ? tree.nodes[node.parent].branch : branches++;
    }
}

} // namespace

VesselTree growTree(const Trunk& trunk, std::vector<Vec3> supplied, const Distance& inside)
{
    VesselTree tree;
    for (std::size_t i = 0; i < trunk.points_W.size(); ++i) {
        tree.nodes.push_back({trunk.points_W[i], static_cast<int>(i) - 1, 0.0});
    }
    Supply supply(std::move(supplied), trunk.points_W.size() - 1); // the trunk grows from its end only
    for (int round = 0; round < 200 && !supply.isEmpty(); ++round) {
        supply.update(tree);
        if (!grow(tree, supply.pull(tree), inside)) {
            break;
        }
    }
    setRadii(tree, trunk);
    numberBranches(tree);
    smooth(tree);
    return tree;
}

void add(VesselTree& tree, const VesselTree& other)
{
    const int first = static_cast<int>(tree.nodes.size());
    int branches = 0;
    for (const VesselTree::Node& node : tree.nodes) {
        branches = std::max(branches, node.branch + 1);
    }
    for (VesselTree::Node node : other.nodes) {
        node.parent = node.parent < 0 ? -1 : node.parent + first;
        node.branch += branches;
        tree.nodes.push_back(node);
    }
}

geometry::TriangleMesh vesselSurface(const VesselTree& tree, double cell_mm)
{
    const TreeField field(tree);
    return sampleSurface([&](const Vec3& p) { return field(p); }, field.box(), cell_mm);
}

} // namespace palpate::phantom
