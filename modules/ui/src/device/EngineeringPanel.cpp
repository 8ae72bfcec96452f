// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/EngineeringPanel.h"

#include "touch/EnergyBar.h"

#include "palpate/ui/LiveTouch.h"
#include "palpate/ui/Translated.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>

#include <array>

namespace palpate::ui {

namespace {

constexpr double kEnough = 0.95; // fraction of the requested rate below which missed ticks become perceptible

/// Duration as text: "12 µs" below a millisecond, "1.53 ms" above.
QString timeText(std::int64_t time_ns)
{
    const double time_us = static_cast<double>(time_ns) * 1e-3;
    return time_us < 1000.0
               ? EngineeringPanel::tr("%1 µs").arg(QLocale().toString(time_us, 'f', time_us < 9.95 ? 1 : 0))
               : EngineeringPanel::tr("%1 ms").arg(QLocale().toString(1e-3 * time_us, 'f', 2));
}

/// Distribution of durations: "half below 12 µs, 99 % below 30 µs"; empty without measurements.
QString spreadText(const core::TimingSummary& times)
{
    return times.count == 0
               ? QString()
               : EngineeringPanel::tr("median %1, 99 % below %2").arg(timeText(times.p50_ns), timeText(times.p99_ns));
}

QString countText(std::uint64_t count)
{
    return QLocale().toString(static_cast<qulonglong>(count));
}

QString reportsText(const EngineeringReading& reading)
{
    return reading.reports == 0
               ? QString()
               : EngineeringPanel::tr("%1, %2 rejected, %3 dropouts")
                     .arg(countText(reading.reports), countText(reading.refused), countText(reading.losses));
}

/// One line for each real-time privilege, granted or denied, with the required permission.
QString realtimeText(const servo::RealtimeReport& report)
{
    QStringList lines;
    for (const servo::RealtimeItem& item : report.items) {
        lines << QStringLiteral("%1 %2: %3")
                     .arg(item.isGranted ? QStringLiteral("✓") : QStringLiteral("✗"), translated(item.name),
                          translated(item.message));
        if (!item.remedy.empty()) {
            lines << QStringLiteral("    ") + QString::fromStdString(item.remedy);
        }
    }
    return lines.join(QLatin1Char('\n'));
}

} // namespace

EngineeringReading engineeringReading(const LiveTouch& live, const TouchReading& shown)
{
    const servo::TickRecord& tick = live.newest();
    const device::DeviceReport device = live.deviceReport();
    EngineeringReading reading;
    reading.isRunning = live.isRunning();
    reading.hasMotors = live.deviceInfo().actuatedAxes > 0;
    reading.cpu = live.cpu();
    reading.rate_Hz = live.rate_Hz();
    reading.measured_Hz = live.measuredRate_Hz();
    reading.constraints = shown.constraints;
    reading.delayTicks = live.delayTicks();
    reading.energy_mJ = tick.energy_mJ;
    reading.damping_N = tick.fDamping_W.norm();
    reading.dropped = live.recording().dropped;
    reading.timing = live.timing();
    reading.realtime = live.realtime();
    reading.roundTrip = device.latency;
    reading.reports = device.states;
    reading.refused = device.refused;
    reading.losses = device.losses;
    return reading;
}

RunningState runningState(const EngineeringReading& reading)
{
    if (!reading.isRunning) {
        return {};
    }
    const QString details = EngineeringPanel::tr("Click for the details (View › Engineering).");
    const QLocale locale;
    if (reading.measured_Hz > 0.0 && reading.measured_Hz < kEnough * reading.rate_Hz) {
        return {false, EngineeringPanel::tr("computer too busy"),
                EngineeringPanel::tr(
                    "Touch runs at %1 updates per second instead of %2, so forces may stutter. Close other programs.")
                        .arg(locale.toString(reading.measured_Hz, 'f', 0), locale.toString(reading.rate_Hz, 'f', 0)) +
                    QLatin1Char('\n') + details};
    }
    if (reading.hasMotors && !reading.realtime.isRealtime) {
        return {false, EngineeringPanel::tr("force may stutter"),
                EngineeringPanel::tr("Touch has no real-time priority, so other programs may make the force stutter. "
                                     "The list of messages (F4) explains how to allow real-time priority.") +
                    QLatin1Char('\n') + details};
    }
    return {true, EngineeringPanel::tr("running well"),
            EngineeringPanel::tr("Touch runs at the full rate of %1 updates per second.")
                    .arg(locale.toString(reading.rate_Hz, 'f', 0)) +
                QLatin1Char('\n') + details};
}

EngineeringPanel::EngineeringPanel(QWidget* parent)
    : QWidget(parent)
    , m_energy(new EnergyBar(this))
    , m_realtime(new QLabel(this))
{
    auto* form = new QFormLayout(this);
    form->setContentsMargins(14, 8, 14, 10);
    form->setVerticalSpacing(6);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    makeRows();
    makeLoop();
    m_energy->setToolTip(
        tr("Energy observer: energy that the hand has put into the touched tissue and not recovered [mJ].\n"
           "A negative value means that the simulation adds energy; damping then removes the surplus."));
    m_realtime->setTextFormat(Qt::PlainText);
    m_realtime->setWordWrap(true);
    m_realtime->setMinimumWidth(10);
    m_realtime->setForegroundRole(QPalette::PlaceholderText);
    m_realtime->setAccessibleDescription(tr("Real-time settings of the servo thread"));
    form->addRow(m_realtime);
    show(EngineeringReading());
}

void EngineeringPanel::makeRows()
{
    const std::array<std::array<QString, 2>, RowCount> rows{{
        {tr("Constraints"), tr("Active constraints: surface planes that hold the hand back (at most 3)")},
        {tr("Solver"), tr("Solver time per tick, for ticks with a hand")},
        {tr("Measured rate"), tr("Servo ticks per second, over the last half second [kHz]")},
        {tr("Jitter"), tr("Deviation of the tick interval from the period; 99.9 % of the ticks stay below this value")},
        {tr("Late ticks"),
         tr("Ticks that finished late, out of all ticks since the loop started, and the periods skipped as a result")},
        {tr("Dropped ticks"), tr("Ticks missing from this recording because the disk was too slow")},
        {tr("Energy"),
         tr("Energy observer: energy that the hand has put into the touched tissue and not recovered [mJ]")},
        {tr("Damping added"), tr("Force that the passivity controller adds against the motion [N]")},
        {tr("Device round trip"), tr("Time from receiving a device report to writing the resulting force")},
        {tr("Delay"), tr("Assumed delay until the force acts; limits the stable stiffness")},
        {tr("Device reports"), tr("Reports received, reports rejected as implausible, and connection losses")},
    }};
    auto* form = static_cast<QFormLayout*>(layout());
    for (const auto& [title, tip] : rows) {
        auto* name = new QLabel(title, this);
        auto* value = new QLabel(this);
        name->setToolTip(tip);
        value->setToolTip(tip);
        value->setAccessibleDescription(title);
        value->setTextFormat(Qt::PlainText);
        value->setWordWrap(true);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        m_values.push_back(value);
        form->addRow(name, value);
        if (m_values.size() == Energy + 1) {
            form->addRow(m_energy);
        }
    }
}

void EngineeringPanel::makeLoop()
{
    auto* form = static_cast<QFormLayout*>(layout());
    m_rate = new QComboBox(this);
    for (const int rate_kHz : {1, 2, 4}) {
        m_rate->addItem(tr("%1 kHz").arg(rate_kHz), rate_kHz);
    }
    m_rate->setAccessibleName(tr("Rate of the servo loop"));
    m_rate->setToolTip(
        tr("Ticks per second. A faster loop keeps stiffer tissue stable if the device keeps up; check the jitter."));
    form->addRow(tr("Servo rate"), m_rate);
    m_cpu = new QComboBox(this);
    m_cpu->addItem(tr("Any"), -1);
    for (const int cpu : servo::allowedCpus()) {
        m_cpu->addItem(tr("CPU %1 only").arg(cpu), cpu);
    }
    m_cpu->setAccessibleName(tr("CPU of the servo loop"));
    m_cpu->setToolTip(tr("CPU for the servo loop. A single CPU helps only if no other program uses that CPU;\n"
                         "otherwise choose \"Any\"."));
    form->addRow(tr("Servo CPU"), m_cpu);
    for (QComboBox* box : {m_rate, m_cpu}) {
        connect(box, &QComboBox::activated, this, &EngineeringPanel::tell);
    }
}

void EngineeringPanel::tell()
{
    Q_EMIT loopChosen(m_rate->currentData().toInt(), m_cpu->currentData().toInt());
}

void EngineeringPanel::show(const EngineeringReading& reading)
{
    const QLocale locale;
    const servo::TimingReport& timing = reading.timing;
    const bool hasTicks = timing.ticks > 0;
    std::array<QString, RowCount> texts;
    texts[Constraints] = locale.toString(reading.constraints);
    texts[Solver] = spreadText(timing.solve);
    texts[MeasuredRate] =
        reading.measured_Hz > 0.0 ? tr("%1 kHz").arg(locale.toString(reading.measured_Hz * 1e-3, 'f', 2)) : QString();
    texts[Jitter] = hasTicks ? tr("99.9 % below %1").arg(timeText(timing.periodError.p999_ns)) : QString();
    texts[Late] = hasTicks ? tr("%1 of %2, %3 skipped")
                                 .arg(countText(timing.overruns), countText(timing.ticks), countText(timing.skipped))
                           : QString();
    texts[Dropped] = countText(reading.dropped);
    if (reading.hasMotors) {
        texts[Energy] = tr("%1 mJ").arg(locale.toString(reading.energy_mJ, 'f', 2));
        texts[Damping] = tr("%1 N").arg(locale.toString(reading.damping_N, 'f', 2));
        texts[Delay] = reading.rate_Hz > 0.0
                           ? tr("%1 ms").arg(numberText(1e3 * reading.delayTicks / reading.rate_Hz, 2))
                           : QString();
    }
    texts[RoundTrip] = spreadText(reading.roundTrip);
    texts[Reports] = reportsText(reading);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        m_values[i]->setText(texts[i].isEmpty() ? QStringLiteral("–") : texts[i]);
    }
    m_energy->setVisible(reading.hasMotors);
    m_energy->setEnergy(reading.energy_mJ);
    m_rate->setCurrentIndex(m_rate->findData(static_cast<int>(reading.rate_Hz * 1e-3 + 0.5)));
    m_cpu->setCurrentIndex(m_cpu->findData(reading.cpu));
    m_realtime->setText(realtimeText(reading.realtime));
    m_realtime->setVisible(!m_realtime->text().isEmpty());
}

} // namespace palpate::ui

#include "palpate/ui/moc_EngineeringPanel.cpp"
