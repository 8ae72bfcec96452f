// SPDX-License-Identifier: BSD-3-Clause
#include "DeskStyle.h"

#include "palpate/ui/Theme.h"

#include <QPainter>
#include <QStyleOption>
#include <QTabBar>

namespace palpate::ui {

namespace {

enum class Edge
{
    Square,
    Round
};

void drawEdge(QPainter& painter, const QStyleOption& option, const QRect& place, Edge edge)
{
    const bool isFocused = option.state.testFlag(QStyle::State_HasFocus);
    const auto group = option.state.testFlag(QStyle::State_Enabled) ? QPalette::Active : QPalette::Disabled;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(
        QPen(option.palette.color(group, isFocused ? QPalette::Highlight : QPalette::Text), isFocused ? 2.0 : 1.0));
    const QRectF frame = QRectF(place).adjusted(0.5, 0.5, -0.5, -0.5);
    if (edge == Edge::Round) {
        painter.drawEllipse(frame);
    } else {
        painter.drawRoundedRect(frame, 2.0, 2.0);
    }
    painter.restore();
}

} // namespace

void DeskStyle::polish(QWidget* widget)
{
    QProxyStyle::polish(widget);
    if (auto* tabs = qobject_cast<QTabBar*>(widget)) {
        tabs->setElideMode(Qt::ElideNone);
        tabs->setUsesScrollButtons(true);
    }
}

void DeskStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                              const QWidget* widget) const
{
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (!isHighContrast()) {
        return;
    }
    switch (element) {
    case PE_PanelButtonCommand:
    case PE_FrameLineEdit:
    case PE_IndicatorCheckBox:
    case PE_FrameMenu:
        drawEdge(*painter, *option, option->rect, Edge::Square);
        break;
    case PE_IndicatorRadioButton:
        drawEdge(*painter, *option, option->rect, Edge::Round);
        break;
    default:
        break;
    }
}

void DeskStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                            const QWidget* widget) const
{
    QProxyStyle::drawControl(element, option, painter, widget);
    if (isHighContrast() && element == CE_TabBarTabShape) {
        drawEdge(*painter, *option, option->rect, Edge::Square);
        if (option->state.testFlag(State_Selected)) { // by more than its height
            constexpr int kMark_px = 3;
            painter->fillRect(QRect(option->rect.topLeft(), QSize(option->rect.width(), kMark_px)),
                              option->palette.color(QPalette::Highlight));
        }
    }
}

void DeskStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                   const QWidget* widget) const
{
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (!isHighContrast()) {
        return;
    }
    switch (control) {
    case CC_ComboBox:
    case CC_SpinBox:
        drawEdge(*painter, *option, option->rect, Edge::Square);
        break;
    case CC_Slider:
        drawEdge(*painter, *option,
                 proxy()->subControlRect(control, option, SC_SliderGroove, widget).adjusted(0, 7, 0, -7), Edge::Square);
        drawEdge(*painter, *option, proxy()->subControlRect(control, option, SC_SliderHandle, widget), Edge::Square);
        break;
    case CC_ScrollBar:
        drawEdge(*painter, *option, proxy()->subControlRect(control, option, SC_ScrollBarSlider, widget), Edge::Square);
        break;
    default:
        break;
    }
}

} // namespace palpate::ui
