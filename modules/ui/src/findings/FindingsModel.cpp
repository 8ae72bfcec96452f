// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/FindingsModel.h"

#include "palpate/ui/StructureModel.h"
#include "palpate/ui/TouchPanel.h"
#include "palpate/ui/Translated.h"

#include <palpate/study/FindingsFile.h>

#include <QColor>
#include <QCoreApplication>
#include <QLocale>
#include <QUndoCommand>
#include <QUuid>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace palpate::ui {

namespace {

constexpr double kMostSize_mm = 1e4;

/// Formats a size with the digits that were entered.
QString sizeText(const std::optional<double>& value)
{
    constexpr int kDigits = 15; // as many as any decimal number keeps in a double
    return value ? numberText(*value, kDigits) : QString();
}

QString tipOf(const core::Finding& finding)
{
    QStringList lines;
    for (const core::FindingLayer& layer : finding.layers) {
        lines << FindingsModel::tr("%1: %2 N, %3 mm deep")
                     .arg(readableName(layer.structure), forceText(layer.force_N), depthText(layer.depth_mm));
    }
    if (const auto felt = core::felt_N_per_mm(finding)) {
        lines << FindingsModel::tr("stiffness %1 N/mm").arg(QLocale().toString(*felt, 'f', 2));
    }
    if (!finding.note.empty()) {
        lines << QString::fromStdString(finding.note);
    }
    return lines.join(QLatin1Char('\n'));
}

} // namespace

QString whereText(const core::Finding& finding)
{
    const std::string organ = study::organOf(finding);
    const QString structure = readableName(finding.structure);
    return organ.empty() ? structure : FindingsModel::tr("%1 in %2").arg(structure, readableName(organ));
}

QString typeName(core::FindingType type)
{
    static constexpr std::array<const char*, core::kFindingTypeNames.size()> kNames{
        QT_TRANSLATE_NOOP("FindingType", "lump"),      QT_TRANSLATE_NOOP("FindingType", "hard area"),
        QT_TRANSLATE_NOOP("FindingType", "soft area"), QT_TRANSLATE_NOOP("FindingType", "landmark"),
        QT_TRANSLATE_NOOP("FindingType", "keep away"), QT_TRANSLATE_NOOP("FindingType", "other")};
    return QCoreApplication::translate("FindingType", kNames[static_cast<std::size_t>(type)]);
}

QString typeSign(core::FindingType type)
{
    static constexpr std::array<char16_t, core::kFindingTypeNames.size()> kSigns{u'●', u'◆', u'■', u'▲', u'✕', u'○'};
    return QChar(kSigns[static_cast<std::size_t>(type)]);
}

/// Undo step that inserts, removes or replaces rows.
class FindingsModel::Step final : public QUndoCommand
{
  public:
    struct Change
    {
        int row = 0;
        std::optional<core::Finding> before, after; // empty: the row does not exist
    };
    Step(FindingsModel& model, std::vector<Change> changes, const QString& text)
        : QUndoCommand(text)
        , m_model(model)
        , m_changes(std::move(changes))
    {
    }
    void redo() override
    {
        for (const Change& change : m_changes) {
            apply(change.row, change.before, change.after);
        }
        Q_EMIT m_model.changed();
    }
    void undo() override
    {
        for (auto change = m_changes.rbegin(); change != m_changes.rend(); ++change) {
            apply(change->row, change->after, change->before);
        }
        Q_EMIT m_model.changed();
    }

  private:
    void apply(int row, const std::optional<core::Finding>& from, const std::optional<core::Finding>& to)
    {
        if (!from) {
            m_model.insert(row, *to);
        } else if (!to) {
            m_model.take(row);
        } else {
            m_model.replace(row, *to);
        }
    }

    FindingsModel& m_model;
    std::vector<Change> m_changes;
};

FindingsModel::FindingsModel(QUndoStack& undo, QObject* parent)
    : QAbstractTableModel(parent)
    , m_undo(undo)
{
}

void FindingsModel::reset(std::vector<core::Finding> findings)
{
    beginResetModel();
    m_findings = std::move(findings);
    endResetModel();
    Q_EMIT changed();
}

void FindingsModel::add(std::vector<core::Finding> findings, const QString& text)
{
    std::vector<Step::Change> changes;
    int row = rowCount();
    for (core::Finding& finding : findings) {
        const auto isTaken = [&](const core::Finding& one) { return one.id == finding.id; };
        if (finding.id.empty() || std::any_of(m_findings.begin(), m_findings.end(), isTaken)) {
            finding.id = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
        }
        changes.push_back({row++, std::nullopt, std::move(finding)});
    }
    if (!changes.empty()) {
        m_undo.push(new Step(*this, std::move(changes), text));
    }
}

void FindingsModel::edit(int row, core::Finding finding, const QString& text)
{
    const core::Finding& before = m_findings[static_cast<std::size_t>(row)];
    finding.id = before.id;
    if (finding != before) {
        m_undo.push(new Step(*this, {{row, before, std::move(finding)}}, text));
    }
}

void FindingsModel::remove(std::vector<int> rows)
{
    std::sort(rows.rbegin(), rows.rend()); // from the end, so that the remaining row numbers stay valid
    std::vector<Step::Change> changes;
    for (const int row : rows) {
        changes.push_back({row, m_findings[static_cast<std::size_t>(row)], std::nullopt});
    }
    if (!changes.empty()) {
        const QString text = changes.size() == 1
                                 ? tr("Delete %1").arg(QString::fromStdString(changes.front().before->name))
                                 : tr("Delete %1 findings").arg(changes.size());
        m_undo.push(new Step(*this, std::move(changes), text));
    }
}

