// SPDX-License-Identifier: BSD-3-Clause
#include "touch/FingertipMenu.h"

#include <palpate/ui/LiveTouch.h>

#include <QAction>
#include <QCoreApplication>
#include <QLocale>
#include <QMenu>
#include <QSettings>

#include <iterator>
#include <set>

namespace palpate::app {

namespace {

// A point, probes, and a fingertip.
constexpr double kRadii_mm[] = {0.0, 0.5, 1.0, 2.0, 5.0, 8.0};

constexpr auto kKey = "fingertip_mm";

struct FingertipTexts
{
    Q_DECLARE_TR_FUNCTIONS(palpate::app::Fingertip)
};

QString fingertipText(double radius_mm)
{
    return radius_mm > 0.0 ? FingertipTexts::tr("Ball, radius %1 mm").arg(QLocale().toString(radius_mm))
                           : FingertipTexts::tr("Point");
}

/// Rebuilds the entries. The current radius is always listed, also if set by a recording.
void fill(QMenu& menu, ui::LiveTouch& live)
{
    menu.clear();
    std::set<double> radii_mm(std::begin(kRadii_mm), std::end(kRadii_mm));
    radii_mm.insert(live.fingertip_mm());
    for (const double radius_mm : radii_mm) {
        QAction* action = menu.addAction(fingertipText(radius_mm));
        action->setCheckable(true);
        action->setChecked(radius_mm == live.fingertip_mm());
        QObject::connect(action, &QAction::triggered, &live, [&live, radius_mm] {
            live.setFingertip(radius_mm);
            QSettings().setValue(QLatin1String(kKey), radius_mm);
        });
    }
}

} // namespace

double chosenFingertip_mm()
{
    return QSettings().value(QLatin1String(kKey), 0.0).toDouble();
}

void addFingertipMenu(QMenu& menu, ui::LiveTouch& live)
{
    live.setFingertip(chosenFingertip_mm());
    QMenu* radii = menu.addMenu(FingertipTexts::tr("Fingertip"));
    radii->setToolTipsVisible(true);
    radii->menuAction()->setToolTip(
        FingertipTexts::tr("Contact shape: a point feels every facet; a ball slides over small pits like a finger"));
    QObject::connect(radii, &QMenu::aboutToShow, &live, [radii, &live] { fill(*radii, live); });
    fill(*radii, live);
}

} // namespace palpate::app
