// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/MeasureLines.h"

#include <vtkProperty.h>

#include <utility>

namespace palpate::view {

namespace {

constexpr double kLine_px = 2.5, kWide_px = 4.0, kLineRim_px = 1.5;
constexpr double kEnd_px = 3.5;   // radius
constexpr double kClear_px = 7.0; // around the ends, free of texts
constexpr Colour kFaintText{0.62, 0.62, 0.62};

/// Places the text beyond the end, or beside the line and above it.
TouchLabels::Item itemOf(const MeasureLine& line, const ViewFrame& frame)
{
    const Eigen::Vector2d way = frame.pixelOf(line.to_W) - frame.pixelOf(line.from_W);
    const Eigen::Vector2d along = way.norm() > 1.0 ? Eigen::Vector2d(way.normalized()) : Eigen::Vector2d(1.0, 0.0);
    const Eigen::Vector2d across =
        along.x() < 0.0 ? Eigen::Vector2d(along.y(), -along.x()) : Eigen::Vector2d(-along.y(), along.x());
    return {line.text, line.isTextAtEnd ? line.to_W : Vec3(0.5 * (line.from_W + line.to_W)),
            line.isTextAtEnd ? along : across, textColourOf(line.colour), line.isWide};
}

} // namespace

void MeasureLines::addTo(vtkRenderer& overlay)
{
    m_overlay = &overlay;
    m_labels.addTo(overlay);
}

void MeasureLines::set(std::vector<MeasureLine> lines)
{
    if (lines == m_lines) {
        return;
    }
    for (const Drawn& one : m_drawn) {
        for (std::size_t i = 0; m_overlay != nullptr && i < 2; ++i) {
            m_overlay->RemoveActor(one.line[i].actor());
            m_overlay->RemoveActor(one.ends[i][0]);
            m_overlay->RemoveActor(one.ends[i][1]);
        }
    }
    m_drawn.clear();
    m_lines = std::move(lines);
    for (const MeasureLine& line : m_lines) {
        add(line);
    }
}

void MeasureLines::add(const MeasureLine& line)
{
    const double width_px = line.isWide ? kWide_px : kLine_px;
    m_drawn.push_back(
        {{BillboardLine(width_px + 2.0 * kLineRim_px, kDarkRim), BillboardLine(width_px, line.colour)}, {}});
    Drawn& one = m_drawn.back();
    for (std::size_t i = 0; i < 2; ++i) {
        const double radius_px = kEnd_px + (i == 0 ? kLineRim_px : 0.0);
        for (auto& end : one.ends[i]) {
            end = makeRing(0.0, radius_px, i == 0 ? kDarkRim : line.colour, i == 0 ? 2.0 : 3.0);
            if (m_overlay != nullptr) {
                m_overlay->AddActor(end);
            }
        }
        if (m_overlay != nullptr) {
            m_overlay->AddActor(one.line[i].actor());
        }
    }
}

void MeasureLines::place(const ViewFrame& frame, std::vector<Eigen::AlignedBox2d> taken,
                         const std::function<bool(const Vec3& p_W)>& isOff)
{
    std::vector<TouchLabels::Item> items;
    for (std::size_t n = 0; n < m_lines.size(); ++n) {
        const MeasureLine& line = m_lines[n];
        const Vec3 middle_W = 0.5 * (line.from_W + line.to_W);
        m_drawn[n].isFaint = isOff && (isOff(line.from_W) || isOff(line.to_W));
        const double opacity = m_drawn[n].isFaint ? kFaintOpacity : 1.0;
        for (std::size_t i = 0; i < 2; ++i) {
            // The coloured core in front of the rim.
            const Vec3 lift_W = static_cast<double>(i) * frame.mmPerPixel(middle_W) * frame.towardsViewer(middle_W);
            m_drawn[n].line[i].place(line.from_W + lift_W, line.to_W + lift_W, frame);
            placeBillboard(*m_drawn[n].ends[i][0], line.from_W, frame);
            placeBillboard(*m_drawn[n].ends[i][1], line.to_W, frame);
            m_drawn[n].line[i].actor()->GetProperty()->SetOpacity(opacity);
            for (auto& end : m_drawn[n].ends[i]) {
                end->GetProperty()->SetOpacity(opacity);
            }
        }
        items.push_back(itemOf(line, frame));
        if (m_drawn[n].isFaint) {
            items.back().colour = kFaintText;
            items.back().isLarge = false;
        }
        for (const Vec3& end_W : {line.from_W, line.to_W}) {
            const Eigen::Vector2d end = frame.pixelOf(end_W), room = Eigen::Vector2d::Constant(kClear_px);
            taken.emplace_back(end - room, end + room);
        }
    }
    m_labels.place(items, std::move(taken), frame);
}

core::Box MeasureLines::bounds() const
{
    core::Box box;
    for (const MeasureLine& line : m_lines) {
        box.extend(line.from_W);
        box.extend(line.to_W);
    }
    return box;
}

} // namespace palpate::view
