// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/ui/ActionList.h>
#include <palpate/ui/StructureModel.h>

#include <QObject>

#include <array>
#include <vector>

class QToolButton;

/// Along which axes the open meshes lie: a command for each choice, and a button for the status bar that says what they
/// are taken for and whether anybody knows it.
class CoordinatesChoice : public QObject
{
    Q_OBJECT
  public:
    /// @param actions  gets the commands "frame-lps", "frame-ras" and "frame-y-up", in the menu View
    CoordinatesChoice(palpate::ui::ActionList& actions, QWidget* parent);

    /// The button; its menu holds the same commands. The parent owns it.
    [[nodiscard]] QToolButton& button() const noexcept { return *m_button; }
    /// Shows what the structures are taken for.
    /// @param isFixed  the surfaces are a recording's, which stay as they were felt
    void show(const std::vector<palpate::ui::StructureRow>& rows, bool isFixed);
    /// True when each mesh says its axes itself, or they were chosen.
    [[nodiscard]] bool isKnown() const noexcept { return m_isKnown; }

  Q_SIGNALS:
    /// A person said it. What is shown changes when the scene has been read again and `show` is called.
    void chosen(palpate::core::FileFrame frame);

  private:
    void refresh();

    std::array<QAction*, 3> m_actions{};
    QToolButton* m_button = nullptr;
    std::vector<palpate::core::FileFrame> m_taken; ///< each that some mesh is taken for, once
    bool m_isKnown = true;
    bool m_isFixed = false;
};
