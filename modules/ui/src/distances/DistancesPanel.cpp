// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/DistancesPanel.h"

#include "palpate/ui/Translated.h"

#include "widgets/ShownComboBox.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QModelIndexList>
#include <QPushButton>
#include <QRegularExpression>
#include <QShortcut>
#include <QSignalBlocker>
#include <QTableView>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace palpate::ui {

namespace {

QString distanceText(const geometry::SurfaceDistance& found)
{
    switch (found.relation) {
    case geometry::Relation::Crossing:
        return DistancesPanel::tr("0, they cross");
    case geometry::Relation::Inside:
        return DistancesPanel::tr("inside, %1 below").arg(lengthText(found.surface_mm));
    case geometry::Relation::Around:
        return DistancesPanel::tr("around, %1").arg(lengthText(found.surface_mm));
    case geometry::Relation::Apart:
        break;
    }
    return lengthText(found.surface_mm);
}

QString limitsText(const std::vector<double>& limits_mm)
{
    QStringList texts;
    for (const double limit_mm : limits_mm) {
        texts << numberText(limit_mm, 6);
    }
    return texts.join(QStringLiteral("; "));
}

QString shareText(double share)
{
    return DistancesPanel::tr("%1 %").arg(QLocale().toString(100.0 * share, 'f', 1));
}

void setUp(QTableView& table, const QString& name)
{
    table.setAccessibleName(name);
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.setTabKeyNavigation(false);
    table.setShowGrid(false);
    table.setAlternatingRowColors(true);
    table.verticalHeader()->hide();
    table.verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table.setMinimumHeight(4 * table.fontMetrics().height());
    table.horizontalHeader()->setHighlightSections(false);
    table.horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table.horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
}

QString unselectedText()
{
    return DistancesPanel::tr("Select a row to see its closest points.");
}

} // namespace

DistancesPanel::DistancesPanel(SceneDistances& distances, MarginOverlay& overlay, TapesModel& tapes,
                               const StructureModel& model, QWidget* parent)
    : QWidget(parent)
    , m_distances(distances)
    , m_overlay(overlay)
    , m_tapes(tapes)
    , m_model(model)
{
    auto* left = new QVBoxLayout;
    left->addWidget(makeTop());
    makeTable();
    left->addWidget(m_table, 1);
    m_detail = new QLabel(unselectedText(), this);
    m_detail->setObjectName(QStringLiteral("distanceDetail"));
    m_detail->setMinimumWidth(1); // the tool tip of the row has the whole text
    m_detail->setTextFormat(Qt::PlainText);
    m_detail->setTextInteractionFlags(Qt::TextSelectableByMouse);
    left->addWidget(m_detail);
    auto* all = new QHBoxLayout(this);
    all->setContentsMargins(8, 4, 8, 4);
    all->addLayout(left, 3);
    all->addWidget(makeTapes(), 1);
    connect(&distances, &SceneDistances::changed, this, &DistancesPanel::fill);
    connect(&distances, &SceneDistances::outdated, this, [this] {
        m_rows.clear();
        m_table->setRowCount(0);
        m_detail->setText(unselectedText());
        fillChoice();
    });
    fill();
}

QWidget* DistancesPanel::makeTop()
{
    auto* top = new QWidget(this);
    auto* line = new QHBoxLayout(top);
    line->setContentsMargins(0, 0, 0, 0);
    m_from = new ShownComboBox(top);
    m_from->setAccessibleName(tr("Measure from"));
    m_bands = new QLineEdit(limitsText(m_distances.limits_mm()), top);
    m_bands->setObjectName(QStringLiteral("bands"));
    m_bands->setAccessibleName(tr("Borders of the bands in millimetres"));
    m_bands->setToolTip(tr("Borders of the bands of the margin [mm], at most four, such as 5; 10"));
    m_bands->setMaximumWidth(12 * fontMetrics().averageCharWidth() + 16);
    m_status = new QLabel(top);
    m_status->setTextFormat(Qt::PlainText);
    m_status->setMinimumWidth(1);
    line->addWidget(new QLabel(tr("From"), top));
    line->addWidget(m_from);
    line->addSpacing(8);
    line->addWidget(new QLabel(tr("Bands [mm]"), top));
    line->addWidget(m_bands);
    line->addWidget(m_status, 1);
    connect(m_from, &QComboBox::activated, this, [this](int chosen) {
        const QVariant row = m_from->itemData(chosen);
        m_distances.setFrom(row.isValid() ? std::optional(row.toInt()) : std::nullopt);
    });
    connect(m_bands, &QLineEdit::editingFinished, this, &DistancesPanel::takeLimits);
    return top;
}

