// SPDX-License-Identifier: BSD-3-Clause
#include "structures/StructureList.h"

#include "palpate/ui/ElidedName.h"
#include "palpate/ui/Theme.h"

#include <palpate/haptics/HapticScene.h>

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelection>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QStyle>
#include <QStyleOptionViewItem>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>
#include <utility>

namespace palpate::ui {

namespace {

/// Indents the names of inner layers, and shortens long names so that they can be told apart.
class NameDelegate final : public QStyledItemDelegate
{
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

  protected:
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        constexpr std::uint32_t kStep_px = 16, kMostSteps = haptics::kMaxLayers - 1;
        QStyleOptionViewItem whole = option; // background over the full column width
        initStyleOption(&whole, index);
        const QStyle& style = whole.widget != nullptr ? *whole.widget->style() : *QApplication::style();
        style.drawPrimitive(QStyle::PE_PanelItemViewItem, &whole, painter, whole.widget);
        QStyleOptionViewItem moved = option;
        const std::uint32_t steps = std::min(kMostSteps, index.data(StructureModel::kLayerRole).toUInt());
        moved.rect.adjust(static_cast<int>(steps * kStep_px), 0, 0, 0);
        QStyledItemDelegate::paint(painter, moved, index);
    }
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        const QStyle& style = option->widget != nullptr ? *option->widget->style() : *QApplication::style();
        const int margin = style.pixelMetric(QStyle::PM_FocusFrameHMargin, option, option->widget) + 1;
        const int width =
            style.subElementRect(QStyle::SE_ItemViewItemText, option, option->widget).width() - 2 * margin;
        if (width <= 0 || option->fontMetrics.horizontalAdvance(option->text) <= width) {
            return;
        }
        QStringList others;
        const QModelIndex group = index.parent();
        for (int row = 0; row < index.model()->rowCount(group); ++row) {
            others << index.model()->index(row, index.column(), group).data().toString();
        }
        option->text = elidedName(option->text, option->fontMetrics, width, others);
    }
};

/// Adds mutually exclusive entries to a menu. @param now  returns the value to check when the menu opens
template<class Value>
void addChoices(QMenu& menu, const QString& title, std::function<Value()> now,
                const std::vector<std::pair<QString, Value>>& choices, std::function<void(Value)> choose)
{
    menu.addSection(title);
    auto* group = new QActionGroup(&menu);
    for (const auto& [text, value] : choices) {
        QAction* action = menu.addAction(text);
        action->setCheckable(true);
        group->addAction(action);
        QObject::connect(&menu, &QMenu::aboutToShow, action,
                         [action, now, value = value] { action->setChecked(value == now()); });
        QObject::connect(action, &QAction::triggered, &menu, [choose, value = value] { choose(value); });
    }
}

/// Title of a group without the member count.
QString titleOf(const QModelIndex& group)
{
    return group.siblingAtColumn(StructureModel::Name).data().toString().section(QLatin1Char(' '), 0, -2);
}

} // namespace

QItemSelectionModel::SelectionFlags StructureListView::selectionCommand(const QModelIndex& index,
                                                                        const QEvent* event) const
{
    const bool isSymbol = index.column() == StructureModel::Shown || index.column() == StructureModel::Felt;
    const auto* mouse =
        event != nullptr && (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonRelease)
            ? static_cast<const QMouseEvent*>(event)
            : nullptr;
    if (isSymbol && mouse != nullptr && mouse->modifiers() == Qt::NoModifier && selectionModel()->isSelected(index)) {
        return QItemSelectionModel::NoUpdate;
    }
    return QTreeView::selectionCommand(index, event);
}

StructureList::StructureList(StructureModel& model, QWidget* parent)
    : QWidget(parent)
    , m_model(model)
    , m_tree(model)
    , m_view(new StructureListView(this))
{
    makeView();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(makeHead());
    layout->addWidget(m_view, 1);
    m_hidden = new QLabel(this);
    m_hidden->setObjectName(QStringLiteral("hiddenTargets"));
    m_hidden->setContentsMargins(8, 3, 8, 3);
    m_hidden->setForegroundRole(QPalette::PlaceholderText);
    m_hidden->setToolTip(tr("Targets of the exercise can be felt, but are neither drawn nor named until the exercise "
                            "ends"));
    layout->addWidget(m_hidden);
    connect(&model, &StructureModel::targetsHidden, this, &StructureList::showHidden);
    connect(&model, &QAbstractItemModel::modelReset, this, &StructureList::showHidden);
    showHidden();
    connect(&m_tree, &QAbstractItemModel::modelAboutToBeReset, this, &StructureList::keepSelection);
    connect(&m_tree, &QAbstractItemModel::modelReset, this, &StructureList::bringSelectionBack);
    connect(&model, &QAbstractItemModel::modelAboutToBeReset, this, [this] { // another scene
        m_filter->clear();
        m_closed.clear();
        m_view->selectionModel()->clear();
        m_kept.clear();
        m_keptCurrent = -1;
    });
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        if (!m_isRearranging) {
            Q_EMIT selectionChanged();
        }
    });
    connect(m_view->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
        if (!m_isRearranging) {
            Q_EMIT selectionChanged();
        }
    });
    connect(m_view, &QTreeView::collapsed, this, [this](const QModelIndex& group) { m_closed.insert(titleOf(group)); });
    connect(m_view, &QTreeView::expanded, this, [this](const QModelIndex& group) { m_closed.remove(titleOf(group)); });
    showCount();
}

