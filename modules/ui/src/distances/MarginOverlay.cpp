// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/MarginOverlay.h"

#include "palpate/ui/Translated.h"
#include "palpate/ui/VtkViewport.h"

#include <palpate/geometry/SurfaceDistance.h>
#include <palpate/view/MarginColours.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace palpate::ui {

using core::Vec3;

namespace {

constexpr view::Colour kPairColour{1.0, 1.0, 1.0};
constexpr view::Colour kTapeColour{1.0, 0.85, 0.35};

/// Distance of each point of a picture to a surface. [mm]
std::vector<float> distancesTo(const geometry::SurfaceIndex& surface, vtkPolyData& picture)
{
    std::vector<float> distances;
    Vec3 before = Vec3::Zero();
    for (vtkIdType i = 0; i < picture.GetNumberOfPoints(); ++i) {
        const Vec3 p(picture.GetPoint(i));
        const auto within = distances.empty() ? std::nullopt : std::optional(distances.back() + (p - before).norm());
        // Single precision may round the bound of the neighbour down.
        const auto nearest = geometry::nearestPoint(surface, p, within ? std::optional(*within * 1.001) : within);
        distances.push_back(static_cast<float>(nearest ? nearest->distance_mm : *within));
        before = p;
    }
    return distances;
}

} // namespace

