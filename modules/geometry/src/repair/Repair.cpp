// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/Repair.h"

#include "palpate/geometry/EdgeTable.h"
#include "palpate/geometry/MeshCheck.h"
#include "palpate/geometry/Reshape.h"

#include "repair/CarryArrays.h"
#include "repair/DisjointSets.h"
#include "repair/FirstSeen.h"
#include "repair/Orientation.h"
#include "repair/Weld.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace palpate::geometry {

namespace {

/// True if the area is within the rounding error, so that the normal is undefined. The rounding error of a cross
/// product is a few ulp of the squared longest edge.
bool isZeroArea(const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 ab = b - a, ac = c - a;
    const double longest2 = std::max({ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm()});
    return !(ab.cross(ac).norm() > 8.0 * std::numeric_limits<double>::epsilon() * longest2);
}

/// @return new index of each vertex, kNoVertex for removed ones
std::vector<std::uint32_t> dropUnusedVertices(TriangleMesh& mesh)
{
    std::vector<std::uint32_t> renumbered(mesh.vertices.size(), kNoVertex);
    for (const Triangle& t : mesh.triangles) {
        for (const std::uint32_t v : t) {
            renumbered[v] = 0;
        }
    }
    std::uint32_t next = 0;
    for (std::size_t v = 0; v < renumbered.size(); ++v) {
        if (renumbered[v] == 0) {
            mesh.vertices[next] = mesh.vertices[v];
            for (MeshArray& array : mesh.arrays) {
                if (!array.isPerTriangle) {
                    array.values[next] = array.values[v];
                }
            }
            renumbered[v] = next++;
        }
    }
    mesh.vertices.resize(next);
    for (MeshArray& array : mesh.arrays) {
        if (!array.isPerTriangle) {
            array.values.resize(next);
        }
    }
    for (Triangle& t : mesh.triangles) {
        for (std::uint32_t& v : t) {
            v = renumbered[v];
        }
    }
    return renumbered;
}

double signedVolume6(const TriangleMesh& mesh, const Triangle& t, const Vec3& origin)
{
    return (mesh.vertices[t[0]] - origin).dot((mesh.vertices[t[1]] - origin).cross(mesh.vertices[t[2]] - origin));
}

/// Winding number around `p` of the components accepted by `counts`, from a ray along +x.
template<class Counts>
int windingOf(const TriangleMesh& mesh, const std::vector<std::uint32_t>& componentOf, const Vec3& p, Counts&& counts)
{
    int winding = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (!counts(componentOf[i])) {
            continue;
        }
        const Triangle& t = mesh.triangles[i];
        std::array<Vec3, 3> q;
        for (std::size_t k = 0; k < 3; ++k) {
            q[k] = mesh.vertices[t[k]] - p;
        }
        // Half-open edges in y count each crossing of the yz projection once.
        int sides = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 &a = q[k], &b = q[(k + 1) % 3];
            if ((a.y() > 0.0) != (b.y() > 0.0)) {
                const double z = a.z() + (b.z() - a.z()) * (-a.y() / (b.y() - a.y()));
                if (z > 0.0) {
                    sides += a.y() > 0.0 ? 1 : -1;
                }
            }
        }
        if (sides != 0) {
            const Vec3 n = (q[1] - q[0]).cross(q[2] - q[0]);
            if (n.x() != 0.0 && n.dot(q[0]) / n.x() > 0.0) {
                winding += n.x() > 0.0 ? 1 : -1;
            }
        }
    }
    return winding;
}

/// Stepwise repair of a mesh; each step adds its counts to the report.
class Repairer
{
  public:
    /// @param turnsOutwards  also reverse consistently oriented closed components that are inside out
    explicit Repairer(const TriangleMesh& input, bool turnsOutwards = false, double weldWithin_mm = 0.0)
        : m_input(input)
        , m_turnsOutwards(turnsOutwards)
        , m_weldWithin_mm(weldWithin_mm)
    {
    }
    RepairedMesh run();

  private:
    void weldAndDrop();
    void mapVertices(const std::vector<std::uint32_t>& welded, const std::vector<std::uint32_t>& kept);
    void findComponents(const EdgeTable& edges);
    void orient(const EdgeTable& edges);
    void measureComponents();
    void turnComponentsOutwards();
    [[nodiscard]] bool isInsideOut(std::uint32_t component) const;
    [[nodiscard]] bool isWithin(std::uint32_t inner, std::uint32_t outer) const;
    void turnInsideOut();
    void turnAll(const std::vector<std::uint8_t>& components);
    void measureTriangles();
    void countComponents();
    void turn(std::size_t triangle)
    {
        m_turned[triangle] ^= 1;
        std::swap(m_mesh.triangles[triangle][1], m_mesh.triangles[triangle][2]);
    }

