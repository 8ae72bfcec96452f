// SPDX-License-Identifier: BSD-3-Clause
#include "scene/CoordinatesPart.h"

#include "scene/CoordinatesChoice.h"
#include "scene/DocumentPart.h"
#include "scene/SceneFiles.h"
#include "shell/Notices.h"

#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/VtkViewport.h>

#include <QMainWindow>
#include <QToolButton>
#include <QUndoStack>

namespace palpate::app {

CoordinatesPart::CoordinatesPart(const WindowCore& core, DocumentPart& document, SceneFiles& files)
    : WindowPart(&core.window)
    , m_core(core)
    , m_document(document)
    , m_files(files)
{
    connect(&core.model.undoStack(), &QUndoStack::indexChanged, this, [this] { m_isEdited = true; });
}

void CoordinatesPart::addActions()
{
    m_choice = new CoordinatesChoice(m_core.actions, &m_core.window);
    connect(m_choice, &CoordinatesChoice::chosen, this, &CoordinatesPart::readAs);
    connect(&m_core.model, &QAbstractItemModel::modelReset, this, &CoordinatesPart::show);
    connect(&m_core.model, &QAbstractItemModel::rowsInserted, this, &CoordinatesPart::show);
    connect(&m_core.model, &QAbstractItemModel::rowsRemoved, this, &CoordinatesPart::show);
}

QWidget& CoordinatesPart::button() const
{
    return m_choice->button();
}

QString CoordinatesPart::axesText() const
{
    return m_choice->button().text();
}

void CoordinatesPart::readAs(core::FileFrame frame)
{
    if (m_core.model.rowCount() == 0) {
        return;
    }
    if (m_core.live.recording().isRecording) {
        m_core.notices.say(tr("Stop the recording first: it uses the current coordinates."));
        return;
    }
    m_isEdited = false;
    m_files.reopen(m_document.document().inFrame(frame));
}

/// Shows what is known of the patient orientation in the status bar and on the cube in the view.
void CoordinatesPart::show()
{
    m_choice->show(m_core.model.rows(), m_document.isFromRecording());
    m_core.viewport.view().cube().setSidesKnown(m_choice->isKnown());
    m_core.viewport.update();
}

} // namespace palpate::app

#include "moc_CoordinatesPart.cpp"
