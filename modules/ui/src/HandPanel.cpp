// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/HandPanel.h"

#include "EnergyBar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

namespace palpate::ui {

namespace {

QString heldText(const HandStatus& status, bool hasMotors)
{
    const QLocale locale;
    if (!hasMotors || !std::isfinite(status.held_N_per_mm)) {
        return HandPanel::tr("No motors: force is shown, not felt, and any stiffness is stable.");
    }
    return HandPanel::tr("Holds up to %1 N/mm at %2 Hz with %3 ms of delay; more is refused.")
        .arg(locale.toString(status.held_N_per_mm, 'f', status.held_N_per_mm < 0.995 ? 2 : 1),
             locale.toString(status.rate_Hz, 'f', 0),
             locale.toString(status.rate_Hz > 0.0 ? 1e3 * status.delayTicks / status.rate_Hz : 0.0, 'g', 2));
}

QString timingText(const HandStatus& status)
{
    const QLocale locale;
    if (status.timing.ticks == 0) {
        return {};
    }
    QString text = HandPanel::tr("Period error %1 µs (99.9 %), overruns %2 of %3 ticks")
                       .arg(locale.toString(static_cast<double>(status.timing.periodError.p999_ns) * 1e-3, 'f', 0),
                            locale.toString(static_cast<qulonglong>(status.timing.overruns)),
                            locale.toString(static_cast<qulonglong>(status.timing.ticks)));
    if (!status.realtime.isRealtime) {
        text += HandPanel::tr("\nNot real-time: point here to read why.");
    }
    return text;
}

QString realtimeText(const servo::RealtimeReport& report)
{
    QStringList lines;
    for (const servo::RealtimeItem& item : report.items) {
        lines << QStringLiteral("%1: %2").arg(QString::fromStdString(item.name), QString::fromStdString(item.message));
        if (!item.remedy.empty()) {
            lines << QStringLiteral("    ") + QString::fromStdString(item.remedy);
        }
    }
    return lines.join(QLatin1Char('\n'));
}

} // namespace

HandPanel::HandPanel(QWidget* parent)
    : QWidget(parent)
    , m_name(new QLabel(this))
    , m_held(new QLabel(this))
    , m_energyText(new QLabel(this))
    , m_energy(new EnergyBar(this))
    , m_mapping(new QWidget(this))
    , m_timing(new QLabel(this))
{
    QFont bold = font();
    bold.setBold(true);
    m_name->setFont(bold);
    m_name->setTextFormat(Qt::PlainText);
    for (QLabel* label : {m_held, m_energyText, m_timing}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
    }
    m_timing->setForegroundRole(QPalette::PlaceholderText);
    m_held->setAccessibleName(tr("Stiffness that is held"));
    m_energyText->setAccessibleName(tr("Energy observer"));
    m_energy->setToolTip(tr("Energy observer: what the hand has put into the touched tissue and not got back [mJ].\n"
                            "Below zero the program would give more than it took; damping then takes it away."));

    auto* form = new QFormLayout(m_mapping);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(6);
    m_fill = new QComboBox(m_mapping);
    m_fill->addItems({tr("Whole scene"), tr("Selected structure"), tr("10 mm: a lump"), tr("Scale by number"),
                      tr("As it lies: 1 : 1, unturned")});
    m_fill->setAccessibleName(tr("What fills the workspace"));
    m_fill->setToolTip(tr("What the device reaches from edge to edge of its workspace"));
    form->addRow(tr("Reaches"), m_fill);
    m_scale = new QDoubleSpinBox(m_mapping);
    m_scale->setRange(0.01, 100.0);
    m_scale->setDecimals(2);
    m_scale->setSingleStep(0.1);
    m_scale->setSuffix(tr(" ×"));
    m_scale->setAccessibleName(tr("Scale"));
    m_scale->setToolTip(tr("Millimetres of the scene for a millimetre of the device"));
    form->addRow(tr("Scale"), m_scale);
    m_turn = new QComboBox(m_mapping);
    m_turn->addItems({tr("The picture"), tr("The patient")});
    m_turn->setAccessibleName(tr("What the device turns with"));
    m_turn->setToolTip(tr("The picture: right is right in the view, however it is turned.\n"
                          "The patient: right is to the patient's left, up is to the head."));
    form->addRow(tr("Turns with"), m_turn);
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        m_buttons[i] = new QComboBox(m_mapping);
        m_buttons[i]->addItems({tr("Nothing"), tr("Clutch"), tr("Centre")});
        m_buttons[i]->setAccessibleName(tr("Use of button %1").arg(i + 1));
        form->addRow(tr("Button %1").arg(i + 1), m_buttons[i]);
        connect(m_buttons[i], &QComboBox::activated, this, &HandPanel::edit);
    }
    m_leftHanded = new QCheckBox(tr("Left hand"), m_mapping);
    m_leftHanded->setToolTip(tr("The first two buttons change places"));
    form->addRow(QString(), m_leftHanded);
    m_clutch = new QPushButton(tr("Clutch"), m_mapping);
    m_clutch->setToolTip(tr("While held the device moves and the hand in the scene stays; the key C switches it"));
    m_centre = new QPushButton(tr("Centre"), m_mapping);
    m_centre->setToolTip(tr("Puts the middle of the device's workspace in the middle of what it reaches"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_clutch);
    row->addWidget(m_centre);
    form->addRow(row);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(14, 8, 14, 10);
    layout->setSpacing(6);
    for (QWidget* part : {static_cast<QWidget*>(m_name), static_cast<QWidget*>(m_held), static_cast<QWidget*>(m_energy),
                          static_cast<QWidget*>(m_energyText), m_mapping, static_cast<QWidget*>(m_timing)}) {
        layout->addWidget(part);
    }
    layout->addStretch(1);

    connect(m_fill, &QComboBox::activated, this, &HandPanel::edit);
    connect(m_turn, &QComboBox::activated, this, &HandPanel::edit);
    connect(m_scale, &QDoubleSpinBox::valueChanged, this, &HandPanel::edit);
    connect(m_leftHanded, &QCheckBox::toggled, this, &HandPanel::edit);
    connect(m_clutch, &QPushButton::pressed, this, [this] { emit clutchWanted(true); });
    connect(m_clutch, &QPushButton::released, this, [this] { emit clutchWanted(false); });
    connect(m_centre, &QPushButton::clicked, this, &HandPanel::centreWanted);
    setDevice({}, {});
}

void HandPanel::setDevice(const device::DeviceInfo& info, const HandSettings& settings)
{
    m_settings = settings;
    m_hasMotors = info.actuatedAxes > 0;
    m_name->setText(QString::fromStdString(info.name));
    m_mapping->setVisible(servo::edgeOf(info) > 0.0);
    m_energy->setVisible(m_hasMotors);
    m_energyText->setVisible(m_hasMotors);
    showSettings();
}

void HandPanel::showSettings()
{
    m_isShowing = true;
    m_fill->setCurrentIndex(static_cast<int>(m_settings.fill));
    m_turn->setCurrentIndex(static_cast<int>(m_settings.turn));
    m_leftHanded->setChecked(m_settings.isLeftHanded);
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        m_buttons[i]->setCurrentIndex(static_cast<int>(m_settings.buttons[i]));
    }
    m_scale->setEnabled(m_settings.fill == MapFill::Scale);
    m_isShowing = false;
}

