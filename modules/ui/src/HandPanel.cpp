// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/HandPanel.h"

#include "EnergyBar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

namespace palpate::ui {

namespace {

QString ms(std::int64_t time_ns)
{
    return QLocale().toString(static_cast<double>(time_ns) * 1e-6, 'f', 1);
}

QString heldText(const HandStatus& status, bool hasMotors)
{
    const QLocale locale;
    if (!hasMotors || !std::isfinite(status.held_N_per_mm)) {
        return HandPanel::tr("No motors: force is shown, not felt, and any stiffness is stable.");
    }
    return HandPanel::tr("Holds up to %1 N/mm at %2 kHz with %3 ms of delay; more is refused.")
        .arg(locale.toString(status.held_N_per_mm, 'f', status.held_N_per_mm < 0.995 ? 2 : 1),
             locale.toString(status.rate_Hz * 1e-3),
             locale.toString(status.rate_Hz > 0.0 ? 1e3 * status.delayTicks / status.rate_Hz : 0.0, 'g', 2));
}

QString clutchText(const HandStatus& status)
{
    switch (status.clutch) {
    case HandStatus::Clutch::AtEdge:
        return HandPanel::tr("At the edge of the workspace: bring the device back to its middle. The hand in the scene "
                             "stays until then.");
    case HandStatus::Clutch::Asked:
        return HandPanel::tr("Clutched: the device moves, the hand in the scene stays.");
    case HandStatus::Clutch::None:
        break;
    }
    return status.inside.isEmpty()
               ? QString()
               : HandPanel::tr("Inside %1, which is felt from outside: bring the hand out towards you first.")
                     .arg(status.inside);
}

QString reachText(const HandStatus& status, MapFill fill)
{
    if (!status.isMapped) {
        return HandPanel::tr("As it lies: the device's millimetres are the scene's.");
    }
    const QString scale = QLocale().toString(status.scale, 'g', 2);
    return fill == MapFill::Scale
               ? HandPanel::tr("1 mm of the device is %1 mm of the scene.").arg(scale)
               : HandPanel::tr("%1 fills the workspace: 1 mm of the device is %2 mm of the scene.")
                     .arg(status.filled.isEmpty() ? HandPanel::tr("Nothing yet") : status.filled, scale);
}

QString timingText(const HandStatus& status)
{
    const QLocale locale;
    if (status.timing.ticks == 0) {
        return {};
    }
    QStringList lines;
    if (status.latency.count > 0) {
        lines << HandPanel::tr("Latency %1 ms, 99 % below %2 ms")
                     .arg(ms(status.latency.p50_ns), ms(status.latency.p99_ns));
    }
    lines << HandPanel::tr("Jitter 99.9 % below %1 µs")
                 .arg(locale.toString(static_cast<double>(status.timing.periodError.p999_ns) * 1e-3, 'f', 0));
    lines << HandPanel::tr("%1 of %2 ticks late")
                 .arg(locale.toString(static_cast<qulonglong>(status.timing.overruns)),
                      locale.toString(static_cast<qulonglong>(status.timing.ticks)));
    if (!status.realtime.isRealtime) {
        lines << HandPanel::tr("Not real-time: the list of messages (F4) says how to permit it.");
    }
    return lines.join(QLatin1Char('\n'));
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
    , m_force(new QLabel(this))
    , m_held(new QLabel(this))
    , m_energyText(new QLabel(this))
    , m_energy(new EnergyBar(this))
    , m_clutched(new QLabel(this))
    , m_timing(new QLabel(this))
{
    m_mapping = makeMapping();
    QFont bold = font();
    bold.setBold(true);
    m_name->setFont(bold);
    m_clutched->setFont(bold);
    m_name->setTextFormat(Qt::PlainText);
    for (QLabel* label : {m_force, m_held, m_energyText, m_clutched, m_reach, m_timing}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
    }
    m_timing->setForegroundRole(QPalette::PlaceholderText);
    m_force->setAccessibleDescription(tr("Force on the hand"));
    m_held->setAccessibleDescription(tr("Stiffness that is held"));
    m_energyText->setAccessibleDescription(tr("Energy observer"));
    m_energy->setToolTip(tr("Energy observer: what the hand has put into the touched tissue and not got back [mJ].\n"
                            "Below zero the program would give more than it took; damping then takes it away."));
    m_timing->setAccessibleDescription(tr("Latency and jitter"));

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(14, 8, 14, 10);
    layout->setSpacing(6);
    for (QWidget* part : {static_cast<QWidget*>(m_name), static_cast<QWidget*>(m_force), static_cast<QWidget*>(m_held),
                          static_cast<QWidget*>(m_energy), static_cast<QWidget*>(m_energyText),
                          static_cast<QWidget*>(m_clutched), m_mapping, static_cast<QWidget*>(m_timing)}) {
        layout->addWidget(part);
    }
    layout->addStretch(1);
    m_clutched->hide();
    setDevice({}, {});
}

QWidget* HandPanel::makeFits()
{
    auto* fits = new QWidget;
    auto* row = new QHBoxLayout(fits);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    const auto add = [&](const QString& text, MapFill fill, const QString& tip) {
        auto* button = new QPushButton(text, fits);
        button->setMinimumWidth(40); // three fit into a narrow panel
        button->setToolTip(tip);
        row->addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, fill] { Q_EMIT fitWanted(fill); });
    };
    add(tr("Fit all"), MapFill::Scene, tr("All that is shown fills the device's workspace (W)"));
    add(tr("Fit organ"), MapFill::Organ,
        tr("The organ that is touched fills the device's workspace; else the one under the pointer or selected (O)"));
    add(tr("Fit lump"), MapFill::Lump,
        tr("10 mm fill the device's workspace: where the hand touches, else under the pointer, else the newest finding "
           "(L)"));
    return fits;
}

QWidget* HandPanel::makeMapping()
{
    auto* mapping = new QWidget(this);
    auto* form = m_form = new QFormLayout(mapping);
    form->setContentsMargins(0, 4, 0, 4);
    form->setVerticalSpacing(6);
    m_fits = makeFits();
    form->addRow(m_fits);
    m_reach = new QLabel(mapping);
    m_reach->setAccessibleDescription(tr("What fills the workspace"));
    form->addRow(m_reach);
    m_scale = new QDoubleSpinBox(mapping);
    m_scale->setRange(0.01, 100.0);
    m_scale->setDecimals(3);
    m_scale->setSingleStep(0.1);
    m_scale->setSuffix(tr(" mm per mm"));
    m_scale->setKeyboardTracking(false); // 15 is not first 1
    m_scale->setAccessibleName(tr("Scale"));
    m_scale->setToolTip(tr("Millimetres of the scene for a millimetre of the device"));
    form->addRow(tr("Scale"), m_scale);
    m_turn = new QComboBox(mapping);
    m_turn->addItems({tr("The picture"), tr("The patient"), tr("Nothing: as it lies")});
    m_turn->setAccessibleName(tr("What the device turns with"));
    m_turn->setToolTip(tr("The picture: right is right in the view, however it is turned.\n"
                          "The patient: right is to the patient's left, up is to the head.\n"
                          "Nothing: the device's coordinates are the scene's, without scale and clutch."));
    form->addRow(tr("Turns with"), m_turn);
    m_rate = new QComboBox(mapping);
    for (const int rate_kHz : {1, 2, 4}) {
        m_rate->addItem(tr("%1 kHz").arg(rate_kHz), rate_kHz);
    }
    m_rate->setAccessibleName(tr("Rate of the servo loop"));
    m_rate->setToolTip(
        tr("Ticks a second. A faster loop holds stiffer tissue where the device keeps up; see the jitter "
           "below."));
    form->addRow(tr("Servo rate"), m_rate);
    m_cpu = new QComboBox(mapping);
    m_cpu->addItem(tr("Any"), -1);
    for (const int cpu : servo::allowedCpus()) {
        m_cpu->addItem(tr("CPU %1 alone").arg(cpu), cpu);
    }
    m_cpu->setAccessibleName(tr("CPU of the servo loop"));
    m_cpu->setToolTip(tr("Where the servo loop runs. One CPU alone helps where it is kept free of everything else; "
                         "elsewhere \"Any\" lets\nthe loop go where there is room."));
    form->addRow(tr("Servo CPU"), m_cpu);
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        m_buttons[i] = new QComboBox(mapping);
        m_buttons[i]->addItems({tr("Nothing"), tr("Clutch"), tr("Centre")});
        m_buttons[i]->setAccessibleName(tr("Use of button %1").arg(i + 1));
        form->addRow(tr("Button %1").arg(i + 1), m_buttons[i]);
        connect(m_buttons[i], &QComboBox::activated, this, &HandPanel::edit);
    }
    m_leftHanded = new QCheckBox(tr("Left hand"), mapping);
    m_leftHanded->setToolTip(tr("The first two buttons change places"));
    form->addRow(QString(), m_leftHanded);
    m_clutch = new QPushButton(tr("Clutch"), mapping);
    m_clutch->setToolTip(tr("While held the device moves and the hand in the scene stays; the key C switches it"));
    m_centre = new QPushButton(tr("Centre"), mapping);
    m_centre->setToolTip(tr("Puts the middle of the device's workspace in the middle of what fills it"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_clutch);
    row->addWidget(m_centre);
    form->addRow(row);

    connect(m_turn, &QComboBox::activated, this, &HandPanel::edit);
    connect(m_rate, &QComboBox::activated, this, &HandPanel::edit);
    connect(m_cpu, &QComboBox::activated, this, &HandPanel::edit);
    connect(m_scale, &QDoubleSpinBox::valueChanged, this, [this] {
        if (!m_isShowing) {
            m_settings.fill = MapFill::Scale;
            m_settings.scale = m_scale->value();
            Q_EMIT settingsChanged();
        }
    });
    connect(m_leftHanded, &QCheckBox::toggled, this, &HandPanel::edit);
    connect(m_clutch, &QPushButton::pressed, this, [this] { Q_EMIT clutchWanted(true); });
    connect(m_clutch, &QPushButton::released, this, [this] { Q_EMIT clutchWanted(false); });
    connect(m_centre, &QPushButton::clicked, this, &HandPanel::centreWanted);
    return mapping;
}

void HandPanel::setDevice(const device::DeviceInfo& info, const HandSettings& settings)
{
    m_limit_N = info.actuatedAxes > 0 ? info.maxForce_N : 0.0;
    m_name->setText(QString::fromStdString(info.name));
    showWhatApplies(servo::edgeOf(info) > 0.0);
    const bool hasMotors = m_limit_N > 0.0;
    for (QWidget* part :
         {static_cast<QWidget*>(m_force), static_cast<QWidget*>(m_energy), static_cast<QWidget*>(m_energyText)}) {
        part->setVisible(hasMotors);
    }
    setSettings(settings);
}

/// A hand without a workspace of its own (pointer, simulated hand) lies as the scene does and has no buttons: what is
/// left to choose is its loop.
void HandPanel::showWhatApplies(bool hasWorkspace)
{
    for (QWidget* field : {m_fits, static_cast<QWidget*>(m_reach), static_cast<QWidget*>(m_scale),
                           static_cast<QWidget*>(m_turn), static_cast<QWidget*>(m_buttons[0]),
                           static_cast<QWidget*>(m_buttons[1]), static_cast<QWidget*>(m_leftHanded)}) {
        m_form->setRowVisible(field, hasWorkspace);
    }
    m_clutch->setVisible(hasWorkspace);
    m_centre->setVisible(hasWorkspace);
}

void HandPanel::setSettings(const HandSettings& settings)
{
    m_settings = settings;
    m_isShowing = true;
    m_turn->setCurrentIndex(static_cast<int>(m_settings.turn));
    m_rate->setCurrentIndex(m_rate->findData(m_settings.rate_kHz));
    m_cpu->setCurrentIndex(m_cpu->findData(m_settings.cpu));
    m_leftHanded->setChecked(m_settings.isLeftHanded);
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        m_buttons[i]->setCurrentIndex(static_cast<int>(m_settings.buttons[i]));
    }
    m_scale->setEnabled(m_settings.turn != MapTurn::None);
    m_isShowing = false;
}

