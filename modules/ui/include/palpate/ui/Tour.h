// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFrame>
#include <QPointer>
#include <QRect>

#include <vector>

class QLabel;
class QPushButton;

namespace palpate::ui {

/// Callouts that show parts of a window one after the other, each beside its part, which is framed. Enter goes on,
/// buttons go back and end. The window stays in use meanwhile.
/// @par Thread The GUI's.
class Tour : public QFrame
{
    Q_OBJECT
  public:
    struct Stop
    {
        QPointer<QWidget> part;
        QString title;
        QString text;
    };

    /// @param window  over which the callouts stand; owns this
    explicit Tour(QWidget* window);
    /// Begins with the first stop; a tour that runs begins anew.
    /// @pre there is a stop
    void start(std::vector<Stop> stops);
    /// @return false when none ran
    bool end();
    /// Number of the stop that is shown, from 0.
    [[nodiscard]] int at() const noexcept { return m_at; }
    /// What is pointed at, in the window. Of a part that leaves no room for the callout beside it only the middle.
    [[nodiscard]] QRect target() const noexcept { return m_target; }

  Q_SIGNALS:
    /// A stop is about to be shown: its part may have to come to the front.
    void coming(QWidget* part);
    void ended();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void go(int stop);
    void place();
    [[nodiscard]] bool isPlacedBeside(const QRect& target);

    std::vector<Stop> m_stops;
    QLabel* m_title = nullptr;
    QLabel* m_text = nullptr;
    QPushButton* m_next = nullptr;
    QPushButton* m_back = nullptr;
    QWidget* m_frame = nullptr; ///< round what is pointed at
    QPointer<QWidget> m_before; ///< had the keys before, and gets them back
    QRect m_target;
    int m_at = 0;
};

} // namespace palpate::ui
