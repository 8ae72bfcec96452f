// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <QScrollArea>

namespace palpate::ui {

/// Scroll area of a panel, so that no panel enlarges the window beyond the screen.
class PALPATE_EXPORT PanelScroll : public QScrollArea
{
    Q_OBJECT
  public:
    explicit PanelScroll(QWidget* panel, QWidget* parent = nullptr);
    /// Minimum width of the panel plus the scroll bar.
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
};

} // namespace palpate::ui
