// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Balls.h"

#include <palpate/ui/StructureModel.h>
#include <palpate/view/SurfaceMesh.h>

#include <QComboBox>

namespace palpate::test {

/// Returns a combo box of a panel by its accessible name.
inline QComboBox* boxNamed(const QWidget& panel, const char* name)
{
    for (QComboBox* one : panel.findChildren<QComboBox*>()) {
        if (one->accessibleName() == QLatin1String(name)) {
            return one;
        }
    }
    qFatal("no choice \"%s\"", name);
}

/// Returns a palpable, loaded row as the loader produces.
inline ui::StructureRow row(const std::string& name, const geometry::TriangleMesh& mesh)
{
    ui::StructureRow made;
    made.loaded.description.name = name;
    made.loaded.surface =
        std::make_shared<const geometry::RepairedMesh>(geometry::repair(mesh, geometry::Facing::AsGiven));
    made.picture = view::makeSurface(*made.loaded.surface);
    made.touch = std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(*made.loaded.surface));
    return made;
}

inline std::vector<ui::StructureRow> twoRows()
{
    std::vector<ui::StructureRow> rows;
    rows.push_back(row("VH_F_liver_capsule", ball(50.0, 4)));
    rows.push_back(row("lump", ball(8.0, 2)));
    return rows;
}

} // namespace palpate::test
