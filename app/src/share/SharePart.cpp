// SPDX-License-Identifier: BSD-3-Clause
#include "share/SharePart.h"

#include "scene/DocumentPart.h"
#include "scene/SceneFiles.h"
#include "share/ReceivedSurfaces.h"
#include "share/ShareDialog.h"
#include "shell/Notices.h"

#include <palpate/study/FindingsFile.h>
#include <palpate/ui/ActionList.h>
#include <palpate/ui/ChipRow.h>
#include <palpate/ui/Translated.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QMainWindow>

#include <cmath>
#include <string>
#include <vector>

namespace palpate::app {

using ui::ActionGroup;

namespace {

constexpr int kShareEvery_ms = 33; // of a display at 30 Hz, as the server sends
constexpr int kShareRefresh_ms = 500;
constexpr int kAddRetry_ms = 100;
constexpr auto kFindingsName = "PalpateFindings";

/// Findings as a table that fits into one message; the last ones are left out if there are too many. Without the paths
/// of recordings, which may name people.
std::string sharedFindings(std::vector<core::Finding> findings)
{
    for (core::Finding& finding : findings) {
        finding.recording.reset();
    }
    std::string table = study::findingsCsv(findings);
    while (table.size() > igtl::kMaxText_bytes) {
        findings.resize(findings.size() / 2);
        table = study::findingsCsv(findings);
    }
    return table;
}

} // namespace

SharePart::SharePart(const WindowCore& core, DocumentPart& document, SceneFiles& files)
    : WindowPart(&core.window)
    , m_core(core)
    , m_document(document)
    , m_files(files)
    , m_chip(*core.chips.add("share", tr("Sharing"), 1))
    , m_received(new ReceivedSurfaces(this))
{
    m_chip.say({});
    m_sample.setInterval(kShareEvery_ms);
    m_sample.setTimerType(Qt::PreciseTimer);
    connect(&m_sample, &QTimer::timeout, this, &SharePart::shareTouch);
    m_refresh.setInterval(kShareRefresh_ms);
    connect(&m_refresh, &QTimer::timeout, this, &SharePart::refresh);
    m_adding.setInterval(kAddRetry_ms);
    connect(&m_adding, &QTimer::timeout, this, &SharePart::addNext);
    connect(&document.document(), &SceneDocument::findingsChanged, this, &SharePart::shareFindings);
    // Emitted on the thread of the writer or of the server.
    connect(m_received, &ReceivedSurfaces::stored, this, &SharePart::takeSurface, Qt::QueuedConnection);
    connect(
        m_received, &ReceivedSurfaces::failed, this, [this](const QString& line) { m_core.notices.showError(line); },
        Qt::QueuedConnection);
}

SharePart::~SharePart()
{
    m_server.stop(); // before m_received, which is used on the thread of the server
    delete m_received;
}

void SharePart::addActions()
{
    connect(m_core.actions.add("share", ActionGroup::Device, tr("Share with 3D Slicer…"),
                               tr("Send the touch and the findings to 3D Slicer and receive surfaces, by OpenIGTLink")),
            &QAction::triggered, this, &SharePart::ask);
}

void SharePart::ask()
{
    if (m_dialog == nullptr) {
        m_dialog = new ShareDialog(&m_core.window);
        connect(m_dialog, &ShareDialog::startWanted, this, &SharePart::begin);
        connect(m_dialog, &ShareDialog::stopWanted, this, &SharePart::end);
    }
    refresh();
    m_dialog->show();
    m_dialog->raise();
    m_dialog->activateWindow();
}

void SharePart::begin()
{
    const core::Status status = m_server.start(
        m_dialog->options(), [received = m_received](igtl::ReceivedSurface one) { received->take(std::move(one)); });
    if (!status.isOk()) {
        m_dialog->showFailure(ui::translated(status));
        return;
    }
    m_sent = 0;
    m_sinceRefresh.start();
    m_sample.start();
    m_refresh.start();
    shareFindings();
    refresh();
}

void SharePart::end()
{
    m_sample.stop();
    m_refresh.stop();
    m_server.stop();
    refresh();
}

void SharePart::shareTouch()
{
    const view::TouchState& shown = m_core.viewport.view().cursor().state();
    igtl::SharedTouch touch;
    touch.isPresent = shown.isPresent;
    for (int i = 0; i < 3; ++i) {
        touch.hand_mm[i] = shown.p_WH[i];
        touch.godObject_mm[i] = shown.p_WG[i];
        touch.force_N[i] = shown.f_W[i];
    }
    m_server.setTouch(touch);
}

void SharePart::shareFindings()
{
    if (m_server.isRunning()) {
        m_server.setText(kFindingsName, sharedFindings(m_document.document().findings()));
    }
}

void SharePart::refresh()
{
    const igtl::ShareReport report = m_server.report();
    const auto passed_ms = m_sinceRefresh.isValid() ? m_sinceRefresh.restart() : 0;
    const double perSecond =
        passed_ms > 0 ? 1000.0 * static_cast<double>(report.sent - m_sent) / static_cast<double>(passed_ms) : 0.0;
    m_sent = report.sent;
    const bool isShared = report.port != 0;
    m_chip.say(!isShared ? QString() : report.peers.empty() ? tr("sharing") : tr("shared with 3D Slicer"));
    m_chip.setToolTip(
        isShared ? tr("OpenIGTLink server at port %1. To stop it: Device › Share with 3D Slicer…").arg(report.port)
                 : QString());
    if (m_dialog != nullptr) {
        m_dialog->showReport(report, perSecond);
    }
}

void SharePart::takeSurface(const std::filesystem::path& file, const QString& name)
{
    m_surfaces.emplace_back(file, name);
    addNext();
}

/// Adds one surface, unless files are being opened, which another opening would cancel.
void SharePart::addNext()
{
    if (!m_surfaces.empty() && !m_files.loader().isBusy()) {
        const auto [file, name] = m_surfaces.front();
        m_surfaces.pop_front();
        m_core.notices.say(tr("%1 was received from 3D Slicer.").arg(name));
        m_files.add({file});
    }
    if (m_surfaces.empty()) {
        m_adding.stop();
    } else if (!m_adding.isActive()) {
        m_adding.start();
    }
}

} // namespace palpate::app

#include "moc_SharePart.cpp"
