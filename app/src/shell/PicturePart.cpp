// SPDX-License-Identifier: BSD-3-Clause
#include "shell/PicturePart.h"

#include "shared/Paths.h"
#include "shell/Notices.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/ui/ActionList.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QBuffer>
#include <QMainWindow>

namespace palpate::app {

using ui::ActionGroup;

PicturePart::PicturePart(const WindowCore& core)
    : WindowPart(&core.window)
    , m_core(core)
{
}

void PicturePart::addActions()
{
    ui::ActionList& actions = m_core.actions;
    connect(actions.add("snapshot", ActionGroup::File, tr("Snapshot"), tr("Save a picture of the view"),
                        {QKeySequence(Qt::Key_S)}, ui::Symbol::Snapshot),
            &QAction::triggered, this, &PicturePart::saveSnapshot);
    connect(actions.add("fit", ActionGroup::View, tr("Fit"), tr("Fit everything into the view"),
                        {QKeySequence(Qt::Key_F)}, ui::Symbol::Fit),
            &QAction::triggered, this, [this] {
                m_core.viewport.view().fitAll();
                m_core.viewport.update();
            });
}

void PicturePart::showState(const WindowState& state)
{
    m_core.actions.setEnabled({"snapshot", "fit"}, state.hasScene);
}

void PicturePart::saveSnapshot()
{
    const std::filesystem::path file = newFile(QStandardPaths::PicturesLocation, QStringLiteral(".png"));
    m_core.viewport.refineNext();
    QBuffer bytes;
    const bool isDrawn = m_core.viewport.grabFramebuffer().save(&bytes, "PNG");
    const auto written = core::writeNew(file, {bytes.data().constData(), static_cast<std::size_t>(bytes.size())});
    if (isDrawn && written.isOk()) {
        m_core.notices.say(tr("Picture saved to %1").arg(toText(written.value())), 15000);
    } else {
        m_core.notices.showError(
            tr("%1: the picture could not be written. Is the folder writable and the disk not full?")
                .arg(toText(file)));
    }
}

} // namespace palpate::app

#include "moc_PicturePart.cpp"
