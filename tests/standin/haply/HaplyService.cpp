// SPDX-License-Identifier: BSD-3-Clause
#include "HaplyService.h"

#include <QEventLoop>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>
#include <QWebSocket>
#include <QWebSocketServer>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <deque>
#include <list>
#include <map>

namespace standin {

namespace {

constexpr std::int64_t kForget_ns = 20'000'000;
constexpr double kCentre_m[] = {0.0, -0.15, 0.20}; // of the workspace, in the service's axes
constexpr std::uint32_t kHugeFrame = 64U << 20;

std::int64_t serviceNow_ns()
{
    timespec t{};
    clock_gettime(CLOCK_MONOTONIC, &t);
    return static_cast<std::int64_t>(t.tv_sec) * 1'000'000'000 + t.tv_nsec;
}

void serviceSleep(std::int64_t until_ns)
{
    const timespec until{until_ns / 1'000'000'000, until_ns % 1'000'000'000};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) != 0) {
    }
}

double drawHaply(HaplyBench& bench)
{
    bench.random ^= bench.random >> 12; // xorshift64*
    bench.random ^= bench.random << 25;
    bench.random ^= bench.random >> 27;
    return static_cast<double>((bench.random * 0x2545F4914F6CDD1DULL) >> 11) / 9007199254740992.0;
}

double lengthOf(const HaplyV3& v)
{
    return std::hypot(v[0], v[1], v[2]);
}

/// The service's axes: x right, y away from the user, z up.
HaplyV3 toService(const HaplyV3& u)
{
    return {u[0], -u[2], u[1]};
}

HaplyV3 fromService(const HaplyV3& s)
{
    return {s[0], s[2], -s[1]};
}

QJsonObject vectorJson(const HaplyV3& v)
{
    return {{QStringLiteral("x"), v[0]}, {QStringLiteral("y"), v[1]}, {QStringLiteral("z"), v[2]}};
}

HaplyV3 vectorFrom(const QJsonObject& o)
{
    return {o.value(QLatin1String("x")).toDouble(), o.value(QLatin1String("y")).toDouble(),
            o.value(QLatin1String("z")).toDouble()};
}

/// Axes of a session for one device.
struct SessionAxes
{
    QString basis;
    HaplyV3 origin_m{}; ///< added to positions
    double scale = 1.0;
    bool isCentred = false;
};

/// "XZY": the second axis of the session is the service's third.
HaplyV3 permuted(const HaplyV3& v, const QString& basis)
{
    HaplyV3 out{};
    for (int i = 0; i < 3; ++i) {
        out[static_cast<std::size_t>(i)] = v[static_cast<std::size_t>(basis.at(i).unicode() - 'X')];
    }
    return out;
}

HaplyV3 unpermuted(const HaplyV3& v, const QString& basis)
{
    HaplyV3 out{};
    for (int i = 0; i < 3; ++i) {
        out[static_cast<std::size_t>(basis.at(i).unicode() - 'X')] = v[static_cast<std::size_t>(i)];
    }
    return out;
}

} // namespace

/// Lives in the service's thread.
class HaplyService::Server : public QObject
{
  public:
    explicit Server(HaplyService& owner)
        : m_owner(owner)
        , m_upgrades(QStringLiteral("emulated"), QWebSocketServer::NonSecureMode)
    {
        connect(&m_door, &QTcpServer::newConnection, this, &Server::greet);
        connect(&m_upgrades, &QWebSocketServer::newConnection, this, [this] {
            while (QWebSocket* const socket = m_upgrades.nextPendingConnection()) {
                open(socket);
            }
        });
        if (!m_door.listen(QHostAddress::LocalHost)) {
            qFatal("the emulated service cannot listen");
        }
        m_owner.m_port = m_door.serverPort();
        connect(&m_timer, &QTimer::timeout, this, &Server::tick);
        m_timer.start(1);
    }
    ~Server() override { endAll(); }

  private:
    struct Answer
    {
        std::int64_t due_ns = 0;
        bool isFull = false;
    };
    struct Session
    {
        QWebSocket* socket = nullptr;
        QTcpSocket* tcp = nullptr; ///< below `socket`
        std::map<std::string, SessionAxes> axes;
        std::map<std::string, HaplyV3> forces; ///< U
        std::deque<Answer> answers;
        bool isBroken = false; ///< an answer has left the stream in the middle of a frame or message
    };

