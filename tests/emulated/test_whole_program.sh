#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_whole_program.sh PALPATE STANDIN PHANTOM HAND WORK   the program feels the phantom's liver through the emulated arm, held by the
# hand of HAND.csv: replay --live, where the arm's millimetres are the scene's; and by that of HAND_fitted.csv: the window at 1, 2 and 4 kHz,
# where there is a display, which fits the scene to the arm.
set -eu
palpate=$1 standin=$2 phantom=$3 hand=$4 work=$5
mkdir -p "$work"
emulated() { env LD_PRELOAD="$standin" PALPATE_STANDIN_HAND="$hand.csv" XDG_CONFIG_HOME="$work" HOME="$work" "$@"; }

# Only its length counts: the hand is the emulated one.
awk 'BEGIN { print "x,y,z"; for (i = 0; i < 6000; i++) print "0,0,500" }' >"$work/motion.csv"
emulated "$palpate" replay "$phantom" --motion "$work/motion.csv" --live --device woodenhaptics --out "$work/ticks.csv" ||
    [ $? -eq 3 ] # on a machine too busy for a report every 5 ms the gate takes the force away, as it should
# Pressed, on the liver alone, by the spring's force, and never harder than the arm can.
awk -F, 'NR > 1 && $12 == "liver" {
        touched++
        depth = sqrt(($5 - $2)^2 + ($6 - $3)^2 + ($7 - $4)^2); force = sqrt($8^2 + $9^2 + $10^2)
        if (force - 0.2 * depth > 1e-9 || 0.2 * depth - force > 1e-9) wrong++
        if (force > most) most = force
    }
    END {
        printf "touched in %d ticks, at most %.2f N, %d off the spring\n", touched, most, wrong
        exit !(touched > 100 && most > 0.1 && most < 5.0 && !wrong)
    }' "$work/ticks.csv"

if [ -z "${DISPLAY:-}" ]; then
    echo "no display: the window was not tried"
    exit 77
fi
hand+=_fitted
mkdir -p "$work/Palpate"
for rate_kHz in 1 2 4; do
    printf '[devices]\nwoodenhaptics\\rate_kHz=%s\n' "$rate_kHz" >"$work/Palpate/Palpate screenshot.conf"
    for attempt in 1 2 3; do # for the same reason
        said=$(emulated "$palpate" "$phantom" --device woodenhaptics --screenshot "$work/window_$rate_kHz.png" || true)
        echo "$rate_kHz kHz: $said"
        [[ $said != *", in contact"* ]] || continue 2
    done
    exit 1
done
