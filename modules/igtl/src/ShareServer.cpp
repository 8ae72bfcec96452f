// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/igtl/ShareServer.h"

#include "palpate/igtl/Connection.h"

#include <palpate/core/Clock.h>
#include <palpate/core/Text.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <poll.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <unistd.h>
#include <utility>

namespace palpate::igtl {

using core::Status;
using core::StatusCode;

namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kMillisecond_ns = 1'000'000;
// A peer that has read nothing for so long while messages were waiting has hung.
constexpr std::int64_t kSilentAfter_ns = 10 * kSecond_ns;
// Transforms are dropped beyond this queue, so that a slow peer gets the newest ones, not old ones. [bytes]
constexpr std::size_t kMaxTransformQueue_bytes = 4096;

Pose poseAt(const double (&p_W)[3]) noexcept
{
    return toggleRas({Vec3(p_W[0], p_W[1], p_W[2]), core::Quaternion::Identity()});
}

} // namespace

struct ShareServer::Waker
{
    Socket event{::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)}; // a Socket for its closing

    void wake() const noexcept
    {
        const std::uint64_t one = 1;
        (void)!::write(event.descriptor(), &one, sizeof one); // a full counter is awake already
    }
    void clear() const noexcept
    {
        std::uint64_t count = 0;
        (void)!::read(event.descriptor(), &count, sizeof count);
    }
};

struct ShareServer::Peer
{
    Peer(Socket socket, bool takesSurfaces)
        : connection(std::move(socket), takesSurfaces)
        , address(connection.socket().peerAddress())
        , progress_ns(core::monotonicNow_ns())
    {
    }
    Connection connection;
    std::string address;
    bool hasTexts = false;
    bool wantsTransforms = true;
    std::int64_t trackingEvery_ns = 0; ///< 0: no tracking data
    std::int64_t tracked_ns = 0;       ///< of the last tracking data
    std::int64_t progress_ns;          ///< when the queue was last empty or shrank
    std::size_t queued_bytes = 0;      ///< at that time
    std::uint64_t received = 0;        ///< counted in the report
    std::uint64_t refused = 0;
};

ShareServer::ShareServer() = default;

ShareServer::~ShareServer()
{
    stop();
}

Status ShareServer::start(const ShareOptions& options, std::function<void(ReceivedSurface)> takeSurface)
{
    if (isRunning()) {
        return {StatusCode::Internal, PALPATE_TEXT("%1: already started"), "OpenIGTLink"};
    }
    auto listener = listenAt(options.address, options.port);
    if (!listener.isOk()) {
        return listener.status();
    }
    auto waker = std::make_unique<Waker>();
    if (!waker->event.isOpen()) {
        return {StatusCode::Unreadable, core::systemError(errno)};
    }
    m_options = options;
    m_options.rate_Hz = std::clamp(options.rate_Hz, 1.0, 1000.0);
    m_takeSurface = std::move(takeSurface);
    m_listener = std::move(listener).value();
    m_waker = std::move(waker);
    m_isStopWanted = false;
    m_hasTouch = false;
    (void)m_touch.fetch(); // a touch before the start is old
    m_sentTexts.clear();
    {
        const std::scoped_lock lock(m_mutex);
        m_report = {};
        m_report.port = m_listener.localPort();
    }
    m_thread = std::thread([this] { run(); });
    return {};
}

void ShareServer::stop() noexcept
{
    if (!isRunning()) {
        return;
    }
    m_isStopWanted = true;
    m_waker->wake();
    m_thread.join();
    m_listener = Socket();
    const std::scoped_lock lock(m_mutex);
    m_report.port = 0;
    m_report.peers.clear();
}

void ShareServer::setText(const std::string& name, const std::string& text)
{
    {
        const std::scoped_lock lock(m_mutex);
        if (text.empty()) {
            m_texts.erase(name);
        } else {
            m_texts[name] = text;
        }
        ++m_textVersion;
    }
    if (m_waker != nullptr) {
        m_waker->wake();
    }
}

ShareReport ShareServer::report() const
{
    const std::scoped_lock lock(m_mutex);
    return m_report;
}

void ShareServer::run() noexcept
{
    pthread_setname_np(pthread_self(), "palpate-share");
    while (!m_isStopWanted) {
        try {
            serve();
        } catch (const std::bad_alloc&) { // a surface too large for this computer
            m_peers.clear();
            const std::scoped_lock lock(m_mutex);
            m_report.peers.clear();
            ++m_report.refused;
        }
    }
    m_peers.clear();
}

