#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Counts the instructions that a tick executes (Palpator::step alone) in each row of bench_touch: the mean of 10,000
# ticks. The same build gives the same numbers, however busy the machine is. It takes some minutes: a tick runs about
# 50 times slower under callgrind.
#
#   tests/bench/count_instructions.sh BENCH_TOUCH [FILTER [TICKS]]
#
# BENCH_TOUCH is the program (cost.md tells how it is built), FILTER a regular expression for the rows' names.
# Printed: row, instructions a tick, hash of the answers.
set -eu
program=${1:?"usage: count_instructions.sh BENCH_TOUCH [FILTER [TICKS]]"}
filter=${2:-.}
ticks=${3:-10000}
command -v valgrind > /dev/null || { echo "count_instructions.sh: valgrind is not installed (Debian: valgrind)" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
PALPATE_BENCH_TICKS=$ticks valgrind --tool=callgrind --callgrind-out-file="$work/row" \
    --toggle-collect='palpate::haptics::Palpator::step*' --zero-before=beginRow --dump-before=endRow \
    "$program" --benchmark_filter="$filter" --benchmark_format=csv > "$work/rows.csv" 2> "$work/log" ||
    { cat "$work/log" >&2; exit 1; }
head=$(sed -n '/^name,/=' "$work/rows.csv")
[ -n "$head" ] || { echo "count_instructions.sh: no row's name matches '$filter'" >&2; exit 1; }
# One dump for each row, in the rows' order.
dump=0
column=$(sed -n "${head}p" "$work/rows.csv" | tr ',' '\n' | grep -n '"hash"' | cut -d: -f1)
tail -n "+$((head + 1))" "$work/rows.csv" | while IFS= read -r line; do
    dump=$((dump + 1))
    name=$(echo "$line" | cut -d, -f1 | tr -d '"' | sed 's,/iterations:.*,,')
    total=$(sed -n 's/^totals: //p' "$work/row.$dump")
    echo "$name $(awk "BEGIN { printf \"%.1f\", $total / $ticks }") $(echo "$line" | cut -d, -f"$column")"
done