    [[nodiscard]] const Vec3& somePointOf(std::uint32_t component) const
    {
        return m_mesh.vertices[m_mesh.triangles[m_components[component].someTriangle][0]];
    }

    const TriangleMesh& m_input;
    bool m_turnsOutwards;
    double m_weldWithin_mm;
    RepairedMesh m_result;
    TriangleMesh& m_mesh = m_result.mesh;
    MeshReport& m_report = m_result.report;
    std::vector<std::uint32_t> m_componentOf; ///< component of each triangle
    std::vector<Component> m_components;
    std::vector<std::uint8_t> m_turned; ///< for each triangle: 1 if reversed relative to the input
};

/// Welds the vertices and drops zero-area and duplicate triangles.
void Repairer::weldAndDrop()
{
    const std::vector<std::uint32_t> renumbered = weld(m_input.vertices, m_weldWithin_mm, m_mesh.vertices);
    m_report.weldedVertices = m_input.vertices.size() - m_mesh.vertices.size();
    m_mesh.arrays = weldArrays(m_input.arrays, renumbered, m_mesh.vertices.size(), m_report.mixedValues);
    std::vector<Triangle> candidates(m_input.triangles.size());
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            candidates[i][k] = renumbered[m_input.triangles[i][k]];
        }
    }
    const auto sorted = [&candidates](std::uint32_t i) {
        Triangle t = candidates[i];
        std::sort(t.begin(), t.end());
        return t;
    };
    FirstSeen seen(
        candidates.size(),
        [&](std::uint32_t i) {
            const Triangle t = sorted(i);
            return mix(mix(t[0] | std::uint64_t{t[1]} << 32) ^ t[2]);
        },
        [&](std::uint32_t a, std::uint32_t b) { return sorted(a) == sorted(b); });
    m_mesh.triangles.reserve(candidates.size());
    m_result.source.reserve(candidates.size());
    for (std::uint32_t i = 0; i < candidates.size(); ++i) {
        const Triangle& t = candidates[i];
        if (isZeroArea(m_mesh.vertices[t[0]], m_mesh.vertices[t[1]], m_mesh.vertices[t[2]])) {
            ++m_report.zeroAreaTriangles;
        } else if (seen.insert(i) != i) {
            ++m_report.duplicateTriangles;
        } else {
            m_mesh.triangles.push_back(t);
            m_result.source.push_back(i);
        }
    }
    keepTriangles(m_mesh.arrays, m_result.source);
    mapVertices(renumbered, dropUnusedVertices(m_mesh));
}

/// Relates the vertices to those of the input.
/// @param welded  vertex after welding of each input vertex
/// @param kept  final index of each welded vertex, or kNoVertex
void Repairer::mapVertices(const std::vector<std::uint32_t>& welded, const std::vector<std::uint32_t>& kept)
{
    m_result.vertexSource.assign(m_mesh.vertices.size(), kNoVertex);
    m_result.vertexOfSource.resize(welded.size());
    for (std::uint32_t i = 0; i < welded.size(); ++i) {
        const std::uint32_t vertex = kept[welded[i]];
        m_result.vertexOfSource[i] = vertex;
        if (vertex != kNoVertex && m_result.vertexSource[vertex] == kNoVertex) {
            m_result.vertexSource[vertex] = i;
        }
    }
}

/// Finds the sets of triangles connected by edges, numbered in the order of their first triangles.
void Repairer::findComponents(const EdgeTable& edges)
{
    const std::size_t n = m_mesh.triangles.size();
    DisjointSets sets(n);
    edges.forEach([&](const EdgeUse* uses, std::size_t count) {
        for (std::size_t i = 1; i < count; ++i) {
            sets.join(uses[0].triangle, uses[i].triangle);
        }
        m_report.openEdges += count == 1 ? 1 : 0;
        m_report.nonManifoldEdges += count > 2 ? 1 : 0;
        m_report.inconsistentEdges += count == 2 && uses[0].isForward == uses[1].isForward ? 1 : 0;
    });
    m_componentOf.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t root = sets.find(i);
        if (root == i) {
            m_componentOf[i] = static_cast<std::uint32_t>(m_components.size());
            m_components.push_back({});
            m_components.back().someTriangle = i;
        } else {
            // The root is the smallest index of its set and therefore already numbered.
            m_componentOf[i] = m_componentOf[root];
        }
    }
    edges.forEach([&](const EdgeUse* uses, std::size_t count) {
        if (count == 2 && uses[0].isForward == uses[1].isForward) {
            m_components[m_componentOf[uses[0].triangle]].isConsistent = false;
        }
    });
}

