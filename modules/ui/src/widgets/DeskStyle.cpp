// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/DeskStyle.h"

#include "palpate/ui/Theme.h"
#include "widgets/CutCells.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QMainWindow>
#include <QPainter>
#include <QSlider>
#include <QStyle>
#include <QStyleOption>
#include <QTabBar>

#include <algorithm>
#include <vector>

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

/// True for the tab bar of tabified dock panels.
bool isOfPanels(const QWidget* tabs)
{
    return qobject_cast<const QTabBar*>(tabs) != nullptr &&
           qobject_cast<const QMainWindow*>(tabs->parentWidget()) != nullptr;
}

/// True for widgets whose value the wheel changes.
bool turnsByWheel(const QWidget* widget)
{
    return qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
           qobject_cast<const QComboBox*>(widget) != nullptr || qobject_cast<const QSlider*>(widget) != nullptr;
}

int titleWidth(const QTabBar& tabs, const QString& title)
{
    return tabs.fontMetrics().size(Qt::TextShowMnemonic, title).width();
}

/// Maximum tab width such that eliding only the longest titles makes all tabs fit.
/// @param beside_px  tab width without the title
int widestTab(const QTabBar& tabs, int beside_px)
{
    std::vector<int> widths;
    for (int i = 0; i < tabs.count(); ++i) {
        widths.push_back(titleWidth(tabs, tabs.tabText(i)) + beside_px);
    }
    std::sort(widths.begin(), widths.end());
    int left = tabs.width();
    // Water filling: short titles keep their width, longer ones share the rest.
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const int share = left / static_cast<int>(widths.size() - i);
        if (widths[i] > share) {
            return share;
        }
        left -= widths[i];
    }
    return tabs.width();
}

} // namespace

void DeskStyle::polish(QWidget* widget)
{
    QProxyStyle::polish(widget);
    if (auto* tabs = qobject_cast<QTabBar*>(widget)) {
        // Every dock panel must stay visible, if necessary with an elided title; the tool tip shows the full title.
        // Other tab bars keep full titles and scroll.
        tabs->setElideMode(isOfPanels(tabs) ? Qt::ElideRight : Qt::ElideNone);
        tabs->setUsesScrollButtons(!isOfPanels(tabs));
    }
    auto* cells = qobject_cast<QAbstractItemView*>(widget);
    if (cells != nullptr && qobject_cast<QHeaderView*>(widget) == nullptr &&
        cells->findChild<QObject*>(QLatin1String(CutCells::kName), Qt::FindDirectChildrenOnly) ==
            nullptr) { // styles change
        new CutCells(*cells);
    }
    if (turnsByWheel(widget)) {
        if (widget->focusPolicy() == Qt::WheelFocus) {
            widget->setFocusPolicy(Qt::StrongFocus); // the wheel itself must not give the focus
        }
        widget->installEventFilter(this);
    }
}

/// Passes the wheel over a widget without focus to the scrolled panel around the widget.
bool DeskStyle::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
        event->ignore();
        return true;
    }
    return QProxyStyle::eventFilter(watched, event);
}

int DeskStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const
{
    constexpr int kTabBeside_px = 12; // horizontal padding of a title, sum of both sides
    return metric == PM_TabBarTabHSpace && isOfPanels(widget) ? kTabBeside_px
                                                              : QProxyStyle::pixelMetric(metric, option, widget);
}

QSize DeskStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                                  const QWidget* widget) const
{
    QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
    const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option);
    if (type == CT_TabBarTab && tab != nullptr && isOfPanels(widget)) {
        const auto& tabs = static_cast<const QTabBar&>(*widget);
        size.setWidth(std::min(size.width(), widestTab(tabs, size.width() - titleWidth(tabs, tab->text))));
    }
    return size;
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
        if (option->state.testFlag(State_Selected)) { // selection must not be visible by height alone
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

#include "moc_DeskStyle.cpp"
