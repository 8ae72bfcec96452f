// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/StructureModel.h"

#include "palpate/ui/Theme.h"

#include <palpate/meshio/SurfaceMaps.h>
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
    QPixmap pixmap(32, 32);
    pixmap.setDevicePixelRatio(2.0);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(mutedColour(), 1.0));
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(1.5, 1.5, 13, 13), 3, 3);
    QIcon made(pixmap);
    made.addPixmap(pixmap, QIcon::Selected); // its true colour on the selected row too
    return made;
}

} // namespace

QColor colourOf(const meshio::SceneStructure& structure)
{
    return QColor::fromRgbF(static_cast<float>(structure.colour[0]), static_cast<float>(structure.colour[1]),
                            static_cast<float>(structure.colour[2]));
}

/// One edit of one structure. Steps of one drag or one roll of the wheel, which come quickly, undo together.
class StructureModel::Edit final : public QUndoCommand
{
  public:
    Edit(StructureModel& model, int row, const meshio::SceneStructure& after)
        : QUndoCommand(tr("Change %1").arg(readableName(after.name)))
        , m_model(model)
        , m_row(row)
        , m_before(model.structure(row))
        , m_after(after)
    {
        m_time.start();
    }
    void undo() override { m_model.apply(m_row, m_before); }
    void redo() override { m_model.apply(m_row, m_after); }
    [[nodiscard]] int id() const override { return 1; }
    bool mergeWith(const QUndoCommand* other) override
    {
        const auto* next = static_cast<const Edit*>(other);
        if (next->m_row != m_row || m_time.elapsed() > 700 || m_before.visible != next->m_after.visible ||
            m_before.palpable != next->m_after.palpable || m_after.layer != next->m_after.layer) {
            return false;
        }
        m_after = next->m_after;
        m_time.restart();
        return true;
    }

  private:
    StructureModel& m_model;
    int m_row;
    meshio::SceneStructure m_before;
    meshio::SceneStructure m_after;
    QElapsedTimer m_time;
};

/// The layers of all structures.
class StructureModel::Relayer final : public QUndoCommand
{
  public:
    Relayer(StructureModel& model, std::vector<std::uint32_t> after, const QString& text)
        : QUndoCommand(text)
        , m_model(model)
        , m_after(std::move(after))
    {
        for (const StructureRow& row : model.rows()) {
            m_before.push_back(row.loaded.description.layer);
        }
    }
    void undo() override { apply(m_before); }
    void redo() override { apply(m_after); }

  private:
    void apply(const std::vector<std::uint32_t>& layers)
    {
        for (std::size_t i = 0; i < layers.size(); ++i) {
            const int row = static_cast<int>(i);
            meshio::SceneStructure changed = m_model.structure(row);
            if (changed.layer != layers[i]) {
                changed.layer = layers[i];
                m_model.apply(row, changed);
            }
        }
    }

    StructureModel& m_model;
    std::vector<std::uint32_t> m_before, m_after;
};

