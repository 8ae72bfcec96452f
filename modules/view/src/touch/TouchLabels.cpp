// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/TouchLabels.h"

#include <vtkRenderWindow.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>

namespace palpate::view {

namespace {

constexpr double kBorder_px = 4.0; // margin to the border of the view

} // namespace

void TouchLabels::add()
{
    Label& one = m_labels.emplace_back(Label{vtkSmartPointer<vtkTextActor>::New(), {}});
    one.actor->PickableOff();
    one.actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
    vtkTextProperty* text = one.actor->GetTextProperty();
    text->SetBackgroundColor(kTextGround[0], kTextGround[1], kTextGround[2]);
    text->SetJustificationToLeft();
    text->SetVerticalJustificationToBottom();
    if (m_overlay != nullptr) {
        m_overlay->AddActor2D(one.actor);
    }
}

void TouchLabels::place(const std::vector<Item>& items, std::vector<Eigen::AlignedBox2d> taken, const ViewFrame& frame)
{
    m_boxes.clear();
    while (m_labels.size() < items.size()) {
        add();
    }
    const Eigen::Vector2d half(0.5 * frame.width_px, 0.5 * frame.height_px);
    const Eigen::Vector2d inner = (half - Eigen::Vector2d::Constant(kBorder_px)).cwiseMax(1.0);
    const Eigen::AlignedBox2d view(-inner, inner);
    vtkRenderWindow* window = m_overlay != nullptr ? m_overlay->GetRenderWindow() : nullptr;
    const int dpi = window != nullptr ? window->GetDPI() : 72;
    for (std::size_t i = 0; i < m_labels.size(); ++i) {
        Label& one = m_labels[i];
        const bool isShown = i < items.size() && !items[i].text.empty() && items[i].p_W.allFinite();
        one.actor->SetVisibility(isShown);
        if (!isShown) {
            one.layout.place = -1;
            continue;
        }
        const Item& item = items[i];
        const std::string padded = ' ' + item.text + ' ';
        vtkTextProperty* text = one.actor->GetTextProperty();
        text->SetColor(item.colour[0], item.colour[1], item.colour[2]);
        text->SetBackgroundOpacity(frame.text.groundOpacity);
        setFont(*text, frame.text, item.isLarge ? TextUse::Large : TextUse::Usual, frame.pixelRatio);
        one.actor->SetInput(padded.c_str());
        int box[4] = {0, 0, 0, 0};
        vtkTextRenderer::GetInstance()->GetBoundingBox(text, vtkStdString(padded), box, dpi);
        one.layout.size_px = Eigen::Vector2d(box[1] - box[0] + 1, box[3] - box[2] + 1) / frame.pixelRatio;
        one.layout.point_px = frame.pixelOf(item.p_W);
        one.layout.towards = item.towards;
        const Eigen::Vector2d centre = placeBeside(one.layout, taken, view);
        const Eigen::AlignedBox2d own(centre - 0.5 * one.layout.size_px, centre + 0.5 * one.layout.size_px);
        const Eigen::Vector2d corner = (own.min() + half) * frame.pixelRatio;
        one.actor->SetPosition(std::round(corner.x()) - box[0], std::round(corner.y()) - box[2]);
        m_boxes.push_back(own);
        taken.push_back(own);
    }
}

std::vector<std::string> TouchLabels::texts() const
{
    std::vector<std::string> texts;
    for (const Label& one : m_labels) {
        if (one.actor->GetVisibility() != 0) {
            const std::string padded = one.actor->GetInput();
            texts.push_back(padded.substr(1, padded.size() - 2));
        }
    }
    return texts;
}

} // namespace palpate::view
