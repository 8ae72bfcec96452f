#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_variants.sh PREFIX WORK   builds and runs variants/ against the package installed in PREFIX, with each of g++ and
# clang++ that is there, and main.cpp with what pkg-config says.
set -eu
prefix=$1 work=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
libraries=$(dirname "$(find "$prefix" -name 'libpalpate*' -print -quit)")
rm -rf "$work"
mkdir -p "$work"

# $@: a program built from consumer/main.cpp
expect_force() {
    local said
    said=$("$@")
    [[ $said == "force 0 0 1 N" ]] || { echo "$*: found \"$said\", expected \"force 0 0 1 N\""; exit 1; }
}

for compiler in g++ clang++; do
    command -v "$compiler" >/dev/null || { echo "no $compiler here: its variants are not built"; continue; }
    cmake -S "$here/variants" -B "$work/$compiler" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$prefix" \
        -DCMAKE_BUILD_TYPE=Debug -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON -DCMAKE_DISABLE_FIND_PACKAGE_SQLite3=ON \
        -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON
    cmake --build "$work/$compiler"
    for variant in cxx20 cxx23 native no_exceptions; do
        expect_force "$work/$compiler/$variant"
    done
    # Except for functions with target_clones, which GCC 12 does not hide.
    exported=$(nm -D --defined-only --demangle "$work/$compiler/extension.so" | grep palpate:: |
        grep -v '[iW] palpate::haptics::internal::' || true)
    # Inline functions of exported classes are the shared libraries' interface.
    if [[ -n $exported && ! -e $libraries/libpalpate-engine.so ]]; then
        echo "expected an extension to export nothing of Palpate, found:"
        echo "$exported"
        exit 1
    fi
done

command -v pkg-config >/dev/null || { echo "no pkg-config here: the .pc files are not tried"; exit 0; }
export PKG_CONFIG_PATH=$libraries/pkgconfig
read -r -a flags < <(pkg-config --cflags --libs palpate-haptics)
g++ -std=c++20 "$here/consumer/main.cpp" -o "$work/pc" "${flags[@]}"
LD_LIBRARY_PATH=$libraries expect_force "$work/pc"
