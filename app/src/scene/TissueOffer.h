// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate::study {
struct Layering;
}

namespace palpate::ui {
class MessageBar;
class StructureModel;
} // namespace palpate::ui

namespace palpate::app {

/// Applies tissue presets by name to structures from row `first` on, as one undo step. Offers to undo, and to
/// choose a preset for all structures whose names match none.
void applyTissueByName(ui::StructureModel& model, ui::MessageBar& bar, const study::Layering& layering, int first);

} // namespace palpate::app
