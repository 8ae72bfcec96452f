// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/StructureModel.h"

#include "palpate/ui/EngineTexts.h"
#include "palpate/ui/Theme.h"

#include <palpate/meshio/SurfaceMaps.h>
#include <palpate/study/BuriedLumps.h>
#include <palpate/study/DeviceLimit.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/StructureSources.h>

#include <QElapsedTimer>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>

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

namespace {

/// True when a different surface must be built from the same mesh.
bool hasOtherSurface(const meshio::SceneStructure& a, const meshio::SceneStructure& b)
{
    return a.outwards != b.outwards || a.surface != b.surface ||
           (a.smoothing != b.smoothing && b.surface == meshio::SurfaceKind::Smoothed);
}

} // namespace

QColor colourOf(const meshio::SceneStructure& structure)
{
    return QColor::fromRgbF(static_cast<float>(structure.colour[0]), static_cast<float>(structure.colour[1]),
                            static_cast<float>(structure.colour[2]));
}

/// Undo step for changed descriptions. Steps in quick succession, as from a drag or the wheel, are merged.
class StructureModel::Edit final : public QUndoCommand
{
  public:
    Edit(StructureModel& model, std::vector<Edited> after, const QString& text,
         std::optional<meshio::BuriedTouch> buried)
        : QUndoCommand(text)
        , m_model(model)
        , m_after(std::move(after))
        , m_buried(buried)
    {
        m_buriedBefore = buried ? std::optional(model.buried()) : std::nullopt;
        for (const Edited& one : m_after) {
            m_before.push_back({one.row, model.structure(one.row)});
        }
        m_time.start();
    }
    void undo() override { m_model.apply(m_before, m_buriedBefore); }
    void redo() override { m_model.apply(m_after, m_buried); }
    [[nodiscard]] int id() const override { return 1; }
    bool mergeWith(const QUndoCommand* other) override
    {
        const auto* next = static_cast<const Edit*>(other);
        if (next->m_after.size() != m_after.size() || m_time.elapsed() > 700 || m_buried || next->m_buried) {
            return false;
        }
        for (std::size_t i = 0; i < m_after.size(); ++i) {
            const meshio::SceneStructure &from = m_before[i].description, &to = next->m_after[i].description;
            if (next->m_after[i].row != m_after[i].row || hasOtherSurface(from, to) || from.visible != to.visible ||
                from.palpable != to.palpable || from.name != to.name || m_after[i].description.layer != to.layer ||
                from.inside != to.inside) {
                return false;
            }
        }
        m_after = next->m_after;
        m_time.restart();
        return true;
    }

  private:
    StructureModel& m_model;
    std::vector<Edited> m_before, m_after;
    std::optional<meshio::BuriedTouch> m_buriedBefore, m_buried;
    QElapsedTimer m_time;
};

/// Undo step for added or removed structures.
class StructureModel::Presence final : public QUndoCommand
{
  public:
    Presence(StructureModel& model, std::vector<int> rows, bool isRemoving, const QString& text)
        : QUndoCommand(text)
        , m_model(model)
        , m_rows(std::move(rows))
        , m_isRemoving(isRemoving)
    {
    }
    void undo() override { m_model.setRemoved(m_rows, !m_isRemoving); }
    void redo() override { m_model.setRemoved(m_rows, m_isRemoving); }

  private:
    StructureModel& m_model;
    std::vector<int> m_rows;
    bool m_isRemoving;
};

QString readableName(const std::string& name)
{
    QString text = QString::fromStdString(name).replace('_', ' ').simplified();
    // Reference libraries prefix every organ with the body: "VH F liver".
    for (const char* prefix : {"VH F ", "VH M "}) {
        if (text.startsWith(QLatin1String(prefix), Qt::CaseInsensitive)) {
            text.remove(0, 5);
        }
    }
    return text;
}

StructureModel::StructureModel(QObject* parent)
    : QAbstractTableModel(parent)
{
}

void StructureModel::setRows(std::vector<StructureRow> rows, meshio::BuriedTouch buried)
{
    beginResetModel();
    m_undo.clear();
    m_rows = std::move(rows);
    m_buried = buried;
    for (StructureRow& row : m_rows) {
        if (buried == meshio::BuriedTouch::Layers) {
            row.recordedBelow = row.loaded.feltBelow;
        }
        refreshTouchMaps(row);
    }
    endResetModel();
}