void HandPanel::edit()
{
    if (m_isShowing) {
        return;
    }
    m_settings.fill = static_cast<MapFill>(m_fill->currentIndex());
    m_settings.turn = static_cast<MapTurn>(m_turn->currentIndex());
    m_settings.isLeftHanded = m_leftHanded->isChecked();
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        m_settings.buttons[i] = static_cast<ButtonUse>(m_buttons[i]->currentIndex());
    }
    if (m_settings.fill == MapFill::Scale) {
        m_settings.scale = m_scale->value();
    }
    m_scale->setEnabled(m_settings.fill == MapFill::Scale);
    emit settingsChanged();
}

void HandPanel::show(const HandStatus& status)
{
    const QLocale locale;
    m_held->setText(heldText(status, m_hasMotors));
    m_energy->setEnergy(status.energy_mJ);
    m_energyText->setText(status.isClutched ? tr("Clutched: the device moves, the hand in the scene stays.")
                                            : tr("Energy %1 mJ · damping added %2 N")
                                                  .arg(locale.toString(status.energy_mJ, 'f', 2),
                                                       locale.toString(status.damping_N, 'f', 2)));
    if (!m_scale->hasFocus() || m_settings.fill != MapFill::Scale) {
        m_isShowing = true;
        m_scale->setValue(status.scale);
        m_isShowing = false;
    }
    m_timing->setText(timingText(status));
    m_timing->setToolTip(realtimeText(status.realtime));
}

} // namespace palpate::ui
