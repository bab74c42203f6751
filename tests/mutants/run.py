#!/usr/bin/env python3
"""Puts one small fault after the other into the library, and shows that a test catches each.

Shaders are faulted in a directory that the test programs read (OSGWATERREFLECT_TEST_SHADERS), C++ in
a copy of the tree with a build of its own. The table goes to docs/stability/mutants.json.

  run.py [--only TEXT] [--list]
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is

from mutants import MUTANTS

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build"
COPY = BUILD / "mutants"
TABLE = ROOT / "docs" / "stability" / "mutants.json"
SHADERS = "osgWaterReflect/shaders/"

# [s] A test that does not end has noticed, too.
PATIENCE = 240


def faulted(mutant, tree):
    path = tree / mutant.file
    text = path.read_text(encoding="utf-8")
    if text.count(mutant.was) != 1:
        sys.exit(f"{mutant.file}: expected once, found {text.count(mutant.was)} times: {mutant.was}")
    return text.replace(mutant.was, mutant.becomes)


def run_test(binaries, mutant, environment=None):
    """Whether the test fails."""
    # Catch2 takes a comma for the end of a name.
    command = [binaries / mutant.program, mutant.test.replace(",", "\\,"), "--abort"]
    try:
        done = subprocess.run(
            command, env={**os.environ, **(environment or {})}, timeout=PATIENCE,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    except subprocess.TimeoutExpired:
        return True
    if "No test cases matched" in done.stdout or "No tests ran" in done.stdout:
        sys.exit(f"{mutant.program}: expected a test {mutant.test}, got none")
    return done.returncode != 0


def try_shader(mutant):
    with tempfile.TemporaryDirectory() as directory:
        piece = Path(directory) / Path(mutant.file).name
        piece.write_text(faulted(mutant, ROOT), encoding="utf-8")
        return run_test(BUILD / "bin", mutant, {"OSGWATERREFLECT_TEST_SHADERS": directory})


def make_copy():
    """A build of the tree as it is, for faults in C++."""
    shutil.rmtree(COPY / "tree", ignore_errors=True)
    files = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard", "-z"], cwd=ROOT,
        check=True, stdout=subprocess.PIPE).stdout.decode().split("\0")
    for name in filter(None, files):
        if (ROOT / name).exists():
            (COPY / "tree" / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, COPY / "tree" / name)
    if not (COPY / "build" / "build.ninja").exists():
        subprocess.run(
            ["cmake", "-S", COPY / "tree", "-B", COPY / "build", "-G", "Ninja",
             "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1"],
            check=True, stdout=subprocess.DEVNULL)
    for program in sorted({mutant.program for mutant in MUTANTS}):
        build(program)


def build(program):
    subprocess.run(["cmake", "--build", COPY / "build", "--target", program], check=True,
                   stdout=subprocess.DEVNULL)


def try_cpp(mutant):
    path = COPY / "tree" / mutant.file
    whole = path.read_text(encoding="utf-8")
    path.write_text(faulted(mutant, COPY / "tree"), encoding="utf-8")
    try:
        build(mutant.program)
        return run_test(COPY / "build" / "bin", mutant)
    finally:
        path.write_text(whole, encoding="utf-8")


def write_table(rows):
    """In the order of MUTANTS; what was not tried now stays as it was when it was tried last."""
    before = json.loads(TABLE.read_text(encoding="utf-8")) if TABLE.exists() else []
    latest = {(row["file"], row["fault"]): row for row in before + rows}
    known = [latest.get((m.file, m.fault)) for m in MUTANTS]
    TABLE.parent.mkdir(parents=True, exist_ok=True)
    TABLE.write_text(json.dumps([row for row in known if row], indent=1) + "\n", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", default="", help="of faults whose text or file holds this")
    parser.add_argument("--list", action="store_true", help="what would be tried")
    arguments = parser.parse_args()
    mutants = [m for m in MUTANTS if arguments.only in f"{m.file} {m.fault} row {m.row},"]
    if arguments.list:
        for mutant in mutants:
            print(f"{mutant.row:2}  {mutant.file}: {mutant.fault}  [{mutant.program} {mutant.test}]")
        return

    for program, test in sorted({(m.program, m.test) for m in mutants}):
        whole = next(m for m in mutants if (m.program, m.test) == (program, test))
        if run_test(BUILD / "bin", whole):
            sys.exit(f"{program} {test}: expected it to pass without a fault, it fails")
    if any(not m.file.startswith(SHADERS) for m in mutants):
        print("building a copy", flush=True)
        make_copy()

    rows = []
    for mutant in mutants:
        start = time.monotonic()
        caught = (try_shader if mutant.file.startswith(SHADERS) else try_cpp)(mutant)
        seconds = time.monotonic() - start
        print(f"{'caught' if caught else 'SURVIVES':8} {seconds:5.0f} s  row {mutant.row:2}  "
              f"{mutant.file}: {mutant.fault}", flush=True)
        rows.append({"row": mutant.row, "file": mutant.file, "fault": mutant.fault,
                     "test": f"{mutant.program}: {mutant.test}", "caught": caught})
    write_table(rows)
    survivors = sum(not row["caught"] for row in rows)
    print(f"{len(rows)} faults, {survivors} survive")
    sys.exit(1 if survivors else 0)


if __name__ == "__main__":
    main()
