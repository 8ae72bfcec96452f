// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/FeltPanel.h"

#include "palpate/ui/FeltWords.h"
#include "palpate/ui/OwnThreshold.h"
#include "palpate/ui/Translated.h"

#include "widgets/ShownComboBox.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cstdlib>

namespace palpate::ui {

namespace {

constexpr double kUsualOrgan_kPa = 6.9; // healthy liver: 3 times the shear modulus of 2.3 kPa (PMC2894569)
constexpr double kLeastRatio = 0.001, kLeast_kPa = 0.01, kMost_kPa = 1e6;

/// Item roles with the full text and a short text for narrow tables, which contains only the verdict's symbol.
constexpr int kFullText = Qt::UserRole, kBriefText = Qt::UserRole + 1;

QString verdictWords(buried::Verdict verdict)
{
    return verdictSign(verdict) + QLatin1Char(' ') + verdictText(verdict);
}

/// Verdicts for the ends of the ratio's range, when different: " (○ … ●)".
QString ends(const buried::FeltSurface::LumpPress& press)
{
    return press.verdictAtLow == press.verdict && press.verdictAtHigh == press.verdict
               ? QString()
               : QStringLiteral(" (%1 … %2)").arg(verdictSign(press.verdictAtLow), verdictSign(press.verdictAtHigh));
}

/// Tool tip of a cell: bounds of the change, and the verdict with the underlying ratios.
QString tipText(const buried::FeltSurface::LumpPress& press, const buried::FeltSurface::Lump& lump)
{
    const QString own = press.best ? ownVerdictText(press.felt.estimate) : QString();
    const QString verdict = verdictRangeText(press, lump.ratio) + (own.isEmpty() ? own : QLatin1Char('\n') + own);
    return press.best ? FeltPanel::tr("between %1 and %2")
                                .arg(responseChangeText(press.felt.low), responseChangeText(press.felt.high)) +
                            QLatin1Char('\n') + verdict
                      : verdict;
}

QString cellText(const buried::FeltSurface::LumpPress& press)
{
    const QString own = press.best ? ownVerdictText(press.felt.estimate) : QString();
    const QString verdict = verdictWords(press.verdict) + (own.isEmpty() ? own : QStringLiteral(", ") + own);
    return (press.best ? responseChangeText(press.felt.estimate) + QLatin1Char('\n') + verdict : verdict) + ends(press);
}

QString briefText(const buried::FeltSurface::LumpPress& press)
{
    const QString sign = verdictSign(press.verdict);
    return (press.best ? responseChangeText(press.felt.estimate) + QStringLiteral("  ") + sign : sign) + ends(press);
}

/// Legend of the verdict symbols.
QString keyOfSigns()
{
    QStringList words;
    for (const buried::Verdict verdict :
         {buried::Verdict::NotByHand, buried::Verdict::ByTrainedHand, buried::Verdict::Plainly,
          buried::Verdict::NotJudged, buried::Verdict::NotKnown}) {
        words << verdictWords(verdict);
    }
    return words.join(QStringLiteral(" · "));
}

/// Breaks a text into two lines at the space closest to the middle.
QString inTwoLines(QString text)
{
    qsizetype best = -1;
    for (qsizetype at = text.indexOf(QLatin1Char(' ')); at >= 0; at = text.indexOf(QLatin1Char(' '), at + 1)) {
        best = best < 0 || std::abs(2 * at - text.size()) < std::abs(2 * best - text.size()) ? at : best;
    }
    return best < 0 ? text : text.replace(best, 1, QLatin1Char('\n'));
}

QDoubleSpinBox* makeSpin(double least, double most, const QString& name, QWidget* parent)
{
    auto* spin = new QDoubleSpinBox(parent);
    spin->setRange(least, most);
    spin->setDecimals(3);
    spin->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    spin->setKeyboardTracking(false); // commits the value when editing is finished
    spin->setAccessibleName(name);
    return spin;
}

} // namespace

FeltPanel::FeltPanel(FeltOverlay& overlay, StructureModel& model, QWidget* parent)
    : QWidget(parent)
    , m_overlay(overlay)
    , m_model(model)
    , m_status(new QLabel(this))
    , m_table(new QTableWidget(this))
{
    m_status->setWordWrap(true);
    m_status->setTextFormat(Qt::PlainText);
    makeTable();
    m_notice = new QLabel(this);
    m_notice->setWordWrap(true);
    auto* left = new QVBoxLayout;
    left->addWidget(m_status);
    left->addWidget(m_table, 1); // at the top, so that a low panel with large text shows a whole row
    left->addWidget(m_notice);
    auto* all = new QHBoxLayout(this);
    all->setContentsMargins(8, 8, 8, 8);
    all->addLayout(left, 1);
    all->addWidget(makeChoices());

    connect(&overlay, &FeltOverlay::changed, this, &FeltPanel::fill);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &FeltPanel::showChosen);
    connect(m_table, &QTableWidget::cellActivated, this, &FeltPanel::showBestPlace); // double click or Enter
    fill();
}

