// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class QToolBar;
class QWidget;

namespace palpate::ui {
class ActionList;
class ChipRow;
} // namespace palpate::ui

namespace palpate::app {

/// Makes the tool bar of the window: the most used commands, and the chips.
/// @param window  owns the tool bar
[[nodiscard]] QToolBar* makeToolBar(ui::ActionList& actions, ui::ChipRow& chips, QWidget* window);

} // namespace palpate::app
