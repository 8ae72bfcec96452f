// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <QFrame>
#include <QPointer>
#include <QRect>

#include <vector>

class QLabel;
class QPushButton;

namespace palpate::ui {

/// Guided tour with callouts next to the framed parts of a window. Enter continues; buttons go back and end the tour.
/// The window stays usable.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT Tour : public QFrame
{
    Q_OBJECT
  public:
    struct Stop
    {
        QPointer<QWidget> part;
        QString title;
        QString text;
    };

    /// @param window  parent of the callouts; owns this object
    explicit Tour(QWidget* window);
    /// Starts at the first stop; restarts a running tour.
    /// @pre `stops` is not empty
    void start(std::vector<Stop> stops);
    /// Ends the tour. Returns false when no tour was running.
    bool end();
    /// Index of the current stop, from 0.
    [[nodiscard]] int at() const noexcept { return m_at; }
    /// Highlighted rectangle in window coordinates. For a part that leaves no space for the callout, only the central
    /// region.
    [[nodiscard]] QRect target() const noexcept { return m_target; }

  Q_SIGNALS:
    /// Emitted before a stop is shown, so that the part can be raised.
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
    QWidget* m_frame = nullptr; ///< around the target
    QPointer<QWidget> m_before; ///< previous focus widget, restored at the end
    QRect m_target;
    int m_at = 0;
};

} // namespace palpate::ui
