# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the Python package; test_python.sh runs them."""

import ast
import csv
import functools
import gc
import inspect
import json
import os
import pathlib
import re
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings

import numpy as np
import palpate

SOURCES = pathlib.Path(os.environ["PALPATE_SOURCES"])
PROGRAM = os.environ["PALPATE_PROGRAM"]
PHANTOM = SOURCES / "data" / "phantom"
SCENE = PHANTOM / "phantom.palpate.json"
SESSION = PHANTOM / "palpation.palpate"


def sphere(radius=20.0, rings=24, segments=36):
    """Return points and triangles of a closed sphere."""
    polar = np.linspace(0, np.pi, rings + 1)[1:-1]
    around = np.arange(segments) * 2 * np.pi / segments
    sin, cos = np.sin(polar)[:, None], np.cos(polar)[:, None]
    belts = np.stack([sin * np.cos(around), sin * np.sin(around), cos * np.ones_like(around)], axis=-1)
    points = np.concatenate([[[0, 0, 1]], belts.reshape(-1, 3), [[0, 0, -1]]]) * radius
    corner = np.arange((rings - 1) * segments).reshape(rings - 1, segments) + 1
    a, b = corner[:-1], np.roll(corner, -1, axis=1)[:-1]
    c, d = corner[1:], np.roll(corner, -1, axis=1)[1:]
    last = len(points) - 1
    caps = [np.stack([np.zeros(segments), corner[0], np.roll(corner[0], -1)], axis=-1),
            np.stack([np.full(segments, last), np.roll(corner[-1], -1), corner[-1]], axis=-1)]
    faces = [np.stack([a, c, b], axis=-1).reshape(-1, 3), np.stack([b, c, d], axis=-1).reshape(-1, 3)]
    return points, np.concatenate(caps[:1] + faces + caps[1:]).astype(np.int64)


def write_off(path, points, triangles):
    """Write a mesh with numbers that read back bit for bit."""
    with open(path, "w", encoding="ascii") as file:
        file.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
        file.writelines("%.17g %.17g %.17g\n" % tuple(p) for p in points)
        file.writelines("3 %d %d %d\n" % tuple(t) for t in triangles)


def write_motion(path, hips):
    with open(path, "w", encoding="ascii") as file:
        file.write("x,y,z\n")
        file.writelines("%.17g,%.17g,%.17g\n" % tuple(p) for p in hips)


def run_palpate(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True, text=True).stdout


@functools.lru_cache(maxsize=None)
def phantom():
    """Return the bundled scene; scenes are immutable."""
    return palpate.load(SCENE)


@functools.lru_cache(maxsize=None)
def small_folder():
    """Return a folder with the file names of the bundled phantom, a sphere as its scene and a recording of a second.

    Measures take seconds for the surfaces of the phantom."""
    folder = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(folder.cleanup)
    path = pathlib.Path(folder.name)
    write_off(path / "ball.off", *sphere())
    scene = {"version": 1, "structures": [{"mesh": "ball.off", "name": "ball", "stiffness_N_per_mm": 0.3}]}
    (path / "phantom.palpate.json").write_text(json.dumps(scene), encoding="utf-8")
    t = np.linspace(0, 1, 1000)
    write_motion(path / "motion.csv", np.stack([4 * np.sin(5 * t), 8 * np.sin(np.pi * t) - 24, 2 * t], axis=-1))
    run_palpate("replay", path / "phantom.palpate.json", "--motion", path / "motion.csv", "--record",
                path / "palpation.palpate")
    return path


@functools.lru_cache(maxsize=None)
def small_measures():
    return json.loads(run_palpate("session", "measure", small_folder() / "palpation.palpate", "--json", "-"))


def stroke(ticks=1500, radius=20.0):
    """Return a path that presses into the sphere, slides over it and leaves."""
    t = np.linspace(0, 1, ticks)
    angle = 2.5 * np.pi * t
    distance = radius + 4 - 9 * np.sin(np.pi * t)
    return np.stack([distance * np.sin(angle), 3 * np.sin(3 * angle), distance * np.cos(angle)], axis=-1)


def scene_of_sphere(**options):
    return palpate.Scene([palpate.Structure(palpate.Surface(*sphere()), name="ball", **options)])


class InFolder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext_(tempfile.TemporaryDirectory()))

    def enterContext_(self, manager):  # unittest's own needs Python 3.11
        value = manager.__enter__()
        self.addCleanup(manager.__exit__, None, None, None)
        return value


