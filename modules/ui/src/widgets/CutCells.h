// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractItemView>
#include <QObject>

namespace palpate::ui {

/// Shortens the texts of a list or table in the middle, where names differ the least, and adds the whole text of a
/// shortened cell to its tool tip.
class CutCells : public QObject
{
  public:
    static constexpr auto kName = "cutCells"; ///< object name, to find out whether a view has one
    /// @param view  owns this object
    explicit CutCells(QAbstractItemView& view);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    [[nodiscard]] bool isCut(const QModelIndex& index) const;

    QAbstractItemView& m_view;
};

} // namespace palpate::ui
