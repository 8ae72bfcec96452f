// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Messages.h"

#include "palpate/ui/Theme.h"

#include <vector>

namespace palpate::ui {

void Messages::add(Kind kind, const QStringList& texts)
{
    std::vector<Message> added;
    for (const QString& text : texts) {
        const QString newest = !added.empty() ? added.back().text : m_all.empty() ? QString() : m_all.back().text;
        if (!text.isEmpty() && text != newest) {
            added.push_back({kind, QTime::currentTime(), text});
        }
    }
    if (added.size() > static_cast<std::size_t>(kMost)) {
        added.erase(added.begin(), added.end() - kMost);
    }
    if (added.empty()) {
        return;
    }
    if (const int surplus = rowCount() + static_cast<int>(added.size()) - kMost; surplus > 0) {
        beginRemoveRows({}, 0, surplus - 1);
        m_all.erase(m_all.begin(), m_all.begin() + surplus);
        endRemoveRows();
    }
    beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(added.size()) - 1);
    m_all.insert(m_all.end(), added.begin(), added.end());
    endInsertRows();
}

void Messages::removeIf(const std::function<bool(const QString& text)>& matches)
{
    for (int row = rowCount() - 1; row >= 0; --row) {
        if (matches(text(row))) {
            beginRemoveRows({}, row, row);
            m_all.erase(m_all.begin() + row);
            endRemoveRows();
        }
    }
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
