// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <QAbstractItemModel>
#include <QString>

#include <vector>

namespace palpate::ui {

/// The structures of the scene as the list shows them: in an order, in groups, those that match a filter. Columns are
/// StructureModel's; what was removed from the scene isn't there.
class StructureTree : public QAbstractItemModel
{
    Q_OBJECT
  public:
    enum class Order
    {
        Scene, ///< as the files were opened, what lies in something after it
        Name,
        Tissue, ///< softest first
        Layer   ///< outermost first
    };
    enum class Grouping
    {
        None,
        Source, ///< by the file that holds several structures, else by the folder of the files
        Layer
    };

    /// @param model  must outlive this
    explicit StructureTree(StructureModel& model, QObject* parent = nullptr);

    void setOrder(Order order);
    [[nodiscard]] Order order() const noexcept { return m_order; }
    void setGrouping(Grouping grouping);
    [[nodiscard]] Grouping grouping() const noexcept { return m_grouping; }
    /// Lists only the structures whose name has each word of `text`, in any order; all for none.
    void setFilter(const QString& text);
    /// Structures that are listed.
    [[nodiscard]] int listedCount() const;

    /// @return the structure's row in StructureModel; -1 for a group.
    [[nodiscard]] int rowOf(const QModelIndex& index) const;
    /// @return rows of a structure or of all that a group lists.
    [[nodiscard]] std::vector<int> rowsOf(const QModelIndex& index) const;
    /// @return an invalid index when the structure isn't listed.
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
    [[nodiscard]] bool isListed(int row) const;
    [[nodiscard]] bool isGrouped() const noexcept { return m_grouping != Grouping::None; }
    [[nodiscard]] QVariant groupData(const Group& group, int column, int role) const;
    void rearrange();
    void refresh();

    StructureModel& m_model;
    Order m_order = Order::Scene;
    Grouping m_grouping = Grouping::None;
    QStringList m_words;         ///< of the filter
    std::vector<Group> m_groups; ///< one, without a title, when there is no grouping
};

} // namespace palpate::ui
