// SPDX-License-Identifier: BSD-3-Clause
#include "tables/TickTable.h"

#include "database/Bounds.h"
#include "tables/Contacts.h"
#include "tables/Packing.h"
#include "tables/TickColumns.h"

#include <palpate/core/Numbers.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

namespace palpate::session::internal {

namespace {

/// Returns the names of all columns of `ticks`.
std::vector<std::string> storedNames(int version)
{
    std::vector<std::string> names;
    for (const TickColumn& column : kTickColumns) {
        if (column.isStored(version)) {
            const std::vector<std::string> own = columnNames(column);
            names.insert(names.end(), own.begin(), own.end());
        }
    }
    return names;
}

std::string joined(const std::vector<std::string>& texts)
{
    std::string out;
    for (const std::string& text : texts) {
        out += (out.empty() ? "" : ", ") + text;
    }
    return out;
}

/// Returns the SQL for one value of a column with NULL resolved. @param axis  "_x", "_y", "_z", or "" for a scalar
std::string filledIn(const TickColumn& column, const std::string& axis)
{
    const std::string name = std::string(column.name) + axis;
    switch (column.stored) {
    case Stored::UnlessZero:
        return "coalesce(" + name + ", 0.0)";
    case Stored::UnlessSame: {
        const auto same = std::find_if(std::begin(kTickColumns), std::end(kTickColumns),
                                       [&](const TickColumn& other) { return other.name == column.same; });
        return "coalesce(" + name + ", " + filledIn(*same, axis) + ")";
    }
    default:
        return name;
    }
}

} // namespace

std::string createTicks(int version)
{
    std::vector<std::string> columns = storedNames(version);
    columns.front() += " INTEGER PRIMARY KEY";
    return "CREATE TABLE ticks(" + joined(columns) + ");\n";
}

std::string createTickValues(int version)
{
    std::vector<std::string> columns;
    for (const TickColumn& column : kTickColumns) {
        for (const std::string& name : column.isStored(version) ? columnNames(column) : std::vector<std::string>()) {
            const std::string value = filledIn(column, name.substr(column.name.size()));
            if (name == "time_ns") {
                columns.push_back("time_ns * 1e-9 AS time_s");
            } else {
                columns.push_back(value == name ? name : value + " AS " + name);
            }
            if (name == "structure") {
                columns.push_back("(SELECT name FROM structures s WHERE s.generation = t.scene AND s.number = "
                                  "t.structure) AS name");
            }
        }
    }
    return "CREATE VIEW tick_values AS SELECT " + joined(columns) + " FROM ticks t;\n";
}

std::string insertTick()
{
    return "INSERT INTO ticks VALUES(" + joined(std::vector<std::string>(tickColumnCount(kRecordingVersion), "?")) +
           ")";
}

std::string selectTicks(const std::string& rest, int version)
{
    return "SELECT " + joined(storedNames(version)) + " FROM ticks " + rest;
}

std::size_t tickColumnCount(int version)
{
    return storedNames(version).size();
}

void bindTick(Statement& row, const servo::TickRecord& tick)
{
    int place = 0;
    for (const TickColumn& column : kTickColumns) {
        if (!column.isStored()) {
            continue;
        }
        useValue(column, tick, [&]<class Value>(const Value& value) {
            if constexpr (std::is_same_v<Value, core::Vec3>) {
                const bool isNull = column.stored != Stored::Always && sameBits(value, impliedVector(column, tick));
                for (const double number : value) {
                    isNull ? row.bindNull(place++) : row.bind(place++, number);
                }
            } else if constexpr (std::is_same_v<Value, haptics::TickResult>) {
                const std::string layers = packLayers(tick);
                layers.empty() ? row.bindNull(place++) : row.bindBlob(place++, layers);
            } else if constexpr (std::is_same_v<Value, double>) {
                row.bind(place++, value);
            } else {
                const bool isNull = column.stored == Stored::InContact && tick.felt.structure < 0;
                isNull ? row.bindNull(place++) : row.bind(place++, static_cast<std::int64_t>(value));
            }
        });
    }
}

std::vector<std::string> knownTickValues(int version)
{
    std::vector<std::string> known{createTickValues(version)};
    if (version < 3) { // written by versions 1 and 2
        known.emplace_back(
            "CREATE VIEW tick_values AS SELECT tick, time_ns * 1e-9 AS time_s, hip_x, hip_y, hip_z, "
            "coalesce(god_x, hip_x) AS god_x, coalesce(god_y, hip_y) AS god_y, coalesce(god_z, hip_z) AS god_z, "
            "coalesce(force_x, 0.0) AS force_x, coalesce(force_y, 0.0) AS force_y, coalesce(force_z, 0.0) AS force_z, "
            "coalesce(sent_x, force_x, 0.0) AS sent_x, coalesce(sent_y, force_y, 0.0) AS sent_y, "
            "coalesce(sent_z, force_z, 0.0) AS sent_z, structure, "
            "(SELECT name FROM structures s WHERE s.generation = t.scene AND s.number = t.structure) AS name, "
            "triangle, constraints, scene, buttons, solve_ns, iterations, flags FROM ticks t");
    }
    return known;
}

namespace {

/// Reads the values of a row and keeps the first error.
class TickRow
{
  public:
    TickRow(const Statement& row, core::Message& wrong)
        : m_row(row)
        , m_wrong(wrong)
    {
    }

