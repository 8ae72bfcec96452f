// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TapesModel.h"

#include "palpate/ui/Translated.h"

#include <palpate/study/Distances.h>

#include <QLocale>
#include <QUndoCommand>

#include <algorithm>
#include <utility>

namespace palpate::ui {

/// Undo step that replaces the list, which is short.
class TapesModel::Step final : public QUndoCommand
{
  public:
    Step(TapesModel& model, std::vector<core::Tape> after, const QString& text)
        : QUndoCommand(text)
        , m_model(model)
        , m_before(model.m_tapes)
        , m_after(std::move(after))
    {
    }
    void redo() override { m_model.take(m_after); }
    void undo() override { m_model.take(m_before); }

  private:
    TapesModel& m_model;
    std::vector<core::Tape> m_before, m_after;
};

TapesModel::TapesModel(QUndoStack& undo, QObject* parent)
    : QAbstractTableModel(parent)
    , m_undo(undo)
{
}

void TapesModel::take(std::vector<core::Tape> tapes)
{
    beginResetModel();
    m_tapes = std::move(tapes);
    endResetModel();
    Q_EMIT changed();
}

void TapesModel::reset(std::vector<core::Tape> tapes)
{
    take(std::move(tapes));
}

void TapesModel::add(std::vector<core::Tape> tapes)
{
    if (tapes.empty()) {
        return;
    }
    std::vector<core::Tape> after = m_tapes;
    for (core::Tape& tape : tapes) {
        for (std::size_t number = after.size() + 1; tape.name.empty(); ++number) {
            const std::string name = tr("Tape %1").arg(number).toStdString();
            const bool isTaken = std::any_of(after.begin(), after.end(),
                                             [&name](const core::Tape& other) { return other.name == name; });
            tape.name = isTaken ? std::string() : name;
        }
        after.push_back(std::move(tape));
    }
    const QString text = tr("Measure %1").arg(QString::fromStdString(after.back().name));
    m_undo.push(new Step(*this, std::move(after), text));
}

void TapesModel::remove(const std::vector<int>& rows)
{
    std::vector<core::Tape> after;
    QString gone;
    for (int row = 0; row < rowCount(); ++row) {
        const core::Tape& one = m_tapes[static_cast<std::size_t>(row)];
        if (std::find(rows.begin(), rows.end(), row) == rows.end()) {
            after.push_back(one);
        } else {
            gone = QString::fromStdString(one.name);
        }
    }
    const auto count = static_cast<int>(m_tapes.size() - after.size());
    if (count > 0) {
        m_undo.push(new Step(*this, std::move(after),
                             count == 1 ? tr("Delete %1").arg(gone) : tr("Delete %1 tapes").arg(count)));
    }
}

int TapesModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_tapes.size());
}

int TapesModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant TapesModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const core::Tape& tape = m_tapes[static_cast<std::size_t>(index.row())];
    if (role == Qt::TextAlignmentRole) {
        return int(Qt::AlignVCenter | (index.column() == Length ? Qt::AlignRight : Qt::AlignLeft));
    }
    if (role == Qt::ToolTipRole) {
        return translated(study::sentence(tape));
    }
    if (role != Qt::DisplayRole && role != Qt::EditRole) {
        return {};
    }
    switch (index.column()) {
    case Name:
        return QString::fromStdString(tape.name);
    case Length:
        return lengthText(tape.length_mm());
    case From:
        return QString::fromStdString(tape.fromOn);
    case To:
        return QString::fromStdString(tape.toOn);
    default:
        return {};
    }
}

QVariant TapesModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return orientation == Qt::Horizontal && role == Qt::TextAlignmentRole
                   ? QVariant(int(Qt::AlignVCenter | (section == Length ? Qt::AlignRight : Qt::AlignLeft)))
                   : QVariant();
    }
    switch (section) {
    case Name:
        return tr("Tape");
    case Length:
        return tr("Length");
    case From:
        return tr("From");
    case To:
        return tr("To");
    default:
        return {};
    }
}

bool TapesModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const std::string name = value.toString().trimmed().toStdString();
    if (!index.isValid() || role != Qt::EditRole || index.column() != Name || name.empty()) {
        return false;
    }
    std::vector<core::Tape> after = m_tapes;
    core::Tape& tape = after[static_cast<std::size_t>(index.row())];
    const QString before = QString::fromStdString(tape.name);
    tape.name = name;
    if (after != m_tapes) {
        m_undo.push(new Step(*this, std::move(after), tr("Rename %1").arg(before)));
    }
    return true;
}

Qt::ItemFlags TapesModel::flags(const QModelIndex& index) const
{
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return index.isValid() && index.column() == Name ? flags | Qt::ItemIsEditable : flags;
}

QString lengthText(double length_mm)
{
    return TapesModel::tr("%1 mm").arg(QLocale().toString(length_mm, 'f', 1));
}

} // namespace palpate::ui

#include "palpate/ui/moc_TapesModel.cpp"
