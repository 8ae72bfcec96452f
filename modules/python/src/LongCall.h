// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <future>
#include <utility>

namespace palpate::python {

namespace py = pybind11;

/// Runs the handlers of signals that have arrived, such as Ctrl-C, if this is Python's main thread.
/// @return false if a handler raised an exception, which stays set
/// @pre the GIL is not held
[[nodiscard]] bool handleSignals();

/// Throws the exception that `handleSignals` left.
/// @pre the GIL is held
void throwIfRaised();

/// Runs `work(isCancelled)` on another thread without the GIL, so that other Python threads continue, and handles
/// signals meanwhile. Ctrl-C sets `isCancelled` and raises KeyboardInterrupt as soon as `work` has returned.
/// @param work  must not use Python objects
template<class Work>
auto longCall(Work work)
{
    constexpr std::chrono::milliseconds kPoll{50};
    std::atomic<bool> isCancelled{false};
    std::future<decltype(work(isCancelled))> result;
    {
        const py::gil_scoped_release released;
        result = std::async(std::launch::async, [&] { return work(isCancelled); });
        while (!isCancelled && result.wait_for(kPoll) != std::future_status::ready) {
            isCancelled = !handleSignals();
        }
        result.wait();
    }
    throwIfRaised();
    return result.get();
}

/// Handles signals every few thousand ticks of a loop that runs without the GIL.
class SignalCheck
{
  public:
    /// @return false to end the loop; `throwIfRaised` then throws
    [[nodiscard]] bool goesOn() { return ++m_ticks % kInterval != 0 || handleSignals(); }

  private:
    static constexpr std::int64_t kInterval = 4096;
    std::int64_t m_ticks = 0;
};

} // namespace palpate::python
