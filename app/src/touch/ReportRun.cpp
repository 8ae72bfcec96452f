// SPDX-License-Identifier: BSD-3-Clause
#include "touch/ReportRun.h"

#include <palpate/ui/ReportFile.h>
#include <palpate/ui/Translated.h>

#include <QMetaObject>
#include <QTimer>

#include <utility>

namespace palpate::app {

namespace {

constexpr int kShortRun_ms = 500; // shorter runs show no progress
constexpr int kSteps = 1000;
constexpr double kFactsShare = 0.6, kPicturesShare = 0.9; // of the whole run

} // namespace

ReportRun::ReportRun(std::filesystem::path recording, study::ReportOptions options, std::filesystem::path out,
                     QWidget* parent)
    : QObject(parent)
    , m_recording(std::move(recording))
    , m_out(std::move(out))
    , m_options(std::move(options))
    , m_progress(parent)
{
    m_progress.setWindowTitle(tr("Report"));
    m_progress.setWindowModality(Qt::WindowModal);
    m_progress.setMinimumDuration(kShortRun_ms);
    m_progress.setRange(0, kSteps);
    m_progress.setAutoClose(false);
    m_progress.setAutoReset(false);
    connect(&m_progress, &QProgressDialog::canceled, this, [this] { m_isCancelled = true; });
    m_progress.setValue(0);
    m_options.isCancelled = &m_isCancelled;
    m_options.progress = [this](double share, const core::Message& step) {
        QMetaObject::invokeMethod(
            this, [this, share, step] { show(kFactsShare * share, step); }, Qt::QueuedConnection);
    };
    m_worker = std::thread([this] {
        auto facts = std::make_shared<core::Result<study::ReportFacts>>(study::gatherReport(m_recording, m_options));
        QMetaObject::invokeMethod(
            this, [this, facts] { takeFacts(std::move(*facts)); }, Qt::QueuedConnection);
    });
}

ReportRun::~ReportRun()
{
    m_isCancelled = true;
    if (m_worker.joinable()) {
        m_worker.join();
    }
}

void ReportRun::show(double share, const core::Message& step)
{
    if (!m_isCancelled) {
        m_progress.setLabelText(ui::translated(step));
        m_progress.setValue(static_cast<int>(kSteps * share));
    }
}

void ReportRun::takeFacts(core::Result<study::ReportFacts> facts)
{
    m_worker.join();
    if (!facts.isOk()) {
        end(facts.status());
        return;
    }
    m_facts = std::move(facts).value();
    m_report = study::composeReport(*m_facts);
    for (const core::Message& one : m_facts->missing) {
        m_missing << ui::translated(one);
    }
    if (m_facts->scene != nullptr) {
        auto views = ui::ReportViews::create(*m_facts);
        if (views.isOk()) {
            m_views = std::move(views).value();
        } else {
            m_report = study::composeReport(*m_facts, views.status().text());
            m_missing << ui::translated(views.status());
        }
    }
    QTimer::singleShot(0, this, &ReportRun::drawNext);
}

void ReportRun::drawNext()
{
    const std::size_t number = m_pictures.size();
    if (m_isCancelled) {
        end(core::Status(core::StatusCode::Cancelled, PALPATE_TEXT("the report was cancelled")));
    } else if (m_views == nullptr || number == m_report.views.size()) {
        m_views.reset();
        write();
    } else {
        m_pictures.push_back(m_views->draw(m_report, number));
        const double drawn = static_cast<double>(number + 1) / static_cast<double>(m_report.views.size());
        show(kFactsShare + (kPicturesShare - kFactsShare) * drawn, core::Message(PALPATE_TEXT("Drawing the pictures")));
        QTimer::singleShot(0, this, &ReportRun::drawNext);
    }
}

void ReportRun::write()
{
    show(kPicturesShare, core::Message(PALPATE_TEXT("Writing the report")));
    m_worker = std::thread([this] {
        const core::Status status = ui::writeReport(m_out, m_report, m_pictures);
        QMetaObject::invokeMethod(
            this,
            [this, status] {
                m_worker.join();
                end(status);
            },
            Qt::QueuedConnection);
    });
}

void ReportRun::end(const core::Status& status)
{
    m_progress.reset();
    if (status.isOk()) {
        Q_EMIT written(m_missing);
    } else if (status.code() == core::StatusCode::Cancelled) {
        Q_EMIT cancelled();
    } else {
        Q_EMIT failed(ui::translated(status));
    }
    deleteLater();
}

} // namespace palpate::app

#include "moc_ReportRun.cpp"
