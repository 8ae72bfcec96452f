// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/AccessibleReadout.h"
#include "palpate/ui/TouchHistory.h"

#include <palpate/core/Export.h>

#include <QPainterPath>
#include <QWidget>

namespace palpate::ui {

/// Chart of force and depth over the last ten seconds, stacked on a common time axis. With several layers in contact,
/// the area below the force is divided into the layers' components in the structures' colours, outermost at the bottom,
/// inner layers hatched. A dotted line shows the tangential (friction) component. Screen readers hear the newest
/// values.
class PALPATE_EXPORT TouchChart : public QWidget, public AccessibleReadout
{
    Q_OBJECT
  public:
    explicit TouchChart(const TouchHistory& history, QWidget* parent = nullptr);
    [[nodiscard]] QSize sizeHint() const override { return {260, 230}; }
    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::Chart; }
    [[nodiscard]] QString accessibleText() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
    /// Allows lower lanes, for a panel without the room. `minimumSizeHint` is less by `kLowSaves_px`.
    void setLow(bool isLow);
    static constexpr int kLowSaves_px = 36;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void paintLane(QPainter& painter, const QRectF& lane, bool isForce) const;
    /// Curve of one sample member over time.
    [[nodiscard]] QPainterPath curve(const QRectF& lane, double top, double TouchSample::*value) const;
    void paintOver(QPainter& painter, const QRectF& lane) const;
    void paintLayers(QPainter& painter, const QRectF& lane, double top_N) const;
    const TouchHistory& m_history;
    bool m_isLow = false;
};

/// Bar from 0 to the device's force limit in the colours of the cursor sphere in the view.
class PALPATE_EXPORT ForceBar : public QWidget, public AccessibleReadout
{
    Q_OBJECT
  public:
    explicit ForceBar(QWidget* parent = nullptr);
    void setLimit(double force_N);
    void setForce(double force_N);
    [[nodiscard]] double limit_N() const noexcept { return m_limit_N; }
    /// Filled fraction of the bar, 0 to 1.
    [[nodiscard]] double share() const noexcept;
    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::Indicator; }
    [[nodiscard]] QString accessibleText() const override;
    [[nodiscard]] std::optional<Scale> accessibleScale() const override { return Scale{m_force_N, 0.0, m_limit_N}; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {40, sizeHint().height()}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    double m_limit_N = 10.0;
    double m_force_N = 0.0;
};

} // namespace palpate::ui
