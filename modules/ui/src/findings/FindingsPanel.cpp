// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/FindingsPanel.h"

#include "palpate/ui/ClipboardCell.h"

#include <QAbstractItemDelegate>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QKeySequence>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace palpate::ui {

namespace {

/// Combo box editor for the type column.
class TypeDelegate final : public QStyledItemDelegate
{
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                          const QModelIndex& /*index*/) const override
    {
        auto* box = new QComboBox(parent);
        for (std::size_t i = 0; i < core::kFindingTypeNames.size(); ++i) {
            const auto type = static_cast<core::FindingType>(i);
            box->addItem(typeSign(type) + QLatin1Char(' ') + typeName(type));
        }
        QTimer::singleShot(0, box, &QComboBox::showPopup);
        auto* self = const_cast<TypeDelegate*>(this); // the interface is const, its signals are not
        connect(box, &QComboBox::activated, self, [self, box] {
            Q_EMIT self->commitData(box);
            Q_EMIT self->closeEditor(box);
        });
        return box;
    }
    void setEditorData(QWidget* editor, const QModelIndex& index) const override
    {
        qobject_cast<QComboBox*>(editor)->setCurrentIndex(index.data(Qt::EditRole).toInt());
    }
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override
    {
        model->setData(index, qobject_cast<QComboBox*>(editor)->currentIndex(), Qt::EditRole);
    }
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& /*index*/) const override
    {
        QRect place = option.rect;
        place.setWidth(std::max(place.width(), editor->sizeHint().width()));
        editor->setGeometry(place);
    }
};

} // namespace

FindingsPanel::FindingsPanel(FindingsModel& model, QWidget* parent)
    : QWidget(parent)
    , m_model(model)
    , m_table(new QTableView(this))
    , m_note(new QLineEdit(this))
    , m_empty(new QLabel(this))
{
    m_table->setModel(&model);
    m_table->setObjectName(QStringLiteral("findingsTable"));
    m_table->setAccessibleName(tr("Findings and notes"));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    // A double click moves the camera; F2 is handled below.
    m_table->setEditTriggers(QAbstractItemView::SelectedClicked);
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(false);
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 10);
    m_table->setItemDelegateForColumn(FindingsModel::Type, new TypeDelegate(m_table));
    m_table->installEventFilter(this);
    const int letter = fontMetrics().horizontalAdvance(QLatin1Char('n'));
    constexpr std::array<int, FindingsModel::ColumnCount> kLetters{4, 13, 14, 13, 6, 6, 6, 30};
    for (int column = 0; column < FindingsModel::ColumnCount; ++column) {
        m_table->setColumnWidth(column, letter * kLetters[static_cast<std::size_t>(column)]);
    }
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);

    m_empty->setText(tr("No findings yet. Press on a place, then click Mark or press M."));
    m_empty->setWordWrap(true);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_note->setPlaceholderText(tr("Write a note (N), Enter saves"));
    m_note->setAccessibleName(tr("New note without a place"));
    m_note->setMaxLength(4000);
    m_note->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(m_empty);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_note);

    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) { Q_EMIT selected(now.isValid() ? now.row() : -1); });
    connect(m_table, &QWidget::customContextMenuRequested, this, &FindingsPanel::openMenu);
    connect(m_table, &QTableView::doubleClicked, this,
            [this](const QModelIndex& index) { Q_EMIT flightWanted(index.row()); });
    for (QAbstractItemDelegate* delegate :
         {m_table->itemDelegate(), m_table->itemDelegateForColumn(FindingsModel::Type)}) {
        connect(delegate, &QAbstractItemDelegate::closeEditor, this, &FindingsPanel::giveFocusBack,
                Qt::QueuedConnection);
    }
    connect(m_note, &QLineEdit::returnPressed, this, [this] {
        const QString text = m_note->text().trimmed();
        m_note->clear();
        giveFocusBack();
        if (!text.isEmpty()) {
            Q_EMIT noteWritten(text);
        }
    });
    connect(&model, &FindingsModel::changed, this, &FindingsPanel::showEmpty);
    showEmpty();
}

void FindingsPanel::showEmpty()
{
    m_empty->setVisible(m_model.rowCount() == 0);
}

int FindingsPanel::current() const
{
    const QModelIndex index = m_table->currentIndex();
    return index.isValid() ? index.row() : -1;
}

void FindingsPanel::select(int row)
{
    const QModelIndex old = m_table->currentIndex();
    const QModelIndex index = m_model.index(row, old.isValid() ? old.column() : int(FindingsModel::Name));
    m_table->setCurrentIndex(index);
    m_table->scrollTo(index);
    m_table->horizontalScrollBar()->setValue(0); // number, type and name first
}

