// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/study/PressedPairs.h>
#include <palpate/ui/OwnThreshold.h>

#include <QDialog>
#include <QTimer>

#include <cstdint>
#include <optional>

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace palpate::ui {
class LiveTouch;
class VtkViewport;
} // namespace palpate::ui

namespace palpate::app {

/// Measures the threshold of the user's hand: in 60 trials the hand presses a wall twice and the user tells which press
/// was stiffer. The series can be interrupted and gives the estimate so far. Shows, keeps and deletes the threshold.
///
/// The wall is felt only: neither its place nor the force is displayed, which could be compared by eye.
/// @par Thread GUI thread only.
class ThresholdDialog : public QDialog
{
    Q_OBJECT
  public:
    /// @param live, viewport  must outlive the dialog
    /// @param seed  of the order of walls
    ThresholdDialog(ui::LiveTouch& live, ui::VtkViewport& viewport, std::uint32_t seed, QWidget* parent);
    ~ThresholdDialog() override; ///< gives the hand back to the scene

    /// Current series; empty before the start and after the end.
    [[nodiscard]] const std::optional<study::PressedPairs>& series() const noexcept { return m_series; }
    /// Takes the force of the hand on the wall [N], 0 without contact. Called with each displayed tick.
    void takeForce(double force_N);
    /// Smallest number of answers that gives an estimate.
    static constexpr std::size_t kLeastTrials = 20;

  public Q_SLOTS:
    void done(int result) override;

  private:
    void toggle();
    void begin();
    void endSeries();
    void sample();
    void placeWall();
    void showStage();
    void showStored();
    void answer(bool wasSecondStiffer);

    ui::LiveTouch& m_live;
    ui::VtkViewport& m_viewport;
    std::uint32_t m_seed;
    QTimer m_sampling;
    std::optional<study::PressedPairs> m_series;
    QLabel* m_told = nullptr;
    QLabel* m_stored = nullptr;
    QProgressBar* m_progress = nullptr;
    QPushButton* m_first = nullptr;
    QPushButton* m_second = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_reset = nullptr;
    QCheckBox* m_use = nullptr;
};

} // namespace palpate::app
