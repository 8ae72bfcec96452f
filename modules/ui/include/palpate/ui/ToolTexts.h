// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

class QToolBar;
class QToolButton;

namespace palpate::ui {

/// Takes the texts from a tool bar's buttons, the last first, where there is no room for them: else Qt would put what
/// stands at the bar's end, such as the chips, behind a button.
class ToolTexts : public QObject
{
  public:
    /// @param bar  whose buttons have both icon and text where they show one; it owns this
    explicit ToolTexts(QToolBar& bar);

    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void fit();

    QToolBar& m_bar;
};

} // namespace palpate::ui
