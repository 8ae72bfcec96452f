// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"
#include "palpate/view/LabelLayout.h"

#include <vtkBillboardTextActor3D.h>

#include <vector>

namespace palpate::view {

/// The places that were marked as findings: a disc of constant size on screen with the finding's number beside it,
/// which tissue does not hide. Where findings lie close together, numbers move apart and lines lead to their discs.
class FindingMarkers
{
  public:
    FindingMarkers() = default;
    ~FindingMarkers();
    FindingMarkers(const FindingMarkers&) = delete;
    FindingMarkers& operator=(const FindingMarkers&) = delete;

    /// @param overlay  drawn over the tissue; must outlive this or `set({})`
    void addTo(vtkRenderer& overlay) { m_overlay = &overlay; }
    /// Numbers are the order, from 1. A place that is not finite is left out, and so is its number.
    void set(const std::vector<Vec3>& places_W);
    void setVisible(bool isVisible) { m_isVisible = isVisible; }
    [[nodiscard]] bool isVisible() const noexcept { return m_isVisible; }

    /// Fits everything to the view. Before each frame.
    void place(const ViewFrame& frame);

    /// Box of what is drawn, for the clipping range [mm]; empty when nothing is.
    [[nodiscard]] core::Box bounds() const;
    /// Of the markers drawn.
    [[nodiscard]] std::size_t count() const noexcept { return m_isVisible ? m_markers.size() : 0; }

  private:
    struct Marker
    {
        Vec3 p_W;
        vtkSmartPointer<vtkActor> rim;
        vtkSmartPointer<vtkActor> disc;
        vtkSmartPointer<vtkBillboardTextActor3D> number;
        BillboardLine leader; ///< drawn where the number is not at its usual place
    };
    void measure(double pixelRatio);

    std::vector<Marker> m_markers;
    std::vector<DiscLabel> m_labels; ///< one a marker; sizes hold for m_pixelRatio
    double m_pixelRatio = 0.0;
    vtkRenderer* m_overlay = nullptr;
    bool m_isVisible = true;
};

} // namespace palpate::view
