// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/PointedStructure.h"

#include "palpate/ui/Translated.h"
#include "palpate/ui/VtkViewport.h"

#include <palpate/view/SurfacePicker.h>

#include <QLabel>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace palpate::ui {

namespace {

constexpr int kLook_ms = 16;  // one frame
constexpr int kAside_px = 16; // distance from the pointer

/// Where a ray hits a structure as drawn.
std::optional<view::RayHit> hitOf(const view::ViewStructure& one, const geometry::RepairedMesh& surface,
                                  const view::Ray& ray)
{
    const view::MovedSurface& moved = one.picture.moved();
    if (one.touchable != nullptr) {
        return moved.motion == nullptr ? view::firstHit(*one.touchable, ray)
                                       : view::firstHit(*one.touchable, *moved.motion, moved.moment, ray);
    }
    // What cannot be touched has no hierarchy: the displacement of its middle is exact enough to point at it.
    const core::Vec3 middle = surface.report.bounds.center();
    const core::Vec3 shift = moved.motion == nullptr ? core::Vec3(core::Vec3::Zero())
                                                     : core::Vec3(moved.motion->toWorld(moved.moment, middle) - middle);
    auto hit = view::firstHit(surface.mesh, surface.report.bounds, {ray.p_W - shift, ray.d_W});
    if (hit) {
        hit->rest_W = hit->p_W;
        hit->p_W += shift;
    }
    return hit;
}

/// Where a ray meets the cut face of the section; empty if it starts behind the section or does not meet it.
std::optional<core::Vec3> onSection(const std::optional<geometry::SectionPlane>& section, const view::Ray& ray)
{
    const double before_mm = section ? section->distance_mm(ray.p_W) : 0.0;
    const double along = section ? -section->n_W.dot(ray.d_W) : 0.0;
    return before_mm > 0.0 && along > 0.0 ? std::optional<core::Vec3>(ray.p_W + before_mm / along * ray.d_W)
                                          : std::nullopt;
}

} // namespace

PointedStructure::PointedStructure(VtkViewport& viewport, const StructureModel& model, const MapDisplay& maps,
                                   QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_model(model)
    , m_maps(maps)
    , m_name(new QLabel(&viewport))
{
    m_name->setObjectName(QStringLiteral("pointed"));
    m_name->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_name->setTextFormat(Qt::PlainText);
    m_name->setAutoFillBackground(true);
    m_name->setBackgroundRole(QPalette::ToolTipBase);
    m_name->setForegroundRole(QPalette::ToolTipText);
    m_name->setMargin(4);
    m_name->hide();
    m_frame.setSingleShot(true);
    m_frame.setInterval(kLook_ms);
    connect(&m_frame, &QTimer::timeout, this, &PointedStructure::show);
    connect(&viewport, &VtkViewport::hovered, this, [this](const QPointF& place) {
        m_place = place;
        if (!m_frame.isActive()) {
            m_frame.start();
        }
    });
    connect(&viewport, &VtkViewport::hoverEnded, this, [this] {
        m_frame.stop();
        m_name->hide();
    });
    connect(&viewport, &VtkViewport::clicked, this, [this](const QPointF& place, Qt::KeyboardModifiers modifiers) {
        if (m_taker && m_taker(place)) {
            return;
        }
        const auto found = at(place);
        Q_EMIT clicked(found ? found->row : -1, modifiers);
    });
    connect(&model, &QAbstractItemModel::modelReset, m_name, &QWidget::hide);
}

std::optional<PointedStructure::Place> PointedStructure::at(const QPointF& place) const
{
    return at(place, 0.0);
}

std::optional<PointedStructure::Place> PointedStructure::at(const QPointF& place, double opacity) const
{
    view::Ray ray = m_viewport.rayAt(place);
    view::SceneView& view = m_viewport.view();
    if (view.structureCount() != m_model.rows().size()) {
        return std::nullopt; // the scene is being replaced
    }
    if (const auto start = onSection(view.section(), ray)) {
        ray.p_W = *start; // everything in front of the section is hidden
        if (const auto cut = view.sectionPicture().structureAt(ray.p_W)) {
            return Place{static_cast<int>(*cut), 0, ray.p_W, ray.p_W, true};
        }
        if (view.imageNumberAt(ray.p_W)) {
            return std::nullopt; // the image hides everything behind it
        }
    }
    std::optional<Place> found;
    double nearest_mm = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < view.structureCount(); ++i) {
        const view::ViewStructure& one = view.structure(i);
        const view::Appearance& look = one.picture.appearance();
        if (!look.isVisible || !(look.opacity > 0.0) || look.opacity < opacity) {
            continue;
        }
        const geometry::RepairedMesh& surface = *m_model.rows()[i].loaded.surface;
        const auto hit = hitOf(one, surface, ray);
        if (!hit || !(hit->distance_mm < nearest_mm)) {
            continue;
        }
        nearest_mm = hit->distance_mm;
        std::size_t triangle = hit->triangle;
        if (one.touchable != nullptr) {
            const std::vector<std::uint32_t>& source = surface.source;
            triangle = static_cast<std::size_t>(
                std::lower_bound(source.begin(), source.end(), one.touchable->sourceTriangle(hit->triangle)) -
                source.begin());
        }
        found = Place{static_cast<int>(i), triangle, hit->p_W, hit->rest_W};
    }
    return found;
}

QString PointedStructure::nameOf(const Place& place) const
{
    return readableName(m_model.structure(place.row).name);
}

QString PointedStructure::textOf(const Place& place) const
{
    const QString name = nameOf(place);
    if (place.isOnCut) {
        return name;
    }
    const QString number = m_maps.textAt(place.row, place.triangle, place.rest_W);
    const QString first = number.isEmpty() ? name : QStringLiteral("%1 · %2").arg(name, number);
    const QString more = m_more ? m_more(place) : QString();
    return more.isEmpty() ? first : first + QLatin1Char('\n') + more;
}

void PointedStructure::show()
{
    view::SceneView& view = m_viewport.view();
    if (m_viewport.mode() == VtkViewport::Mode::Palpate && view.cursor().state().isInContact) {
        m_name->hide(); // the numbers and the panel are about the hand, which keys may have led elsewhere
        return;
    }
    const auto place = at(m_place);
    const auto cut = onSection(view.section(), m_viewport.rayAt(m_place));
    const auto number = cut ? view.imageNumberAt(*cut) : std::nullopt;
    m_name->setVisible(place || number);
    if (!place && !number) {
        return;
    }
    const QString image = number ? tr("image: %1").arg(numberText(*number, 5)) : QString();
    m_name->setText(!number ? textOf(*place) : !place ? image : tr("%1 · %2").arg(textOf(*place), image));
    m_name->adjustSize();
    // Below and to the right of the pointer, or on the other side near the edges.
    const QSize size = m_name->size(), room = m_viewport.size();
    const QPoint at = m_place.toPoint();
    const int x =
        at.x() + kAside_px + size.width() < room.width() ? at.x() + kAside_px : at.x() - kAside_px - size.width();
    const int y =
        at.y() + kAside_px + size.height() < room.height() ? at.y() + kAside_px : at.y() - kAside_px - size.height();
    m_name->move(std::max(0, x), std::max(0, y));
    m_name->raise();
}

} // namespace palpate::ui

#include "palpate/ui/moc_PointedStructure.cpp"