const meshio::SceneStructure& StructureModel::structure(int row) const
{
    return m_rows[static_cast<std::size_t>(row)].loaded.description;
}

void StructureModel::edit(int row, const meshio::SceneStructure& description)
{
    editAll({{row, description}}, tr("Change %1").arg(readableName(description.name)));
}

void StructureModel::editAll(std::vector<Edited> edits, const QString& text, std::optional<meshio::BuriedTouch> buried)
{
    if (buried == m_buried) {
        buried.reset();
    }
    if (!edits.empty() || buried) {
        m_undo.push(new Edit(*this, std::move(edits), text, buried));
    }
}

void StructureModel::setLayers(const std::vector<std::uint32_t>& layers, const QString& text)
{
    std::vector<Edited> edits;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const meshio::SceneStructure& now = m_rows[i].loaded.description;
        if (now.layer != layers[i] && !m_rows[i].isRemoved) {
            edits.push_back({static_cast<int>(i), now});
            edits.back().description.layer = layers[i];
            if (layers[i] > 0) {
                edits.back().description.inside.clear();
            }
        }
    }
    editAll(std::move(edits), text);
}

study::LumpRule StructureModel::lumpRule() const
{
    std::vector<study::PlacedStructure> structures;
    for (const StructureRow& row : m_rows) {
        const auto& surface = row.loaded.surface;
        const bool isThere = !row.isRemoved && surface != nullptr && !surface->mesh.triangles.empty();
        structures.push_back({&row.loaded.description, isThere ? surface.get() : nullptr,
                              row.in ? std::optional(static_cast<std::size_t>(*row.in)) : std::nullopt});
    }
    return study::LumpRule(std::move(structures));
}

bool StructureModel::isTransmitted(int row) const
{
    return m_buried == meshio::BuriedTouch::Felt && lumpRule().feltThrough(static_cast<std::size_t>(row));
}

std::optional<int> StructureModel::organAround(int row) const
{
    const auto organ = lumpRule().organAround(static_cast<std::size_t>(row)).organ;
    return organ ? std::optional(static_cast<int>(*organ)) : std::nullopt;
}

std::uint32_t StructureModel::layerWithin(int row) const
{
    return lumpRule().layerWithin(static_cast<std::size_t>(row));
}

/// Clears the maps of lumps no longer in transmitted mode. Returns the rows with changed touch.
std::vector<int> StructureModel::clearTransmittedMaps()
{
    std::vector<int> others;
    bool isAny = false;
    for (int i = 0; i < rowCount() && !isAny; ++i) {
        isAny = isTransmitted(i);
    }
    for (int i = 0; i < rowCount(); ++i) {
        StructureRow& row = m_rows[static_cast<std::size_t>(i)];
        const bool isLost = row.loaded.isTransmitted && !isTransmitted(i);
        const bool isOther = !isAny && row.loaded.feltBelow != row.recordedBelow;
        row.loaded.isTransmitted = row.loaded.isTransmitted && !isLost;
        if (isOther) {
            row.loaded.feltBelow = row.recordedBelow;
            refreshTouchMaps(row);
        }
        if (isLost || isOther) {
            others.push_back(i);
        }
    }
    return others;
}

void StructureModel::setTransmittedMaps(const std::vector<TransmittedMap>& maps)
{
    if (m_buried != meshio::BuriedTouch::Felt) {
        return;
    }
    std::vector<bool> isThrough(m_rows.size());
    std::vector<const std::vector<std::vector<float>>*> below(m_rows.size());
    for (const TransmittedMap& one : maps) {
        below[static_cast<std::size_t>(one.organ)] = &one.below;
        for (const int lump : one.lumps) {
            isThrough[static_cast<std::size_t>(lump)] = true;
        }
    }
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        meshio::LoadedStructure& one = m_rows[i].loaded;
        const bool isOtherMap = below[i] == nullptr ? !one.feltBelow.empty() : one.feltBelow != *below[i];
        if (isOtherMap) {
            one.feltBelow = below[i] == nullptr ? std::vector<std::vector<float>>() : *below[i];
            refreshTouchMaps(m_rows[i]);
        }
        if (isOtherMap || one.isTransmitted != isThrough[i]) {
            one.isTransmitted = isThrough[i];
            Q_EMIT edited(static_cast<int>(i), Change::Touch);
        }
    }
}

