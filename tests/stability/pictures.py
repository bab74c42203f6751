#!/usr/bin/env python3
"""Has hard cases drawn as they are and with a fault, for docs/stability.md.

  pictures.py
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests" / "mutants"))

from mutants import MUTANTS

DRAWN = ROOT / "build" / "test-output"
PICTURES = ROOT / "docs" / "stability"

# By picture, the fault of tests/mutants that it shows.
FAULTS = {
    "hard-case-branch": "whatever the ray is behind is hit",
    "hard-case-budget": "a search gives up after 64 columns",
}


def draw(name, suffix, shaders=None):
    environment = {"OSGWATERREFLECT_TEST_SHADERS": shaders} if shaders else {}
    subprocess.run([ROOT / "build" / "bin" / "test_gpu", "pictures of hard cases"], check=True,
                   env={**os.environ, **environment}, stdout=subprocess.DEVNULL)
    shutil.copy(DRAWN / f"{name}.png", PICTURES / f"{name}{suffix}.png")


def main():
    for name, fault in FAULTS.items():
        mutant = next(m for m in MUTANTS if m.fault == fault)
        text = (ROOT / mutant.file).read_text(encoding="utf-8")
        draw(name, "")
        with tempfile.TemporaryDirectory() as shaders:
            (Path(shaders) / Path(mutant.file).name).write_text(
                text.replace(mutant.was, mutant.becomes), encoding="utf-8")
            draw(name, "-fault", shaders)


if __name__ == "__main__":
    main()
