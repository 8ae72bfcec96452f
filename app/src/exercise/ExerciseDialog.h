// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "exercise/ExerciseRun.h"

#include <palpate/core/Status.h>

#include <QDialog>
#include <QImage>

#include <filesystem>
#include <functional>
#include <optional>
#include <thread>

class QLabel;
class QPushButton;
class QTextBrowser;

namespace palpate::app {

/// Result page of an exercise. The score is computed on another thread; the page is saved as PDF, web page or JSON.
/// @par Thread GUI thread only.
class ExerciseDialog : public QDialog
{
    Q_OBJECT
  public:
    /// Starts to compute. @param picture  called when the score is there: draws the targets, and returns the view
    ExerciseDialog(const std::filesystem::path& recording, session::MeshesByHash meshes, meshio::Exercise exercise,
                   std::function<QImage(const study::ExerciseScore& score)> picture, QWidget* parent);
    ~ExerciseDialog() override; ///< waits for the score

    /// Score; empty until computed, and if that failed.
    [[nodiscard]] const std::optional<ScoredExercise>& scored() const noexcept { return m_scored; }
    /// Saves the page (`.pdf`, `.html`) or the numbers (`.json`), by the extension of the name.
    void saveTo(const std::filesystem::path& path);

  Q_SIGNALS:
    void againWanted();

  private:
    void present(const core::Result<ScoredExercise>& scored);
    void choose(bool isPage);
    void say(const QString& line);
    [[nodiscard]] study::Report page() const;

    std::filesystem::path m_recording;
    std::function<QImage(const study::ExerciseScore& score)> m_picture;
    QTextBrowser* m_text = nullptr;
    QLabel* m_said = nullptr;
    QPushButton* m_savePage = nullptr;
    QPushButton* m_saveNumbers = nullptr;
    std::optional<ScoredExercise> m_scored;
    QImage m_drawn;
    std::thread m_worker;
};

} // namespace palpate::app
