// SPDX-License-Identifier: BSD-3-Clause
#include "FingertipMenu.h"

#include <palpate/ui/LiveTouch.h>

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QLocale>
#include <QMenu>
#include <QSettings>

namespace palpate::app {

namespace {

// A point, probes, and the pad of a finger.
constexpr double kRadii_mm[] = {0.0, 0.5, 1.0, 2.0, 5.0, 8.0};

struct FingertipTexts
{
    Q_DECLARE_TR_FUNCTIONS(palpate::app::Fingertip)
};

} // namespace

void addFingertipMenu(QMenu& menu, ui::LiveTouch& live)
{
    const QString key = QStringLiteral("fingertip_mm");
    live.setFingertip(QSettings().value(key, 0.0).toDouble());
    QMenu* radii = menu.addMenu(FingertipTexts::tr("Fingertip"));
    auto* group = new QActionGroup(radii);
    for (const double radius_mm : kRadii_mm) {
        QAction* action = radii->addAction(
            radius_mm > 0.0 ? FingertipTexts::tr("Ball of %1 mm radius").arg(QLocale().toString(radius_mm))
                            : FingertipTexts::tr("Point"));
        action->setCheckable(true);
        action->setChecked(radius_mm == live.fingertip_mm());
        group->addAction(action);
        QObject::connect(action, &QAction::triggered, &live, [&live, key, radius_mm] {
            live.setFingertip(radius_mm);
            QSettings().setValue(key, radius_mm);
        });
    }
}

} // namespace palpate::app
