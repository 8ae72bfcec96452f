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
    m_shown.clear();
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
        rings[used]->show(mark.p_W, mark.n_W, mark.radius_mm, mark.structure.value_or(0));
        m_shown.push_back({mark.p_W, mark.n_W, rings[used].get()});
        ++used;
    }
}

void TargetMarks::moveTo(std::size_t i, const core::Vec3& p_W, const core::Vec3& n_W)
{
    Shown& shown = m_shown[i];
    if (shown.p_W != p_W || shown.n_W != n_W) {
        shown.p_W = p_W;
        shown.n_W = n_W;
        shown.ring->moveTo(p_W, n_W);
    }
}

void TargetMarks::place(const std::vector<Eigen::AlignedBox2d>& taken, const ViewFrame& frame)
{
    std::vector<TouchLabels::Item> items;
    for (std::size_t i = 0; i < m_marks.size(); ++i) {
        const TargetMark& mark = m_marks[i];
        items.push_back(
            {mark.text, m_shown[i].p_W, Eigen::Vector2d(1.0, 0.0), mark.isFound ? kFoundColour : kMissedColour, false});
    }
    m_labels.place(items, taken, frame);
}

} // namespace palpate::view