QString readableName(const std::string& name)
{
    QString text = QString::fromStdString(name).replace('_', ' ').simplified();
    // Reference libraries prefix every organ with its body: "VH F liver".
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

void StructureModel::setRows(std::vector<StructureRow> rows)
{
    beginResetModel();
    m_undo.clear();
    m_rows = std::move(rows);
    for (StructureRow& row : m_rows) {
        refreshFelt(row);
    }
    endResetModel();
}

const meshio::SceneStructure& StructureModel::structure(int row) const
{
    return m_rows[static_cast<std::size_t>(row)].loaded.description;
}

void StructureModel::edit(int row, const meshio::SceneStructure& description)
{
    m_undo.push(new Edit(*this, row, description));
}

void StructureModel::setLayers(const std::vector<std::uint32_t>& layers, const QString& text)
{
    m_undo.push(new Relayer(*this, layers, text));
}

QString StructureModel::feltText(int row, std::uint32_t layer) const
{
    if (layer == 0) {
        return tr("outermost");
    }
    const std::optional<int> in = m_rows[static_cast<std::size_t>(row)].in;
    if (in && structure(*in).layer + 1 == layer) {
        return tr("below %1").arg(readableName(structure(*in).name));
    }
    return tr("%1 below").arg(layer);
}

void StructureModel::apply(int row, const meshio::SceneStructure& description)
{
    meshio::SceneStructure& now = m_rows[static_cast<std::size_t>(row)].loaded.description;
    const meshio::SceneStructure before = now;
    now = description;
    const bool hasOtherMaps = before.maps != now.maps;
    if (hasOtherMaps) {
        resolveMaps(row);
    } else if (before.tissue != now.tissue) {
        refreshFelt(m_rows[static_cast<std::size_t>(row)]);
    }
    Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
    if (before.colour != now.colour || before.opacity != now.opacity || before.visible != now.visible) {
        Q_EMIT edited(row, Change::Look);
    }
    if (isFelt(before) != isFelt(now) || before.tissue != now.tissue || before.layer != now.layer || hasOtherMaps) {
        Q_EMIT edited(row, Change::Touch);
    }
}

void StructureModel::resolveMaps(int row)
{
    StructureRow& one = m_rows[static_cast<std::size_t>(row)];
    const auto& mappings = one.loaded.description.maps;
    if (mappings && std::any_of(mappings->begin(), mappings->end(), [](const auto& m) { return m.array.empty(); })) {
        Q_EMIT mapsWanted(row);
        return;
    }
    std::vector<std::string> warnings, losses;
    meshio::resolveMaps(one.loaded, warnings, losses);
    one.mapProblems.clear();
    for (const std::string& line : losses) {
        one.mapProblems << QString::fromStdString(line);
    }
    refreshFelt(one);
}

void StructureModel::setMaps(int row, const std::optional<std::vector<core::TissueMapping>>& of,
                             std::vector<meshio::SurfaceMap> maps, const QStringList& problems)
{
    StructureRow& one = m_rows[static_cast<std::size_t>(row)];
    if (one.loaded.description.maps != of) {
        return;
    }
    one.loaded.maps = std::move(maps);
    one.mapProblems = problems;
    refreshFelt(one);
    Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
    Q_EMIT edited(row, Change::Touch);
}

/// Lays the maps out for the tick. @par Cost O(triangles) for each map
void StructureModel::refreshFelt(StructureRow& row)
{
    row.felt = row.touch != nullptr && !row.loaded.maps.empty() ? study::tissueMaps(row.loaded, *row.touch)
                                                                : haptics::TissueMaps();
}

void StructureModel::setTouch(int row, std::shared_ptr<const geometry::SurfaceIndex> touch, std::string sha256)
{
    StructureRow& one = m_rows[static_cast<std::size_t>(row)];
    one.touch = std::move(touch);
    one.sha256 = std::move(sha256);
    refreshFelt(one);
    Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
    Q_EMIT edited(row, Change::Touch);
}

QStringList StructureModel::findings(int row) const
{
    QStringList lines;
    const auto& surface = m_rows[static_cast<std::size_t>(row)].loaded.surface;
    if (surface != nullptr) {
        for (const std::string& sentence : surface->report.sentences()) {
            lines << QString::fromStdString(sentence);
        }
    }
    return lines;
}

bool StructureModel::isDefective(int row) const
{
    const auto& surface = m_rows[static_cast<std::size_t>(row)].loaded.surface;
    if (surface == nullptr) {
        return false;
    }
    const geometry::MeshReport& report = surface->report;
    return report.zeroAreaTriangles + report.duplicateTriangles + report.inconsistentEdges + report.nonManifoldEdges +
               report.nonOrientableComponents + report.insideOutComponents >
           0;
}

bool StructureModel::isFelt(const meshio::SceneStructure& structure) noexcept
{
    return structure.palpable && structure.visible;
}

view::Appearance StructureModel::appearanceOf(const meshio::SceneStructure& structure)
{
    return {structure.colour, structure.opacity, structure.visible};
}

std::vector<haptics::HapticStructure> StructureModel::feltStructures(const haptics::Tissue& greatest) const
{
    std::vector<haptics::HapticStructure> structures;
    structures.reserve(m_rows.size());
    for (const StructureRow& row : m_rows) {
        const meshio::SceneStructure& from = row.loaded.description;
        structures.push_back(study::hapticStructure(from, isFelt(from) ? row.touch : nullptr));
        if (structures.back().surface != nullptr) {
            structures.back().maps = row.felt;
        }
    }
    study::boundBy(greatest, structures);
    return structures;
}

std::shared_ptr<const haptics::HapticScene> StructureModel::hapticScene(const haptics::Tissue& greatest,
                                                                        double fingertip_mm) const
{
    return std::make_shared<const haptics::HapticScene>(feltStructures(greatest), fingertip_mm);
}

std::vector<session::StructureSource> StructureModel::sources() const
{
    std::vector<session::StructureSource> sources;
    for (const StructureRow& row : m_rows) {
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
        index.column() == Health && isDefective(index.row()) ? findings(index.row()) : QStringList();
    switch (index.column()) {
    case Shown:
        if (role == Qt::DecorationRole) {
            return icon(one.visible ? Symbol::Eye : Symbol::EyeOff);
        }
        if (role == Qt::CheckStateRole) {
            return {}; // the picture says it; a box beside it would say it twice
        }
        if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) {
            return one.visible ? tr("%1 is shown. Click to hide it; what is hidden is not felt.").arg(name)
                               : tr("%1 is hidden. Click to show it.").arg(name);
        }
        break;
    case Name:
        if (role == Qt::DisplayRole) {
            return name;
        }
        if (role == Qt::AccessibleTextRole) {
            return one.layer == 0 ? name : tr("%1, felt %2").arg(name, feltText(index.row(), one.layer));
        }
        if (role == kLayerRole) {
            return one.layer;
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
            return tr("%1\n%2 triangles\nFelt: %3").arg(name, triangles, feltText(index.row(), one.layer));
        }
        break;
    case Health:
        if (role == Qt::DecorationRole && !found.isEmpty()) {
            return icon(Symbol::Warning);
        }
        if ((role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) && !found.isEmpty()) {
            return tr("About the mesh of %1:\n• %2").arg(name, found.join(QStringLiteral("\n• ")));
        }
        break;
    case Felt:
        if (role == Qt::DecorationRole) {
            return icon(one.palpable ? Symbol::Hand : Symbol::HandOff);
        }
        if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) {
            return one.palpable ? tr("%1 can be felt. Click to let the hand pass through it.").arg(name)
                                : tr("The hand passes through %1. Click to feel it.").arg(name);
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
        const QString titles[ColumnCount] = {tr("Shown"), tr("Name and colour"), tr("What was found in the mesh"),
                                             tr("Can be felt")};
        return titles[section];
    }
    return {};
}

bool StructureModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::CheckStateRole || !index.isValid()) {
        return false;
    }
    meshio::SceneStructure changed = structure(index.row());
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
    return index.isValid() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable : Qt::NoItemFlags;
}

} // namespace palpate::ui
