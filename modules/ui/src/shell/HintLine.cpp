// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/HintLine.h"

#include <QAccessible>
#include <QMouseEvent>

#include <algorithm>

namespace palpate::ui {

HintLine::HintLine(QWidget* parent)
    : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setMinimumWidth(10);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    setCursor(Qt::PointingHandCursor);
    setAccessibleDescription(tr("Latest message; F4 shows all"));
}

void HintLine::say(const QString& text)
{
    m_said = text;
    setToolTip(text.isEmpty() ? QString()
                              : tr("%1\n"
                                   "Click here or press F4 for all messages")
                                    .arg(text));
    fit();
    if (!text.isEmpty()) {
        setAccessibleName(text); // full text, since the visible text may be elided
        QAccessibleEvent alert(this, QAccessible::Alert);
        QAccessible::updateAccessibility(&alert);
    } else {
        setAccessibleName(tr("No new messages"));
    }
}

void HintLine::fit()
{
    setText(fontMetrics().elidedText(m_said, Qt::ElideRight, std::max(10, contentsRect().width())));
}

void HintLine::resizeEvent(QResizeEvent* event)
{
    QLabel::resizeEvent(event);
    fit();
}

void HintLine::mouseReleaseEvent(QMouseEvent* event)
{
    if (rect().contains(event->position().toPoint())) {
        Q_EMIT pressed();
    }
}

} // namespace palpate::ui

#include "palpate/ui/moc_HintLine.cpp"