void FeltPanel::makeTable()
{
    QStringList titles{tr("Lump"), tr("Stiffness ratio"), tr("Tissue above")};
    for (const double press_mm : FeltOverlay::kPress_mm) {
        titles << (press_mm > 0.0 ? tr("Pressed %1 mm").arg(numberText(press_mm)) : tr("Touched lightly"));
    }
    m_table->setObjectName(QStringLiteral("feltTable"));
    m_table->setAccessibleName(tr("Lumps and their palpability"));
    m_table->setColumnCount(static_cast<int>(titles.size()));
    for (int column = 0; column < static_cast<int>(titles.size()); ++column) {
        auto* title = new QTableWidgetItem(titles[column]);
        title->setData(kFullText, titles[column]);
        title->setData(kBriefText, column == 1 ? tr("Ratio") : inTwoLines(titles[column]));
        title->setData(Qt::AccessibleTextRole, titles[column]);
        m_table->setHorizontalHeaderItem(column, title);
    }
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->installEventFilter(this);
    fitRows(false);
}

/// Sets the row height to the lines of text, and the least height of the table to two rows.
void FeltPanel::fitRows(bool isBrief)
{
    constexpr int kRows = 2;
    const int row = (isBrief ? 1 : 2) * fontMetrics().height() + 8;
    m_table->verticalHeader()->setDefaultSectionSize(row);
    m_table->setMinimumHeight(m_table->horizontalHeader()->sizeHint().height() + kRows * row +
                              2 * m_table->frameWidth());
}

void FeltPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        fitColumns();
    }
}

/// Watches the table, because its width can change while the panel's width stays: the widgets beside the table grow
/// with the text size.
bool FeltPanel::eventFilter(QObject* watched, QEvent* event)
{
    const bool isTaken = QWidget::eventFilter(watched, event);
    if (watched == m_table && event->type() == QEvent::Resize) {
        fitColumns();
    }
    return isTaken;
}

void FeltPanel::setBrief(bool isBrief)
{
    const int role = isBrief ? kBriefText : kFullText;
    for (int column = 0; column < m_table->columnCount(); ++column) {
        QTableWidgetItem* title = m_table->horizontalHeaderItem(column);
        title->setText(title->data(role).toString());
        for (int row = 0; row < m_table->rowCount(); ++row) {
            QTableWidgetItem* item = m_table->item(row, column);
            item->setText(item->data(role).toString());
        }
    }
    const QString notice = tr("Estimate for research and rehearsal.");
    m_notice->setText(isBrief ? notice + QLatin1Char(' ') + keyOfSigns() : notice);
    fitRows(isBrief);
}

/// Uses full texts if they fit and short texts otherwise, so that no column is cut off at the right.
void FeltPanel::fitColumns()
{
    setBrief(false);
    int wide = 2 * m_table->frameWidth();
    for (int column = 0; column < m_table->columnCount(); ++column) {
        int widest = m_table->horizontalHeader()->sectionSizeHint(column);
        for (int row = 0; row < m_table->rowCount(); ++row) {
            widest = std::max(widest, m_table->sizeHintForIndex(m_table->model()->index(row, column)).width());
        }
        wide += widest;
    }
    setBrief(m_table->rowCount() > 0 && wide > m_table->width());
}

