"""Figures computed over rows: means over scenes, ratios, exponents, growth."""

from __future__ import annotations

import math
import statistics
from typing import Callable

import bench_data as bench
from bench_data import BenchData, Experiment, Row, cost_ms, field

# Table 1 of Li and Luo, on a GeForce 8800 GTX: frames a second by size in pixels.
PAPER_FRAMES = {
    (640, 480): 62.5,
    (800, 600): 31.25,
    (1024, 768): 15.87,
    (1400, 1050): 6.41,
}


def of_scenes(
    data: BenchData, experiment: Experiment, method: str, slope: float = bench.MAIN_SLOPE
) -> list[Row]:
    return [experiment.row(scene=scene, slope=slope, method=method) for scene in data.scenes]


def of_borders(data: BenchData, method: str, slope: float, size: tuple[int, int]) -> list[Row]:
    """One for each scene."""
    width, height = size
    return [
        data.borders.row(scene=scene, slope=slope, width=width, height=height, method=method)
        for scene in bench.BORDER_SCENES
    ]


def mean(values: list[float]) -> float:
    return statistics.fmean(values)


def median(values: list[float]) -> float:
    return statistics.median(values)


def mean_right(rows: list[Row]) -> float:
    """[%] every scene counts the same."""
    return mean([bench.right_percent(row) for row in rows])


def pooled_right(rows: list[Row], classes: tuple[str, ...]) -> float | None:
    """[%] every pixel counts the same: a class may be empty in a scene."""
    right = sum(bench.pixels(row, classes, "correct") for row in rows)
    return bench.share(right, sum(bench.pixels(row, classes) for row in rows))


def pooled_outcome(rows: list[Row], name: str, outcome: str) -> float | None:
    counted = sum(bench.pixels(row, (name,), outcome) for row in rows)
    return bench.share(counted, sum(bench.pixels(row, (name,)) for row in rows))


def worst(rows: list[Row]) -> Row:
    return min(rows, key=bench.right_percent)


def median_of(rows: list[Row], path: str) -> float | None:
    """Over scenes."""
    values = [field(row, path) for row in rows]
    values = [value for value in values if value is not None]
    return statistics.median(values) if values else None


def relative_cost(rows: list[Row], references: list[Row]) -> float:
    return relative_time(rows, references, cost_ms)


def relative_time(rows: list[Row], references: list[Row], time: Callable[[Row], float]) -> float:
    """Geometric mean over scenes of a time, the reference's being 1."""
    ratios = [time(row) / time(other) for row, other in zip(rows, references, strict=True)]
    return statistics.geometric_mean(ratios)


def exponent(sizes: list[tuple[int, int]], times: list[float]) -> float:
    """Of the power law of time in the number of pixels: least squares of the logarithms."""
    x = [math.log(width * height) for width, height in sizes]
    y = [math.log(time) for time in times]
    return statistics.linear_regression(x, y).slope


def growth(rows: list[Row], path: str) -> float:
    """From the smallest to the largest of what is varied."""
    rows = sorted(rows, key=lambda row: row["value"])
    return field(rows[-1], path) / field(rows[0], path)


def extremes(rows: list[Row], path: str) -> float:
    """The largest over the smallest."""
    values = [field(row, path) for row in rows]
    return max(values) / min(values)


def middle_half_width(rows: list[Row]) -> float:
    """[%] of the median: how wide the middle half of a point's trace times is, in the median."""
    widths = [row["trace_ms"]["p75"] - row["trace_ms"]["p25"] for row in rows]
    medians = [row["trace_ms"]["median"] for row in rows]
    return statistics.median(100.0 * width / m for width, m in zip(widths, medians, strict=True))
