// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/LumpLabel.h"

#include "palpate/ui/FeltWords.h"
#include "palpate/ui/TouchPanel.h"
#include "palpate/ui/VtkViewport.h"

#include <palpate/view/LabelLayout.h>

#include <QEvent>
#include <QLabel>

#include <vector>

namespace palpate::ui {

LumpLabel::LumpLabel(VtkViewport& viewport, const TouchPanel& touch, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_touch(touch)
    , m_label(new QLabel(&viewport))
{
    m_label->setObjectName(QStringLiteral("lumpLabel"));
    m_label->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_label->setTextFormat(Qt::PlainText);
    m_label->setAutoFillBackground(true);
    m_label->setBackgroundRole(QPalette::ToolTipBase);
    m_label->setForegroundRole(QPalette::ToolTipText);
    m_label->setMargin(3);
    m_label->hide();
    connect(&touch, &TouchPanel::changed, this, &LumpLabel::show);
    viewport.installEventFilter(this);
}

bool LumpLabel::eventFilter(QObject* watched, QEvent* event)
{
    if ((event->type() == QEvent::FontChange || event->type() == QEvent::Resize) && m_label->isVisible()) {
        QMetaObject::invokeMethod(this, &LumpLabel::show, Qt::QueuedConnection); // when the label has that font, too
    }
    return QObject::eventFilter(watched, event);
}

void LumpLabel::show()
{
    const QString text = lumpText(m_touch.reading());
    view::SceneView& view = m_viewport.view();
    const view::TouchState& state = view.cursor().state();
    const bool isShown = !text.isEmpty() && state.isInContact && state.isPresent;
    m_label->setVisible(isShown);
    if (!isShown) {
        return;
    }
    m_label->setText(text);
    if (m_label->sizeHint().width() > m_viewport.width()) {
        m_label->setText(overLumpText(m_touch.reading()) + QLatin1Char('\n') +
                         verdictPhrase(m_touch.reading().lumpRatio));
    }
    m_label->adjustSize();
    const Eigen::Vector2d half(0.5 * m_viewport.width(), 0.5 * m_viewport.height());
    const view::ViewFrame frame = view::ViewFrame::of(view.renderer(), m_viewport.devicePixelRatioF());
    std::vector<Eigen::AlignedBox2d> taken = view.cursor().labels().boxes();
    for (const Eigen::AlignedBox2d& mark : view.cursor().marks_px(frame)) {
        taken.push_back(mark);
    }
    const Eigen::Vector2d place_px = frame.pixelOf(state.p_WG);
    const Eigen::Vector2d dial_px = Eigen::Vector2d::Constant(view.cursor().arrow().radius_px() + 4.0);
    taken.emplace_back(place_px - dial_px, place_px + dial_px);
    if (view.legend().isShown()) {
        taken.push_back(view.legend().box());
    }
    view::PointLabel layout;
    layout.point_px = place_px;
    layout.size_px = {m_label->width(), m_label->height()};
    layout.towards = {0.0, -1.0}; // below, because the numbers are at the sides
    layout.place = m_place;
    const Eigen::Vector2d centre = view::placeBeside(layout, taken, Eigen::AlignedBox2d(-half, half));
    m_place = layout.place;
    m_label->move(qRound(half.x() + centre.x() - 0.5 * m_label->width()),
                  qRound(half.y() - centre.y() - 0.5 * m_label->height()));
    m_label->raise();
}

} // namespace palpate::ui

#include "palpate/ui/moc_LumpLabel.cpp"