void StructureModel::addRows(std::vector<StructureRow> rows, const QString& text)
{
    if (rows.empty()) {
        return;
    }
    std::vector<int> numbers;
    beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(rows.size()) - 1);
    for (StructureRow& row : rows) {
        numbers.push_back(rowCount());
        row.isRemoved = true; // until the undo step runs
        row.loaded.isTransmitted = false;
        row.loaded.feltBelow.clear();
        refreshTouchMaps(row);
        m_rows.push_back(std::move(row));
    }
    endInsertRows();
    m_undo.push(new Presence(*this, std::move(numbers), false, text));
}

void StructureModel::removeRows(std::vector<int> rows)
{
    rows.erase(std::remove_if(rows.begin(), rows.end(),
                              [this](int row) { return m_rows[static_cast<std::size_t>(row)].isRemoved; }),
               rows.end());
    if (rows.empty()) {
        return;
    }
    const QString text = rows.size() == 1 ? tr("Remove %1").arg(readableName(structure(rows.front()).name))
                                          : tr("Remove %1 structures").arg(rows.size());
    m_undo.push(new Presence(*this, std::move(rows), true, text));
}

void StructureModel::setRemoved(const std::vector<int>& rows, bool isRemoved)
{
    for (const int row : rows) {
        m_rows[static_cast<std::size_t>(row)].isRemoved = isRemoved;
    }
    const std::vector<int> others = clearTransmittedMaps();
    // Affects the texts of contained structures.
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    for (const int row : rows) {
        Q_EMIT edited(row, Change::Look);
        Q_EMIT edited(row, Change::Touch);
    }
    for (const int row : others) {
        Q_EMIT edited(row, Change::Touch);
    }
}

void StructureModel::setNesting(const std::vector<std::optional<int>>& in)
{
    for (std::size_t i = 0; i < std::min(in.size(), m_rows.size()); ++i) {
        m_rows[i].in = in[i];
    }
}

int StructureModel::presentCount() const
{
    return static_cast<int>(
        std::count_if(m_rows.begin(), m_rows.end(), [](const StructureRow& row) { return !row.isRemoved; }));
}

QString StructureModel::touchOrderText(int row, std::uint32_t layer) const
{
    if (layer == 0) {
        return tr("outermost");
    }
    std::optional<int> in = m_rows[static_cast<std::size_t>(row)].in;
    std::uint32_t most = 1; // number of layers below the container; skips structures that are not palpable
    for (; in && (m_rows[static_cast<std::size_t>(*in)].isRemoved || !structure(*in).palpable); ++most) {
        in = m_rows[static_cast<std::size_t>(*in)].in;
    }
    if (in && structure(*in).layer < layer && layer <= structure(*in).layer + most) {
        return tr("below %1").arg(readableName(structure(*in).name));
    }
    return tr("%1 below surface").arg(layer);
}

QString StructureModel::touchOrderText(int row) const
{
    const std::optional<int> organ = isTransmitted(row) ? organAround(row) : std::nullopt;
    return organ ? tr("through %1").arg(readableName(structure(*organ).name))
                 : touchOrderText(row, structure(row).layer);
}

void StructureModel::apply(const std::vector<Edited>& edits, std::optional<meshio::BuriedTouch> buried)
{
    std::vector<meshio::SceneStructure> before;
    int first = buried ? 0 : rowCount(), last = buried ? rowCount() - 1 : -1;
    m_buried = buried.value_or(m_buried);
    for (const Edited& one : edits) {
        meshio::SceneStructure& now = m_rows[static_cast<std::size_t>(one.row)].loaded.description;
        before.push_back(now);
        now = one.description;
        if (before.back().maps != now.maps) {
            resolveMaps(one.row);
        } else if (before.back().tissue != now.tissue) {
            refreshTouchMaps(m_rows[static_cast<std::size_t>(one.row)]);
        }
        first = std::min(first, one.row);
        last = std::max(last, one.row);
    }
    std::vector<int> others = clearTransmittedMaps();
    for (int row = 0; buried && row < rowCount(); ++row) {
        if (isTransmitted(row)) {
            others.push_back(row);
        }
    }
    Q_EMIT dataChanged(index(first, 0), index(last, ColumnCount - 1));
    for (std::size_t i = 0; i < edits.size(); ++i) {
        if (hasOtherSurface(before[i], edits[i].description) && isReshapable(edits[i].row)) {
            Q_EMIT surfaceWanted(edits[i].row);
        }
        tell(edits[i].row, before[i], before[i].maps != edits[i].description.maps);
    }
    for (const int row : others) {
        Q_EMIT edited(row, Change::Touch);
    }
}