StructureList::~StructureList()
{
    delete m_view; // before the tree model, to which an open editor commits
}

void StructureList::makeView()
{
    m_view->setModel(&m_tree);
    m_view->setRootIsDecorated(false);
    m_view->setTreePosition(StructureModel::Name);
    m_view->setUniformRowHeights(true);
    m_view->setAlternatingRowColors(true);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_view->setAccessibleName(tr("Structures"));
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setIndentation(0);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    m_view->setItemDelegateForColumn(StructureModel::Name, new NameDelegate(m_view));
    QHeaderView* header = m_view->header();
    header->setStretchLastSection(false);
    header->setMinimumSectionSize(24);
    for (const int column : {StructureModel::Shown, StructureModel::Health, StructureModel::Felt}) {
        header->setSectionResizeMode(column, QHeaderView::Fixed);
    }
    header->setSectionResizeMode(StructureModel::Name, QHeaderView::Stretch);
    header->hide();
    applyStyle();
}

void StructureList::applyStyle()
{
    m_view->setMinimumHeight(9 * fontMetrics().height()); // about six rows; the list scrolls
    const int symbol_px = withText_px(18);
    m_view->setIconSize(QSize(symbol_px, symbol_px));
    for (const int column : {StructureModel::Shown, StructureModel::Health, StructureModel::Felt}) {
        m_view->header()->resizeSection(column, symbol_px + 12);
    }
    // Selection as a tint, so that swatches, symbols and badges stay readable on the selected row.
    QPalette tint = palette();
    const QColor accent = tint.color(QPalette::Highlight);
    const QColor base = tint.color(QPalette::Base);
    const float share = isHighContrast() ? 0.3F : isDarkTheme() ? 0.45F : 0.22F;
    tint.setColor(QPalette::Highlight, QColor::fromRgbF(base.redF() + share * (accent.redF() - base.redF()),
                                                        base.greenF() + share * (accent.greenF() - base.greenF()),
                                                        base.blueF() + share * (accent.blueF() - base.blueF())));
    tint.setColor(QPalette::HighlightedText, tint.color(QPalette::Text));
    m_view->setPalette(tint);
}

void StructureList::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        applyStyle();
    } else if (event->type() == QEvent::StyleChange) { // a new style sheet restores the view's old palette
        QMetaObject::invokeMethod(this, &StructureList::applyStyle, Qt::QueuedConnection);
    }
    QWidget::changeEvent(event);
}

QWidget* StructureList::makeHead()
{
    auto* head = new QWidget(this);
    m_filter = new QLineEdit(head);
    m_filter->setObjectName(QStringLiteral("filter"));
    m_filter->setPlaceholderText(tr("Filter by name"));
    m_filter->setClearButtonEnabled(true);
    m_filter->setAccessibleName(tr("Filter the structures by name"));
    m_filter->setToolTip(tr("List only structures with these words in the name (Ctrl+F); Esc lists all"));
    m_filter->installEventFilter(this);
    m_count = new QLabel(head);
    m_count->setForegroundRole(QPalette::PlaceholderText);
    auto* arrange = new QToolButton(head);
    arrange->setObjectName(QStringLiteral("arrange"));
    arrange->setText(QStringLiteral("⇅"));
    arrange->setAutoRaise(true);
    arrange->setPopupMode(QToolButton::InstantPopup);
    arrange->setAccessibleName(tr("Order and groups of the list"));
    arrange->setToolTip(tr("Order and groups of the list"));
    auto* menu = new QMenu(arrange);
    addChoices<StructureTree::Order>(
        *menu, tr("Order"), [this] { return m_tree.order(); },
        {{tr("As opened"), StructureTree::Order::Scene},
         {tr("By name"), StructureTree::Order::Name},
         {tr("By tissue, softest first"), StructureTree::Order::Tissue},
         {tr("By layer, outermost first"), StructureTree::Order::Layer}},
        [this](StructureTree::Order order) { m_tree.setOrder(order); });
    addChoices<StructureTree::Grouping>(
        *menu, tr("Groups"), [this] { return m_tree.grouping(); },
        {{tr("None"), StructureTree::Grouping::None},
         {tr("By file or folder"), StructureTree::Grouping::Source},
         {tr("By layer"), StructureTree::Grouping::Layer},
         {tr("By anatomy"), StructureTree::Grouping::Anatomy}},
        [this](StructureTree::Grouping grouping) { m_tree.setGrouping(grouping); });
    arrange->setMenu(menu);
    auto* layout = new QHBoxLayout(head);
    layout->setContentsMargins(6, 6, 6, 4);
    layout->setSpacing(4);
    layout->addWidget(m_filter, 1);
    layout->addWidget(m_count);
    layout->addWidget(arrange);
    connect(m_filter, &QLineEdit::textChanged, this, [this](const QString& text) {
        m_tree.setFilter(text);
        showCount();
    });
    return head;
}

