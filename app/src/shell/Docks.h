// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <palpate/ui/PanelRound.h>

#include <QString>
#include <QTimer>

#include <vector>

class QDockWidget;
class QMenu;
class QWidget;

namespace palpate::app {

/// Dock widgets of the main window, and the commands that move between them or hide them.
class Docks : public WindowPart
{
    Q_OBJECT
  public:
    /// Panel of the window.
    struct Panel
    {
        QString title;
        const char* name = nullptr; ///< untranslated object name, for the saved layout
        QWidget* content = nullptr; ///< ownership is taken
        Qt::DockWidgetArea area = Qt::RightDockWidgetArea;
        bool isScrollable = true;
    };

    Docks(QMainWindow& window, ui::ActionList& actions);
    void addActions() override;

    /// Adds a panel that is visible at first and has an entry in the View menu. Panels on the right are tabs of one
    /// place.
    QDockWidget& add(const Panel& panel);
    /// Adds a panel that stays hidden until a command shows it.
    QDockWidget& addHidden(const Panel& panel);
    /// Shows or hides a panel of `addHidden`. Unless moved by the user, the panel becomes a tab of the panel of `add`
    /// in the same area.
    void setShown(QDockWidget& dock, bool isShown);
    /// Adds entries at the top of a menu that show and hide the panels of `add`.
    void fill(QMenu& menu) const;
    /// Sets the panel sizes but leaves the larger part of the window to the view. [px]
    void fit(double left_px, double right_px, double below_px);
    /// Scales the panels after a change of the text size. @param ratio  new size / old size
    void scale(double ratio);
    /// Appends a part of the window to those that F6 visits.
    void addToRound(QWidget* part) { m_round.add(part); }
    /// Appends the panels to those that F6 visits, first the panels of `add`.
    void addPanelsToRound();

  private:
    struct Docked
    {
        QDockWidget* dock = nullptr;
        Qt::DockWidgetArea area = Qt::RightDockWidgetArea; ///< at first
    };
    QDockWidget& make(const Panel& panel);
    [[nodiscard]] QDockWidget& firstAt(Qt::DockWidgetArea area) const;
    void toggleAll();
    void fitTitles();
    void detach(int tab);

    QMainWindow& m_window;
    ui::ActionList& m_actions;
    ui::PanelRound m_round;
    QTimer m_fitTitles;           ///< combines all changes of one event
    std::vector<Docked> m_docks;  ///< panels of `add`
    std::vector<Docked> m_hidden; ///< panels of `addHidden`
};

} // namespace palpate::app