void ShareServer::serve()
{
    const auto period_ns = static_cast<std::int64_t>(static_cast<double>(kSecond_ns) / m_options.rate_Hz);
    std::int64_t due_ns = core::monotonicNow_ns();
    while (!m_isStopWanted) {
        waitForWork(due_ns);
        acceptPeers();
        const std::size_t count = m_peers.size();
        std::erase_if(m_peers, [this](const std::unique_ptr<Peer>& peer) { return !receiveFrom(*peer); });
        if (m_peers.size() != count) {
            publishPeers();
        }
        sendTexts();
        const std::int64_t now_ns = core::monotonicNow_ns();
        if (now_ns >= due_ns) {
            due_ns = std::max(due_ns + period_ns, now_ns); // after a delay, the rate is not made up for
            sendTouch(now_ns);
            closeSilent(now_ns);
        }
    }
}

/// Sleeps until `until_ns`, or until a peer sends, reads or connects, or the server is woken.
void ShareServer::waitForWork(std::int64_t until_ns)
{
    std::vector<pollfd> waiting{{m_waker->event.descriptor(), POLLIN, 0}, {m_listener.descriptor(), POLLIN, 0}};
    for (const auto& peer : m_peers) {
        const auto events = static_cast<short>(peer->connection.hasQueue() ? POLLIN | POLLOUT : POLLIN);
        waiting.push_back({peer->connection.descriptor(), events, 0});
    }
    const std::int64_t left_ns = std::max<std::int64_t>(0, until_ns - core::monotonicNow_ns());
    (void)::poll(waiting.data(), waiting.size(), static_cast<int>((left_ns + kMillisecond_ns - 1) / kMillisecond_ns));
    m_waker->clear();
}

void ShareServer::acceptPeers()
{
    for (Socket socket = m_listener.accept(); socket.isOpen(); socket = m_listener.accept()) {
        if (m_peers.size() < kMaxPeers) {
            m_peers.push_back(std::make_unique<Peer>(std::move(socket), m_options.takesSurfaces));
            publishPeers();
        }
        socket = Socket();
    }
}

bool ShareServer::receiveFrom(Peer& peer)
{
    Connection& connection = peer.connection;
    const bool isOpen =
        connection.receive([&](const Message& message) { answer(peer, message); }) && connection.flush();
    const bool isRefused = connection.refused() != peer.refused;
    if (connection.received() != peer.received || isRefused) {
        const std::scoped_lock lock(m_mutex);
        m_report.received += connection.received() - peer.received;
        m_report.refused += connection.refused() - peer.refused;
    }
    peer.received = connection.received();
    peer.refused = connection.refused();
    if (isRefused) {
        noteProblem(peer.address, connection.problem());
    }
    return isOpen;
}

void ShareServer::answer(Peer& peer, const Message& message)
{
    if (message.header.type == "POLYDATA") {
        takePolyData(message);
    } else if (const auto query = queryOf(message.header.type)) {
        answerQuery(peer, *query, message.content);
    }
}

void ShareServer::takePolyData(const Message& message)
{
    auto surface = decodeSurface(message.content);
    if (!surface.isOk()) {
        {
            const std::scoped_lock lock(m_mutex);
            ++m_report.refused;
        }
        noteProblem(core::inQuotes(message.header.name), surface.status().message());
    } else if (m_takeSurface) {
        m_takeSurface({message.header.name, std::move(surface).value()});
    }
}

void ShareServer::answerQuery(Peer& peer, const Query& query, ByteView content)
{
    const bool isTransform = query.type == "TRANSFORM";
    const bool isTracking = query.type == "TDATA";
    bool isGranted = isTransform || isTracking;
    switch (query.kind) {
    case QueryKind::Get:
        if (isTransform) {
            sendTransforms(peer);
        } else if (isTracking) {
            sendTracking(peer);
        } else if (query.type == "STATUS") {
            sendTo(peer, encodeMessage("STATUS", kOwnPrefix, encodeStatus({}), timestampNow()));
        } else if (query.type == "STRING") {
            peer.hasTexts = false; // sends the texts again
        }
        return;
    case QueryKind::Start:
        if (isTransform) {
            peer.wantsTransforms = true;
        } else if (isTracking) {
            const auto request = decodeTrackingRequest(content);
            isGranted = request.isOk();
            if (isGranted) {
                peer.trackingEvery_ns = std::max<std::int64_t>(1, request.value().interval_ms * kMillisecond_ns);
            }
        }
        break;
    case QueryKind::Stop:
        if (isTransform) {
            peer.wantsTransforms = false;
        } else if (isTracking) {
            peer.trackingEvery_ns = 0;
        }
        break;
    case QueryKind::Answer: // to a request that was never made
        return;
    }
    const std::uint8_t status = isGranted ? 0 : 1;
    const std::string type = "RTS_" + (isTransform ? std::string("TRANS") : query.type);
    sendTo(peer, encodeMessage(type, kOwnPrefix, {&status, 1}, timestampNow()));
}

