// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/servo/TickRecord.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace palpate::session::internal {

/// Where a value stands in a tick.
using TickMember =
    std::variant<std::int64_t servo::TickRecord::*, std::uint32_t servo::TickRecord::*,
                 std::uint16_t servo::TickRecord::*, double servo::TickRecord::*, core::Vec3 servo::TickRecord::*,
                 core::Vec3 haptics::TickResult::*, std::int32_t haptics::TickResult::*,
                 std::uint32_t haptics::TickResult::*, std::uint8_t haptics::TickResult::*>;

/// When a value is NULL in the table `ticks`, which leaves out what can be known without it.
enum class Null : std::uint8_t
{
    Never,
    InFreeSpace, ///< stands for what the value is in a new TickRecord
    Zero,        ///< stands for a zero vector, all signs positive
    SameAs       ///< stands for the bits of the vector `TickColumn::same`
};

/// One value of a tick: its name in the table `ticks`, in the CSV and in resources/docs/recording.md.
struct TickColumn
{
    std::string_view name; ///< of a vector: of three columns, with _x, _y and _z at the end
    TickMember member;
    std::string_view meaning; ///< as recording.md says it
    Null null = Null::Never;
    std::string_view same{}; ///< for Null::SameAs: name of the other column
    bool isStored = true;    ///< in `ticks` and its checksum
    int csv = 0;             ///< place in the CSV, from 1; 0: not in it
};

/// All values of a tick, those of the table `ticks` in its order. A new one comes last, and last in the CSV: readers go
/// by the order.
inline constexpr TickColumn kTickColumns[] = {
    {.name = "tick",
     .member = &servo::TickRecord::tick,
     .meaning = "primary key, since the servo started; a gap is a loss",
     .csv = 1},
    {.name = "time_ns",
     .member = &servo::TickRecord::time_ns,
     .meaning = "monotonic, since the recording's first tick"},
    {.name = "hip",
     .member = &servo::TickRecord::p_WH,
     .meaning = "HIP that was solved, after the safety gate",
     .csv = 2},
    {.name = "god",
     .member = &haptics::TickResult::p_WG,
     .meaning = "god-object; NULL: the HIP's bits",
     .null = Null::SameAs,
     .same = "hip",
     .csv = 3},
    {.name = "force",
     .member = &haptics::TickResult::f_W,
     .meaning = "force of the model on the hand; NULL: zero",
     .null = Null::Zero,
     .csv = 4},
    {.name = "sent",
     .member = &servo::TickRecord::fSent_W,
     .meaning = "force given to the device, after the safety gate; NULL: `force`'s bits",
     .null = Null::SameAs,
     .same = "force"},
    {.name = "structure",
     .member = &haptics::TickResult::structure,
     .meaning = "number of the touched structure in the scene, NULL in free space",
     .null = Null::InFreeSpace,
     .csv = 6},
    {.name = "triangle",
     .member = &haptics::TickResult::triangle,
     .meaning = "touched triangle, in the mesh file's order; NULL in free space",
     .null = Null::InFreeSpace},
    {.name = "constraints", .member = &haptics::TickResult::constraints, .meaning = "active planes, 0 to 3", .csv = 5},
    {.name = "scene", .member = &servo::TickRecord::scene, .meaning = "generation of the scene that was felt"},
    {.name = "buttons", .member = &servo::TickRecord::buttons, .meaning = "of the device, a bit each"},
    {.name = "solve_ns",
     .member = &servo::TickRecord::solve_ns,
     .meaning = "time that the solver took in this tick",
     .csv = 7},
    {.name = "iterations", .member = &haptics::TickResult::iterations, .meaning = "moves of the solver in this tick"},
    {.name = "flags",
     .member = &servo::TickRecord::flags,
     .meaning = "sum of: 1 overrun, 2 HIP gated, 4 force gated, 8 iteration bound hit, 16 ticks lost before this one, "
                "32 first tick on another scene, 64 god-object started anew at the HIP, 128 no hand (nothing was "
                "solved), 256 clutched (the device moved, the HIP stayed, nothing was felt)"},
    {.name = "normal",
     .member = &haptics::TickResult::n_W,
     .meaning = "direction of the contact; a reader gives that of the spring, from the HIP to the god-object",
     .isStored = false},
    {.name = "damping",
     .member = &servo::TickRecord::fDamping_W,
     .meaning = "part of `sent` that the passivity controller asked for",
     .isStored = false},
    {.name = "energy_mJ",
     .member = &servo::TickRecord::energy_mJ,
     .meaning = "what the hand put in since contact began and has not got back",
     .isStored = false},
};

/// Gives a column's value to `use`, by reference. @param tick  a TickRecord, const or not
template<class Tick, class Use>
void useValue(const TickColumn& column, Tick& tick, Use&& use)
{
    std::visit(
        [&]<class Class, class Value>(Value Class::*member) {
            if constexpr (std::is_same_v<Class, servo::TickRecord>) {
                use(tick.*member);
            } else {
                use(tick.felt.*member);
            }
        },
        column.member);
}

/// @return the names of its columns in `ticks` and the CSV: one, or a vector's three.
[[nodiscard]] std::vector<std::string> columnNames(const TickColumn& column);
/// The vector that a column's NULLs stand for. @pre `null` is Zero or SameAs
[[nodiscard]] core::Vec3 impliedVector(const TickColumn& column, const servo::TickRecord& tick);

} // namespace palpate::session::internal
