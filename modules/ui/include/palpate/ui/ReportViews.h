// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>
#include <palpate/study/Report.h>

#include <QImage>

#include <cstddef>
#include <memory>

namespace palpate::ui {

/// Draws the pictures of a report: the scene on white, with the findings and a scale bar, in an OpenGL context of its
/// own without a window. Needs a QGuiApplication and a display; with Qt's platform "offscreen" an X server suffices.
/// @par Thread The thread of the QGuiApplication.
class PALPATE_EXPORT ReportViews
{
  public:
    /// Makes the context and uploads nothing yet.
    /// @param facts  with a scene; must outlive the views
    /// @return Unsupported without OpenGL
    [[nodiscard]] static core::Result<std::unique_ptr<ReportViews>> create(const study::ReportFacts& facts);
    ~ReportViews();
    ReportViews(const ReportViews&) = delete;
    ReportViews& operator=(const ReportViews&) = delete;

    /// Draws one of `Report::views`, 4 : 3.
    [[nodiscard]] QImage draw(const study::Report& report, std::size_t view);

  private:
    struct Private;
    explicit ReportViews(std::unique_ptr<Private> d);
    std::unique_ptr<Private> m_d;
};

} // namespace palpate::ui