void FindingsModel::setRecordingHash(const std::string& file, const std::string& sha256)
{
    for (core::Finding& finding : m_findings) {
        if (finding.recording && finding.recording->file == file) {
            finding.recording->sha256 = sha256;
        }
    }
}

void FindingsModel::insert(int row, const core::Finding& finding)
{
    beginInsertRows({}, row, row);
    m_findings.insert(m_findings.begin() + row, finding);
    endInsertRows();
    Q_EMIT marked(finding);
}

void FindingsModel::take(int row)
{
    const core::Finding gone = m_findings[static_cast<std::size_t>(row)];
    beginRemoveRows({}, row, row);
    m_findings.erase(m_findings.begin() + row);
    endRemoveRows();
    Q_EMIT unmarked(gone);
}

void FindingsModel::replace(int row, const core::Finding& finding)
{
    m_findings[static_cast<std::size_t>(row)] = finding;
    Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
    Q_EMIT edited(finding);
}

int FindingsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_findings.size());
}

int FindingsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant FindingsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const core::Finding& finding = m_findings[static_cast<std::size_t>(index.row())];
    if (role == Qt::TextAlignmentRole) {
        const bool isNumber = index.column() == Number || (index.column() >= Size && index.column() <= Depth);
        return int(Qt::AlignVCenter | (isNumber ? Qt::AlignRight : Qt::AlignLeft));
    }
    if (role == Qt::ToolTipRole) {
        return tipOf(finding);
    }
    if (role != Qt::DisplayRole && role != Qt::EditRole) {
        return {};
    }
    switch (index.column()) {
    case Number:
        return index.row() + 1;
    case Type:
        if (role == Qt::EditRole) {
            return static_cast<int>(finding.type);
        }
        return finding.hasPlace ? typeSign(finding.type) + QLatin1Char(' ') + typeName(finding.type)
                                : QStringLiteral("✎ ") + tr("note");
    case Name:
        return QString::fromStdString(finding.name);
    case Where:
        return whereText(finding);
    case Size:
        return sizeText(finding.size_mm);
    case Force:
        return finding.force_N ? forceText(*finding.force_N) : QString();
    case Depth:
        return finding.depth_mm ? depthText(*finding.depth_mm) : QString();
    case Note: {
        const QString note = QString::fromStdString(finding.note);
        return role == Qt::EditRole ? note : note.simplified();
    }
    default:
        return {};
    }
}

QVariant FindingsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) {
        return {};
    }
    const bool isTip = role == Qt::ToolTipRole;
    switch (section) {
    case Number:
        return isTip ? tr("Number in the view") : tr("№");
    case Type:
        return tr("Type");
    case Name:
        return tr("Name");
    case Where:
        return isTip ? tr("Palpated structure and surrounding organ") : tr("Where");
    case Size:
        return isTip ? tr("Estimated diameter [mm]") : tr("Size");
    case Force:
        return isTip ? tr("Force of this structure at the time of marking [N]") : tr("Force [N]");
    case Depth:
        return isTip ? tr("Depth in this structure at the time of marking [mm]") : tr("Depth [mm]");
    case Note:
        return tr("Note");
    default:
        return {};
    }
}

bool FindingsModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!index.isValid() || role != Qt::EditRole) {
        return false;
    }
    core::Finding finding = m_findings[static_cast<std::size_t>(index.row())];
    const QString name = QString::fromStdString(finding.name);
    const QString text = value.toString();
    switch (index.column()) {
    case Type:
        finding.type =
            static_cast<core::FindingType>(std::clamp<int>(value.toInt(), 0, core::kFindingTypeNames.size() - 1));
        edit(index.row(), finding, tr("Type of %1").arg(name));
        return true;
    case Name:
        if (text.trimmed().isEmpty()) {
            return false; // keeps the old name
        }
        finding.name = text.trimmed().toStdString();
        edit(index.row(), finding, tr("Rename %1").arg(name));
        return true;
    case Size: {
        bool isNumber = false;
        const double size_mm = QLocale().toDouble(text.trimmed(), &isNumber);
        if (!text.trimmed().isEmpty() && (!isNumber || !(size_mm >= 0.0 && size_mm <= kMostSize_mm))) {
            Q_EMIT refused(
                tr("Size: found “%1”, expected millimetres such as %2.").arg(text, QLocale().toString(12.5)));
            return false;
        }
        finding.size_mm = text.trimmed().isEmpty() ? std::nullopt : std::optional(size_mm);
        edit(index.row(), finding, tr("Size of %1").arg(name));
        return true;
    }
    case Note:
        finding.note = text.toStdString();
        edit(index.row(), finding, tr("Note on %1").arg(name));
        return true;
    default:
        return false;
    }
}

Qt::ItemFlags FindingsModel::flags(const QModelIndex& index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (!index.isValid()) {
        return flags;
    }
    const bool hasPlace = m_findings[static_cast<std::size_t>(index.row())].hasPlace;
    const int column = index.column();
    const bool isEditable = column == Name || column == Note || (hasPlace && (column == Type || column == Size));
    return isEditable ? flags | Qt::ItemIsEditable : flags;
}

} // namespace palpate::ui

#include "palpate/ui/moc_FindingsModel.cpp"