QWidget* FeltPanel::makeChoices()
{
    auto* choices = new QWidget(this);
    auto* column = new QVBoxLayout(choices);
    column->setContentsMargins(0, 0, 0, 0);
    m_press = new QComboBox(choices);
    m_press->setAccessibleName(tr("Press depth of the finger"));
    for (const double press_mm : FeltOverlay::kPress_mm) {
        m_press->addItem(press_mm > 0.0 ? tr("Colours: pressed %1 mm").arg(numberText(press_mm))
                                        : tr("Colours: touched lightly"));
    }
    m_best = new QPushButton(tr("Show the best place"), choices);
    m_ratioLabel = new QLabel(choices);
    m_ratioLabel->setTextFormat(Qt::PlainText);
    m_ratio =
        makeSpin(kLeastRatio, buried::kMaxModulusRatio, tr("Stiffness of the lump relative to the organ"), choices);
    m_source = new ShownComboBox(choices);
    m_source->setAccessibleName(tr("Source of the stiffness ratio"));
    m_source->addItems({tr("As typed"), tr("From the two Young's moduli"), tr("From tissues or names")});
    for (const study::PublishedRatio& one : study::publishedRatios()) {
        m_source->addItem(tr("Published: %1, %2").arg(publishedName(one), ratioRangeText(one.ratio)));
        m_source->setItemData(m_source->count() - 1, QString::fromUtf8(one.ratio.citation.data()), Qt::ToolTipRole);
    }
    m_moduli = new QWidget(choices);
    auto* moduli = new QHBoxLayout(m_moduli);
    moduli->setContentsMargins(0, 0, 0, 0);
    m_lump_kPa = makeSpin(kLeast_kPa, kMost_kPa, tr("Young's modulus of the lump [kPa]"), m_moduli);
    m_organ_kPa = makeSpin(kLeast_kPa, kMost_kPa, tr("Young's modulus of the organ [kPa]"), m_moduli);
    m_organ_kPa->setSuffix(tr(" kPa"));
    moduli->addWidget(m_lump_kPa, 1);
    moduli->addWidget(new QLabel(tr("to"), m_moduli));
    moduli->addWidget(m_organ_kPa, 1);
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_press, m_best, m_ratioLabel, m_ratio, m_source, m_moduli}) {
        column->addWidget(widget);
    }
    column->addStretch(1);
    connect(m_press, qOverload<int>(&QComboBox::currentIndexChanged), this,
            [this](int index) { m_overlay.setPress(static_cast<std::size_t>(index)); });
    connect(m_best, &QPushButton::clicked, this, &FeltPanel::showBestPlace);
    connect(m_ratio, &QDoubleSpinBox::valueChanged, this, [this](double ratio) { setRatio(ratio); });
    connect(m_source, &QComboBox::activated, this, &FeltPanel::chooseSource);
    for (QDoubleSpinBox* spin : {m_lump_kPa, m_organ_kPa}) {
        connect(spin, &QDoubleSpinBox::valueChanged, this,
                [this] { setModuli(m_lump_kPa->value(), m_organ_kPa->value()); });
    }
    return choices;
}

void FeltPanel::fill()
{
    const bool isBusy = !m_overlay.isUpToDate();
    const QString notes = m_overlay.notes().join(QLatin1Char('\n'));
    m_status->setText(isBusy && m_overlay.isBusy() ? tr("Computing…") : notes);
    m_status->setVisible(!m_status->text().isEmpty());
    m_table->setEnabled(!isBusy); // current results are outdated
    if (!isBusy || m_overlay.organs().empty()) {
        const std::optional<Row> before = chosen();
        const QSignalBlocker blocker(m_table);
        m_table->setRowCount(0);
        m_rows.clear();
        for (std::size_t i = 0; i < m_overlay.organs().size(); ++i) {
            const study::OrganPalpability& organ = m_overlay.organs()[i]->organ;
            for (std::size_t k = 0; k < organ.felt.lumps.size(); ++k) {
                const std::size_t lump = organ.organ.lumps[organ.felt.lumps[k].given].structure;
                addRow({i, k, static_cast<int>(lump), static_cast<int>(organ.organ.organ)});
            }
        }
        const auto same = std::find_if(m_rows.begin(), m_rows.end(),
                                       [&](const Row& row) { return before && row.lumpRow == before->lumpRow; });
        if (!m_rows.empty()) {
            m_table->selectRow(same == m_rows.end() ? 0 : static_cast<int>(same - m_rows.begin()));
        }
    }
    fitColumns();
    const QSignalBlocker blocker(m_press);
    m_press->setCurrentIndex(static_cast<int>(m_overlay.press()));
    showChosen();
}

void FeltPanel::addRow(const Row& row)
{
    const study::OrganPalpability& organ = m_overlay.organs()[row.organ]->organ;
    const buried::FeltSurface::Lump& lump = organ.felt.lumps[row.lump];
    const QString in = readableName(m_model.structure(row.organRow).name);
    const QString cover =
        lump.minCover_mm > 0.0 ? tr("%1 mm").arg(QLocale().toString(lump.minCover_mm, 'f', 1)) : tr("exposed");
    const std::optional<study::StiffnessRatio>& ratio = organ.organ.lumps[lump.given].ratio;
    const QString source = ratio ? ratioSourceText(ratio->source) : tr("enter a ratio or choose a published one");
    QStringList cells{readableName(lump.name) + QLatin1Char('\n') + tr("in %1").arg(in),
                      ratioRangeText(ratio) + QLatin1Char('\n') + source, cover};
    QStringList brief{readableName(lump.name), ratioRangeText(ratio), cover};
    QStringList tips{cells[0],
                     ratio && !ratio->citation.empty()
                         ? source + QLatin1Char('\n') + QString::fromUtf8(ratio->citation.data())
                         : source,
                     QString()};
    for (const buried::FeltSurface::LumpPress& press : lump.press) {
        cells << cellText(press);
        brief << briefText(press);
        tips << tipText(press, lump);
    }
    const int at = m_table->rowCount();
    m_table->insertRow(at);
    for (int column = 0; column < static_cast<int>(cells.size()); ++column) {
        auto* item = new QTableWidgetItem(cells[column]);
        item->setData(kFullText, cells[column]);
        item->setData(kBriefText, brief[column]);
        item->setData(Qt::AccessibleTextRole, cells[column]);
        item->setToolTip(tips[column]);
        m_table->setItem(at, column, item);
    }
    m_rows.push_back(row);
}

