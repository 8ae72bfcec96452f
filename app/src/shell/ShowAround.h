// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

class QMainWindow;
class QWidget;

namespace palpate::ui {
class ActionList;
class Tour;
} // namespace palpate::ui

namespace palpate::app {

/// Guided tour, *Help › Show me around*: four callouts on structure list, view, touch panel and findings. The open
/// scene is not changed; without a scene, the phantom is opened first.
class ShowAround : public QObject
{
    Q_OBJECT
  public:
    /// Makes the command. @param window  shows the callouts; owns this. Panels are found by object name.
    /// @param view  the 3D view of the window
    ShowAround(QMainWindow* window, ui::ActionList& actions, QWidget* view);

    [[nodiscard]] ui::Tour& tour() noexcept { return *m_tour; }
    /// Starts the tour. @param hasScene   true: a scene is open and shown
    /// @param isOpening  true: a scene is being opened, and the tour waits for it
    void begin(bool hasScene, bool isOpening);
    /// Call when the opened scene is shown: starts a waiting tour.
    void goOn();
    /// Call when opening failed or was cancelled.
    void giveUp() { m_isWaiting = false; }

  Q_SIGNALS:
    /// The command was triggered.
    void wanted();
    void phantomWanted();

  private:
    void start();
    [[nodiscard]] QWidget* panel(const char* name) const;
    static void bringForward(QWidget* part);

    QMainWindow* m_window = nullptr;
    QWidget* m_view = nullptr;
    ui::Tour* m_tour = nullptr;
    bool m_isWaiting = false;
    bool m_isPhantom = false; ///< opened for the tour
};

} // namespace palpate::app
