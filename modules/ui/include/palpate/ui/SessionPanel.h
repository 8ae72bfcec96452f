// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Spoken.h"
#include "palpate/ui/Transport.h"

#include <QWidget>

#include <utility>
#include <vector>

class QAction;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace palpate::ui {

/// Force as a waveform over the whole recording, with a head that is dragged to seek. A screen reader hears where the
/// head stands and the greatest force there.
class ForceTimeline : public QWidget, public Spoken
{
    Q_OBJECT
  public:
    explicit ForceTimeline(QWidget* parent = nullptr);

    void setPeaks(std::vector<float> peaks_N, double duration_s);
    void setMarks(std::vector<std::pair<double, QString>> marks);
    void setPosition(double position_s);
    /// Shows a recording as it grows. @param force_N  greatest since the last call
    void addLive(double time_s, double force_N);
    void clear();
    [[nodiscard]] double duration_s() const noexcept { return m_duration_s; }
    [[nodiscard]] QSize sizeHint() const override { return {500, 64}; }
    [[nodiscard]] QAccessible::Role spokenRole() const override { return QAccessible::Slider; }
    [[nodiscard]] QString spokenText() const override;
    [[nodiscard]] std::optional<Scale> spokenScale() const override;
    void setSpoken(double value) override;
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

    std::vector<float> m_peaks_N;
    std::vector<std::pair<double, QString>> m_marks;
    double m_duration_s = 0.0;
    double m_position_s = 0.0;
    bool m_isLive = false;
};

/// The recording at hand: transport, timeline, speed.
class SessionPanel : public QWidget
{
    Q_OBJECT
  public:
    explicit SessionPanel(QWidget* parent = nullptr);

    /// The window's actions appear here as buttons too.
    void addAction(QAction* action);
    [[nodiscard]] ForceTimeline& timeline() noexcept { return *m_timeline; }
    [[nodiscard]] Transport& transport() noexcept { return m_transport; }
    void showTitle(const QString& title);
    /// Shows what the transport says.
    void refresh();
    /// Shows a recording in progress. @param losses  what `lossesText` says
    void showRecording(double duration_s, const QString& losses);

  Q_SIGNALS:
    void sought();

  private:
    Transport m_transport;
    ForceTimeline* m_timeline = nullptr;
    QLabel* m_title = nullptr;
    QLabel* m_time = nullptr;
    QComboBox* m_speed = nullptr;
    QHBoxLayout* m_buttons = nullptr;
};

/// "01:02.3" for 62.3 s, rounded.
[[nodiscard]] QString clockText(double seconds);
/// "109 late, 0 lost". @param late  ticks that the servo left out; @param lost  those that the disk was too slow for
[[nodiscard]] QString lossesText(qulonglong late, qulonglong lost);

} // namespace palpate::ui
