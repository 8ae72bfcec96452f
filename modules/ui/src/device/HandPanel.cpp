// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/HandPanel.h"

#include "widgets/ShownComboBox.h"

#include <palpate/device/DevicePresets.h>

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

QString heldText(const HandStatus& status, bool hasMotors)
{
    if (!hasMotors || !std::isfinite(status.held_N_per_mm)) {
        return HandPanel::tr("No motors: forces are displayed, not felt. Any stiffness is possible.");
    }
    return HandPanel::tr("This device can render tissue up to %1 N/mm.")
        .arg(QLocale().toString(status.held_N_per_mm, 'f', status.held_N_per_mm < 0.995 ? 2 : 1));
}

QString clutchText(const HandStatus& status)
{
    switch (status.clutch) {
    case HandStatus::Clutch::AtEdge:
        return HandPanel::tr("Edge of the workspace: move the device back to the middle. Until then, the hand in the "
                             "scene does not move.");
    case HandStatus::Clutch::Asked:
        return HandPanel::tr("Lifted: the device moves, the hand in the scene does not.");
    case HandStatus::Clutch::None:
        break;
    }
    return status.inside.isEmpty()
               ? QString()
               : HandPanel::tr(
                     "The hand is inside %1, which is only felt from outside. Move the hand out towards you first.")
                     .arg(status.inside);
}

QString reachText(const HandStatus& status, MapFill fill)
{
    if (!status.isMapped) {
        return HandPanel::tr("Unscaled: 1 mm of the device is 1 mm of the scene.");
    }
    const QString scale = numberText(status.scale, 2);
    return fill == MapFill::Scale
               ? HandPanel::tr("1 mm of the device is %1 mm of the scene.").arg(scale)
               : HandPanel::tr("%1 fills the workspace: 1 mm of the device is %2 mm of the scene.")
                     .arg(status.filled.isEmpty() ? HandPanel::tr("Nothing yet") : status.filled, scale);
}

} // namespace

HandPanel::HandPanel(QWidget* parent)
    : QWidget(parent)
    , m_name(new QLabel(this))
    , m_force(new QLabel(this))
    , m_held(new QLabel(this))
    , m_clutched(new QLabel(this))
{
    m_mapping = makeMapping();
    m_press = makePress();
    m_simulated = makeSimulated();
    QFont bold = font();
    bold.setBold(true);
    m_name->setFont(bold);
    m_clutched->setFont(bold);
    m_name->setTextFormat(Qt::PlainText);
    for (QLabel* label : {m_force, m_held, m_clutched, m_reach}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
    }
    m_force->setAccessibleDescription(tr("Force on the hand"));
    m_held->setAccessibleDescription(tr("Maximum tissue stiffness"));

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(14, 8, 14, 10);
    layout->setSpacing(6);
    for (QWidget* part : {static_cast<QWidget*>(m_name), static_cast<QWidget*>(m_force), static_cast<QWidget*>(m_held),
                          static_cast<QWidget*>(m_clutched), m_press, m_simulated, m_mapping}) {
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
        button->setMinimumWidth(40); // three buttons fit into a narrow panel
        button->setToolTip(tip);
        row->addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, fill] { Q_EMIT fitWanted(fill); });
    };
    add(tr("Everything"), MapFill::Scene, tr("Map the full device range to all visible structures (W)"));
    add(tr("Organ"), MapFill::Organ,
        tr("Map the full device range to the touched organ, or else to the organ under the pointer or the selected one "
           "(O)"));
    add(tr("Lump"), MapFill::Lump,
        tr("Map the full device range to 10 mm around the contact, or else around the pointer or the newest finding "
           "(L)"));
    return fits;
}

