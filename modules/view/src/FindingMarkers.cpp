// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/FindingMarkers.h"

#include <vtkRenderWindow.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace palpate::view {

namespace {

constexpr Colour kPin{0.98, 0.75, 0.14}; // seen on tissue and vessels alike, and no colour of a force
constexpr double kDisc_px = 5.0;
constexpr double kRim_px = kDisc_px + 1.5;
constexpr double kFont_px = 13.0;
constexpr double kLeader_px = 1.6;

} // namespace

FindingMarkers::~FindingMarkers() = default; // the renderer keeps what it draws

void FindingMarkers::set(const std::vector<Vec3>& places_W)
{
    for (const Marker& old : m_markers) {
        if (m_overlay != nullptr) {
            m_overlay->RemoveActor(old.rim);
            m_overlay->RemoveActor(old.disc);
            m_overlay->RemoveActor(old.number);
            m_overlay->RemoveActor(old.leader.actor());
        }
    }
    m_markers.clear();
    for (std::size_t i = 0; i < places_W.size(); ++i) {
        if (!places_W[i].allFinite()) {
            continue;
        }
        Marker one{places_W[i], makeRing(0.0, kRim_px, kDarkRim, 0.0), makeRing(0.0, kDisc_px, kPin, 0.5),
                   vtkSmartPointer<vtkBillboardTextActor3D>::New(), BillboardLine(kLeader_px, kPin)};
        one.number->PickableOff();
        one.number->SetInput((' ' + std::to_string(i + 1) + ' ').c_str());
        one.number->SetPosition(one.p_W.data());
        vtkTextProperty* text = one.number->GetTextProperty();
        text->SetBold(true);
        text->SetColor(kPin[0], kPin[1], kPin[2]);
        text->SetBackgroundColor(0.08, 0.09, 0.11);
        text->SetBackgroundOpacity(0.72);
        text->SetJustificationToCentered();
        text->SetVerticalJustificationToCentered();
        if (m_overlay != nullptr) {
            m_overlay->AddActor(one.rim);
            m_overlay->AddActor(one.disc);
            m_overlay->AddActor(one.number);
            m_overlay->AddActor(one.leader.actor());
        }
        m_markers.push_back(std::move(one));
    }
    m_labels.assign(m_markers.size(), {});
    m_pixelRatio = 0.0;
}

/// Sizes of the texts, which the font says.
void FindingMarkers::measure(double pixelRatio)
{
    vtkRenderWindow* window = m_overlay != nullptr ? m_overlay->GetRenderWindow() : nullptr;
    const int dpi = window != nullptr ? window->GetDPI() : 72;
    for (std::size_t i = 0; i < m_markers.size(); ++i) {
        vtkTextProperty* text = m_markers[i].number->GetTextProperty();
        text->SetFontSize(std::max(8, static_cast<int>(kFont_px * pixelRatio)));
        int box[4] = {0, 0, 0, 0};
        vtkTextRenderer::GetInstance()->GetBoundingBox(text, vtkStdString(m_markers[i].number->GetInput()), box, dpi);
        m_labels[i].size_px = Eigen::Vector2d(box[1] - box[0] + 1, box[3] - box[2] + 1) / pixelRatio;
    }
    m_pixelRatio = pixelRatio;
}

void FindingMarkers::place(const ViewFrame& frame)
{
    if (frame.pixelRatio != m_pixelRatio) {
        measure(frame.pixelRatio);
    }
    for (std::size_t i = 0; i < m_markers.size(); ++i) {
        const Vec3 fromEye = m_markers[i].p_W - frame.eye_W;
        const double size = frame.mmPerPixel(m_markers[i].p_W);
        m_labels[i].disc_px = Eigen::Vector2d(fromEye.dot(frame.right_W), fromEye.dot(frame.up_W)) / size;
    }
    placeLabels(m_labels, kRim_px);
    for (std::size_t i = 0; i < m_markers.size(); ++i) {
        Marker& one = m_markers[i];
        const DiscLabel& label = m_labels[i];
        one.rim->SetVisibility(m_isVisible);
        one.disc->SetVisibility(m_isVisible);
        one.number->SetVisibility(m_isVisible);
        one.leader.actor()->SetVisibility(m_isVisible && label.isMoved);
        placeBillboard(*one.rim, one.p_W, frame);
        placeBillboard(*one.disc, one.p_W, frame);
        one.number->SetDisplayOffset(static_cast<int>(std::lround(label.offset_px.x() * frame.pixelRatio)),
                                     static_cast<int>(std::lround(label.offset_px.y() * frame.pixelRatio)));
        // From the rim to the text's edge.
        const Eigen::Vector2d start = label.offset_px.normalized() * kRim_px;
        const double outside = (0.5 * label.size_px).cwiseQuotient(label.offset_px.cwiseAbs()).minCoeff();
        const Eigen::Vector2d end = label.offset_px * std::max(0.0, 1.0 - outside);
        const auto inView = [&](const Eigen::Vector2d& px) -> Vec3 {
            return one.p_W + (frame.right_W * px.x() + frame.up_W * px.y()) * frame.mmPerPixel(one.p_W);
        };
        one.leader.place(inView(start), inView(end), frame);
    }
}

core::Box FindingMarkers::bounds() const
{
    core::Box box;
    if (m_isVisible) {
        for (const Marker& one : m_markers) {
            box.extend(one.p_W);
        }
    }
    return box;
}

} // namespace palpate::view