    [[nodiscard]] bool isNull() const { return m_row.isNull(m_place); }

    double real(const TickColumn& column, double most)
    {
        const int place = m_place++;
        const double value = m_row.real(place); // NaN if not a number
        if (std::abs(value) <= most) {
            return value;
        }
        note(column, place, core::Message(PALPATE_TEXT("a number within %1"), most));
        return 0.0;
    }

    std::int64_t integer(const TickColumn& column, std::int64_t least, std::int64_t most)
    {
        const int place = m_place++;
        const std::int64_t value = m_row.integer(place);
        if (m_row.isInteger(place) && value >= least && value <= most) {
            return value;
        }
        note(column, place, core::Message(PALPATE_TEXT("a whole number from %1 to %2"), least, most));
        return least;
    }

    /// @pre isNull() for the first component
    void skipVector(const TickColumn& column)
    {
        if (!m_row.isNull(m_place + 1) || !m_row.isNull(m_place + 2)) {
            note(column, m_place, core::Message(PALPATE_TEXT("three numbers or none")));
        }
        m_place += 3;
    }
    void skip() { ++m_place; }

    std::string blob(const TickColumn& column)
    {
        const int place = m_place++;
        if (!m_row.isNull(place) && m_row.type(place) != Statement::Type::Blob) {
            note(column, place, core::Message(PALPATE_TEXT("bytes")));
            return {};
        }
        return m_row.bytes(place);
    }

    void note(const TickColumn& column, int place, const core::Message& expected)
    {
        if (m_wrong.isEmpty()) {
            m_wrong = core::Message(PALPATE_TEXT("found %1 for %2, expected %3"), found(place), column.name, expected);
        }
    }

  private:
    [[nodiscard]] core::MessageArgument found(int place) const
    {
        switch (m_row.type(place)) {
        case Statement::Type::Null:
            return core::Message(PALPATE_TEXT("nothing"));
        case Statement::Type::Text:
            return core::Message(PALPATE_TEXT("text"));
        case Statement::Type::Blob:
            return core::Message(PALPATE_TEXT("bytes"));
        case Statement::Type::Integer:
            return m_row.integer(place);
        case Statement::Type::Real:
            break;
        }
        return m_row.real(place);
    }

    const Statement& m_row;
    core::Message& m_wrong;
    int m_place = 0;
};

/// Returns the maximum absolute value of a vector component.
double mostOf(const TickColumn& column)
{
    const bool isPlace = column.name == "hip" || column.name == "god";
    return isPlace ? kMaxLength_mm : column.stored == Stored::UnlessSpring ? kMaxNormal : kMaxForce_N;
}

/// Returns the range of an integer column: that of its type, or less if a reader depends on tighter limits.
template<class Value>
std::pair<std::int64_t, std::int64_t> rangeOf(const TickColumn& column)
{
    if (column.name == "constraints") {
        return {0, 3};
    }
    return {0, sizeof(Value) == sizeof(std::int64_t) ? kMaxTick
                                                     : static_cast<std::int64_t>(std::numeric_limits<Value>::max())};
}

} // namespace

servo::TickRecord readTick(const Statement& row, int version, core::Message& wrong)
{
    servo::TickRecord tick;
    std::string layers;
    TickRow values(row, wrong);
    for (const TickColumn& column : kTickColumns) {
        if (!column.isStored(version)) {
            continue;
        }
        useValue(column, tick, [&]<class Value>(Value& value) {
            const bool isImplied = column.stored != Stored::Always && values.isNull();
            if constexpr (std::is_same_v<Value, core::Vec3>) {
                if (isImplied) {
                    values.skipVector(column);
                    value = impliedVector(column, tick);
                } else {
                    for (double& number : value) {
                        number = values.real(column, mostOf(column));
                    }
                }
            } else if constexpr (std::is_same_v<Value, haptics::TickResult>) {
                layers = values.blob(column);
            } else if constexpr (std::is_same_v<Value, double>) {
                value = values.real(column, kMaxForce_N);
            } else if (isImplied) {
                values.skip();
            } else {
                const auto [least, most] = rangeOf<Value>(column);
                value = static_cast<Value>(values.integer(column, least, most));
            }
        });
    }
    if (version < 3) {
        tick.felt.n_W = springDirection(tick);
    }
    if (!unpackLayers(layers, tick) && wrong.isEmpty()) {
        wrong = core::Message(PALPATE_TEXT("found no contacts of layers in the column layers"));
    }
    return tick;
}

} // namespace palpate::session::internal
