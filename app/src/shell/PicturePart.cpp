// SPDX-License-Identifier: BSD-3-Clause
#include "shell/PicturePart.h"

#include "shared/Paths.h"
#include "shell/Notices.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/ui/ActionList.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QBuffer>
#include <QClipboard>
#include <QDateTime>
#include <QFontInfo>
#include <QFontMetrics>
#include <QGuiApplication>
#include <QImage>
#include <QLocale>
#include <QMainWindow>
#include <QPainter>

#include <vector>

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
    connect(actions.add("snapshot", ActionGroup::File, tr("Snapshot"),
                        tr("Save a picture of the view with a caption, and copy it"), {QKeySequence(Qt::Key_S)},
                        ui::Symbol::Snapshot),
            &QAction::triggered, this, &PicturePart::saveSnapshot);
    connect(actions.add("fit", ActionGroup::View, tr("Fit"), tr("Fit everything into the view"),
                        {QKeySequence(Qt::Key_F)}, ui::Symbol::Fit),
            &QAction::triggered, this, [this] {
                m_core.viewport.view().fitAll();
                m_core.viewport.update();
            });
    actions.addSubmenu(ActionGroup::View, tr("Standard views"), ActionGroup::Directions);
    actions.addSeparator(ActionGroup::View);
}

void PicturePart::showState(const WindowState& state)
{
    m_core.actions.setEnabled({"snapshot", "fit"}, state.hasScene);
}

/// Adds a caption below a picture: title of the window and time, and the visible structures with their colours.
QImage PicturePart::captioned(const QImage& picture, double scale) const
{
    QFont font = m_core.viewport.font();
    font.setPixelSize(qRound(scale * QFontInfo(font).pixelSize()));
    const QFontMetrics metrics(font);
    const int margin = metrics.height() / 2, line = metrics.height() + margin / 2, swatch = metrics.ascent();
    struct Entry
    {
        QString name;
        QColor colour;
        QPoint at;
    };
    std::vector<Entry> entries;
    QPoint at(margin, margin + line);
    for (int row = 0; row < m_core.model.rowCount(); ++row) {
        const view::Appearance look = m_core.model.appearanceOf(row);
        if (!look.isVisible || !(look.opacity > 0.0)) {
            continue;
        }
        const QString name = metrics.elidedText(ui::readableName(m_core.model.structure(row).name), Qt::ElideMiddle,
                                                picture.width() / 2);
        const int wide = swatch + margin / 2 + metrics.horizontalAdvance(name) + 2 * margin;
        constexpr int kMostLines = 4; // the scene of a whole body has hundreds of structures
        if (at.x() > margin && at.x() + wide > picture.width()) {
            at = QPoint(margin, at.y() + line);
        }
        if (at.y() >= margin + (kMostLines + 1) * line) {
            break;
        }
        entries.push_back({name, ui::colourOf(m_core.model.structure(row)), at});
        at.rx() += wide;
    }
    const int below = (entries.empty() ? margin : entries.back().at.y()) + line + margin / 2;
    QImage whole(picture.width(), picture.height() + below, QImage::Format_RGB32);
    whole.fill(Qt::white);
    QPainter painter(&whole);
    painter.drawImage(0, 0, picture);
    painter.translate(0, picture.height());
    painter.setFont(font);
    const QString title = m_core.window.windowTitle().remove(QStringLiteral("[*]"));
    const QString when = QLocale().toString(QDateTime::currentDateTime(), QLocale::ShortFormat);
    painter.drawText(
        margin, margin + metrics.ascent(),
        metrics.elidedText(title + QStringLiteral(" · ") + when, Qt::ElideMiddle, picture.width() - 2 * margin));
    for (const Entry& entry : entries) {
        painter.fillRect(QRect(entry.at, QSize(swatch, swatch)), entry.colour);
        painter.drawText(entry.at + QPoint(swatch + margin / 2, metrics.ascent()), entry.name);
    }
    return whole;
}

/// Saves a picture with twice the resolution of the view, and copies it.
void PicturePart::saveSnapshot()
{
    constexpr double kScale = 2.0;
    const std::filesystem::path file = newFile(QStandardPaths::PicturesLocation, QStringLiteral(".png"));
    const QImage picture = m_core.viewport.picture(kScale);
    const QImage whole = picture.isNull() ? picture : captioned(picture, kScale * m_core.viewport.devicePixelRatioF());
    QBuffer bytes;
    const bool isDrawn = whole.save(&bytes, "PNG");
    const auto written = core::writeNew(file, {bytes.data().constData(), static_cast<std::size_t>(bytes.size())});
    if (isDrawn && written.isOk()) {
        QGuiApplication::clipboard()->setImage(whole);
        m_core.notices.say(tr("Picture copied, and saved to %1").arg(toText(written.value())), 15000);
    } else {
        m_core.notices.showError(
            tr("%1: the picture could not be written. Is the folder writable and the disk not full?")
                .arg(toText(file)));
    }
}

} // namespace palpate::app

#include "moc_PicturePart.cpp"