MarginOverlay::MarginOverlay(VtkViewport& viewport, StructureModel& model, SceneDistances& distances, MapDisplay& maps,
                             const TapesModel& tapes, const TapeTool& tool, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_model(model)
    , m_distances(distances)
    , m_maps(maps)
    , m_tapes(tapes)
    , m_tool(tool)
    , m_flight(viewport)
{
    m_thread.setMaxThreadCount(1);
    connect(&distances, &SceneDistances::outdated, this, [this] { choose(std::nullopt); });
    connect(&model, &QAbstractItemModel::modelAboutToBeReset, this, [this] { choose(std::nullopt); });
    connect(&tapes, &TapesModel::changed, this, [this] { chooseTape(-1); });
    connect(&tool, &TapeTool::changed, this, &MarginOverlay::drawLines);
}

MarginOverlay::~MarginOverlay()
{
    m_thread.waitForDone();
}

void MarginOverlay::setShown(bool isShown)
{
    if (isShown != m_isShown) {
        m_isShown = isShown;
        draw();
    }
}

void MarginOverlay::choose(std::optional<std::size_t> pair)
{
    m_pair = pair;
    draw();
}

void MarginOverlay::chooseTape(int row)
{
    m_tape = row;
    drawLines();
}

const study::LumpMargin* MarginOverlay::marginOf(std::size_t pair) const
{
    const study::DistanceTable& table = m_distances.table();
    const study::PairDistance& of = table.pairs[pair];
    const auto found = std::find_if(table.margins.begin(), table.margins.end(), [&of](const study::LumpMargin& margin) {
        return margin.lump == of.first && margin.structure == of.second;
    });
    return found == table.margins.end() ? nullptr : &*found;
}

void MarginOverlay::draw()
{
    undraw();
    drawLines();
    const study::LumpMargin* margin = m_isShown && m_pair ? marginOf(*m_pair) : nullptr;
    if (margin != nullptr) {
        colour(*margin);
    }
}

void MarginOverlay::drawLines()
{
    std::vector<view::MeasureLine> lines;
    for (std::size_t i = 0; i < m_tapes.tapes().size(); ++i) {
        const core::Tape& tape = m_tapes.tapes()[i];
        lines.push_back({tape.from_W, tape.to_W, lengthText(tape.length_mm()).toStdString(), kTapeColour,
                         static_cast<int>(i) == m_tape});
    }
    if (const auto& begun = m_tool.begun()) {
        lines.push_back({begun->from_W, begun->to_W, lengthText(begun->length_mm()).toStdString(), kTapeColour, true});
    }
    if (m_isShown && m_pair) {
        const geometry::SurfaceDistance& found = m_distances.table().pairs[*m_pair].found;
        lines.push_back({found.onFirst, found.onSecond, lengthText(found.surface_mm).toStdString(), kPairColour, true});
    }
    m_viewport.view().measures().set(std::move(lines));
    m_viewport.update();
}

/// Colours the lump on a worker thread.
void MarginOverlay::colour(const study::LumpMargin& margin)
{
    const auto row = static_cast<int>(margin.lump);
    const std::shared_ptr<const geometry::SurfaceIndex> structure = m_distances.indices()[margin.structure];
    const double edge_mm = 0.01 * m_distances.indices()[margin.lump]->bounds().diagonal().norm();
    m_thread.start([this, number = ++m_asked, row, structure, edge_mm, limits_mm = m_distances.limits_mm(),
                    picture = m_model.picture(row), margin] {
        if (number != m_asked) {
            return;
        }
        const vtkSmartPointer<vtkPolyData> fine = view::refinedPicture(*picture, edge_mm);
        const auto coloured = view::marginColoured(*fine, distancesTo(*structure, *fine), limits_mm);
        QMetaObject::invokeMethod(this, [this, number, row, coloured, margin] {
            if (number == m_asked) {
                m_maps.setCovered(true);
                m_viewport.view().setPicture(static_cast<std::size_t>(row), coloured);
                m_drawn = row;
                fadeAround(margin.lump);
                drawLegend(margin);
                m_viewport.update();
            }
        });
    });
}

/// Makes translucent structures more transparent, so that they do not tint the bands.
void MarginOverlay::fadeAround(std::size_t lump)
{
    constexpr double kTranslucent = 0.75, kFaded = 0.15;
    for (int row = 0; row < m_model.rowCount(); ++row) {
        view::Appearance look = m_model.appearanceOf(row);
        if (static_cast<std::size_t>(row) != lump && look.isVisible && look.opacity < kTranslucent) {
            look.opacity = std::min(look.opacity, kFaded);
            m_viewport.view().setAppearance(static_cast<std::size_t>(row), look);
            m_faded.push_back(row);
        }
    }
}

void MarginOverlay::drawLegend(const study::LumpMargin& margin)
{
    const study::DistanceTable& table = m_distances.table();
    view::ColourLegend::Content content;
    content.title = tr("%1\nto %2,\nshare of its area")
                        .arg(QString::fromStdString(table.sizes[margin.lump].name),
                             QString::fromStdString(table.sizes[margin.structure].name))
                        .toStdString();
    content.briefTitle = tr("Distance").toStdString();
    const std::vector<core::Message> clauses = study::clauses(table, margin);
    const std::size_t count = margin.found.shares.size();
    content.range.high = static_cast<double>(count);
    for (std::size_t band = 0; band < count; ++band) {
        content.steps.push_back(view::marginColour(band, count));
        content.marks.push_back({static_cast<double>(band) + 0.5, translated(clauses[band]).toStdString(), {}});
    }
    m_viewport.view().legend().show(content);
}

void MarginOverlay::undraw()
{
    ++m_asked;
    if (!m_drawn) {
        return;
    }
    for (const int row : m_faded) {
        if (m_viewport.view().structureCount() > static_cast<std::size_t>(row)) {
            m_viewport.view().setAppearance(static_cast<std::size_t>(row), m_model.appearanceOf(row));
        }
    }
    m_faded.clear();
    if (*m_drawn < m_model.rowCount() && m_viewport.view().structureCount() > static_cast<std::size_t>(*m_drawn)) {
        m_viewport.view().setPicture(static_cast<std::size_t>(*m_drawn), m_model.picture(*m_drawn));
    }
    m_drawn.reset();
    m_viewport.view().legend().hide();
    m_maps.setCovered(false);
    m_viewport.update();
}

void MarginOverlay::fly(const Vec3& from_W, const Vec3& to_W)
{
    core::ViewPose pose = viewPose(m_viewport);
    const Vec3 middle_W = 0.5 * (from_W + to_W);
    pose.position_W += middle_W - pose.focus_W;
    pose.focus_W = middle_W;
    m_flight.flyTo(pose);
}

void MarginOverlay::flyToPair()
{
    if (m_pair) {
        const geometry::SurfaceDistance& found = m_distances.table().pairs[*m_pair].found;
        fly(found.onFirst, found.onSecond);
    }
}

void MarginOverlay::flyToTape()
{
    if (m_tape >= 0) {
        const core::Tape& tape = m_tapes.tapes()[static_cast<std::size_t>(m_tape)];
        fly(tape.from_W, tape.to_W);
    }
}

} // namespace palpate::ui

#include "palpate/ui/moc_MarginOverlay.cpp"
