// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <pthread.h>

/// The bench of the emulated devices: a plain struct in a file shared between processes, so that a device outlives the
/// process that drives it, like a real one. Guarded by `lock`.
namespace standin {

using V3 = std::array<double, 3>;

/// Parameters of one arm in SI units; defaults match the kit. Deliberately separate from the driver's configuration.
struct ArmUnit
{
    int variant = 0;
    int protocol = 2;
    V3 capstan_m{0.010, 0.010, 0.010};
    V3 body_m{0.160, 0.120, 0.120};
    V3 link_m{0.080, 0.205, 0.245};
    V3 origin_m{0.220, 0.0, 0.080};
    V3 torqueConstant{0.0259, 0.0259, 0.0259};
    V3 countsPerTurn{2000, 2000, 2000};
    double massB_kg = 0.170;
    double massC_kg = 0.110;
    double centreB_m = 0.051;
    double centreC_m = 0.091;
    double gravity = 0.0;
    double baseInertia = 4e-4;        ///< rotating base [kg m^2], an estimate
    double rotorInertia = 3.4e-6;     ///< typical for a 30 mm graphite-brush motor with this torque constant [kg m^2]
    double motorFriction_Nm = 1.5e-3; ///< brushes and cable
    double jointViscosity = 1e-3;     ///< [N m s]
    double fullScale_A = 3.0;         ///< limit of the amplifiers
};

struct Knot
{
    double time_s = 0.0;
    V3 p_mm{}; ///< in the arm's frame D
};

/// A hand that holds the tip: a mass attached to the tip and drawn to a moving target by a spring and a damper.
///
/// Stiffness and damping are in the ranges that Hajian & Howe (J. Biomech. Eng. 119, 1997) identified at the fingertip,
/// 255 to 1255 N/m and 4 to 7.4 N s/m (cited from secondary literature); the mass is an assumption for fingers with a
/// stylus. Tremor: 8 to 12 Hz, a tenth of a millimetre, as in physiological tremor.
struct Hand
{
    double mass_kg = 0.1;
    double stiffness_N_per_m = 500.0;
    double damping_Ns_per_m = 5.0;
    double tremor_mm = 0.05;
    double tremor_Hz = 9.0;
    bool isHolding = true;
    int knots = 0;
    std::array<Knot, 128> path{}; ///< smooth between knots, at rest before and after; empty: stays in the rest pose
};

/// Injected faults; probabilities are per report.
struct Faults
{
    double dropIn = 0.0; ///< a report from the device is lost
    double dropOut = 0.0;
    double repeat = 0.0;
    double shortened = 0.0;
    double lengthened = 0.0;
    double random = 0.0; ///< of the right length, all bytes random
    double delay = 0.0;
    double delayLeast_s = 0.001;
    double delayMost_s = 0.020;
    std::int64_t stalledUntil_ns = 0; ///< the firmware hangs until then
};

/// A report of the host as received by the firmware.
struct Taken
{
    std::int64_t time_ns = 0;
    std::array<std::int16_t, 3> mA{};
    std::int16_t command = 0;
    V3 f_D{};          ///< current motor force at the tip [N]
    V3 p_mm{};         ///< true tip position at that time
    V3 sampled_mm{};   ///< true tip position when the device sampled its previous report
    V3 countStep_mm{}; ///< largest tip motion per encoder count, over the axes
};

struct Packet
{
    std::array<std::uint8_t, 64> bytes{};
    int length = 0;
    std::int64_t ready_ns = 0;
};

struct Queue
{
    std::array<Packet, 30> packets{}; ///< same number as in hidapi's libusb back end
    int first = 0;
    int count = 0;
};

struct Arm
{
    ArmUnit unit;
    Hand hand;
    bool isPlugged = true;
    bool isButtonDown = false;
    std::uint32_t plugins = 0; ///< number of times plugged in; handles from before are invalid
    std::int64_t plugged_ns = 0;
    std::int64_t sim_ns = 0;
    V3 q{}; ///< link angles: whole arm, b from the vertical, c from the vertical downwards
    V3 v{};
    V3 amps{};
    std::array<double, 6> counterOffset{};
    std::array<std::int16_t, 6> counters{};
    V3 sampled_mm{};
    std::int64_t lastHost_ns = 0; ///< for the watchdog
    bool isAwaitingHost = true;
    bool isReportDue = false;
    Queue toHost;
    Queue toDevice;
    std::uint64_t watchdogs = 0;
    std::uint64_t takenCount = 0;
    std::array<Taken, 4096> taken{};
    double largestForce_N = 0.0;    ///< of the motors at the tip
    std::int64_t forceSince_ns = 0; ///< start of the uninterrupted motor force; 0: no force
};

struct Puck
{
    bool isPlugged = false;
    std::uint16_t vendor = 0x256f;
    std::uint16_t product = 0xc635;
    bool hasSixAxisReport = false;
    std::uint32_t plugins = 0;
    std::array<std::int16_t, 6> axes{}; ///< all zero: idle, no reports
    std::uint32_t buttons = 0;
    int light = -1; ///< last value set
    std::int64_t next_ns = 0;
    bool isTurnNext = false;
    bool wasHeld = false;
    std::uint32_t buttonsSent = 0;
    Queue toHost;
};

struct Bench
{
    std::uint64_t magic = 0; ///< kMagic after initialisation
    pthread_mutex_t lock;
    std::uint64_t random = 1;
    Arm arm;
    Faults faults;
    Puck puck;
    bool hasStranger = false; ///< another mbed device with the arm's ids is also on the bus
    int strangerLength = 0;   ///< > 0: the arm itself sends reports of this length
};

constexpr std::uint64_t kMagic = 0x70616c7061746531;

/// Opens the bench in the file `path` and creates the file if missing; null on failure. A null path makes a bench for
/// this process alone.
Bench* openBench(const char* path);
void lockBench(Bench& bench);
void unlockBench(Bench& bench);

/// Advances the simulation to `now_ns`.
void advance(Bench& bench, std::int64_t now_ns);
/// Returns the time of the next possible bus event after `now_ns`: half a frame.
std::int64_t nextEvent(std::int64_t now_ns);
/// Plugs in the arm, in its rest pose with counters at zero, or unplugs the arm.
void plugArm(Bench& bench, bool isPlugged, std::int64_t now_ns);
void plugPuck(Bench& bench, bool isPlugged);
/// Returns a random number in [0, 1).
double draw(Bench& bench);

// Arm.cpp: the mechanics.
V3 tipOf(const ArmUnit& unit, const V3& q);                   ///< [mm]
V3 forceOf(const ArmUnit& unit, const V3& q, const V3& amps); ///< of the motors, at the tip [N]
V3 restPose(const ArmUnit& unit);
V3 targetOf(const Arm& arm, double time_s); ///< of the hand, with tremor [mm]
void stepArm(Arm& arm, double dt_s);
std::array<double, 3> countsOf(const ArmUnit& unit, const V3& q); ///< encoders a, b, c with the signs of protocol 2
V3 countStepOf(const ArmUnit& unit, const V3& q);

// Puck.cpp
void advancePuck(Puck& puck, std::int64_t now_ns);

bool push(Queue& queue, const Packet& packet); ///< drops the oldest packet if full
bool pop(Queue& queue, std::int64_t now_ns, Packet& out);

} // namespace standin
