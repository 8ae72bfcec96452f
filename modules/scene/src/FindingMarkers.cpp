// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scene/FindingMarkers.h"

#include <vtkTextProperty.h>

#include <algorithm>
#include <string>

namespace palpate::scene {

namespace {

constexpr Colour kPin{0.98, 0.75, 0.14}; // seen on tissue and vessels alike, and no colour of a force
constexpr Colour kDark{0.07, 0.08, 0.10};
constexpr double kDisc_px = 5.0;
constexpr double kFont_px = 13.0;

} // namespace

FindingMarkers::~FindingMarkers() = default; // the renderer keeps what it draws

void FindingMarkers::set(const std::vector<Vec3>& places_W)
{
    for (const Marker& old : m_markers) {
        if (m_overlay != nullptr) {
            m_overlay->RemoveActor(old.rim);
            m_overlay->RemoveActor(old.disc);
            m_overlay->RemoveActor(old.number);
        }
    }
    m_markers.clear();
    for (std::size_t i = 0; i < places_W.size(); ++i) {
        if (!places_W[i].allFinite()) {
            continue;
        }
        Marker one{places_W[i], makeRing(0.0, kDisc_px + 1.5, kDark, 0.0), makeRing(0.0, kDisc_px, kPin, 0.5),
                   vtkSmartPointer<vtkBillboardTextActor3D>::New()};
        one.number->PickableOff();
        one.number->SetInput((' ' + std::to_string(i + 1) + ' ').c_str());
        one.number->SetPosition(one.p_W.data());
        vtkTextProperty* text = one.number->GetTextProperty();
        text->SetBold(true);
        text->SetColor(kPin[0], kPin[1], kPin[2]);
        text->SetBackgroundColor(0.08, 0.09, 0.11);
        text->SetBackgroundOpacity(0.72);
        text->SetJustificationToLeft();
        text->SetVerticalJustificationToCentered();
        if (m_overlay != nullptr) {
            m_overlay->AddActor(one.rim);
            m_overlay->AddActor(one.disc);
            m_overlay->AddActor(one.number);
        }
        m_markers.push_back(std::move(one));
    }
}

void FindingMarkers::place(const ViewFrame& frame)
{
    for (const Marker& one : m_markers) {
        one.rim->SetVisibility(m_isVisible);
        one.disc->SetVisibility(m_isVisible);
        one.number->SetVisibility(m_isVisible);
        placeBillboard(*one.rim, one.p_W, frame);
        placeBillboard(*one.disc, one.p_W, frame);
        one.number->GetTextProperty()->SetFontSize(std::max(8, static_cast<int>(kFont_px * frame.pixelRatio)));
        one.number->SetDisplayOffset(static_cast<int>((kDisc_px + 4.0) * frame.pixelRatio),
                                     static_cast<int>(10.0 * frame.pixelRatio));
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

} // namespace palpate::scene
