// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TouchMap.h"

#include "palpate/ui/StructureModel.h"
#include "palpate/ui/Translated.h"
#include "palpate/ui/VtkViewport.h"

#include <palpate/core/Quantity.h>
#include <palpate/session/CompareSessions.h>
#include <palpate/view/SurfaceColours.h>
#include <palpate/view/SurfaceMesh.h>

#include <QAbstractItemModel>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace palpate::ui {

namespace {

constexpr int kRedraw_ms = 250;

/// Values to draw: NaN where the quantity is not known.
std::vector<float> valuesOf(const TouchedStructure& touched, TouchQuantity quantity)
{
    std::vector<float> values = quantity == TouchQuantity::PeakForce   ? touched.peakForce_N
                                : quantity == TouchQuantity::Stiffness ? touched.stiffness_N_per_mm
                                                                       : touched.dwell_s;
    for (float& value : values) {
        value = !(value > 0.0F)                      ? std::numeric_limits<float>::quiet_NaN()
                : quantity == TouchQuantity::Covered ? 1.0F
                                                     : value;
    }
    return values;
}

QString areaText(double area_mm2, double all_mm2)
{
    const double percent = 100.0 * area_mm2 / all_mm2;
    return TouchMap::tr("%1, %2 %")
        .arg(translated(core::areaText(area_mm2)), QLocale().toString(percent, 'f', percent < 1.0 ? 1 : 0));
}

} // namespace

QString touchQuantityText(TouchQuantity quantity)
{
    switch (quantity) {
    case TouchQuantity::Covered:
        return TouchMap::tr("Examined surface");
    case TouchQuantity::Dwell:
        return TouchMap::tr("Time spent");
    case TouchQuantity::PeakForce:
        return TouchMap::tr("Largest force");
    case TouchQuantity::Stiffness:
        return TouchMap::tr("Stiffness felt");
    case TouchQuantity::None:
        break;
    }
    return TouchMap::tr("No map");
}

