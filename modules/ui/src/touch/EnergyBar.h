// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/AccessibleReadout.h"

#include <QWidget>

namespace palpate::ui {

/// Bar of the energy exchanged with the hand around zero: energy put in by the hand to the right, excess energy
/// returned to the hand to the left in another colour.
class EnergyBar : public QWidget, public AccessibleReadout
{
    Q_OBJECT
  public:
    explicit EnergyBar(QWidget* parent = nullptr);
    void setEnergy(double energy_mJ);
    [[nodiscard]] QSize sizeHint() const override { return {120, 12}; }
    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::Indicator; }
    [[nodiscard]] QString accessibleText() const override;
    [[nodiscard]] std::optional<Scale> accessibleScale() const override
    {
        return Scale{m_energy_mJ, -m_range_mJ, m_range_mJ};
    }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    double m_energy_mJ = 0.0;
    double m_range_mJ = 1.0; ///< grows with the displayed values
};

} // namespace palpate::ui
