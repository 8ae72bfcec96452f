#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# tests/package/debian_packages.sh [bookworm|trixie …]   builds the Debian packages in a system with the packages for
# building, then installs, runs and removes them in another one without: both of the named Debian, and new ones, unless
# PALPATE_SYSTEMS=DIR names a folder where they are kept for the next run, as DIR/SUITE-build and DIR/SUITE-fresh. The
# packages go to build/packages/SUITE. Needs root, debootstrap and some 10 GB (tests/support/fresh_machine.sh). Part of
# `.ci/run packages`. Exit code: 0 all held, 1 something did not, 2 wrong command line.
set -u -o pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
made=build/packages/packages

say() { printf 'debian_packages: %s\n' "$*" >&2; }
fail() {
    say "$*"
    exit 1
}
install() {
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends -o Dpkg::Use-Pty=0 "$@" >&2 ||
        fail "apt-get install $* failed"
}

# In the system for building.
build_packages() {
    source "$root/app/setup.sh"
    # dpkg-shlibdeps is in dpkg-dev; CPack asks `file` what is a binary.
    # shellcheck disable=SC2154 # of setup.sh
    ensure_packages "${palpate_build_packages[@]}" dpkg-dev file lintian
    [[ ! -d modules/python ]] || ensure_packages python3-dev pybind11-dev # for the component `python`
    ensure_configured packages
    build packages
    rm -rf "$made"
    (cd build/packages && cpack) >&2 || fail "cpack failed"
    ls "$made"/palpate_*.deb "$made"/libpalpate-dev_*.deb >/dev/null || fail "a package is missing in $made"
    # Tags of severity E; the address of the maintainer is a placeholder until whoever builds gives one.
    lintian --allow-root --fail-on error --suppress-tags bogus-mail-host "$made"/*.deb >&2 || fail "lintian found errors"
    say "built: $(ls "$made")"
}

# try COMMAND…: runs a command and ends the script if it fails.
try() {
    "$@" || fail "failed: $*"
}

# In the system without anything; the packages are in /packages.
try_packages() {
    local out listed name expected
    export HOME=/root LANG=C.UTF-8
    apt-get update -qq >&2 || fail "apt-get update failed"
    # What is needed to try them is installed first, so that the lists of files before and after differ by Palpate alone.
    install xvfb xauth libgl1-mesa-dri fonts-dejavu-core desktop-file-utils shared-mime-info libglib2.0-bin man-db hicolor-icon-theme \
        g++ cmake ninja-build
    find / -xdev -iname '*palpate*' -not -path '/palpate*' -not -path '/packages*' | sort >/tmp/before.txt

    install /packages/palpate_*.deb
    cd / || fail "no /"
    out=$(try palpate --version)
    say "$out"
    [[ $out == "palpate $(dpkg-query -W -f '${Version}' palpate) ("* ]] || fail "found \"$out\", expected the version of the package"
    out=$(try palpate devices)
    for name in woodenhaptics spacemouse forcedimension; do
        [[ $out == *"/usr/lib/"*"/palpate/plugins/"*"$name"* ]] || fail "palpate devices: found no $name in \"$out\""
        [[ -f /usr/lib/udev/rules.d/70-palpate-$name.rules ]] || fail "no rules of udev for $name"
    done
    try palpate info /usr/share/palpate/phantom/phantom.palpate.json >/dev/null
    out=$(try palpate session measure /usr/share/palpate/phantom/palpation.palpate) && [[ $out == *liver* ]] ||
        fail "palpate session measure: found \"$out\""
    out=$(try palpate evaluate --help) && [[ $out == *--quick* ]] || fail "palpate evaluate: found \"$out\""
    [[ -f /usr/share/palpate/docs/window.md ]] || fail "no documents"
    out=$(HOME=/tmp/user try xvfb-run -a palpate /usr/share/palpate/phantom/phantom.palpate.json --screenshot /tmp/window.png)
    say "$out"
    [[ $out == *"in contact"* && -s /tmp/window.png ]] || fail "the window: found \"$out\", expected a hand in contact"

    try desktop-file-validate /usr/share/applications/palpate.desktop
    try grep -q 'palpate.desktop' /usr/share/applications/mimeinfo.cache # written by a trigger of desktop-file-utils
    for expected in palpation.palpate=application/x-palpate-recording phantom.palpate.json=application/x-palpate-scene+json \
        liver.stl=model/stl; do
        name=/usr/share/palpate/phantom/${expected%=*}
        out=$(gio info -a standard::content-type "$name" | sed -n 's/ *standard::content-type: //p')
        [[ $out == "${expected#*=}" ]] || fail "$name: found the type $out, expected ${expected#*=}"
    done
    for name in palpate palpate-evaluation; do
        man -w $name >/dev/null || fail "no manual page of $name"
    done
    # In lines: the page of a narrow terminal breaks them.
    out=$(MANWIDTH=200 man palpate | grep -c -- '--screenshot') || fail "the manual page does not name --screenshot"
    for name in bash-completion/completions/palpate zsh/vendor-completions/_palpate metainfo/local.palpate.palpate.metainfo.xml \
        icons/hicolor/scalable/apps/palpate.svg icons/hicolor/48x48/apps/palpate.png doc/palpate/copyright; do
        [[ -f /usr/share/$name ]] || fail "no /usr/share/$name"
    done

    install /packages/libpalpate-dev_*.deb
    for name in touch_mesh record; do # haptics alone; the whole engine
        try cmake -S /palpate/resources/examples/$name -B /tmp/$name -G Ninja -DCMAKE_BUILD_TYPE=Release >&2
        try cmake --build /tmp/$name >&2
    done
    out=$(try /tmp/touch_mesh/touch_mesh) && [[ $out == *"force 0.000 0.000 1.000 N"* ]] || fail "touch_mesh: found \"$out\""

    listed="palpate libpalpate-dev"
    if ls /packages/python3-palpate_*.deb >/dev/null 2>&1; then
        install /packages/python3-palpate_*.deb
        try python3 -B -c 'import palpate'
        listed+=" python3-palpate"
    fi

    # shellcheck disable=SC2086
    DEBIAN_FRONTEND=noninteractive apt-get purge -y -qq -o Dpkg::Use-Pty=0 $listed >&2 || fail "the packages could not be removed"
    rm -rf /tmp/touch_mesh /tmp/record /tmp/user
    find / -xdev -iname '*palpate*' -not -path '/palpate*' -not -path '/packages*' | sort >/tmp/after.txt
    diff /tmp/before.txt /tmp/after.txt >&2 || fail "left behind, see above"
    ! grep -rq palpate /usr/share/applications/mimeinfo.cache /usr/share/mime/types || fail "the databases of types still name palpate"
    say "installed, run, removed"
}

case ${1:-} in
--build) build_packages && exit 0 || exit 1 ;;
--try) try_packages && exit 0 || exit 1 ;;
esac

[[ $# -gt 0 ]] || set -- bookworm trixie
systems=${PALPATE_SYSTEMS:-}
if [[ -z $systems ]]; then
    systems=$(mktemp -d) && chmod 755 "$systems" || exit 1
    trap 'rm -rf --one-file-system "$systems"' EXIT
fi
# The systems get the sources without .git: the build id names the commit all the same.
commit=$(git -C "$root" describe --always --dirty --abbrev=12 2>/dev/null)
for suite in "$@"; do
    case $suite in bookworm | trixie) ;; *)
        say "found \"$suite\", expected bookworm or trixie"
        exit 2
        ;;
    esac
    builder=$systems/$suite-build fresh=$systems/$suite-fresh
    "$root/tests/support/fresh_machine.sh" "$suite" "$builder" "PALPATE_COMMIT=$commit tests/package/debian_packages.sh --build" ||
        fail "$suite: the packages were not built"
    rm -rf "$root/build/packages/$suite" && mkdir -p "$root/build/packages/$suite" &&
        cp "$builder/palpate/$made"/*.deb "$root/build/packages/$suite/" || fail "$suite: the packages could not be copied"
    # A system that is used again has nothing of Palpate: the last run removed it, or it is made anew.
    rm -rf --one-file-system "$fresh"
    "$root/tests/support/fresh_machine.sh" "$suite" "$fresh" true || fail "$suite: no new system"
    mkdir -p "$fresh/packages" && cp "$root/build/packages/$suite"/*.deb "$fresh/packages/" || exit 1
    "$root/tests/support/fresh_machine.sh" "$suite" "$fresh" 'tests/package/debian_packages.sh --try' ||
        fail "$suite: the packages do not work"
    say "$suite: done, the packages are in build/packages/$suite"
done
