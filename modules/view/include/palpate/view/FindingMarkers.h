// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"
#include "palpate/view/LabelLayout.h"

#include <palpate/core/Export.h>
#include <palpate/core/Finding.h>

#include <vtkSmartPointer.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate::view {

/// Position and label of a marked finding.
struct FindingMark
{
    Vec3 p_W = Vec3::Zero(); ///< not drawn unless finite
    core::FindingType type = core::FindingType::Other;
    std::size_t number = 0;                 ///< shown beside the marker
    std::string name{};                     ///< shown after the number while the finding is selected
    std::optional<std::size_t> structure{}; ///< index in the view; if it moves, `p_W` is on its rest shape
};

/// Markers of findings: a shape and colour per finding type, of constant size on screen, with the finding's number.
/// Markers behind tissue stay visible, hollow and faint. Where findings are close together, numbers move apart and
/// leader lines connect them with their markers.
///
/// All markers are drawn by two actors, whatever their number. Geometry is rebuilt only when the view or the findings
/// change.
class PALPATE_EXPORT FindingMarkers
{
  public:
    /// Opacity of markers hidden behind tissue.
    static constexpr double kHiddenOpacity = 0.35;
    /// Above this number of markers, only the selected marker shows a number and no marker is treated as hidden.
    static constexpr std::size_t kMaxNumbered = 1000;

    FindingMarkers();
    ~FindingMarkers();
    FindingMarkers(const FindingMarkers&) = delete;
    FindingMarkers& operator=(const FindingMarkers&) = delete;

    /// Adds the actors to a renderer. @param overlay  drawn over the tissue; must outlive this
    void addTo(vtkRenderer& overlay);
    void set(std::vector<FindingMark> marks);
    /// Moves a mark, to where its place on the rest shape is now.
    void move(std::size_t i, const Vec3& p_W);
    /// The place of a mark as given to `set`.
    [[nodiscard]] const Vec3& rest_W(std::size_t i) const { return m_rest_W[i]; }
    /// Shows the name of one finding. @param number  number of the mark; 0: deselect
    void select(std::size_t number);
    void setVisible(bool isVisible);
    [[nodiscard]] bool isVisible() const noexcept { return m_isVisible; }

    /// Place of the selected finding; empty if none is selected.
    [[nodiscard]] std::optional<Vec3> selectedPlace() const;

    /// Returns whether tissue is between the eye and a point.
    using IsBehind = std::function<bool(const Vec3& p_W)>;
    /// Recomputes which markers are hidden. Call when the view, the tissue or the findings changed.
    void updateHidden(const IsBehind& isBehind);
    /// Number of changes of the marks so far, for the code that calls `updateHidden`.
    [[nodiscard]] std::size_t revision() const noexcept { return m_revision; }

    /// Fits all markers to the view. Call before each frame.
    /// @param taken  boxes that numbers avoid (the hand), logical pixels from the centre of the view
    void place(const ViewFrame& frame, const std::vector<Eigen::AlignedBox2d>& taken = {});

    /// Bounding box of the markers, for the clipping range [mm]; empty when nothing is drawn.
    [[nodiscard]] core::Box bounds() const;
    /// Number of markers drawn.
    [[nodiscard]] std::size_t count() const noexcept { return m_isVisible ? m_marks.size() : 0; }
    [[nodiscard]] const std::vector<FindingMark>& marks() const noexcept { return m_marks; }
    [[nodiscard]] bool isHidden(std::size_t i) const { return m_isHidden[i]; }
    /// Text beside a marker; empty: no text.
    [[nodiscard]] std::string textOf(std::size_t i) const;
    /// Position of that text, after `place`.
    [[nodiscard]] const DiscLabel& labelOf(std::size_t i) const { return m_labels[i]; }

  private:
    class Picture;
    void writeTexts(const ViewFrame& frame);
    [[nodiscard]] bool overlapsAny(const std::vector<Eigen::AlignedBox2d>& taken) const;

    std::vector<FindingMark> m_marks;
    std::vector<Vec3> m_rest_W;      ///< per mark: place as given to `set`
    std::vector<bool> m_isHidden;    ///< per mark
    std::vector<DiscLabel> m_labels; ///< per mark; sizes are valid for m_pixelRatio and m_textStyle
    std::unique_ptr<Picture> m_picture;
    std::size_t m_selected = 0;
    std::size_t m_revision = 0;
    double m_pixelRatio = 0.0;                  ///< 0: texts must be rendered again
    TextStyle m_textStyle;                      ///< style of the rendered texts
    std::optional<ViewFrame> m_placed;          ///< view of the current geometry; empty: must be rebuilt
    std::vector<Eigen::AlignedBox2d> m_avoided; ///< boxes that the numbers avoid in the current geometry
    vtkRenderer* m_overlay = nullptr;
    bool m_isVisible = true;
};

} // namespace palpate::view
