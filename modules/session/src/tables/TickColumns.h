// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recording.h"

#include <palpate/servo/TickRecord.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace palpate::session::internal {

/// Member of a tick that holds a column's value.
using TickMember = std::variant<std::int64_t servo::TickRecord::*, std::uint32_t servo::TickRecord::*,
                                std::uint16_t servo::TickRecord::*, double servo::TickRecord::*,
                                core::Vec3 servo::TickRecord::*, haptics::TickResult servo::TickRecord::*,
                                core::Vec3 haptics::TickResult::*, std::int32_t haptics::TickResult::*,
                                std::uint32_t haptics::TickResult::*, std::uint8_t haptics::TickResult::*>;

/// Condition for storing a value in the table `ticks`. Values that can be derived are stored as NULL.
enum class Stored : std::uint8_t
{
    Always,
    InContact,    ///< NULL: default value of a new TickRecord
    UnlessZero,   ///< NULL: zero vector with positive signs
    UnlessSame,   ///< NULL: bits of the vector `TickColumn::same`
    UnlessSpring, ///< NULL: bits of `springDirection`
    UnlessAlone,  ///< for the contacts of a TickResult; NULL: only `ownContact`
    Never         ///< not in the table and not in the checksum
};

/// One value of a tick, with its name in the table `ticks`, in the CSV and in resources/docs/recording.md.
struct TickColumn
{
    std::string_view name; ///< base name for a vector with three columns _x, _y and _z
    TickMember member;
    std::string_view meaning; ///< description in recording.md
    int csv = 0;              ///< position in the CSV, from 1; 0: absent
    Stored stored = Stored::Always;
    std::string_view same{}; ///< for Stored::UnlessSame: name of the other column
    int since = 1;           ///< first recording version with this column

    [[nodiscard]] constexpr bool isStored(int version = kRecordingVersion) const noexcept
    {
        return stored != Stored::Never && version >= since;
    }
};

using haptics::TickResult;
using servo::TickRecord;

/// All values of a tick; the stored ones in the order of the table `ticks`. Append new values at the end and without a
/// CSV position, because readers depend on the order. In the CSV, add them to kCsvColumns.
inline constexpr TickColumn kTickColumns[] = {
    {"tick", &TickRecord::tick, "primary key, since the servo started; a gap is a loss", 1},
    {"time_ns", &TickRecord::time_ns, "monotonic, since the recording's first tick"},
    {"hip", &TickRecord::p_WH, "HIP that was solved, after the safety gate", 2},
    {"god", &TickResult::p_WG, "god-object; NULL: the HIP's bits", 3, Stored::UnlessSame, "hip"},
    {"force", &TickResult::f_W, "force of the model on the hand; NULL: zero", 4, Stored::UnlessZero},
    {"sent", &TickRecord::fSent_W, "force given to the device, after the safety gate; NULL: `force`'s bits", 0,
     Stored::UnlessSame, "force"},
    {"structure", &TickResult::structure, "number of the touched structure in the scene, NULL in free space", 6,
     Stored::InContact},
    {"triangle", &TickResult::triangle, "touched triangle, in the mesh file's order; NULL in free space", 0,
     Stored::InContact},
    {"constraints", &TickResult::constraints, "active planes, 0 to 3", 5},
    {"scene", &TickRecord::scene, "generation of the scene that was felt"},
    {"buttons", &TickRecord::buttons, "of the device, a bit each"},
    {"solve_ns", &TickRecord::solve_ns, "time that the solver took in this tick", 7},
    {"iterations", &TickResult::iterations, "moves of the solver in this tick"},
    {"flags", &TickRecord::flags,
     "sum of: 1 overrun, 2 HIP gated, 4 force gated, 8 iteration bound hit, 16 ticks lost before this one, "
     "32 first tick on another scene, 64 god-object started anew at the HIP, 128 no hand (nothing was "
     "solved), 256 clutched (the device moved, the HIP stayed, nothing was felt), 512 friction lets the god-object "
     "slide, "
     "1024 friction holds it (neither: there is none)"},
    {"normal", &TickResult::n_W,
     "unit normal of the contact, from surface to free space; NULL: the direction of the spring, from the HIP to the "
     "god-object, and zero in free space",
     8, Stored::UnlessSpring, "", 3},
    {"layers", &TickRecord::felt, "each contact of the tick, see below; NULL: the columns before say all of it", 0,
     Stored::UnlessAlone, "", 3},
    {"velocity", &TickRecord::v_WH,
     "the hand's velocity as dampers were given it [mm/s]; zero in free space and where nothing has a damper; NULL: "
     "zero",
     0, Stored::UnlessZero, "", 4},
    {"damping", &TickRecord::fDamping_W, "part of `sent` that the passivity controller asked for", 0, Stored::Never},
    {"energy_mJ", &TickRecord::energy_mJ, "what the hand put in since contact began and has not got back", 0,
     Stored::Never},
};

/// CSV types that contain a column.
enum class InCsv : std::uint8_t
{
    All,
    OfSession, ///< CSV of a recording
    OfDevice   ///< CSV of a replay with a device
};

/// CSV-only column after the values of kTickColumns: derived values and events.
struct CsvColumn
{
    std::string_view name;
    std::string_view meaning; ///< description in recording.md
    InCsv in = InCsv::OfSession;
    bool isWithoutHand = false; ///< filled even without a hand
};

/// In CSV order; append new columns at the end.
inline constexpr CsvColumn kCsvColumns[] = {
    {"slides", "1 while friction lets the god-object slide, 0 while it holds it, empty without friction", InCsv::All},
    {"layers", "each structure in contact, the outermost layer first, see below", InCsv::All},
    {"time_s", "since the recording's first tick [s]", InCsv::OfSession, true},
    {"sent_x_N", "force given to the device, after the safety gate [N]"},
    {"sent_y_N", "the same along y [N]"},
    {"sent_z_N", "the same along z [N]"},
    {"force_N", "length of the model's force on the hand [N]"},
    {"depth_mm", "distance of the god-object of the outermost layer touched from the HIP; 0 in free space [mm]"},
    {"felt_N_per_mm", "`force_N` ÷ `depth_mm`: all layers together; empty without a depth [N/mm]"},
    {"events", "what happened in this tick, see below", InCsv::OfSession, true},
    {"sent_x", "of a replay with a device: force given to it, after the safety gate [N]", InCsv::OfDevice},
    {"sent_y", "the same along y [N]", InCsv::OfDevice},
    {"sent_z", "the same along z [N]", InCsv::OfDevice},
};

/// Passes a column's value to `use` by reference. @param tick  a TickRecord, const or not
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

/// Returns the direction of the spring, from HIP to god-object; zero in free space and for zero length.
[[nodiscard]] core::Vec3 springDirection(const servo::TickRecord& tick);

/// Returns the column names in `ticks` and in the CSV: one, or three for a vector.
[[nodiscard]] std::vector<std::string> columnNames(const TickColumn& column);
/// Returns the vector that NULL stands for in a column. @pre `stored` is UnlessZero, UnlessSame or UnlessSpring
[[nodiscard]] core::Vec3 impliedVector(const TickColumn& column, const servo::TickRecord& tick);

} // namespace palpate::session::internal
