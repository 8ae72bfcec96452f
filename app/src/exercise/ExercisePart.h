// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "exercise/ExerciseDialog.h"
#include "shell/WindowPart.h"

#include <palpate/study/ExerciseScore.h>

#include <QImage>
#include <QPointer>
#include <QTimer>

#include <filesystem>
#include <vector>

namespace palpate::ui {
class ExerciseBar;
}

namespace palpate::app {

class DocumentPart;
class RecordingPart;
class TouchPart;

/// The exercise of the open scene: a search for hidden targets. Hides them, records the search, ends it by command or
/// time, shows targets and results.
///
/// Names of hidden targets are kept from all displays by study::OpenScene. This part switches off what would show the
/// targets in another way, such as sections, maps and distances, and sets older findings and tapes aside.
class ExercisePart : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    ExercisePart(const WindowCore& core, DocumentPart& document, TouchPart& touch, RecordingPart& recording);
    ~ExercisePart() override;
    void addActions() override;
    void showState(const WindowState& state) override;

    /// Takes a scene that was just opened; model and document already have it.
    void takeScene();
    /// Results of the last search; null without a dialog.
    [[nodiscard]] ExerciseDialog* results() const { return m_dialog; }

  private:
    enum class Stage
    {
        None,    ///< the scene has no exercise
        Waiting, ///< targets are hidden
        Running, ///< targets are hidden, and the search is recorded
        Ended    ///< targets are shown
    };
    void toggle();
    void start();
    void begin(const std::filesystem::path& recording);
    void end();
    void takeEnd();
    void hide();
    void reveal();
    void unblock();
    void askToReveal();
    void again();
    void showResults();
    void closeResults();
    void follow();
    void showBar();
    void showTargets(const study::ExerciseScore& score);
    void dropTargets();
    [[nodiscard]] QImage picture(const study::ExerciseScore& score);

    WindowCore m_core;
    DocumentPart& m_document;
    TouchPart& m_touch;
    RecordingPart& m_recording;
    ui::ExerciseBar* m_bar = nullptr;
    QPointer<ExerciseDialog> m_dialog;
    QTimer m_clock;
    Stage m_stage = Stage::None;
    std::filesystem::path m_file; ///< recording of the search
    std::vector<int> m_faded;     ///< structures drawn translucent around the shown targets
    bool m_isBlocked = false;     ///< other commands are withheld
};

} // namespace palpate::app
