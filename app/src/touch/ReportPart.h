// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <QString>

#include <filesystem>

namespace palpate::ui {
class Playback;
}

namespace palpate::app {

class ReportRun;

/// Report of the open recording as PDF or HTML.
class ReportPart : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    ReportPart(const WindowCore& core, const ui::Playback& playback);
    void addActions() override;
    void showState(const WindowState& state) override;

    /// Writes the report of the open recording. A name without an extension gets `ending`; a name with an unknown
    /// extension is rejected with a message. @param ending  ".pdf" or ".html"
    void write(std::filesystem::path out, const QString& ending, const QString& caseText, const QString& examiner);

  private:
    void ask();
    void choose(const QString& caseText, const QString& examiner);

    WindowCore m_core;
    const ui::Playback& m_playback;
};

} // namespace palpate::app