/// Reverses triangles to agree with their neighbours, then finds the closed components.
void Repairer::orient(const EdgeTable& edges)
{
    const std::size_t n = m_mesh.triangles.size();
    m_turned.assign(n, 0);
    if (m_report.inconsistentEdges > 0) {
        for (const std::uint32_t t : trianglesToReverse(n, edges, m_componentOf, m_components)) {
            turn(t);
        }
    }
    edges.forEach([&](const EdgeUse* uses, std::size_t count) {
        int balance = 0;
        for (std::size_t i = 0; i < count; ++i) {
            balance += uses[i].isForward != (m_turned[uses[i].triangle] != 0) ? 1 : -1;
        }
        if (balance != 0) {
            m_components[m_componentOf[uses[0].triangle]].isBalanced = false;
        }
    });
    for (Component& component : m_components) {
        component.isBalanced = component.isBalanced && component.isOrientable;
    }
}

void Repairer::measureComponents()
{
    const Vec3 origin = m_report.bounds.center();
    for (std::size_t i = 0; i < m_mesh.triangles.size(); ++i) {
        Component& component = m_components[m_componentOf[i]];
        component.volume6 += signedVolume6(m_mesh, m_mesh.triangles[i], origin);
        for (const std::uint32_t v : m_mesh.triangles[i]) {
            component.box.extend(m_mesh.vertices[v]);
        }
    }
}

/// Reverses all components marked with 1.
void Repairer::turnAll(const std::vector<std::uint8_t>& components)
{
    for (std::size_t c = 0; c < components.size(); ++c) {
        m_components[c].volume6 *= components[c] != 0 ? -1.0 : 1.0;
    }
    for (std::size_t i = 0; i < m_mesh.triangles.size(); ++i) {
        if (components[m_componentOf[i]] != 0) {
            turn(i);
        }
    }
}

/// Reverses closed components oriented by this repair so that they face outwards.
void Repairer::turnComponentsOutwards()
{
    std::vector<std::uint8_t> turned(m_components.size(), 0);
    for (std::size_t c = 0; c < m_components.size(); ++c) {
        const Component& component = m_components[c];
        turned[c] = !component.isConsistent && component.isBalanced && component.volume6 < 0.0 ? 1 : 0;
    }
    turnAll(turned);
}

/// True for a closed component with inward normals that is not a cavity of another closed component.
bool Repairer::isInsideOut(std::uint32_t component) const
{
    const Vec3& p = somePointOf(component);
    return m_components[component].isBalanced && m_components[component].volume6 < 0.0 &&
           windingOf(m_mesh, m_componentOf, p, [&](std::uint32_t c) {
               return c != component && m_components[c].isBalanced && m_components[c].box.contains(p);
           }) <= 0;
}

bool Repairer::isWithin(std::uint32_t inner, std::uint32_t outer) const
{
    const Vec3& p = somePointOf(inner);
    return inner != outer && m_components[outer].box.contains(m_components[inner].box) &&
           windingOf(m_mesh, m_componentOf, p, [outer](std::uint32_t c) { return c == outer; }) != 0;
}

/// Reverses inside-out components together with their contents.
void Repairer::turnInsideOut()
{
    std::vector<std::uint8_t> turned(m_components.size(), 0);
    for (std::uint32_t outer = 0; outer < m_components.size(); ++outer) {
        if (!isInsideOut(outer)) {
            continue;
        }
        turned[outer] = 1;
        for (std::uint32_t inner = 0; inner < m_components.size(); ++inner) {
            if (m_components[inner].isBalanced && isWithin(inner, outer)) {
                turned[inner] = 1;
            }
        }
    }
    turnAll(turned);
}

void Repairer::measureTriangles()
{
    for (std::size_t i = 0; i < m_mesh.triangles.size(); ++i) {
        m_report.reorientedTriangles += m_turned[i];
        m_result.twoSided[i] = m_components[m_componentOf[i]].isBalanced ? 0 : 1;
        const Triangle& t = m_mesh.triangles[i];
        const Vec3& a = m_mesh.vertices[t[0]];
        m_report.area_mm2 += 0.5 * (m_mesh.vertices[t[1]] - a).cross(m_mesh.vertices[t[2]] - a).norm();
    }
}

void Repairer::countComponents()
{
    m_report.components = m_components.size();
    for (std::uint32_t c = 0; c < m_components.size(); ++c) {
        const Component& component = m_components[c];
        if (!component.isBalanced) {
            ++m_report.openComponents;
            m_report.nonOrientableComponents += component.isOrientable ? 0 : 1;
            continue;
        }
        ++m_report.closedComponents;
        m_report.volume_mm3 += component.volume6 / 6.0;
        m_report.insideOutComponents += isInsideOut(c) ? 1 : 0;
    }
}

