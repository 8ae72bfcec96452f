// SPDX-License-Identifier: BSD-3-Clause
#include "tables/TickColumns.h"

#include <algorithm>
#include <iterator>

namespace palpate::session::internal {

std::vector<std::string> columnNames(const TickColumn& column)
{
    const std::string name(column.name);
    servo::TickRecord any;
    std::vector<std::string> names;
    useValue(column, any, [&]<class Value>(const Value&) {
        if constexpr (std::is_same_v<Value, core::Vec3>) {
            names = {name + "_x", name + "_y", name + "_z"};
        } else {
            names = {name};
        }
    });
    return names;
}

core::Vec3 springDirection(const servo::TickRecord& tick)
{
    const core::Vec3 spring = tick.felt.p_WG - tick.p_WH;
    const double length = spring.norm();
    return tick.felt.structure >= 0 && length > 0.0 ? core::Vec3(spring / length) : core::Vec3::Zero();
}

core::Vec3 impliedVector(const TickColumn& column, const servo::TickRecord& tick)
{
    if (column.stored == Stored::UnlessSpring) {
        return springDirection(tick);
    }
    core::Vec3 implied = core::Vec3::Zero();
    if (column.stored == Stored::UnlessSame) {
        const auto same = std::find_if(std::begin(kTickColumns), std::end(kTickColumns),
                                       [&](const TickColumn& other) { return other.name == column.same; });
        useValue(*same, tick, [&]<class Value>(const Value& value) {
            if constexpr (std::is_same_v<Value, core::Vec3>) {
                implied = value;
            }
        });
    }
    return implied;
}

} // namespace palpate::session::internal
