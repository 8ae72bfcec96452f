# SPDX-License-Identifier: BSD-3-Clause
"""Palpate: feel segmented surfaces from Python.

Lengths are in mm, forces in N, times in s and coordinates LPS, unless a name says otherwise.

>>> surface = palpate.Surface(points, triangles)                 # (n, 3) and (m, 3) arrays
>>> scene = palpate.Scene([palpate.Structure(surface, name="liver", stiffness_N_per_mm=0.2)])
>>> ticks = palpate.replay(scene, hips)                          # (k, 3) positions at 1 kHz
>>> ticks["force_z"].max()
"""

from ._palpate import (
    Error,
    Palpator,
    Recording,
    Scene,
    Structure,
    Surface,
    Tick,
    __version__,
    compare,
    felt,
    load,
    replay,
)

__all__ = [
    "Error",
    "Palpator",
    "Recording",
    "Scene",
    "Structure",
    "Surface",
    "Tick",
    "compare",
    "felt",
    "load",
    "replay",
]
