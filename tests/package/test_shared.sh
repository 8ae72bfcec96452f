#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_shared.sh SOURCE WORK COMPILER   has host programs take in all components as the three shared libraries, without
# optimisation, then installs these and builds and runs programs with the engine, VTK and Qt against them.
set -eu
source=$1 work=$2/shared compiler=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
rm -rf "$work"
cmake -S "$here/host" -B "$work/host" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=40 \
    -DPALPATE_SOURCES="$source" -DPALPATE_COMPONENTS=ui -DBUILD_SHARED_LIBS=ON -DPALPATE_INSTALL=ON
cmake --build "$work/host" -j 2
expect() { # TEXT COMMAND …
    local said
    said=$("${@:2}")
    [[ $said == "$1" ]] || { echo "${*:2}: found \"$said\", expected \"$1\""; exit 1; }
}
expect "force 0 0 1 N" "$work/host/host"
read -ra run <<<"${PALPATE_RUN:-}" # e.g. xvfb-run for a window
expect "OpenGL, CPU 3" "${run[@]}" "$work/host/window"

cmake --install "$work/host" --prefix "$work/prefix" >"$work/install.log"
[[ -f $work/prefix/share/palpate/LICENSE && -f $work/prefix/share/palpate/docs/embedding.md && -d $work/prefix/share/palpate/examples ]]
number=$("$work/host/version" | sed 's/ .*//')
for name in engine vtk qt; do
    library=$(find "$work/prefix" -name "libpalpate-$name.so")
    [[ $(readlink -f "$library") == *.so.$number ]]
    objdump -p "$library" | grep -q "SONAME *libpalpate-$name.so.${number%.*}\$"
done
library=$(find "$work/prefix" -name 'libpalpate-engine.so')
others=$(nm -D --defined-only --demangle "$library" | sed 's/^[^ ]* . //' |
    grep -v -E '^((typeinfo|typeinfo name|vtable|guard variable) for )?palpate::[a-z]+::[^(]|^PALPATE_[0-9.]+|(^| )(std|Eigen|__gnu_cxx|Q[A-Za-z]+)::' || true)
hidden=$(nm -D --defined-only --demangle "$library" | grep 'palpate::haptics::internal' || true)
[[ -z $others$hidden ]] || { echo "expected the shared library to export public functions alone, found $others$hidden"; exit 1; }

"$here/test_variants.sh" "$work/prefix" "$work/variants" cxx20 cxx23 no_exceptions
"$here/test_pc.sh" "$work/prefix" "$work/pc"
"$here/test_example.sh" "$source/resources/examples/touch_polydata" "$work" "$compiler" "organ: .*stiffness 1\.0 to 1\.[0-9] .*points"
"$here/test_example.sh" "$source/resources/examples/touch_window" "$work" "$compiler" "[0-9.]+ N, [0-9.]+ mm" show
