#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the motion of a hand for the pictures of motion.md as CSV: at a moment of the breath it presses the larger lump
of data/phantom/phantom-breathing.palpate.json, 8 mm deep with a ball of 8 mm.

    press_breathing.py 2.0 >inhaled.csv    # seconds: 2 is inhaled, 4 is exhaled
"""
import math
import sys

PLACE = (-51.9, -62.4, 11.7)  # the best place to press at rest [mm], from `palpate felt`
OUT = (-0.296, -0.906, 0.302)  # from the lump to that place
AMPLITUDE, STILL_Z, FULL_Z, PERIOD_S = (0.0, -3.0, -15.0), -56.0, 64.0, 4.0  # of the scene
RADIUS_MM, DEPTH_MM, AWAY_MM = 8.0, 8.0, 25.0

peak_s = float(sys.argv[1])
ramp = (PLACE[2] - STILL_Z) / (FULL_Z - STILL_Z)
share = ramp * ramp * (3.0 - 2.0 * ramp) * math.sin(math.pi * peak_s / PERIOD_S) ** 4
place = [p + share * a for p, a in zip(PLACE, AMPLITUDE)]
print("x,y,z")
for tick in range(round(1000 * (peak_s + 0.3))):
    t = tick * 1e-3 - peak_s  # in within the second before, out within 0.3 s
    way = max(0.0, 1.0 + t) if t <= 0.0 else 1.0 - t / 0.3
    depth = way * (AWAY_MM + DEPTH_MM) - AWAY_MM - RADIUS_MM
    print(",".join(f"{p - depth * n:.4f}" for p, n in zip(place, OUT)))
