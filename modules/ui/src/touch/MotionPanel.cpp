// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/MotionPanel.h"

#include "palpate/ui/Theme.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include <cmath>

namespace palpate::ui {

MotionPanel::MotionPanel(QWidget* parent)
    : QWidget(parent)
    , m_play(new QToolButton(this))
    , m_hold(new QToolButton(this))
    , m_rate(new QDoubleSpinBox(this))
    , m_amplitude(new QSlider(Qt::Horizontal, this))
    , m_percent(new QLabel(this))
{
    auto* form = new QFormLayout(this);
    auto* buttons = new QHBoxLayout;
    m_play->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_play->setToolTip(tr("Let the tissue move, or stop it where it is"));
    m_hold->setText(tr("Hold breath"));
    m_hold->setCheckable(true);
    m_hold->setToolTip(tr("Hold breathing tissue where it is; pulses and tracked poses go on"));
    buttons->addWidget(m_play);
    buttons->addWidget(m_hold);
    buttons->addStretch(1);
    form->addRow(buttons);
    m_rate->setRange(kLeastRate, kMostRate);
    m_rate->setSingleStep(0.1);
    m_rate->setDecimals(1);
    m_rate->setSuffix(tr(" ×"));
    m_rate->setKeyboardTracking(false);
    m_rate->setAccessibleName(tr("Rate of the motion"));
    m_rate->setToolTip(tr("Speed of all motions; 1 is that of the scene file"));
    form->addRow(tr("Rate"), m_rate);
    auto* amplitude = new QHBoxLayout;
    m_amplitude->setRange(0, 100);
    m_amplitude->setPageStep(25);
    m_amplitude->setTracking(false); // each value is a new scene for the hand
    m_amplitude->setAccessibleName(tr("Amplitude of the breath"));
    m_amplitude->setToolTip(tr("Share of the displacement of the scene file; at 0 % breathing tissue rests"));
    amplitude->addWidget(m_amplitude, 1);
    amplitude->addWidget(m_percent);
    form->addRow(tr("Amplitude"), amplitude);
    connect(m_play, &QToolButton::clicked, this, [this] {
        m_shown.isPlaying = !m_shown.isPlaying;
        choose();
    });
    connect(m_hold, &QToolButton::clicked, this, &MotionPanel::choose);
    connect(m_rate, &QDoubleSpinBox::valueChanged, this, &MotionPanel::choose);
    connect(m_amplitude, &QSlider::valueChanged, this, &MotionPanel::choose);
    connect(m_amplitude, &QSlider::sliderMoved, this, &MotionPanel::showAmplitude);
    show({}, true);
}

void MotionPanel::show(const MotionSettings& settings, bool hasBreath)
{
    const QSignalBlocker rate(m_rate), amplitude(m_amplitude);
    m_shown = settings;
    m_play->setText(settings.isPlaying ? tr("Pause") : tr("Play"));
    m_play->setIcon(icon(settings.isPlaying ? Symbol::Pause : Symbol::Play));
    m_hold->setChecked(settings.isHeld);
    m_rate->setValue(settings.rate);
    m_amplitude->setValue(static_cast<int>(std::lround(100.0 * settings.amplitude)));
    showAmplitude(m_amplitude->value());
    m_hold->setEnabled(hasBreath);
    m_amplitude->setEnabled(hasBreath);
}

void MotionPanel::choose()
{
    m_shown.isHeld = m_hold->isChecked();
    m_shown.rate = m_rate->value();
    m_shown.amplitude = m_amplitude->value() / 100.0;
    Q_EMIT chosen(m_shown);
}

void MotionPanel::showAmplitude(int percent)
{
    m_percent->setText(tr("%1 %").arg(QLocale().toString(percent)));
}

} // namespace palpate::ui

#include "palpate/ui/moc_MotionPanel.cpp"
