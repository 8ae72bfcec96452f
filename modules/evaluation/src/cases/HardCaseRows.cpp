// SPDX-License-Identifier: BSD-3-Clause
#include "cases/HardCaseRows.h"

namespace palpate::evaluation {

HardCase row(std::string name, std::function<geometry::TriangleMesh()> mesh, const HandPath& path)
{
    HardCase result;
    result.name = std::move(name);
    result.mesh = std::move(mesh);
    result.ticks = static_cast<std::int64_t>(path.points().size());
    const auto points = std::make_shared<const std::vector<Vec3>>(path.points());
    result.motion = [points] {
        return [points, next = std::size_t{0}]() mutable { return (*points)[std::min(next++, points->size() - 1)]; };
    };
    return result;
}

const std::vector<HardCase>& hardCases()
{
    static const std::vector<HardCase> rows = [] {
        std::vector<HardCase> all;
        addMeshFaultRows(all);
        addContactRows(all);
        addTransformRows(all);
        addHandRows(all);
        addTieRows(all);
        addLayerRows(all);
        addFingertipRows(all);
        return all;
    }();
    return rows;
}

} // namespace palpate::evaluation
