#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_components.sh SOURCE WORK COMPILER   has a host program take in the sources up to haptics, without Qt, SQLite and VTK to
# be found, and builds the lowest library, since every test is built from the others. What a shared build makes of them
# is left to test_shared.sh.
set -eu
source=$1 work=$2/components compiler=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
rm -rf "$work"
configure() { # FOLDER [CMAKE-ARGUMENT …]
    cmake -S "$here/host" -B "$work/$1" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Debug \
        -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=40 \
        -DPALPATE_SOURCES="$source" -DPALPATE_COMPONENTS=haptics -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON \
        -DCMAKE_DISABLE_FIND_PACKAGE_SQLite3=ON -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON "${@:2}"
}
expect_libraries() { # FOLDER SUFFIX EXPECTED
    local found
    found=$(ninja -C "$work/$1" -t targets all | sed -n "s/.*libpalpate\([a-z_-]*\)\.$2:.*/\1/p" | LC_ALL=C sort -u | tr '\n' ' ')
    [[ $found == "$3" ]] || { echo "$1: found the libraries $found, expected $3"; exit 1; }
    ! grep -i -E 'qt6|sqlite|vtk' "$work/$1/compile_commands.json" || { echo "expected none of these on a compiler's command"; exit 1; }
}

configure shared -DBUILD_SHARED_LIBS=ON
expect_libraries shared so "-engine "
configure static
expect_libraries static a "_core _geometry _haptics "
cmake --build "$work/static" --target version
[[ $("$work/static/version") == [0-9]*.[0-9]*.[0-9]*" 0.25" ]]
# A subproject installs nothing, unless it is told to.
cmake --install "$work/static" --prefix "$work/nothing"
[[ ! -e $work/nothing ]] || { echo "expected nothing to be installed, found $(find "$work/nothing" -type f)"; exit 1; }

if cmake -S "$source" -B "$work/unknown" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DPALPATE_COMPONENTS=haptic >"$work/unknown.log" 2>&1; then
    echo "expected an unknown component to be refused"
    exit 1
fi
grep 'found "haptic", expected' "$work/unknown.log"
