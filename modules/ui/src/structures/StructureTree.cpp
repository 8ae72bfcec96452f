// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/StructureTree.h"

#include "palpate/ui/Theme.h"

#include <palpate/haptics/ForceTable.h>
#include <palpate/meshio/AnatomyKind.h>

#include <QFont>
#include <QHash>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace palpate::ui {

namespace {

/// Groups of the list, in its order.
enum class AnatomyGroup
{
    Lumps,
    Organs,
    Vessels,
    Nerves,
    Bones,
    Joints,
    Muscles,
    Skin,
    Other
};

AnatomyGroup anatomyGroup(const std::string& name)
{
    using meshio::AnatomyKind;
    switch (const AnatomyKind kind = meshio::anatomyKind(name); kind) {
    case AnatomyKind::Vessel:
        return AnatomyGroup::Vessels;
    case AnatomyKind::Nerve:
    case AnatomyKind::Brain:
        return AnatomyGroup::Nerves;
    case AnatomyKind::Bone:
        return AnatomyGroup::Bones;
    case AnatomyKind::Tendon:
    case AnatomyKind::Cartilage:
        return AnatomyGroup::Joints;
    case AnatomyKind::Muscle:
        return AnatomyGroup::Muscles;
    case AnatomyKind::Skin:
    case AnatomyKind::Fat:
        return AnatomyGroup::Skin;
    case AnatomyKind::Other:
        return AnatomyGroup::Other;
    default:
        return meshio::isLump(kind) ? AnatomyGroup::Lumps : AnatomyGroup::Organs;
    }
}

} // namespace

StructureTree::StructureTree(StructureModel& model, QObject* parent)
    : QAbstractItemModel(parent)
    , m_model(model)
{
    connect(&model, &QAbstractItemModel::modelReset, this, &StructureTree::takeScene);
    connect(&model, &QAbstractItemModel::rowsInserted, this, &StructureTree::refresh);
    connect(&model, &QAbstractItemModel::dataChanged, this, &StructureTree::refresh);
    rearrange();
}

void StructureTree::setOrder(Order order)
{
    m_order = order;
    refresh();
}

void StructureTree::setGrouping(Grouping grouping)
{
    m_isChosen = true;
    if (grouping != m_grouping) {
        beginResetModel(); // grouping changes the tree depth of the same structures
        m_grouping = grouping;
        m_groups = arranged();
        endResetModel();
    }
}

StructureTree::Grouping StructureTree::fittingGrouping() const
{
    constexpr int kMany = 30; // more than fit into the list
    std::set<AnatomyGroup> groups;
    int known = 0;
    for (int row = 0; row < m_model.rowCount(); ++row) {
        const AnatomyGroup group = anatomyGroup(m_model.structure(row).name);
        known += group == AnatomyGroup::Other ? 0 : 1;
        groups.insert(group);
    }
    return known >= kMany && groups.size() > 2 ? Grouping::Anatomy : Grouping::None;
}

void StructureTree::takeScene()
{
    m_grouping = m_isChosen ? m_grouping : fittingGrouping();
    rearrange();
}

void StructureTree::setFilter(const QString& text)
{
    m_words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    refresh();
}

int StructureTree::listedCount() const
{
    std::size_t count = 0;
    for (const Group& group : m_groups) {
        count += group.rows.size();
    }
    return static_cast<int>(count);
}

bool StructureTree::isListed(int row) const
{
    if (!m_model.isListed(row)) {
        return false;
    }
    const QString name = m_words.isEmpty() ? QString() : readableName(m_model.structure(row).name);
    return std::all_of(m_words.begin(), m_words.end(),
                       [&](const QString& word) { return name.contains(word, Qt::CaseInsensitive); });
}

