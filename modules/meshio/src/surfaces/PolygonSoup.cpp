// SPDX-License-Identifier: BSD-3-Clause
#include "surfaces/PolygonSoup.h"

#include "text/Fault.h"

#include <algorithm>
#include <utility>

namespace palpate::meshio::internal {

using core::Result;
using core::Status;
using core::StatusCode;
using geometry::PolygonCutter;

Status PolygonSoup::add(std::span<const std::int64_t> corners)
{
    const std::uint64_t number = m_polygons++;
    if (corners.size() < 3) {
        ++m_thin;
        return {};
    }
    const core::Message place(PALPATE_TEXT("polygon %1"), number);
    if (corners.size() > PolygonCutter::kMostCorners) {
        return fault(StatusCode::BadFormat, m_context.file, place,
                     {PALPATE_TEXT("number of corners: %1"), Count(corners.size())},
                     {PALPATE_TEXT("at most %1"), Count(PolygonCutter::kMostCorners)});
    }
    const auto points = static_cast<std::int64_t>(m_soup.mesh.vertices.size());
    const auto bad = std::ranges::find_if(corners, [points](std::int64_t i) { return i < 0 || i >= points; });
    if (bad != corners.end()) {
        return fault(StatusCode::OutOfRange, m_context.file, place, {PALPATE_TEXT("it uses point %1"), *bad},
                     {PALPATE_TEXT("%1 to %2"), 0, points - 1});
    }
    m_corners.clear();
    for (const std::int64_t corner : corners) {
        m_corners.push_back(static_cast<std::uint32_t>(corner));
    }
    if (m_corners.size() == 3) {
        m_soup.mesh.triangles.push_back({m_corners[0], m_corners[1], m_corners[2]});
    } else {
        m_cutter.cut(m_soup.mesh.vertices, m_corners, m_soup.mesh.triangles);
    }
    return {};
}

Status PolygonSoup::progress(std::uint64_t done, std::uint64_t all)
{
    constexpr std::uint64_t kRarely = 4096;
    if (m_calls++ % kRarely != 0 || !m_context.progress ||
        m_context.progress(static_cast<double>(done) / static_cast<double>(std::max<std::uint64_t>(all, 1)))) {
        return {};
    }
    return {StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), m_context.file};
}

Result<TriangleSoup> PolygonSoup::finish(PreScan& scan, const std::string& name)
{
    if (m_soup.mesh.triangles.empty()) {
        return noFaces(m_soup.mesh.vertices.size(), {}, m_context);
    }
    scan.points = m_soup.mesh.vertices.size();
    scan.cells = m_polygons;
    noteCrossing(m_cutter.crossing(), scan);
    noteThinFaces(m_thin, scan);
    m_soup.partNames = {name};
    return std::move(m_soup);
}

} // namespace palpate::meshio::internal
