// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <palpate/view/ColourLegend.h>

#include <array>
#include <optional>

class QAction;

namespace palpate::app {

/// Whether and where the colour legend of the view is shown: by mouse in the view, or in the View menu. The place is
/// stored; a closed legend is open again after the next start, because colours without a legend mean nothing.
class LegendPart : public WindowPart
{
    Q_OBJECT
  public:
    explicit LegendPart(const WindowCore& core);
    void addActions() override;

  private:
    using Corner = view::ColourLegend::Corner;
    void place(std::optional<Corner> corner);
    void setShown(bool isShown);

    WindowCore m_core;
    std::array<QAction*, 5> m_places{}; ///< automatic, then as `kPlaces`
};

} // namespace palpate::app
