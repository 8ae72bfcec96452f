#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_components.sh SOURCE WORK COMPILER   has a host program take in the sources up to haptics, without Qt, SQLite and VTK to
# be found: as static libraries, of which it builds the lowest, since every test is built from the others, and as a shared
# library, which is then installed and used from there.
set -eu
source=$1 work=$2/components compiler=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
rm -rf "$work"
configure() { # FOLDER [CMAKE-ARGUMENT …]
    cmake -S "$here/host" -B "$work/$1" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Debug \
        -DPALPATE_SOURCES="$source" -DPALPATE_COMPONENTS=haptics -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON \
        -DCMAKE_DISABLE_FIND_PACKAGE_SQLite3=ON -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON "${@:2}"
}

configure static
libraries=$(ninja -C "$work/static" -t targets all | sed -n 's/.*libpalpate_\([a-z]*\)\.a:.*/\1/p' | LC_ALL=C sort -u | tr '\n' ' ')
[[ $libraries == "core geometry haptics " ]] || { echo "found the libraries $libraries, expected core geometry haptics"; exit 1; }
! grep -i -E 'qt6|sqlite|vtk' "$work/static/compile_commands.json" || { echo "expected none of these on a compiler's command"; exit 1; }
cmake --build "$work/static" --target version
[[ $("$work/static/version") == [0-9]*.[0-9]*.[0-9]*" 0.25" ]]
# A subproject installs nothing, unless it is told to.
cmake --install "$work/static" --prefix "$work/nothing"
[[ ! -e $work/nothing ]] || { echo "expected nothing to be installed, found $(find "$work/nothing" -type f)"; exit 1; }

configure shared -DBUILD_SHARED_LIBS=ON -DPALPATE_INSTALL=ON
cmake --build "$work/shared"
[[ $("$work/shared/host") == "force 0 0 1 N" ]]
cmake --install "$work/shared" --prefix "$work/prefix" >"$work/install.log"
number=$("$work/shared/version" | sed 's/ .*//')
library=$(find "$work/prefix" -name 'libpalpate-engine.so')
[[ $(readlink -f "$library") == *.so.$number ]]
objdump -p "$library" | grep -q "SONAME *libpalpate-engine.so.${number%.*}\$"
others=$(nm -D --defined-only --demangle "$library" | sed 's/^[^ ]* . //' |
    grep -v -E '^((typeinfo|typeinfo name|vtable|guard variable) for )?palpate::[a-z]+::[^(]|^PALPATE_[0-9.]+|(^| )(std|Eigen|__gnu_cxx)::' || true)
hidden=$(nm -D --defined-only --demangle "$library" | grep 'palpate::haptics::internal' || true)
[[ -z $others$hidden ]] || { echo "expected the shared library to export public functions alone, found $others$hidden"; exit 1; }
[[ -f $work/prefix/share/palpate/LICENSE && -f $work/prefix/share/palpate/docs/embedding.md && -d $work/prefix/share/palpate/examples ]]
"$here/test_variants.sh" "$work/prefix" "$work/variants"

if cmake -S "$source" -B "$work/unknown" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DPALPATE_COMPONENTS=haptic >"$work/unknown.log" 2>&1; then
    echo "expected an unknown component to be refused"
    exit 1
fi
grep 'found "haptic", expected' "$work/unknown.log"
