#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# tests/run.sh [FILTER] [CTEST-ARGUMENTS…]   sets up and builds what is missing, then runs the tests off-screen.
#
# FILTER is a regular expression over test names, for example `geometry` or `haptics.GodObject`; what starts with a dash goes
# to ctest as it is. Exit code: ctest's.
set -u -o pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../app/setup.sh"

ensure_packages "${palpate_build_packages[@]}" locales # whose parts make a German one for a test
ensure_configured "$palpate_preset"
build "$palpate_preset"

"$palpate_root/tests/support/check_layers.sh" "$palpate_root" || exit 1

filter=(-LE nightly) # millions of ticks: tests/run.sh -L nightly
if [[ $# -gt 0 && $1 != -* ]]; then
    filter=(-R "$1")
    shift
elif [[ "$*" == *nightly* ]]; then
    filter=()
fi
headless ctest --test-dir "$palpate_root/build/$palpate_preset" --output-on-failure -j 3 "${filter[@]}" "$@"
