// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ResultTables.h"

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

/// The results of a recording, measured on a thread of its own, with buttons that copy and export them. What became of
/// an export is said in a line below.
class MeasuresDialog : public QDialog
{
    Q_OBJECT
  public:
    /// @param meshes  surfaces of the open scene; those that are not among them are looked for where the recording says
    MeasuresDialog(const std::filesystem::path& recording, palpate::session::MeshesByHash meshes,
                   QWidget* parent = nullptr);
    ~MeasuresDialog() override; ///< cancels

    enum class Export
    {
        Csv, ///< every tick
        Vtp, ///< the path, and the touched surface beside it
        Json ///< the results
    };
    /// Writes on a thread of its own. A name without an ending gets one; one of another kind is refused, in words.
    void exportTo(Export what, std::filesystem::path path);
    /// Puts all tables on the clipboard, for a spreadsheet.
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
    std::vector<QPushButton*> m_ofMeasures; ///< need them to be there
    std::shared_ptr<const palpate::session::SessionMeasures> m_measures;
    std::vector<ResultTable> m_tables;
    std::atomic<bool> m_isClosing{false};
    std::atomic<bool> m_isCancelled{false}; ///< the export
    bool m_isBusy = false;
    std::thread m_worker;
    std::thread m_exporter;
};
