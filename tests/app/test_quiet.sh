#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_quiet.sh PALPATE SOURCES WORK commands|window   What goes well says nothing on stderr, neither by itself nor by its
# libraries, in an environment with nothing in it: no XDG_RUNTIME_DIR, no locale, no session bus.
set -euo pipefail
palpate=$1 phantom=$2/data/phantom work=$3 what=$4
rm -rf "$work" && mkdir -p "$work/home" && cd "$work"

# run [NAME=VALUE …] ARGUMENT…: runs palpate; anything on stderr fails the test.
failed=0
run() {
    local variables=()
    while [[ $1 == *=* ]]; do
        variables+=("$1")
        shift
    done
    local code=0
    env -i PATH="$PATH" HOME="$work/home" ${DISPLAY:+DISPLAY="$DISPLAY"} ${XAUTHORITY:+XAUTHORITY="$XAUTHORITY"} \
        ${variables[@]+"${variables[@]}"} "$palpate" "$@" >out.txt 2>error.txt || code=$?
    if [[ $code -ne 0 || -s error.txt ]]; then
        echo "${variables[*]-} palpate $*: exit code $code, on stderr:"
        cat error.txt
        failed=1
    fi
}

printf 'x,y,z\n' >motion.csv
for z in 30 20 10 0 -10; do printf '%s,-150,20\n' "$z" >>motion.csv; done

if [[ $what == commands ]]; then
    unset DISPLAY
    run --version
    run --help
    run devices
    run info "$phantom/liver.stl"
    run info "$phantom/phantom.palpate.json" --json
    run replay "$phantom/phantom.palpate.json" --motion motion.csv --out ticks.csv --json summary.json --record a.palpate
    run replay "$phantom/phantom.palpate.json" --motion "$phantom/palpation.palpate"
    run replay "$phantom/liver.stl" --motion motion.csv --live
    run session info a.palpate
    run session verify a.palpate
    run session measure "$phantom/palpation.palpate" --json measures.json
    run session export "$phantom/palpation.palpate" --csv e.csv --vtp e.vtp
    run session recover a.palpate --out copy.palpate
else
    if [[ -z ${DISPLAY:-} ]]; then
        echo "no display: the window was not tried"
        exit 77
    fi
    run "$phantom/phantom.palpate.json" --screenshot a.png
    run LC_ALL=C "$phantom/phantom.palpate.json" "$phantom/palpation.palpate" --screenshot b.png --dark
    mkdir -m 755 open
    run XDG_RUNTIME_DIR="$work/open" "$phantom/liver.stl" --screenshot c.png # anyone could look into it
    run XDG_RUNTIME_DIR="$work/none" --screenshot d.png
    [[ -s a.png && -s b.png && -s c.png && -s d.png ]] || failed=1

    # Settings that are no regular file are neither written through nor waited for, and the reason is printed.
    mkdir link pipe
    echo precious >target
    ln -s "$work/target" link/Palpate.conf
    mkfifo pipe/Palpate.conf
    for kind in link pipe; do
        timeout 60 env XDG_CONFIG_HOME="$work/$kind" "$palpate" "$phantom/liver.stl" --screenshot "$kind.png" >out.txt 2>error.txt &&
            [[ -s $kind.png ]] && grep -q "$kind/Palpate.conf: found a link, pipe or other special file" error.txt ||
            { echo "settings that are a $kind:"; cat error.txt; failed=1; }
    done
    [[ $(cat target) == precious ]] || { echo "the target of the link was changed"; failed=1; }
fi
exit $failed
