// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/RecordedTouch.h"
#include "palpate/ui/SessionPanel.h"
#include "palpate/ui/StructureModel.h"
#include "palpate/ui/TouchPanel.h"
#include "palpate/ui/VtkViewport.h"

#include <palpate/core/Export.h>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <memory>

namespace palpate::ui {

/// Plays an open recording in the view. Shows the recorded ticks without recomputing contacts or forces.
class PALPATE_EXPORT Playback : public QObject
{
    Q_OBJECT
  public:
    /// @param model  structures of the open scene; provides colours by structure name
    /// All references must outlive this object.
    Playback(VtkViewport& viewport, const StructureModel& model, SessionPanel& panel, TouchPanel& touch,
             QObject* parent = nullptr);

    /// Takes a recording and shows the first tick; null closes the recording.
    void setRecording(std::unique_ptr<RecordedTouch> recording);
    [[nodiscard]] const RecordedTouch* recording() const noexcept { return m_recording.get(); }
    /// Takes a second recording, which is played beside the first and has its own playhead; null closes it. A new first
    /// recording closes it, too. No effect without a recording.
    void setSecond(std::unique_ptr<RecordedTouch> second);
    [[nodiscard]] const RecordedTouch* second() const noexcept { return m_second.get(); }
    [[nodiscard]] bool isPlaying() const;
    void play();
    void pause();
    void toStart();
    /// Seeks and fills the chart with the preceding seconds. The second recording stays where it is.
    void seek(double position_s);
    /// Moves the playhead of the second recording. No effect without one.
    void seekSecond(double position_s);
    /// Redraws the current position after other content was shown. No effect without a recording.
    void showAgain() { seek(position_s()); }
    /// Current position. [s]
    [[nodiscard]] double position_s() const { return m_panel.transport().position_s(); }
    /// Time of the greatest force. [s]
    [[nodiscard]] double peakTime_s() const noexcept { return m_peak_s; }

  Q_SIGNALS:
    void stateChanged();
    void overviewReady();
    /// Emitted when another moment is shown. @param time_s  since the first tick
    void momentShown(double time_s);
    /// As momentShown, of the second recording.
    void secondMomentShown(double time_s);

  private:
    void step();
    void showMoment(double time_s);
    void showSecondMoment();
    void showNames();
    void showPath();
    [[nodiscard]] std::shared_ptr<const geometry::SurfaceMotion> motionOf(const servo::TickRecord& tick, int row) const;
    void addLump(TouchReading& reading, const servo::TickRecord& tick) const;
    void feed(const servo::TickRecord& tick, double time_s);
    [[nodiscard]] LayerStyle lookOf(const servo::TickRecord& tick, std::uint32_t number) const;
    [[nodiscard]] std::vector<LayerShare> layersOf(const servo::TickRecord& tick) const;

    VtkViewport& m_viewport;
    const StructureModel& m_model;
    SessionPanel& m_panel;
    TouchPanel& m_touch;
    std::unique_ptr<RecordedTouch> m_recording, m_second;
    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_peak_s = 0.0;
};

} // namespace palpate::ui
