// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

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

/// What can be felt through an organ of the open scene, and what is needed to show it.
struct FeltOrganShown
{
    study::FeltOrgan organ;                          ///< its numbers of structures are the rows
    vtkSmartPointer<vtkPolyData> picture;            ///< of the felt surface, without colours
    vtkSmartPointer<vtkStaticPointLocator> vertices; ///< of the felt surface
};
using FeltOrgans = std::vector<std::shared_ptr<const FeltOrganShown>>;

/// The maps of what lumps make of their organs' surfaces: one computation, on a thread of its own, for what is shown
/// of them and for the hand, which gets those of the lumps that are felt through their organ. Made anew when tissue,
/// ratio, radius or a structure changes; nothing is computed until it is wanted.
/// @par Thread All functions on the window's thread; the signals come there too.
class LumpMaps : public QObject
{
    Q_OBJECT
  public:
    /// @param model  gets the hand's maps; must outlive this
    explicit LumpMaps(StructureModel& model, QObject* parent = nullptr);
    ~LumpMaps() override; ///< cancels and waits

    /// Whether the maps of all lumps are wanted, to be shown.
    void setWanted(bool isWanted);
    /// Stops what is being computed; `cancelled` follows at once, and nothing is computed until something is asked for
    /// or changes.
    void cancel();

    /// The newest results; those of a scene that was changed since then are out of date until `changed`.
    [[nodiscard]] const FeltOrgans& organs() const noexcept { return m_organs; }
    [[nodiscard]] bool isUpToDate() const noexcept { return m_isUpToDate; }
    /// Whether the hand feels through organs as the scene says; true where nothing is felt so.
    [[nodiscard]] bool isHandUpToDate() const noexcept { return m_isHandUpToDate || !isForHand(); }
    [[nodiscard]] bool isBusy() const noexcept { return m_job != nullptr; }
    /// Why there are no results, or what was left out of them; one line each.
    [[nodiscard]] const QStringList& notes() const noexcept { return m_notes; }

  Q_SIGNALS:
    /// The results are out of date. @param isReset  the rows are other ones
    void outdated(bool isReset);
    /// Other results, or none because it was cancelled.
    void changed();
    /// Of work that takes longer than a blink. @param share  0 … 1
    void progressed(const QString& what, double share);
    /// Nothing is computed any more, whether it was done, failed or cancelled.
    void ended();
    void cancelled(const QString& line);
    /// An organ could not be judged, or a lump was left out. @param lines  one each
    void noted(const QStringList& lines);

  private:
    struct Job;
    struct Found;
    class Making;
    /// What the results follow from, of one structure.
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
    [[nodiscard]] std::vector<bool> lumpsForHand() const;
    [[nodiscard]] bool isForHand() const;
    [[nodiscard]] meshio::LoadedScene sceneNow() const;
    void reset();
    void follow();
    void begin();
    void stop();
    void take(Found& found);

    StructureModel& m_model;
    QThreadPool m_thread;
    QTimer m_wait; ///< gathers changes
    QElapsedTimer m_since;
    std::shared_ptr<Job> m_job; ///< null: nothing is computed
    std::vector<Cause> m_causes;
    std::vector<bool> m_forHand; ///< rows that are to be felt through their organ
    FeltOrgans m_organs;
    QStringList m_notes;
    bool m_isWanted = false, m_isUpToDate = false, m_isHandUpToDate = false;
    bool m_isGivenUp = false; ///< cancelled: the hand's maps are not tried again until something changes
};

} // namespace palpate::ui
