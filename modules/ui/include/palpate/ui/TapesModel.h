// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Tape.h>

#include <QAbstractTableModel>
#include <QUndoStack>

#include <vector>

namespace palpate::ui {

/// Table of the open scene's tapes. Every change can be undone.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT TapesModel : public QAbstractTableModel
{
    Q_OBJECT
  public:
    enum Column
    {
        Name,
        Length, ///< [mm]
        From,
        To,
        ColumnCount
    };

    /// @param undo  undo stack of all scene edits; must outlive this object
    explicit TapesModel(QUndoStack& undo, QObject* parent = nullptr);

    /// Replaces all tapes when a scene is opened. Not undoable.
    void reset(std::vector<core::Tape> tapes);
    [[nodiscard]] const std::vector<core::Tape>& tapes() const noexcept { return m_tapes; }
    /// Appends tapes as one undo step. A tape without a name gets a number: "Tape 2".
    void add(std::vector<core::Tape> tapes);
    /// Removes rows as one undo step.
    void remove(const std::vector<int>& rows);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// Name takes text that is not empty.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

  Q_SIGNALS:
    void changed();

  private:
    class Step;
    void take(std::vector<core::Tape> tapes);

    QUndoStack& m_undo;
    std::vector<core::Tape> m_tapes;
};

/// Returns a length for table and view: "12.3 mm".
[[nodiscard]] PALPATE_EXPORT QString lengthText(double length_mm);

} // namespace palpate::ui