TouchMap::TouchMap(VtkViewport& viewport, StructureModel& model, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_model(model)
{
    m_redraw.setSingleShot(true);
    m_redraw.setInterval(kRedraw_ms);
    connect(&m_redraw, &QTimer::timeout, this, [this] {
        if (m_live != nullptr && m_quantity != TouchQuantity::None && m_first.recording.empty()) {
            m_first.sums = touchSums(*m_live, m_liveMeshes, m_live_s, m_first.sums.get());
            draw();
        }
    });
    connect(&model, &StructureModel::edited, this, [this] {
        if (m_first.reader != nullptr && meshes().size() != m_meshes) { // a surface got ready, was removed or restored
            m_first.reader = nullptr;
            m_second.reader = nullptr;
            read();
        }
    });
    connect(&model, &QAbstractItemModel::modelReset, this, [this] { // the view has new pictures
        m_pictures.clear();
        m_live = nullptr;
        forget();
        m_drawn.clear();
        undraw();
        read();
    });
}

TouchMap::~TouchMap()
{
    forget(); // the threads of the readers post to this object
}

void TouchMap::forget()
{
    for (Source* source : {&m_first, &m_second}) {
        source->reader = nullptr;
        source->sums = nullptr;
    }
}

void TouchMap::show(TouchQuantity quantity)
{
    m_quantity = quantity;
    if (quantity == TouchQuantity::None) {
        undraw();
        return;
    }
    read();
    draw();
}

void TouchMap::setRecording(const std::filesystem::path& recording)
{
    if (recording == m_first.recording) {
        return;
    }
    undraw();
    forget();
    m_first.recording = recording;
    m_first.position_s = 0.0;
    read();
}

void TouchMap::setSecond(const std::filesystem::path& recording, double distance_mm)
{
    if (recording == m_second.recording) {
        return;
    }
    forget();
    m_second.recording = recording;
    m_second.position_s = 0.0;
    m_compared_mm = recording.empty() ? std::nullopt : std::optional(distance_mm);
    read();
}

void TouchMap::setPosition(double time_s)
{
    m_first.position_s = time_s;
    read(m_first);
}

void TouchMap::setSecondPosition(double time_s)
{
    m_second.position_s = time_s;
    read(m_second);
}

void TouchMap::restart(double distance_mm)
{
    m_distance_mm = distance_mm;
    m_live = nullptr;
    m_live_s = 0.0;
    if (m_first.recording.empty()) {
        undraw();
        m_first.sums = nullptr;
    }
}

void TouchMap::add(const servo::TickRecord& tick, double dt_s)
{
    if (m_quantity == TouchQuantity::None || !m_first.recording.empty() ||
        (m_live == nullptr && tick.felt.contactCount == 0)) { // before the first contact, surfaces may not be ready
        return;
    }
    if (m_live == nullptr) {
        m_liveMeshes = meshes();
        const auto keyOf = [this](std::uint32_t /*scene*/, std::uint32_t structure) {
            const auto& rows = m_model.rows();
            return structure < rows.size()
                       ? session::StructureKey(rows[structure].loaded.description.name, rows[structure].sha256)
                       : session::StructureKey();
        };
        m_live = std::make_unique<session::TouchedSurfaces>(m_liveMeshes, keyOf, m_distance_mm);
    }
    m_live_s += dt_s;
    m_live->add(tick, m_live_s, dt_s);
    if (!m_redraw.isActive()) {
        m_redraw.start();
    }
}

session::MeshesByHash TouchMap::meshes() const
{
    session::MeshesByHash meshes;
    for (const study::OpenStructure& row : m_model.rows()) {
        if (!row.sha256.empty() && row.isThere()) {
            meshes[row.sha256] = row.loaded.surface;
        }
    }
    return meshes;
}

/// Requests the sums of the recordings, once a map is shown.
void TouchMap::read()
{
    read(m_first);
    read(m_second);
}

void TouchMap::read(Source& source)
{
    if (m_quantity == TouchQuantity::None || source.recording.empty()) {
        return;
    }
    if (source.reader == nullptr) {
        m_meshes = meshes().size();
        source.number = ++m_readers;
        source.reader = std::make_unique<RecordedTouchSums>(
            source.recording, meshes(), m_compared_mm,
            [this, &source, number = source.number](std::shared_ptr<const TouchSums> sums) {
                QMetaObject::invokeMethod(
                    this,
                    [this, &source, number, sums = std::move(sums)] {
                        if (number == source.number && source.reader != nullptr) { // else of another recording or scene
                            source.sums = sums;
                            draw();
                        }
                    },
                    Qt::QueuedConnection);
            },
            [this](const core::Status& status) {
                QMetaObject::invokeMethod(
                    this, [this, status] { Q_EMIT failed(translated(status)); }, Qt::QueuedConnection);
            });
    }
    source.reader->setEnd(source.position_s);
}

vtkSmartPointer<vtkPolyData> TouchMap::plainPicture(int row, const TouchedStructure& touched)
{
    if (!touched.isSplit) {
        return m_model.picture(row);
    }
    Picture& picture = m_pictures[row];
    if (picture.surface != touched.surface) {
        picture = {touched.surface, view::makeSurface(*touched.surface)};
    }
    return picture.plain;
}

bool TouchMap::isCompared() const
{
    return m_quantity == TouchQuantity::Covered && !m_second.recording.empty();
}

std::vector<TouchMap::Drawn> TouchMap::touchedStructures() const
{
    std::vector<Drawn> all;
    for (int row = 0; row < m_model.rowCount(); ++row) {
        const study::OpenStructure& open = m_model.rows()[static_cast<std::size_t>(row)];
        const auto in = [&](const Source& source) -> const TouchedStructure* {
            const auto found = source.sums->structures.find({open.loaded.description.name, open.sha256});
            return found == source.sums->structures.end() ? nullptr : &found->second;
        };
        const Drawn one{row, in(m_first), isCompared() ? in(m_second) : nullptr};
        if (open.isThere() && (one.first != nullptr || one.second != nullptr)) {
            all.push_back(one);
        }
    }
    return all;
}

void TouchMap::draw()
{
    if (m_quantity == TouchQuantity::None || m_first.sums == nullptr || (isCompared() && m_second.sums == nullptr)) {
        return;
    }
    const std::vector<Drawn> touched = touchedStructures();
    m_isShown = true;
    Q_EMIT shownChanged(true);
    for (const int row : std::exchange(m_drawn, {})) { // at this moment not touched yet
        if (std::none_of(touched.begin(), touched.end(), [row](const Drawn& one) { return one.row == row; })) {
            restore(row);
        }
    }
    if (isCompared()) {
        drawCompared(touched);
    } else {
        drawValues(touched);
    }
    m_viewport.update();
    Q_EMIT drawn();
}

/// Shows a coloured picture, opaque: colours would mix with what lies behind.
void TouchMap::paint(int row, vtkPolyData& picture)
{
    view::Appearance look = m_model.appearanceOf(row);
    look.opacity = 1.0;
    m_viewport.view().setAppearance(static_cast<std::size_t>(row), look);
    m_viewport.view().setPicture(static_cast<std::size_t>(row), &picture);
    m_drawn.push_back(row);
}

void TouchMap::drawValues(const std::vector<Drawn>& touched)
{
    std::vector<std::vector<float>> values;
    std::vector<float> all;
    for (const Drawn& one : touched) {
        values.push_back(valuesOf(*one.first, m_quantity));
        all.insert(all.end(), values.back().begin(), values.back().end());
    }
    const double high = m_quantity == TouchQuantity::Covered ? 1.0 : session::mapEnd(all);
    double all_mm2 = 0.0, covered_mm2 = 0.0, above_mm2 = 0.0;
    for (std::size_t i = 0; i < touched.size(); ++i) {
        const TouchedStructure& one = *touched[i].first;
        for (std::size_t v = 0; v < values[i].size(); ++v) {
            const double share_mm2 = one.share_mm2[v];
            all_mm2 += share_mm2;
            covered_mm2 += one.dwell_s[v] > 0.0F ? share_mm2 : 0.0;
            above_mm2 += double{values[i][v]} > high ? share_mm2 : 0.0;
        }
        paint(touched[i].row, *view::coloured(*plainPicture(touched[i].row, one), *one.surface, values[i], false,
                                              {0.0, high}, m_model.appearanceOf(touched[i].row).colour));
    }
    drawLegend(high, all_mm2, covered_mm2, above_mm2);
}

void TouchMap::drawCompared(const std::vector<Drawn>& touched)
{
    using session::TouchedBy;
    double all_mm2 = 0.0;
    std::array<double, 4> areas_mm2{}; // by TouchedBy
    for (const Drawn& one : touched) {
        const TouchedStructure& any = one.first != nullptr ? *one.first : *one.second;
        const view::Colour own = m_model.appearanceOf(one.row).colour;
        const std::array<view::Colour, 4> colourBy{own, view::kFirstColour, view::kSecondColour, view::kBothColour};
        std::vector<view::Colour> colours;
        for (std::size_t v = 0; v < any.dwell_s.size(); ++v) {
            const auto isTouched = [v](const TouchedStructure* in) { return in != nullptr && in->dwell_s[v] > 0.0F; };
            const auto by = static_cast<std::size_t>(session::touchedBy(isTouched(one.first), isTouched(one.second)));
            areas_mm2[by] += any.share_mm2[v];
            all_mm2 += any.share_mm2[v];
            colours.push_back(colourBy[by]);
        }
        paint(one.row, *view::coloured(*plainPicture(one.row, any), *any.surface, colours));
    }
    const auto until = [](const Source& source) { return QLocale().toString(source.sums->time_s, 'f', 1); };
    view::ColourLegend::Content content;
    content.title = QStringList{touchQuantityText(m_quantity),
                                tr("A up to %1 s, B up to %2 s").arg(until(m_first), until(m_second))}
                        .join(QLatin1Char('\n'))
                        .toStdString();
    content.range = {0.0, 3.0};
    content.steps = {view::kFirstColour, view::kBothColour, view::kSecondColour};
    const auto area = [&](TouchedBy by) {
        return all_mm2 > 0.0 ? areaText(areas_mm2[static_cast<std::size_t>(by)], all_mm2) : tr("nothing touched yet");
    };
    content.briefTitle = touchQuantityText(m_quantity).toStdString();
    content.marks = {{0.5, tr("only A: %1").arg(area(TouchedBy::First)).toStdString(), tr("only A").toStdString()},
                     {1.5, tr("both: %1").arg(area(TouchedBy::Both)).toStdString(), tr("both").toStdString()},
                     {2.5, tr("only B: %1").arg(area(TouchedBy::Second)).toStdString(), tr("only B").toStdString()}};
    m_viewport.view().legend().show(content);
}

void TouchMap::drawLegend(double high, double all_mm2, double covered_mm2, double above_mm2)
{
    QStringList lines{m_quantity == TouchQuantity::Dwell       ? tr("Time spent, s")
                      : m_quantity == TouchQuantity::PeakForce ? tr("Largest force, N")
                      : m_quantity == TouchQuantity::Stiffness ? tr("Stiffness felt, N/mm")
                                                               : touchQuantityText(m_quantity)};
    const QString until = QLocale().toString(m_first.sums->time_s, 'f', 1);
    lines << (m_first.recording.empty() ? tr("live, %1 s (preview)").arg(until) : tr("up to %1 s").arg(until));
    lines << (m_drawn.empty() ? tr("nothing touched yet") : tr("touched: %1").arg(areaText(covered_mm2, all_mm2)));
    if (above_mm2 > 0.0) {
        lines << tr("above %1: %2").arg(numberText(high), areaText(above_mm2, all_mm2));
    }
    view::ColourLegend::Content content;
    content.title = lines.join(QLatin1Char('\n')).toStdString();
    content.briefTitle = lines.front().toStdString();
    content.range = {0.0, high};
    if (m_quantity == TouchQuantity::Covered) {
        content.marks = {{1.0, tr("touched").toStdString(), {}}};
    } else {
        for (const double value : {0.0, 0.5 * high, high}) {
            content.marks.push_back({value, numberText(value).toStdString(), {}});
        }
    }
    m_viewport.view().legend().show(content);
}

/// Gives a structure its own colour and opacity again.
void TouchMap::restore(int row)
{
    if (row < m_model.rowCount()) {
        m_viewport.view().setPicture(static_cast<std::size_t>(row), m_model.picture(row));
        m_viewport.view().setAppearance(static_cast<std::size_t>(row), m_model.appearanceOf(row));
    }
}

void TouchMap::undraw()
{
    if (!std::exchange(m_isShown, false)) {
        return; // the legend may be that of other colours
    }
    for (const int row : m_drawn) {
        restore(row);
    }
    m_drawn.clear();
    m_viewport.view().legend().hide();
    m_viewport.update();
    Q_EMIT shownChanged(false);
}

} // namespace palpate::ui

#include "palpate/ui/moc_TouchMap.cpp"
