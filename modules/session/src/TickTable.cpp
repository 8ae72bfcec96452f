// SPDX-License-Identifier: BSD-3-Clause
#include "TickTable.h"

#include "Contacts.h"
#include "Packing.h"
#include "TickColumns.h"

#include <algorithm>
#include <iterator>

namespace palpate::session::internal {

namespace {

/// @return the names of all columns, as `ticks` has them.
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

/// One of a column's values in SQL, whatever NULL stands for filled in. @param axis  "_x", "_y", "_z", or "" of a
/// number
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

servo::TickRecord readTick(const Statement& row, int version)
{
    servo::TickRecord tick;
    std::string layers;
    int place = 0;
    for (const TickColumn& column : kTickColumns) {
        if (!column.isStored(version)) {
            continue;
        }
        useValue(column, tick, [&]<class Value>(Value& value) {
            if constexpr (std::is_same_v<Value, core::Vec3>) {
                value = column.stored != Stored::Always && row.isNull(place)
                            ? impliedVector(column, tick)
                            : core::Vec3(row.real(place), row.real(place + 1), row.real(place + 2));
                place += 3;
            } else if constexpr (std::is_same_v<Value, haptics::TickResult>) {
                layers = row.bytes(place++);
            } else if constexpr (std::is_same_v<Value, double>) {
                value = row.real(place++);
            } else {
                if (column.stored == Stored::Always || !row.isNull(place)) {
                    value = static_cast<Value>(row.integer(place));
                }
                ++place;
            }
        });
    }
    if (version < 3) {
        tick.felt.n_W = springDirection(tick);
    }
    unpackLayers(layers, tick);
    return tick;
}

} // namespace palpate::session::internal
