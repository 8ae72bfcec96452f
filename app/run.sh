#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# app/run.sh ARGS…   installs missing packages, builds, runs `palpate ARGS…` and returns its exit code.
#
# Without arguments, opens the bundled phantom and plays the recording. Without a display, commands that open the window
# render off-screen and write out/palpate.png and out/summary.txt.
set -u -o pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

ensure_packages "${palpate_build_packages[@]}"
ensure_configured "$palpate_preset"
targets=(palpate_app palpate_plugin_woodenhaptics palpate_plugin_spacemouse palpate_plugin_forcedimension
    palpate_plugin_haply palpate_plugin_openhaptics palpate_plugin_openigtlink)
case ${1:-} in
    evaluate | stability) targets+=(palpate_evaluation_app) ;;
esac
build "$palpate_preset" "${targets[@]}"

palpate=$palpate_root/build/$palpate_preset/bin/palpate
phantom=$palpate_root/data/phantom

case ${1:-} in
    devices | evaluate | felt | findings | info | replay | session | stability | thumbnail | -h | --help | --version) exec "$palpate" "$@" ;;
esac
[[ $# -gt 0 ]] || set -- "$phantom/phantom.palpate.json" "$phantom/palpation.palpate"
[[ -z ${DISPLAY:-} ]] || exec "$palpate" "$@"
if [[ " $*" == *" --screenshot"* ]]; then
    headless "$palpate" "$@"
    exit $?
fi

out=$palpate_root/out
mkdir -p "$out"
rm -f "$out/palpate.png" "$out/summary.txt"
say "no display: drawing off-screen"
headless "$palpate" "$@" --screenshot "$out/palpate.png" >"$out/summary.txt" || exit $?
if [[ $1 == "$phantom/phantom.palpate.json" && ${2:-} == "$phantom/palpation.palpate" ]]; then
    "$palpate" session measure "$2" >>"$out/summary.txt" || exit $?
fi
cat "$out/summary.txt"
say "picture: $out/palpate.png"
say "summary: $out/summary.txt"
