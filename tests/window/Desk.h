// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "window/MainWindow.h"

#include <palpate/ui/MessageBar.h>

#include <QImage>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <memory>

namespace palpate::test {

/// The whole window on a display, with settings, documents and pictures in a separate folder, driven by keyboard and
/// pointer. Use in `initTestCase`: `if (!Desk::hasDisplay()) QSKIP(...)`.
class Desk
{
  public:
    Desk();

    /// Returns whether a display for OpenGL is available: run under xvfb-run with QT_QPA_PLATFORM=xcb.
    [[nodiscard]] static bool hasDisplay();
    static constexpr const char* kNoDisplay =
        "no OpenGL without a display: run under xvfb-run with QT_QPA_PLATFORM=xcb";

    /// Shows a new window and closes the previous one without a question.
    /// @return false on timeout
    [[nodiscard]] bool show(QSize size = {1280, 800});
    /// Opens files in the window and waits until they are rendered.
    [[nodiscard]] bool open(const std::vector<std::filesystem::path>& files);
    /// Opens the phantom with its recording.
    /// @return false if the files are missing
    [[nodiscard]] bool openPhantom();
    void close();

    [[nodiscard]] MainWindow& window() { return *m_window; }
    /// Returns a command by its name in `ui::ActionList`; an unknown name ends the test program.
    [[nodiscard]] QAction& command(const char* id);
    /// Sends a key press to the widget with the keyboard focus.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    /// Presses a command's first shortcut.
    void pressKeyOf(const char* id);
    [[nodiscard]] QImage picture();
    /// Returns the folder for the test's files.
    [[nodiscard]] std::filesystem::path folder() const { return m_folder.path().toStdString(); }
    /// Writes a mesh as a binary STL into the folder.
    std::filesystem::path writeStl(const char* name, const geometry::TriangleMesh& mesh) const;

  private:
    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
};

/// Returns whether a widget is inside the scrolled content of a panel, so that scrolling may hide the widget.
[[nodiscard]] bool isScrolled(const QWidget* widget);

/// Returns the top line of the messages over the view.
[[nodiscard]] inline QString newest(const QString& messages)
{
    return messages.section(QLatin1Char('\n'), 0, 0);
}

/// Returns the first button of the top message.
/// @return null if the message has no button
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