/// Opens the menu of the row at a place.
void FindingsPanel::openMenu(const QPoint& place)
{
    const QModelIndex at = m_table->indexAt(place);
    if (!at.isValid()) {
        return;
    }
    const int row = at.row();
    const core::Finding& finding = m_model.findings()[static_cast<std::size_t>(row)];
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Go there"), this, [this, row] { Q_EMIT flightWanted(row); });
    menu->addAction(tr("Play from here"), this, [this, row] { Q_EMIT playWanted(row); })
        ->setEnabled(finding.recording.has_value());
    menu->addSeparator();
    if (finding.hasPlace) {
        QMenu* types = menu->addMenu(tr("Type"));
        for (std::size_t i = 0; i < core::kFindingTypeNames.size(); ++i) {
            const auto type = static_cast<core::FindingType>(i);
            QAction* one = types->addAction(typeSign(type) + QLatin1Char(' ') + typeName(type), this, [this, row, i] {
                m_model.setData(m_model.index(row, FindingsModel::Type), static_cast<int>(i), Qt::EditRole);
            });
            one->setCheckable(true);
            one->setChecked(type == finding.type);
        }
    }
    menu->addAction(tr("Rename"), this, [this, row] { editCell(row, FindingsModel::Name); });
    if (finding.hasPlace) {
        menu->addAction(tr("Enter the size"), this, [this, row] { editCell(row, FindingsModel::Size); });
    }
    menu->addAction(tr("Write a note"), this, [this, row] { editNote(row); });
    menu->addSeparator();
    menu->addAction(tr("Delete"), this, [this] { m_model.remove(chosenRows()); });
    menu->popup(m_table->viewport()->mapToGlobal(place));
}

void FindingsPanel::editCell(int row, int column)
{
    const QModelIndex index = m_model.index(row, column);
    m_table->setCurrentIndex(index);
    m_table->scrollTo(index);
    m_table->edit(index);
}

void FindingsPanel::rememberFocus()
{
    m_before = window()->focusWidget();
}

void FindingsPanel::giveFocusBack()
{
    m_table->horizontalScrollBar()->setValue(0); // an edited note is at the right
    if (m_before != nullptr) {
        m_before->setFocus();
        m_before = nullptr;
    }
}

void FindingsPanel::editNote(int row)
{
    rememberFocus();
    editCell(row, FindingsModel::Note);
}

void FindingsPanel::startNote()
{
    if (!m_note->hasFocus()) {
        rememberFocus();
    }
    m_note->setFocus(Qt::ShortcutFocusReason);
}

std::vector<int> FindingsPanel::chosenRows() const
{
    std::vector<int> rows;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows()) {
        rows.push_back(index.row());
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

QString FindingsPanel::copiedText() const
{
    QStringList lines;
    for (const int row : chosenRows()) {
        QStringList cells;
        for (int column = 0; column < FindingsModel::ColumnCount; ++column) {
            cells << clipboardCell(m_model.index(row, column).data().toString());
        }
        lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n'));
}

/// Handles the table's own keys. Returns false for other keys.
bool FindingsPanel::handleKey(int key, Qt::KeyboardModifiers modifiers)
{
    const int row = current();
    const bool isPlain = (modifiers & ~Qt::KeypadModifier) == Qt::NoModifier;
    if (key == Qt::Key_C && modifiers == Qt::ControlModifier) {
        QApplication::clipboard()->setText(copiedText());
    } else if (row < 0) {
        return false;
    } else if ((key == Qt::Key_Return || key == Qt::Key_Enter) && isPlain) {
        Q_EMIT flightWanted(row);
    } else if ((key == Qt::Key_Return || key == Qt::Key_Enter) && modifiers.testFlag(Qt::ShiftModifier)) {
        Q_EMIT playWanted(row);
    } else if (key == Qt::Key_Delete && isPlain) {
        m_model.remove(chosenRows());
    } else if (key == Qt::Key_F2 && isPlain) {
        const QModelIndex index = m_table->currentIndex();
        const bool isEditable = m_model.flags(index).testFlag(Qt::ItemIsEditable);
        m_table->edit(isEditable ? index : m_model.index(row, FindingsModel::Name));
    } else {
        return false;
    }
    return true;
}

bool FindingsPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride) {
        return QWidget::eventFilter(watched, event);
    }
    auto* key = static_cast<QKeyEvent*>(event);
    if (watched == m_note) {
        const bool leaves = key->key() == Qt::Key_Escape;
        if (leaves && event->type() == QEvent::KeyPress) {
            giveFocusBack(); // keeps the entered text
        } else if (leaves) {
            event->accept();
        }
        return leaves && event->type() == QEvent::KeyPress;
    }
    const bool isOwn = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter || key->key() == Qt::Key_Delete ||
                       key->key() == Qt::Key_F2 || key->matches(QKeySequence::Copy);
    if (event->type() == QEvent::ShortcutOverride) {
        if (isOwn) { // takes precedence over shortcuts of the window
            event->accept();
        }
        return isOwn;
    }
    return isOwn && handleKey(key->key(), key->modifiers());
}

} // namespace palpate::ui

#include "palpate/ui/moc_FindingsPanel.cpp"