void DistancesPanel::makeTable()
{
    m_table = new QTableWidget(this);
    m_table->setObjectName(QStringLiteral("distanceTable"));
    setUp(*m_table, tr("Distances between structures"));
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->horizontalHeader()->setStretchLastSection(true);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &DistancesPanel::showChosen);
    connect(m_table, &QTableWidget::cellActivated, &m_overlay, &MarginOverlay::flyToPair); // double click or Enter
    auto* copies = new QShortcut(QKeySequence::Copy, m_table, this, &DistancesPanel::copy);
    copies->setContext(Qt::WidgetShortcut);
}

QWidget* DistancesPanel::makeTapes()
{
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(8, 0, 0, 0);
    m_tapeTable = new QTableView(box);
    m_tapeTable->setObjectName(QStringLiteral("tapes"));
    m_tapeTable->setModel(&m_tapes);
    setUp(*m_tapeTable, tr("Tapes"));
    m_tapeTable->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_tapeTable->horizontalHeader()->setStretchLastSection(true);
    auto* gone = new QPushButton(tr("Delete"), box);
    gone->setToolTip(tr("Delete the selected tapes (Del)"));
    auto* line = new QHBoxLayout;
    auto* hint = new QLabel(tr("T: tape between two places"), box);
    hint->setForegroundRole(QPalette::PlaceholderText);
    line->addWidget(hint, 1);
    line->addWidget(gone);
    column->addLayout(line);
    column->addWidget(m_tapeTable, 1);
    const auto selected = [this] {
        std::vector<int> rows;
        for (const QModelIndex& index : m_tapeTable->selectionModel()->selectedRows()) {
            rows.push_back(index.row());
        }
        return rows;
    };
    const auto remove = [this, selected] { m_tapes.remove(selected()); };
    connect(gone, &QPushButton::clicked, this, remove);
    auto* key = new QShortcut(QKeySequence(Qt::Key_Delete), m_tapeTable, this, remove);
    key->setContext(Qt::WidgetShortcut);
    const auto show = [this, selected, gone] {
        const std::vector<int> rows = selected();
        gone->setEnabled(!rows.empty());
        m_overlay.chooseTape(rows.empty() ? -1 : rows.back());
    };
    connect(m_tapeTable->selectionModel(), &QItemSelectionModel::selectionChanged, this, show);
    connect(&m_tapes, &QAbstractItemModel::modelReset, this, show);
    connect(m_tapeTable, &QTableView::activated, &m_overlay, &MarginOverlay::flyToTape);
    gone->setEnabled(false);
    return box;
}

std::optional<std::vector<double>> DistancesPanel::limitsFrom(const QString& text)
{
    const QLocale locale;
    static const QRegularExpression withCommas(QStringLiteral("[;,\\s]+")), without(QStringLiteral("[;\\s]+"));
    const bool isDecimal = locale.decimalPoint() == QLatin1String(",");
    std::vector<double> limits_mm;
    for (const QString& part : text.trimmed().split(isDecimal ? without : withCommas, Qt::SkipEmptyParts)) {
        bool isNumber = false;
        const double limit_mm = locale.toDouble(part, &isNumber);
        constexpr double kMost_mm = 10000.0;
        if (!isNumber || !(limit_mm > (limits_mm.empty() ? 0.0 : limits_mm.back())) || limit_mm > kMost_mm) {
            return std::nullopt;
        }
        limits_mm.push_back(limit_mm);
    }
    return limits_mm.empty() || limits_mm.size() > kMostLimits ? std::nullopt : std::optional(limits_mm);
}

void DistancesPanel::takeLimits()
{
    if (const auto limits_mm = limitsFrom(m_bands->text())) {
        m_distances.setLimits(*limits_mm);
        m_bands->setText(limitsText(*limits_mm));
    } else {
        m_status->setText(tr("Bands: found “%1”, expected at most four ascending distances in mm, such as 5; 10.")
                              .arg(m_bands->text()));
    }
}

