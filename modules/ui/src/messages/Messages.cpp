// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Messages.h"

#include "palpate/ui/Theme.h"

namespace palpate::ui {

void Messages::add(Kind kind, const QString& text)
{
    if (text.isEmpty() || (!m_all.empty() && m_all.back().text == text)) {
        return;
    }
    if (m_all.size() >= static_cast<std::size_t>(kMost)) {
        beginRemoveRows({}, 0, 0);
        m_all.pop_front();
        endRemoveRows();
    }
    const int row = rowCount();
    beginInsertRows({}, row, row);
    m_all.push_back({kind, QTime::currentTime(), text});
    endInsertRows();
}

int Messages::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_all.size());
}

QVariant Messages::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const Message& one = m_all[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return QStringLiteral("%1  %2").arg(one.at.toString(QStringLiteral("HH:mm:ss")), one.text);
    case Qt::DecorationRole:
        return iconOf(one.kind);
    case Qt::ToolTipRole:
        return one.text;
    case Qt::AccessibleTextRole:
        return tr("%1: %2").arg(word(one.kind), one.text);
    default:
        return {};
    }
}

QString Messages::word(Kind kind)
{
    switch (kind) {
    case Kind::Told:
        return tr("Information");
    case Kind::Warning:
        return tr("Warning");
    case Kind::Error:
        return tr("Error");
    case Kind::Offer:
        break;
    }
    return tr("Offer");
}

QIcon Messages::iconOf(Kind kind)
{
    switch (kind) {
    case Kind::Told:
        return icon(Symbol::Told);
    case Kind::Warning:
        return icon(Symbol::Warning);
    case Kind::Error:
        return icon(Symbol::Error);
    case Kind::Offer:
        break;
    }
    return icon(Symbol::Offer);
}

} // namespace palpate::ui

#include "palpate/ui/moc_Messages.cpp"
