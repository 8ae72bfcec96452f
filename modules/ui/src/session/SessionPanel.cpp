// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/SessionPanel.h"

#include "palpate/ui/Theme.h"
#include "palpate/ui/Translated.h"

#include <QAction>
#include <QColor>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <initializer_list>

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
    , m_secondTimeline(new ForceTimeline(this))
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
        m_speed->addItem(tr("%1 ×").arg(numberText(speed)), speed);
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
    m_letterA = letter(QStringLiteral("A"), view::kFirstColour);
    m_letterB = letter(QStringLiteral("B"), view::kSecondColour);
    m_secondTimeline->setAccessibleName(tr("Force timeline of the second recording"));
    auto* lanes = new QGridLayout;
    lanes->setSpacing(2);
    lanes->addWidget(m_letterA, 0, 0);
    lanes->addWidget(m_timeline, 0, 1);
    lanes->addWidget(m_letterB, 1, 0);
    lanes->addWidget(m_secondTimeline, 1, 1);
    lanes->setColumnStretch(1, 1);
    layout->addLayout(lanes, 1);

    connect(m_speed, &QComboBox::currentIndexChanged, this, [this](int i) {
        m_transport.setSpeed(m_speed->itemData(i).toDouble());
        m_secondTransport.setSpeed(m_speed->itemData(i).toDouble());
    });
    connect(m_timeline, &ForceTimeline::seekWanted, this, [this](double position_s) {
        m_transport.seek(position_s);
        refresh();
        Q_EMIT sought();
    });
    connect(m_secondTimeline, &ForceTimeline::seekWanted, this, [this](double position_s) {
        m_secondTransport.seek(position_s);
        refresh();
        Q_EMIT secondSought();
    });
    showTitle({});
    showSecond(false);
    refresh();
}

/// Makes a letter on the colour of its hand, which is bright enough for black.
QLabel* SessionPanel::letter(const QString& text, const view::Colour& colour)
{
    auto* label = new QLabel(text, this);
    label->setAlignment(Qt::AlignCenter);
    const QColor back =
        QColor::fromRgbF(static_cast<float>(colour[0]), static_cast<float>(colour[1]), static_cast<float>(colour[2]));
    label->setStyleSheet(QStringLiteral("background: %1; color: black; padding: 2px 6px").arg(back.name()));
    return label;
}

void SessionPanel::showSecond(bool isShown)
{
    for (QWidget* one : std::initializer_list<QWidget*>{m_letterA, m_letterB, m_secondTimeline}) {
        one->setVisible(isShown);
    }
    m_timeline->setTimeShown(!isShown);
}

void SessionPanel::alignAxes()
{
    const bool isCompared = m_secondTransport.duration_s() > 0.0;
    const double duration_s = isCompared ? std::max(m_transport.duration_s(), m_secondTransport.duration_s()) : 0.0;
    const double force_N = isCompared ? std::max(m_timeline->greatest_N(), m_secondTimeline->greatest_N()) : 0.0;
    m_timeline->setLeastAxes(duration_s, force_N);
    m_secondTimeline->setLeastAxes(duration_s, force_N);
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
    const auto textOf = [](const Transport& one) {
        return QStringLiteral("%1 / %2").arg(clockText(one.position_s()), clockText(one.duration_s()));
    };
    const bool isCompared = m_secondTransport.duration_s() > 0.0;
    m_time->setText(!isAny        ? QString()
                    : !isCompared ? textOf(m_transport)
                                  : tr("A %1, B %2").arg(textOf(m_transport), textOf(m_secondTransport)));
    m_speed->setEnabled(isAny);
    m_timeline->setPosition(m_transport.position_s());
    m_secondTimeline->setPosition(m_secondTransport.position_s());
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
