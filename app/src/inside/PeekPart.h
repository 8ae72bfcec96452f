// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <optional>
#include <vector>

namespace palpate::ui {
class StructurePanel;
class TouchPanel;
} // namespace palpate::ui

namespace palpate::app {

/// Looks through everything that lies above a structure, while a key is held or the command is checked.
class PeekPart : public WindowPart
{
    Q_OBJECT
  public:
    static constexpr double kOpacity = 0.2; ///< of the structures above

    /// The references must outlive this part.
    PeekPart(const WindowCore& core, const ui::StructurePanel& structures, const ui::TouchPanel& touch);
    void addActions() override;
    void showState(const WindowState& state) override;

  private:
    void setPeeking(bool isPeeking);
    [[nodiscard]] std::optional<int> target() const;
    [[nodiscard]] std::vector<int> above(int target) const;

    WindowCore m_core;
    const ui::StructurePanel& m_structures;
    const ui::TouchPanel& m_touch;
    std::vector<int> m_faded; ///< rows drawn translucent at the moment
};

} // namespace palpate::app
