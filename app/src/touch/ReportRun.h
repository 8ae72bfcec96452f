// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/study/Report.h>
#include <palpate/ui/ReportViews.h>

#include <QImage>
#include <QObject>
#include <QProgressDialog>
#include <QString>
#include <QStringList>

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

namespace palpate::app {

/// Computes and writes a report: facts and file in a worker thread, one picture at a time in the GUI thread. From half
/// a second on, a dialog shows the progress and cancels.
/// @par Thread GUI thread only.
class ReportRun : public QObject
{
    Q_OBJECT
  public:
    /// Starts. @param out  ends in .pdf or .html
    ReportRun(std::filesystem::path recording, study::ReportOptions options, std::filesystem::path out,
              QWidget* parent);
    ~ReportRun() override; ///< cancels

  Q_SIGNALS:
    /// The report has been written. @param missing  what is missing in the report, one sentence each
    void written(const QStringList& missing);
    void failed(const QString& line);
    void cancelled();

  private:
    void show(double share, const core::Message& step);
    void takeFacts(core::Result<study::ReportFacts> facts);
    void drawNext();
    void write();
    void end(const core::Status& status);

    std::filesystem::path m_recording, m_out;
    study::ReportOptions m_options;
    std::atomic<bool> m_isCancelled{false};
    QProgressDialog m_progress;
    std::optional<study::ReportFacts> m_facts;
    study::Report m_report;
    QStringList m_missing;
    std::unique_ptr<ui::ReportViews> m_views;
    std::vector<QImage> m_pictures;
    std::thread m_worker;
};

} // namespace palpate::app
