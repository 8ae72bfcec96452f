// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TypeAhead.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>

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
    if (widget == nullptr || widget->window() != parent() ||
        (qobject_cast<const QAbstractItemView*>(widget) == nullptr &&
         qobject_cast<const QComboBox*>(widget) == nullptr)) {
        return false;
    }
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool isPlain = (key->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) == 0;
    const bool isTyped = !key->text().isEmpty() && key->text().front().isPrint();
    if (isPlain && (isTyped || key->key() == Qt::Key_Home || key->key() == Qt::Key_End)) {
        event->accept(); // it comes as a key, not as a command
        return true;
    }
    return false;
}

} // namespace palpate::ui