bool ShareServer::sendTo(Peer& peer, ByteView message)
{
    const bool isSent = peer.connection.send(message);
    const std::scoped_lock lock(m_mutex);
    ++(isSent ? m_report.sent : m_report.dropped);
    return isSent;
}

void ShareServer::sendTransforms(Peer& peer)
{
    const SharedTouch& touch = m_touch.value();
    if (!m_hasTouch || !touch.isPresent) {
        return;
    }
    const std::uint64_t timestamp = timestampNow();
    const auto send = [&](const char* name, const double(&vector_W)[3]) {
        sendTo(peer, encodeMessage("TRANSFORM", name, encodeTransform(transformOf(poseAt(vector_W))), timestamp));
    };
    send(kHandName, touch.hand_mm);
    send(kGodObjectName, touch.godObject_mm);
    send(kForceName, touch.force_N);
}

void ShareServer::sendTracking(Peer& peer)
{
    const SharedTouch& touch = m_touch.value();
    std::vector<TrackedTool> tools; // tools that are not there are left out
    if (m_hasTouch && touch.isPresent) {
        constexpr std::uint8_t kPointOnly = 3;
        tools = {{kHandName, kPointOnly, transformOf(poseAt(touch.hand_mm))},
                 {kGodObjectName, kPointOnly, transformOf(poseAt(touch.godObject_mm))}};
    }
    sendTo(peer, encodeMessage("TDATA", kOwnPrefix, encodeTrackingData(tools), timestampNow()));
}

void ShareServer::sendTouch(std::int64_t now_ns)
{
    if (!m_touch.fetch()) {
        return;
    }
    m_hasTouch = true;
    for (const auto& peer : m_peers) {
        if (peer->connection.queued_bytes() > kMaxTransformQueue_bytes) {
            const std::scoped_lock lock(m_mutex);
            ++m_report.dropped;
            continue;
        }
        if (peer->wantsTransforms) {
            sendTransforms(*peer);
        }
        if (peer->trackingEvery_ns > 0 && now_ns - peer->tracked_ns >= peer->trackingEvery_ns) {
            peer->tracked_ns = now_ns;
            sendTracking(*peer);
        }
    }
}

/// Sends changed texts to all peers, and all texts to new peers and to those that missed one and read again.
void ShareServer::sendTexts()
{
    const auto isDue = [](const std::unique_ptr<Peer>& peer) {
        return !peer->hasTexts && !peer->connection.hasQueue();
    };
    if (m_sentVersion == m_textVersion.load() && std::none_of(m_peers.begin(), m_peers.end(), isDue)) {
        return;
    }
    std::map<std::string, std::string> texts;
    {
        const std::scoped_lock lock(m_mutex);
        texts = m_texts;
        m_sentVersion = m_textVersion.load();
    }
    for (const auto& peer : m_peers) {
        const bool isAll = isDue(peer);
        if (!isAll && !peer->hasTexts) {
            continue;
        }
        peer->hasTexts = true;
        for (const auto& [name, text] : texts) {
            const auto sent = m_sentTexts.find(name);
            if (isAll || sent == m_sentTexts.end() || sent->second != text) {
                const bool isSent = sendTo(*peer, encodeMessage("STRING", name, encodeString(text), timestampNow()));
                peer->hasTexts = peer->hasTexts && isSent;
            }
        }
    }
    m_sentTexts = std::move(texts);
}

/// Closes connections to peers that do not read.
void ShareServer::closeSilent(std::int64_t now_ns)
{
    const std::size_t count = m_peers.size();
    std::erase_if(m_peers, [&](const std::unique_ptr<Peer>& peer) {
        const std::size_t queued = peer->connection.queued_bytes();
        if (queued == 0 || queued < peer->queued_bytes) {
            peer->progress_ns = now_ns;
        }
        peer->queued_bytes = queued;
        return now_ns - peer->progress_ns > kSilentAfter_ns;
    });
    if (m_peers.size() != count) {
        publishPeers();
    }
}

void ShareServer::noteProblem(const std::string& address, const std::string& problem)
{
    const std::scoped_lock lock(m_mutex);
    m_report.problem = address + ": " + problem;
}

void ShareServer::publishPeers()
{
    std::vector<std::string> addresses;
    for (const auto& peer : m_peers) {
        addresses.push_back(peer->address);
    }
    const std::scoped_lock lock(m_mutex);
    m_report.peers = std::move(addresses);
}

} // namespace palpate::igtl
