// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/StructureModel.h"

#include "palpate/ui/Theme.h"
#include "palpate/ui/Translated.h"

#include <palpate/study/HapticCopy.h>
#include <palpate/study/ReadableName.h>

#include <QElapsedTimer>
#include <QLocale>
#include <QPainter>
#include <QUndoCommand>

#include <algorithm>
#include <cmath>
#include <map>

namespace palpate::ui {

namespace {

QIcon swatch(const QColor& colour)
{
    const int side_px = withText_px(16);
    QPixmap pixmap(2 * side_px, 2 * side_px);
    pixmap.setDevicePixelRatio(2.0);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(mutedColour(), 1.0));
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(1.5, 1.5, side_px - 3.0, side_px - 3.0), 3, 3);
    QIcon made(pixmap);
    made.addPixmap(pixmap, QIcon::Selected); // keeps the colour unchanged on a selected row
    return made;
}

} // namespace

QColor colourOf(const meshio::SceneStructure& structure)
{
    return QColor::fromRgbF(static_cast<float>(structure.colour[0]), static_cast<float>(structure.colour[1]),
                            static_cast<float>(structure.colour[2]));
}

/// Undo step: an edit and its inverse. Changed descriptions in quick succession, as from a drag or the wheel, are
/// merged.
class StructureModel::Step final : public QUndoCommand
{
  public:
    Step(StructureModel& model, study::SceneEdit edit, const QString& text)
        : QUndoCommand(text)
        , m_model(model)
        , m_undo(model.scene().inverse(edit))
        , m_redo(std::move(edit))
    {
        m_time.start();
    }
    void undo() override { m_model.apply(m_undo); }
    void redo() override { m_model.apply(m_redo); }
    [[nodiscard]] int id() const override { return 1; }
    bool mergeWith(const QUndoCommand* other) override
    {
        const auto* next = static_cast<const Step*>(other);
        if (!hasOnlyDescriptions() || !next->hasOnlyDescriptions() ||
            next->m_redo.descriptions.size() != m_redo.descriptions.size() || m_time.elapsed() > 700) {
            return false;
        }
        for (std::size_t i = 0; i < m_redo.descriptions.size(); ++i) {
            const meshio::SceneStructure &from = m_undo.descriptions[i].description,
                                         &to = next->m_redo.descriptions[i].description;
            if (next->m_redo.descriptions[i].structure != m_redo.descriptions[i].structure ||
                study::needsOtherSurface(from, to) || from.visible != to.visible || from.palpable != to.palpable ||
                from.name != to.name || m_redo.descriptions[i].description.layer != to.layer ||
                from.inside != to.inside) {
                return false;
            }
        }
        m_redo = next->m_redo;
        m_time.restart();
        return true;
    }

  private:
    [[nodiscard]] bool hasOnlyDescriptions() const
    {
        return !m_redo.buried && m_redo.removed.empty() && m_redo.restored.empty();
    }

    StructureModel& m_model;
    study::SceneEdit m_undo, m_redo;
    QElapsedTimer m_time;
};

QString readableName(const std::string& name)
{
    return QString::fromStdString(study::readableName(name));
}

StructureModel::StructureModel(QObject* parent)
    : QAbstractTableModel(parent)
{
}

void StructureModel::setRows(std::vector<StructureRow> rows, meshio::BuriedTouch buried,
                             std::optional<meshio::Exercise> exercise)
{
    beginResetModel();
    m_undo.clear();
    m_pictures.clear();
    std::vector<study::OpenStructure> structures;
    for (StructureRow& row : rows) {
        m_pictures.push_back(std::move(row.picture));
        structures.push_back(std::move(row));
    }
    m_scene.reset(std::move(structures), buried, std::move(exercise));
    endResetModel();
}

void StructureModel::setTargetsHidden(bool areHidden)
{
    const study::SceneEvents events = m_scene.setTargetsHidden(areHidden);
    if (events.empty()) {
        return;
    }
    const bool wasClean = m_undo.isClean();
    m_undo.clear(); // labels of undo steps name structures
    if (!wasClean) {
        m_undo.resetClean();
    }
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    announce(events);
    Q_EMIT targetsHidden(areHidden);
}

