// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

namespace palpate::ui {
class MapDisplay;
class PointedStructure;
class StructurePanel;
} // namespace palpate::ui

namespace palpate::app {

/// List of the structures and the editor of the selection; selection and names in the view.
class StructuresPart : public WindowPart
{
    Q_OBJECT
  public:
    explicit StructuresPart(const WindowCore& core);
    ~StructuresPart() override;
    void addActions() override;
    /// Colours structures that were opened without colours of their own, as chosen under Appearance.
    /// @param first  rows before this one are unchanged
    void colourAsChosen(int first);
    void addPanel(Docks& docks) override;
    void showState(const WindowState& state) override;

    [[nodiscard]] ui::StructurePanel& panel() noexcept { return *m_panel; }
    [[nodiscard]] ui::MapDisplay& maps() noexcept { return *m_maps; }
    [[nodiscard]] ui::PointedStructure& pointed() noexcept { return *m_pointed; }
    /// Takes the stable limit of the device, after a change of the device or its limit.
    void takeLimit();

  private:
    void recolour(bool isSafe, int first);
    void connectMapWarnings();
    [[nodiscard]] bool isSecret() const;

    WindowCore m_core;
    ui::StructurePanel* m_panel = nullptr;
    ui::MapDisplay* m_maps = nullptr;
    ui::PointedStructure* m_pointed = nullptr;
};

} // namespace palpate::app