void StructureList::showCount()
{
    m_count->setVisible(!m_filter->text().isEmpty());
    m_count->setText(tr("%1 of %2").arg(m_tree.listedCount()).arg(m_model.listedCount()));
}

void StructureList::showHidden()
{
    const auto count = static_cast<int>(m_model.scene().hiddenTargets());
    m_hidden->setVisible(count > 0);
    m_hidden->setText(tr("%n hidden target(s)", nullptr, count));
}

int StructureList::currentRow() const
{
    const int row = m_tree.rowOf(m_view->currentIndex());
    if (row >= 0) {
        return row;
    }
    const std::vector<int> rows = selectedRows();
    return rows.empty() ? -1 : rows.front();
}

std::vector<int> StructureList::selectedRows() const
{
    std::vector<int> rows;
    for (const QModelIndex& index : m_view->selectionModel()->selectedRows(StructureModel::Name)) {
        const std::vector<int> some = m_tree.rowsOf(index);
        rows.insert(rows.end(), some.begin(), some.end());
    }
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
}

void StructureList::select(int row, bool adds)
{
    if (row < 0 || row >= m_model.rowCount()) {
        return;
    }
    if (!m_tree.indexOf(row).isValid()) {
        m_filter->clear();
    }
    const QModelIndex index = m_tree.indexOf(row);
    using Selection = QItemSelectionModel;
    m_view->selectionModel()->setCurrentIndex(index,
                                              (adds ? Selection::Toggle : Selection::ClearAndSelect) | Selection::Rows);
    m_view->scrollTo(index);
}

void StructureList::clearSelection()
{
    m_kept.clear();
    m_view->selectionModel()->clear();
}

void StructureList::focusFilter()
{
    m_filter->setFocus(Qt::ShortcutFocusReason);
    m_filter->selectAll();
}

void StructureList::keepSelection()
{
    m_isRearranging = true;
    const std::vector<int> rows = selectedRows();
    if (!rows.empty()) { // keeps the selection of filtered-out rows for their reappearance
        m_kept = rows;
        m_keptCurrent = currentRow();
    }
}

void StructureList::bringSelectionBack()
{
    m_view->setRootIsDecorated(m_tree.grouping() != StructureTree::Grouping::None);
    m_view->setIndentation(m_tree.grouping() == StructureTree::Grouping::None ? 0 : 12);
    for (int group = 0; group < m_tree.rowCount(); ++group) {
        const QModelIndex index = m_tree.index(group, 0);
        m_view->setExpanded(index, !m_closed.contains(titleOf(index)));
    }
    QItemSelection selection;
    for (const int row : m_kept) {
        const QModelIndex index = row < m_model.rowCount() ? m_tree.indexOf(row) : QModelIndex();
        if (index.isValid()) {
            selection.select(index.siblingAtColumn(0), index.siblingAtColumn(StructureModel::ColumnCount - 1));
        }
    }
    m_view->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
    if (m_keptCurrent >= 0 && m_keptCurrent < m_model.rowCount()) {
        if (const QModelIndex index = m_tree.indexOf(m_keptCurrent); index.isValid()) {
            m_view->selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
        }
    }
    m_isRearranging = false;
    showCount();
    Q_EMIT selectionChanged();
}

bool StructureList::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_filter && (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride)) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Escape || key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Down) {
            if (event->type() == QEvent::ShortcutOverride) {
                event->accept(); // otherwise the key triggers a shortcut of the window
                return true;
            }
            if (key == Qt::Key_Escape) {
                m_filter->clear();
            } else if (m_tree.rowOf(m_view->currentIndex()) < 0 && m_tree.rowCount() > 0) {
                const QModelIndex first = m_tree.index(0, StructureModel::Name);
                m_view->setCurrentIndex(
                    m_tree.rowOf(first) >= 0 ? first : m_tree.index(0, StructureModel::Name, first.siblingAtColumn(0)));
            }
            m_view->setFocus();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace palpate::ui

#include "moc_StructureList.cpp"
