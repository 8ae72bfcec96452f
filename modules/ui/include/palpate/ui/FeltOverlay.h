// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/CameraFlight.h"
#include "palpate/ui/MapDisplay.h"
#include "palpate/ui/StructureModel.h"

#include <palpate/study/FeltFile.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStaticPointLocator.h>

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <array>
#include <memory>
#include <vector>

namespace palpate::ui {

/// What can be felt through an organ of the open scene, and what is needed to show it.
struct FeltOrganShown
{
    study::FeltOrgan organ;                          ///< its numbers of structures are the rows
    vtkSmartPointer<vtkPolyData> picture;            ///< of the felt surface, without colours
    vtkSmartPointer<vtkStaticPointLocator> vertices; ///< of the felt surface
};

/// What can be felt of lumps through the organs of the open scene: computed on a thread of its own, anew when tissue,
/// ratio, radius or a structure changes, and drawn on the organs. Nothing is computed until it is wanted.
/// @par Thread All functions on the window's thread; the signals come there too.
class FeltOverlay : public QObject
{
    Q_OBJECT
  public:
    /// How deep the finger is pressed in. [mm]
    static constexpr std::array<double, 4> kPress_mm{0.0, 2.0, 4.0, 8.0};

    /// All must outlive this. @param maps  draws nothing while this does
    FeltOverlay(VtkViewport& viewport, StructureModel& model, MapDisplay& maps, QObject* parent = nullptr);
    ~FeltOverlay() override; ///< cancels and waits

    /// Draws it on the organs, or no more.
    void setShown(bool isShown);
    [[nodiscard]] bool isShown() const noexcept { return m_isShown; }
    /// Computes it for a table, drawn or not.
    void setTabled(bool isTabled);
    /// @param press  number in kPress_mm, for what is drawn and said
    void setPress(std::size_t press);
    [[nodiscard]] std::size_t press() const noexcept { return m_press; }
    /// Stops what is being computed; `cancelled` follows at once, and nothing is computed until something is asked for
    /// or changes.
    void cancel();

    /// The newest results; those of a scene that was changed since then are out of date until `changed`.
    [[nodiscard]] const std::vector<FeltOrganShown>& organs() const noexcept { return m_organs; }
    [[nodiscard]] bool isUpToDate() const noexcept { return m_isUpToDate; }
    [[nodiscard]] bool isBusy() const noexcept { return m_job != nullptr; }
    /// Why there are no results, or what was left out of them; one line each.
    [[nodiscard]] const QStringList& notes() const noexcept { return m_notes; }

    /// What is felt at a place, in words; empty where nothing is drawn. @param p_W  on the structure [mm]
    [[nodiscard]] QString textAt(int row, const core::Vec3& p_W) const;
    /// Flies to where a lump is felt most and marks it. @param organ,lump  numbers in organs(), and of its lumps
    /// @return false where no place is judged
    bool showBestPlace(std::size_t organ, std::size_t lump);

  Q_SIGNALS:
    /// Other results, or they are out of date, or another press.
    void changed();
    /// Of work that takes longer than a blink. @param share  0 … 1
    void progressed(const QString& what, double share);
    /// Nothing is computed any more, whether it was done, failed or cancelled.
    void ended();
    void cancelled();
    /// An organ could not be judged, or a lump was left out. @param lines  one each
    void noted(const QStringList& lines);

  private:
    struct Job;
    struct Found;
    /// What the results follow from, of one structure.
    struct Cause
    {
        std::string name, inside;
        std::optional<double> ratio, young_kPa, radius_mm;
        double stiffness_N_per_mm = 0.0;
        bool isPalpable = false;
        const void* surface = nullptr;
        friend bool operator==(const Cause&, const Cause&) = default;
    };
    [[nodiscard]] std::vector<Cause> causes() const;
    [[nodiscard]] meshio::LoadedScene sceneNow() const;
    void follow();
    void begin();
    void stop();
    void take(Found& found);
    void draw();
    void drawLegend(double greatest_percent, bool isHatched);
    void undraw();

    VtkViewport& m_viewport;
    StructureModel& m_model;
    MapDisplay& m_maps;
    CameraFlight m_flight;
    QThreadPool m_thread;
    QTimer m_wait; ///< gathers changes
    QElapsedTimer m_since;
    std::shared_ptr<Job> m_job; ///< null: nothing is computed
    std::vector<Cause> m_causes;
    std::vector<FeltOrganShown> m_organs;
    QStringList m_notes;
    std::vector<int> m_drawn; ///< rows
    std::size_t m_press = 0;
    bool m_isShown = false, m_isTabled = false, m_isUpToDate = false;
};

} // namespace palpate::ui
