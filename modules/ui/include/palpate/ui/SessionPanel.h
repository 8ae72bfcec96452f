// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/AccessibleReadout.h"
#include "palpate/ui/Transport.h"

#include <palpate/core/Export.h>
#include <palpate/view/ColourMap.h>

#include <QRectF>
#include <QWidget>

#include <utility>
#include <vector>

class QAction;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QPainter;
class QToolButton;

namespace palpate::ui {

/// Force waveform of the whole recording with a draggable playhead. Screen readers hear the position and the greatest
/// force there.
class PALPATE_EXPORT ForceTimeline : public QWidget, public AccessibleReadout
{
    Q_OBJECT
  public:
    explicit ForceTimeline(QWidget* parent = nullptr);

    void setPeaks(std::vector<float> peaks_N, double duration_s);
    void setMarks(std::vector<std::pair<double, QString>> marks);
    void setPosition(double position_s);
    /// Extends the axes to at least this, so that two timelines have the same. @param duration_s,  force_N  0: as
    /// needed
    void setLeastAxes(double duration_s, double force_N);
    /// Hides the labels of the time axis, for a timeline with the same axis below.
    void setTimeShown(bool isShown);
    /// Greatest force of the waveform. [N]
    [[nodiscard]] double greatest_N() const noexcept { return double{m_greatest_N}; }
    /// Extends the waveform during recording. @param force_N  greatest force since the previous call
    void addLive(double time_s, double force_N);
    void clear();
    [[nodiscard]] double duration_s() const noexcept { return m_duration_s; }
    [[nodiscard]] QSize sizeHint() const override { return {500, 64}; }
    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::Slider; }
    [[nodiscard]] QString accessibleText() const override;
    [[nodiscard]] std::optional<Scale> accessibleScale() const override;
    void setAccessibleValue(double value) override;
    [[nodiscard]] QSize minimumSizeHint() const override;

  Q_SIGNALS:
    void seekWanted(double position_s);

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    [[nodiscard]] double timeAt(double x) const;
    [[nodiscard]] double placeOf(double time_s) const;
    [[nodiscard]] QRectF lane() const;
    [[nodiscard]] double top_N() const;
    [[nodiscard]] double axis_s() const;
    [[nodiscard]] QString topText() const;
    void paintBars(QPainter& painter, const QRectF& bars) const;
    void paintAxes(QPainter& painter, const QRectF& bars) const;

    std::vector<float> m_peaks_N;
    float m_greatest_N = 0.0f; ///< of the peaks
    std::vector<std::pair<double, QString>> m_marks;
    double m_duration_s = 0.0;
    double m_position_s = 0.0;
    double m_leastAxis_s = 0.0, m_leastAxis_N = 0.0;
    bool m_hasTimes = true;
    bool m_isLive = false;
    long long m_drawnTenths = -1; ///< of the live time, when last drawn
};

/// Panel of the current recording: transport, timeline, speed. A second recording has its own timeline and playhead
/// below, with the same axes.
class PALPATE_EXPORT SessionPanel : public QWidget
{
    Q_OBJECT
  public:
    explicit SessionPanel(QWidget* parent = nullptr);

    /// Adds an action of the window as a button.
    void addAction(QAction* action);
    [[nodiscard]] ForceTimeline& timeline() noexcept { return *m_timeline; }
    [[nodiscard]] Transport& transport() noexcept { return m_transport; }
    [[nodiscard]] ForceTimeline& secondTimeline() noexcept { return *m_secondTimeline; }
    [[nodiscard]] Transport& secondTransport() noexcept { return m_secondTransport; }
    void showTitle(const QString& title);
    /// Shows or hides the second timeline and the letters A and B.
    void showSecond(bool isShown);
    /// Gives both timelines the same axes, once their waveforms are known.
    void alignAxes();
    /// Updates the display from the transports.
    void refresh();
    /// Shows a running recording. @param losses  result of `lossesText`
    void showRecording(double duration_s, const QString& losses);

  Q_SIGNALS:
    void sought();
    void secondSought();

  private:
    [[nodiscard]] QLabel* letter(const QString& text, const view::Colour& colour);
    Transport m_transport, m_secondTransport;
    ForceTimeline *m_timeline = nullptr, *m_secondTimeline = nullptr;
    QLabel *m_letterA = nullptr, *m_letterB = nullptr;
    QLabel* m_title = nullptr;
    QLabel* m_time = nullptr;
    QComboBox* m_speed = nullptr;
    QHBoxLayout* m_buttons = nullptr;
};

/// Rounded time: "01:02.3" for 62.3 s.
[[nodiscard]] PALPATE_EXPORT QString clockText(double seconds);
/// Loss summary: "109 late, 0 lost". @param late  ticks skipped by the servo loop
/// @param lost  ticks lost because the disk was too slow
[[nodiscard]] PALPATE_EXPORT QString lossesText(qulonglong late, qulonglong lost);

} // namespace palpate::ui