QString StructureModel::shownName(int row) const
{
    std::optional<std::size_t> shown = static_cast<std::size_t>(row);
    while (shown && rows()[*shown].loaded.description.isHiddenTarget) {
        shown = rows()[*shown].in;
    }
    return shown ? readableName(rows()[*shown].loaded.description.name) : tr("unnamed structure");
}

const meshio::SceneStructure& StructureModel::structure(int row) const
{
    return rows()[static_cast<std::size_t>(row)].loaded.description;
}

void StructureModel::edit(int row, const meshio::SceneStructure& description)
{
    editAll({{row, description}}, tr("Change %1").arg(readableName(description.name)));
}

void StructureModel::editAll(std::vector<Edited> edits, const QString& text, std::optional<meshio::BuriedTouch> buried)
{
    study::SceneEdit edit;
    for (Edited& one : edits) {
        edit.descriptions.push_back({static_cast<std::size_t>(one.row), std::move(one.description)});
    }
    edit.buried = buried == m_scene.buried() ? std::nullopt : buried;
    if (!edit.descriptions.empty() || edit.buried) {
        push(std::move(edit), text);
    }
}

void StructureModel::push(study::SceneEdit edit, const QString& text)
{
    m_undo.push(new Step(*this, std::move(edit), text));
}

void StructureModel::setLayers(const std::vector<std::uint32_t>& layers, const QString& text)
{
    std::vector<Edited> edits;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const meshio::SceneStructure& now = rows()[i].loaded.description;
        if (now.layer != layers[i] && !rows()[i].isRemoved) {
            edits.push_back({static_cast<int>(i), now});
            edits.back().description.layer = layers[i];
            if (layers[i] > 0) {
                edits.back().description.inside.clear();
            }
        }
    }
    editAll(std::move(edits), text);
}

bool StructureModel::isTransmitted(int row) const
{
    return m_scene.isTransmitted(static_cast<std::size_t>(row));
}

std::optional<int> StructureModel::organAround(int row) const
{
    const auto organ = m_scene.lumpRule().organAround(static_cast<std::size_t>(row)).organ;
    return organ ? std::optional(static_cast<int>(*organ)) : std::nullopt;
}

std::uint32_t StructureModel::layerWithin(int row) const
{
    return m_scene.lumpRule().layerWithin(static_cast<std::size_t>(row));
}

void StructureModel::setTransmittedMaps(const std::vector<TransmittedMap>& maps)
{
    announce(m_scene.setTransmittedMaps(maps));
}

void StructureModel::changeMotions(const ChangeOfMotion& change)
{
    using Motion = std::shared_ptr<const geometry::SurfaceMotion>;
    std::map<Motion, Motion> changed;
    for (const study::OpenStructure& row : rows()) {
        if (const Motion& motion = row.loaded.motion; motion != nullptr && !changed.contains(motion)) {
            changed[motion] = change(motion);
        }
    }
    if (std::all_of(changed.begin(), changed.end(), [](const auto& one) { return one.first == one.second; })) {
        return;
    }
    for (std::size_t i = 0; i < rows().size(); ++i) {
        if (const Motion motion = rows()[i].loaded.motion; motion != nullptr) {
            m_scene.setMotion(i, changed[motion]);
        }
    }
    Q_EMIT motionsChanged();
}

void StructureModel::addRows(std::vector<StructureRow> rows, const QString& text)
{
    if (rows.empty()) {
        return;
    }
    study::SceneEdit edit;
    beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(rows.size()) - 1);
    for (StructureRow& row : rows) {
        m_pictures.push_back(std::move(row.picture));
        edit.restored.push_back(m_scene.append(std::move(row)));
    }
    endInsertRows();
    push(std::move(edit), text);
}

void StructureModel::removeRows(std::vector<int> rows)
{
    std::erase_if(rows, [this](int row) { return this->rows()[static_cast<std::size_t>(row)].isRemoved; });
    if (rows.empty()) {
        return;
    }
    const QString text = rows.size() == 1 ? tr("Remove %1").arg(readableName(structure(rows.front()).name))
                                          : tr("Remove %1 structures").arg(rows.size());
    study::SceneEdit edit;
    edit.removed.assign(rows.begin(), rows.end());
    push(std::move(edit), text);
}

