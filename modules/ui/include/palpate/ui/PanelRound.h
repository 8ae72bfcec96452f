// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <QDockWidget>
#include <QPointer>
#include <QWidget>

#include <vector>

namespace palpate::ui {

/// Focus navigation with F6 and Shift+F6. Moves the keyboard focus between the parts of the window and restores the
/// last focus widget of each part. A tabbed panel is raised while focused.
class PALPATE_EXPORT PanelRound
{
  public:
    /// Appends a part.
    void add(QWidget* part);
    /// Focuses the next visible part. @param step  1: forward, -1: backward
    void go(int step);

  private:
    struct Part
    {
        QPointer<QWidget> widget;
        QPointer<QWidget> last; ///< focus widget when the part was left
    };
    bool isGivenKeys(Part& part);
    std::vector<Part> m_parts;
    QPointer<QDockWidget> m_covered; ///< front panel before another tab was raised
};

/// Frame around a widget that becomes visible with the keyboard focus.
class PALPATE_EXPORT FocusFrame : public QWidget
{
    Q_OBJECT
  public:
    /// @param held  content of the frame; ownership is taken
    /// @param watched  widget whose focus shows the frame
    FocusFrame(QWidget* held, QWidget* watched, QWidget* parent);

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget* m_watched = nullptr;
};

} // namespace palpate::ui