RepairedMesh Repairer::run()
{
    m_report.inputVertices = m_input.vertices.size();
    m_report.inputTriangles = m_input.triangles.size();
    weldAndDrop();
    m_report.vertices = m_mesh.vertices.size();
    m_report.triangles = m_mesh.triangles.size();
    m_report.bounds = m_mesh.bounds();
    m_result.twoSided.assign(m_mesh.triangles.size(), 0);
    if (!m_mesh.triangles.empty()) {
        const EdgeTable edges(m_mesh);
        findComponents(edges);
        orient(edges);
        measureComponents();
        turnComponentsOutwards();
        if (m_turnsOutwards) {
            turnInsideOut();
        }
        measureTriangles();
        countComponents();
    }
    if (m_report.reorientedTriangles > 0) {
        m_result.turned = std::move(m_turned);
    }
    return std::move(m_result);
}

/// Makes `again`, repaired from the mesh of `before`, refer to the original input of `before`.
RepairedMesh chained(const RepairedMesh& before, RepairedMesh again)
{
    MeshReport& report = again.report;
    const MeshReport& was = before.report;
    report.inputVertices = was.inputVertices;
    report.inputTriangles = was.inputTriangles;
    report.weldedVertices += was.weldedVertices;
    report.mixedValues = was.mixedValues;
    report.zeroAreaTriangles += was.zeroAreaTriangles;
    report.duplicateTriangles += was.duplicateTriangles;
    report.inconsistentEdges = was.inconsistentEdges;
    report.turnedComponents += was.turnedComponents;
    report.reorientedTriangles = was.reorientedTriangles; // reversed for consistency; excludes reversals on request
    if (again.turned.empty() && !before.turned.empty()) {
        again.turned.assign(again.source.size(), 0);
    }
    for (std::size_t i = 0; i < again.source.size(); ++i) {
        const std::uint32_t from = again.source[i];
        again.source[i] = before.source[from];
        if (!before.turned.empty()) {
            again.turned[i] ^= before.turned[from];
        }
    }
    if (before.vertexSource.size() != before.mesh.vertices.size()) { // unknown, as from a recording
        again.vertexSource.clear();
        again.vertexOfSource.clear();
        return again;
    }
    for (std::uint32_t& vertex : again.vertexSource) {
        // A subdivision has more vertices, numbered after those that it divides.
        vertex = vertex < before.vertexSource.size() ? before.vertexSource[vertex] : kNoVertex;
    }
    std::vector<std::uint32_t> vertexOfSource(before.vertexOfSource);
    for (std::uint32_t& vertex : vertexOfSource) {
        vertex = vertex == kNoVertex ? kNoVertex : again.vertexOfSource[vertex];
    }
    again.vertexOfSource = std::move(vertexOfSource);
    return again;
}

} // namespace

RepairedMesh repair(const TriangleMesh& input, const RepairOptions& options)
{
    RepairedMesh surface = Repairer(input, false, options.weldWithin_mm).run();
    if (options.facing == Facing::Outward) {
        const std::size_t insideOut = surface.report.insideOutComponents;
        if (std::optional<RepairedMesh> outward = orientedOutwards(surface)) {
            surface = std::move(*outward);
            surface.report.turnedComponents = insideOut - surface.report.insideOutComponents;
        }
    }
    return surface;
}

core::Result<RepairedMesh> surfaceOf(const TriangleMesh& mesh, const RepairOptions& options)
{
    if (const MeshCheck found = check(mesh); !found.isOk()) {
        return found.status();
    }
    if (!(options.weldWithin_mm >= 0.0 && options.weldWithin_mm <= kMostCoordinate_mm)) {
        return core::Status(core::StatusCode::OutOfRange, PALPATE_TEXT("weldWithin_mm: found %1, expected 0 to %2 mm"),
                            options.weldWithin_mm, kMostCoordinate_mm);
    }
    RepairedMesh surface = repair(mesh, options);
    if (surface.mesh.triangles.empty()) {
        return core::Status(core::StatusCode::Empty,
                            PALPATE_TEXT("none of the %1 triangles has an area; check the unit, expected mm"),
                            core::Count(mesh.triangles.size()));
    }
    return surface;
}

std::optional<RepairedMesh> orientedOutwards(const RepairedMesh& surface)
{
    return surface.report.insideOutComponents > 0 ? std::optional(chained(surface, Repairer(surface.mesh, true).run()))
                                                  : std::nullopt;
}

RepairedMesh withVertices(const RepairedMesh& surface, std::vector<Vec3> vertices)
{
    TriangleMesh moved = surface.mesh;
    moved.vertices = std::move(vertices);
    return chained(surface, repair(moved, Facing::AsGiven));
}

RepairedMesh withTriangles(const RepairedMesh& surface, const TriangleMesh& mesh,
                           const std::vector<std::uint32_t>& parents)
{
    RepairedMesh again = repair(mesh, Facing::AsGiven);
    for (std::uint32_t& source : again.source) {
        source = parents[source];
    }
    return chained(surface, std::move(again));
}

} // namespace palpate::geometry
