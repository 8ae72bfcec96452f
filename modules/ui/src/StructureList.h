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

/// The tree's view: a click on the eye or hand of a selected structure keeps the selection, to which it then applies.
class StructureListView final : public QTreeView
{
  public:
    using QTreeView::QTreeView;

  protected:
    QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex& index, const QEvent* event) const override;
};

/// The list of structures with its filter and its menu of order and groups. Keeps what is selected while what is
/// listed changes.
class StructureList : public QWidget
{
    Q_OBJECT
  public:
    explicit StructureList(StructureModel& model, QWidget* parent = nullptr);
    ~StructureList() override; ///< a name that is being written is taken

    [[nodiscard]] StructureListView& view() noexcept { return *m_view; }
    [[nodiscard]] const StructureTree& tree() const noexcept { return m_tree; }
    /// The structure that has the focus, else the first selected; -1 for none.
    [[nodiscard]] int currentRow() const;
    /// Ascending; a selected group stands for all that it lists.
    [[nodiscard]] std::vector<int> selectedRows() const;
    /// Selects one structure and shows it in the list. A filter that hides it is cleared.
    /// @param adds  to what is selected, or takes it out when it is selected already
    void select(int row, bool adds = false);
    void clearSelection();
    /// Puts the cursor into the filter's field.
    void focusFilter();

  Q_SIGNALS:
    void selectionChanged();

  protected:
    /// In the filter: Esc clears it, Return and Down go to the list.
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void makeView();
    void takeLook();
    [[nodiscard]] QWidget* makeHead();
    void keepSelection();
    void bringSelectionBack();
    void showCount();

    StructureModel& m_model;
    StructureTree m_tree;
    StructureListView* m_view = nullptr;
    QLineEdit* m_filter = nullptr;
    QLabel* m_count = nullptr; ///< how many of all match the filter
    std::vector<int> m_kept;   ///< selected rows, while the tree is arranged anew
    int m_keptCurrent = -1;
    QSet<QString> m_closed; ///< titles of groups that are folded
    bool m_isRearranging = false;
};

} // namespace palpate::ui
