// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/TargetMarks.h"

#include <cstddef>
#include <utility>

namespace palpate::view {

namespace {

constexpr Colour kFoundColour{0.0, 0.80, 0.62};  // Okabe-Ito bluish green, lighter
constexpr Colour kMissedColour{1.0, 0.62, 0.10}; // Okabe-Ito orange

} // namespace

void TargetMarks::addTo(vtkRenderer& overlay)
{
    m_overlay = &overlay;
    m_labels.addTo(overlay);
}

void TargetMarks::set(std::vector<TargetMark> marks)
{
    m_marks = std::move(marks);
    for (auto* rings : {&m_found, &m_missed}) {
        for (const auto& ring : *rings) {
            ring->hide();
        }
    }
    std::size_t found = 0, missed = 0;
    for (const TargetMark& mark : m_marks) {
        auto& rings = mark.isFound ? m_found : m_missed;
        std::size_t& used = mark.isFound ? found : missed;
        if (used == rings.size()) {
            rings.push_back(std::make_unique<PlaceRing>(mark.isFound ? kFoundColour : kMissedColour));
            if (m_overlay != nullptr) {
                rings.back()->addTo(*m_overlay);
            }
        }
        rings[used]->show(mark.p_W, mark.n_W, mark.radius_mm, 0);
        ++used;
    }
}

void TargetMarks::place(const std::vector<Eigen::AlignedBox2d>& taken, const ViewFrame& frame)
{
    std::vector<TouchLabels::Item> items;
    for (const TargetMark& mark : m_marks) {
        items.push_back(
            {mark.text, mark.p_W, Eigen::Vector2d(1.0, 0.0), mark.isFound ? kFoundColour : kMissedColour, false});
    }
    m_labels.place(items, taken, frame);
}

} // namespace palpate::view
