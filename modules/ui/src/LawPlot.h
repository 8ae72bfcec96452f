// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/ForceTable.h>

#include <QWidget>

#include <limits>
#include <memory>
#include <optional>

namespace palpate::ui {

/// The force of a law by depth, with the steepest line that the device holds and where the hand is now. Measured points
/// can be moved: by dragging, or with the keyboard (left and right choose one, up and down move it).
class LawPlot : public QWidget
{
    Q_OBJECT
  public:
    explicit LawPlot(QWidget* parent = nullptr);

    /// @param greatest_N_per_mm  that the device holds; infinite: nothing is known
    void show(const core::Tissue& tissue, double greatest_N_per_mm);
    /// @param depth_mm  of the hand in this tissue; 0: it does not touch
    /// @param scale  by which maps and lumps below scale the law where it touches [1]
    void setTouch(double depth_mm, double scale);
    /// Where a force at a depth is drawn.
    [[nodiscard]] QPointF placeOf(double depth_mm, double force_N) const;
    /// Where the dot of the live touch is: the law times the scale where it touches.
    [[nodiscard]] QPointF touchedPlace() const;
    /// What is written of the live touch; empty when there is none.
    [[nodiscard]] QString touchText() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, sizeHint().height()}; }

  Q_SIGNALS:
    /// A measured point was moved.
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
    std::shared_ptr<const haptics::ForceTable> m_felt;  ///< as far as the device holds it
    double m_greatest = std::numeric_limits<double>::infinity();
    double m_depth_mm = 0.0;
    double m_scale = 1.0;
    double m_reach_mm = 12.0, m_top_N = 1.0; ///< ends of the axes
    std::optional<std::size_t> m_held;       ///< point under the mouse button
    std::size_t m_chosen = 1;                ///< point that keys move
};

} // namespace palpate::ui
