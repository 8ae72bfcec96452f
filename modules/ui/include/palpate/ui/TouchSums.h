// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/session/TouchedSurfaces.h>

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace palpate::ui {

/// Measures of touch at the vertices of one surface. Arrays have one entry per vertex; see docs/measures.md.
struct TouchedStructure
{
    std::shared_ptr<const geometry::RepairedMesh> surface; ///< with long edges split, see session::TouchedSurface
    bool isSplit = false;                                  ///< `surface` is not that of the scene
    std::vector<float> dwell_s, peakForce_N, stiffness_N_per_mm;
    std::vector<double> share_mm2; ///< area share
};

/// What was touched up to a moment.
struct TouchSums
{
    double time_s = 0.0; ///< since the start
    std::map<session::StructureKey, TouchedStructure> structures;
};

/// Copies the measures out of surfaces that change with each tick. Surfaces of the last result are used again.
[[nodiscard]] PALPATE_EXPORT std::shared_ptr<const TouchSums> touchSums(const session::TouchedSurfaces& surfaces,
                                                                        const session::MeshesByHash& meshes,
                                                                        double time_s, const TouchSums* last);

/// Reads a recording on a thread of its own and sums up what was touched up to a moment. Moving on from the last
/// moment reads only the ticks between; moving back starts again.
class PALPATE_EXPORT RecordedTouchSums
{
  public:
    /// @param meshes  surfaces of the open scene
    /// @param distance_mm  distance that counts as touched; empty: the recording's default
    /// @param ready  called on the thread with each result @param failed  called there with the reason, at most once
    RecordedTouchSums(std::filesystem::path recording, session::MeshesByHash meshes, std::optional<double> distance_mm,
                      std::function<void(std::shared_ptr<const TouchSums>)> ready,
                      std::function<void(const core::Status&)> failed);
    ~RecordedTouchSums(); ///< cancels and waits
    RecordedTouchSums(const RecordedTouchSums&) = delete;
    RecordedTouchSums& operator=(const RecordedTouchSums&) = delete;

    /// Requests the sums up to a moment, in place of an older request. @param time_s  since the first tick
    void setEnd(double time_s);

  private:
    void run();
    /// Waits for a request. @return empty: the object is being destroyed
    [[nodiscard]] std::optional<double> nextEnd();
    [[nodiscard]] bool isOutdated(double end_s);

    std::filesystem::path m_recording;
    session::MeshesByHash m_meshes;
    std::optional<double> m_distance_mm;
    std::function<void(std::shared_ptr<const TouchSums>)> m_ready;
    std::function<void(const core::Status&)> m_failed;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::optional<double> m_end_s; ///< requested and not yet begun
    bool m_isClosing = false;
    std::thread m_thread; ///< last, so that it starts with everything else in place
};

} // namespace palpate::ui
