// SPDX-License-Identifier: BSD-3-Clause
#include "touch/EnergyBar.h"

#include "palpate/ui/Theme.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace palpate::ui {

EnergyBar::EnergyBar(QWidget* parent)
    : QWidget(parent)
    , AccessibleReadout(this)
{
    setFixedHeight(12);
    setObjectName(QStringLiteral("energy"));
    setAccessibleName(tr("Energy observer"));
}

void EnergyBar::setEnergy(double energy_mJ)
{
    m_energy_mJ = std::isfinite(energy_mJ) ? energy_mJ : 0.0;
    m_range_mJ = std::max(m_range_mJ, std::abs(m_energy_mJ));
    update();
    announceValue();
}

QString EnergyBar::accessibleText() const
{
    return tr("%1 mJ").arg(QLocale().toString(m_energy_mJ, 'f', 2));
}

void EnergyBar::paintEvent(QPaintEvent*)
{
    constexpr double kZero = 0.25; // fraction of the width; excess energy is expected to be small
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    painter.setPen(Qt::NoPen);
    const double zero = kZero * width();
    const double length = m_energy_mJ / m_range_mJ * (m_energy_mJ < 0.0 ? zero : width() - zero);
    painter.setBrush(m_energy_mJ < 0.0 ? warningColour() : palette().color(QPalette::Highlight));
    painter.drawRect(QRectF(std::min(zero, zero + length), 2, std::abs(length), height() - 4));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawLine(QPointF(zero, 0), QPointF(zero, height()));
}

} // namespace palpate::ui

#include "moc_EnergyBar.cpp"