void StructureModel::tell(int row, const meshio::SceneStructure& before, bool hasOtherMaps)
{
    const meshio::SceneStructure& now = structure(row);
    const bool isRenamed = before.name != now.name;
    if (isRenamed) {
        Q_EMIT renamed(row, readableName(before.name), readableName(now.name));
    }
    if (before.colour != now.colour || before.opacity != now.opacity || before.visible != now.visible) {
        Q_EMIT edited(row, Change::Look);
    }
    const bool hasOtherLump = before.inside != now.inside || before.young_ratio != now.young_ratio ||
                              before.young_kPa != now.young_kPa ||
                              before.felt_contact_radius_mm != now.felt_contact_radius_mm;
    if (study::canBeFelt(before) != study::canBeFelt(now) || before.tissue != now.tissue || before.layer != now.layer ||
        hasOtherMaps || isRenamed || hasOtherLump) {
        Q_EMIT edited(row, Change::Touch);
    }
}

void StructureModel::resolveMaps(int row)
{
    StructureRow& one = m_rows[static_cast<std::size_t>(row)];
    const auto& mappings = one.loaded.description.maps;
    if (mappings && std::any_of(mappings->begin(), mappings->end(), [](const auto& m) { return m.array.empty(); })) {
        Q_EMIT mapsWanted(row); // volumes are read on a worker thread
        return;
    }
    std::vector<std::string> warnings, losses;
    meshio::resolveMaps(one.loaded, warnings, losses);
    one.mapProblems.clear();
    for (const std::string& line : losses) {
        one.mapProblems << engineText(line);
    }
    refreshTouchMaps(one);
}

void StructureModel::setMaps(int row, const std::optional<std::vector<core::TissueMapping>>& of,
                             std::vector<meshio::SurfaceMap> maps, const QStringList& problems)
{
    StructureRow& one = m_rows[static_cast<std::size_t>(row)];
    if (one.loaded.description.maps != of) {
        return; // outdated result: the mappings have changed since the request
    }
    one.loaded.maps = std::move(maps);
    one.mapProblems = problems;
    refreshTouchMaps(one);
    Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
    Q_EMIT edited(row, Change::Touch);
}

bool StructureModel::isReshapable(int row) const
{
    return m_rows[static_cast<std::size_t>(row)].loaded.asRead != nullptr;
}

void StructureModel::setSurface(int row, const StructureRow& built)
{
    StructureRow& one = m_rows[static_cast<std::size_t>(row)];
    const meshio::SceneStructure &now = one.loaded.description, &of = built.loaded.description;
    if (hasOtherSurface(now, of)) {
        return; // outdated result: the description has changed since the request
    }
    const std::size_t vertices = built.loaded.surface->mesh.vertices.size();
    if (vertices != one.loaded.surface->mesh.vertices.size()) { // sized for the old vertices
        one.loaded.feltBelow.clear();
        one.recordedBelow.clear();
    }
    one.loaded.surface = built.loaded.surface;
    one.loaded.staircase = built.loaded.staircase;
    one.loaded.smoothing = built.loaded.smoothing;
    one.picture = built.picture;
    one.touch = built.touch;
    one.sha256 = built.sha256;
    if (now.maps == of.maps) {
        one.loaded.maps = built.loaded.maps;
        one.mapProblems = built.mapProblems;
        refreshTouchMaps(one);
    } else {
        resolveMaps(row);
    }
    Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
    Q_EMIT surfaceReplaced(row);
    Q_EMIT edited(row, Change::Touch);
}

std::vector<int> StructureModel::insideOutRows() const
{
    std::vector<int> rows;
    for (int row = 0; row < rowCount(); ++row) {
        const StructureRow& one = m_rows[static_cast<std::size_t>(row)];
        if (!one.isRemoved && isReshapable(row) && one.loaded.surface->report.insideOutComponents > 0) {
            rows.push_back(row);
        }
    }
    return rows;
}

