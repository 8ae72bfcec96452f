#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_package.sh BUILD WORK COMPILER   installs BUILD below WORK, then builds and runs consumer/ with find_package(Palpate).
set -eu
build=$1 work=$2 compiler=$3
rm -rf "$work/prefix" "$work/consumer"
cmake --install "$build" --prefix "$work/prefix" >"$work/install.log"
internal=$(find "$work/prefix" -name internal)
[[ -z $internal ]] || { echo "installed: $internal"; exit 1; }
"$(dirname "${BASH_SOURCE[0]}")/check_exports.pl" "$work/prefix"
cmake -S "$(dirname "${BASH_SOURCE[0]}")/consumer" -B "$work/consumer" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/prefix"
cmake --build "$work/consumer"
said=$("$work/consumer/consumer")
echo "$said"
# 2 mm into a triangle of 0.5 N/mm.
[ "$said" = "force 0 0 1 N" ]
# Layouts do not depend on the caller's flags.
"$work/consumer/layout" | tee "$work/layout.txt"
[[ $(tail -n 1 "$work/layout.txt") == "translation 1 2 3" ]]
if grep -q -w avx /proc/cpuinfo; then
    "$work/consumer/layout_avx" | diff "$work/layout.txt" -
else
    echo "this processor has no AVX: the caller with AVX was built, not run"
fi
# The programs find each other where they are installed.
program=$work/prefix/bin/palpate
[ ! -x "$program" ] || [[ $("$program" evaluate --help) == *--quick* ]]
