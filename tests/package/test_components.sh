#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_components.sh SOURCE WORK COMPILER   configures the engine up to haptics by itself, without Qt, SQLite and VTK to be
# found, and builds its lowest module. Its other sources are those that every test is built from; that they include nothing
# but Eigen and the standard library is what check_layers.sh holds.
set -eu
source=$1 work=$2/components compiler=$3
rm -rf "$work"
cmake -S "$source" -B "$work" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Debug -DPALPATE_COMPONENTS=haptics \
    -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON -DCMAKE_DISABLE_FIND_PACKAGE_SQLite3=ON -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON
libraries=$(ninja -C "$work" -t targets all | sed -n 's/.*libpalpate_\([a-z]*\)\.a:.*/\1/p' | LC_ALL=C sort -u | tr '\n' ' ')
[[ $libraries == "core geometry haptics " ]] || { echo "found the libraries $libraries, expected core geometry haptics"; exit 1; }
! grep -i -E 'qt6|sqlite|vtk' "$work/compile_commands.json" || { echo "expected none of these on a compiler's command"; exit 1; }
cmake --build "$work" --target palpate_core

if cmake -S "$source" -B "$work/unknown" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DPALPATE_COMPONENTS=haptic >"$work/unknown.log" 2>&1; then
    echo "expected an unknown component to be refused"
    exit 1
fi
grep 'found "haptic", expected' "$work/unknown.log"
