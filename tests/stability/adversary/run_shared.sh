#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# run_shared.sh PROGRAM ARGUMENTS…   runs the adversary that lies beside the checkout. Exit code 1 when it found anything
# but what is named here.
set -u -o pipefail

said=$("$@" 2>&1)
code=$?
printf '%s\n' "$said"
[[ $code -le 1 && -n $said ]] || exit 1 # 2: it was not understood; more: it crashed

if [[ $2 == odd ]]; then
    # A HIP of 1e30 mm or more, and back in one tick: of such a move nothing is left of the scene's own digits, so that
    # what lies between can't be told. Required is that all stays finite. The servo's gate refuses such jumps, and a device
    # without motors, whose jumps are followed, has no such reach.
    ! grep -v -E '^WRONG r [01] HIP at [-+][0-9.]+e\+([3-9][0-9]|[0-9]{3}) on axis 0: finite 1; back in: g finite 1 ' \
        <<<"$said" | grep '^WRONG'
else
    # Its table has a line for each kind of fault. Ticks at the bound on work are faults to it; here they are counted,
    # must be fewer than one in 1,000 (single scenes of large balls have most), and may be on their way. One in 10,000 may
    # not be at rest: in the slot between two walls that coincide, and on a plate thinner than its own skin (god-object.md,
    # Limits). A HIP farther than HapticScene::reaches is refused: no force there, where it expects a spring of kilometres.
    # In a contact of several structures it expects the whole spring to have the stiffness of the stiffest. Each pushes by
    # itself (god-object.md, "Several structures in one contact"), which SharedJudge.h judges; here such a force is only
    # told from none.
    awk 'function triple(name, out,   text) { text = $0; sub(".* " name " ", "", text); split(text, out, " ") }
        function size(v) { return sqrt(v[1] * v[1] + v[2] * v[2] + v[3] * v[3]) }
        /^ticks / { ticks = $2 + 0 }
        /^  FOUND force wrong / {
            extent = $0; sub(/.* extent /, "", extent); triple("hip", hip); triple("g1", given)
            isRefused = size(given) == 0 && size(hip) > 4000 * extent
            isShared = size(given) > 0
            if (isRefused || isShared) explained++
        }
        / in [0-9]+ scenes, worst / {
            known = /^  limit, not at rest / || (/^  not at rest / && $4 * 10000 < ticks) || (/^  iteration limit / && $3 * 1000 < ticks) ||
                (/^  force wrong / && $7 == explained)
            if (!known) { print "not allowed:" $0; bad = 1 }
        }
        END { exit bad || ticks == 0 }' <<<"$said"
fi