void DistancesPanel::fillChoice()
{
    const QSignalBlocker blocker(m_from);
    m_from->clear();
    m_from->addItem(tr("lumps"));
    for (int row = 0; row < m_model.rowCount(); ++row) {
        if (m_model.isListed(row) && m_model.rows()[static_cast<std::size_t>(row)].isThere()) {
            m_from->addItem(readableName(m_model.structure(row).name), row);
        }
    }
    const std::optional<int> from = m_distances.from();
    m_from->setCurrentIndex(from ? std::max(0, m_from->findData(*from)) : 0);
    m_status->setText(m_distances.isBusy()        ? tr("Measuring…")
                      : m_distances.needsChoice() ? tr("No lump here: choose the structure to measure from.")
                                                  : QString());
}

void DistancesPanel::fill()
{
    fillChoice();
    const QSignalBlocker blocker(m_table);
    m_table->setRowCount(0);
    m_rows.clear();
    const study::DistanceTable& table = m_distances.table();
    QStringList titles{tr("From"), tr("To"), tr("Distance")};
    if (!table.margins.empty()) {
        for (const core::Message& clause : study::bandNames(table.limits_mm)) {
            titles << translated(clause);
        }
    }
    m_table->setColumnCount(static_cast<int>(titles.size()));
    m_table->setHorizontalHeaderLabels(titles);
    if (m_distances.isUpToDate()) {
        std::vector<std::size_t> pairs(table.pairs.size());
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            pairs[i] = i;
        }
        std::stable_sort(pairs.begin(), pairs.end(), [&table](std::size_t a, std::size_t b) {
            const study::PairDistance &one = table.pairs[a], &other = table.pairs[b];
            return one.first != other.first ? one.first < other.first : one.found.surface_mm < other.found.surface_mm;
        });
        m_table->setRowCount(static_cast<int>(pairs.size()));
        for (const std::size_t pair : pairs) {
            addRow(pair);
        }
        if (!m_rows.empty()) {
            m_table->selectRow(0);
        }
    }
    showChosen();
}

void DistancesPanel::addRow(std::size_t pair)
{
    const study::DistanceTable& table = m_distances.table();
    const study::PairDistance& of = table.pairs[pair];
    QStringList cells{QString::fromStdString(table.sizes[of.first].name),
                      QString::fromStdString(table.sizes[of.second].name), distanceText(of.found)};
    if (const study::LumpMargin* margin = m_overlay.marginOf(pair)) {
        for (const double share : margin->found.shares) {
            cells << shareText(share);
        }
    }
    const auto row = static_cast<int>(m_rows.size());
    const QString tip = textOf(pair);
    for (int column = 0; column < static_cast<int>(cells.size()); ++column) {
        auto* item = new QTableWidgetItem(cells[column]);
        item->setToolTip(tip);
        m_table->setItem(row, column, item);
    }
    m_rows.push_back(pair);
}

std::optional<std::size_t> DistancesPanel::chosen() const
{
    const QModelIndexList selected = m_table->selectionModel()->selectedRows();
    const int row = selected.isEmpty() ? -1 : selected.front().row();
    return row >= 0 && row < static_cast<int>(m_rows.size()) ? std::optional(m_rows[static_cast<std::size_t>(row)])
                                                             : std::nullopt;
}

/// The sentences of the command line on a pair.
QString DistancesPanel::textOf(std::size_t pair) const
{
    const study::DistanceTable& table = m_distances.table();
    QString text = translated(study::sentence(table, table.pairs[pair]));
    if (const study::LumpMargin* margin = m_overlay.marginOf(pair)) {
        QStringList bands;
        for (const core::Message& clause : study::clauses(table, *margin)) {
            bands << translated(clause);
        }
        text += QLatin1Char('\n') + tr("%1 of its area").arg(bands.join(QStringLiteral(", ")));
    }
    return text;
}

void DistancesPanel::showChosen()
{
    const std::optional<std::size_t> pair = chosen();
    m_detail->setText(pair ? textOf(*pair) : unselectedText());
    m_overlay.choose(pair);
}

/// Copies the table for a spreadsheet.
void DistancesPanel::copy() const
{
    QStringList lines;
    for (int row = -1; row < m_table->rowCount(); ++row) {
        QStringList cells;
        for (int column = 0; column < m_table->columnCount(); ++column) {
            const QTableWidgetItem* item = row < 0 ? m_table->horizontalHeaderItem(column) : m_table->item(row, column);
            cells << (item != nullptr ? item->text() : QString());
        }
        lines << cells.join(QLatin1Char('\t'));
    }
    QApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

} // namespace palpate::ui

#include "palpate/ui/moc_DistancesPanel.cpp"
