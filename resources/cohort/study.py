#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Jobs of the Snakefile in this folder, with the standard library of Python alone.

    study.py recording PALPATE FILE RESULT [OPTION ...]      verifies and measures a recording
    study.py felt PALPATE SCENE RESULT                       which lumps of a patient can be felt
    study.py evaluate PALPATE FILE RESULT KIND quick|full    speed against error; KIND: recordings or patients
    study.py join OUT [recordings=FOLDER] [patients=FOLDER] [felt] [evaluate]    tables and page of all results

A job writes its result at once and under its final name, so that a killed job leaves none. It ends with 0 when the
file cannot be used, which is the result then, and with another code when the program cannot be started.
"""
import csv
import hashlib
import html
import io
import json
import math
import os
import re
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import urllib.parse
from collections import defaultdict
from typing import NamedTuple

RECORDING = ".palpate"
SCENE = ".palpate.json"
# Formats of `palpate info` (README.md, "Formats").
MESHES = (".stl", ".vtp", ".obj", ".ply", ".vtk", ".vtu", ".off", ".gii", ".pial", ".white", ".nrrd", ".nhdr", ".nii",
          ".nii.gz", ".mha", ".mhd", ".vti")
CONFIG = {"recordings", "patients", "out", "palpate", "scene", "distance", "evaluate", "felt"}
MEASURES = ["session", "sha256", "started_utc", "device", "structure", "measure", "value", "unit"]
EVALUATED = ["triangles", "time_us_p50", "time_us_p99", "position_error_mm_max", "force_error_percent_p99",
             "pop_throughs", "ticks", "ticks_apart"]
FELT = ["lumps", "lumps_palpable", "least_cover_mm", "best_change_percent", "area_over_14_mm2"]
MOST_ENCODED = 200  # bytes of a name, which the folder limits to 255 with the extension


class StudyError(Exception):
    pass


class Item(NamedTuple):
    path: str
    name: str  # in the tables
    files: list  # whose change makes the result out of date
    stamp: list  # times of the files whose names Snakemake would not take literally


def item_of(path, name, files):
    # Snakemake takes braces as wildcards, and does not give all characters literally to the jobs of a cluster.
    odd = [file for file in files if not re.fullmatch(r"[\w/.+-]+", file)]
    return Item(path, name, [file for file in files if file not in odd], [os.stat(file).st_mtime_ns for file in odd])


def check_config(config):
    if unknown := set(config) - CONFIG:
        raise StudyError(f"--config: found {', '.join(sorted(unknown))}, expected some of {', '.join(sorted(CONFIG))}")
    if not {"recordings", "patients"} & set(config):
        raise StudyError("--config: found neither recordings=FOLDER nor patients=FOLDER, expected at least one")
    for name, allowed in (("evaluate", ("quick", "full")), ("felt", ("yes", "no"))):
        if name in config and str(config[name]) not in allowed:
            raise StudyError(f"--config {name}: found {config[name]}, expected {' or '.join(allowed)}")
    if set(str(config.get("out", ""))) & set("{}\n\r"):
        raise StudyError(f"--config out: found {config['out']}, expected a name without braces and line breaks")
    if "scene" in config and not os.path.exists(str(config["scene"])):
        raise StudyError(f"--config scene: found no file {config['scene']}, expected the scene of the recordings")


class Build:
    """The version that a program states. It is kept beside the results as long as the program and its libraries are
    the same files, because a start of the program takes 0.2 s."""

    def __init__(self, palpate, out):
        self.file = os.path.join(out, ".build.json")
        self.program = os.path.realpath(shutil.which(palpate) or palpate)
        try:
            kept = json.loads(read(self.file))
            self.isKept = self.program in kept["files"] and kept["files"] == stamps(kept["files"])
            self.text = kept["text"]
        except (OSError, ValueError, KeyError, TypeError):
            self.isKept = False
        if not self.isKept:
            try:
                self.text = subprocess.run([palpate, "--version"], capture_output=True, text=True,
                                           check=True).stdout.strip()
            except (OSError, subprocess.CalledProcessError) as error:
                raise StudyError(f"--config palpate: cannot start {palpate}: {error}") from error

    def keep(self):
        """After a run, which has made the folder."""
        if self.isKept or not os.path.isdir(os.path.dirname(self.file)):
            return
        ldd = subprocess.run(["ldd", self.program], capture_output=True, text=True, check=False)
        if ldd.returncode == 0:  # a script may start any program
            libraries = re.findall(r"=> (/.*palpate.*) \(0x", ldd.stdout)
            files = [self.program, *map(os.path.realpath, libraries)]
            write(self.file, json.dumps({"text": self.text, "files": stamps(files)}) + "\n")


def stamps(files):
    """Time and size of files."""
    return {file: [os.stat(file).st_mtime_ns, os.stat(file).st_size] for file in files}


def measure_options(config):
    return [part for name in ("scene", "distance") if name in config for part in (f"--{name}", str(config[name]))]


def tables_of(config):
    tables = ["failed.csv"]
    if "recordings" in config:
        tables += ["measures.csv", "findings.csv"] + (["evaluated.csv"] if "evaluate" in config else [])
    if "patients" in config:
        tables += ["patients.csv", "spread.csv"]
    return tables


# Inputs

def key_of(name):
    """A file name for any name: percent-encoded, shortened by a hash if it is too long."""
    key = urllib.parse.quote(os.fsencode(name), safe="")
    if len(key) > MOST_ENCODED:
        key = key[:MOST_ENCODED - 65] + "-" + hashlib.sha256(os.fsencode(name)).hexdigest()
    return key


def listed(folder):
    try:
        return sorted((entry for entry in os.scandir(folder) if not entry.name.startswith(".")),
                      key=lambda entry: os.fsencode(entry.name))
    except OSError as error:
        raise StudyError(f"{folder}: cannot be read: {error.strerror}") from error


def find_recordings(folder):
    """All recordings of a folder and the folders below, in the order of `palpate session measure`."""
    folder = os.path.normpath(folder)
    found = []

    def search(inner):
        for entry in listed(inner):
            if entry.is_dir():
                if not entry.is_symlink():
                    search(entry.path)
            elif entry.name.endswith(RECORDING) and entry.name != RECORDING:
                found.append(entry.path)

    search(folder)
    if not found:
        raise StudyError(f"{folder}: found no recording, expected files named *{RECORDING}")
    found.sort(key=lambda path: os.fsencode(path).split(b"/"))
    names = [os.path.relpath(path, folder) for path in found]
    return {key_of(name): item_of(path, name, [path]) for path, name in zip(found, names)}


def meshes_of_scene(path):
    try:
        with open(path, encoding="utf-8") as file:
            structures = json.load(file).get("structures", [])
        meshes = [os.path.join(os.path.dirname(path), one["mesh"]) for one in structures]
    except (OSError, ValueError, AttributeError, KeyError, TypeError):
        return []  # the job reports it
    return sorted({os.path.normpath(mesh) for mesh in meshes if os.path.isfile(mesh)})


def find_patients(folder):
    """One patient for each folder, scene file or mesh file directly in a folder."""
    folder = os.path.normpath(folder)
    found = {}
    for entry in listed(folder):
        if entry.is_dir():
            scenes = [one.path for one in listed(entry.path) if one.name.endswith(SCENE)]
            files = [os.path.join(inner, name) for inner, folders, names in os.walk(entry.path)
                     for name in names if not name.startswith(".")]
            # A folder with one scene file is that scene; other folders are read as a folder of meshes.
            path = scenes[0] if len(scenes) == 1 else entry.path
        elif entry.name.lower().endswith((SCENE, *MESHES)):
            path, files = entry.path, [entry.path] + (meshes_of_scene(entry.path) if entry.name.endswith(SCENE) else [])
        else:
            continue
        found[key_of(entry.name)] = item_of(path, entry.name, sorted(files))
    if not found:
        raise StudyError(f"{folder}: found no patient, expected folders of meshes, scene files or mesh files")
    return found


# Jobs

class Step(NamedTuple):
    code: int
    messages: list

    @property
    def is_usable(self):
        return self.code in (0, 3)  # 3: something is missing, each loss is a message


def run(command):
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", check=False)
    if -done.returncode in (signal.SIGINT, signal.SIGTERM):
        sys.exit(128 - done.returncode)  # interrupted: no result
    messages = [line for line in done.stderr.splitlines() if not line.lstrip()[:3].rstrip(" %").isdigit()]
    if done.returncode < 0:
        messages.append(f"killed by {signal.Signals(-done.returncode).name}")
    return Step(done.returncode, messages)


def write(path, text):
    """Writes a file at once: a reader finds all of it or the one before."""
    folder = os.path.dirname(path) or "."
    os.makedirs(folder, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=folder, prefix=".", suffix=".part")
    try:
        with open(handle, "w", encoding="utf-8", errors="surrogateescape", newline="") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
            os.fchmod(file.fileno(), 0o644)
        os.replace(name, path)
    except BaseException:
        os.unlink(name)
        raise


def read(path):
    with open(path, encoding="utf-8", newline="") as file:
        return file.read()


def write_result(path, steps, **values):
    steps = {name: step._asdict() for name, step in steps.items()}
    write(path, json.dumps({"steps": steps, **values}, indent=1, sort_keys=True) + "\n")


def recording(palpate, path, result, *options):
    scene = [options[i + 1] for i in range(0, len(options), 2) if options[i] == "--scene"]
    steps = {"verify": run([palpate, "session", "verify", path, *(["--scene", *scene] if scene else [])])}
    measures = findings = ""
    if steps["verify"].is_usable:
        with tempfile.TemporaryDirectory() as folder:
            tables = [os.path.join(folder, name) for name in ("m.csv", "f.csv")]
            steps["measure"] = run([palpate, "session", "measure", path, "--csv", tables[0], "--findings", tables[1],
                                    *options])
            if steps["measure"].is_usable:
                measures, findings = map(read, tables)
    write_result(result, steps, measures=measures, findings=findings)


def felt(palpate, path, result):
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "felt.json")
        step = run([palpate, "felt", path, "--json", out])
        lumps = json.loads(read(out))["lumps"] if step.is_usable and os.path.exists(out) else []
    write_result(result, {"felt": step}, row=felt_row(lumps) if step.is_usable else {})


def felt_row(lumps):
    deepest = [lump["press"][-1] for lump in lumps if lump["press"]]

    def greatest(values):
        known = [value for value in values if value is not None]
        return max(known) if known else None

    return {
        "lumps": len(lumps),
        "lumps_palpable": sum(press["verdict"] in ("by a trained hand", "plainly") for press in deepest),
        "least_cover_mm": min((lump["least_cover_mm"] for lump in lumps), default=None),
        "best_change_percent": greatest(None if press["ratio"] is None else 100.0 * (press["ratio"] - 1.0)
                                        for press in deepest),
        "area_over_14_mm2": greatest(press["area_over_14_mm2"] for press in deepest),
    }


def evaluate(palpate, path, result, kind, how):
    motion = ["--motion", path] if kind == "recordings" else []
    with tempfile.TemporaryDirectory() as folder:
        step = run([palpate, "evaluate", path, *motion, "--out", folder, *(["--quick"] if how == "quick" else [])])
        row = {}
        if step.is_usable:
            with open(os.path.join(folder, "results.csv"), encoding="utf-8", newline="") as file:
                # The first row of Palpate with the usual setting; the next ones are of other settings and bodies.
                row = next((one for one in csv.DictReader(file)
                            if (one["solver"], one["setting"], one["knob"]) == ("Palpate", "", "solver")), {})
    write_result(result, {"evaluate": step}, row={name: row[name] for name in EVALUATED if name in row})


# Tables and page

def cell(text):
    """The same as core/CsvCell.h, so that the tables have the bytes of `palpate session measure FOLDER`."""
    text = ("'" if text[:1] in ("=", "+", "-", "@", "\t", "\r", "\n") and text else "") + text
    return '"' + text.replace('"', '""') + '"' if any(c in text for c in ',"\r\n') else text


def number(value):
    return "" if value is None or value == "" else f"{float(value):.10g}"


def shown(name):
    """A name as text of valid UTF-8."""
    return os.fsencode(name).decode("utf-8", "replace")


def visible(text):
    """Makes characters visible that would change the direction or the lines of a text."""
    return "".join(c if c.isprintable() and c not in "\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069"
                   else f"<U+{ord(c):04X}>" for c in text)


def renamed(table, name):
    """The rows of a table of one session with the name of the session in the study."""
    first = cell(shown(name))
    for row in list(csv.reader(io.StringIO(table, newline="")))[1:]:
        yield ",".join([first, *map(again, row[1:])]), row


def again(text):
    """A cell that was read from a table."""
    return '"' + text.replace('"', '""') + '"' if any(c in text for c in ',"\r\n') else text


class Study:
    def __init__(self, out, recordings, patients, steps):
        self.out = out
        self.recordings = find_recordings(recordings) if recordings else {}
        self.patients = find_patients(patients) if patients else {}
        self.steps = steps
        self.failed = []  # kind, name, step, code, message
        self.noted = []
        self.values = defaultdict(list)  # (structure, measure, unit) -> values
        self.measured = 0
        self.rows = []  # of patients

    def result(self, *parts):
        """A result, or None when the file came after the jobs were chosen."""
        try:
            return json.loads(read(os.path.join(self.out, *parts) + ".json"))
        except FileNotFoundError:
            return None

    def take_steps(self, kind, name, result):
        for step, done in result["steps"].items():
            where = self.noted if done["code"] in (0, 3) else self.failed
            lines = done["messages"] or ([] if done["code"] == 0 else [f"exit code {done['code']}"])
            where += [(kind, shown(name), step, done["code"], line) for line in lines]

    def join_recordings(self):
        tables = {"measures": [",".join(MEASURES)], "findings": []}
        evaluated = [",".join(["session", *EVALUATED])]
        for key, item in self.recordings.items():
            if (result := self.result("recordings", key)) is None:
                continue
            self.take_steps("recording", item.name, result)
            if not result["measures"]:
                continue
            self.measured += 1
            for line, row in renamed(result["measures"], item.name):
                tables["measures"].append(line)
                if row[6]:
                    self.values[row[4], row[5], row[7]].append(float(row[6]))
            tables["findings"] = tables["findings"] or [result["findings"].split("\r\n")[0]]
            tables["findings"] += [line for line, row in renamed(result["findings"], item.name)]
            if "evaluate" in self.steps and (result := self.result("evaluated", "recordings", key)):
                self.take_steps("recording", item.name, result)
                if result["row"]:
                    evaluated.append(",".join([cell(shown(item.name)),
                                               *(number(result["row"].get(one)) for one in EVALUATED)]))
        for name, lines in tables.items():
            self.write_lines(f"{name}.csv", lines)
        if "evaluate" in self.steps:
            self.write_lines("evaluated.csv", evaluated)

    def columns(self):
        return FELT * ("felt" in self.steps) + EVALUATED * ("evaluate" in self.steps)

    def join_patients(self):
        for key, item in self.patients.items():
            row = {"patient": shown(item.name)}
            for place in (["patients"], ["evaluated", "patients"]):
                if (place[0] == "patients") != ("felt" in self.steps) and place[0] == "patients":
                    continue
                if place[0] == "evaluated" and "evaluate" not in self.steps:
                    continue
                if result := self.result(*place, key):
                    self.take_steps("patient", item.name, result)
                    row.update(result["row"])
            self.rows.append(row)
        lines = [",".join(["patient", *self.columns()])]
        lines += [",".join([cell(row["patient"]), *(number(row.get(one)) for one in self.columns())])
                  for row in self.rows]
        self.write_lines("patients.csv", lines)
        lines = ["measure,patients,minimum,quartile_1,median,quartile_3,maximum"]
        lines += [",".join([name, str(len(values)), *map(number, five(values))]) for name, values in self.spread()]
        self.write_lines("spread.csv", lines)

    def spread(self):
        for name in self.columns():
            if values := [float(row[name]) for row in self.rows if row.get(name) not in (None, "")]:
                yield name, values

    def write_lines(self, name, lines):
        write(os.path.join(self.out, name), "".join(line + "\r\n" for line in lines))

    def write_all(self):
        if self.recordings:
            self.join_recordings()
        if self.patients:
            self.join_patients()
        lines = ["kind,name,step,exit_code,message"]
        lines += [",".join([kind, cell(name), step, str(code), cell(line)])
                  for kind, name, step, code, line in self.failed]
        self.write_lines("failed.csv", lines)
        write(os.path.join(self.out, "index.html"), self.page())

    def page(self):
        parts = [HEAD, "<h1>Palpate study</h1>"]
        names = {(kind, name) for kind, name, *_ in self.failed}
        bad = sum(kind == "recording" for kind, _ in names)
        if self.recordings:
            parts.append(f"<p>{self.measured} of {len(self.recordings)} recordings measured, {bad} failed: "
                         '<a href="measures.csv">measures.csv</a>, <a href="findings.csv">findings.csv</a>.</p>')
            parts += self.charts()
            parts.append(table("Measures over sessions", ["structure", "measure", "unit", "sessions", *FIVE],
                               [[*key, str(len(values)), *map(short, five(values))]
                                for key, values in sorted(self.values.items())]))
        if self.patients:
            parts.append(f"<p>{len(self.patients)} patients: "
                         '<a href="patients.csv">patients.csv</a>, <a href="spread.csv">spread.csv</a>.</p>')
            for name, values in self.spread():
                parts.append(chart(name.replace("_", " "), "", [("", values)]))
            parts.append(table("Spread over patients", ["measure", "patients", *FIVE],
                               [[name, str(len(values)), *map(short, five(values))]
                                for name, values in self.spread()]))
        for title, lines in (("Failed", self.failed), ("Notes", self.noted)):
            if lines:
                parts.append(table(title, ["kind", "name", "step", "exit code", "message"],
                                   [[visible(str(one)) for one in line] for line in lines]))
        parts.append("<p>Definitions: measures.md, felt.md and evaluate.md. Research measures, not a diagnosis.</p>"
                     "</body></html>\n")
        return "\n".join(parts)

    def charts(self):
        for measure, title, unit in CHARTS:
            rows = [(structure, values) for (structure, name, _), values in sorted(self.values.items())
                    if name == measure]
            if rows:
                yield chart(title, unit, rows[:MOST_ROWS])


CHARTS = (("contact_time_s", "Contact time", "s"), ("peak_force_N", "Peak force", "N"),
          ("mean_force_N", "Mean force", "N"), ("peak_depth_mm", "Peak depth", "mm"),
          ("coverage", "Examined share of the surface", "1"), ("path_length_mm", "Path of the hand", "mm"))
FIVE = ("minimum", "first quartile", "median", "third quartile", "maximum")
MOST_ROWS = 12
MOST_POINTS = 200
HEAD = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Palpate study</title><style>
body { font: 15px/1.5 sans-serif; max-width: 62em; margin: 2em auto; padding: 0 1em; color: #222; background: #fff }
table { border-collapse: collapse; margin: 1em 0 } caption { text-align: left; font-weight: bold; padding: 0.4em 0 }
th, td { border-bottom: 1px solid #ccc; padding: 0.15em 0.7em 0.15em 0; text-align: left; vertical-align: top }
svg { display: block; margin: 1.5em 0; max-width: 100%; height: auto }
</style></head><body>"""