std::optional<FeltPanel::Row> FeltPanel::chosen() const
{
    const QList<QTableWidgetItem*> items = m_table->selectedItems();
    const int at = items.isEmpty() ? -1 : items.front()->row();
    return at >= 0 && at < static_cast<int>(m_rows.size()) ? std::optional(m_rows[static_cast<std::size_t>(at)])
                                                           : std::nullopt;
}

/// Shows the stiffness ratio of the selected lump and its source.
void FeltPanel::showChosen()
{
    const std::optional<Row> row = chosen();
    for (QWidget* widget : std::initializer_list<QWidget*>{m_ratio, m_source, m_moduli}) {
        widget->setEnabled(row.has_value());
    }
    m_best->setEnabled(row.has_value() && m_overlay.isUpToDate());
    m_moduli->setVisible(false);
    if (!row || row->lumpRow >= m_model.rowCount() || row->organRow >= m_model.rowCount()) {
        m_ratioLabel->setText(tr("Stiffness ratio to the organ:"));
        return;
    }
    const meshio::SceneStructure &lump = m_model.structure(row->lumpRow), &organ = m_model.structure(row->organRow);
    m_ratioLabel->setText(tr("%1, stiffness ratio to %2:").arg(readableName(lump.name), readableName(organ.name)));
    const QSignalBlocker ratio(m_ratio), ofLump(m_lump_kPa), ofOrgan(m_organ_kPa);
    int source = Automatic;
    if (lump.young_ratio) {
        source = Typed;
        m_ratio->setValue(*lump.young_ratio);
    } else if (lump.young_kPa && organ.young_kPa) {
        source = Moduli;
        m_lump_kPa->setValue(*lump.young_kPa);
        m_organ_kPa->setValue(*organ.young_kPa);
        m_ratio->setValue(*lump.young_kPa / *organ.young_kPa);
    } else if (row->organ < m_overlay.organs().size() && m_overlay.isUpToDate()) {
        const auto& known = m_overlay.organs()[row->organ]->organ.felt.lumps[row->lump].ratio;
        m_ratio->setValue(known ? known->typical : 1.0);
    }
    m_source->setCurrentIndex(source);
    m_moduli->setVisible(source == Moduli);
}

/// Sets the ratio of the selected lump. @param ratio  empty: derived from tissues or names
void FeltPanel::setRatio(std::optional<double> ratio)
{
    const std::optional<Row> row = chosen();
    if (!row) {
        return;
    }
    meshio::SceneStructure lump = m_model.structure(row->lumpRow);
    lump.young_ratio = ratio;
    if (!ratio) {
        lump.young_kPa.reset();
    }
    m_model.editAll({{row->lumpRow, lump}}, tr("Stiffness of %1").arg(readableName(lump.name)));
    showChosen();
}

void FeltPanel::setModuli(double lump_kPa, double organ_kPa)
{
    const std::optional<Row> row = chosen();
    if (!row) {
        return;
    }
    meshio::SceneStructure lump = m_model.structure(row->lumpRow), organ = m_model.structure(row->organRow);
    lump.young_ratio.reset();
    lump.young_kPa = lump_kPa;
    organ.young_kPa = organ_kPa;
    m_model.editAll({{row->lumpRow, lump}, {row->organRow, organ}}, tr("Stiffness of %1").arg(readableName(lump.name)));
    showChosen();
}

void FeltPanel::chooseSource(int index)
{
    const std::optional<Row> row = chosen();
    if (!row) {
        return;
    }
    if (index >= FirstPublished) {
        setRatio(study::publishedRatios()[static_cast<std::size_t>(index - FirstPublished)].ratio.typical);
    } else if (index == Typed) {
        setRatio(m_ratio->value());
        m_ratio->setFocus();
    } else if (index == Automatic) {
        setRatio(std::nullopt);
    } else {
        const double organ_kPa = m_model.structure(row->organRow).young_kPa.value_or(kUsualOrgan_kPa);
        setModuli(m_model.structure(row->lumpRow).young_kPa.value_or(m_ratio->value() * organ_kPa), organ_kPa);
    }
}

void FeltPanel::showBestPlace()
{
    const std::optional<Row> row = chosen();
    if (row && m_overlay.isUpToDate() && !m_overlay.showBestPlace(row->organ, row->lump)) {
        m_status->setText(tr("No place above this lump can be judged."));
        m_status->show();
    }
}

} // namespace palpate::ui

#include "palpate/ui/moc_FeltPanel.cpp"
