// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/MapDisplay.h"

#include "palpate/ui/Translated.h"
#include "palpate/ui/VtkViewport.h"

#include <palpate/study/DeviceLimit.h>
#include <palpate/study/FeltMap.h>
#include <palpate/view/SurfaceColours.h>

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate::ui {

namespace {

const QString kFelt = QStringLiteral("felt:");
const QString kArray = QStringLiteral("array:");

QString keyOf(const meshio::SurfaceMap& map)
{
    const std::string_view name = core::traitsOf(map.mapping.quantity).name;
    return kFelt + QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

/// Meaning and unit of an array's values according to the maps that use the array; empty without a map.
QString unitOf(const meshio::LoadedStructure& structure, const std::string& array)
{
    for (const meshio::SurfaceMap& map : structure.maps) {
        if (map.mapping.array == array && map.mapping.quantity == core::MappedQuantity::Stiffness) {
            switch (map.mapping.unit) {
            case core::MapUnit::YoungKPa:
                return MapDisplay::tr("Young's modulus, kPa");
            case core::MapUnit::ShearKPa:
                return MapDisplay::tr("shear modulus, kPa");
            default:
                break;
            }
        }
    }
    return {};
}

QString feltTitle(const meshio::SurfaceMap& map, const core::Tissue& tissue)
{
    switch (map.mapping.quantity) {
    case core::MappedQuantity::Damping:
        return MapDisplay::tr("damping, N·s/mm");
    case core::MappedQuantity::Friction:
        return MapDisplay::tr("friction, relative to the tissue");
    case core::MappedQuantity::Stiffness:
        break;
    }
    return tissue.law.kind == core::LawKind::Linear ? MapDisplay::tr("felt stiffness, N/mm")
                                                    : MapDisplay::tr("felt stiffness, relative to the law");
}

/// Upper limit of a mapped quantity, in the unit of study::feltMap.
double mostOf(const meshio::SurfaceMap& map, const core::Tissue& tissue, const haptics::HapticStructure& felt)
{
    switch (map.mapping.quantity) {
    case core::MappedQuantity::Damping:
        return study::maxDamping(felt);
    case core::MappedQuantity::Stiffness:
        if (felt.maps.stiffness.isEmpty()) {
            break; // not in the haptic scene
        }
        return tissue.law.kind == core::LawKind::Linear ? study::maxStiffness(felt) : felt.maps.stiffness.greatest();
    case core::MappedQuantity::Friction:
        break;
    }
    return std::numeric_limits<double>::infinity();
}

} // namespace

std::vector<SurfaceField> surfaceFields(const meshio::LoadedStructure& structure)
{
    std::vector<SurfaceField> numbers;
    for (const meshio::SurfaceMap& map : structure.maps) {
        numbers.push_back({keyOf(map), feltTitle(map, structure.description.tissue), map.isPerTriangle});
    }
    if (structure.surface != nullptr) {
        for (const geometry::MeshArray& array : structure.surface->mesh.arrays) {
            const QString name = QString::fromStdString(array.name), unit = unitOf(structure, array.name);
            numbers.push_back({kArray + name,
                               unit.isEmpty() || name.endsWith(QLatin1String("Modulus_kPa"))
                                   ? (unit.isEmpty() ? name : unit)
                                   : MapDisplay::tr("%1: %2").arg(name, unit),
                               array.isPerTriangle});
        }
    }
    return numbers;
}

SurfaceField surfaceFields(const meshio::LoadedStructure& structure, const QString& what,
                           const haptics::HapticStructure& felt)
{
    for (SurfaceField& numbers : surfaceFields(structure)) {
        if (numbers.what != what) {
            continue;
        }
        for (const meshio::SurfaceMap& map : structure.maps) {
            if (keyOf(map) == what) {
                const core::Tissue& tissue = structure.description.tissue;
                numbers.values = study::feltMap(map, tissue, mostOf(map, tissue, felt)).values;
            }
        }
        for (const geometry::MeshArray& array : structure.surface->mesh.arrays) {
            if (kArray + QString::fromStdString(array.name) == what) {
                numbers.values = array.values;
            }
        }
        return numbers;
    }
    return {};
}

MapDisplay::MapDisplay(VtkViewport& viewport, StructureModel& model, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_model(model)
{
    connect(&model, &StructureModel::edited, this, [this](int, StructureModel::Change change) {
        if (change == StructureModel::Change::Touch) {
            refresh();
        }
    });
    connect(&model, &StructureModel::targetsHidden, this, [this](bool areHidden) {
        if (areHidden) {
            show(m_row, {}); // a map can show where a target is
        }
    });
    connect(&model, &QAbstractItemModel::modelReset, this, [this] {
        m_row = -1; // the view has new pictures
        m_what.clear();
        m_shown = {};
    });
}

void MapDisplay::show(int row, const QString& what)
{
    if (row != m_row) {
        restore();
    }
    m_row = row;
    m_what = m_model.scene().hiddenTargets() > 0 ? QString() : what;
    refresh();
}

std::optional<meshio::ShownMap> MapDisplay::shown() const
{
    if (m_row < 0 || m_row >= m_model.rowCount() || m_what.isEmpty()) {
        return std::nullopt;
    }
    return meshio::ShownMap{m_model.structure(m_row).name, m_what.toStdString()};
}

QString MapDisplay::textAt(int row, std::size_t triangle, const core::Vec3& p_W) const
{
    if (row != m_row || m_shown.values.empty()) {
        return {};
    }
    const geometry::RepairedMesh& surface = *m_model.rows()[static_cast<std::size_t>(row)].loaded.surface;
    const double value = study::valueAt(surface, m_shown.values, m_shown.isPerTriangle, triangle, p_W);
    // The unit follows the last comma of a title.
    const qsizetype comma = m_shown.title.lastIndexOf(QStringLiteral(", "));
    const QString name = comma < 0 ? m_shown.title : m_shown.title.left(comma);
    const QString unit = comma < 0 ? QString() : m_shown.title.mid(comma + 2);
    return std::isnan(value) ? tr("%1: no data").arg(name)
                             : QStringLiteral("%1 %2 %3").arg(name, numberText(value, 3), unit).trimmed();
}

void MapDisplay::setCovered(bool isCovered)
{
    if (isCovered == m_isCovered) {
        return;
    }
    if (isCovered && !m_shown.values.empty()) {
        restore();
    }
    m_isCovered = isCovered;
    refresh();
}

void MapDisplay::setGreatest(const haptics::Tissue& greatest)
{
    m_greatest = greatest;
    refresh();
}

/// Restores the structure's own colour.
void MapDisplay::restore()
{
    m_shown = {};
    if (m_isCovered) {
        return;
    }
    if (m_row >= 0 && m_row < m_model.rowCount()) {
        m_viewport.view().setPicture(static_cast<std::size_t>(m_row), m_model.picture(m_row));
    }
    m_viewport.view().legend().hide();
    m_viewport.update();
}

void MapDisplay::refresh()
{
    if (m_isCovered || m_row < 0 || m_row >= m_model.rowCount()) {
        return;
    }
    const auto i = static_cast<std::size_t>(m_row);
    const study::OpenStructure& row = m_model.rows()[i];
    SurfaceField numbers =
        m_what.isEmpty() ? SurfaceField() : surfaceFields(row.loaded, m_what, m_model.hapticStructures(m_greatest)[i]);
    if (numbers.values.empty()) { // including maps that were removed
        restore();
        return;
    }
    const view::ColourRange range = view::colourRange(numbers.values);
    m_viewport.view().setPicture(
        i, view::coloured(*m_model.picture(m_row), *row.loaded.surface, numbers.values, numbers.isPerTriangle, range));
    const QString title = readableName(row.loaded.description.name) + QLatin1Char('\n') + numbers.title;
    m_viewport.view().legend().show(
        {title.toStdString(), tr("no data").toStdString(), range, QLocale().decimalPoint().toStdString()});
    m_shown = std::move(numbers);
    m_viewport.update();
}

} // namespace palpate::ui

#include "palpate/ui/moc_MapDisplay.cpp"
