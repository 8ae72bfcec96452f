// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/FeltLayers.h"

#include <palpate/core/Export.h>
#include <palpate/core/Finding.h>
#include <palpate/geometry/SurfaceMotion.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/view/HandPath.h>

#include <QObject>
#include <QString>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace palpate::ui {

/// Opened recording with random access to ticks and an overview of the force for the timeline.
class PALPATE_EXPORT RecordedTouch : public QObject
{
    Q_OBJECT
  public:
    /// Bins of the overview; more than a timeline has pixels.
    static constexpr std::size_t kBins = 2000;
    /// Most points of the path of the hand.
    static constexpr std::int64_t kPathPoints = 20'000;

    [[nodiscard]] static core::Result<std::unique_ptr<RecordedTouch>> open(const std::filesystem::path& path);
    ~RecordedTouch() override;

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return m_path; }
    [[nodiscard]] double duration_s() const;
    /// Newest tick at `time_s` after the first tick.
    [[nodiscard]] std::optional<servo::TickRecord> at(double time_s) const;
    /// Name of a structure by its number in the tick's scene; empty for unnamed structures.
    [[nodiscard]] std::string structureName(const servo::TickRecord& tick, std::uint32_t number) const;
    /// Radius of the probe sphere; 0: a point. [mm]
    [[nodiscard]] double fingertip_mm(const servo::TickRecord& tick) const;
    /// Time of a tick, at which its moving tissue was. [s]
    [[nodiscard]] double timeOf_s(const servo::TickRecord& tick) const;
    /// How a structure of the open scene moved at a tick.
    /// @param own  its motion in the scene. A structure that could not be touched has none in the recording: it moves
    /// like one of the same shape of motion, else by its own
    [[nodiscard]] std::shared_ptr<const geometry::SurfaceMotion>
    motion(const servo::TickRecord& tick, const std::string& structure,
           const std::shared_ptr<const geometry::SurfaceMotion>& own) const;
    /// Tissue of the structure reported by a tick; null in free space or when the tick's scene is unknown.
    [[nodiscard]] const core::Tissue* tissue(const servo::TickRecord& tick) const;
    /// Stiffness at the recorded contact of a tick.
    [[nodiscard]] ContactStiffness stiffness(const servo::TickRecord& tick) const;
    [[nodiscard]] double forceLimit_N() const { return m_reader->info().device.maxForce_N; }
    /// Times [s] and kinds of the recorded events.
    [[nodiscard]] std::vector<std::pair<double, QString>> marks() const;
    /// Findings marked during the recording and not deleted, ordered by time.
    [[nodiscard]] std::vector<core::Finding> findings() const;
    /// One line about lost ticks or an interrupted recording; empty for a complete recording.
    [[nodiscard]] QString losses() const;

    /// Starts reading the greatest force in each of `kBins` equal intervals and the path of the hand on a worker
    /// thread.
    void startOverview();
    /// Positions of the hand at equal intervals; empty until `overviewReady`.
    [[nodiscard]] const std::vector<view::PathPoint>& path_W() const noexcept { return m_path_W; }

  Q_SIGNALS:
    void overviewReady(const std::vector<float>& peaks_N);
    /// Emitted after the full read when damage was found that opening did not detect. @param what  result of damageText
    void damageFound(const QString& what);

  private:
    RecordedTouch(std::filesystem::path path, std::unique_ptr<session::RecordingReader> reader);

    std::filesystem::path m_path;
    std::unique_ptr<session::RecordingReader> m_reader;
    std::thread m_overview;
    std::atomic<bool> m_isClosing{false};
    std::vector<view::PathPoint> m_path_W;
};

/// One-line message about the number of damaged places of a recording; empty for 0 places.
[[nodiscard]] PALPATE_EXPORT QString damageText(const std::filesystem::path& recording, std::size_t places);

} // namespace palpate::ui
