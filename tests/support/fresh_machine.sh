#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# tests/support/fresh_machine.sh bookworm|trixie [DIR [COMMAND]]   the README's two commands on a bare Debian 12 or 13.
#
# Installs that Debian, no more than its smallest set of packages, into DIR (without one, a temporary folder that is
# removed at the end), copies this checkout to DIR/palpate as it is on disk, without what git ignores, and runs COMMAND
# there in a chroot: without one, `app/run.sh && tests/run.sh`. A DIR that holds such a system already is used again, and
# what was built there with it. Needs root, debootstrap and some 8 GB. Packages come from where this machine's apt has
# them; PALPATE_MIRROR=URL says otherwise. All mounts are in a namespace of their own and end with the script, however it
# ends. Exit code: the command's; 2 for a wrong command line.
set -u -o pipefail

say() { printf 'fresh_machine: %s\n' "$*" >&2; }
fail() {
    say "$1"
    exit "${2:-1}"
}

suite=${1:-}
case $suite in bookworm | trixie) ;; *) fail "found \"$suite\", expected bookworm or trixie" 2 ;; esac
[[ $# -le 3 ]] || fail "found $# arguments, expected at most 3: put the command in quotes" 2
[[ $(id -u) -eq 0 ]] || fail "needs root, to install packages and to mount" 2
command -v debootstrap >/dev/null || fail "needs debootstrap (apt-get install debootstrap)" 2

source_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
command=${3:-app/run.sh && tests/run.sh}
if [[ -z ${PALPATE_MOUNTS_ARE_OWN:-} ]]; then
    # Out here: the folder, and an end to all that runs inside. With its last process the namespace and its mounts go.
    inside=
    system=${2:-}
    [[ -n $system ]] || { system=$(mktemp -d) && chmod 755 "$system" && trap 'rm -rf --one-file-system "$system"' EXIT; } || exit 1
    trap '[[ -z $inside ]] || { kill -KILL "$inside"; wait "$inside"; }; exit 130' INT TERM HUP
    PALPATE_MOUNTS_ARE_OWN=1 unshare --mount --pid --fork --kill-child --mount-proc -- \
        "$BASH" "$0" "$suite" "$system" "$command" &
    inside=$!
    wait "$inside"
    exit $?
fi
unset PALPATE_MOUNTS_ARE_OWN

mkdir -p "$2" || exit 1
system=$(cd "$2" && pwd)
[[ $system != / ]] || fail "found / as the folder, expected one for a system of its own" 2

mirror=${PALPATE_MIRROR:-$(apt-get indextargets --format '$(REPO_URI) $(LABEL)' 'Created-By: Packages' |
    sed -n 's/ Debian$//p' | head -n 1)}
[[ -n $mirror ]] || fail "this machine's apt names no archive of Debian: set PALPATE_MIRROR=URL" 2

if [[ ! -f $system/.palpate-system ]]; then
    [[ -z $(ls -A "$system") ]] || fail "$system is not empty and not of this script: not touched" 2
    say "installing $suite into $system"
    debootstrap --variant=minbase "$suite" "$system" "$mirror" >&2 || fail "debootstrap failed, see above"
    # Reached as this machine reaches it.
    apt-config dump --format '%F "%v";%n' Acquire::http Acquire::https Acquire::Check-Valid-Until Acquire::Check-Date \
        >"$system/etc/apt/apt.conf.d/99-as-outside"
    printf '%s\n' "$suite" >"$system/.palpate-system"
fi
[[ $(cat "$system/.palpate-system") == "$suite" ]] ||
    fail "$system holds $(cat "$system/.palpate-system"), expected $suite" 2
cp -L /etc/resolv.conf /etc/hosts "$system/etc/"

mkdir -p "$system/palpate"
say "copying the checkout"
{
    # Where it is no checkout: all but what is built.
    git -C "$source_folder" ls-files -z --cached --others --exclude-standard 2>/dev/null ||
        (cd "$source_folder" && find . \( -path ./build -o -path ./out \) -prune -o -type f -print0)
} | (cd "$source_folder" && xargs -0 sh -c 'for f; do [ ! -e "$f" ] || printf "%s\0" "$f"; done' sh) |
    tar -C "$source_folder" --null --no-recursion --owner=0 --group=0 -T - -cf - | tar -C "$system/palpate" -xf - ||
    fail "the checkout could not be copied"

mount -t proc proc "$system/proc" && mount --rbind /dev "$system/dev" ||
    fail "proc and dev could not be mounted"
say "running: $command"
start=$SECONDS
# Nothing of this machine's environment but the way out to the net.
env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin ${http_proxy:+http_proxy="$http_proxy"} \
    ${https_proxy:+https_proxy="$https_proxy"} chroot "$system" bash -c "cd /palpate && $command"
code=$?
say "$suite: exit code $code after $((SECONDS - start)) s"
exit $code
