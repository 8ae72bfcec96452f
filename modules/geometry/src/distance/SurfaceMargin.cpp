// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/SurfaceMargin.h"

#include "distance/TrianglePair.h"
#include "palpate/geometry/Inside.h"
#include "palpate/geometry/SurfaceDistance.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace palpate::geometry {

namespace {

/// Areas of a few neighbouring triangles by band.
class BandAreas
{
  public:
    BandAreas(const SurfaceIndex& structure, bool hasInside, std::span<const double> limits_mm, double resolution_mm)
        : m_structure(structure)
        , m_hasInside(hasInside)
        , m_limits_mm(limits_mm)
        , m_resolution_mm(resolution_mm)
        , m_bands_mm2(limits_mm.size() + 1, 0.0)
    {
    }
    void add(const Corners& t)
    {
        const Vec3 centre = (t[0] + t[1] + t[2]) / 3.0;
        double radius2 = 0.0, edge2 = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            radius2 = std::max(radius2, (t[k] - centre).squaredNorm());
            edge2 = std::max(edge2, (t[(k + 1) % 3] - t[k]).squaredNorm());
        }
        const double radius_mm = std::sqrt(radius2);
        bool isDecided = m_isStarted && isDecidedAround(centre, radius_mm);
        if (!isDecided) {
            measureAt(centre);
            isDecided = isDecidedAround(centre, radius_mm) || edge2 <= m_resolution_mm * m_resolution_mm;
        }
        if (isDecided) {
            const double area_mm2 = 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
            m_bands_mm2[bandOf(m_distance_mm)] += area_mm2;
            m_inside_mm2 += m_isInside ? area_mm2 : 0.0;
            return;
        }
        const Corners middle{0.5 * (t[0] + t[1]), 0.5 * (t[1] + t[2]), 0.5 * (t[2] + t[0])};
        add({t[0], middle[0], middle[2]});
        add({middle[0], t[1], middle[1]});
        add({middle[2], middle[1], t[2]});
        add(middle);
    }
    [[nodiscard]] const std::vector<double>& bands_mm2() const { return m_bands_mm2; }
    [[nodiscard]] double inside_mm2() const { return m_inside_mm2; }

  private:
    [[nodiscard]] std::size_t bandOf(double distance_mm) const
    {
        return static_cast<std::size_t>(std::upper_bound(m_limits_mm.begin(), m_limits_mm.end(), distance_mm) -
                                        m_limits_mm.begin());
    }
    /// True if all points around one have the band and the side of the point measured last: the distance changes by at
    /// most the way.
    [[nodiscard]] bool isDecidedAround(const Vec3& p, double radius_mm) const
    {
        const double way_mm = (p - m_at).norm() + radius_mm;
        return bandOf(m_distance_mm - way_mm) == bandOf(m_distance_mm + way_mm) &&
               (!m_hasInside || m_distance_mm > way_mm);
    }
    /// Measures the distance at a point. The point found last bounds it; the side changes only across the surface.
    void measureAt(const Vec3& p)
    {
        const bool isSameSide = m_isStarted && (p - m_at).norm() < m_distance_mm;
        const auto within = m_isStarted ? std::optional((p - m_found).norm()) : std::nullopt;
        if (const auto nearest = nearestPoint(m_structure, p, within)) {
            m_distance_mm = nearest->distance_mm;
            m_found = nearest->at;
        }
        if (m_hasInside && !isSameSide) {
            m_isInside = isInside(m_structure, p);
        }
        m_at = p;
        m_isStarted = true;
    }

    const SurfaceIndex& m_structure;
    bool m_hasInside;
    std::span<const double> m_limits_mm;
    double m_resolution_mm;
    std::vector<double> m_bands_mm2;
    double m_inside_mm2 = 0.0;
    bool m_isStarted = false, m_isInside = false;
    Vec3 m_at = Vec3::Zero();    ///< point measured last
    Vec3 m_found = Vec3::Zero(); ///< closest point of the structure to it
    double m_distance_mm = 0.0;
};

bool hasInside(const SurfaceIndex& surface)
{
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i) {
        if (surface.isTwoSided(i)) {
            return false;
        }
    }
    return true;
}

} // namespace

double marginResolution_mm(const SurfaceIndex& lump)
{
    return lump.triangleCount() == 0 ? 0.1 : std::max(0.1, lump.bounds().diagonal().norm() / 300.0);
}

SurfaceMargin surfaceMargin(const SurfaceIndex& lump, const SurfaceIndex& structure, std::span<const double> limits_mm,
                            unsigned threads)
{
    SurfaceMargin margin;
    margin.shares.assign(limits_mm.size() + 1, 0.0);
    if (lump.triangleCount() == 0 || structure.triangleCount() == 0) {
        return margin;
    }
    constexpr std::uint32_t kPiece = 256;
    const std::uint32_t count = (lump.triangleCount() + kPiece - 1) / kPiece;
    std::vector<BandAreas> pieces(count,
                                  BandAreas(structure, hasInside(structure), limits_mm, marginResolution_mm(lump)));
    core::parallelFor(
        count,
        [&](std::size_t piece, unsigned /*thread*/) {
            const auto first = static_cast<std::uint32_t>(piece) * kPiece;
            for (std::uint32_t i = first; i < std::min(lump.triangleCount(), first + kPiece); ++i) {
                pieces[piece].add(cornersAt(lump, i));
            }
        },
        threads);
    double area_mm2 = 0.0;
    for (const BandAreas& piece : pieces) {
        for (std::size_t band = 0; band < margin.shares.size(); ++band) {
            margin.shares[band] += piece.bands_mm2()[band];
            area_mm2 += piece.bands_mm2()[band];
        }
        margin.insideShare += piece.inside_mm2();
    }
    if (area_mm2 > 0.0) {
        for (double& share : margin.shares) {
            share /= area_mm2;
        }
        margin.insideShare /= area_mm2;
    }
    return margin;
}

} // namespace palpate::geometry
