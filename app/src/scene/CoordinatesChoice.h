// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/ui/ActionList.h>
#include <palpate/ui/StructureModel.h>

#include <QObject>

#include <array>
#include <vector>

class QToolButton;

/// Coordinate axes of the open meshes: one command per choice, and a status bar button that shows the assumed axes
/// and whether they are certain.
class CoordinatesChoice : public QObject
{
    Q_OBJECT
  public:
    /// Makes commands and button.
    /// @param actions  gets the commands "frame-lps", "frame-ras" and "frame-y-up" in the View menu
    CoordinatesChoice(palpate::ui::ActionList& actions, QWidget* parent);

    /// Status bar button with a menu of the same commands. Owned by the parent.
    [[nodiscard]] QToolButton& button() const noexcept { return *m_button; }
    /// Shows the axes of the structures.
    /// @param isFixed  true: the surfaces come from a recording, and their axes cannot be changed
    void show(const std::vector<palpate::study::OpenStructure>& rows, bool isFixed);
    /// True if each mesh file states its axes, or the user has chosen them.
    [[nodiscard]] bool isKnown() const noexcept { return m_isKnown; }

  Q_SIGNALS:
    /// The user chose axes. The display changes when the scene has been reloaded and `show` is called.
    void chosen(palpate::core::FileFrame frame);

  private:
    void refresh();

    std::array<QAction*, 3> m_actions{};
    QToolButton* m_button = nullptr;
    std::vector<palpate::core::FileFrame> m_taken; ///< distinct axes of the meshes
    bool m_isKnown = true;
    bool m_isFixed = false;
};
