// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/PointedStructure.h"

#include "palpate/ui/VtkViewport.h"

#include <QLabel>

#include <algorithm>
#include <limits>

namespace palpate::ui {

namespace {

constexpr int kLook_ms = 16;  // one frame
constexpr int kAside_px = 16; // distance from the pointer

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
        const auto found = at(place);
        Q_EMIT clicked(found ? found->row : -1, modifiers);
    });
    connect(&model, &QAbstractItemModel::modelReset, m_name, &QWidget::hide);
}

std::optional<PointedStructure::Place> PointedStructure::at(const QPointF& place) const
{
    view::Ray ray = m_viewport.rayAt(place);
    view::SceneView& view = m_viewport.view();
    if (view.structureCount() != m_model.rows().size()) {
        return std::nullopt; // the scene is being replaced
    }
    const std::optional<geometry::SectionPlane>& section = view.section();
    const double before_mm = section ? section->distance_mm(ray.p_W) : 0.0;
    if (const double along = section ? -section->n_W.dot(ray.d_W) : 0.0; before_mm > 0.0 && along > 0.0) {
        // Everything in front of the section is hidden.
        ray.p_W += before_mm / along * ray.d_W;
        if (const auto cut = view.sectionPicture().structureAt(ray.p_W)) {
            return Place{static_cast<int>(*cut), 0, ray.p_W, true};
        }
    }
    std::optional<Place> found;
    double nearest_mm = std::numeric_limits<double>::infinity();
    if (const auto pick = view.pick(ray)) {
        const view::ViewStructure& one = view.structure(pick->structure);
        const std::vector<std::uint32_t>& source = m_model.rows()[pick->structure].loaded.surface->source;
        const auto triangle =
            std::lower_bound(source.begin(), source.end(), one.touchable->sourceTriangle(pick->hit.triangle));
        found = Place{static_cast<int>(pick->structure), static_cast<std::size_t>(triangle - source.begin()),
                      pick->hit.p_W};
        nearest_mm = pick->hit.distance_mm;
    }
    // The pick above covers palpable structures only: intersect the other visible meshes directly.
    for (std::size_t i = 0; i < view.structureCount(); ++i) {
        const view::Appearance& look = view.structure(i).picture.appearance();
        if (view.structure(i).touchable != nullptr || !look.isVisible || !(look.opacity > 0.0)) {
            continue;
        }
        const geometry::RepairedMesh& surface = *m_model.rows()[i].loaded.surface;
        const auto hit = view::firstHit(surface.mesh, surface.report.bounds, ray);
        if (hit && hit->distance_mm < nearest_mm) {
            found = Place{static_cast<int>(i), hit->triangle, hit->p_W};
            nearest_mm = hit->distance_mm;
        }
    }
    return found;
}

QString PointedStructure::textOf(const Place& place) const
{
    const QString name = readableName(m_model.structure(place.row).name);
    if (place.isOnCut) {
        return name;
    }
    const QString number = m_maps.textAt(place.row, place.triangle, place.p_W);
    const QString first = number.isEmpty() ? name : QStringLiteral("%1 · %2").arg(name, number);
    const QString more = m_more ? m_more(place) : QString();
    return more.isEmpty() ? first : first + QLatin1Char('\n') + more;
}

void PointedStructure::show()
{
    const auto place = at(m_place);
    m_name->setVisible(place.has_value());
    if (!place) {
        return;
    }
    m_name->setText(textOf(*place));
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
