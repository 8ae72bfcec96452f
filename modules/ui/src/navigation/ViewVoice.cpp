// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/ViewVoice.h"

#include "palpate/ui/TouchPanel.h"

namespace palpate::ui {

ViewVoice::ViewVoice(QWidget& view, const TouchPanel& touch, QObject* parent)
    : QObject(parent)
    , m_view(view)
    , m_touch(touch)
    , m_pace([this] { say(); })
{
    connect(&touch, &TouchPanel::changed, this, [this] { m_pace.want(); });
    say();
}

void ViewVoice::say()
{
    const TouchReading& reading = m_touch.reading();
    const QString name =
        reading.structure.isEmpty() ? tr("3D view") : tr("3D view: %1, %2").arg(reading.structure, touchText(reading));
    if (name != m_view.accessibleName()) {
        m_view.setAccessibleName(name);
    }
}

} // namespace palpate::ui

#include "palpate/ui/moc_ViewVoice.cpp"
