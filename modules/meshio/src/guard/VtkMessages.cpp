// SPDX-License-Identifier: BSD-3-Clause
#include "guard/VtkMessages.h"

#include "text/TextScan.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <atomic>
#include <cstdio>
#include <mutex>
#include <string_view>

namespace palpate::meshio::internal {

namespace {

thread_local VtkMessages* t_collector = nullptr;

// VTK also logs to the console, for all threads at once. Logging is off while any thread collects messages.
std::mutex g_mutex;
std::atomic<int> g_collectors{0};
vtkLogger::Verbosity g_verbosity = vtkLogger::VERBOSITY_INFO;

/// Passes a message to the collector of the thread or, without a collector, to the previous output window.
class ThreadOutputWindow : public vtkOutputWindow
{
  public:
    static ThreadOutputWindow* New();
    vtkTypeMacro(ThreadOutputWindow, vtkOutputWindow)

        void DisplayText(const char* text) override
    {
        forward(text, &vtkOutputWindow::DisplayText);
    }
    void DisplayErrorText(const char* text) override
    {
        if (t_collector != nullptr) {
            t_collector->addError(text);
        } else {
            forward(text, &vtkOutputWindow::DisplayErrorText);
        }
    }
    void DisplayWarningText(const char* text) override { forward(text, &vtkOutputWindow::DisplayWarningText); }
    void DisplayGenericWarningText(const char* text) override
    {
        forward(text, &vtkOutputWindow::DisplayGenericWarningText);
    }
    void DisplayDebugText(const char* text) override { forward(text, &vtkOutputWindow::DisplayDebugText); }

    ThreadOutputWindow(const ThreadOutputWindow&) = delete;
    void operator=(const ThreadOutputWindow&) = delete;

  protected:
    ThreadOutputWindow() { m_before = vtkOutputWindow::GetInstance(); }
    ~ThreadOutputWindow() override = default;

  private:
    void forward(const char* text, void (vtkOutputWindow::*display)(const char*))
    {
        if (t_collector != nullptr || m_before == nullptr) {
            return;
        }
        if (g_collectors.load() > 0 && std::string_view(m_before->GetClassName()) == "vtkOutputWindow") {
            std::fputs(text, stderr); // vtkOutputWindow prints through VTK's logger, which is off
        } else {
            (m_before->*display)(text);
        }
    }

    vtkSmartPointer<vtkOutputWindow> m_before;
};

vtkStandardNewMacro(ThreadOutputWindow)

} // namespace

VtkMessages::VtkMessages()
    : m_outer(t_collector)
{
    static std::once_flag installed;
    std::call_once(installed, [] {
        const auto window = vtkSmartPointer<ThreadOutputWindow>::New();
        vtkOutputWindow::SetInstance(window);
    });
    const std::lock_guard lock(g_mutex);
    if (g_collectors.fetch_add(1) == 0) {
        g_verbosity = vtkLogger::GetCurrentVerbosityCutoff();
        vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    }
    t_collector = this;
}

VtkMessages::~VtkMessages()
{
    t_collector = m_outer;
    const std::lock_guard lock(g_mutex);
    if (g_collectors.fetch_sub(1) == 1) {
        vtkLogger::SetStderrVerbosity(g_verbosity);
    }
}

void VtkMessages::addError(const char* text)
{
    if (!m_firstError.empty()) {
        return;
    }
    // "ERROR: In file.cxx, line n\nvtkClass (0x…): what happened\n\n"
    std::string_view rest = text;
    if (const std::size_t address = rest.find("): "); address != std::string_view::npos) {
        rest.remove_prefix(address + 3);
    }
    rest = trimmed(rest);
    for (const char c : rest.substr(0, 200)) {
        // VTK may quote control characters from the file.
        m_firstError += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    if (m_firstError.empty()) {
        m_firstError = "an error without a text";
    }
}

} // namespace palpate::meshio::internal