void StructureModel::setNesting(const std::vector<std::optional<std::size_t>>& in)
{
    m_scene.setNesting(in);
}

int StructureModel::presentCount() const
{
    return static_cast<int>(
        std::count_if(rows().begin(), rows().end(), [](const study::OpenStructure& one) { return !one.isRemoved; }));
}

int StructureModel::listedCount() const
{
    return static_cast<int>(
        std::count_if(rows().begin(), rows().end(), [](const study::OpenStructure& one) { return one.isListed(); }));
}

QString StructureModel::touchOrderText(int row, std::uint32_t layer) const
{
    if (layer == 0) {
        return tr("outermost");
    }
    std::optional<std::size_t> in = rows()[static_cast<std::size_t>(row)].in;
    std::uint32_t most = 1; // number of layers below the container; skips structures that are not palpable
    for (; in && (!rows()[*in].isListed() || !rows()[*in].loaded.description.palpable); ++most) {
        in = rows()[*in].in;
    }
    if (in) {
        const meshio::SceneStructure& around = rows()[*in].loaded.description;
        if (around.layer < layer && layer <= around.layer + most) {
            return tr("below %1").arg(readableName(around.name));
        }
    }
    return tr("%1 below surface").arg(layer);
}

QString StructureModel::touchOrderText(int row) const
{
    const std::optional<int> organ = isTransmitted(row) ? organAround(row) : std::nullopt;
    return organ ? tr("through %1").arg(readableName(structure(*organ).name))
                 : touchOrderText(row, structure(row).layer);
}

void StructureModel::apply(const study::SceneEdit& edit)
{
    const study::SceneEvents events = m_scene.apply(edit);
    int first = rowCount() - 1, last = 0;
    for (const study::SceneEdit::Description& one : edit.descriptions) {
        first = std::min(first, static_cast<int>(one.structure));
        last = std::max(last, static_cast<int>(one.structure));
    }
    if (edit.buried || !edit.removed.empty() || !edit.restored.empty()) {
        first = 0; // texts of contained structures
        last = rowCount() - 1;
    }
    Q_EMIT dataChanged(index(first, 0), index(last, ColumnCount - 1));
    announce(events);
}

void StructureModel::announce(const study::SceneEvents& events)
{
    for (const study::SceneEvent& event : events) {
        const int row = static_cast<int>(event.structure);
        switch (event.kind) {
        case study::SceneEvent::Kind::MapsWanted:
            Q_EMIT mapsWanted(row);
            break;
        case study::SceneEvent::Kind::SurfaceWanted:
            Q_EMIT surfaceWanted(row);
            break;
        case study::SceneEvent::Kind::Renamed:
            Q_EMIT renamed(row, readableName(event.before), readableName(structure(row).name));
            break;
        case study::SceneEvent::Kind::Look:
            Q_EMIT edited(row, Change::Look);
            break;
        case study::SceneEvent::Kind::Touch:
            Q_EMIT edited(row, Change::Touch);
            break;
        }
    }
}

void StructureModel::setMaps(int row, const std::optional<std::vector<core::TissueMapping>>& of,
                             std::vector<meshio::SurfaceMap> maps, std::vector<core::Message> problems)
{
    if (m_scene.setMaps(static_cast<std::size_t>(row), of, std::move(maps), std::move(problems))) {
        Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
        Q_EMIT edited(row, Change::Touch);
    }
}

bool StructureModel::isReshapable(int row) const
{
    return rows()[static_cast<std::size_t>(row)].loaded.asRead != nullptr;
}

void StructureModel::setSurface(int row, const StructureRow& built)
{
    const auto events = m_scene.setSurface(static_cast<std::size_t>(row), built);
    if (!events) {
        return;
    }
    m_pictures[static_cast<std::size_t>(row)] = built.picture;
    announce(*events);
    Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
    Q_EMIT surfaceReplaced(row);
    Q_EMIT edited(row, Change::Touch);
}

