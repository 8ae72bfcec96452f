// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Finding.h>

#include <QAbstractTableModel>
#include <QUndoStack>

#include <vector>

namespace palpate::ui {

/// The open scene's findings and notes as a table that is edited in place; every change can be undone.
/// @par Thread The GUI's.
class FindingsModel : public QAbstractTableModel
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

    /// @param undo  of all edits of the scene; must outlive this
    explicit FindingsModel(QUndoStack& undo, QObject* parent = nullptr);

    /// Takes those of another scene; nothing to undo.
    void reset(std::vector<core::Finding> findings);
    [[nodiscard]] const std::vector<core::Finding>& findings() const noexcept { return m_findings; }
    /// Adds some at the end as one step; one without an id, or with one that is taken, gets an id.
    /// @param text  what is undone, "Mark Finding 3"
    void add(std::vector<core::Finding> findings, const QString& text);
    /// Replaces one; its id stays.
    void edit(int row, core::Finding finding, const QString& text);
    /// Removes rows as one step.
    void remove(std::vector<int> rows);
    /// Says which file a recording became, once it is whole; nothing to undo.
    void setRecordingHash(const std::string& file, const std::string& sha256);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// Type takes the type's number, Name, Size (empty: not known) and Note take a text.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

  Q_SIGNALS:
    void changed();
    void marked(const palpate::core::Finding& finding);
    void unmarked(const palpate::core::Finding& finding);
    void edited(const palpate::core::Finding& finding);
    /// What was typed is not taken. @param line  why
    void refused(const QString& line);

  private:
    class Step;
    void insert(int row, const core::Finding& finding);
    void take(int row);
    void replace(int row, const core::Finding& finding);

    QUndoStack& m_undo;
    std::vector<core::Finding> m_findings;
};

/// "lump 20 mm in liver": what was felt, and the organ around it.
[[nodiscard]] QString whereText(const core::Finding& finding);
/// "lump" in the person's language.
[[nodiscard]] QString typeName(core::FindingType type);
/// "●": the shape that the view draws.
[[nodiscard]] QString typeSign(core::FindingType type);

} // namespace palpate::ui
