// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/FeltLayers.h"

#include <palpate/core/Finding.h>
#include <palpate/session/RecordingReader.h>

#include <QObject>
#include <QString>

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

namespace palpate::ui {

/// A recording opened for the window: any moment of it, and its force over time for the timeline.
class RecordedTouch : public QObject
{
    Q_OBJECT
  public:
    /// Bins of the overview: more than a timeline has pixels.
    static constexpr std::size_t kBins = 2000;

    [[nodiscard]] static core::Result<std::unique_ptr<RecordedTouch>> open(const std::filesystem::path& path);
    ~RecordedTouch() override;

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return m_path; }
    [[nodiscard]] double duration_s() const;
    /// @return the newest tick at `time_s` since the first.
    [[nodiscard]] std::optional<servo::TickRecord> at(double time_s) const;
    /// Name of a structure by its number in the scene that a tick felt, as the scene has it; empty when it has none.
    [[nodiscard]] std::string structureName(const servo::TickRecord& tick, std::uint32_t number) const;
    /// Radius of the ball that touched, 0 = a point. [mm]
    [[nodiscard]] double fingertip_mm(const servo::TickRecord& tick) const;
    /// Of the structure that a tick reports; null in free space, and when its scene is not known.
    [[nodiscard]] const core::Tissue* tissue(const servo::TickRecord& tick) const;
    /// How stiff what a tick touches was felt.
    [[nodiscard]] FeltStiffness stiffness(const servo::TickRecord& tick) const;
    [[nodiscard]] double forceLimit_N() const { return m_reader->info().device.maxForce_N; }
    /// When something was noted [s], with its kind.
    [[nodiscard]] std::vector<std::pair<double, QString>> marks() const;
    /// What was marked in it and not taken back, in the order of time.
    [[nodiscard]] std::vector<core::Finding> findings() const;
    /// @return one line about ticks that were lost or a recording that ended by itself; empty when it is whole.
    [[nodiscard]] QString losses() const;

    /// Reads the greatest force in each of `kBins` equal spans, on a thread of its own.
    void startOverview();

  Q_SIGNALS:
    void overviewReady(const std::vector<float>& peaks_N);
    /// Once all was read: something is not as it was written that opening did not tell. @param what  as damageText
    void damageFound(const QString& what);

  private:
    RecordedTouch(std::filesystem::path path, std::unique_ptr<session::RecordingReader> reader);

    std::filesystem::path m_path;
    std::unique_ptr<session::RecordingReader> m_reader;
    std::thread m_overview;
    std::atomic<bool> m_isClosing{false};
};

/// One line for a person about a recording of which some places are not as they were written; empty for 0 places.
[[nodiscard]] QString damageText(const std::filesystem::path& recording, std::size_t places);

} // namespace palpate::ui
