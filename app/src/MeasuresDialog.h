// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/session/MeasureSession.h>

#include <QDialog>

#include <atomic>
#include <filesystem>
#include <optional>
#include <thread>

class QPushButton;
class QTextBrowser;

/// What a recording says in numbers, measured on a thread of its own, with buttons that export it.
class MeasuresDialog : public QDialog
{
    Q_OBJECT
  public:
    /// @param meshes  surfaces of the open scene, beside those that the recording holds itself
    MeasuresDialog(const std::filesystem::path& recording, palpate::session::MeshesByHash meshes,
                   QWidget* parent = nullptr);
    ~MeasuresDialog() override; ///< cancels

  private:
    void present(palpate::core::Result<palpate::session::SessionMeasures> measured);
    void exportCsv();
    void exportVtp();
    void tell(const palpate::core::Status& status, const QString& done);

    std::filesystem::path m_recording;
    QTextBrowser* m_text = nullptr;
    QPushButton* m_vtp = nullptr;
    std::optional<palpate::session::SessionMeasures> m_measures;
    std::atomic<bool> m_isCancelled{false};
    std::thread m_worker;
};
