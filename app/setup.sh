# SPDX-License-Identifier: BSD-3-Clause
# Sourced by app/run.sh, tests/run.sh and .ci/run: prepares a Debian 12 or 13 machine and builds. All output, including
# output of the tools called, goes to stderr.

palpate_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# Preset of CMakePresets.json to build and run: `release` is fastest for a full build, `dev` for a changed file.
palpate_preset=${PALPATE_PRESET:-release}

palpate_build_packages=(g++ cmake ninja-build pkgconf libvtk9-dev qt6-base-dev qt6-l10n-tools qt6-multimedia-dev qt6-websockets-dev libqt6opengl6-dev libgl-dev libeigen3-dev libfontconfig-dev
    libhidapi-dev libsqlite3-dev libcli11-dev libgl1-mesa-dri xvfb xauth fonts-dejavu-core)

# Without any locale, Qt prints a warning to stderr and uses C.UTF-8.
[[ -n ${LC_ALL:-}${LC_CTYPE:-}${LANG:-} ]] || export LANG=C.UTF-8

say() { printf 'palpate: %s\n' "$*" >&2; }
fail() { say "$*"; exit 1; }

# ensure_packages PACKAGE…: installs missing packages.
ensure_packages() {
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "not a Debian system: expecting what these packages hold to be installed: $*"
        return
    fi
    local installed missing=() package as_root=()
    # Include packages provided by installed ones: Debian 13 has merged some of these packages into others.
    installed=" $(dpkg-query -W -f='${db:Status-Status}:${Package} ${Provides} \n' "$@" 2>/dev/null |
        sed -n 's/^installed://p' | tr ',\n' '  ')"
    for package in "$@"; do
        [[ $installed == *" $package "* ]] || missing+=("$package")
    done
    [[ ${#missing[@]} -eq 0 ]] && return
    if [[ $(id -u) -ne 0 ]]; then
        command -v sudo >/dev/null || fail "missing packages; neither root nor sudo is there to install them: ${missing[*]}"
        as_root=(sudo)
    fi
    say "installing ${missing[*]}"
    "${as_root[@]}" apt-get update -qq >&2 || fail "apt-get update failed, see above"
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
        -o Dpkg::Use-Pty=0 "${missing[@]}" >&2 || fail "apt-get install failed, see above"
}

# ensure_configured PRESET [CMAKE-ARGUMENT…]: configures once, and again after the checkout was moved or the system changed.
ensure_configured() {
    local preset=$1 folder="$palpate_root/build/$1" stamp
    shift
    stamp="$palpate_root $(sed -n 's/^PRETTY_NAME=//p' /etc/os-release 2>/dev/null) $*"
    if [[ -f $folder/build.ninja && $(cat "$folder/.configured-for" 2>/dev/null) == "$stamp" ]]; then
        return
    fi
    say "configuring build/$preset"
    rm -rf "$folder/CMakeCache.txt" "$folder/CMakeFiles" "$folder/build.ninja"
    (cd "$palpate_root" && cmake --preset "$preset" "$@") >&2 || fail "cmake --preset $preset failed, see above"
    printf '%s\n' "$stamp" >"$folder/.configured-for"
}

# build PRESET [TARGET…]: builds the targets, or everything, with at most 2 jobs.
build() {
    local preset=$1
    shift
    (
        # Lock: concurrent runs would build into the same folder.
        flock 9
        cd "$palpate_root/build/$preset" || exit 1
        # The first step, which looks up the commit, always runs. Print output only if other steps follow.
        ninja -j 2 "$@" 2>&1 9>&- | {
            read -r first
            while IFS= read -r line; do
                [[ -n $first ]] && say "building in build/$preset" && printf '%s\n' "$first" >&2
                first=
                printf '%s\n' "$line" >&2
            done
            [[ $first == *error* ]] && printf '%s\n' "$first" >&2
            true
        }
    ) 9>"$palpate_root/build/$preset/.lock" || fail "the build failed, see above"
}

# headless COMMAND…: runs the command on a virtual display. It starts anew when its last client leaves, and refuses the
# next one meanwhile, unless told not to.
headless() {
    xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" "$@"
}
