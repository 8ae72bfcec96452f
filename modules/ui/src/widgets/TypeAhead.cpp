// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TypeAhead.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>

namespace palpate::ui {

TypeAhead::TypeAhead(QWidget* window)
    : QObject(window)
{
    QApplication::instance()->installEventFilter(this);
}

bool TypeAhead::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::ShortcutOverride) {
        return false;
    }
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (widget == nullptr || widget->window() != parent()) {
        return false;
    }
    const bool isList =
        qobject_cast<const QAbstractItemView*>(widget) != nullptr || qobject_cast<const QComboBox*>(widget) != nullptr;
    const bool hasEnds = isList || qobject_cast<const QAbstractSlider*>(widget) != nullptr ||
                         qobject_cast<const QLabel*>(widget) != nullptr; // labels with selectable text
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool isPlain = (key->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) == 0;
    const bool isTyped = !key->text().isEmpty() && key->text().front().isPrint();
    const bool isEnd = key->key() == Qt::Key_Home || key->key() == Qt::Key_End;
    if (isPlain && ((isList && isTyped) || (hasEnds && isEnd))) {
        event->accept(); // delivered as a key press instead of a shortcut
        return true;
    }
    return false;
}

} // namespace palpate::ui

#include "palpate/ui/moc_TypeAhead.cpp"
