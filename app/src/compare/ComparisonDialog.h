// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reports/ResultTables.h"

#include <palpate/study/CompareRecordings.h>

#include <QDialog>

#include <atomic>
#include <filesystem>
#include <thread>
#include <vector>

class QPushButton;
class QTextBrowser;

namespace palpate::app {

/// Tables of `session compare`, computed in a worker thread, with a button to copy. Closing cancels.
/// @par Thread GUI thread only.
class ComparisonDialog : public QDialog
{
    Q_OBJECT
  public:
    ComparisonDialog(const std::filesystem::path& first, const std::filesystem::path& second,
                     study::CompareOptions options, QWidget* parent);
    ~ComparisonDialog() override;
    /// Copies all tables to the clipboard for a spreadsheet.
    void copy();

  private:
    void present(const core::Result<study::RecordingComparison>& compared);

    QTextBrowser* m_text;
    QPushButton* m_copy;
    std::vector<ResultTable> m_tables;
    std::atomic<bool> m_isClosing{false};
    std::thread m_worker;
};

} // namespace palpate::app
