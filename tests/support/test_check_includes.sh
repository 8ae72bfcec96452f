#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_includes.pl must pass a source that includes what it uses and name what another one lacks.
set -eu
check=$(dirname "${BASH_SOURCE[0]}")/check_includes.pl
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failed=0
mkdir -p "$tree/modules/core/include/palpate/core" "$tree/modules/core/src"
printf '%s\n' '#pragma once' '#include <vector>' 'struct Grid' '{' '    std::vector<int> cells;' '};' 'int sumOf(const Grid& grid);' \
    >"$tree/modules/core/include/palpate/core/Grid.h"

# expect NAME SOURCE: a tree with this source lacks an include for NAME; an empty NAME: lacks none.
expect() {
    printf '%b' "$2" >"$tree/modules/core/src/a.cpp"
    local result=0 found
    found=$("$check" "$tree" 2>&1) || result=$?
    if [[ -z $1 && $result -ne 0 ]] || [[ -n $1 && ($result -ne 1 || $found != "modules/core/src/a.cpp: uses $1 without "*) ]]; then
        echo "FAIL: expected \"$1\" for: $2: $found"
        failed=1
    fi
}

grid='#include "palpate/core/Grid.h"\n'
expect '' "${grid}int f() { return sumOf(Grid{}); }\n"
expect '' "${grid}std::vector<int> v; // by way of Grid.h\n"
expect '' '// std::map\nconst char* text = "std::map";\nclass QLabel;\nvoid f(QLabel* label);\n'
expect '' '#include <QLabel>\nvoid f() { QLabel label; QString text; }\n'
expect '' '#include <sstream>\nstd::string s;\n'
expect 'std::map' 'std::map<int, int> m;\n'
expect 'std::sqrt' "${grid}double f(double a) { return std::sqrt(a); }\n"
expect 'sumOf' 'struct Grid;\nint f(const Grid& grid) { return sumOf(grid); }\n'
expect 'QLabel' '#include <QWidget>\nvoid f() { new QLabel(QString()); }\n'
expect 'vtkActor' 'void f() { vtkActor::New(); }\n'
exit $failed
