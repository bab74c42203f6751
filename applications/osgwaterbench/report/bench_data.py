"""What osgwaterbench wrote: loaded, checked for completeness, and asked by row and field."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Iterable

SCENES = ("lake", "floating", "street", "branch", "boxes", "boxes-branch")
SLOPES = (0.0, 0.05, 0.1, 0.15)
CALM = 0.0
MAIN_SLOPE = 0.05  # of the main tables, the plots and the pictures

DEFAULT = "hierarchical"
SEQUENTIAL = "sequential"
BINARY = "binary"
METHODS = (
    DEFAULT,
    "hierarchical, thickness 0.1",
    "hierarchical, thickness 2.0",
    "hierarchical, capture scale 0.50",
    "hierarchical, capture scale 0.25",
    SEQUENTIAL,
    "sequential, stride 2",
    "sequential, stride 4",
    "sequential, stride 8",
    BINARY,
    "paper",
    "paper-binary",
    "baseline",
)
MIRROR = "mirror"  # whichever of its two kinds of bending was the best
RIVALS = (DEFAULT, "paper", "paper-binary", MIRROR, "sky-only")
TABLE1_METHODS = (DEFAULT, SEQUENTIAL, BINARY, "paper", "paper-binary")
VARIED = ("triangles", "waters", "corners", "pixels")
VARIED_WHEN_CALM = ("waters", "corners")  # too

CLASSES = ("sky", "visible", "hidden", "outside_top", "outside_sides")
NOT_IN_IMAGE = ("hidden", "outside_top", "outside_sides")
OUTCOMES = ("correct", "misplaced", "missed", "false_hit")

Row = dict[str, Any]


class DataError(Exception):
    """The data lack something, or contradict the text."""


class MissingRow(DataError):
    """A row that only a full run has may be missing from a quick one."""


def field(row: Row, path: str) -> Any:
    """A value such as trace_ms.median; None where it or what holds it is null."""
    value: Any = row
    for key in path.split("."):
        if value is None:
            return None
        if key not in value:
            raise DataError(f"expected the field {path} in a row, got {sorted(row)}")
        value = value[key]
    return value


def cost_ms(row: Row) -> float:
    """What water adds on the rasteriser: the captured or mirrored image, and the trace."""
    return field(row, "image_ms.median") + field(row, "trace_ms.median")


def pixels(row: Row, classes: Iterable[str] = CLASSES, outcome: str = "pixels") -> int:
    return sum(field(row, f"classes.{name}.{outcome}") for name in classes)


def share(part: float, whole: float) -> float | None:
    """[%] None of nothing."""
    return 100.0 * part / whole if whole else None


def right_percent(row: Row, classes: Iterable[str] = CLASSES) -> float | None:
    classes = tuple(classes)
    return share(pixels(row, classes, "correct"), pixels(row, classes))


def outcome_percent(row: Row, name: str, outcome: str) -> float | None:
    return share(pixels(row, (name,), outcome), pixels(row, (name,)))


class Experiment:
    """One file."""

    def __init__(self, file: Path):
        self.file = file
        try:
            content = json.loads(file.read_text(encoding="utf-8"))
        except FileNotFoundError:
            raise DataError(f"{file}: expected a file that osgwaterbench wrote, got none") from None
        except json.JSONDecodeError as error:
            raise DataError(f"{file}: expected JSON, got: {error}") from None
        missing = {"date", "commit", "machine", "conditions", "rows"} - content.keys()
        if missing:
            raise DataError(f"{file}: expected {', '.join(sorted(missing))}, got none")
        self.date: str = content["date"]
        self.commit: str = content["commit"]
        self.machine: dict[str, Any] = content["machine"]
        self.conditions: dict[str, Any] = content["conditions"]
        self.rows: list[Row] = [self._named(row) for row in content["rows"]]
        self.quick: bool = self.conditions["quick"]

    @staticmethod
    def _named(row: Row) -> Row:
        """The mirrored camera under one name, whichever its bending."""
        if not str(row.get("method")).startswith(MIRROR):
            return row
        return {**row, "method": MIRROR, "bending": row["method"]}

    def row(self, **keys: Any) -> Row:
        found = self.all(**keys)
        if len(found) != 1:
            wanted = ", ".join(f"{key} {value}" for key, value in keys.items())
            raise MissingRow(f"{self.file}: expected one row of {wanted}, got {len(found)}")
        return found[0]

    def all(self, **keys: Any) -> list[Row]:
        return [row for row in self.rows if all(row.get(k) == v for k, v in keys.items())]

    def values(self, key: str) -> tuple[Any, ...]:
        """Those that occur, in the order of the file."""
        return tuple(dict.fromkeys(row[key] for row in self.rows))


class BenchData:
    """All files of one machine.

    partial: what was measured there is taken as it is, which may be less than a full run; an
    experiment without a file is None
    """

    def __init__(self, directory: Path, partial: bool = False):
        def load(name: str) -> Experiment | None:
            file = directory / f"{name}.json"
            return None if partial and not file.exists() else Experiment(file)

        self.directory = directory
        self.accuracy = load("accuracy")
        self.rivals = load("rivals")
        self.table1 = load("table1")
        self.scaling = load("scaling")
        self.quick = any(experiment.quick for experiment in self.experiments)
        self._partial = partial or self.quick
        self._check_rows()

    @property
    def experiments(self) -> list[Experiment]:
        every = (self.accuracy, self.rivals, self.table1, self.scaling)
        return [experiment for experiment in every if experiment]

    @property
    def scenes(self) -> tuple[str, ...]:
        return self._found("scene", SCENES)

    @property
    def slopes(self) -> tuple[float, ...]:
        return self._found("slope", SLOPES)

    @property
    def methods(self) -> tuple[str, ...]:
        """Of accuracy."""
        return self.accuracy.values("method") if self._partial else METHODS

    def _found(self, key: str, expected: tuple) -> tuple:
        if not self._partial:
            return expected
        experiment = self.accuracy or self.rivals
        return experiment.values(key) if experiment else ()

    def sizes(self) -> list[tuple[int, int]]:
        """[pixels] of table 1."""
        return list(dict.fromkeys((row["width"], row["height"]) for row in self.table1.rows))

    def _check_rows(self) -> None:
        if self.accuracy:
            self._check_grid(self.accuracy, self.methods)
        if self.rivals:
            self._check_grid(self.rivals, RIVALS)
        if self.table1:
            self._check_table1()
        if self.scaling:
            self._check_scaling()

    def _check_grid(self, experiment: Experiment, methods: Iterable[str]) -> None:
        for scene in self.scenes:
            for slope in self.slopes:
                for method in methods:
                    experiment.row(scene=scene, slope=slope, method=method)

    def _check_table1(self) -> None:
        for slope in (CALM, MAIN_SLOPE):
            for width, height in self.sizes():
                for method in TABLE1_METHODS:
                    self.table1.row(slope=slope, width=width, height=height, method=method)

    def _check_scaling(self) -> None:
        expected = [(varied, MAIN_SLOPE) for varied in VARIED]
        expected += [(varied, CALM) for varied in VARIED_WHEN_CALM]
        for varied, slope in expected:
            if not self.scaling.all(varied=varied, slope=slope, water=True):
                raise DataError(
                    f"{self.scaling.file}: expected rows of varied {varied}, slope {slope}, got none"
                )