std::vector<int> StructureModel::insideOutRows() const
{
    std::vector<int> rows;
    for (int row = 0; row < rowCount(); ++row) {
        const study::OpenStructure& one = this->rows()[static_cast<std::size_t>(row)];
        if (one.isListed() && isReshapable(row) && one.loaded.surface->report.insideOutComponents > 0) {
            rows.push_back(row);
        }
    }
    return rows;
}

std::vector<int> StructureModel::steppedRows() const
{
    std::vector<int> rows;
    for (int row = 0; row < rowCount(); ++row) {
        const study::OpenStructure& one = this->rows()[static_cast<std::size_t>(row)];
        if (one.isListed() && isReshapable(row) && one.loaded.staircase &&
            !meshio::isSmoothed(structure(row).surface)) {
            rows.push_back(row);
        }
    }
    return rows;
}

void StructureModel::turnOutwards(const std::vector<int>& rows)
{
    std::vector<Edited> edits;
    for (const int row : rows) {
        edits.push_back({row, structure(row)});
        edits.back().description.outwards = true;
    }
    editAll(std::move(edits), rows.size() == 1 ? tr("Turn %1 around").arg(readableName(structure(rows.front()).name))
                                               : tr("Turn %1 surfaces around").arg(rows.size()));
}

void StructureModel::smooth(const std::vector<int>& rows)
{
    std::vector<Edited> edits;
    for (const int row : rows) {
        edits.push_back({row, structure(row)});
        meshio::SurfaceKind& kind = edits.back().description.surface;
        kind = meshio::surfaceKind(true, meshio::isCurved(kind));
    }
    editAll(std::move(edits), rows.size() == 1 ? tr("Smooth %1").arg(readableName(structure(rows.front()).name))
                                               : tr("Smooth %1 surfaces").arg(rows.size()));
}

std::vector<geometry::Hole> StructureModel::holes(int row) const
{
    const study::OpenStructure& one = rows()[static_cast<std::size_t>(row)];
    return isReshapable(row) && !one.loaded.surface->report.isClosed() ? geometry::holesOf(one.loaded.surface->mesh)
                                                                       : std::vector<geometry::Hole>();
}

void StructureModel::closeHoles(const std::vector<int>& rows)
{
    std::vector<Edited> edits;
    for (const int row : rows) {
        if (const std::vector<geometry::Hole> found = holes(row); !found.empty()) {
            edits.push_back({row, structure(row)});
            meshio::SceneStructure& changed = edits.back().description;
            changed.closeHoles_mm = std::max(changed.closeHoles_mm, std::ceil(found.front().across_mm));
            changed.outwards = true; // an open surface may face either way
        }
    }
    const QString text = edits.size() == 1
                             ? tr("Close the holes of %1").arg(readableName(edits.front().description.name))
                             : tr("Close the holes of %1 surfaces").arg(edits.size());
    editAll(std::move(edits), text);
}

void StructureModel::reopenHoles(const std::vector<int>& rows)
{
    std::vector<Edited> edits;
    for (const int row : rows) {
        if (structure(row).closeHoles_mm > 0.0) {
            edits.push_back({row, structure(row)});
            edits.back().description.closeHoles_mm = 0.0;
        }
    }
    const QString text = edits.size() == 1
                             ? tr("Reopen the holes of %1").arg(readableName(edits.front().description.name))
                             : tr("Reopen the holes of %1 surfaces").arg(edits.size());
    editAll(std::move(edits), text);
}

void StructureModel::setTouch(int row, std::shared_ptr<const geometry::SurfaceIndex> touch, std::string sha256)
{
    m_scene.setTouch(static_cast<std::size_t>(row), std::move(touch), std::move(sha256));
    Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
    Q_EMIT edited(row, Change::Touch);
}

