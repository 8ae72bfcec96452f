// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <palpate/core/Export.h>
#include <palpate/study/FeltFile.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStaticPointLocator.h>

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <memory>
#include <string>
#include <vector>

namespace palpate::ui {

/// Computed palpability of an organ's lumps and the data needed for display.
struct DisplayedOrgan
{
    study::OrganPalpability organ;                   ///< structure numbers are the rows of StructureModel
    vtkSmartPointer<vtkPolyData> picture;            ///< of the evaluated surface, uncoloured
    vtkSmartPointer<vtkStaticPointLocator> vertices; ///< of the evaluated surface
};
using DisplayedOrgans = std::vector<std::shared_ptr<const DisplayedOrgan>>;

/// Computes how buried lumps change the response of their organs' surfaces. One computation on a worker thread serves
/// the overlay and the haptic scene; the latter uses only lumps in transmitted mode. Changes of tissue, stiffness
/// ratio, contact radius or structures trigger a new computation. Nothing is computed until requested.
///
/// @par Thread All functions and signals on the GUI thread.
class PALPATE_EXPORT LumpMaps : public QObject
{
    Q_OBJECT
  public:
    /// @param model  receives the maps for the haptic scene; must outlive this object
    explicit LumpMaps(StructureModel& model, QObject* parent = nullptr);
    ~LumpMaps() override; ///< cancels and waits

    /// Requests the maps of all lumps for display.
    void setWanted(bool isWanted);
    /// Cancels the running computation and emits `cancelled` immediately. Nothing is computed until the next request or
    /// change.
    void cancel();

    /// Latest results. After a scene change they are outdated until `changed`.
    [[nodiscard]] const DisplayedOrgans& organs() const noexcept { return m_organs; }
    [[nodiscard]] bool isUpToDate() const noexcept { return m_isUpToDate; }
    /// True when the haptic scene's transmitted lumps match the scene, or when no lump is in transmitted mode.
    [[nodiscard]] bool isHandUpToDate() const noexcept { return m_isHandUpToDate || !hasTransmittedLumps(); }
    [[nodiscard]] bool isBusy() const noexcept { return m_job != nullptr; }
    /// Reasons for missing or partial results, one line each.
    [[nodiscard]] const QStringList& notes() const noexcept { return m_notes; }

  Q_SIGNALS:
    /// Emitted when results become outdated. @param isReset  the rows belong to another scene
    void outdated(bool isReset);
    /// Emitted with new results, or with empty results after cancellation.
    void changed();
    /// Progress of longer computations. @param share  0 to 1
    void progressed(const QString& what, double share);
    /// Emitted when the computation has finished, failed or been cancelled.
    void ended();
    void cancelled(const QString& line);
    /// Emitted when an organ could not be evaluated or a lump was skipped. @param lines  one message each
    void noted(const QStringList& lines);

  private:
    struct Job;
    struct Found;
    class Making;
    /// Inputs of the computation for one structure.
    struct Cause
    {
        std::string name, inside;
        std::optional<double> ratio, young_kPa, radius_mm;
        double stiffness_N_per_mm = 0.0;
        core::LawKind law = core::LawKind::Linear;
        bool isPalpable = false;
        const void* surface = nullptr;
        friend bool operator==(const Cause&, const Cause&) = default;
    };
    [[nodiscard]] std::vector<Cause> causes() const;
    [[nodiscard]] bool hasTransmittedLumps() const;
    void reset();
    void forget();
    [[nodiscard]] bool mayShow() const;
    void follow();
    void begin();
    void stop();
    void take(Found& found);

    StructureModel& m_model;
    QThreadPool m_thread;
    QTimer m_wait; ///< coalesces changes
    QElapsedTimer m_since;
    std::shared_ptr<Job> m_job; ///< null: idle
    std::vector<Cause> m_causes;
    std::vector<bool> m_forHand; ///< rows in transmitted mode
    DisplayedOrgans m_organs;
    QStringList m_notes;
    bool m_isWanted = false, m_isUpToDate = false, m_isHandUpToDate = false;
    bool m_isGivenUp = false; ///< cancelled: the maps for the haptic scene are not retried until the next change
};

} // namespace palpate::ui
