// SPDX-License-Identifier: BSD-3-Clause
#include "window/ToolBar.h"

#include "window/MainWindow.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/ChipRow.h>
#include <palpate/ui/Theme.h>
#include <palpate/ui/ToolTexts.h>

#include <QAction>
#include <QToolBar>
#include <QToolButton>

namespace palpate::app {

QToolBar* makeToolBar(ui::ActionList& actions, ui::ChipRow& chips, QWidget* window)
{
    auto* bar = new QToolBar(MainWindow::tr("Tools"), window);
    bar->setObjectName(QStringLiteral("tools"));
    bar->setMovable(false);
    ui::keepIconSize(*bar, 22);
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    const auto add = [&](const char* id, bool hasText) {
        QAction& action = actions.at(id);
        bar->addAction(&action);
        auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(&action));
        button->setToolButtonStyle(hasText ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
        button->setAccessibleName(action.text());
    };
    add("open", true);
    bar->addSeparator();
    for (const char* id : {"palpate", "record", "mark"}) {
        add(id, true);
    }
    add("play", false); // known without a text, whose place the chip of a recording needs
    bar->addSeparator();
    for (const char* id : {"fit", "snapshot", "undo", "redo", "keys"}) {
        add(id, false);
    }
    bar->addWidget(&chips);
    new ui::ToolTexts(*bar);
    return bar;
}

} // namespace palpate::app
