#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The layering check must pass a tree that keeps the rules and fail each of the trees that break one.
set -eu
check=$(dirname "${BASH_SOURCE[0]}")/check_layers.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failed=0

# expect RESULT FILE LINE [SOURCE]: a tree with the FILE of this LINE, and an empty SOURCE, gives RESULT, 0 allowed and 1 not.
expect() {
    rm -rf "$tree/modules" "$tree/app" "$tree/plugins"
    mkdir -p "$tree/$(dirname "$2")"
    printf '// a comment\n%s\n' "$3" >"$tree/$2"
    if [ $# -gt 3 ]; then # the header's source
        mkdir -p "$tree/$(dirname "$4")"
        : >"$tree/$4"
    fi
    local result=0 said
    said=$("$check" "$tree") || result=$?
    if [ "$result" -ne "$1" ]; then
        echo "FAIL: $2 with $3: exit code $result, expected $1: $said"
        failed=1
    elif [ "$result" -ne 0 ] && [[ $said != "$2:"[12]": "* ]]; then
        echo "FAIL: $2 with $3: the place is not named: $said"
        failed=1
    fi
}

expect 0 modules/haptics/src/a.cpp '#include <palpate/geometry/SurfaceIndex.h>'
expect 0 modules/haptics/src/a.cpp '#include "palpate/core/Types.h"'
expect 0 modules/session/src/a.cpp '#include <palpate/core/Types.h>'
expect 0 modules/session/src/a.cpp '#include <QFile>'
expect 0 modules/view/src/a.cpp '#include <vtkActor.h>'
expect 0 app/src/a.cpp '#include <palpate/haptics/Palpator.h>'
expect 1 modules/geometry/src/a.cpp '#include <palpate/haptics/Palpator.h>'
expect 1 modules/geometry/include/palpate/geometry/a.h '#include "palpate/haptics/Palpator.h"'
expect 1 modules/device/src/a.cpp '  #  include <palpate/servo/TickRecord.h>'
expect 1 modules/view/src/a.cpp '#include <palpate/session/Recording.h>'
expect 1 modules/core/src/a.cpp '#include <palpate/nowhere/A.h>'
expect 1 modules/unlisted/src/a.cpp ''
expect 1 plugins/hid/a.cpp '#include <palpate/geometry/TriangleMesh.h>'
expect 1 modules/servo/src/a.cpp '#include <vtkPolyData.h>'
expect 1 modules/session/src/a.cpp '#include <QtWidgets/QWidget>'
expect 1 modules/device/src/a.cpp '#include <hidapi/hidapi.h>'
expect 1 modules/haptics/src/a.cpp '#include <QString>'
expect 1 modules/core/src/a.cpp '#include <QtCore/QString>'
expect 1 modules/view/src/a.cpp '#include <QString>'
expect 1 modules/meshio/include/palpate/meshio/a.h '#include <vtkPolyData.h>'
expect 1 modules/servo/CMakeLists.txt 'palpate_module(servo LIBRARIES VTK::CommonCore)'
expect 0 modules/haptics/src/solver/a.cpp '#include "goal/CoulombFriction.h"'
expect 0 modules/haptics/src/a.cpp '#include "solver/GodObject.h"'
expect 1 modules/haptics/src/law/a.cpp '#include "solver/GodObject.h"'
expect 1 modules/haptics/src/nearby/a.cpp '#include "law/Foot.h"'
expect 1 modules/haptics/src/elsewhere/a.cpp ''
expect 0 app/src/window/a.cpp '#include "shared/Console.h"'
expect 1 app/src/shared/a.cpp '#include "window/Window.h"'
# A public header belongs to the folder of its source.
expect 0 modules/ui/src/touch/a.cpp '#include "palpate/ui/b.h"' modules/ui/src/widgets/b.cpp
expect 1 modules/ui/src/widgets/a.cpp '#include "palpate/ui/b.h"' modules/ui/src/touch/b.cpp
exit $failed
