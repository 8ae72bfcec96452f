// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractListModel>
#include <QIcon>
#include <QTime>

#include <deque>

namespace palpate::ui {

/// Everything that the program told since it was started, oldest first: what passed by in the status line, warnings of
/// files, errors, offers. The newest `kMost` are kept.
/// @par Thread The GUI's.
class Messages : public QAbstractListModel
{
    Q_OBJECT
  public:
    enum class Kind
    {
        Told,    ///< something was done, or how it is done
        Warning, ///< to look at: what is open is not quite what it should be
        Error,   ///< something asked for was not done
        Offer    ///< something can be done, and waits for an answer
    };
    static constexpr int kMost = 5000;

    using QAbstractListModel::QAbstractListModel;

    /// Adds a message, unless the newest one is the same.
    void add(Kind kind, const QString& text);
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] Kind kind(int row) const { return m_all[static_cast<std::size_t>(row)].kind; }
    [[nodiscard]] QString text(int row) const { return m_all[static_cast<std::size_t>(row)].text; }

    /// The kind in a word, for those who don't see the icon.
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
