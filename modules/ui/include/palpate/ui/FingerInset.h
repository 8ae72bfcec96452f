// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Types.h>
#include <palpate/geometry/SurfaceSection.h>
#include <palpate/view/SectionPicture.h>
#include <palpate/view/TouchCursor.h>

#include <QTimer>
#include <QWidget>

#include <vector>

namespace palpate::ui {

class VtkViewport;

/// Small picture in a corner of the view, the one where it hides the least tissue and neither hand nor legend: a
/// section along the finger, with the surface at rest, the hand, the god-object and what lies below. The outward normal
/// of the contact points up. Follows the cursor, live and in playback; between contacts the latest section stays.
/// Follows at most 20 times a second.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT FingerInset : public QWidget
{
    Q_OBJECT
  public:
    /// Hidden at first. @param viewport  shows the picture; must outlive it
    explicit FingerInset(VtkViewport& viewport);

    /// Plane of the picture; its origin is the contact on the surface, its second coordinate points out of the tissue.
    [[nodiscard]] const geometry::SectionPlane& plane() const noexcept { return m_plane; }
    [[nodiscard]] const std::vector<view::SectionCut>& cuts() const noexcept { return m_cuts; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void follow();
    void take();
    void place();
    [[nodiscard]] Eigen::AlignedBox2d boxOf(const QRect& place) const;
    [[nodiscard]] bool isInTheWay(const QRect& place) const;
    [[nodiscard]] double halfWidth_mm() const;

    VtkViewport& m_viewport;
    view::TouchState m_touch; ///< shown
    geometry::SectionPlane m_plane;
    std::vector<view::SectionCut> m_cuts;
    QTimer m_pause; ///< between two pictures
};

} // namespace palpate::ui
