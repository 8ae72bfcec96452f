// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MainWindow.h"

#include <QImage>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <memory>

namespace palpate::test {

/// The whole window on a display, with settings, documents and pictures in a folder of its own, driven by keys and
/// pointer. Use in `initTestCase`: `if (!Desk::hasDisplay()) QSKIP(...)`.
class Desk
{
  public:
    Desk();

    /// OpenGL needs a display: run under xvfb-run with QT_QPA_PLATFORM=xcb.
    [[nodiscard]] static bool hasDisplay();
    static constexpr const char* kNoDisplay =
        "no OpenGL without a display: run under xvfb-run with QT_QPA_PLATFORM=xcb";

    /// A new window; the one before is closed without a question.
    /// @return false when it is not shown in time
    [[nodiscard]] bool show(QSize size = {1280, 800});
    /// Opens files in the window and waits until they are drawn.
    [[nodiscard]] bool open(const std::vector<std::filesystem::path>& files);
    /// The phantom with its recording. @return false when it is not there
    [[nodiscard]] bool openPhantom();
    void close();

    [[nodiscard]] MainWindow& window() { return *m_window; }
    /// A command by its name in `ui::ActionList`; one that is not there ends the test program.
    [[nodiscard]] QAction& command(const char* id);
    /// Presses a key as a person would: it goes to the widget that has the focus.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    /// Presses a command's first key.
    void pressKeyOf(const char* id);
    [[nodiscard]] QImage picture();
    /// The folder for the test's files.
    [[nodiscard]] std::filesystem::path folder() const { return m_folder.path().toStdString(); }
    /// Writes a mesh as a binary STL into the folder.
    std::filesystem::path writeStl(const char* name, const geometry::TriangleMesh& mesh) const;

  private:
    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
};

/// Whether what a widget shows may be scrolled away: it lies in the moving part of a scrolling panel.
[[nodiscard]] bool isScrolled(const QWidget* widget);

/// Of the messages over the view, a line each, the one on top.
[[nodiscard]] inline QString newest(const QString& messages)
{
    return messages.section(QLatin1Char('\n'), 0, 0);
}

/// The first button of the message on top. @return nothing when it has none
[[nodiscard]] inline QPushButton* answerOf(const palpate::ui::MessageBar& messages)
{
    for (const ui::MessageRow* row : messages.findChildren<ui::MessageRow*>()) {
        if (row->text().section(QLatin1Char('\n'), 0, 0) == newest(messages.text())) {
            return row->findChild<QPushButton*>();
        }
    }
    return nullptr;
}

} // namespace palpate::test
