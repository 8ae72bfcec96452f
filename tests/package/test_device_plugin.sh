#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_device_plugin.sh PAGE WORK COMPILER   takes the example out of PAGE, builds it against the package installed below WORK
# and has the installed program load it, beside its own plugins.
set -eu
page=$1 work=$2 compiler=$3
rm -rf "$work/sway"
mkdir "$work/sway"
awk -v folder="$work/sway" '
    /^\*\*File `/ { name = $0; sub(/^[^`]*`/, "", name); sub(/`.*/, "", name); next }
    /^```/ { if (file) { close(file); file = ""; name = "" } else if (name) file = folder "/" name; next }
    file { print >file }
' "$page"
cmake -S "$work/sway" -B "$work/sway/build" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$work/prefix"
cmake --build "$work/sway/build"
# Nothing of this machine's own: no user's plugins.
said=$(XDG_DATA_HOME=$work/nothing "$work/prefix/bin/palpate" devices --plugin-path "$work/sway/build")
echo "$said"
for expected in "sway 1.0 (BSD-3-Clause)" "on the bus: Swaying hand" "$work/prefix/lib" "woodenhaptics 0" "spacemouse 0" "forcedimension 0" "haply 0" "openhaptics 0" "openigtlink 0"; do
    [[ $said == *"$expected"* ]] || { echo "missing: $expected"; exit 1; }
done
