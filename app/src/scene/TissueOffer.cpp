// SPDX-License-Identifier: BSD-3-Clause
#include "scene/TissueOffer.h"

#include <palpate/study/Layers.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/TissueByName.h>

#include <QCoreApplication>

#include <utility>
#include <vector>

namespace palpate::app {

using ui::StructureModel;

namespace {

struct TissueTexts
{
    Q_DECLARE_TR_FUNCTIONS(palpate::app::TissueOffer)
};

/// Message with the number of structures with and without a preset.
QString tissueLine(const StructureModel& model, const std::vector<StructureModel::Edited>& changed)
{
    QString line = changed.size() == 1
                       ? TissueTexts::tr("The tissue of %1 was chosen by its name.")
                             .arg(ui::readableName(changed.front().description.name))
                       : TissueTexts::tr("The tissue of %1 structures was chosen by their names.").arg(changed.size());
    int unnamed = 0;
    for (const study::OpenStructure& row : model.rows()) {
        unnamed += !row.isRemoved && row.loaded.description.tissue == core::Tissue() ? 1 : 0;
    }
    if (unnamed > 0) {
        line += QLatin1Char(' ') +
                TissueTexts::tr("No preset matches the name of %n: “Firm organ”, 0.5 N/mm.", nullptr, unnamed);
    }
    return line;
}

} // namespace

void applyTissueByName(StructureModel& model, ui::MessageBar& bar, const study::Layering& layering, int first)
{
    std::vector<StructureModel::Edited> edits = ui::tissueByName(model, layering, first);
    if (edits.empty()) {
        return;
    }
    std::vector<StructureModel::Edited> before;
    for (const StructureModel::Edited& one : edits) {
        before.push_back({one.row, model.structure(one.row)});
    }
    model.editAll(std::move(edits), TissueTexts::tr("Tissue by name"));
    bar.offer(tissueLine(model, before), TissueTexts::tr("Undo"), [&model, before] {
        std::vector<StructureModel::Edited> back;
        for (const StructureModel::Edited& one : before) { // keeps the current name, layer and colour
            back.push_back({one.row, model.structure(one.row)});
            back.back().description.tissue = one.description.tissue;
            back.back().description.opacity = one.description.opacity;
            back.back().description.palpable = one.description.palpable;
        }
        model.editAll(std::move(back), TissueTexts::tr("Restore tissue"));
    });
}

} // namespace palpate::app
