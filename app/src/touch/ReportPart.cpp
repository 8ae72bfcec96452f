// SPDX-License-Identifier: BSD-3-Clause
#include "touch/ReportPart.h"

#include "scene/DocumentPart.h"
#include "scene/SceneDocument.h"
#include "shared/Console.h"
#include "shared/Paths.h"
#include "shell/Notices.h"
#include "touch/ReportDialog.h"
#include "touch/ReportRun.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/RecordedTouch.h>
#include <palpate/ui/ReportFile.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/Translated.h>

#include <QAction>
#include <QDesktopServices>
#include <QFileDialog>
#include <QMainWindow>
#include <QUrl>

#include <algorithm>
#include <memory>
#include <utility>

namespace palpate::app {

using ui::ActionGroup;

namespace {

/// Returns the open scene, for recordings whose own scene is no longer available.
std::shared_ptr<const meshio::LoadedScene> openedScene(const ui::StructureModel& model)
{
    auto scene = std::make_shared<meshio::LoadedScene>();
    for (const study::OpenStructure& row : model.rows()) {
        if (!row.isRemoved) {
            scene->structures.push_back(row.loaded);
            scene->scene.structures.push_back(row.loaded.description);
        }
    }
    return scene;
}

} // namespace

ReportPart::ReportPart(const WindowCore& core, DocumentPart& document, const ui::Playback& playback)
    : WindowPart(&core.window)
    , m_core(core)
    , m_document(document)
    , m_playback(playback)
{
}

void ReportPart::addActions()
{
    connect(m_core.actions.add("report", ActionGroup::File, tr("Report…"),
                               tr("Write a report of the recording as PDF or web page"),
                               {QKeySequence(Qt::CTRL | Qt::Key_P)}),
            &QAction::triggered, this, &ReportPart::ask);
}

void ReportPart::showState(const WindowState& state)
{
    m_isRecording = state.isRecording;
    m_core.actions.at("report").setEnabled(state.hasScene || state.hasRecording);
}

/// Offers to record, or to end the running recording, where a report cannot be written yet.
void ReportPart::offerRecording()
{
    ui::MessageBar& bar = m_core.notices.bar();
    bar.withdraw(m_offer);
    QAction& record = m_core.actions.at("record");
    if (m_isRecording) {
        m_offer = tr("The report describes a finished recording.");
        bar.offer(m_offer, tr("Stop and report…"), [this, &record] {
            if (m_isRecording) {
                record.trigger();
            }
            if (!m_isRecording && m_playback.recording() != nullptr) {
                ask();
            }
        });
    } else {
        m_offer =
            tr("The report describes a recording: record, press, mark findings and stop. Then choose Report again.");
        bar.offer(m_offer, tr("Record"), [this, &record] {
            if (!m_isRecording) {
                record.trigger();
            }
        });
    }
}

void ReportPart::ask()
{
    if (m_isRecording || m_playback.recording() == nullptr) {
        offerRecording();
        return;
    }
    m_core.notices.bar().withdraw(m_offer);
    auto* dialog = new ReportDialog(&m_core.window);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { choose(dialog->caseText(), dialog->examiner()); });
    dialog->open();
}

void ReportPart::choose(const QString& caseText, const QString& examiner)
{
    if (m_playback.recording() == nullptr) {
        return;
    }
    std::filesystem::path suggested = m_playback.recording()->path();
    suggested.replace_extension(".pdf");
    const QString pages = tr("PDF for printing (*.pdf)"), web = tr("Web page, for screen readers too (*.html)");
    QString filter = pages;
    const QString chosen = QFileDialog::getSaveFileName(&m_core.window, tr("Report"), toText(suggested),
                                                        pages + QStringLiteral(";;") + web, &filter);
    if (!chosen.isEmpty()) {
        write(toPath(chosen), filter == web ? QStringLiteral(".html") : QStringLiteral(".pdf"), caseText, examiner);
    }
}

void ReportPart::write(std::filesystem::path out, const QString& ending, const QString& caseText,
                       const QString& examiner)
{
    if (m_playback.recording() == nullptr) {
        return;
    }
    Notices& notices = m_core.notices;
    std::error_code error;
    if (out.extension().empty()) {
        out += ending.toStdString();
        if (std::filesystem::exists(out, error)) { // the file dialog confirmed a different name
            notices.showError(
                tr("Nothing was written: %1 already exists. Enter the full file name to replace the file.")
                    .arg(toText(out)));
            return;
        }
    }
    if (!ui::reportFormatOf(out)) {
        notices.showError(tr("Nothing was written: %1 must end in .pdf or .html.").arg(toText(out.filename())));
        return;
    }
    const std::filesystem::path recording = m_playback.recording()->path();
    if (const core::Status allowed = checkOutputs({recording}, {out}); !allowed.isOk()) {
        notices.showError(ui::translated(allowed));
        return;
    }
    study::ReportOptions options;
    options.opened = openedScene(m_core.model);
    options.findings = m_document.document().findings();
    options.tapes = m_document.document().tapesModel().tapes();
    options.caseText = caseText.toStdString();
    options.examiner = examiner.toStdString();
    auto* run = new ReportRun(recording, std::move(options), out, &m_core.window);
    connect(run, &ReportRun::written, this, [this, out](const QStringList& missing) { showWritten(out, missing); });
    connect(run, &ReportRun::failed, this, [this](const QString& line) { m_core.notices.showError(line); });
    connect(run, &ReportRun::cancelled, this, [this] { m_core.notices.say(tr("Report cancelled")); });
}

void ReportPart::showWritten(const std::filesystem::path& out, const QStringList& missing)
{
    m_core.notices.warn(missing);
    ui::MessageBar& bar = m_core.notices.bar();
    bar.withdraw(m_written);
    const int outside = findingsOutside();
    m_written =
        !missing.isEmpty() ? tr("Report written to %1; it lists the missing parts").arg(toText(out))
        : outside > 0
            ? tr("Report written to %1; %n finding(s) marked outside of the recording are in a table of their own",
                 nullptr, outside)
                  .arg(toText(out))
            : tr("Report written to %1").arg(toText(out));
    bar.offer(m_written, tr("Open the report"), [this, out] { openFile(out); });
}

void ReportPart::openFile(const std::filesystem::path& out)
{
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(toText(out)))) {
        m_core.notices.showError(tr("No program was found that opens %1.").arg(toText(out)));
    }
}

/// Number of findings of the scene that the recording does not contain, such as those marked before or afterwards.
int ReportPart::findingsOutside() const
{
    const std::vector<core::Finding> inside =
        m_playback.recording() == nullptr ? std::vector<core::Finding>() : m_playback.recording()->findings();
    const std::vector<core::Finding>& all = m_document.document().findings();
    return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const core::Finding& one) {
        return one.hasPlace && std::none_of(inside.begin(), inside.end(), [&](const core::Finding& other) {
                   return one.id.empty() ? one.p_W == other.p_W : one.id == other.id;
               });
    }));
}

} // namespace palpate::app

#include "moc_ReportPart.cpp"
