#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_listing.sh PALPATE FOLDER SCENE WORK   the program lists an emulated device through the stand-in libHD.so in FOLDER, which the
# loader finds by each of its names; without it, the list is silent about the library, and choosing the device names it.
set -eu
palpate=$1 folder=$2 scene=$3 work=$4
rm -rf "$work"
mkdir -p "$work/touch/config"
echo 0.5 >"$work/touch/config/Default Device.config"
export XDG_CONFIG_HOME=$work HOME=$work PALPATE_STANDIN_HD=$work/bench GTDD_HOME=$work/touch

for soname in libHD.so.3.4 libHD.so.3.0 libHD.so; do
    mkdir "$work/$soname"
    cp "$folder/libHD.so.3.4" "$work/$soname/$soname"
    LD_LIBRARY_PATH=$work/$soname "$palpate" devices >"$work/with.txt"
    grep -F 'on the bus: Touch, Default Device (110-01)' "$work/with.txt"
done

"$palpate" devices >"$work/without.txt" 2>&1
grep -F 'openhaptics 0' "$work/without.txt"
if grep -F 'was not found' "$work/without.txt"; then
    exit 1
fi

awk 'BEGIN { print "x,y,z"; for (i = 0; i < 100; i++) print "0,0,500" }' >"$work/motion.csv"
if "$palpate" replay "$scene" --motion "$work/motion.csv" --live --device openhaptics --out "$work/ticks.csv" 2>"$work/error.txt"; then
    echo "touches with a device that is not there"
    exit 1
fi
grep -F 'libHD.so.3.4 was not found; install' "$work/error.txt"