    void greet()
    {
        while (QTcpSocket* const tcp = m_door.nextPendingConnection()) {
            tcp->setSocketOption(QAbstractSocket::LowDelayOption, 1);
            connect(tcp, &QTcpSocket::readyRead, this, [this, tcp] { route(tcp); });
            if (tcp->bytesAvailable() > 0) {
                route(tcp);
            }
        }
    }

    /// Answers GET /version, and passes others on to the WebSocket server.
    void route(QTcpSocket* tcp)
    {
        const QByteArray head = tcp->peek(4096);
        if (!head.contains("\r\n\r\n")) {
            return;
        }
        HaplyBench bench; // the few fields that are needed
        m_owner.with([&](HaplyBench& b) {
            bench.version = b.version;
            bench.refusesUpgrade = b.refusesUpgrade;
            bench.ignoresUpgrade = b.ignoresUpgrade;
        });
        const bool isVersion = head.startsWith("GET /version ");
        if (!isVersion && bench.ignoresUpgrade) {
            return;
        }
        tcp->disconnect(this);
        if (isVersion || bench.refusesUpgrade) {
            tcp->readAll();
            const QByteArray page = "{\"build_type\":\"release\",\"git_tag\":\"v\",\"project_version\":\"" +
                                    QByteArray::fromStdString(bench.version) + "\"}";
            tcp->write(isVersion && !bench.version.empty()
                           ? "HTTP/1.1 200 OK\r\nContent-Type: application/json\r\nContent-Length: " +
                                 QByteArray::number(page.size()) + "\r\n\r\n" + page
                           : QByteArray("HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n"));
            tcp->disconnectFromHost();
            connect(tcp, &QTcpSocket::disconnected, tcp, &QObject::deleteLater);
            return;
        }
        m_raw[{tcp->peerPort()}] = tcp;
        m_upgrades.handleConnection(tcp);
    }

    void open(QWebSocket* socket)
    {
        m_sessions.emplace_back();
        Session& session = m_sessions.back();
        session.socket = socket;
        session.tcp = m_raw[socket->peerPort()];
        bool hasInventory = false;
        m_owner.with([&](HaplyBench& b) {
            ++b.sessions;
            ++b.openSessions;
            hasInventory = !b.hasNoInventory;
        });
        connect(socket, &QWebSocket::textMessageReceived, this,
                [this, &session](const QString& text) { receive(session, text); });
        connect(socket, &QWebSocket::pong, this, [this] { m_owner.with([](HaplyBench& b) { ++b.pongs; }); });
        connect(socket, &QWebSocket::disconnected, this, [this, &session] { end(session); });
        if (hasInventory) {
            send(session, stateText(session, true));
        }
    }

    void end(Session& session)
    {
        QWebSocket* const socket = session.socket;
        socket->disconnect(this);
        m_raw.erase(socket->peerPort());
        const auto place =
            std::find_if(m_sessions.begin(), m_sessions.end(), [&session](const Session& s) { return &s == &session; });
        m_sessions.erase(place);
        m_owner.with([this](HaplyBench& b) {
            --b.openSessions;
            drive(b);
        });
        socket->deleteLater();
    }

    void endAll()
    {
        while (!m_sessions.empty()) {
            Session& session = m_sessions.front();
            session.socket->disconnect(this);
            session.socket->abort();
            end(session);
        }
    }

    /// Sets the motors to the sum of all sessions.
    void drive(HaplyBench& b)
    {
        for (HaplyDevice& device : b.devices) {
            HaplyV3 sum{};
            for (const Session& session : m_sessions) {
                if (const auto found = session.forces.find(device.id); found != session.forces.end()) {
                    for (std::size_t i = 0; i < 3; ++i) {
                        sum[i] += found->second[i];
                    }
                }
            }
            device.f = device.isPlugged && device.hasPower && device.isCalibrated && device.isReady ? sum : HaplyV3{};
            device.largestForce_N = std::max(device.largestForce_N, lengthOf(device.f));
        }
    }

