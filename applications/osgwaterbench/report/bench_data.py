"""What osgwaterbench wrote: loaded, checked for completeness, and asked by row and field."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Iterable

SCENES = ("lake", "floating", "street", "branch", "boxes", "boxes-branch")
SLOPES = (0.0, 0.05, 0.1, 0.15)
CALM = 0.0
MAIN_SLOPE = 0.05  # of the main tables, the plots and the pictures

DEFAULT = "automatic"  # the library's default settings
SEARCH = "hierarchical"  # the default search, always in the view's capture with its adaptive band
MIRRORED = "hierarchical, mirror"  # in the mirrored eye's capture
BOTH = "hierarchical, both"
SEQUENTIAL = "sequential"
BINARY = "binary"
BASELINE = "baseline"
METHODS = (
    DEFAULT,
    SEARCH,
    MIRRORED,
    BOTH,
    "hierarchical, thickness 0.1",
    "hierarchical, thickness 2.0",
    "hierarchical, capture scale 0.50",
    "hierarchical, capture scale 0.25",
    "hierarchical, trace scale 0.50",
    "hierarchical, trace scale 0.25",
    SEQUENTIAL,
    "sequential, stride 2",
    "sequential, stride 4",
    "sequential, stride 8",
    BINARY,
    "paper",
    "paper-binary",
    BASELINE,
)
MIRROR = "mirror"  # a mirrored camera, whichever of its two kinds of bending was the best
BENDINGS = (MIRROR, "mirror-over-distance")
RIVALS = (DEFAULT, "paper", "paper-binary", MIRROR, "sky-only")
TABLE1_METHODS = (SEARCH, SEQUENTIAL, BINARY, "paper", "paper-binary")

# Of borders: no band where none is named.
PLAIN = "hierarchical"
FIXED_BAND = "hierarchical, band 25 %"
ADAPTIVE_BAND = "hierarchical, adaptive band"
BOTH_FIXED = "hierarchical, both, band 25 %"
BOTH_ADAPTIVE = "hierarchical, both, adaptive band"
BORDER_METHODS = (
    BASELINE,
    SEQUENTIAL,
    PLAIN,
    FIXED_BAND,
    ADAPTIVE_BAND,
    MIRRORED,
    BOTH_FIXED,
    BOTH_ADAPTIVE,
)
BORDER_SCENES = ("boxes", "boxes-branch")
BORDER_SLOPES = (0.0, 0.05, 0.15)

# Of added: the mirrored camera, then captures.
VIEW, VIEW_BAND = "view", "view, adaptive band"
FRAME, FRAME_BAND = "frame", "frame, adaptive band"
MIRRORED_CAPTURE = "mirrored capture"
ADDED_METHODS = (MIRROR, VIEW, VIEW_BAND, FRAME, FRAME_BAND, MIRRORED_CAPTURE)

VARIED = ("triangles", "waters", "corners", "pixels")
VARIED_WHEN_CALM = ("waters", "corners")  # too

CLASSES = ("sky", "visible", "hidden", "outside_top", "outside_sides")
OUTSIDE = ("outside_top", "outside_sides")
NOT_IN_IMAGE = ("hidden", *OUTSIDE)
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
    """What water adds on the rasteriser: captured or mirrored images, their pyramids, the trace."""
    return field(row, "image_ms.median") + field(row, "trace_ms.median")


def search_ms(row: Row) -> float:
    return field(row, "pyramid_ms.median") + field(row, "trace_ms.median")


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
        if row.get("method") not in BENDINGS:
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

    def sizes(self) -> list[tuple[int, int]]:
        """[pixels] Those that occur, in the order of the file."""
        return list(dict.fromkeys((row["width"], row["height"]) for row in self.rows))


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
        self.borders = load("borders")
        self.added = load("added")
        self.table1 = load("table1")
        self.scaling = load("scaling")
        self.quick = any(experiment.quick for experiment in self.experiments)
        self._partial = partial or self.quick
        self._check_rows()

    @property
    def experiments(self) -> list[Experiment]:
        every = (
            self.accuracy,
            self.rivals,
            self.borders,
            self.table1,
            self.scaling,
            self.added,
        )
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

    @property
    def border_slopes(self) -> tuple[float, ...]:
        return self.borders.values("slope") if self._partial else BORDER_SLOPES

    def _found(self, key: str, expected: tuple) -> tuple:
        if not self._partial:
            return expected
        experiment = self.accuracy or self.rivals
        return experiment.values(key) if experiment else ()

    def _check_rows(self) -> None:
        if self.accuracy:
            self._check_grid(self.accuracy, self.methods)
        if self.rivals:
            self._check_grid(self.rivals, RIVALS)
        if self.borders:
            self._check_borders()
        if self.added:
            self._check_added()
        if self.table1:
            self._check_table1()
        if self.scaling:
            self._check_scaling()

    def _check_grid(self, experiment: Experiment, methods: Iterable[str]) -> None:
        for scene in self.scenes:
            for slope in self.slopes:
                for method in methods:
                    experiment.row(scene=scene, slope=slope, method=method)

    def _check_borders(self) -> None:
        for scene in BORDER_SCENES:
            for slope in self.border_slopes:
                for width, height in self.borders.sizes():
                    for method in BORDER_METHODS:
                        self.borders.row(
                            scene=scene, slope=slope, width=width, height=height, method=method
                        )

    def _check_added(self) -> None:
        for triangles in self.added.values("triangles"):
            self.added.row(triangles=triangles, method=None)
            for slope in (CALM, MAIN_SLOPE):
                for method in ADDED_METHODS:
                    self.added.row(triangles=triangles, slope=slope, method=method)

    def _check_table1(self) -> None:
        for slope in (CALM, MAIN_SLOPE):
            for width, height in self.table1.sizes():
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
