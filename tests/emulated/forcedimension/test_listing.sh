#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_listing.sh PALPATE FOLDER SCENE WORK STANDIN   the program lists an emulated device through the stand-in libdhd.so.3 in FOLDER, which the
# loader finds; without it, the list is silent about the library, and choosing the device names it.
set -eu
palpate=$1 folder=$2 scene=$3 work=$4 standin=$5
rm -rf "$work"
mkdir -p "$work"
export XDG_CONFIG_HOME=$work HOME=$work PALPATE_STANDIN_DHD=$work/bench
unset FDSDK

LD_LIBRARY_PATH=$folder "$palpate" devices >"$work/with.txt"
grep -F 'on the bus: emulated omega (1001)' "$work/with.txt"

"$palpate" devices >"$work/without.txt" 2>&1
grep -F 'forcedimension 0' "$work/without.txt"
if grep -F 'was not found' "$work/without.txt"; then
    exit 1
fi

awk 'BEGIN { print "x,y,z"; for (i = 0; i < 100; i++) print "0,0,500" }' >"$work/motion.csv"
if "$palpate" replay "$scene" --motion "$work/motion.csv" --live --device forcedimension --out "$work/ticks.csv" 2>"$work/error.txt"; then
    echo "touches with a device that is not there"
    exit 1
fi
grep -F 'libdhd.so.3 was not found; install' "$work/error.txt"

# Tests the emulated device in virtual time, and refuses others.
(
    export LD_LIBRARY_PATH=$folder LD_PRELOAD=$standin PALPATE_STANDIN_VIRTUAL=1
    "$palpate" devices --check forcedimension --out "$work/check" >"$work/check.txt"
)
grep -F 'Held stiffness, with the controller: ' "$work/check.txt"
grep -F 'compare with: palpate stability --device omega --rate 1000 --delay' "$work/check.txt"
grep -F '</html>' "$work/check/selftest.html" >/dev/null
grep -F '"complete": true' "$work/check/selftest.json"
status=0
"$palpate" devices --check nothing --out "$work/none" 2>"$work/error.txt" || status=$?
test "$status" -eq 2
grep -F -- '--check: found "nothing", expected one of simulated, ' "$work/error.txt"
test ! -e "$work/none"
