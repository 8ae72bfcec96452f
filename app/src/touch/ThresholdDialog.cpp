// SPDX-License-Identifier: BSD-3-Clause
#include "touch/ThresholdDialog.h"

#include <palpate/ui/DeviceChoice.h>
#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/Translated.h>
#include <palpate/ui/VtkViewport.h>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <vtkCamera.h>

#include <algorithm>

namespace palpate::app {

using core::Vec3;
using Stage = study::PressedPairs::Stage;

namespace {

constexpr int kWallSample_ms = 8;
constexpr double kDeviceStiffness_N_per_mm = 0.3; // of the softer wall, at the device: between liver and muscle
constexpr double kStiffest = 3.0;                 // largest ratio of the series: +200 %
constexpr double kAhead_mm = 10.0;                // from the hand to the wall, at the device
constexpr double kHalfWidth_mm = 300.0;           // of the wall, at the device: beyond any workspace

} // namespace

ThresholdDialog::ThresholdDialog(ui::LiveTouch& live, ui::VtkViewport& viewport, std::uint32_t seed, QWidget* parent)
    : QDialog(parent)
    , m_live(live)
    , m_viewport(viewport)
    , m_seed(seed)
    , m_told(new QLabel(this))
    , m_stored(new QLabel(this))
    , m_progress(new QProgressBar(this))
    , m_first(new QPushButton(tr("The &first was stiffer"), this))
    , m_second(new QPushButton(tr("The &second was stiffer"), this))
    , m_start(new QPushButton(this))
    , m_reset(new QPushButton(tr("Delete the stored threshold"), this))
    , m_use(new QCheckBox(tr("Also give verdicts on lumps for my hand"), this))
{
    setWindowTitle(tr("My threshold"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowModality(Qt::WindowModal);
    m_told->setWordWrap(true);
    m_told->setTextFormat(Qt::PlainText);
    m_told->setMinimumHeight(4 * fontMetrics().lineSpacing());
    m_told->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_stored->setWordWrap(true);
    m_stored->setTextFormat(Qt::PlainText);
    m_progress->setRange(0, static_cast<int>(study::PressedPairs::kTrials));
    m_progress->setFormat(tr("%v of %m trials"));
    m_progress->setAccessibleName(tr("Trials"));
    m_use->setToolTip(tr("After “plainly felt”, “felt by a trained hand” and “too little for a trained hand”: whether "
                         "the change of stiffness is above the stored threshold"));
    auto* answers = new QHBoxLayout;
    answers->addWidget(m_first);
    answers->addWidget(m_second);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->addButton(m_start, QDialogButtonBox::ActionRole);
    buttons->addButton(m_reset, QDialogButtonBox::ResetRole);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_told);
    layout->addWidget(m_progress);
    layout->addLayout(answers);
    layout->addWidget(m_stored);
    layout->addWidget(m_use);
    layout->addWidget(buttons);
    setMinimumWidth(520);
    m_sampling.setInterval(kWallSample_ms);
    connect(&m_sampling, &QTimer::timeout, this, &ThresholdDialog::sample);
    connect(m_first, &QPushButton::clicked, this, [this] { answer(false); });
    connect(m_second, &QPushButton::clicked, this, [this] { answer(true); });
    connect(m_start, &QPushButton::clicked, this, &ThresholdDialog::toggle);
    connect(m_reset, &QPushButton::clicked, this, [this] {
        ui::OwnThreshold::reset();
        showStored();
    });
    connect(m_use, &QCheckBox::toggled, this, [](bool isUsed) {
        if (auto own = ui::OwnThreshold::stored()) {
            own->isUsed = isUsed;
            own->store();
        }
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    showStored();
    showStage();
}

ThresholdDialog::~ThresholdDialog()
{
    if (m_live.isLent()) {
        (void)m_live.lend(nullptr);
    }
}

/// Esc and Close end a series first.
void ThresholdDialog::done(int result)
{
    if (m_series) {
        endSeries();
        return;
    }
    QDialog::done(result);
}

void ThresholdDialog::toggle()
{
    m_series ? endSeries() : begin();
}

void ThresholdDialog::begin()
{
    m_series.emplace(m_seed++);
    placeWall();
    if (!m_live.isLent()) {
        m_series.reset();
        return;
    }
    m_sampling.start();
    showStage();
}

/// Puts the wall in front of the hand, facing the viewer, with the stiffness of the next press.
void ThresholdDialog::placeWall()
{
    const servo::MapSettings& map = m_live.map();
    const double scale = map.isDirect ? 1.0 : map.scale;
    const Vec3 forward_W(m_viewport.view().camera().GetDirectionOfProjection());
    const double soft_N_per_mm =
        std::min(kDeviceStiffness_N_per_mm / scale, m_live.maxTissue().stiffness_N_per_mm / kStiffest);
    const core::Status lent =
        m_live.lend(study::wallScene(m_live.newest().p_WH + scale * kAhead_mm * forward_W, -forward_W,
                                     scale * kHalfWidth_mm, m_series->ratio() * soft_N_per_mm));
    if (!lent.isOk()) {
        m_told->setText(ui::translated(lent));
    }
}

void ThresholdDialog::sample()
{
    servo::TickRecord tick;
    if (m_live.fetch(tick)) {
        takeForce(tick.felt.structure >= 0 ? tick.felt.f_W.norm() : 0.0);
    }
}

void ThresholdDialog::takeForce(double force_N)
{
    if (m_series && m_series->takeForce(force_N)) {
        if (m_series->stage() == Stage::Second) {
            placeWall(); // the hand is off the wall
        }
        showStage();
    }
}

void ThresholdDialog::answer(bool wasSecondStiffer)
{
    if (!m_series) {
        return;
    }
    m_series->answer(wasSecondStiffer);
    if (m_series->stage() == Stage::Done) {
        endSeries();
        return;
    }
    placeWall();
    showStage();
}

/// Ends the series and keeps the estimate of the answers so far, if there are enough.
void ThresholdDialog::endSeries()
{
    m_sampling.stop();
    (void)m_live.lend(nullptr);
    const study::ThresholdSeries series = m_series->series();
    m_series.reset();
    showStage();
    const std::size_t trials = series.trials().size();
    if (trials < kLeastTrials) {
        m_told->setText(tr("Interrupted after %1 trials. An estimate needs at least %2; nothing was changed.")
                            .arg(trials)
                            .arg(kLeastTrials));
        return;
    }
    ui::OwnThreshold own;
    own.measured = series.estimate();
    own.device = ui::deviceName(m_live.deviceInfo());
    own.trials = static_cast<int>(trials);
    own.isUsed = m_use->isChecked();
    own.store();
    m_told->setText(tr("Done. Your threshold is below."));
    showStored();
}

void ThresholdDialog::showStage()
{
    const bool hasForce = m_live.isRunning() && m_live.deviceInfo().actuatedAxes > 0;
    const Stage stage = m_series ? m_series->stage() : Stage::Done;
    m_first->setEnabled(m_series && stage == Stage::Answer);
    m_second->setEnabled(m_series && stage == Stage::Answer);
    m_start->setText(m_series ? tr("Interrupt") : tr("Start"));
    m_start->setEnabled(m_series || hasForce);
    m_progress->setValue(m_series ? static_cast<int>(m_series->series().trials().size()) : 0);
    m_reset->setEnabled(!m_series && ui::OwnThreshold::stored());
    if (!m_series) {
        m_told->setText(
            hasForce ? tr("Which of two presses is stiffer? In each of 60 trials you press an invisible wall twice and "
                          "tell which press was stiffer. The difference becomes smaller until you can only guess. It "
                          "takes about 8 minutes.")
                     : tr("This needs a device that renders force, with an open scene: with the mouse nothing is "
                          "felt. Choose one in the menu Device."));
    } else if (stage == Stage::First) {
        m_told->setText(tr("First press: push away from you onto the wall, then move back."));
    } else if (stage == Stage::Second) {
        m_told->setText(tr("Second press: push onto the wall again, then move back."));
    } else {
        m_told->setText(tr("Which press was stiffer? Guess if you are not sure."));
    }
}

void ThresholdDialog::showStored()
{
    const auto own = ui::OwnThreshold::stored();
    const QSignalBlocker quiet(m_use);
    m_use->setEnabled(own.has_value());
    m_use->setChecked(own && own->isUsed);
    m_reset->setEnabled(own.has_value() && !m_series);
    m_stored->setText(own ? tr("Your threshold: Weber fraction %1 (95 % interval %2 to %3 %), from %4 trials with %5. "
                               "This increase of stiffness is told apart in 71 % of the trials.")
                                .arg(ui::weberText(own->measured),
                                     QLocale().toString(own->measured.low_percent, 'f', 0),
                                     QLocale().toString(own->measured.high_percent, 'f', 0))
                                .arg(own->trials)
                                .arg(own->device)
                          : tr("No threshold of your own is stored."));
}

} // namespace palpate::app

#include "moc_ThresholdDialog.cpp"
