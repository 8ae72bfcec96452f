// SPDX-License-Identifier: BSD-3-Clause
#include "touch/FingertipPart.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/ChipRow.h>
#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/Translated.h>

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>

#include <iterator>
#include <set>

namespace palpate::app {

namespace {

// A point, probes, and fingertips.
constexpr double kRadii_mm[] = {0.0, 0.5, 1.0, 2.0, 5.0, 8.0};
constexpr double kFinger_mm = 8.0; // about half the width of an index finger

constexpr auto kKey = "fingertip_mm";

QString fingertipText(double radius_mm)
{
    return radius_mm > 0.0 ? FingertipPart::tr("Ball, radius %1 mm").arg(ui::numberText(radius_mm))
                           : FingertipPart::tr("Point");
}

QString shapeTip()
{
    return FingertipPart::tr("Contact shape: a point feels every facet; a ball slides over small pits like a finger");
}

} // namespace

double chosenFingertip_mm()
{
    return QSettings().value(QLatin1String(kKey), kFinger_mm).toDouble();
}

FingertipPart::FingertipPart(const WindowCore& core)
    : WindowPart(&core.window)
    , m_core(core)
    , m_menu(*new QMenu(tr("Fingertip"), &core.window))
    , m_chip(*core.chips.add("fingertip", tr("Fingertip"), 1))
{
    core.live.setFingertip(chosenFingertip_mm());
    m_menu.setToolTipsVisible(true);
    m_chip.setToolTip(shapeTip());
    connect(&m_menu, &QMenu::aboutToShow, this, &FingertipPart::fill);
    connect(&m_chip, &ui::Chip::clicked, this,
            [this] { m_menu.popup(m_chip.mapToGlobal(QPoint(0, m_chip.height()))); });
    connect(&core.live, &ui::LiveTouch::statusChanged, this, &FingertipPart::showChip);
    fill();
    showChip();
}

void FingertipPart::addActions()
{
    m_core.actions.add("fingertip", ui::ActionGroup::Session, m_menu.title(), shapeTip())->setMenu(&m_menu);
}

void FingertipPart::showState(const WindowState& /*state*/)
{
    showChip(); // a recording may have brought its fingertip
}

/// Rebuilds the entries. The current radius is always listed, also if set by a recording.
void FingertipPart::fill()
{
    m_menu.clear();
    std::set<double> radii_mm(std::begin(kRadii_mm), std::end(kRadii_mm));
    radii_mm.insert(m_core.live.fingertip_mm());
    for (const double radius_mm : radii_mm) {
        QAction* action = m_menu.addAction(fingertipText(radius_mm));
        action->setCheckable(true);
        action->setChecked(radius_mm == m_core.live.fingertip_mm());
        connect(action, &QAction::triggered, this, [this, radius_mm] {
            m_core.live.setFingertip(radius_mm);
            QSettings().setValue(QLatin1String(kKey), radius_mm);
            showChip();
        });
    }
}

void FingertipPart::showChip()
{
    const double radius_mm = m_core.live.fingertip_mm();
    const QString number = ui::numberText(radius_mm);
    if (radius_mm > 0.0) {
        m_chip.say(tr("fingertip %1 mm ▾").arg(number), ui::Chip::Tone::Quiet, tr("%1 mm ▾").arg(number));
    } else {
        m_chip.say(tr("fingertip: point ▾"), ui::Chip::Tone::Quiet, tr("point ▾"));
    }
}

} // namespace palpate::app

#include "moc_FingertipPart.cpp"
