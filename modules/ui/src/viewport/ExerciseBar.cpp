// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/ExerciseBar.h"

#include "palpate/ui/Theme.h"
#include "palpate/ui/VtkViewport.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace palpate::ui {

namespace {

constexpr int kExerciseMargin_px = 8; // from the edges of the view

void showText(QLabel& label, const QString& text)
{
    label.setText(text);
    label.setVisible(!text.isEmpty());
}

} // namespace

ExerciseBar::ExerciseBar(VtkViewport& viewport)
    : QFrame(&viewport)
    , m_title(new QLabel(this))
    , m_clock(new QLabel(this))
    , m_force(new QLabel(this))
    , m_detail(new QLabel(this))
    , m_buttons(new QHBoxLayout)
{
    setObjectName(QStringLiteral("exerciseBar"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setCursor(Qt::ArrowCursor);
    keepFont(*m_title, 1.0, QFont::DemiBold);
    keepFont(*m_clock, 1.6, QFont::DemiBold);
    for (QLabel* label : {m_title, m_clock, m_force, m_detail}) {
        label->setTextFormat(Qt::PlainText);
    }
    m_clock->setObjectName(QStringLiteral("exerciseClock"));
    m_clock->setAccessibleDescription(tr("Time of the exercise"));
    m_force->setAccessibleDescription(tr("Force and force ceiling of the exercise"));
    m_detail->setWordWrap(true);
    m_detail->setFixedWidth(30 * fontMetrics().averageCharWidth());
    m_buttons->setSpacing(4);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->setSpacing(3);
    for (QLabel* label : {m_title, m_clock, m_force, m_detail}) {
        layout->addWidget(label);
    }
    layout->addLayout(m_buttons);
    hide();
    viewport.installEventFilter(this);
    connect(&viewport, &VtkViewport::coveredAboveChanged, this, &ExerciseBar::place);
}

void ExerciseBar::setTexts(const Texts& texts)
{
    if (texts == m_texts) {
        return;
    }
    m_texts = texts;
    showText(*m_title, texts.title);
    showText(*m_clock, texts.clock);
    showText(*m_force, texts.force);
    showText(*m_detail, texts.detail);
    m_force->setForegroundRole(texts.isAbove ? QPalette::BrightText : QPalette::WindowText); // see Theme.h
    m_force->setMinimumWidth(qMax(m_force->minimumWidth(), m_force->sizeHint().width()));    // the bar must not jump
    place();
}

void ExerciseBar::setActions(const std::vector<QAction*>& actions)
{
    if (actions == m_actions) {
        return;
    }
    m_actions = actions;
    while (QLayoutItem* item = m_buttons->takeAt(0)) {
        if (QWidget* button = item->widget()) {
            button->hide();
            button->deleteLater(); // may be the sender of the current signal
        }
        delete item;
    }
    for (QAction* action : actions) {
        auto* button = new QToolButton(this);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setDefaultAction(action);
        m_buttons->addWidget(button);
    }
    m_buttons->addStretch(1);
    place();
}

bool ExerciseBar::event(QEvent* event)
{
    const bool isTaken = QFrame::event(event);
    if (event->type() == QEvent::LayoutRequest) { // new buttons and fonts get their size only after they are shown
        place();
    }
    return isTaken;
}

bool ExerciseBar::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize && watched == parent()) {
        place();
    }
    return QFrame::eventFilter(watched, event);
}

void ExerciseBar::showEvent(QShowEvent* event)
{
    QFrame::showEvent(event);
    place();
}

void ExerciseBar::place()
{
    m_detail->setFixedHeight(qMax(0, m_detail->heightForWidth(m_detail->maximumWidth())));
    layout()->activate(); // otherwise the size is that of the texts before
    adjustSize();
    move(kExerciseMargin_px, static_cast<const VtkViewport*>(parentWidget())->coveredAbove_px() + kExerciseMargin_px);
    raise();
}

} // namespace palpate::ui

#include "palpate/ui/moc_ExerciseBar.cpp"
