// SPDX-License-Identifier: BSD-3-Clause
#include "inside/PeekPart.h"

#include "shell/Notices.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QMainWindow>

#include <vtkCamera.h>

#include <algorithm>
#include <utility>

namespace palpate::app {

using core::Vec3;
using ui::ActionGroup;

namespace {

constexpr std::size_t kLines = 48; // lines of sight to the structure, from which the structures above are found

/// First hit on a structure, by its haptic surface if there is one.
std::optional<view::RayHit> hitOf(const study::OpenStructure& one, const view::Ray& ray)
{
    if (one.touch != nullptr) {
        return view::firstHit(*one.touch, ray);
    }
    return view::firstHit(one.loaded.surface->mesh, one.loaded.surface->report.bounds, ray);
}

} // namespace

PeekPart::PeekPart(const WindowCore& core, const ui::StructurePanel& structures, const ui::TouchPanel& touch)
    : WindowPart(&core.window)
    , m_core(core)
    , m_structures(structures)
    , m_touch(touch)
{
    connect(&core.viewport, &ui::VtkViewport::peekHeld, this, [this](bool isDown) {
        if (!isDown || m_core.actions.hasLetterKeys()) {
            m_core.actions.at("peek").setChecked(isDown && m_core.actions.at("peek").isEnabled());
        }
    });
    connect(&core.model, &QAbstractItemModel::modelReset, this, [this] {
        m_faded.clear();
        m_core.actions.at("peek").setChecked(false);
    });
}

void PeekPart::addActions()
{
    QAction* peek = m_core.actions.add("peek", ActionGroup::View, tr("Peek inside"),
                                       tr("Make everything above the touched structure, or else the selected one, "
                                          "nearly transparent; or hold G"));
    peek->setCheckable(true);
    connect(peek, &QAction::toggled, this, &PeekPart::setPeeking);
    m_core.actions.addGesture(ActionGroup::InView, tr("hold G"), tr("look through what is above the structure"));
}

void PeekPart::showState(const WindowState& state)
{
    m_core.actions.at("peek").setEnabled(state.hasScene);
}

void PeekPart::setPeeking(bool isPeeking)
{
    view::SceneView& view = m_core.viewport.view();
    for (const int row : std::exchange(m_faded, {})) {
        view.setAppearance(static_cast<std::size_t>(row), m_core.model.appearanceOf(row));
    }
    const std::optional<int> wanted = isPeeking ? target() : std::nullopt;
    if (isPeeking && !wanted) {
        m_core.notices.say(tr("Peek: touch or select the structure that you want to see."));
    }
    if (wanted) {
        m_faded = above(*wanted);
        for (const int row : m_faded) {
            view::Appearance look = m_core.model.appearanceOf(row);
            look.opacity = std::min(look.opacity, kOpacity);
            view.setAppearance(static_cast<std::size_t>(row), look);
        }
        if (m_faded.empty()) {
            m_core.notices.say(
                tr("Peek: nothing is above %1.").arg(ui::readableName(m_core.model.structure(*wanted).name)));
        }
    }
    m_core.viewport.update();
}

/// The innermost structure under the hand, else the selected one.
std::optional<int> PeekPart::target() const
{
    const QString touched = ui::palpatedStructure(m_touch.reading()).name;
    for (int row = 0; row < m_core.model.rowCount() && !touched.isEmpty(); ++row) {
        const std::string& name = m_core.model.structure(row).name;
        if (touched == QString::fromStdString(name) || touched == ui::readableName(name)) {
            return row;
        }
    }
    const std::vector<int> selected = m_structures.selectedRows();
    return selected.empty() ? std::nullopt : std::optional(selected.front());
}

/// Visible structures that a line of sight to the structure meets first.
std::vector<int> PeekPart::above(int target) const
{
    const std::vector<study::OpenStructure>& rows = m_core.model.rows();
    const auto wanted = static_cast<std::size_t>(target);
    const std::vector<Vec3>& vertices = rows[wanted].loaded.surface->mesh.vertices;
    view::SceneView& view = m_core.viewport.view();
    const Vec3 eye_W(view.camera().GetPosition());
    std::vector<view::Ray> lines;
    std::vector<double> lengths_mm;
    const std::size_t step = std::max<std::size_t>(1, vertices.size() / kLines);
    for (std::size_t i = 0; i < vertices.size(); i += step) {
        // What is behind the front of the structure, such as the content of an organ, is not above it.
        const view::Ray line{eye_W, (vertices[i] - eye_W).normalized()};
        const auto front = hitOf(rows[wanted], line);
        lines.push_back(line);
        lengths_mm.push_back(front ? front->distance_mm : (vertices[i] - eye_W).norm());
    }
    std::vector<int> found;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const meshio::SceneStructure& look = rows[i].loaded.description;
        if (i == wanted || !rows[i].isThere() || !look.visible) {
            continue;
        }
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const auto hit = hitOf(rows[i], lines[k]);
            if (hit && hit->distance_mm < lengths_mm[k]) {
                found.push_back(static_cast<int>(i));
                break;
            }
        }
    }
    return found;
}

} // namespace palpate::app

#include "moc_PeekPart.cpp"