std::vector<int> StructureModel::steppedRows() const
{
    std::vector<int> rows;
    for (int row = 0; row < rowCount(); ++row) {
        const StructureRow& one = m_rows[static_cast<std::size_t>(row)];
        if (!one.isRemoved && isReshapable(row) && one.loaded.staircase &&
            structure(row).surface != meshio::SurfaceKind::Smoothed) {
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
        edits.back().description.surface = meshio::SurfaceKind::Smoothed;
    }
    editAll(std::move(edits), rows.size() == 1 ? tr("Smooth %1").arg(readableName(structure(rows.front()).name))
                                               : tr("Smooth %1 surfaces").arg(rows.size()));
}

/// Prepares the maps for the servo tick. @par Cost O(triangles) per map
void StructureModel::refreshTouchMaps(StructureRow& row)
{
    const bool varies = !row.loaded.maps.empty() || !row.loaded.feltBelow.empty();
    row.felt = row.touch != nullptr && varies ? study::tissueMaps(row.loaded, *row.touch) : haptics::TissueMaps();
}

void StructureModel::setTouch(int row, std::shared_ptr<const geometry::SurfaceIndex> touch, std::string sha256)
{
    StructureRow& one = m_rows[static_cast<std::size_t>(row)];
    one.touch = std::move(touch);
    one.sha256 = std::move(sha256);
    refreshTouchMaps(one);
    Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
    Q_EMIT edited(row, Change::Touch);
}

QStringList StructureModel::findings(int row) const
{
    QStringList lines;
    const meshio::LoadedStructure& one = m_rows[static_cast<std::size_t>(row)].loaded;
    if (one.surface != nullptr) {
        for (const std::string& sentence : one.surface->report.sentences()) {
            lines << engineText(sentence);
        }
    }
    if (one.staircase) {
        lines << engineText(one.staircase->sentence());
    }
    if (one.smoothing) {
        lines << engineText(one.smoothing->sentence());
    }
    return lines;
}

/// Notes on voxel steps or the effect of smoothing.
QStringList StructureModel::surfaceTexts(const meshio::LoadedStructure& one)
{
    const QLocale locale;
    if (const auto& done = one.smoothing) {
        const QString moved = locale.toString(done->most_mm, 'g', 2);
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
                    .arg(locale.toString(voxel.x(), 'g', 3), locale.toString(voxel.y(), 'g', 3),
                         locale.toString(voxel.z(), 'g', 3))};
    }
    return {};
}

QStringList StructureModel::defects(int row) const
{
    QStringList lines;
    const auto& surface = m_rows[static_cast<std::size_t>(row)].loaded.surface;
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
    lines << surfaceTexts(m_rows[static_cast<std::size_t>(row)].loaded);
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
    const meshio::LoadedStructure& one = m_rows[static_cast<std::size_t>(row)].loaded;
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
    return {structure.colour, structure.opacity, structure.visible};
}

view::Appearance StructureModel::appearanceOf(int row) const
{
    view::Appearance appearance = appearanceOf(structure(row));
    appearance.isVisible = appearance.isVisible && !m_rows[static_cast<std::size_t>(row)].isRemoved;
    return appearance;
}

std::vector<haptics::HapticStructure> StructureModel::hapticStructures(const haptics::Tissue& greatest) const
{
    std::vector<haptics::HapticStructure> structures;
    structures.reserve(m_rows.size());
    for (const StructureRow& row : m_rows) {
        const meshio::SceneStructure& from = row.loaded.description;
        structures.push_back(study::hapticStructure(
            from, study::canBeFelt(from) && !row.loaded.isTransmitted && !row.isRemoved ? row.touch : nullptr));
        if (structures.back().surface != nullptr) {
            structures.back().maps = row.felt;
            if (const int number = static_cast<int>(structures.size()) - 1; isTransmitted(number)) {
                structures.back().layer = layerWithin(number); // map not computed yet
            }
        }
    }
    study::limitTissues(greatest, structures);
    return structures;
}

std::shared_ptr<const haptics::HapticScene> StructureModel::hapticScene(const haptics::Tissue& greatest,
                                                                        double fingertip_mm) const
{
    return std::make_shared<const haptics::HapticScene>(hapticStructures(greatest), fingertip_mm);
}

std::vector<session::StructureSource> StructureModel::sources() const
{
    std::vector<session::StructureSource> sources;
    for (const StructureRow& row : m_rows) {
        if (row.isRemoved) {
            sources.emplace_back(); // placeholder that keeps the numbering
            continue;
        }
        sources.push_back(study::sourceOf(row.loaded.description, row.sha256));
        sources.back().embed = row.sha256.empty() ? nullptr : row.loaded.surface;
    }
    return sources;
}

int StructureModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
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
            const auto& surface = m_rows[static_cast<std::size_t>(index.row())].loaded.surface;
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
                      "See the list of messages (F4) for details.")
                .arg(name, found.join(QStringLiteral("\n• ")));
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
