#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_example.sh EXAMPLE WORK COMPILER EXPECTED [ARGUMENT …] [-- CMAKE-ARGUMENT …]   builds the folder EXAMPLE against the package
# installed below WORK and runs it with the arguments: all that it says must match the regular expression EXPECTED.
set -eu
example=$1 work=$2 compiler=$3 expected=$4
shift 4
arguments=()
while [[ $# -gt 0 && $1 != -- ]]; do
    arguments+=("$1")
    shift
done
[[ $# -eq 0 ]] || shift
name=$(basename "$example")
rm -rf "${work:?}/$name"
cmake -S "$example" -B "$work/$name" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$work/prefix" "$@"
cmake --build "$work/$name"
rm -f "$work/example.palpate"* # of the last run: `record` never overwrites
read -ra run <<<"${PALPATE_RUN:-}" # e.g. xvfb-run for a window
said=$("${run[@]}" "$work/$name/$name" "${arguments[@]}")
echo "$said"
[[ $said =~ ^$expected$ ]] || { echo "expected: $expected"; exit 1; }
