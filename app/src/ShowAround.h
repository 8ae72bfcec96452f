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

/// *Help › Show me around*: four callouts on the list of structures, the view, the touch and the findings. Nothing that
/// is open is touched; where nothing is, the phantom is opened first.
class ShowAround : public QObject
{
    Q_OBJECT
  public:
    /// @param window  over which the callouts stand; owns this. Its panels are known by their names.
    /// @param view    the 3D view in it
    ShowAround(QMainWindow* window, ui::ActionList& actions, QWidget* view);

    [[nodiscard]] ui::Tour& tour() noexcept { return *m_tour; }
    /// @param hasScene   something is open and shown
    /// @param isOpening  something is being opened: the callouts wait for it
    void begin(bool hasScene, bool isOpening);
    /// What was being opened is drawn: the callouts begin, if they wait for it.
    void goOn();
    /// What was asked for does not come.
    void giveUp() { m_isWaiting = false; }

  Q_SIGNALS:
    /// The command was given.
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
    bool m_isPhantom = false; ///< opened for this
};

} // namespace palpate::app