class Bits(InFolder):
    """The values are those of `palpate replay`, bit for bit."""

    def rows_of(self, ticks):
        rows = [list(ticks.dtype.names)]
        for item in ticks:
            rows.append(["%.17g" % cell if isinstance(cell, np.floating) else str(cell) for cell in item])
        return rows

    @staticmethod
    def without_times(rows):
        at = rows[0].index("solve_ns")
        return [row[:at] + row[at + 1:] for row in rows]

    def check(self, scene, hips, *arguments):
        write_motion(self.folder / "motion.csv", hips)
        out = self.folder / "ticks.csv"
        run_palpate("replay", *arguments, "--motion", self.folder / "motion.csv", "--out", out)
        ticks = palpate.replay(scene, hips)
        with open(out, newline="", encoding="utf-8") as file:
            expected = self.without_times(list(csv.reader(file)))
        self.assertEqual(self.without_times(self.rows_of(ticks)), expected)
        return ticks

    def test_surface_from_arrays(self):
        points, triangles = sphere()
        points = points + [0.1, 0.2, 0.3]
        write_off(self.folder / "ball.off", points, triangles)
        scene = palpate.Scene([palpate.Structure(palpate.Surface(points, triangles), name="ball")])
        ticks = self.check(scene, stroke(), self.folder / "ball.off")
        self.assertGreater((ticks["constraints"] > 0).sum(), 1000)
        for radius, stiffness in ((0.0, 0.7), (3.0, 0.3)):
            other = scene.with_radius(radius).with_tissue(stiffness_N_per_mm=stiffness, damping_Ns_per_mm=0.002)
            self.check(other, stroke(300), self.folder / "ball.off", "--radius", radius, "--stiffness", stiffness,
                       "--damping", 0.002)

    def test_phantom_with_transmitted_lumps(self):
        hips = palpate.Recording(SESSION).hips()[6000:9000]
        ticks = self.check(phantom(), hips, SCENE)
        self.assertIn("liver", set(ticks["structure"]))

    def test_layers_friction_and_names(self):
        """Two layers, friction, and a name with what CSV and the list of layers must encode."""
        points, triangles = sphere()
        write_off(self.folder / "a.off", points, triangles)
        write_off(self.folder / "b.off", points * 0.85, triangles)
        structures = [{"mesh": "a.off", "name": 'Öl, "dick"; a=b', "stiffness_N_per_mm": 0.2, "layer": 0,
                       "friction": {"static": 0.4, "dynamic": 0.3}},
                      {"mesh": "b.off", "name": "kern", "stiffness_N_per_mm": 0.9, "layer": 1}]
        path = self.folder / "two.palpate.json"
        path.write_text(json.dumps({"version": 1, "structures": structures}), encoding="utf-8")
        ticks = self.check(palpate.load(path), stroke(800), path)
        self.assertIn("1", ticks["slides"])
        self.assertTrue(any(";kern=" in text for text in ticks["layers"]))
        self.assertTrue(any(text.startswith("Öl%2C %22dick%22%3B a%3Db=") for text in ticks["layers"]))

    def test_steps_equal_replay(self):
        for options in ({}, {"damping_Ns_per_mm": 0.003}, {"friction_static": 0.5, "friction_dynamic": 0.4}):
            scene, hips = scene_of_sphere(**options).with_radius(1.5), stroke(400)
            ticks = palpate.replay(scene, hips, 0.002)
            palpator = palpate.Palpator(scene)
            for _ in range(2):  # after reset() as new
                for i, hip in enumerate(hips):
                    tick = palpator.step(hip, 0.002)
                    item = ticks[i]
                    self.assertEqual(tick.tick, item["tick"])
                    for name, value in (("hip", tick.hip), ("god", tick.god), ("force", tick.force),
                                        ("normal", tick.normal)):
                        expected = np.array([item[f"{name}_{axis}"] for axis in "xyz"])
                        self.assertEqual(value.tobytes(), expected.tobytes())
                    self.assertEqual(tick.structure, item["structure"])
                    self.assertEqual({None: "", True: "1", False: "0"}[tick.slides], item["slides"])
                palpator.reset()

    def test_breathing_phantom(self):
        """The time of moving tissue is that of the tick."""
        scene = palpate.load(PHANTOM / "phantom-breathing.palpate.json")
        hips = palpate.Recording(SESSION).hips()[6000:7500]
        forces = palpate.replay(scene, hips)["force_y"]
        palpator = palpate.Palpator(scene)
        self.assertEqual(np.array([palpator.step(hip).force[1] for hip in hips]).tobytes(), forces.tobytes())
        self.assertGreater(np.abs(forces - palpate.replay(phantom(), hips)["force_y"]).max(), 0.01)