QString StructureTree::groupOf(int row) const
{
    if (m_grouping == Grouping::Layer) {
        const std::uint32_t layer = m_model.structure(row).layer;
        return layer == 0 ? tr("Outermost") : tr("%1 below surface").arg(layer);
    }
    if (m_grouping == Grouping::Anatomy) {
        switch (anatomyGroup(m_model.structure(row).name)) {
        case AnatomyGroup::Lumps:
            return tr("Lumps");
        case AnatomyGroup::Organs:
            return tr("Organs");
        case AnatomyGroup::Vessels:
            return tr("Vessels");
        case AnatomyGroup::Nerves:
            return tr("Brain and nerves");
        case AnatomyGroup::Bones:
            return tr("Bones");
        case AnatomyGroup::Joints:
            return tr("Cartilage and tendons");
        case AnatomyGroup::Muscles:
            return tr("Muscles");
        case AnatomyGroup::Skin:
            return tr("Skin and fat");
        case AnatomyGroup::Other:
            return tr("Other");
        }
    }
    const meshio::SceneStructure& one = m_model.structure(row);
    const std::filesystem::path from = one.part.empty() ? one.mesh.parent_path() : one.mesh;
    const QString name = QString::fromStdU16String(from.filename().u16string());
    return name.isEmpty() ? tr("Other") : name;
}

std::vector<StructureTree::Group> StructureTree::arranged() const
{
    std::vector<int> rows;
    for (int row = 0; row < m_model.rowCount(); ++row) {
        if (isListed(row)) {
            rows.push_back(row);
        }
    }
    if (m_order == Order::Name) {
        std::map<int, QString> names;
        for (const int row : rows) {
            names[row] = readableName(m_model.structure(row).name);
        }
        std::stable_sort(rows.begin(), rows.end(),
                         [&](int a, int b) { return QString::localeAwareCompare(names.at(a), names.at(b)) < 0; });
    } else if (m_order == Order::Tissue) {
        std::stable_sort(rows.begin(), rows.end(), [this](int a, int b) {
            return haptics::maxStiffness(m_model.structure(a).tissue) <
                   haptics::maxStiffness(m_model.structure(b).tissue);
        });
    } else if (m_order == Order::Layer) {
        std::stable_sort(rows.begin(), rows.end(),
                         [this](int a, int b) { return m_model.structure(a).layer < m_model.structure(b).layer; });
    }
    if (m_grouping == Grouping::Anatomy) {
        std::vector<AnatomyGroup> groupOfRow;
        for (int row = 0; row < m_model.rowCount(); ++row) {
            groupOfRow.push_back(anatomyGroup(m_model.structure(row).name));
        }
        std::stable_sort(rows.begin(), rows.end(), [&](int a, int b) {
            return groupOfRow[static_cast<std::size_t>(a)] < groupOfRow[static_cast<std::size_t>(b)];
        });
    }
    std::vector<Group> groups;
    if (!isGrouped()) {
        groups.push_back({QString(), std::move(rows)});
        return groups;
    }
    QHash<QString, std::size_t> numbers;
    for (const int row : rows) {
        const QString title = groupOf(row);
        const auto known = numbers.constFind(title);
        if (known == numbers.constEnd()) {
            numbers.insert(title, groups.size());
            groups.push_back({title, {row}});
        } else {
            groups[*known].rows.push_back(row);
        }
    }
    return groups;
}

void StructureTree::rearrange()
{
    beginResetModel();
    m_groups = arranged();
    endResetModel();
}

/// Rebuilds the tree only if the arrangement changed, to preserve selection and expanded groups otherwise.
void StructureTree::refresh()
{
    if (arranged() != m_groups) {
        rearrange();
        return;
    }
    if (rowCount() == 0) {
        return;
    }
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    for (int group = 0; isGrouped() && group < rowCount(); ++group) {
        const QModelIndex above = index(group, 0);
        Q_EMIT dataChanged(index(0, 0, above), index(rowCount(above) - 1, columnCount() - 1, above));
    }
}

int StructureTree::rowOf(const QModelIndex& index) const
{
    if (!index.isValid() || (isGrouped() && index.internalId() == 0)) {
        return -1;
    }
    const std::size_t group = isGrouped() ? index.internalId() - 1 : 0;
    return m_groups[group].rows[static_cast<std::size_t>(index.row())];
}

std::vector<int> StructureTree::rowsOf(const QModelIndex& index) const
{
    if (!index.isValid()) {
        return {};
    }
    const int row = rowOf(index);
    return row >= 0 ? std::vector<int>{row} : m_groups[static_cast<std::size_t>(index.row())].rows;
}

