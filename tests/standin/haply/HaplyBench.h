// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// Emulated Haply devices behind an emulated Inverse Service. Everything here is in metres, newtons and the user frame
/// U (x right, y up, z towards the user), with the origin in the centre of the workspace; the service converts to its
/// own axes and origin.
namespace standin {

using HaplyV3 = std::array<double, 3>;

/// Content of an answer instead of the state.
enum class HaplyAnswer
{
    State,
    Malformed,
    Deep,          ///< 100 000 nested arrays
    Huge,          ///< a frame of 64 MiB
    EndlessPieces, ///< fragments of one message, without an end
    Binary,
    InvalidUtf8,
    NullFields,
    MissingFields,
    TextFields,  ///< numbers in quotes
    ArrayFields, ///< vectors as arrays
    Empty,
    WrongId,
    NoDevices,
    NumberNaN,
    Number1e999,
    Number1e308,
    Masked,        ///< a frame as only clients send
    ReservedBits,  ///< as of an extension that was not agreed
    HalfFrame,     ///< then nothing more
    CloseSilently, ///< end of the connection without a close frame
    PingFlood,     ///< pings and no state
    None,          ///< half-open: nothing comes any more
};

struct HaplyFaults
{
    HaplyAnswer answer = HaplyAnswer::State;
    double share = 1.0;              ///< of the answers that `answer` concerns, at random
    std::int64_t stallUntil_ns = 0;  ///< nothing is read until then
    std::int64_t delayAnswer_ns = 0; ///< answers come so much later, although forces are taken at once
    double jitter = 0.0;             ///< probability that an answer is late by up to 4 ms, so that several come at once
    bool isFrozen = false;           ///< positions do not change
    double jump_m = 0.0;             ///< added to positions
};

/// Features of well-formed messages that a client must accept.
struct HaplyStyle
{
    int fragment = 0;          ///< bytes of a fragment; 0: one frame a message
    bool hasExponents = false; ///< numbers as 1.5e-1
    bool hasPings = false;     ///< a ping before each answer
    bool answersTwice = false; ///< a second state, unasked
    bool hasStrangers = false; ///< unknown fields
};

struct HaplyForce
{
    std::int64_t time_ns = 0;
    HaplyV3 f{};
};

struct HaplySample
{
    std::int64_t time_ns = 0;
    HaplyV3 p{};
};

struct HaplyDevice
{
    std::string id = "049D";
    std::string type = "inverse3";
    bool isPlugged = true;
    bool hasPower = true;
    bool isCalibrated = true;
    bool isReady = true;
    bool isInUse = false;
    // Where the Hub has left the axes; a session's own configuration goes before.
    std::string basis = "XYZ";
    HaplyV3 mount_m{};
    double mountScale = 1.0;
    bool ignoresConfiguration = false;
    double workspaceScale = 1.0; ///< of the navigation

    // Mechanics: a mass at the tip, a hand that holds it.
    double mass_kg = 0.15;
    double viscosity_Ns_per_m = 1.0;
    bool isHeld = true;
    HaplyV3 p{}, v{};
    HaplyV3 from{}, to{}; ///< motion of the hand
    std::int64_t begin_ns = 0;
    double duration_s = 0.0;
    HaplyV3 f{}; ///< of the motors: the sum over all sessions

    // Observations.
    double largestForce_N = 0.0;
    std::int64_t lastMessage_ns = 0;
    std::int64_t longestSilence_ns = 0; ///< longest time that motors drove without a message, other than by a stall
    std::uint64_t watchdogs = 0;        ///< number of times that the service removed a force that was not renewed
    std::uint64_t messages = 0;
    std::vector<HaplyForce> forces;   ///< all commands, in order
    std::vector<HaplySample> samples; ///< all answers, in order
};

struct HaplyGrip
{
    std::string id = "8001";
    std::string kind = "wireless_verse_grip";
    std::array<double, 4> q{1, 0, 0, 0}; ///< w, x, y, z in the service's axes
    bool isA = false, isB = false, isC = false;
};

struct HaplyBench
{
    std::string version = "3.5.0"; ///< empty: no page /version
    bool hasValues = false;        ///< takes a force under "values"
    bool hasVector = true;         ///< takes a force under "vector"
    bool isNew = true;             ///< 3.5: states the driven force, session_id, axes
    bool refusesUpgrade = false;   ///< 404 instead of 101
    bool ignoresUpgrade = false;   ///< no answer to the upgrade
    bool hasNoInventory = false;
    bool hasOpenDoor = true;         ///< false: nobody listens
    std::int64_t takes_ns = 200'000; ///< from a message to its answer
    std::vector<HaplyDevice> devices{HaplyDevice{}};
    std::vector<HaplyGrip> grips;
    HaplyFaults faults;
    HaplyStyle style;
    std::uint64_t sessions = 0; ///< opened so far
    int openSessions = 0;
    std::uint64_t pongs = 0;
    std::string lastError; ///< of a message that the service could not read
    std::int64_t sim_ns = 0;
    std::uint64_t random = 1;
};

/// Advances the mechanics to `now_ns`.
void advanceHaply(HaplyBench& bench, std::int64_t now_ns);

} // namespace standin
