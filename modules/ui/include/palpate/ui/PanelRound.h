// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDockWidget>
#include <QPointer>
#include <QWidget>

#include <vector>

namespace palpate::ui {

/// F6 and Shift+F6: the keys go from one part of the window to the next, and come back to where they were in it. A
/// panel behind another one's tab comes to the front while the keys are in it.
class PanelRound
{
  public:
    /// Adds a part after those there are.
    void add(QWidget* part);
    /// Gives the keys to the next part that is shown. @param step  1: the next, -1: the one before
    void go(int step);

  private:
    struct Part
    {
        QPointer<QWidget> widget;
        QPointer<QWidget> last; ///< had the keys when the part was left
    };
    bool isGivenKeys(Part& part);
    std::vector<Part> m_parts;
    QPointer<QDockWidget> m_covered; ///< was in front before one behind it got the keys
};

/// A narrow frame round what it holds, which shows when the keys go there.
class FocusFrame : public QWidget
{
    Q_OBJECT
  public:
    /// @param held     what stands in the frame; taken over
    /// @param watched  what has the keys when the frame shows
    FocusFrame(QWidget* held, QWidget* watched, QWidget* parent);

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget* m_watched = nullptr;
};

} // namespace palpate::ui