def five(values):
    values = sorted(values)
    if len(values) == 1:
        return values * 5
    quartiles = statistics.quantiles(values, n=4, method="inclusive")
    return [values[0], *quartiles, values[-1]]


def short(value):
    return f"{value:.4g}"


def table(caption, head, rows):
    def line(cells, tag):
        return "<tr>" + "".join(f"<{tag}>{html.escape(one)}</{tag}>" for one in cells) + "</tr>"

    return "\n".join([f"<table><caption>{caption}</caption>", line(head, "th"),
                      *(line([visible(one) for one in row], "td") for row in rows), "</table>"])


def step_of(extent):
    """The step of an axis: 1, 2 or 5 times a power of ten."""
    rough = extent / 5
    power = 10.0 ** math.floor(math.log10(rough))
    return next(factor * power for factor in (1, 2, 5, 10) if factor * power >= rough * (1 - 1e-9))


def chart(title, unit, rows):
    """Box from the first to the third quartile with the median, and a point for each value."""
    left, width, height = 150, 560, 26
    low = min(0.0, min(min(values) for _, values in rows))
    high = max(max(values) for _, values in rows)
    high = high if high > low else low + 1.0

    def x(value):
        return f"{left + width * (value - low) / (high - low):.1f}"

    bottom = 30 + height * len(rows)
    name = html.escape(title + (f" [{unit}]" if unit not in ("", "1") else ""))
    out = [f'<svg viewBox="0 0 740 {bottom + 24}" width="740" role="img" aria-label="{name}">',
           f'<text x="0" y="15" font-size="14" font-weight="bold">{name}</text>']
    step = step_of(high - low)
    for i in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1):
        out.append(f'<path d="M{x(i * step)} 24V{bottom}" stroke="#ddd"/><text x="{x(i * step)}" y="{bottom + 16}" '
                   f'font-size="11" text-anchor="middle">{i * step:.10g}</text>')
    for i, (label, values) in enumerate(rows):
        y = 30 + height * i + height // 2
        _, first, median, third, _ = five(values)
        label = html.escape(visible(label or "all"))
        out.append(f'<text x="{left - 10}" y="{y + 4}" font-size="12" text-anchor="end">{label[:24]}</text>')
        out.append(f'<path d="M{x(first)} {y - 7}H{x(third)}V{y + 7}H{x(first)}Z" fill="#9ecae1"/>'
                   f'<path d="M{x(median)} {y - 9}V{y + 9}" stroke="#08306b" stroke-width="2"/>')
        points = sorted(values)
        points = points[::math.ceil(len(points) / MOST_POINTS)] + points[-1:]
        out.append(f'<path d="{"".join(f"M{x(value)} {y}h0" for value in points)}" stroke="#222" stroke-width="4" '
                   'stroke-linecap="round" stroke-opacity="0.5"/>')
    return "\n".join([*out, "</svg>"])


def join(out, *arguments):
    folders = dict(one.split("=", 1) for one in arguments if "=" in one)
    Study(out, folders.get("recordings"), folders.get("patients"), set(arguments)).write_all()


def main(arguments):
    jobs = {one.__name__: one for one in (recording, felt, evaluate, join)}
    try:
        jobs[arguments[0]](*arguments[1:])
    except StudyError as error:
        sys.exit(str(error))


if __name__ == "__main__":
    main(sys.argv[1:])
