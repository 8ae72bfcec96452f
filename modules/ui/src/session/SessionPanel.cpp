// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/SessionPanel.h"

#include "palpate/ui/Theme.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>

namespace palpate::ui {

QString clockText(double seconds)
{
    const long long tenths = std::llround(std::max(0.0, seconds) * 10.0);
    return QStringLiteral("%1:%2%3%4")
        .arg(tenths / 600, 2, 10, QLatin1Char('0'))
        .arg(tenths / 10 % 60, 2, 10, QLatin1Char('0'))
        .arg(QLocale().decimalPoint())
        .arg(tenths % 10);
}

SessionPanel::SessionPanel(QWidget* parent)
    : QWidget(parent)
    , m_timeline(new ForceTimeline(this))
    , m_title(new QLabel(this))
    , m_time(new QLabel(this))
    , m_speed(new QComboBox(this))
    , m_buttons(new QHBoxLayout)
{
    m_title->setTextFormat(Qt::PlainText);
    m_title->setMinimumWidth(10);
    m_time->setAccessibleDescription(tr("Position and length"));
    m_time->setToolTip(tr("Position / length [min:s]"));
    m_time->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    for (const double speed : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0}) {
        m_speed->addItem(tr("%1 ×").arg(QLocale().toString(speed)), speed);
    }
    m_speed->setCurrentIndex(3);
    m_speed->setToolTip(tr("Playback speed; 1 × is real time"));
    m_speed->setAccessibleName(tr("Speed"));

    auto* line = new QHBoxLayout;
    line->setSpacing(6);
    m_buttons->setSpacing(2);
    line->addLayout(m_buttons);
    line->addSpacing(6);
    line->addWidget(m_title, 1);
    line->addWidget(m_time);
    line->addSpacing(6);
    line->addWidget(m_speed);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 4, 12, 8);
    layout->setSpacing(4);
    layout->addLayout(line);
    layout->addWidget(m_timeline, 1);

    connect(m_speed, &QComboBox::currentIndexChanged, this,
            [this](int i) { m_transport.setSpeed(m_speed->itemData(i).toDouble()); });
    connect(m_timeline, &ForceTimeline::seekWanted, this, [this](double position_s) {
        m_transport.seek(position_s);
        refresh();
        Q_EMIT sought();
    });
    showTitle({});
    refresh();
}

void SessionPanel::addAction(QAction* action)
{
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    keepIconSize(*button, 20);
    m_buttons->addWidget(button);
}

void SessionPanel::showTitle(const QString& title)
{
    m_title->setText(title.isEmpty() ? tr("No recording yet. Record one with R, or open a .palpate file.") : title);
    m_title->setToolTip(m_title->text()); // a narrow window elides the text
    m_title->setForegroundRole(title.isEmpty() ? QPalette::PlaceholderText : QPalette::WindowText);
}

void SessionPanel::refresh()
{
    const bool isAny = m_transport.duration_s() > 0.0;
    m_time->setText(
        isAny ? QStringLiteral("%1 / %2").arg(clockText(m_transport.position_s()), clockText(m_transport.duration_s()))
              : QString());
    m_speed->setEnabled(isAny);
    m_timeline->setPosition(m_transport.position_s());
}

void SessionPanel::showRecording(double duration_s, const QString& losses)
{
    m_time->setText(tr("%1, %2").arg(clockText(duration_s), losses));
}

QString lossesText(qulonglong late, qulonglong lost)
{
    return SessionPanel::tr("%1 late, %2 lost").arg(QLocale().toString(late), QLocale().toString(lost));
}

} // namespace palpate::ui

#include "palpate/ui/moc_SessionPanel.cpp"
