// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "HaplyBench.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>

namespace standin {

/// Emulated Inverse Service: an own thread with a WebSocket server at a free port of 127.0.0.1, which also answers
/// GET /version. Sends an inventory on connection, then one state for each message. A force is forgotten 20 ms after
/// the last message.
class HaplyService
{
  public:
    HaplyService();
    ~HaplyService();
    HaplyService(const HaplyService&) = delete;
    HaplyService& operator=(const HaplyService&) = delete;

    [[nodiscard]] std::uint16_t port() const noexcept { return m_port; }
    /// Calls a function with the bench locked and advanced to the current time.
    void with(const std::function<void(HaplyBench&)>& act);
    /// Ends all connections, as a crash of the service does. With `hasOpenDoor`, new ones are accepted.
    void crash() { m_isCrashWanted = true; }

  private:
    class Server;
    void run();

    std::mutex m_mutex;
    HaplyBench m_bench;
    std::atomic<std::uint16_t> m_port{0};
    std::atomic<bool> m_isStopWanted{false};
    std::atomic<bool> m_isCrashWanted{false};
    std::thread m_thread;
};

} // namespace standin