class Arrays(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = sphere()

    def check_same(self, points, triangles):
        surface = palpate.Surface(points, triangles)
        expected = palpate.Surface(self.points, self.triangles)
        np.testing.assert_array_equal(surface.points, expected.points)
        np.testing.assert_array_equal(surface.triangles, expected.triangles)

    def test_any_memory_order_byte_order_and_type(self):
        wide = np.zeros((len(self.points), 6))
        wide[:, ::2] = self.points
        self.check_same(wide[:, ::2], self.triangles)
        self.check_same(np.asfortranarray(self.points), np.asfortranarray(self.triangles.astype(np.uint32)))
        self.check_same(self.points[::-1][::-1], self.triangles[::-1][::-1].astype(np.int32))
        self.check_same(self.points.astype(">f8"), self.triangles.astype(">i4"))
        self.check_same(self.points.tolist(), self.triangles.tolist())
        single = palpate.Surface(self.points.astype(np.float32), self.triangles.astype(np.uint64))
        np.testing.assert_array_equal(single.points.astype(np.float32), palpate.Surface(
            self.points.astype(np.float32).astype(np.float64), self.triangles).points.astype(np.float32))
        hips = stroke(50)
        scene = scene_of_sphere()
        expected = palpate.replay(scene, hips)["force_z"].tobytes()
        for other in (hips.astype(">f8"), np.asfortranarray(hips), np.repeat(hips, 2, axis=0)[::2], hips.tolist()):
            self.assertEqual(palpate.replay(scene, other)["force_z"].tobytes(), expected)
        integers = np.array([[0, 0, 30], [0, 0, 10]], dtype=">i2")
        self.assertAlmostEqual(palpate.replay(scene, integers)["force_z"][1], 5.0, delta=0.05)
        np.testing.assert_array_equal(palpate.Palpator(scene).step(np.array([0, 0, 15], dtype=">f4")).hip, [0, 0, 15])

    def test_read_only_input_and_output(self):
        points, triangles = self.points.copy(), self.triangles.copy()
        points.flags.writeable = triangles.flags.writeable = False
        self.check_same(points, triangles)
        surface = palpate.Surface(points, triangles)
        for array in (surface.points, surface.triangles, surface.two_sided, surface.triangle_source):
            self.assertFalse(array.flags.writeable)
            with self.assertRaises(ValueError):
                array[0] = 0
            with self.assertRaises(ValueError):
                array.flags.writeable = True

    def test_input_is_copied_and_output_is_not(self):
        points = self.points.copy()
        surface = palpate.Surface(points, self.triangles)
        before = surface.points.copy()
        points[:] = 0
        np.testing.assert_array_equal(surface.points, before)
        self.assertEqual(surface.points.ctypes.data, surface.points.ctypes.data)
        self.assertIs(surface.points.base, surface)

    def test_wrong_shapes(self):
        for points in (np.zeros(9), np.zeros((3, 2)), np.zeros((3, 3, 1)), np.zeros((0,)), np.float64(1)):
            with self.assertRaisesRegex(ValueError, r"points: found an array of shape \(.*\), expected \(n, 3\)"):
                palpate.Surface(points, [[0, 1, 2]])
        with self.assertRaisesRegex(ValueError, "triangles: .*expected"):
            palpate.Surface(self.points, np.zeros((4, 4), int))
        scene = scene_of_sphere()
        for hip in ([1, 2], [1, 2, 3, 4], [[1, 2, 3]], 1.0):
            with self.assertRaisesRegex(ValueError, "hip: "):
                palpate.Palpator(scene).step(hip)
        with self.assertRaisesRegex(ValueError, "hips: found no row"):
            palpate.replay(scene, np.zeros((0, 3)))
        with self.assertRaisesRegex(palpate.Error, "triangle"):
            palpate.Surface(np.zeros((0, 3)), np.zeros((0, 3), int))

    def test_wrong_types(self):
        for points in (self.points + 1j, self.points.astype(str), self.points.astype(object), self.points > 0,
                       "points", None, np.array([["a", "b", "c"]]), [[1, 2, 3], [4]]):
            with self.assertRaisesRegex(TypeError, "points: found"):
                palpate.Surface(points, self.triangles)
        for triangles in (self.triangles.astype(float), self.triangles > 0):
            with self.assertRaisesRegex(TypeError, "triangles: found numbers of type .*, expected whole numbers"):
                palpate.Surface(self.points, triangles)
        scene = scene_of_sphere()
        for hip in ("abc", None, ["a", "b", "c"], object()):
            with self.assertRaisesRegex(TypeError, "hip: found"):
                palpate.Palpator(scene).step(hip)
        for call in (lambda: palpate.Palpator(None), lambda: palpate.replay(None, [[0, 0, 0]]),
                     lambda: palpate.Scene([None]), lambda: palpate.Structure(None), lambda: palpate.load(3),
                     lambda: setattr(palpate.Palpator(scene), "scene", None)):
            with self.assertRaises(TypeError):
                call()

    def test_not_finite(self):
        for value, text in ((np.nan, "nan"), (np.inf, "inf"), (-np.inf, "-inf")):
            points = self.points.copy()
            points[7, 1] = value
            with self.assertRaisesRegex(palpate.Error, "vertex 7") as caught:
                palpate.Surface(points, self.triangles)
            self.assertEqual(caught.exception.code, "NonFinite")
            hips = stroke(20)
            hips[11, 2] = value
            with self.assertRaisesRegex(ValueError, rf"hips\[11, 2\]: found {text}, expected a finite number"):
                palpate.replay(scene_of_sphere(), hips)
            with self.assertRaisesRegex(ValueError, rf"hip\[2\]: found {text}"):
                palpate.Palpator(scene_of_sphere()).step(hips[11])

    def test_numbers_of_points_out_of_range(self):
        triangles = self.triangles.copy()
        triangles[5, 2] = len(self.points)
        with self.assertRaisesRegex(palpate.Error, f"triangle 5 uses vertex {len(self.points)}") as caught:
            palpate.Surface(self.points, triangles)
        self.assertEqual(caught.exception.code, "OutOfRange")
        for value in (-1, 2**32, 2**62):
            triangles[5, 2] = value
            with self.assertRaisesRegex(ValueError, rf"triangles\[5, 2\]: found {value}"):
                palpate.Surface(self.points, triangles)
        with self.assertRaisesRegex(ValueError, r"triangles\[0, 0\]: "):
            palpate.Surface(self.points, np.full((1, 3), 2**64 - 1, np.uint64))

    def test_options_out_of_range(self):
        surface, scene = palpate.Surface(self.points, self.triangles), scene_of_sphere()
        for call, text in (
                (lambda: palpate.replay(scene, [[0, 0, 0]], 0.0), "dt: found 0, expected"),
                (lambda: palpate.Palpator(scene).step([0, 0, 0], float("nan")), "dt: found nan"),
                (lambda: scene.with_radius(-1), "radius_mm: found -1, expected 0 to 50"),
                (lambda: scene.with_radius(float("nan")), "radius_mm: found nan"),
                (lambda: scene.with_tissue(stiffness_N_per_mm=0), "stiffness_N_per_mm: found 0, expected above 0"),
                (lambda: palpate.Structure(surface, stiffness_N_per_mm=float("inf")), "expected"),
                (lambda: palpate.Structure(surface, friction_static=0.1, friction_dynamic=0.2), "surface: "),
                (lambda: palpate.Structure(surface, young_ratio=0), "young_ratio: found 0"),
                (lambda: palpate.Structure(surface, name=""), "name: found an empty text"),
                (lambda: palpate.Surface(self.points, self.triangles, weld_within_mm=-1), "found -1"),
                (lambda: palpate.Surface(self.points, self.triangles, facing="in"), "facing: found \"in\""),
                (lambda: palpate.Scene([]), "found an empty list"),
                (lambda: palpate.Scene([palpate.Structure(surface)] * 2), "found \"surface\" twice"),
                (lambda: palpate.Scene([palpate.Structure(surface, inside="x")]), "inside: found \"x\""),
                (lambda: palpate.Scene([palpate.Structure(surface)], buried="x"), "buried: found \"x\""),
                (lambda: palpate.replay(palpate.Scene([palpate.Structure(surface, palpable=False)]), [[0, 0, 0]]),
                 "found nothing palpable"),
                (lambda: palpate.load(SCENE, unit="inch"), "unit: found \"inch\""),
                (lambda: palpate.load(SCENE, frame="XYZ"), "frame: found \"XYZ\""),
                (lambda: palpate.load(SCENE, smoothing=2), "smoothing: found 2"),
                (lambda: palpate.felt(scene, press_mm=[3, 1]), "."),
                (lambda: palpate.Recording(SESSION).measures(distance_mm=0), "distance_mm: found 0")):
            with self.assertRaisesRegex(ValueError, text):
                call()
        with self.assertRaises(TypeError):
            palpate.Structure(surface, layer=-1)
        with self.assertRaises(IndexError):
            scene[1]
        with self.assertRaises(KeyError):
            scene["liver"]
        self.assertEqual(scene[-1].name, "ball")

    def test_beyond_the_reach(self):
        tick = palpate.Palpator(scene_of_sphere()).step([1e12, 0, 0])
        self.assertEqual((tick.status, tick.force.tolist()), ("out of reach", [0, 0, 0]))

    def test_repairs_are_named(self):
        points = np.concatenate([self.points, self.points])
        triangles = np.concatenate([self.triangles, self.triangles + len(self.points)])
        surface = palpate.Surface(points, triangles)
        self.assertEqual(len(surface.points), len(self.points))
        self.assertTrue(surface.notes)
        self.assertTrue(surface.is_closed)
        self.assertEqual(palpate.Surface(self.points, self.triangles).notes, [])
        turned = palpate.Surface(self.points, self.triangles[:, ::-1])
        self.assertGreater(turned.volume_mm3, 0)
        self.assertLess(palpate.Surface(self.points, self.triangles[:, ::-1], facing="as given").volume_mm3, 0)
        np.testing.assert_array_equal(surface.points, points[surface.point_source])


class Lifetime(unittest.TestCase):
    def test_views_outlive_surface_and_scene(self):
        points, triangles = sphere()
        view = palpate.Surface(points, triangles).points
        faces = palpate.Scene([palpate.Structure(palpate.Surface(points, triangles))])[0].surface.triangles
        palpator = palpate.Palpator(scene_of_sphere())
        palpator.step([0, 0, 25])
        tick = palpator.step([0, 0, 15])
        scene = palpator.scene
        felt = palpate.felt(phantom(), press_mm=[4])[0]
        hips = palpate.Recording(SESSION).hips()
        del palpator
        gc.collect()
        filler = [np.ones(100000) for _ in range(50)]  # would overwrite what was freed
        self.assertEqual(np.abs(np.linalg.norm(view, axis=1) - 20).max() < 1e-9, True)
        self.assertEqual(faces.max() + 1, len(points))
        self.assertEqual((tick.structure, tick.contacts[0]["structure"]), ("ball", "ball"))
        self.assertEqual(scene.names, ["ball"])
        self.assertTrue(np.isfinite(felt["points"]).all() and felt["triangles"].max() < len(felt["points"]))
        self.assertTrue(np.isfinite(hips).all())
        del filler

    def test_palpator_keeps_a_scene_that_was_deleted(self):
        palpator = palpate.Palpator(scene_of_sphere())
        gc.collect()
        self.assertAlmostEqual(palpator.step([0, 0, 25]).force[2], 0)
        self.assertAlmostEqual(palpator.step([0, 0, 15]).force[2], 2.5, delta=0.05)
        palpator.scene = palpator.scene.with_tissue(stiffness_N_per_mm=1.0)
        gc.collect()
        self.assertAlmostEqual(palpator.step([0, 0, 15]).force[2], 5.0, delta=0.05)

    def test_surfaces_are_shared(self):
        surface = palpate.Surface(*sphere())
        scene = palpate.Scene([palpate.Structure(surface, name="a")])
        self.assertIs(scene[0].surface, surface)
        self.assertIs(scene.with_radius(2)[0].replace(name="b").surface, surface)
        self.assertEqual(scene[0].replace(layer=3).layer, 3)
        self.assertEqual(scene[0].layer, 0)


class Threads(unittest.TestCase):
    def in_threads(self, *works):
        errors = []

        def run(work):
            try:
                work()
            except BaseException as error:  # pylint: disable=broad-except
                errors.append(error)

        threads = [threading.Thread(target=run, args=(work,)) for work in works]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(errors, [])

    def test_replays_of_one_scene_in_two_threads(self):
        for _ in range(5):
            scene, hips = scene_of_sphere(), stroke(3000)  # the index is built by both
            results = []
            self.in_threads(*[lambda: results.append(palpate.replay(scene, hips)["force_x"].tobytes())] * 2)
            self.assertEqual(results[0], results[1])

    def test_palpator_shared_by_two_threads(self):
        scene = scene_of_sphere()
        palpator = palpate.Palpator(scene)
        other = scene.with_tissue(stiffness_N_per_mm=2)

        def steps():
            for hip in stroke(2000):
                self.assertTrue(np.isfinite(palpator.step(hip).force).all())

        def edits():
            for i in range(100):
                palpator.scene = other if i % 2 else scene
                palpator.reset()

        self.in_threads(steps, steps, edits)

    def test_recording_shared_by_two_threads(self):
        recording = palpate.Recording(SESSION)
        expected = recording.ticks(last=3000)["force_y"].tobytes()

        def read():
            for _ in range(3):
                self.assertEqual(recording.ticks(last=3000)["force_y"].tobytes(), expected)
                self.assertEqual(len(recording.hips()), recording.info["ticks"])

        self.in_threads(read, read)

    def test_array_changed_by_another_thread_meanwhile(self):
        scene, hips = scene_of_sphere(), stroke(60000)
        expected = palpate.replay(scene, hips)
        changed = hips.copy()
        started, results = threading.Event(), []

        def replay():
            started.set()
            results.append(palpate.replay(scene, changed))

        def spoil():
            started.wait()
            while not results:
                changed[:] = changed[::-1].copy()

        self.in_threads(replay, spoil)
        self.assertEqual(len(results[0]), len(expected))
        self.assertTrue(np.isfinite(results[0]["force_x"]).all())

    def test_other_threads_continue_during_a_replay(self):
        scene, hips = scene_of_sphere(), np.repeat(stroke(1500), 60, axis=0)
        palpate.replay(scene, hips[:10])
        count, done = [0], threading.Event()

        def work():
            palpate.replay(scene, hips, layers=False)
            done.set()

        thread = threading.Thread(target=work)
        thread.start()
        while not done.is_set():
            count[0] += 1
        thread.join()
        self.assertGreater(count[0], 100)


    def test_path_is_read_in_place(self):
        """A handler that changes the array during the replay changes the rest of the path."""
        scene, path = scene_of_sphere(), np.repeat(stroke(1500), 100, axis=0)
        for hips, is_read_in_place in ((path.copy(), True), (np.asfortranarray(path), False)):
            before = hips.copy()
            calls = []

            def change(*_, hips=hips, calls=calls):
                calls.append(1)
                hips[:] = 0

            old = signal.signal(signal.SIGUSR1, change)
            try:
                for _ in range(20 if is_read_in_place else 2):  # a signal may come after the replay
                    hips[:] = before
                    calls.clear()
                    timer = threading.Timer(0.01, lambda: os.kill(os.getpid(), signal.SIGUSR1))
                    timer.start()
                    ticks = palpate.replay(scene, hips, layers=False)
                    timer.join()
                    if ticks["hip_x"][-1] != before[-1, 0]:
                        break
            finally:
                signal.signal(signal.SIGUSR1, old)
            self.assertEqual(ticks["hip_x"][-1], 0 if is_read_in_place else before[-1, 0])


class Interrupts(unittest.TestCase):
    """Ctrl-C during long calls. The signal comes from a thread that first sees the call running without the GIL."""

    def check(self, call, delay_s=0.05):
        timer = threading.Timer(delay_s, lambda: os.kill(os.getpid(), signal.SIGINT))
        old = signal.signal(signal.SIGINT, signal.default_int_handler)
        try:
            with self.assertRaises(KeyboardInterrupt):
                timer.start()
                for _ in range(1000):  # one call may be over before the signal
                    call()
        finally:
            timer.cancel()
            timer.join()
            signal.signal(signal.SIGINT, old)

    def test_replay(self):
        points, triangles = sphere(rings=150, segments=200)
        scene = palpate.Scene([palpate.Structure(palpate.Surface(points, triangles))], radius_mm=8)
        few = stroke(3000)
        palpate.replay(scene, few[:1])
        began = time.monotonic()
        palpate.replay(scene, few)
        hips = np.repeat(few, 100, axis=0)
        whole_s = 100 * (time.monotonic() - began)
        began = time.monotonic()
        self.check(lambda: palpate.replay(scene, hips))
        self.assertLess(time.monotonic() - began, whole_s / 2)  # did not run to the end

    def test_felt(self):
        self.check(lambda: palpate.felt(phantom(), radius_mm=1.5))

    def test_load(self):
        self.check(lambda: palpate.load(SCENE))

    def test_recording(self):
        recording = palpate.Recording(SESSION)
        self.check(recording.ticks)
        self.check(recording.verify)
        self.assertEqual(len(recording.ticks()), 20000)  # works afterwards

    def test_handler_that_returns(self):
        calls = []
        old = signal.signal(signal.SIGUSR1, lambda *_: calls.append(1))
        try:
            threading.Timer(0.02, lambda: os.kill(os.getpid(), signal.SIGUSR1)).start()
            scene, hips = scene_of_sphere(), np.repeat(stroke(1500), 100, axis=0)
            for _ in range(100):
                self.assertEqual(len(palpate.replay(scene, hips, layers=False)), len(hips))
                if calls:
                    break
        finally:
            signal.signal(signal.SIGUSR1, old)
        self.assertEqual(calls, [1])


class Files(InFolder):
    def test_errors_have_the_message_of_the_engine(self):
        with self.assertRaisesRegex(palpate.Error, "nothing.stl: ") as caught:
            palpate.load("nothing.stl")
        self.assertEqual(caught.exception.code, "NotFound")
        broken = self.folder / "broken.stl"
        broken.write_bytes((PHANTOM / "lump-12-mm.stl").read_bytes()[:-20])
        with self.assertRaisesRegex(palpate.Error, "broken.stl: .*expected"):
            palpate.load(broken)
        with self.assertRaises(palpate.Error):
            palpate.Recording(broken)
        with self.assertWarns(UserWarning):
            partial = palpate.load(broken, partial=True)
        self.assertTrue(partial.losses)
        odd = self.folder / os.fsdecode(b"\xff.stl")  # no UTF-8
        with self.assertRaises(palpate.Error):
            palpate.load(odd)

    def test_mesh_units_and_label_map(self):
        scene = palpate.load(PHANTOM / "lump-12-mm.stl")
        self.assertAlmostEqual(np.ptp(scene[0].surface.points, axis=0).max(), 12, delta=0.2)
        metres = palpate.load(PHANTOM / "lump-12-mm.stl", unit="cm")
        np.testing.assert_allclose(metres[0].surface.points, scene[0].surface.points * 10)
        labels = np.zeros((12, 12, 12), "<u1")
        labels[3:9, 3:9, 3:9] = 1
        header = ("NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 12 12 12\n"
                  "space directions: (2,0,0) (0,2,0) (0,0,2)\nkinds: domain domain domain\nencoding: raw\n"
                  "space origin: (0,0,0)\n\n")
        path = self.folder / "labels.nrrd"
        path.write_bytes(header.encode() + labels.tobytes())
        ball = palpate.load(path)
        self.assertEqual(len(ball), 1)
        self.assertTrue(ball[0].surface.is_closed)
        self.assertAlmostEqual(np.mean(ball[0].surface.points, axis=0)[0], 11, delta=0.2)

    def test_felt_map_equals_the_command(self):
        out = self.folder / "felt.json"
        run_palpate("felt", SCENE, "--json", out, "--press", "0,4", "--radius", 6)
        felt = palpate.felt(phantom(), press_mm=[0, 4], radius_mm=6)
        self.assertEqual(len(felt), 1)
        self.assertEqual(felt[0]["lumps"], json.loads(out.read_text())["lumps"])
        points = len(felt[0]["points"])
        self.assertEqual(felt[0]["ratio"].shape, (2, points))
        for name in ("cover_mm", "lump", "not_judged"):
            self.assertEqual(felt[0][name].shape, (points,))
        self.assertGreater(felt[0]["ratio"].max(), 1.05)
        best = felt[0]["points"][felt[0]["ratio"][1].argmax()]
        lump = palpate.load(PHANTOM / "lump-20-mm.stl")[0].surface.points.mean(axis=0)
        self.assertLess(np.linalg.norm(best - lump), 25)

    def test_felt_from_arrays(self):
        points, triangles = sphere(30)
        organ = palpate.Structure(palpate.Surface(points, triangles), name="organ", stiffness_N_per_mm=0.2)
        lump = palpate.Structure(palpate.Surface(points / 5 + [0, 0, 18], triangles), name="lump", inside="organ",
                                 young_ratio=5.0)
        scene = palpate.Scene([organ, lump], buried="felt")
        press = np.linspace([0, 0, 31], [0, 0, 26], 200)
        over = palpate.replay(scene, press)["force_z"][-1]
        away = palpate.replay(scene, -press)["force_z"][-1]
        self.assertGreater(over, -1.05 * away)
        self.assertEqual([lump["name"] for lump in palpate.felt(scene)[0]["lumps"]], ["lump"])
        with self.assertRaises(palpate.Error):
            palpate.felt(palpate.Scene([organ]))

    def test_recording(self):
        recording = palpate.Recording(SESSION)
        self.assertEqual(recording.info["ticks"], 20000)
        out = self.folder / "session.csv"
        run_palpate("session", "export", SESSION, "--csv", out)
        ticks = recording.ticks()
        with open(out, newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        self.assertEqual(list(ticks.dtype.names), rows[0])
        self.assertEqual(len(ticks), len(rows) - 1)
        for at, name in enumerate(rows[0]):
            column = [row[at] for row in rows[1:]]
            if ticks[name].dtype.kind == "f":
                expected = np.array([float(cell) if cell else np.nan for cell in column])
                self.assertEqual(np.isnan(ticks[name]).tolist(), np.isnan(expected).tolist(), name)
                self.assertEqual(np.nan_to_num(ticks[name]).tobytes(), np.nan_to_num(expected).tobytes(), name)
            else:
                self.assertEqual([str(cell) for cell in ticks[name]], column, name)
        again = palpate.replay(recording.scene(), recording.hips(), recording.info["dt_s"])
        np.testing.assert_allclose(again["force_y"], ticks["force_y"], atol=1e-9)
        self.assertEqual(recording.events[0]["kind"], "scene")
        self.assertEqual([event["data"]["name"] for event in recording.events if event["kind"] == "finding"],
                         [finding["name"] for finding in recording.findings])
        with self.assertRaisesRegex(AttributeError, "."):
            recording.path = "x"

    def test_events_of_ticks(self):
        run_palpate("session", "share", small_folder() / "palpation.palpate", "--out", self.folder / "copy.palpate")
        recording = palpate.Recording(self.folder / "copy.palpate")
        texts = recording.ticks()["events"]
        self.assertEqual({at: text for at, text in enumerate(texts) if text}, {0: "scene", 999: "shared"})
        for split in (1, 999):
            parts = [recording.ticks(last=split - 1)["events"], recording.ticks(first=split)["events"]]
            self.assertEqual(np.concatenate(parts).tolist(), texts.tolist())

    def test_measures_and_verify(self):
        small = palpate.Recording(small_folder() / "palpation.palpate")
        self.assertEqual(small.measures(), small_measures())
        self.assertTrue(small.verify()["is_same"])
        damaged = self.folder / "damaged.palpate"
        shutil.copy(SESSION, damaged)
        database = sqlite3.connect(damaged)
        database.execute("UPDATE ticks SET hip_x = hip_x + 1 WHERE tick = 5000")
        database.commit()
        database.close()
        with self.assertRaises(palpate.Error) as caught:
            palpate.Recording(damaged).verify()
        self.assertEqual(caught.exception.code, "Mismatch")
        recording = palpate.Recording(damaged)
        self.assertLess(len(recording.ticks()), 20000)
        self.assertTrue(recording.faults)
        with self.assertRaises(palpate.Error):
            palpate.compare(SESSION, SESSION)


class Package(unittest.TestCase):
    def test_version(self):
        self.assertIn(palpate.__version__, run_palpate("--version"))

    def test_everything_has_a_docstring(self):
        for name in palpate.__all__:
            item = getattr(palpate, name)
            self.assertTrue(item.__doc__, name)
            for member, value in vars(item).items() if inspect.isclass(item) else ():
                if not member.startswith("_") and member != "args":
                    self.assertTrue(value.__doc__, f"{name}.{member}")

    def test_stubs_name_what_is_there(self):
        """Names, parameters and defaults of __init__.pyi are those of the module."""
        tree = ast.parse(pathlib.Path(palpate.__file__).with_name("__init__.pyi").read_text(encoding="utf-8"))
        stubs = {node.name: node for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(sorted(name for name in stubs if not name.startswith("_")), sorted(palpate.__all__))

        def parameters_of_stub(node):
            names = [arg.arg for arg in node.args.args + node.args.kwonlyargs]
            return [name for name in names if name != "self"]

        def parameters_of(function):
            signature = re.match(r"[^(]*\((.*)\) -> ", function.__doc__).group(1)
            signature = re.sub(r"\[[^][]*(\[[^][]*\])?[^][]*\]", "", signature)
            names = [part.split(":")[0].split("=")[0].strip() for part in signature.split(", ")]
            return [name for name in names if name.isidentifier() and name != "self"]

        for name, node in stubs.items():
            if isinstance(node, ast.FunctionDef):
                self.assertEqual(parameters_of_stub(node), parameters_of(getattr(palpate, name)), name)
                continue
            if name == "Error" or name.startswith("_"):
                continue
            item = getattr(palpate, name)
            members = {one.name: one for one in node.body if isinstance(one, ast.FunctionDef)}
            there = {member for member in vars(item) if not member.startswith("_")}
            self.assertEqual({member for member in members if not member.startswith("_")}, there, name)
            for member, stub in members.items():
                if isinstance(vars(item)[member], property):
                    self.assertTrue(stub.decorator_list, f"{name}.{member}")
                else:
                    self.assertEqual(parameters_of_stub(stub), parameters_of(vars(item)[member]), f"{name}.{member}")


class Page(InFolder):
    """The examples of resources/docs/python.md run as they stand, in a copy of data/phantom."""

    PAGE = (SOURCES / "resources" / "docs" / "python.md").read_text(encoding="utf-8")
    EXAMPLES = {heading: code for heading, code in re.findall(
        r"^##+ ([^\n]+)\n(?:(?!^##)(?!```)[^\n]*\n)*?```python\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)}

    def run_example(self, heading, folder=PHANTOM):
        for file in folder.iterdir():
            if file.is_file():
                shutil.copy(file, self.folder)
        before, path = os.getcwd(), os.environ["PATH"]
        self.addCleanup(os.chdir, before)
        self.addCleanup(os.environ.__setitem__, "PATH", path)
        os.chdir(self.folder)
        os.environ["PATH"] = f"{os.path.dirname(PROGRAM)}:{path}"
        names = {"__name__": "example", "print": lambda *_: None}
        with warnings.catch_warnings():
            warnings.simplefilter("default")  # those of other libraries are none of ours
            exec(compile(self.EXAMPLES[heading], heading, "exec"), names)  # pylint: disable=exec-used
        return names

    def test_all_are_tried(self):
        self.assertEqual(self.PAGE.count("```python"), len(self.EXAMPLES))
        tried = re.findall(r"run_example\(\"([^\"]+)\"[,)]", pathlib.Path(__file__).read_text(encoding="utf-8"))
        self.assertEqual(sorted(tried), sorted(self.EXAMPLES))

    def test_first_steps(self):
        names = self.run_example("First steps")
        self.assertAlmostEqual(names["tick"].force[2], names["ticks"]["force_z"][-1], places=9)

    def test_force_over_depth(self):
        try:
            import matplotlib  # pylint: disable=import-outside-toplevel
            matplotlib.use("Agg")
        except ImportError:
            self.skipTest("matplotlib is not installed (Debian: python3-matplotlib)")
        self.run_example("Force over depth")
        self.assertEqual((self.folder / "force.png").read_bytes()[1:4], b"PNG")

    def test_search(self):
        names = self.run_example("Search for a lump")
        felt = palpate.felt(names["scene"], press_mm=[4])[0]
        left = felt["points"][:, 0] < 0  # of the lump of 20 mm, not of the other
        stiffest = felt["points"][left][felt["ratio"][0][left].argmax()]
        self.assertLess(np.linalg.norm(names["found"] - stiffest), 6)
        self.assertLess(names["presses"], 60)

    def test_compare(self):
        names = self.run_example("Compare two sessions", small_folder())
        rows = {row["measure"]: row for row in names["comparison"]["measures"] if row["structure"] == ""}
        self.assertEqual(rows["peak_force_N"]["first"], small_measures()["peak_force_N"])
        self.assertGreater(rows["mean_force_N"]["second"], rows["mean_force_N"]["first"])

    def test_sqlite(self):
        names = self.run_example("Without this package", small_folder())
        self.assertEqual(names["peak_N"], small_measures()["peak_force_N"])


if __name__ == "__main__":
    sys.exit(unittest.main())
