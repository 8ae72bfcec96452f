// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <palpate/core/Export.h>
#include <palpate/study/Distances.h>

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate::ui {

/// Measures sizes, least distances and margins of the open scene on a worker thread, and again after changes. Nothing
/// is measured until requested. The numbers are those of `palpate info --distances`.
///
/// @par Thread All functions and signals on the GUI thread.
class PALPATE_EXPORT SceneDistances : public QObject
{
    Q_OBJECT
  public:
    /// A scene without lumps and with more structures is measured from one structure only: all pairs would be many.
    static constexpr int kMostWithoutLumps = 30;

    /// @param model  must outlive this object
    explicit SceneDistances(StructureModel& model, QObject* parent = nullptr);
    ~SceneDistances() override; ///< cancels and waits

    void setWanted(bool isWanted);
    /// Sets the structure to measure from. @param row  of StructureModel; empty: the lumps, or all structures
    void setFrom(std::optional<int> row);
    [[nodiscard]] std::optional<int> from() const noexcept { return m_from; }
    /// Sets the borders of the bands: above 0 and ascending [mm].
    void setLimits(std::vector<double> limits_mm);
    [[nodiscard]] const std::vector<double>& limits_mm() const noexcept { return m_limits_mm; }
    /// Cancels the running computation. Nothing is measured until the next request or change.
    void cancel();

    /// Latest results; structure numbers are the rows of StructureModel, names are readable.
    [[nodiscard]] const study::DistanceTable& table() const noexcept { return m_table; }
    /// Index of each row; null for structures without triangles.
    [[nodiscard]] const study::SharedIndices& indices() const noexcept { return m_indices; }
    [[nodiscard]] bool isUpToDate() const noexcept { return m_isUpToDate; }
    [[nodiscard]] bool isBusy() const noexcept { return m_job != nullptr || m_wait.isActive(); }
    /// The scene has no lumps and too many structures: a structure must be chosen.
    [[nodiscard]] bool needsChoice() const noexcept { return m_needsChoice; }

  Q_SIGNALS:
    /// Emitted when the results no longer describe the scene.
    void outdated();
    /// Emitted with new results, or after cancellation.
    void changed();
    /// Progress of longer computations. @param share  0 to 1
    void progressed(const QString& what, double share);
    /// Emitted when the computation has finished or been cancelled.
    void ended();
    void cancelled(const QString& line);

  private:
    struct Job;
    struct Found;
    /// Inputs of the measurement for one structure.
    struct Cause
    {
        std::string name, inside;
        std::optional<double> ratio;
        bool isPalpable = false;
        const void* surface = nullptr;
        friend bool operator==(const Cause&, const Cause&) = default;
    };
    [[nodiscard]] std::vector<Cause> causes() const;
    void follow();
    void restart();
    void begin();
    void stop();
    void take(Found& found);

    StructureModel& m_model;
    QThreadPool m_thread;
    QTimer m_wait; ///< coalesces changes
    QElapsedTimer m_since;
    std::shared_ptr<Job> m_job; ///< null: idle
    std::vector<Cause> m_causes;
    std::optional<int> m_from;
    std::vector<double> m_limits_mm;
    study::DistanceTable m_table;
    study::SharedIndices m_indices;
    bool m_isWanted = false, m_isUpToDate = false, m_needsChoice = false;
    bool m_isGivenUp = false; ///< cancelled: not measured until the next change
};

} // namespace palpate::ui
