// SPDX-License-Identifier: BSD-3-Clause
#include "scene/CoordinatesChoice.h"

#include <palpate/ui/Theme.h>

#include <QAction>
#include <QMenu>
#include <QToolButton>

#include <algorithm>

using namespace palpate;
using core::FileFrame;

namespace {

constexpr std::array kFrames{FileFrame::Lps, FileFrame::Ras, FileFrame::YUp};

/// Display name of the axes.
QString axes(FileFrame frame)
{
    switch (frame) {
    case FileFrame::Ras:
        return CoordinatesChoice::tr("RAS");
    case FileFrame::YUp:
        return CoordinatesChoice::tr("Y up");
    case FileFrame::Untagged:
    case FileFrame::Lps:
        break;
    }
    return CoordinatesChoice::tr("LPS");
}

} // namespace

CoordinatesChoice::CoordinatesChoice(ui::ActionList& actions, QWidget* parent)
    : QObject(parent)
    , m_button(new QToolButton(parent))
{
    using ui::ActionGroup;
    actions.addSubmenu(ActionGroup::View, tr("Coordinates of the files"), ActionGroup::Coordinates);
    m_actions = {actions.add("frame-lps", ActionGroup::Coordinates, tr("LPS: left, posterior, superior"),
                             tr("File axes point left, posterior and superior, as in DICOM")),
                 actions.add("frame-ras", ActionGroup::Coordinates, tr("RAS: right, anterior, superior"),
                             tr("File axes point right, anterior and superior, as in older 3D Slicer models")),
                 actions.add("frame-y-up", ActionGroup::Coordinates, tr("Y up: left, superior, anterior"),
                             tr("File axes point left, superior and anterior, as in 3D modelling programs"))};
    auto* menu = new QMenu(m_button);
    for (std::size_t i = 0; i < m_actions.size(); ++i) {
        m_actions[i]->setCheckable(true);
        connect(m_actions[i], &QAction::triggered, this, [this, i] {
            const bool isSaid = m_isKnown && m_taken == std::vector{kFrames[i]};
            refresh(); // the check mark does not move until the scene has been reloaded
            if (!isSaid) {
                Q_EMIT chosen(kFrames[i]);
            }
        });
        menu->addAction(m_actions[i]);
    }
    m_button->setMenu(menu);
    m_button->setPopupMode(QToolButton::InstantPopup);
    m_button->setAutoRaise(true);
    m_button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_button->setFocusPolicy(Qt::TabFocus);
    show({}, false);
}

void CoordinatesChoice::show(const std::vector<study::OpenStructure>& rows, bool isFixed)
{
    m_taken.clear();
    m_isKnown = true;
    m_isFixed = isFixed || rows.empty();
    for (const study::OpenStructure& row : rows) {
        const FileFrame said = core::resolvedFrame(row.loaded.description.frame, row.loaded.frame);
        m_isKnown = m_isKnown && said != FileFrame::Untagged;
        const FileFrame taken = said == FileFrame::Untagged ? FileFrame::Lps : said;
        if (std::find(m_taken.begin(), m_taken.end(), taken) == m_taken.end()) {
            m_taken.push_back(taken);
        }
    }
    m_button->setVisible(!rows.empty());
    refresh();
}

void CoordinatesChoice::refresh()
{
    for (std::size_t i = 0; i < m_actions.size(); ++i) {
        m_actions[i]->setChecked(m_isKnown && m_taken == std::vector{kFrames[i]});
        m_actions[i]->setEnabled(!m_isFixed);
    }
    QStringList names;
    for (const FileFrame frame : m_taken) {
        names << axes(frame);
    }
    const QString taken = names.join(tr(" and "));
    m_button->setIcon(m_isKnown ? QIcon() : ui::icon(ui::Symbol::Warning));
    m_button->setText(m_isKnown ? taken : tr("%1 assumed").arg(taken));
    m_button->setEnabled(!m_isFixed);
    const QString what = m_isKnown ? tr("The files use %1 coordinates.").arg(taken)
                                   : tr("Some files do not state their axes. %1 is assumed; left and right may be "
                                        "swapped. Click to choose the axes.")
                                         .arg(taken);
    m_button->setToolTip(m_isFixed ? tr("The surfaces belong to a recording and keep their recorded coordinates.")
                                   : what);
    m_button->setAccessibleName(tr("Coordinates: %1").arg(m_button->text()));
    m_button->setAccessibleDescription(m_button->toolTip());
}

#include "moc_CoordinatesChoice.cpp"
