// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QProxyStyle>

namespace palpate::ui {

/// Fusion, but where that hides something. It draws edges in a darker shade of the window, which on black is none: in
/// high contrast fields, buttons, boxes, tabs, menus and sliders get an edge in the text's colour. Tabs that have no
/// room for their titles are scrolled; those of panels stand closer, and the longest titles are shortened before one of
/// them would hide.
class DeskStyle final : public QProxyStyle
{
    Q_OBJECT
  public:
    using QProxyStyle::polish;
    using QProxyStyle::QProxyStyle;
    void polish(QWidget* widget) override;
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                           const QWidget* widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override;
};

} // namespace palpate::ui
