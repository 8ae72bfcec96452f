// SPDX-License-Identifier: BSD-3-Clause
#include "scene/TissueOffer.h"

#include <palpate/study/HapticCopy.h>
#include <palpate/study/Layers.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/TissueByName.h>
#include <palpate/ui/TissuePresets.h>

#include <QCoreApplication>
#include <QCursor>
#include <QMenu>
#include <QStringList>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace palpate::app {

using ui::StructureModel;

namespace {

struct TissueTexts
{
    Q_DECLARE_TR_FUNCTIONS(palpate::app::TissueOffer)
};

/// Palpable structures from row `first` on whose names match no preset.
std::vector<int> unmatchedRows(const StructureModel& model, int first)
{
    std::vector<int> rows;
    for (int row = first; row < model.rowCount(); ++row) {
        const study::OpenStructure& one = model.rows()[static_cast<std::size_t>(row)];
        if (!one.isRemoved && study::canBeFelt(one.loaded.description) &&
            one.loaded.description.tissue == core::Tissue() && one.loaded.maps.empty()) {
            rows.push_back(row);
        }
    }
    return rows;
}

/// Number of structures of which names have set each property.
struct ByName
{
    std::size_t tissue = 0, passedThrough = 0, opacity = 0;
    std::string one; ///< name of a structure whose tissue was set

    ByName(const StructureModel& model, const std::vector<StructureModel::Edited>& edits)
    {
        for (const StructureModel::Edited& edit : edits) {
            const meshio::SceneStructure& before = model.structure(edit.row);
            if (edit.description.tissue != before.tissue) {
                one = before.name;
                ++tissue;
            }
            passedThrough += before.palpable && !edit.description.palpable ? 1 : 0;
            opacity += edit.description.opacity != before.opacity ? 1 : 0;
        }
    }
};

/// Message with the number of structures with and without a preset.
QString tissueLine(const ByName& named, std::size_t unmatched)
{
    QStringList lines;
    if (named.tissue == 1) {
        lines << TissueTexts::tr("The tissue of %1 was chosen by its name.").arg(ui::readableName(named.one));
    } else if (named.tissue > 1) {
        lines << TissueTexts::tr("The tissue of %1 structures was chosen by their names.").arg(named.tissue);
    }
    if (named.passedThrough > 0) {
        lines << TissueTexts::tr("Vessels, nerves and ducts that are not felt: %1.").arg(named.passedThrough);
    }
    if (unmatched > 0) {
        lines << TissueTexts::tr("No preset matches the name of %n: “Firm organ”, 0.5 N/mm.", nullptr,
                                 static_cast<int>(unmatched));
    }
    if (lines.isEmpty() && named.opacity > 0) {
        lines << TissueTexts::tr("Opacities chosen by name: %1.").arg(named.opacity);
    }
    return lines.join(QLatin1Char(' '));
}

/// Opens a menu of presets at the pointer and applies the chosen one to those of the rows that are still unmatched.
void chooseForAll(StructureModel& model, ui::MessageBar& bar, int first)
{
    auto* menu = new QMenu(&bar);
    menu->setObjectName(QStringLiteral("tissueForAll"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const ui::TissuePreset& preset : ui::tissuePresets()) {
        menu->addAction(ui::StructurePanel::tr(preset.name), &model, [&model, &preset, first] {
            std::vector<StructureModel::Edited> edits;
            for (const int row : unmatchedRows(model, first)) {
                edits.push_back({row, model.structure(row)});
                core::Tissue& tissue = edits.back().description.tissue;
                tissue = ui::withPreset(tissue, preset);
            }
            model.editAll(std::move(edits), TissueTexts::tr("Choose the tissue of unknown names"));
        });
    }
    menu->popup(QCursor::pos());
}

} // namespace

void applyTissueByName(StructureModel& model, ui::MessageBar& bar, const study::Layering& layering, int first)
{
    std::vector<StructureModel::Edited> edits = ui::tissueByName(model, layering, first);
    const ByName named(model, edits);
    std::vector<StructureModel::Edited> before;
    for (const StructureModel::Edited& one : edits) {
        before.push_back({one.row, model.structure(one.row)});
    }
    if (!edits.empty()) {
        model.editAll(std::move(edits), TissueTexts::tr("Tissue by name"));
    }
    const std::size_t unmatched = unmatchedRows(model, first).size();
    const QString line = tissueLine(named, unmatched), all = TissueTexts::tr("Choose for all…");
    const auto choose = [&model, &bar, first] { chooseForAll(model, bar, first); };
    if (before.empty()) {
        if (unmatched > 1) { // the panel shows the tissue of a single structure
            bar.offer(line, all, choose);
        }
        return;
    }
    const auto undo = [&model, before] {
        std::vector<StructureModel::Edited> back;
        for (const StructureModel::Edited& one : before) { // keeps the current name, layer and colour
            back.push_back({one.row, model.structure(one.row)});
            back.back().description.tissue = one.description.tissue;
            back.back().description.opacity = one.description.opacity;
            back.back().description.palpable = one.description.palpable;
        }
        model.editAll(std::move(back), TissueTexts::tr("Restore tissue"));
    };
    if (unmatched == 0) {
        bar.offer(line, TissueTexts::tr("Undo"), undo);
    } else {
        bar.ask(line, TissueTexts::tr("Undo"), undo, all, choose);
    }
}

} // namespace palpate::app