void HandPanel::edit()
{
    if (m_isShowing) {
        return;
    }
    m_settings.turn = static_cast<MapTurn>(m_turn->currentIndex());
    m_settings.rate_kHz = m_rate->currentData().toInt();
    m_settings.cpu = m_cpu->currentData().toInt();
    m_settings.isLeftHanded = m_leftHanded->isChecked();
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        m_settings.buttons[i] = static_cast<ButtonUse>(m_buttons[i]->currentIndex());
    }
    m_scale->setEnabled(m_settings.turn != MapTurn::None);
    Q_EMIT settingsChanged();
}

void HandPanel::show(const HandStatus& status)
{
    const QLocale locale;
    m_force->setText(
        tr("Force on the hand %1 N of %2 N").arg(locale.toString(status.force_N, 'f', 2), locale.toString(m_limit_N)));
    m_held->setText(heldText(status, m_limit_N > 0.0));
    m_energy->setEnergy(status.energy_mJ);
    m_energyText->setText(
        tr("Energy %1 mJ · damping added %2 N")
            .arg(locale.toString(status.energy_mJ, 'f', 2), locale.toString(status.damping_N, 'f', 2)));
    m_clutched->setText(clutchText(status));
    m_clutched->setVisible(!m_clutched->text().isEmpty());
    m_reach->setText(reachText(status, m_settings.fill));
    if (!m_scale->hasFocus()) {
        m_isShowing = true;
        m_scale->setValue(status.scale);
        m_isShowing = false;
    }
    m_timing->setText(timingText(status));
    m_timing->setToolTip(realtimeText(status.realtime));
}

} // namespace palpate::ui
