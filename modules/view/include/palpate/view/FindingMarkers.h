// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"
#include "palpate/view/LabelLayout.h"

#include <palpate/core/Finding.h>

#include <vtkSmartPointer.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate::view {

/// A place that is marked.
struct FindingMark
{
    Vec3 p_W = Vec3::Zero(); ///< not finite: not drawn
    core::FindingType type = core::FindingType::Other;
    std::size_t number = 0; ///< drawn beside it
    std::string name{};     ///< drawn after the number when it is selected
};

/// The places that were marked as findings: a shape and a colour for each type, of constant size on screen, with the
/// finding's number beside it. Tissue does not hide them: what lies behind it is hollow and faint. Where findings lie
/// close together, numbers move apart and lines lead to their shapes.
///
/// All of them are two actors, whatever their number; nothing is made anew while neither view nor findings change.
class FindingMarkers
{
  public:
    /// Of what is behind tissue.
    static constexpr double kHiddenOpacity = 0.35;
    /// With more markers, numbers are those of the selected one alone, and none counts as hidden.
    static constexpr std::size_t kMostNumbered = 1000;

    FindingMarkers();
    ~FindingMarkers();
    FindingMarkers(const FindingMarkers&) = delete;
    FindingMarkers& operator=(const FindingMarkers&) = delete;

    /// @param overlay  drawn over the tissue; must outlive this
    void addTo(vtkRenderer& overlay);
    void set(std::vector<FindingMark> marks);
    /// Shows one's name. @param number  of the mark; 0: none
    void select(std::size_t number);
    void setVisible(bool isVisible);
    [[nodiscard]] bool isVisible() const noexcept { return m_isVisible; }

    /// Whether tissue lies between the eye and a place.
    using IsBehind = std::function<bool(const Vec3& p_W)>;
    /// Asks for each place anew. When the view, the tissue or the findings changed.
    void findHidden(const IsBehind& isBehind);
    /// Counts the changes of what is marked, for the code that finds the hidden ones.
    [[nodiscard]] std::size_t revision() const noexcept { return m_revision; }

    /// Fits everything to the view. Before each frame.
    /// @param taken  what its numbers stay clear of, logical pixels from the view's middle: the hand
    void place(const ViewFrame& frame, const std::vector<Eigen::AlignedBox2d>& taken = {});

    /// Box of what is drawn, for the clipping range [mm]; empty when nothing is.
    [[nodiscard]] core::Box bounds() const;
    /// Of the markers drawn.
    [[nodiscard]] std::size_t count() const noexcept { return m_isVisible ? m_marks.size() : 0; }
    [[nodiscard]] const std::vector<FindingMark>& marks() const noexcept { return m_marks; }
    [[nodiscard]] bool isHidden(std::size_t i) const { return m_isHidden[i]; }
    /// What stands beside a marker; empty for nothing.
    [[nodiscard]] std::string textOf(std::size_t i) const;
    /// Where that stands, after `place`.
    [[nodiscard]] const DiscLabel& labelOf(std::size_t i) const { return m_labels[i]; }

  private:
    class Picture;
    void writeTexts(const ViewFrame& frame);
    [[nodiscard]] bool isCovering(const std::vector<Eigen::AlignedBox2d>& taken) const;

    std::vector<FindingMark> m_marks;
    std::vector<bool> m_isHidden;    ///< one a mark
    std::vector<DiscLabel> m_labels; ///< one a mark; sizes hold for m_pixelRatio and m_textStyle
    std::unique_ptr<Picture> m_picture;
    std::size_t m_selected = 0;
    std::size_t m_revision = 0;
    double m_pixelRatio = 0.0;                  ///< 0: texts are to be written anew
    TextStyle m_textStyle;                      ///< that they were written in
    std::optional<ViewFrame> m_placed;          ///< what is drawn now; nothing: it is to be made anew
    std::vector<Eigen::AlignedBox2d> m_avoided; ///< what numbers went aside for, in the picture as it is
    vtkRenderer* m_overlay = nullptr;
    bool m_isVisible = true;
};

} // namespace palpate::view
