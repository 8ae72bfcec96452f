// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <palpate/core/Export.h>

#include <QAbstractItemModel>
#include <QString>

#include <vector>

namespace palpate::ui {

/// Sorted, grouped and filtered tree of the scene's structures for the list. The columns are those of StructureModel;
/// removed structures are omitted.
class PALPATE_EXPORT StructureTree : public QAbstractItemModel
{
    Q_OBJECT
  public:
    enum class Order
    {
        Scene, ///< file order, contained structures after their container
        Name,
        Tissue, ///< softest first
        Layer   ///< outermost first
    };
    enum class Grouping
    {
        None,
        Source, ///< by a file with several structures, else by folder
        Layer,
        Anatomy ///< lumps, organs, vessels, bones, muscles: by the name (meshio::anatomyKind)
    };

    /// @param model  must outlive this object
    explicit StructureTree(StructureModel& model, QObject* parent = nullptr);

    void setOrder(Order order);
    [[nodiscard]] Order order() const noexcept { return m_order; }
    /// Without a call, a scene with many structures of several kinds is grouped by anatomy, any other is not grouped.
    void setGrouping(Grouping grouping);
    [[nodiscard]] Grouping grouping() const noexcept { return m_grouping; }
    /// Lists only structures whose names contain every word of `text` in any order. An empty text lists all.
    void setFilter(const QString& text);
    /// Number of listed structures.
    [[nodiscard]] int listedCount() const;

    /// Row of a structure in StructureModel; -1 for a group.
    [[nodiscard]] int rowOf(const QModelIndex& index) const;
    /// Row of a structure, or all listed rows of a group.
    [[nodiscard]] std::vector<int> rowsOf(const QModelIndex& index) const;
    /// Index of a row; invalid when the structure is not listed.
    [[nodiscard]] QModelIndex indexOf(int row, int column = StructureModel::Name) const;

    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& index) const override;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

  private:
    struct Group
    {
        QString title;
        std::vector<int> rows;
        bool operator==(const Group&) const = default;
    };
    [[nodiscard]] std::vector<Group> arranged() const;
    [[nodiscard]] QString groupOf(int row) const;
    [[nodiscard]] Grouping fittingGrouping() const;
    void takeScene();
    [[nodiscard]] bool isListed(int row) const;
    [[nodiscard]] bool isGrouped() const noexcept { return m_grouping != Grouping::None; }
    [[nodiscard]] QVariant groupData(const Group& group, int column, int role) const;
    void rearrange();
    void refresh();

    StructureModel& m_model;
    Order m_order = Order::Scene;
    Grouping m_grouping = Grouping::None;
    bool m_isChosen = false;     ///< by `setGrouping`
    QStringList m_words;         ///< words of the filter
    std::vector<Group> m_groups; ///< a single untitled group without grouping
};

} // namespace palpate::ui
