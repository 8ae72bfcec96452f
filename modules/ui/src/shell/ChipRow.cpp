// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/ChipRow.h"

#include <QEvent>
#include <QMenu>
#include <QToolButton>

#include <algorithm>

namespace palpate::ui {

namespace {

constexpr int kGap_px = 6;

} // namespace

ChipRow::ChipRow(QWidget* parent)
    : QWidget(parent)
    , m_rest(new QToolButton(this))
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_rest->setText(QStringLiteral("»"));
    m_rest->setAutoRaise(true);
    m_rest->setFocusPolicy(Qt::TabFocus);
    m_rest->setAccessibleName(tr("More status"));
    m_rest->setToolTip(tr("Status items that do not fit in this row"));
    m_rest->hide();
    connect(m_rest, &QToolButton::clicked, this, &ChipRow::openRest);
}

Chip* ChipRow::add(const char* id, const QString& name, int weight, bool mustStay)
{
    auto* chip = new Chip(name, this);
    chip->setObjectName(QLatin1String(id));
    m_entries.push_back({chip, weight, mustStay});
    connect(chip, &Chip::changed, this, &ChipRow::fit);
    return chip;
}

int ChipRow::widthOf(const Entry& entry) const
{
    return entry.chip->said().isEmpty() || entry.isFolded ? 0 : entry.chip->widthFor(entry.isShort) + kGap_px;
}

int ChipRow::needed() const
{
    int sum = 0;
    bool isAnyFolded = false;
    for (const Entry& entry : m_entries) {
        sum += widthOf(entry);
        isAnyFolded = isAnyFolded || (entry.isFolded && !entry.chip->said().isEmpty());
    }
    return sum + (isAnyFolded ? m_rest->sizeHint().width() : 0);
}

/// Shortens or folds one chip at a time until the row fits.
void ChipRow::shrink()
{
    std::vector<Entry*> order;
    for (Entry& entry : m_entries) {
        entry.isShort = entry.isFolded = false;
        order.push_back(&entry);
    }
    std::stable_sort(order.begin(), order.end(), [](const Entry* a, const Entry* b) { return a->weight < b->weight; });
    for (Entry* entry : order) {
        if (needed() <= width()) {
            return;
        }
        entry->isShort = true;
    }
    std::stable_partition(order.begin(), order.end(), [](const Entry* entry) { return !entry->warns(); });
    // Chips with a warning fold last.
    for (Entry* entry : order) {
        if (needed() <= width()) {
            return;
        }
        entry->isFolded = !entry->mustStay;
    }
}

void ChipRow::fit()
{
    shrink();
    int x = width();
    bool isAnyFolded = false;
    bool isWarningFolded = false;
    for (const Entry& entry : m_entries) {
        const bool isFolded = entry.isFolded && !entry.chip->said().isEmpty();
        isAnyFolded = isAnyFolded || isFolded;
        isWarningFolded = isWarningFolded || (isFolded && entry.warns());
    }
    m_rest->setText(isWarningFolded ? QStringLiteral("⚠ »") : QStringLiteral("»"));
    m_rest->setVisible(isAnyFolded);
    if (isAnyFolded) {
        const QSize size = m_rest->sizeHint();
        x -= size.width();
        m_rest->setGeometry(x, (height() - size.height()) / 2, size.width(), size.height());
    }
    for (auto entry = m_entries.rbegin(); entry != m_entries.rend(); ++entry) {
        const bool isShown = !entry->chip->said().isEmpty() && !entry->isFolded;
        entry->chip->setShort(entry->isShort);
        entry->chip->setVisible(isShown);
        if (isShown) {
            const QSize size = entry->chip->sizeHint();
            x -= size.width() + kGap_px;
            entry->chip->setGeometry(std::max(0, x), (height() - size.height()) / 2, size.width(), size.height());
        }
    }
    updateGeometry();
}

void ChipRow::openRest()
{
    QMenu menu;
    for (const Entry& entry : m_entries) {
        if (entry.isFolded && !entry.chip->said().isEmpty()) {
            menu.addAction(entry.chip->said())->setToolTip(entry.chip->toolTip());
        }
    }
    menu.setToolTipsVisible(true);
    menu.exec(m_rest->mapToGlobal(QPoint(0, m_rest->height())));
}

QSize ChipRow::sizeHint() const
{
    int wide = 0;
    int high = 0;
    for (const Entry& entry : m_entries) {
        wide += entry.chip->said().isEmpty() ? 0 : entry.chip->widthFor(false) + kGap_px;
        high = std::max(high, entry.chip->sizeHint().height());
    }
    return {wide, high};
}

QSize ChipRow::minimumSizeHint() const
{
    int wide = m_rest->sizeHint().width();
    for (const Entry& entry : m_entries) {
        wide += entry.mustStay && !entry.chip->said().isEmpty() ? entry.chip->widthFor(true) + kGap_px : 0;
    }
    return {wide, sizeHint().height()};
}

void ChipRow::resizeEvent(QResizeEvent*)
{
    fit();
}

void ChipRow::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        fit();
    }
    QWidget::changeEvent(event);
}

} // namespace palpate::ui

#include "palpate/ui/moc_ChipRow.cpp"
