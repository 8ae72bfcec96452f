// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/study/Layers.h>
#include <palpate/ui/TouchMode.h>

#include <QCoreApplication>
#include <QStringList>

#include <vector>

/// Contact layout of structures from mesh files by nesting. A lump is palpated through its organ if the model applies
/// and the names determine the stiffness of both; all other structures become layers below the structure around them.
class LumpLayout
{
    Q_DECLARE_TR_FUNCTIONS(LumpLayout)
  public:
    /// Computes the layout.
    /// @param first  structures before this row keep their mode: lumps palpated through their organ stay so, and no
    /// others are added
    LumpLayout(const palpate::ui::StructureModel& model, const palpate::study::Layering& layering, int first);

    /// Contact mode of each structure.
    [[nodiscard]] const std::vector<palpate::ui::TouchMode>& ways() const noexcept { return m_ways; }
    /// Same layout with layers only.
    [[nodiscard]] std::vector<palpate::ui::TouchMode> inLayers() const;
    /// Notes for the user, one sentence each without final full stop, lumps first.
    [[nodiscard]] const QStringList& lines() const noexcept { return m_lines; }
    [[nodiscard]] bool hasTransmittedLump() const noexcept { return m_hasTransmittedLump; }
    /// Lump inside a surface that is open or inside out. The layout leaves it where it is.
    struct InOpen
    {
        int lump = 0;   ///< row
        int around = 0; ///< row of the surface
    };
    [[nodiscard]] const std::vector<InOpen>& inOpenSurfaces() const noexcept { return m_open; }

  private:
    void assignLump(int row, int around);
    [[nodiscard]] QString reasonForLayer(int row, int around) const;

    const palpate::ui::StructureModel& m_model;
    std::vector<palpate::ui::TouchMode> m_ways;
    std::vector<std::uint32_t> m_layers;
    std::vector<bool> m_needsSentence; ///< included in the sentences about layers
    QStringList m_lines;
    std::vector<InOpen> m_open;
    bool m_hasTransmittedLump = false;
};
