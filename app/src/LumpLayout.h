// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/study/Layers.h>
#include <palpate/ui/FeltWay.h>

#include <QCoreApplication>
#include <QStringList>

#include <vector>

/// How structures of mesh files are felt by what lies in what: a lump through its organ, where that can be computed and
/// how stiff both are is known by their names; all else below what is around it, as layers.
class LumpLayout
{
    Q_DECLARE_TR_FUNCTIONS(LumpLayout)
  public:
    /// @param first  structures before this row that are felt through their organ stay so, none of them becomes one
    LumpLayout(const palpate::ui::StructureModel& model, const palpate::study::Layering& layering, int first);

    /// Each structure's way of being felt.
    [[nodiscard]] const std::vector<palpate::ui::FeltWay>& ways() const noexcept { return m_ways; }
    /// The same with all in layers.
    [[nodiscard]] std::vector<palpate::ui::FeltWay> inLayers() const;
    /// What a person should know of it, one sentence without its full stop each, lumps first.
    [[nodiscard]] const QStringList& lines() const noexcept { return m_lines; }
    [[nodiscard]] bool isAnyThrough() const noexcept { return m_isAnyThrough; }

  private:
    void layOutLump(int row, int around);
    [[nodiscard]] QString whyNotThrough(int row, int around) const;

    const palpate::ui::StructureModel& m_model;
    std::vector<palpate::ui::FeltWay> m_ways;
    std::vector<std::uint32_t> m_layers;
    std::vector<bool> m_isToBeTold; ///< by the sentences about layers
    QStringList m_lines;
    bool m_isAnyThrough = false;
};
