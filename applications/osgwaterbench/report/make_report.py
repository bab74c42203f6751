#!/usr/bin/env python3
"""Makes docs/accuracy.md, and the plots beside the data, from what osgwaterbench wrote.

The same data give the same bytes. Nothing is written where something is missing, or where the data
contradict the text.
"""

from __future__ import annotations

import argparse
import os
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is

import claims
import plots
import words
from bench_data import BenchData, DataError, MissingRow

REPORT = Path(__file__).resolve().parent
DOCS = REPORT.parents[2] / "docs"

PLACEHOLDER = re.compile(r"\{\{(\w+)\}\}")


def fill(template: str, values: dict, quick: bool) -> str:
    used = set(PLACEHOLDER.findall(template))
    if used != values.keys():
        raise DataError(f"template.md: expected each value once or more: {used ^ values.keys()}")

    def value(match: re.Match) -> str:
        try:
            return values[match.group(1)]()
        except MissingRow:
            if quick:
                return "n/a"
            raise

    return PLACEHOLDER.sub(value, template)


def check_pictures(data: BenchData) -> None:
    for scene in data.scenes:
        picture = data.directory / f"rivals-{scene}.jpg"
        if not picture.exists():
            raise DataError(f"{picture}: expected a picture that osgwaterbench wrote, got none")


def make(data_directory: Path, output: Path) -> tuple[str, dict[Path, str]]:
    """The document, and the plots' scripts by file."""
    data = BenchData(data_directory)
    gpu = BenchData(data_directory / "gpu", partial=True)
    check_pictures(data)
    if not data.quick:
        claims.check(data)
    link = os.path.relpath(data_directory.resolve(), output.resolve().parent)
    template = (REPORT / "template.md").read_text(encoding="utf-8")
    document = fill(template, words.placeholders(data, gpu, link), data.quick)
    scripts = {
        data_directory / "pareto.svg": plots.pareto_script(data),
        data_directory / "scaling.svg": plots.scaling_script(data),
    }
    if gpu.accuracy:
        scripts[gpu.directory / "pareto.svg"] = plots.pareto_script(gpu)
    return document, scripts


def write(document: str, scripts: dict[Path, str], output: Path) -> None:
    drawn = {file: plots.draw(script) for file, script in scripts.items()}
    for file, svg in drawn.items():
        file.write_text(svg, encoding="utf-8")
    output.write_text(document, encoding="utf-8")
    print(f"written: {output}, {', '.join(str(file) for file in drawn)}")


def check(document: str, scripts: dict[Path, str], output: Path) -> None:
    """Without gnuplot: plots carry the mark of their script."""
    def text(file: Path) -> str:
        return file.read_text(encoding="utf-8") if file.exists() else ""

    stale = [file for file, script in scripts.items() if plots.mark(script) not in text(file)]
    if text(output) != document:
        stale.append(output)
    if stale:
        names = ", ".join(str(file) for file in stale)
        raise DataError(f"{names}: expected what the data give, got another: run make_report.py")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("data", type=Path, nargs="?", default=DOCS / "accuracy", metavar="DATA_DIR")
    parser.add_argument(
        "output", type=Path, nargs="?", default=DOCS / "accuracy.md", metavar="OUTPUT.md"
    )
    parser.add_argument(
        "--check", action="store_true", help="write nothing; fail where files are out of date"
    )
    arguments = parser.parse_args()
    try:
        document, scripts = make(arguments.data, arguments.output)
        act = check if arguments.check else write
        act(document, scripts, arguments.output)
    except DataError as error:
        print(f"make_report.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
