// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/igtl/Messages.h"
#include "palpate/igtl/Socket.h"
#include "palpate/igtl/Surface.h"

#include <palpate/core/Status.h>
#include <palpate/core/TripleBuffer.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace palpate::igtl {

// Names of the shared transforms, which become names of nodes in 3D Slicer: at most 20 bytes.
inline constexpr const char* kHandName = "PalpateHand";
inline constexpr const char* kGodObjectName = "PalpateGodObject";
inline constexpr const char* kForceName = "PalpateForce"; ///< the translation is the force on the hand [N]
/// Prefix of all names above: the program does not take its own hand from a server that sends these.
inline constexpr const char* kOwnPrefix = "Palpate";

struct ShareOptions
{
    std::string address = "127.0.0.1"; ///< numeric; the default admits peers on this computer only
    std::uint16_t port = kDefaultPort; ///< 0: any free port
    double rate_Hz = 30.0;             ///< of the transforms; 3D Slicer shows 15 to 20 updates a second
    bool takesSurfaces = false;        ///< passes received POLYDATA on; otherwise skips it
};

/// Touch at one moment, in the world frame (LPS). A plain value.
struct SharedTouch
{
    double hand_mm[3] = {};
    double godObject_mm[3] = {};
    double force_N[3] = {};
    bool isPresent = false; ///< false: no hand; nothing is sent
};

/// Surface that a peer sent.
struct ReceivedSurface
{
    std::string name; ///< device name, as sent
    Surface surface;  ///< RAS, mm
};

/// State of the server for the user.
struct ShareReport
{
    std::uint16_t port = 0;         ///< 0: not running
    std::vector<std::string> peers; ///< addresses of the connected peers
    std::uint64_t sent = 0;         ///< messages
    std::uint64_t dropped = 0;      ///< messages not sent, because the peer did not read
    std::uint64_t received = 0;     ///< messages of a used type
    std::uint64_t refused = 0;      ///< messages and connections with an error
    std::string problem;            ///< latest error of a peer, in English; empty: none
};

/// Server that sends the touch as TRANSFORM, texts as STRING, and receives POLYDATA. A thread does all input and output
/// without waiting for a peer: whoever does not read loses messages and, after ten seconds, the connection.
///
/// Transforms go to every peer, as 3D Slicer expects, until the peer sends STP_TRANS. STT_TDATA requests the same poses
/// as tracking data. GET_ requests of these types, of STATUS and of STRING are answered; other STT_ with an error.
///
/// Coordinates on the wire are RAS in mm, and the force is a vector in RAS.
/// @par Thread All functions from one thread, except `setTouch`, from one other thread.
class ShareServer
{
  public:
    static constexpr std::size_t kMaxPeers = 8; ///< further connections are closed at once

    ShareServer();
    ~ShareServer(); ///< stops
    ShareServer(const ShareServer&) = delete;
    ShareServer& operator=(const ShareServer&) = delete;

    /// @param takeSurface  called on the thread of the server; may be empty
    /// @return the reason if the address is not available
    core::Status start(const ShareOptions& options, std::function<void(ReceivedSurface)> takeSurface = {});
    void stop() noexcept;
    [[nodiscard]] bool isRunning() const noexcept { return m_thread.joinable(); }

    /// Sets the touch for the next transforms. Wait-free. A touch is sent once: without a new one, peers get nothing.
    void setTouch(const SharedTouch& touch) noexcept { m_touch.write(touch); }
    /// Sets a text, which is sent to all peers and to each new peer. An empty text is no longer sent.
    void setText(const std::string& name, const std::string& text);
    [[nodiscard]] ShareReport report() const;

  private:
    struct Peer;
    struct Waker;

    void run() noexcept;
    void serve();
    void waitForWork(std::int64_t until_ns);
    void acceptPeers();
    bool receiveFrom(Peer& peer);
    void answer(Peer& peer, const Message& message);
    void answerQuery(Peer& peer, const Query& query, ByteView content);
    void takePolyData(const Message& message);
    void sendTouch(std::int64_t now_ns);
    void sendTexts();
    bool sendTo(Peer& peer, ByteView message);
    void sendTransforms(Peer& peer);
    void sendTracking(Peer& peer);
    void closeSilent(std::int64_t now_ns);
    void noteProblem(const std::string& address, const std::string& problem);
    void publishPeers();

    ShareOptions m_options;
    std::function<void(ReceivedSurface)> m_takeSurface;
    Socket m_listener;
    std::unique_ptr<Waker> m_waker;
    std::thread m_thread;
    std::atomic<bool> m_isStopWanted{false};
    core::TripleBuffer<SharedTouch> m_touch;

    // Thread of the server only.
    std::vector<std::unique_ptr<Peer>> m_peers;
    bool m_hasTouch = false; ///< m_touch.value() was set since the start
    std::map<std::string, std::string> m_sentTexts;
    std::uint64_t m_sentVersion = 0; ///< of m_sentTexts

    mutable std::mutex m_mutex; ///< of the following; never held during input or output
    std::map<std::string, std::string> m_texts;
    std::atomic<std::uint64_t> m_textVersion{0}; ///< changed under m_mutex
    ShareReport m_report;
};

} // namespace palpate::igtl