    void configure(Session& session, HaplyDevice& device, const QJsonObject& wanted)
    {
        if (device.ignoresConfiguration || wanted.isEmpty()) {
            return;
        }
        SessionAxes& axes = axesOf(session, device);
        const QString basis =
            wanted.value(QLatin1String("basis")).toObject().value(QLatin1String("permutation")).toString();
        axes.basis = basis.isEmpty() ? axes.basis : basis;
        const QJsonObject mount =
            wanted.value(QLatin1String("mount")).toObject().value(QLatin1String("transform")).toObject();
        if (!mount.isEmpty()) {
            axes.origin_m = vectorFrom(mount.value(QLatin1String("position")).toObject());
            axes.scale = mount.value(QLatin1String("scale")).toObject().value(QLatin1String("x")).toDouble(1.0);
        }
        axes.isCentred = wanted.value(QLatin1String("preset")).toObject().value(QLatin1String("preset")).toString() ==
                         QLatin1String("arm_front_centered");
    }

    static SessionAxes& axesOf(Session& session, const HaplyDevice& device)
    {
        const auto [place, isNew] = session.axes.try_emplace(device.id);
        if (isNew) {
            place->second = {QString::fromStdString(device.basis), device.mount_m, device.mountScale, false};
        }
        return place->second;
    }

    void receive(Session& session, const QString& text)
    {
        const std::int64_t now_ns = serviceNow_ns();
        std::int64_t takes_ns = 0;
        Answer answer;
        m_owner.with([&](HaplyBench& b) {
            takes_ns = b.takes_ns;
            QJsonParseError error;
            const QJsonObject message = QJsonDocument::fromJson(text.toUtf8(), &error).object();
            if (error.error != QJsonParseError::NoError) {
                b.lastError = error.errorString().toStdString() + ": " + text.toStdString();
            }
            answer.isFull =
                message.value(QLatin1String("session")).toObject().contains(QLatin1String("force_render_full_state"));
            for (const QJsonValue value : message.value(QLatin1String("inverse3")).toArray()) {
                const QJsonObject entry = value.toObject();
                const std::string id = entry.value(QLatin1String("device_id")).toString().toStdString();
                for (HaplyDevice& device : b.devices) {
                    if (device.id == id && device.isPlugged) {
                        configure(session, device, entry.value(QLatin1String("configure")).toObject());
                        command(session, b, device, entry.value(QLatin1String("commands")).toObject(), now_ns);
                    }
                }
            }
            drive(b);
            answer.due_ns = now_ns + takes_ns + b.faults.delayAnswer_ns;
            if (drawHaply(b) < b.faults.jitter) {
                answer.due_ns += static_cast<std::int64_t>(4e6 * drawHaply(b));
            }
        });
        session.answers.push_back(answer);
        if (answer.due_ns == now_ns + takes_ns) {
            serviceSleep(answer.due_ns);
            reply(session);
        }
    }

    static void command(Session& session, const HaplyBench& b, HaplyDevice& device, const QJsonObject& commands,
                        std::int64_t now_ns)
    {
        const QJsonObject force = commands.value(QLatin1String("set_cursor_force")).toObject();
        if (force.isEmpty()) {
            return;
        }
        ++device.messages;
        if (lengthOf(device.f) > 0.0 && b.faults.stallUntil_ns == 0) {
            device.longestSilence_ns = std::max(device.longestSilence_ns, now_ns - device.lastMessage_ns);
        }
        device.lastMessage_ns = now_ns;
        QJsonObject vector;
        if (b.hasVector && force.contains(QLatin1String("vector"))) {
            vector = force.value(QLatin1String("vector")).toObject();
        } else if (b.hasValues) {
            vector = force.value(QLatin1String("values")).toObject();
        }
        HaplyV3 f_U{};
        if (!vector.isEmpty()) {
            f_U = fromService(unpermuted(vectorFrom(vector), axesOf(session, device).basis));
        }
        session.forces[device.id] = f_U;
        device.forces.push_back({now_ns, f_U});
    }

