#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_variants.sh PREFIX WORK VARIANT …   builds and runs these of variants/ against the package installed in PREFIX, with
# each of g++ and clang++ that is there.
set -eu
prefix=$1 work=$2
shift 2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
libraries=$(dirname "$(find "$prefix" -name 'libpalpate*' -print -quit)")
rm -rf "$work"
mkdir -p "$work"

for compiler in g++ clang++; do
    command -v "$compiler" >/dev/null || { echo "no $compiler here: its variants are not built"; continue; }
    cmake -S "$here/variants" -B "$work/$compiler" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$prefix" \
        -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON -DCMAKE_DISABLE_FIND_PACKAGE_SQLite3=ON -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON
    cmake --build "$work/$compiler" --target "$@" "${@/%/_extension}"
    for variant in "$@"; do
        said=$("$work/$compiler/$variant")
        [[ $said == "force 0 0 1 N" ]] || { echo "$compiler, $variant: found \"$said\", expected \"force 0 0 1 N\""; exit 1; }
        # Except for functions with target_clones, which GCC 12 does not hide.
        exported=$(nm -D --defined-only --demangle "$work/$compiler/lib${variant}_extension.so" | grep palpate:: |
            grep -v '[iW] palpate::haptics::internal::' || true)
        # Inline functions of exported classes are the shared libraries' interface.
        if [[ -n $exported && ! -e $libraries/libpalpate-engine.so ]]; then
            echo "expected an extension to export nothing of Palpate, found:"
            echo "$exported"
            exit 1
        fi
    done
done
