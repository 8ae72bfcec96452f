// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/VisibleText.h>

#include <chrono>
#include <cstdio>
#include <string>

#include <unistd.h>

namespace palpate::app {

/// Progress on stderr: one line that is overwritten at most ten times a second; a new line per 10 % if stderr is not
/// a terminal.
class ProgressLine
{
  public:
    bool show(double share, const std::string& what)
    {
        if (!m_isTerminal) {
            if (share >= m_nextTenth) {
                std::fprintf(stderr, "%3.0f %%  %s\n", 100.0 * share, core::visible(what).c_str());
                m_nextTenth = share + 0.1;
            }
            return true;
        }
        const auto now = std::chrono::steady_clock::now();
        if (now - m_last >= std::chrono::milliseconds(100)) {
            m_last = now;
            std::fprintf(stderr, "\r%3.0f %%  %-66.66s", 100.0 * share, core::visible(what).c_str());
            m_isShown = true;
        }
        return true;
    }
    ~ProgressLine()
    {
        if (m_isShown) {
            std::fprintf(stderr, "\r%-73s\r", "");
        }
    }

  private:
    std::chrono::steady_clock::time_point m_last;
    bool m_isTerminal = isatty(STDERR_FILENO) == 1;
    bool m_isShown = false;
    double m_nextTenth = 0.1;
};

} // namespace palpate::app
