// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reports/ResultTables.h"

#include <palpate/session/MeasureSession.h>

#include <QDialog>

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;
class QTextBrowser;

/// Results of a recording, computed in a worker thread, with buttons to copy and export. A line below shows the
/// result of an export.
class MeasuresDialog : public QDialog
{
    Q_OBJECT
  public:
    /// Opens the dialog.
    /// @param meshes  surfaces of the open scene; others are loaded from the paths in the recording
    MeasuresDialog(const std::filesystem::path& recording, palpate::session::MeshesByHash meshes,
                   QWidget* parent = nullptr);
    ~MeasuresDialog() override; ///< cancels all work

    enum class Export
    {
        Csv, ///< all ticks
        Vtp, ///< the path, with the touched surface in a second file
        Json ///< results
    };
    /// Exports in a worker thread. A name without an extension gets one; a name with a wrong extension is rejected
    /// with a message.
    void exportTo(Export what, std::filesystem::path path);
    /// Copies all tables to the clipboard for a spreadsheet.
    void copy();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void makeButtons();
    void measure(palpate::session::MeshesByHash meshes);
    void present(palpate::core::Result<palpate::session::SessionMeasures> measured, bool isFingertip);
    void choose(Export what);
    void run(const std::function<QString(const std::function<bool(double)>& progress)>& work);
    void say(const QString& line);
    void setBusy(bool isBusy);

    std::filesystem::path m_recording;
    QTextBrowser* m_text = nullptr;
    QLabel* m_said = nullptr;
    QProgressBar* m_progress = nullptr;
    QPushButton* m_cancel = nullptr;
    QPushButton* m_csv = nullptr;
    std::vector<QPushButton*> m_ofMeasures; ///< enabled once the results are available
    std::shared_ptr<const palpate::session::SessionMeasures> m_measures;
    std::vector<ResultTable> m_tables;
    std::atomic<bool> m_isClosing{false};
    std::atomic<bool> m_isCancelled{false}; ///< cancels the export
    bool m_isBusy = false;
    std::thread m_worker;
    std::thread m_exporter;
};