QWidget* HandPanel::makeMapping()
{
    auto* mapping = new QWidget(this);
    auto* form = new QFormLayout(mapping);
    form->setContentsMargins(0, 4, 0, 4);
    form->setVerticalSpacing(6);
    form->addRow(new QLabel(tr("Fit workspace to"), mapping));
    form->addRow(makeFits());
    m_reach = new QLabel(mapping);
    m_reach->setAccessibleDescription(tr("Current workspace"));
    form->addRow(m_reach);
    m_scale = new QDoubleSpinBox(mapping);
    m_scale->setRange(0.01, 100.0);
    m_scale->setDecimals(3);
    m_scale->setSingleStep(0.1);
    m_scale->setSuffix(tr(" mm per mm"));
    m_scale->setKeyboardTracking(false); // typing 15 must not apply 1 first
    m_scale->setAccessibleName(tr("Scale"));
    m_scale->setToolTip(tr("Scene millimetres per device millimetre"));
    form->addRow(tr("Scale"), m_scale);
    m_turn = new QComboBox(mapping);
    m_turn->addItems({tr("View"), tr("Patient"), tr("Scene axes")});
    m_turn->setAccessibleName(tr("Device orientation"));
    m_turn->setToolTip(
        tr("View: right is right on screen, however the view is rotated.\n"
           "Patient: right is the patient's left, up is towards the head.\n"
           "Scene axes: device coordinates equal scene coordinates, without scaling; the hand cannot be lifted."));
    form->addRow(tr("Aligned with"), m_turn);
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        m_buttons[i] = new QComboBox(mapping);
        m_buttons[i]->addItems({tr("Nothing"), tr("Lift the hand"), tr("Centre")});
        m_buttons[i]->setAccessibleName(tr("Function of button %1").arg(i + 1));
        form->addRow(tr("Button %1").arg(i + 1), m_buttons[i]);
        connect(m_buttons[i], &QComboBox::activated, this, &HandPanel::edit);
    }
    m_leftHanded = new QCheckBox(tr("Left hand"), mapping);
    m_leftHanded->setToolTip(tr("Swaps the first two buttons"));
    form->addRow(QString(), m_leftHanded);
    m_clutch = new QPushButton(tr("Lift the hand"), mapping);
    m_clutch->setToolTip(
        tr("While held, the device moves and the hand in the scene does not; C switches lifting on and off"));
    m_centre = new QPushButton(tr("Centre"), mapping);
    m_centre->setToolTip(tr("Centres the device range on the fitted region"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_clutch);
    row->addWidget(m_centre);
    form->addRow(row);

    connect(m_turn, &QComboBox::activated, this, &HandPanel::edit);
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

QWidget* HandPanel::makePress()
{
    auto* press = new QWidget(this);
    auto* form = new QFormLayout(press);
    form->setContentsMargins(0, 4, 0, 4);
    form->setVerticalSpacing(6);
    m_pressBy = new ShownComboBox(press);
    m_pressBy->addItems({tr("Depth (wheel)"), tr("Force (hold)")});
    m_pressBy->setAccessibleName(tr("Press mode"));
    m_pressBy->setToolTip(tr("Depth: the same depth everywhere; a stiff place pushes back harder.\n"
                             "Force: the same force everywhere; a stiff place yields less. The force rises by 1 N per "
                             "second while the button is held; with a pen, the pen pressure sets the force. (E)"));
    form->addRow(tr("Press mode"), m_pressBy);
    m_effort = new QDoubleSpinBox(press);
    m_effort->setRange(Effort::kLeast_N, Effort::kMost_N);
    m_effort->setDecimals(1);
    m_effort->setSingleStep(Effort::kNotch_N);
    m_effort->setSuffix(tr(" N"));
    m_effort->setKeyboardTracking(false);
    m_effort->setAccessibleName(tr("Maximum force"));
    m_effort->setToolTip(
        tr("Force limit of a press and force at full pen pressure; the wheel changes the value by 0.5 N"));
    form->addRow(tr("Maximum"), m_effort);
    connect(m_pressBy, &QComboBox::activated, this, &HandPanel::edit);
    connect(m_effort, &QDoubleSpinBox::valueChanged, this, &HandPanel::edit);
    return press;
}

QWidget* HandPanel::makeSimulated()
{
    auto* simulated = new QWidget(this);
    auto* form = new QFormLayout(simulated);
    form->setContentsMargins(0, 4, 0, 4);
    form->setVerticalSpacing(6);
    auto* what = new QLabel(tr("Computed hand, no device: it presses what is in the middle of the view. Force and "
                               "stiffness have the limits of the chosen device."),
                            simulated);
    what->setWordWrap(true);
    form->addRow(what);
    m_preset = new ShownComboBox(simulated);
    m_preset->setObjectName(QStringLiteral("preset"));
    for (const device::DevicePreset& one : device::devicePresets()) {
        m_preset->addItem(QString::fromUtf8(one.name.data(), static_cast<qsizetype>(one.name.size())),
                          QString::fromUtf8(one.id.data(), static_cast<qsizetype>(one.id.size())));
    }
    m_preset->setAccessibleName(tr("Limits of"));
    m_preset->setToolTip(tr("Shows how tissue feels at a device that is not here: force, stiffness and damping are "
                            "bounded as by this device"));
    form->addRow(tr("Limits of"), m_preset);
    connect(m_preset, &QComboBox::activated, this, [this] {
        edit();
        Q_EMIT presetChanged();
    });
    return simulated;
}

void HandPanel::setDevice(const device::DeviceInfo& info, const HandSettings& settings)
{
    m_limit_N = info.actuatedAxes > 0 ? info.maxForce_N : 0.0;
    m_name->setText(info.id == "simulated-hand" ? tr("Simulated hand") : QString::fromStdString(info.name));
    showWhatApplies(info);
    m_force->setVisible(m_limit_N > 0.0);
    setSettings(settings);
}

/// Shows the applicable controls. Devices without a workspace (pointer, simulated hand) are not mapped and have no
/// buttons; only force or depth of the pointer and the limits of the simulated hand can be chosen.
void HandPanel::showWhatApplies(const device::DeviceInfo& info)
{
    m_mapping->setVisible(servo::edgeOf(info) > 0.0);
    m_press->setVisible(info.id == "mouse");
    m_simulated->setVisible(info.id == "simulated-hand");
}

void HandPanel::setSettings(const HandSettings& settings)
{
    m_settings = settings;
    m_isShowing = true;
    m_turn->setCurrentIndex(static_cast<int>(m_settings.turn));
    m_leftHanded->setChecked(m_settings.isLeftHanded);
    m_pressBy->setCurrentIndex(m_settings.isByEffort ? 1 : 0);
    m_effort->setValue(m_settings.effort_N);
    m_preset->setCurrentIndex(m_preset->findData(QString::fromStdString(m_settings.preset)));
    m_effort->setEnabled(m_settings.isByEffort);
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
    m_settings.isLeftHanded = m_leftHanded->isChecked();
    m_settings.isByEffort = m_pressBy->currentIndex() == 1;
    m_settings.effort_N = m_effort->value();
    m_settings.preset = m_preset->currentData().toString().toStdString();
    m_effort->setEnabled(m_settings.isByEffort);
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
        tr("Force on the hand %1 N of %2 N").arg(locale.toString(status.force_N, 'f', 2), numberText(m_limit_N)));
    m_held->setText(heldText(status, m_limit_N > 0.0));
    m_clutched->setText(clutchText(status));
    m_clutched->setVisible(!m_clutched->text().isEmpty());
    m_reach->setText(reachText(status, m_settings.fill));
    if (!m_scale->hasFocus()) {
        m_isShowing = true;
        m_scale->setValue(status.scale);
        m_isShowing = false;
    }
}

} // namespace palpate::ui

#include "palpate/ui/Translated.h"
#include "palpate/ui/moc_HandPanel.cpp"
