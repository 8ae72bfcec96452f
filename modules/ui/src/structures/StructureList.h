// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureTree.h"

#include <QSet>
#include <QTreeView>
#include <QWidget>

#include <vector>

class QLabel;
class QLineEdit;

namespace palpate::ui {

/// Tree view of the structures. A click on the eye or hand icon of a selected structure keeps the selection, to which
/// the click applies.
class StructureListView final : public QTreeView
{
  public:
    using QTreeView::QTreeView;

  protected:
    QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex& index, const QEvent* event) const override;
};

/// Structure list with filter and a menu for order and grouping. Preserves the selection when the list changes.
class StructureList : public QWidget
{
    Q_OBJECT
  public:
    explicit StructureList(StructureModel& model, QWidget* parent = nullptr);
    ~StructureList() override; ///< commits a name being edited

    [[nodiscard]] StructureListView& view() noexcept { return *m_view; }
    [[nodiscard]] const StructureTree& tree() const noexcept { return m_tree; }
    /// Focused structure, else the first selected; -1: no selection.
    [[nodiscard]] int currentRow() const;
    /// Selected rows in ascending order; a selected group stands for all listed members.
    [[nodiscard]] std::vector<int> selectedRows() const;
    /// Selects a structure and scrolls to it. Clears a filter that hides the structure.
    /// @param adds  toggles the structure in the selection
    void select(int row, bool adds = false);
    void clearSelection();
    /// Moves the keyboard focus to the filter field.
    void focusFilter();

  Q_SIGNALS:
    void selectionChanged();

  protected:
    /// In the filter: Esc clears the text, Return and Down move to the list.
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void makeView();
    void applyStyle();
    [[nodiscard]] QWidget* makeHead();
    void keepSelection();
    void bringSelectionBack();
    void showCount();
    void showHidden();

    StructureModel& m_model;
    StructureTree m_tree;
    StructureListView* m_view = nullptr;
    QLineEdit* m_filter = nullptr;
    QLabel* m_count = nullptr;  ///< number of matching structures
    QLabel* m_hidden = nullptr; ///< number of hidden targets of an exercise
    std::vector<int> m_kept;    ///< selected rows during rearrangement
    int m_keptCurrent = -1;
    QSet<QString> m_closed; ///< titles of collapsed groups
    bool m_isRearranging = false;
};

} // namespace palpate::ui