    QJsonObject deviceJson(Session& session, const HaplyBench& b, HaplyDevice& device, bool isFull) const
    {
        const SessionAxes& axes = axesOf(session, device);
        HaplyV3 p = toService(device.p);
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = axes.scale * (p[i] + (axes.isCentred ? 0.0 : kCentre_m[i]) + axes.origin_m[i]);
        }
        p = permuted(p, axes.basis);
        if (b.faults.isFrozen) {
            p = m_lastShown;
        }
        m_lastShown = p;
        p[0] += b.faults.jump_m;
        QJsonObject state{{QStringLiteral("cursor_position"), vectorJson(p)},
                          {QStringLiteral("cursor_velocity"), vectorJson(permuted(toService(device.v), axes.basis))}};
        if (b.isNew) {
            state.insert(QStringLiteral("current_cursor_force"), vectorJson(permuted(toService(device.f), axes.basis)));
            state.insert(QStringLiteral("control_domain"), QStringLiteral("cartesian"));
            QJsonObject transform;
            if (device.workspaceScale != 1.0) {
                const double s = device.workspaceScale;
                transform.insert(QStringLiteral("scale"), vectorJson({s, s, s}));
            }
            state.insert(QStringLiteral("transform"), transform);
        }
        QJsonObject out{{QStringLiteral("device_id"), QString::fromStdString(device.id)},
                        {QStringLiteral("state"), state},
                        {QStringLiteral("status"), QJsonObject{{QStringLiteral("calibrated"), device.isCalibrated},
                                                               {QStringLiteral("in_use"), device.isInUse},
                                                               {QStringLiteral("power_supply"), device.hasPower},
                                                               {QStringLiteral("ready"), device.isReady},
                                                               {QStringLiteral("started"), true}}}};
        if (isFull) {
            QJsonObject config{{QStringLiteral("type"), QStringLiteral("inverse3")},
                               {QStringLiteral("port"), QStringLiteral("/dev/ttyACM0")},
                               {QStringLiteral("handedness"), QStringLiteral("right")},
                               {QStringLiteral("device_info"),
                                QJsonObject{{QStringLiteral("major_version"), 7},
                                            {b.isNew ? QStringLiteral("device_type") : QStringLiteral("model"),
                                             QString::fromStdString(device.type)}}}};
            if (b.isNew) {
                const double s = axes.scale;
                config.insert(QStringLiteral("basis"), QJsonObject{{QStringLiteral("permutation"), axes.basis}});
                config.insert(QStringLiteral("mount"),
                              QJsonObject{{QStringLiteral("position"), vectorJson(axes.origin_m)},
                                          {QStringLiteral("scale"), vectorJson({s, s, s})}});
            }
            out.insert(QStringLiteral("config"), config);
        }
        return out;
    }

    QByteArray stateText(Session& session, bool isFull)
    {
        QByteArray text;
        m_owner.with([&](HaplyBench& b) {
            QJsonArray devices;
            for (HaplyDevice& device : b.devices) {
                if (device.isPlugged) {
                    devices.append(deviceJson(session, b, device, isFull));
                    device.samples.push_back({serviceNow_ns(), device.p});
                }
            }
            QJsonObject message;
            if (b.isNew && isFull) {
                message.insert(QStringLiteral("session_id"), 1);
            }
            message.insert(QStringLiteral("inverse3"), devices);
            for (const HaplyGrip& grip : b.grips) {
                QJsonObject state{{QStringLiteral("orientation"), QJsonObject{{QStringLiteral("w"), grip.q[0]},
                                                                              {QStringLiteral("x"), grip.q[1]},
                                                                              {QStringLiteral("y"), grip.q[2]},
                                                                              {QStringLiteral("z"), grip.q[3]}}}};
                if (grip.kind == "verse_grip") {
                    state.insert(QStringLiteral("button"), grip.isA);
                } else {
                    state.insert(QStringLiteral("buttons"), QJsonObject{{QStringLiteral("a"), grip.isA},
                                                                        {QStringLiteral("b"), grip.isB},
                                                                        {QStringLiteral("c"), grip.isC}});
                }
                const QString kind = QString::fromStdString(grip.kind);
                QJsonArray grips = message.value(kind).toArray();
                grips.append(QJsonObject{{QStringLiteral("device_id"), QString::fromStdString(grip.id)},
                                         {QStringLiteral("state"), state}});
                message.insert(kind, grips);
            }
            if (b.style.hasStrangers) {
                message.insert(QStringLiteral("inverse4"), QJsonArray{1, QStringLiteral("two"), QJsonValue()});
                message.insert(QStringLiteral("\u00e9\U0001F44B"), true);
            }
            text = QJsonDocument(message).toJson(QJsonDocument::Compact);
            if (b.style.hasExponents) {
                static const QRegularExpression decimal(QStringLiteral("(\\d+\\.\\d+)(?![\\deE])"));
                text = QString::fromUtf8(text).replace(decimal, QStringLiteral("\\1E+0")).toUtf8();
            }
        });
        return text;
    }

    void send(Session& session, const QByteArray& text)
    {
        HaplyStyle style;
        m_owner.with([&](HaplyBench& b) { style = b.style; });
        if (style.hasPings) {
            session.socket->ping("palpate?");
        }
        session.socket->setOutgoingFrameSize(style.fragment > 0 ? static_cast<quint64>(style.fragment)
                                                                : QWebSocket::maxOutgoingFrameSize());
        session.socket->sendTextMessage(QString::fromUtf8(text));
        session.socket->flush();
    }

    /// Sends a frame that the WebSocket server would not send.
    static void sendRaw(Session& session, std::uint8_t first, const QByteArray& payload, std::uint8_t lengthBits = 0)
    {
        QByteArray frame(1, static_cast<char>(first));
        frame.append(static_cast<char>(lengthBits | 126));
        frame.append(static_cast<char>(payload.size() >> 8));
        frame.append(static_cast<char>(payload.size() & 0xFF));
        session.tcp->write(frame + payload);
        session.tcp->flush();
    }

    void reply(Session& session)
    {
        const Answer answer = session.answers.front();
        session.answers.pop_front();
        HaplyAnswer kind = HaplyAnswer::State;
        bool answersTwice = false;
        m_owner.with([&](HaplyBench& b) {
            kind = drawHaply(b) < b.faults.share ? b.faults.answer : kind;
            answersTwice = b.style.answersTwice;
        });
        if (session.isBroken) {
            return; // whatever follows would be a part of the broken frame
        }
        QByteArray text = stateText(session, answer.isFull);
        switch (kind) {
        case HaplyAnswer::State:
            send(session, text);
            if (answersTwice) {
                send(session, stateText(session, false));
            }
            return;
        case HaplyAnswer::Malformed:
            return send(session, text.chopped(text.size() / 3));
        case HaplyAnswer::Deep:
            return send(session, QByteArray(100'000, '['));
        case HaplyAnswer::Empty:
            return send(session, QByteArray());
        case HaplyAnswer::Binary:
            session.socket->sendBinaryMessage(text);
            session.socket->flush();
            return;
        case HaplyAnswer::InvalidUtf8:
            return sendRaw(session, 0x81, text.replace("device_id", "device\xff\xfe\xc0"));
        case HaplyAnswer::NullFields:
            return send(session, text.replace("{\"x\"", "null,\"was\":{\"x\""));
        case HaplyAnswer::MissingFields:
            return send(session, text.replace("\"z\"", "\"zed\""));
        case HaplyAnswer::TextFields:
            return send(session, text.replace("\"x\":", "\"x\":\"1\",\"w\":"));
        case HaplyAnswer::ArrayFields:
            return send(session, text.replace("\"cursor_position\":", "\"cursor_position\":[0,0,0],\"was\":"));
        case HaplyAnswer::WrongId:
            return send(session, text.replace("049D", "049E"));
        case HaplyAnswer::NoDevices:
            return send(session, "{\"inverse3\":[]}");
        case HaplyAnswer::NumberNaN:
            return send(session, text.replace("\"x\":", "\"x\":NaN,\"w\":"));
        case HaplyAnswer::Number1e999:
            return send(session, text.replace("\"x\":", "\"x\":-1e999,\"w\":"));
        case HaplyAnswer::Number1e308:
            return send(session, text.replace("\"x\":", "\"x\":1e308,\"w\":"));
        case HaplyAnswer::Masked:
            return sendRaw(session, 0x81, "abcd" + text, 0x80);
        case HaplyAnswer::ReservedBits:
            return sendRaw(session, 0xC1, text);
        case HaplyAnswer::Huge: {
            session.isBroken = true;
            QByteArray frame("\x81\x7f\0\0\0\0", 6);
            for (int shift = 24; shift >= 0; shift -= 8) {
                frame.append(static_cast<char>(kHugeFrame >> shift & 0xFF));
            }
            session.tcp->write(frame + QByteArray(1 << 20, ' '));
            return;
        }
        case HaplyAnswer::EndlessPieces:
            sendRaw(session, 0x01, text);
            for (int i = 0; i < 40; ++i) {
                sendRaw(session, 0x00, QByteArray(10'000, ' '));
            }
            session.isBroken = true;
            return;
        case HaplyAnswer::HalfFrame:
            session.isBroken = true;
            session.tcp->write("\x81\x7e\x04\x00{\"inverse3\":[");
            session.tcp->flush();
            return;
        case HaplyAnswer::CloseSilently:
            // Later, because it ends the session.
            QMetaObject::invokeMethod(
                session.tcp, [tcp = session.tcp] { tcp->close(); }, Qt::QueuedConnection);
            return;
        case HaplyAnswer::PingFlood:
            session.tcp->write(QByteArray("\x89\x00", 2).repeated(2000));
            session.tcp->flush();
            return;
        case HaplyAnswer::None:
            return;
        }
    }

    void tick()
    {
        bool isOpen = true;
        std::int64_t stallUntil_ns = 0;
        m_owner.with([&](HaplyBench& b) {
            isOpen = b.hasOpenDoor;
            stallUntil_ns = b.faults.stallUntil_ns;
            const std::int64_t now_ns = serviceNow_ns();
            for (HaplyDevice& device : b.devices) {
                if (lengthOf(device.f) > 0.0 && now_ns - device.lastMessage_ns > kForget_ns) {
                    ++device.watchdogs;
                    for (Session& session : m_sessions) {
                        session.forces.erase(device.id);
                    }
                }
                if (lengthOf(device.f) > 0.0 && b.faults.stallUntil_ns == 0) {
                    device.longestSilence_ns = std::max(device.longestSilence_ns, now_ns - device.lastMessage_ns);
                }
            }
            drive(b);
        });
        if (m_owner.m_isCrashWanted.exchange(false)) {
            endAll();
        }
        if (isOpen && !m_door.isListening()) {
            m_door.listen(QHostAddress::LocalHost, m_owner.m_port);
        } else if (!isOpen) {
            m_door.close();
        }
        if (const std::int64_t now_ns = serviceNow_ns(); stallUntil_ns > now_ns) {
            // The motors are another's business: they stop on time.
            serviceSleep(std::min(stallUntil_ns, now_ns + kForget_ns));
            m_owner.with([this](HaplyBench& b) {
                for (HaplyDevice& device : b.devices) {
                    device.watchdogs += lengthOf(device.f) > 0.0 ? 1 : 0;
                }
                for (Session& session : m_sessions) {
                    session.forces.clear();
                }
                drive(b);
            });
            serviceSleep(stallUntil_ns);
        }
        for (auto it = m_sessions.begin(); it != m_sessions.end();) {
            Session& session = *it++; // a reply may end the session
            while (!session.answers.empty() && session.answers.front().due_ns <= serviceNow_ns()) {
                const bool isLast = session.answers.size() == 1;
                reply(session);
                if (isLast) {
                    break;
                }
            }
        }
    }

    HaplyService& m_owner;
    QTcpServer m_door;
    QWebSocketServer m_upgrades;
    QTimer m_timer;
    std::map<quint16, QTcpSocket*> m_raw; ///< by the port of the client
    std::list<Session> m_sessions;
    mutable HaplyV3 m_lastShown{};
};

HaplyService::HaplyService()
{
    qputenv("QT_NO_GLIB", "1"); // whose event loop does not wait by ppoll
    m_thread = std::thread([this] { run(); });
    while (m_port == 0) {
        serviceSleep(serviceNow_ns() + 1'000'000);
    }
}

HaplyService::~HaplyService()
{
    m_isStopWanted = true;
    m_thread.join();
}

void HaplyService::run()
{
    QEventLoop loop; // first, because it gives this thread a dispatcher
    Server server(*this);
    while (!m_isStopWanted) {
        loop.processEvents(QEventLoop::WaitForMoreEvents);
    }
}

void HaplyService::with(const std::function<void(HaplyBench&)>& act)
{
    const std::lock_guard lock(m_mutex);
    advanceHaply(m_bench, serviceNow_ns());
    act(m_bench);
}

} // namespace standin