QStringList StructureModel::findings(int row) const
{
    QStringList lines;
    const meshio::LoadedStructure& one = rows()[static_cast<std::size_t>(row)].loaded;
    if (one.surface != nullptr) {
        for (const core::Message& sentence : one.surface->report.sentences()) {
            lines << translated(sentence);
        }
    }
    for (const core::Message& sentence : meshio::shapeSentences(one.staircase, one.smoothing)) {
        lines << translated(sentence);
    }
    if (one.closing) {
        lines << translated(one.closing->message());
    }
    if (one.curving) {
        lines << translated(one.curving->message());
    }
    return lines;
}

/// Notes on voxel steps or the effect of smoothing.
QStringList StructureModel::surfaceTexts(const meshio::LoadedStructure& one)
{
    const QLocale locale;
    if (const auto& done = one.smoothing) {
        if (done->isWithdrawn) {
            return {tr("The surface is not smoothed: it is too small")};
        }
        if (done->labelVoxel_mm) {
            return {translated(done->sentence())};
        }
        const QString moved = numberText(done->most_mm, 2);
        if (!(done->volumeBefore_mm3 > 0.0)) {
            return {tr("The surface is smoothed: moved by at most %1 mm").arg(moved)};
        }
        const double change = 100.0 * (done->volumeAfter_mm3 / done->volumeBefore_mm3 - 1.0);
        return {tr("The surface is smoothed: moved by at most %1 mm, volume %2 %")
                    .arg(moved, (change < 0.0 ? QStringLiteral("−") : QStringLiteral("+")) +
                                    locale.toString(std::abs(change), 'f', 1))};
    }
    if (one.staircase) {
        const core::Vec3& voxel = one.staircase->voxel_mm;
        return {tr("The surface has steps of %1 × %2 × %3 mm voxels, which can be felt")
                    .arg(numberText(voxel.x(), 3), numberText(voxel.y(), 3), numberText(voxel.z(), 3))};
    }
    return {};
}

QStringList StructureModel::defects(int row) const
{
    QStringList lines;
    const auto& surface = rows()[static_cast<std::size_t>(row)].loaded.surface;
    if (surface == nullptr) {
        return lines;
    }
    const geometry::MeshReport& report = surface->report;
    if (report.openComponents > 0) {
        lines << (report.closedComponents == 0 ? tr("The mesh is open: feels like a sheet")
                                               : tr("Part of the mesh is open: feels like a sheet there"));
    }
    if (report.insideOutComponents > 0) {
        lines << tr("The mesh is inside out: palpable only from inside");
    }
    if (const auto& closing = rows()[static_cast<std::size_t>(row)].loaded.closing) {
        lines << (closing->holes == 1 ? tr("A hole of %1 mm was closed").arg(numberText(closing->largest_mm, 3))
                                      : tr("%1 holes of up to %2 mm were closed")
                                            .arg(closing->holes)
                                            .arg(numberText(closing->largest_mm, 3)));
    }
    lines << surfaceTexts(rows()[static_cast<std::size_t>(row)].loaded);
    if (report.zeroAreaTriangles + report.duplicateTriangles + report.reorientedTriangles + report.mixedValues > 0) {
        lines << tr("Mesh defects were repaired");
    }
    if (report.nonManifoldEdges > 0) {
        lines << tr("Some edges are shared by more than two triangles");
    }
    return lines;
}

bool StructureModel::isDefective(int row) const
{
    const meshio::LoadedStructure& one = rows()[static_cast<std::size_t>(row)].loaded;
    const auto& surface = one.surface;
    if (surface == nullptr) {
        return false;
    }
    const geometry::MeshReport& report = surface->report;
    return report.zeroAreaTriangles + report.duplicateTriangles + report.inconsistentEdges + report.nonManifoldEdges +
                   report.nonOrientableComponents + report.insideOutComponents >
               0 ||
           (one.staircase && !one.smoothing);
}

view::Appearance StructureModel::appearanceOf(const meshio::SceneStructure& structure)
{
    return {structure.colour, structure.opacity, study::isDrawn(structure)};
}

view::Appearance StructureModel::appearanceOf(int row) const
{
    view::Appearance appearance = appearanceOf(structure(row));
    appearance.isVisible = appearance.isVisible && !rows()[static_cast<std::size_t>(row)].isRemoved;
    return appearance;
}

int StructureModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(rows().size());
}

int StructureModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant StructureModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const meshio::SceneStructure& one = structure(index.row());
    const QString name = readableName(one.name);
    const QStringList found =
        index.column() == Health && isDefective(index.row()) ? defects(index.row()) : QStringList();
    switch (index.column()) {
    case Shown:
        if (role == Qt::DecorationRole) {
            return icon(one.visible ? Symbol::Eye : Symbol::EyeOff);
        }
        if (role == Qt::CheckStateRole) {
            return {}; // the icon shows the state; no additional check box
        }
        if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) {
            return one.visible ? tr("%1 is visible. Click to hide; hidden structures cannot be felt.").arg(name)
                               : tr("%1 is hidden. Click to show.").arg(name);
        }
        break;
    case Name:
        if (role == Qt::DisplayRole || role == Qt::EditRole) {
            return name;
        }
        if (role == Qt::AccessibleTextRole) {
            const QString felt = touchOrderText(index.row());
            return felt == tr("outermost") ? name : tr("%1, %2").arg(name, felt);
        }
        if (role == kLayerRole) {
            return isTransmitted(index.row()) ? layerWithin(index.row()) : one.layer;
        }
        if (role == Qt::DecorationRole) {
            return swatch(colourOf(one));
        }
        if (role == Qt::ForegroundRole && !one.visible) {
            return QBrush(mutedColour());
        }
        if (role == Qt::ToolTipRole) {
            const auto& surface = rows()[static_cast<std::size_t>(index.row())].loaded.surface;
            const QString triangles =
                QLocale().toString(surface == nullptr ? 0 : static_cast<qulonglong>(surface->mesh.triangles.size()));
            return tr("%1\n"
                      "%2 triangles\n"
                      "Depth order: %3")
                .arg(name, triangles, touchOrderText(index.row()));
        }
        break;
    case Health:
        if (role == Qt::DecorationRole && !found.isEmpty()) {
            return icon(Symbol::Warning);
        }
        if ((role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) && !found.isEmpty()) {
            return tr("Mesh of %1:\n"
                      "• %2\n"
                      "Details: %3")
                .arg(name, found.join(QStringLiteral("\n• ")), findings(index.row()).join(QStringLiteral("; ")));
        }
        break;
    case Felt:
        if (role == Qt::DecorationRole) {
            return icon(one.palpable ? Symbol::Hand : Symbol::HandOff);
        }
        if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) {
            return one.palpable ? tr("%1 is palpable. Click to let the hand pass through.").arg(name)
                                : tr("The hand passes through %1. Click to make palpable.").arg(name);
        }
        break;
    default:
        break;
    }
    return {};
}

QVariant StructureModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::DisplayRole && section == Name) {
        return tr("Structure");
    }
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) {
        const QString titles[ColumnCount] = {tr("Visible"), tr("Name and colour"), tr("Notes on the mesh"),
                                             tr("Palpable")};
        return titles[section];
    }
    return {};
}

bool StructureModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!index.isValid()) {
        return false;
    }
    meshio::SceneStructure changed = structure(index.row());
    if (role == Qt::EditRole && index.column() == Name) {
        const QString name = value.toString().simplified(), before = readableName(changed.name);
        if (name.isEmpty() || name == before) {
            return false;
        }
        changed.name = name.toStdString();
        editAll({{index.row(), changed}}, tr("Rename %1").arg(before));
        return true;
    }
    if (role != Qt::CheckStateRole) {
        return false;
    }
    const bool isOn = value.toInt() == Qt::Checked;
    if (index.column() == Shown) {
        changed.visible = isOn;
    } else if (index.column() == Felt) {
        changed.palpable = isOn;
    } else {
        return false;
    }
    edit(index.row(), changed);
    return true;
}

Qt::ItemFlags StructureModel::flags(const QModelIndex& index) const
{
    if (!index.isValid()) {
        return Qt::NoItemFlags;
    }
    const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return index.column() == Name ? flags | Qt::ItemIsEditable : flags;
}

} // namespace palpate::ui

#include "palpate/ui/moc_StructureModel.cpp"
