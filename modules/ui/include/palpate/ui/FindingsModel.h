// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Finding.h>

#include <QAbstractTableModel>
#include <QUndoStack>

#include <vector>

namespace palpate::ui {

/// Editable table of the open scene's findings and notes. Every change can be undone.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT FindingsModel : public QAbstractTableModel
{
    Q_OBJECT
  public:
    enum Column
    {
        Number,
        Type,
        Name,
        Where,
        Size,  ///< [mm]
        Force, ///< [N]
        Depth, ///< [mm]
        Note,
        ColumnCount
    };

    /// @param undo  undo stack of all scene edits; must outlive this object
    explicit FindingsModel(QUndoStack& undo, QObject* parent = nullptr);

    /// Replaces all findings when a scene is opened. Not undoable.
    void reset(std::vector<core::Finding> findings);
    [[nodiscard]] const std::vector<core::Finding>& findings() const noexcept { return m_findings; }
    /// Appends findings as one undo step. Missing and duplicate ids are replaced by new ids.
    /// @param text  label of the undo step, "Mark Finding 3"
    void add(std::vector<core::Finding> findings, const QString& text);
    /// Replaces a finding and keeps its id.
    void edit(int row, core::Finding finding, const QString& text);
    /// Removes rows as one undo step.
    void remove(std::vector<int> rows);
    /// Records the final hash of a recording file in the findings that refer to the file. Not undoable.
    void setRecordingHash(const std::string& file, const std::string& sha256);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// Type takes the number of the type; Name, Size (empty: unknown) and Note take text.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

  Q_SIGNALS:
    void changed();
    void marked(const palpate::core::Finding& finding);
    void unmarked(const palpate::core::Finding& finding);
    void edited(const palpate::core::Finding& finding);
    /// Emitted when typed input is rejected. @param line  reason, for the user
    void refused(const QString& line);

  private:
    class Step;
    void insert(int row, const core::Finding& finding);
    void take(int row);
    void replace(int row, const core::Finding& finding);

    QUndoStack& m_undo;
    std::vector<core::Finding> m_findings;
};

/// Location of a finding: "lump 20 mm in liver", with the structure and the surrounding organ.
[[nodiscard]] PALPATE_EXPORT QString whereText(const core::Finding& finding);
/// Translated type name: "lump".
[[nodiscard]] PALPATE_EXPORT QString typeName(core::FindingType type);
/// Symbol of a type, same shape as the marker in the view: "●".
[[nodiscard]] PALPATE_EXPORT QString typeSign(core::FindingType type);

} // namespace palpate::ui
