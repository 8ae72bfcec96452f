// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/ForceTable.h>

#include <QPolygonF>
#include <QWidget>

#include <limits>
#include <memory>
#include <optional>

namespace palpate::ui {

/// Plot of a force law over depth with the steepest slope of the device and the current contact. Measured points can be
/// dragged or moved with the keyboard (left and right select a point, up and down move the point).
class LawPlot : public QWidget
{
    Q_OBJECT
  public:
    explicit LawPlot(QWidget* parent = nullptr);

    /// Shows a tissue. @param greatest_N_per_mm  largest stable slope of the device; infinite: unknown
    void show(const core::Tissue& tissue, double greatest_N_per_mm);
    /// Shows the live contact.
    /// @param depth_mm  penetration depth in this tissue; 0: no contact
    /// @param scale  scale of the law at the contact, from maps and buried lumps [1]
    void setTouch(double depth_mm, double scale);
    /// Widget position of a force at a depth.
    [[nodiscard]] QPointF placeOf(double depth_mm, double force_N) const;
    /// Widget position of the contact dot: the law times the local scale.
    [[nodiscard]] QPointF touchedPlace() const;
    /// Text of the live contact; empty without contact.
    [[nodiscard]] QString touchText() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, sizeHint().height()}; }

  Q_SIGNALS:
    /// Emitted when a measured point was moved.
    void moved(const core::ForceLaw& law);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void takeLaw(const core::ForceLaw& law);
    void fitAxes();
    [[nodiscard]] double forceAt(double depth_mm) const;
    [[nodiscard]] QRectF area() const;
    [[nodiscard]] QString limitText() const;
    [[nodiscard]] bool isLimitAbove() const;
    [[nodiscard]] QPolygonF curve(const haptics::ForceTable* table) const;
    void paintFrame(QPainter& painter) const;
    void paintLimit(QPainter& painter) const;
    void movePoint(double depth_mm, double force_N);

    core::Tissue m_tissue;
    std::shared_ptr<const haptics::ForceTable> m_table; ///< null: linear
    std::shared_ptr<const haptics::ForceTable> m_felt;  ///< limited by the device
    double m_greatest = std::numeric_limits<double>::infinity();
    double m_depth_mm = 0.0;
    double m_scale = 1.0;
    double m_reach_mm = 12.0, m_top_N = 1.0; ///< ends of the axes
    std::optional<std::size_t> m_held;       ///< point under the mouse button
    std::size_t m_chosen = 1;                ///< point selected by keys
};

} // namespace palpate::ui
