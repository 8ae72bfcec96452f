// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <QAbstractListModel>
#include <QIcon>
#include <QTime>

#include <deque>
#include <functional>

namespace palpate::ui {

/// All messages since program start, oldest first: status lines, file warnings, errors and offers. Keeps the newest
/// `kMost`.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT Messages : public QAbstractListModel
{
    Q_OBJECT
  public:
    enum class Kind
    {
        Told,    ///< status or hint
        Warning, ///< the open data deviates from the expected state
        Error,   ///< a requested operation failed
        Offer    ///< available action that waits for an answer
    };
    static constexpr int kMost = 5000;

    using QAbstractListModel::QAbstractListModel;

    /// Adds a message unless the newest message is identical.
    void add(Kind kind, const QString& text) { add(kind, QStringList(text)); }
    /// Adds messages in one batch, which a view lays out once.
    void add(Kind kind, const QStringList& texts);
    /// Removes all messages whose text matches.
    void removeIf(const std::function<bool(const QString& text)>& matches);
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] Kind kind(int row) const { return m_all[static_cast<std::size_t>(row)].kind; }
    [[nodiscard]] QString text(int row) const { return m_all[static_cast<std::size_t>(row)].text; }

    /// Name of the kind, for screen readers.
    [[nodiscard]] static QString word(Kind kind);
    [[nodiscard]] static QIcon iconOf(Kind kind);

  private:
    struct Message
    {
        Kind kind = Kind::Told;
        QTime at;
        QString text;
    };
    std::deque<Message> m_all;
};

} // namespace palpate::ui
