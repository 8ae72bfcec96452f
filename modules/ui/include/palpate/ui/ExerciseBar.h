// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <QFrame>

#include <vector>

class QAction;
class QHBoxLayout;
class QLabel;

namespace palpate::ui {

class VtkViewport;

/// State of an exercise in the upper left corner of the view: what to do, clock, force against the ceiling, and
/// buttons.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT ExerciseBar : public QFrame
{
    Q_OBJECT
  public:
    /// Texts of the bar; an empty text hides its label.
    struct Texts
    {
        QString title;        ///< "3 hidden targets"
        QString clock;        ///< "04:12 left"
        QString force;        ///< "2.3 of 5.0 N"
        QString detail;       ///< explanation in words
        bool isAbove = false; ///< the force is above the ceiling
        friend bool operator==(const Texts&, const Texts&) = default;
    };

    /// @param viewport  shows the bar; must outlive it
    explicit ExerciseBar(VtkViewport& viewport);
    void setTexts(const Texts& texts);
    [[nodiscard]] const Texts& texts() const noexcept { return m_texts; }
    /// Replaces the buttons. @param actions  must outlive the bar
    void setActions(const std::vector<QAction*>& actions);

  protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    void place();

    QLabel* m_title = nullptr;
    QLabel* m_clock = nullptr;
    QLabel* m_force = nullptr;
    QLabel* m_detail = nullptr;
    QHBoxLayout* m_buttons = nullptr;
    Texts m_texts;
    std::vector<QAction*> m_actions;
};

} // namespace palpate::ui
