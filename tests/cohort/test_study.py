#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""test_study.py PALPATE SOURCES WORK   runs resources/cohort/Snakefile on generated recordings, one of them damaged.

With two cores and with one, the tables are the same byte for byte, and those of `palpate session measure FOLDER`. A
second run does nothing, one new recording is one new job, and a killed run continues."""
import csv
import json
import math
import os
import shutil
import signal
import subprocess
import sys
import time

PALPATE, SOURCES, WORK = sys.argv[1:4]
if shutil.which("snakemake") is None:
    print("skipped: no snakemake")
    sys.exit(77)
BAD = "s1.palpate"
NAMES = ["a/same.palpate", "b/same.palpate", 'comma, "quote"\nline {key}.palpate', "=1+1 \u202e\u05d0\u05d1.palpate",
         "$(touch x);&*? ~#%41'.palpate", "-dash.palpate", BAD]
TABLES = ["measures.csv", "findings.csv", "failed.csv", "index.html"]


def write_box(path):
    corners = [(x, y, z) for x in (-10, 10) for y in (-10, 10) for z in (-10, 10)]
    faces = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(f"v {x} {y} {z}\n" for x, y, z in corners)
        file.writelines(f"f {a} {b} {c}\nf {a} {c} {d}\n" for a, b, c, d in faces)


def record(path, number):
    with open("motion.csv", "w", encoding="utf-8") as file:
        file.write("x,y,z\n")
        file.writelines(f"{0.1 * number},0.2,{10.5 - (1 + 0.1 * number) * math.sin(math.pi * t / 300)}\n"
                        for t in range(300))
    subprocess.run([PALPATE, "replay", "box.obj", "--motion", "motion.csv", "--record", path], check=True,
                   stdout=subprocess.DEVNULL)


def damage(path):
    """Changes the middle of a recording, so that its checksums fail."""
    with open(path, "r+b") as file:
        file.seek(os.path.getsize(path) // 2)
        file.write(bytes(8000))


def snakemake(out, *options):
    return ["snakemake", "-s", os.path.join(SOURCES, "resources/cohort/Snakefile"), "--rerun-incomplete", *options,
            "--config", "recordings=rec", f"out={out}", f"palpate={PALPATE}"]


def run(out, *options):
    """Jobs that were run, and processor time [s]."""
    before = os.times()
    done = subprocess.run(snakemake(out, *options), capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{options}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    rules = [line.split()[1].rstrip(":") for line in done.stderr.splitlines()
             if line.startswith(("rule ", "localrule "))]
    after = os.times()
    spent = after.children_user + after.children_system - before.children_user - before.children_system
    return [rule for rule in rules if rule != "all"], spent


def read(*parts):
    with open(os.path.join(*parts), "rb") as file:
        return file.read()


def check(condition, text):
    if not condition:
        sys.exit(text)


def check_build():
    """The version of the program is kept while its file is the same."""
    sys.path.insert(0, os.path.join(SOURCES, "resources/cohort"))
    sys.dont_write_bytecode = True
    import study  # pylint: disable=import-error,import-outside-toplevel
    with open("two/.build.json", encoding="utf-8") as file:
        kept = json.load(file)
    study.write("kept/.build.json", json.dumps({**kept, "text": "another"}))
    check(study.Build(PALPATE, "kept").text == "another", "the kept version is not used")
    changed = {name: [time_ns - 1, size] for name, (time_ns, size) in kept["files"].items()}
    study.write("kept/.build.json", json.dumps({"text": "another", "files": changed}))
    build = study.Build(PALPATE, "kept")
    check(build.text == kept["text"], "the version of another program is used")
    build.keep()
    check(json.loads(read("kept/.build.json")) == kept, "the version is not kept")


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    os.makedirs(os.path.join(WORK, "rec/a"))
    os.makedirs(os.path.join(WORK, "rec/b"))
    os.chdir(WORK)
    for folder in (".", "rec", "rec/a", "rec/b"):
        write_box(os.path.join(folder, "box.obj"))
    for number in range(3):
        record(f"{number}.palpate", number)
    for number, name in enumerate(NAMES):
        shutil.copyfile(f"{number % 3}.palpate", os.path.join("rec", name))
    damage(os.path.join("rec", BAD))

    jobs, _ = run("two", "--cores", "2")
    check(jobs.count("recording") == len(NAMES) and jobs.count("join") == 1, f"first run: {jobs}")
    check(not os.path.exists("x"), "a file name was run as a command")
    with open("two/failed.csv", encoding="utf-8", newline="") as file:
        failed = list(csv.DictReader(file))
    check({row["name"] for row in failed} == {BAD}, f"failed: {failed}")
    check(BAD in read("two/index.html").decode() and "\u202e" not in read("two/index.html").decode(), "page")
    # The table is that of one command over the folder without the bad recording.
    os.rename(os.path.join("rec", BAD), "bad.palpate")
    subprocess.run([PALPATE, "session", "measure", "rec", "--csv", "t.csv", "--findings", "f.csv"], check=True,
                   capture_output=True)
    os.rename("bad.palpate", os.path.join("rec", BAD))
    check(read("t.csv") == read("two/measures.csv"), "measures.csv is not the table of session measure")
    check(read("f.csv") == read("two/findings.csv"), "findings.csv is not the table of session measure")
    with open("two/measures.csv", encoding="utf-8", newline="") as file:
        names = {row["session"] for row in csv.DictReader(file)}
    check(names == {"'" * (name[0] in "=-") + name for name in NAMES} - {BAD}, f"sessions: {names}")

    jobs, seconds = run("two", "--cores", "2")
    check(not jobs, f"second run: {jobs}")
    print(f"nothing to do: {seconds:.1f} s of processor time")
    check_build()

    # Killed with all of its processes after some results; what is left continues with one core.
    process = subprocess.Popen(snakemake("one", "--cores", "1"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               start_new_session=True)
    deadline = time.monotonic() + 120
    while process.poll() is None and time.monotonic() < deadline:
        if os.path.isdir("one/recordings") and len(os.listdir("one/recordings")) >= 2:
            break
        time.sleep(0.02)
    check(process.poll() is None, "the run ended before it was killed")
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    done = {name: os.stat(f"one/recordings/{name}").st_mtime_ns for name in os.listdir("one/recordings")
            if name.endswith(".json")}
    check(len(done) < len(NAMES), f"killed too late: {len(done)} results")
    jobs, _ = run("one", "--cores", "1", "--nolock")
    check(jobs.count("join") == 1, f"continued run: {jobs}")
    kept = [name for name, when in done.items() if os.stat(f"one/recordings/{name}").st_mtime_ns == when]
    # The result of the job that ended last may not have been noted as complete.
    check(len(kept) >= len(done) - 1, f"{len(done)} results before, {len(kept)} of them kept")
    for name in TABLES:
        check(read("one", name) == read("two", name), f"{name} differs between one core and two")

    shutil.copyfile("2.palpate", "rec/new.palpate")
    jobs, _ = run("two", "--cores", "2", "--nolock")
    check(sorted(jobs) == ["join", "recording"], f"run with a new recording: {jobs}")
    check(b"\r\nnew.palpate," in read("two/measures.csv"), "the new recording is not in the table")


main()
