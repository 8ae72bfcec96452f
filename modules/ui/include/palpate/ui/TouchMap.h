// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/TouchSums.h"

#include <palpate/core/Export.h>
#include <palpate/servo/TickRecord.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <QObject>
#include <QString>
#include <QTimer>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace palpate::ui {

class StructureModel;
class VtkViewport;

/// Quantity of a map of touch; definitions in docs/measures.md.
enum class TouchQuantity
{
    None,
    Covered,   ///< touched or not
    Dwell,     ///< time spent
    PeakForce, ///< largest force
    Stiffness  ///< largest ratio of force and depth
};
inline constexpr int kTouchQuantities = 5;

[[nodiscard]] PALPATE_EXPORT QString touchQuantityText(TouchQuantity quantity);

/// Colours the touched parts of all structures by what the hand did there: in a recording up to the position of the
/// player, else live since `restart` as a preview from the displayed ticks. Ticks are counted while a map is shown.
/// Untouched parts keep their colour. Touched structures are drawn opaque. With a second recording, the examined
/// surface is divided into what both hands, only the first and only the second touched.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT TouchMap : public QObject
{
    Q_OBJECT
  public:
    /// Both references must outlive this object.
    TouchMap(VtkViewport& viewport, StructureModel& model, QObject* parent = nullptr);
    ~TouchMap() override;

    void show(TouchQuantity quantity);
    [[nodiscard]] TouchQuantity quantity() const noexcept { return m_quantity; }
    /// Takes the sums from a recording; an empty path: live.
    void setRecording(const std::filesystem::path& recording);
    /// Moves the end of the sums. No effect without a recording. @param time_s  since the first tick
    void setPosition(double time_s);
    /// Compares the recording with a second one; an empty path: no comparison.
    /// @param distance_mm  distance that counts as touched in both
    void setSecond(const std::filesystem::path& recording, double distance_mm);
    /// As setPosition, for the second recording.
    void setSecondPosition(double time_s);
    /// Starts live sums again. @param distance_mm  distance within which a place counts as touched, > 0
    void restart(double distance_mm);
    /// Adds a displayed tick to the live sums. No effect without a map, or with a recording. @param dt_s  time since
    /// the last one
    void add(const servo::TickRecord& tick, double dt_s);
    /// The sums that are drawn; null before the first.
    [[nodiscard]] const TouchSums* sums() const noexcept { return m_first.sums.get(); }
    /// The sums of the second recording; null before the first.
    [[nodiscard]] const TouchSums* secondSums() const noexcept { return m_second.sums.get(); }

  Q_SIGNALS:
    void drawn();
    /// Emitted before the map's colours replace others, and after they were removed.
    void shownChanged(bool isShown);
    /// Emitted when the recording cannot be read. @param why  one sentence
    void failed(const QString& why);

  private:
    struct Picture
    {
        std::shared_ptr<const geometry::RepairedMesh> surface;
        vtkSmartPointer<vtkPolyData> plain; ///< of a split surface
    };
    /// A recording and its sums up to a moment.
    struct Source
    {
        std::filesystem::path recording; ///< empty: none
        double position_s = 0.0;
        std::uint64_t number = 0; ///< of the reader
        std::unique_ptr<RecordedTouchSums> reader;
        std::shared_ptr<const TouchSums> sums;
    };
    /// A touched structure of the scene. Null: not touched in that recording.
    struct Drawn
    {
        int row = 0;
        const TouchedStructure *first = nullptr, *second = nullptr;
    };
    void read();
    void read(Source& source);
    void forget();
    [[nodiscard]] bool isCompared() const;
    void draw();
    [[nodiscard]] std::vector<Drawn> touchedStructures() const;
    void drawValues(const std::vector<Drawn>& touched);
    void drawCompared(const std::vector<Drawn>& touched);
    void paint(int row, vtkPolyData& picture);
    void drawLegend(double high, double all_mm2, double covered_mm2, double above_mm2);
    void restore(int row);
    void undraw();
    [[nodiscard]] session::MeshesByHash meshes() const;
    [[nodiscard]] vtkSmartPointer<vtkPolyData> plainPicture(int row, const TouchedStructure& touched);

    VtkViewport& m_viewport;
    StructureModel& m_model;
    TouchQuantity m_quantity = TouchQuantity::None;
    Source m_first, m_second;
    std::optional<double> m_compared_mm; ///< distance that counts as touched in both recordings
    std::size_t m_meshes = 0;            ///< surfaces known to the readers
    std::uint64_t m_readers = 0;         ///< number of readers so far
    std::unique_ptr<session::TouchedSurfaces> m_live;
    session::MeshesByHash m_liveMeshes;
    double m_live_s = 0.0, m_distance_mm = 5.0;
    std::map<int, Picture> m_pictures; ///< of split surfaces, by row
    std::vector<int> m_drawn;          ///< rows with the map's colours
    bool m_isShown = false;            ///< colours, if any, and legend are those of the map
    QTimer m_redraw;                   ///< limits the rate of live updates
};

} // namespace palpate::ui