QModelIndex StructureTree::indexOf(int row, int column) const
{
    for (std::size_t group = 0; group < m_groups.size(); ++group) {
        const std::vector<int>& rows = m_groups[group].rows;
        const auto found = std::find(rows.begin(), rows.end(), row);
        if (found != rows.end()) {
            return createIndex(static_cast<int>(found - rows.begin()), column, isGrouped() ? group + 1 : 0);
        }
    }
    return {};
}

QModelIndex StructureTree::index(int row, int column, const QModelIndex& parent) const
{
    if (row < 0 || row >= rowCount(parent) || column < 0 || column >= columnCount()) {
        return {};
    }
    // Internal id: 0 at the top level, group + 1 for the members of a group.
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : 0);
}

QModelIndex StructureTree::parent(const QModelIndex& index) const
{
    return isGrouped() && index.isValid() && index.internalId() > 0
               ? createIndex(static_cast<int>(index.internalId()) - 1, 0, quintptr{0})
               : QModelIndex();
}

int StructureTree::rowCount(const QModelIndex& parent) const
{
    if (!parent.isValid()) {
        return static_cast<int>(isGrouped() ? m_groups.size() : m_groups.front().rows.size());
    }
    const bool isGroup = isGrouped() && parent.internalId() == 0 && parent.column() == 0;
    return isGroup ? static_cast<int>(m_groups[static_cast<std::size_t>(parent.row())].rows.size()) : 0;
}

int StructureTree::columnCount(const QModelIndex& /*parent*/) const
{
    return StructureModel::ColumnCount;
}

QVariant StructureTree::groupData(const Group& group, int column, int role) const
{
    const auto hasAny = [&](bool meshio::SceneStructure::*what) {
        return std::any_of(group.rows.begin(), group.rows.end(), [&](int row) { return m_model.structure(row).*what; });
    };
    const bool isText = role == Qt::ToolTipRole || role == Qt::AccessibleTextRole;
    if (column == StructureModel::Name) {
        if (role == Qt::DisplayRole || isText) {
            return tr("%1 (%2)").arg(group.title).arg(group.rows.size());
        }
        if (role == Qt::FontRole) {
            QFont bold;
            bold.setBold(true);
            return bold;
        }
    } else if (column == StructureModel::Shown) {
        const bool isShown = hasAny(&meshio::SceneStructure::visible);
        if (role == Qt::DecorationRole) {
            return icon(isShown ? Symbol::Eye : Symbol::EyeOff);
        }
        if (isText) {
            return isShown ? tr("Hide all of %1").arg(group.title) : tr("Show all of %1").arg(group.title);
        }
    } else if (column == StructureModel::Felt) {
        const bool isFelt = hasAny(&meshio::SceneStructure::palpable);
        if (role == Qt::DecorationRole) {
            return icon(isFelt ? Symbol::Hand : Symbol::HandOff);
        }
        if (isText) {
            return isFelt ? tr("Let the hand pass through all of %1").arg(group.title)
                          : tr("Make all of %1 palpable").arg(group.title);
        }
    }
    return {};
}

QVariant StructureTree::data(const QModelIndex& index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const int row = rowOf(index);
    return row >= 0 ? m_model.data(m_model.index(row, index.column()), role)
                    : groupData(m_groups[static_cast<std::size_t>(index.row())], index.column(), role);
}

QVariant StructureTree::headerData(int section, Qt::Orientation orientation, int role) const
{
    return m_model.headerData(section, orientation, role);
}

bool StructureTree::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const int row = rowOf(index);
    return row >= 0 && m_model.setData(m_model.index(row, index.column()), value, role);
}

Qt::ItemFlags StructureTree::flags(const QModelIndex& index) const
{
    const int row = rowOf(index);
    if (row >= 0) {
        return m_model.flags(m_model.index(row, index.column()));
    }
    return index.isValid() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable : Qt::NoItemFlags;
}

} // namespace palpate::ui

#include "palpate/ui/moc_StructureTree.cpp"
