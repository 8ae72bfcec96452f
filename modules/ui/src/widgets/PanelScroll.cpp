// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/PanelScroll.h"

#include <QFrame>
#include <QScrollBar>

#include <algorithm>

namespace palpate::ui {

PanelScroll::PanelScroll(QWidget* panel, QWidget* parent)
    : QScrollArea(parent)
{
    setWidget(panel);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus); // the content takes the focus and is scrolled into view
}

QSize PanelScroll::sizeHint() const
{
    return widget()->sizeHint() + QSize(verticalScrollBar()->sizeHint().width(), 0);
}

QSize PanelScroll::minimumSizeHint() const
{
    constexpr int kMostWidth_px = 260; // narrower panels also scroll horizontally
    constexpr int kHeight_px = 60;
    const QSize held = widget()->minimumSizeHint() + QSize(verticalScrollBar()->sizeHint().width(), 0);
    return {std::min(kMostWidth_px, held.width()), std::min(kHeight_px, held.height())};
}

} // namespace palpate::ui

#include "palpate/ui/moc_PanelScroll.cpp"
