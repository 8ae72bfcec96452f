// SPDX-License-Identifier: BSD-3-Clause
#include "touch/DeviceTests.h"

#include "shared/Paths.h"

#include <palpate/study/SelfTestPage.h>
#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/Translated.h>

#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QUrl>
#include <QVBoxLayout>

#include <utility>

namespace palpate::app {

namespace {

constexpr int kTestPoll_ms = 40;
constexpr int kTestWidth_px = 520;

QString checkedKey(const device::DeviceInfo& info)
{
    return QStringLiteral("axesChecked/%1").arg(QString::fromStdString(info.id));
}

/// Makes a window-modal dialog with a text that wraps.
QLabel* addText(QDialog& dialog, QVBoxLayout& layout, int lines)
{
    dialog.setAttribute(Qt::WA_DeleteOnClose);
    dialog.setWindowModality(Qt::WindowModal);
    dialog.setMinimumWidth(kTestWidth_px);
    auto* label = new QLabel(&dialog);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setMinimumHeight(lines * dialog.fontMetrics().lineSpacing());
    label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    layout.addWidget(label);
    return label;
}

} // namespace

SelfTestDialog::SelfTestDialog(ui::LiveTouch& live, QWidget* parent)
    : QDialog(parent)
    , m_live(live)
{
    setWindowTitle(tr("Device test"));
    auto* layout = new QVBoxLayout(this);
    m_text = addText(*this, *layout, 8);
    const device::DeviceInfo& info = live.deviceInfo();
    m_text->setText(
        tr("For about one minute, small forces move the handle, and virtual walls of rising stiffness press "
           "against your hand with up to %1 N. The test measures round trip, noise, friction and the "
           "stiffness that %2 holds without vibrating. Clear the space around the handle. You can stop the "
           "test at any time; the wall is withdrawn at the first sign of instability.")
            .arg(ui::numberText(servo::mostTestForce_N(info), 2), QString::fromStdString(info.name)));
    m_progress = new QProgressBar(this);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Progress of the test"));
    layout->addWidget(m_progress);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_start = buttons->addButton(tr("Start the test"), QDialogButtonBox::ActionRole);
    m_start->setDefault(true);
    m_save = buttons->addButton(tr("Save the page…"), QDialogButtonBox::ActionRole);
    m_save->setEnabled(false);
    layout->addWidget(buttons);
    m_poll.setInterval(kTestPoll_ms);
    connect(m_start, &QPushButton::clicked, this, &SelfTestDialog::toggle);
    connect(m_save, &QPushButton::clicked, this, &SelfTestDialog::save);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(&m_poll, &QTimer::timeout, this, &SelfTestDialog::follow);
}

SelfTestDialog::~SelfTestDialog()
{
    if (m_run != nullptr) {
        m_run.reset();
        (void)m_live.start();
    }
}

/// Esc and Close stop a test first.
void SelfTestDialog::done(int code)
{
    if (m_run != nullptr) {
        m_run->cancel();
        return;
    }
    QDialog::done(code);
}

void SelfTestDialog::toggle()
{
    if (m_run != nullptr) {
        m_run->cancel();
    } else {
        begin();
    }
}

void SelfTestDialog::begin()
{
    m_result.reset();
    m_save->setEnabled(false);
    m_live.stop(); // the device belongs to the test
    auto run = std::make_unique<servo::SelfTestRun>();
    if (const core::Status status = run->start(*m_live.device(), {.rate_Hz = m_live.rate_Hz()}); !status.isOk()) {
        m_text->setText(ui::translated(status));
        (void)m_live.start();
        return;
    }
    m_run = std::move(run);
    m_start->setText(tr("Stop"));
    m_poll.start();
}

void SelfTestDialog::follow()
{
    const bool isRunning = m_run->poll();
    m_progress->setValue(static_cast<int>(100.0 * m_run->progress()));
    if (!isRunning) {
        end();
    } else if (const core::Message line = servo::instruction(m_run->step()); !line.english().empty()) {
        m_text->setText(ui::translated(line));
    }
}

void SelfTestDialog::end()
{
    m_poll.stop();
    m_result = m_run->finish();
    m_run.reset();
    m_start->setText(tr("Start the test"));
    QStringList lines;
    for (const core::Message& line : servo::unmeasured(*m_result)) {
        lines << ui::translated(line);
    }
    if (!m_result->isFailed()) {
        for (const core::Message& line : study::selfTestLines(*m_result)) {
            lines << ui::translated(line);
        }
        m_save->setEnabled(true);
    }
    if (const core::Status status = m_live.start(); !status.isOk()) { // the pointer touches now
        lines << ui::translated(status);
        m_start->setEnabled(false);
    }
    m_text->setText(lines.join(QLatin1Char('\n')));
}

void SelfTestDialog::save()
{
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for the page"), documentsFolder());
    if (folder.isEmpty()) {
        return;
    }
    const std::filesystem::path path = toPath(folder);
    if (const core::Status status = study::writeSelfTest(path, *m_result); !status.isOk()) {
        m_text->setText(ui::translated(status));
        return;
    }
    QDesktopServices::openUrl(QUrl::fromLocalFile(toText(study::selfTestFiles(path).back())));
}

AxisCheckDialog::AxisCheckDialog(ui::LiveTouch& live, QWidget* parent)
    : QDialog(parent)
    , m_live(live)
    , m_check(live.deviceInfo())
{
    setWindowTitle(tr("Check of the axes"));
    auto* layout = new QVBoxLayout(this);
    m_text = addText(*this, *layout, 10);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(&m_poll, &QTimer::timeout, this, &AxisCheckDialog::follow);
    m_time.start();
    m_poll.start(kTestPoll_ms);
    follow();
}

bool AxisCheckDialog::wasDone(const device::DeviceInfo& info)
{
    return QSettings().contains(checkedKey(info));
}

void AxisCheckDialog::follow()
{
    servo::TickRecord tick;
    (void)m_live.fetch(tick);
    tick = m_live.newest();
    // The check compares positions, so that the offset of the workspace map does not matter.
    const servo::MapSettings& map = m_live.map();
    device::DeviceState state;
    state.isPresent = (tick.flags & (servo::kNoHand | servo::kClutched)) == 0;
    state.p_D = map.isDirect ? tick.p_WH : core::Vec3(map.q_WD.inverse() * tick.p_WH / map.scale);
    m_check.follow(state, 0.001 * static_cast<double>(m_time.elapsed()));
    QStringList lines;
    for (std::size_t i = 0; i < m_check.current(); ++i) {
        lines << ui::translated(m_check.statement(i));
    }
    if (!m_check.isDone()) {
        lines << ui::translated(m_check.instruction());
    } else {
        m_poll.stop();
        lines << (m_check.isRight() ? tr("All axes follow the hand.") : ui::translated(m_check.remedy()));
        QSettings().setValue(checkedKey(m_live.deviceInfo()), m_check.isRight());
    }
    m_text->setText(lines.join(QStringLiteral("\n\n")));
}

} // namespace palpate::app

#include "moc_DeviceTests.cpp"
