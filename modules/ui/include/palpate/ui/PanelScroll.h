// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QScrollArea>

namespace palpate::ui {

/// Holds a panel and scrolls it where the window has no room for all of it, so that no panel makes the window larger
/// than the screen.
class PanelScroll : public QScrollArea
{
    Q_OBJECT
  public:
    explicit PanelScroll(QWidget* panel, QWidget* parent = nullptr);
    /// As wide as the panel at its narrowest, with the scroll bar.
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
};

} // namespace palpate::ui
