// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/ToolTexts.h"

#include <QAction>
#include <QEvent>
#include <QLayout>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>
#include <vector>

namespace palpate::ui {

namespace {

/// Property of buttons that show text when space permits.
constexpr const char* kMayHaveText = "mayHaveText";

/// Width added by a text beside the icon, as in QToolButton::sizeHint. [px]
int textWidth_px(const QToolButton& button)
{
    constexpr int kGap_px = 4;
    const QFontMetrics metrics = button.fontMetrics();
    return kGap_px + metrics.size(Qt::TextShowMnemonic, button.text()).width() +
           2 * metrics.horizontalAdvance(QLatin1Char(' '));
}

} // namespace

ToolTexts::ToolTexts(QToolBar& bar)
    : QObject(&bar)
    , m_bar(bar)
{
    for (const QAction* action : bar.actions()) {
        if (auto* button = qobject_cast<QToolButton*>(bar.widgetForAction(const_cast<QAction*>(action)))) {
            button->setProperty(kMayHaveText, button->toolButtonStyle() == Qt::ToolButtonTextBesideIcon);
        }
    }
    bar.installEventFilter(this);
}

bool ToolTexts::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest) {
        fit();
    }
    return QObject::eventFilter(watched, event);
}

void ToolTexts::fit()
{
    const QMargins margins = m_bar.layout()->contentsMargins();
    int needed = margins.left() + margins.right();
    std::vector<QToolButton*> withText;
    for (QAction* action : m_bar.actions()) {
        QWidget* widget = m_bar.widgetForAction(action);
        auto* button = qobject_cast<QToolButton*>(widget);
        needed += m_bar.layout()->spacing();
        if (button == nullptr || !button->property(kMayHaveText).toBool()) {
            needed += button == nullptr ? widget->minimumSizeHint().width() : widget->sizeHint().width();
            continue;
        }
        const bool hasText = button->toolButtonStyle() == Qt::ToolButtonTextBesideIcon;
        needed += button->sizeHint().width() + (hasText ? 0 : textWidth_px(*button));
        withText.push_back(button);
    }
    std::reverse(withText.begin(), withText.end());
    for (QToolButton* button : withText) {
        const bool hasRoom = needed <= m_bar.width();
        needed -= hasRoom ? 0 : textWidth_px(*button);
        button->setToolButtonStyle(hasRoom ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    }
}

} // namespace palpate::ui
