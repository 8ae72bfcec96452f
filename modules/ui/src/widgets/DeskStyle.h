// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QProxyStyle>

namespace palpate::ui {

/// Fusion style with corrections. Fusion draws edges in a darker shade of the window colour, which is invisible on
/// black: in high contrast, fields, buttons, boxes, tabs, menus and sliders get an edge in the text colour. Overfull
/// tab bars scroll. Tabs of docked panels are placed closer together, and the longest titles are elided before a tab
/// would be hidden. Fields, lists and sliders take the wheel only with the keyboard focus, so that scrolling a panel
/// changes no value under the pointer.
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
    bool eventFilter(QObject* watched, QEvent* event) override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override;
};

} // namespace palpate::ui
