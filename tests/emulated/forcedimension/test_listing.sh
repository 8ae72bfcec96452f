#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_listing.sh PALPATE FOLDER SCENE WORK   the program lists an emulated device through the stand-in libdhd.so.3 in FOLDER, which the
# loader finds; without it, the list is silent about the library, and choosing the device names it.
set -eu
palpate=$1 folder=$2 scene=$3 work=$4
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
