"""What the template says in words, checked against the data: a claim that does not hold stops the
report, until either the words or the data are mended."""

from __future__ import annotations

from itertools import pairwise

import bench_data as bench
import derived
import tables
from bench_data import BenchData, DataError, right_percent
from derived import mean_right, of_scenes, relative_cost

WITH_BRANCH = ("branch", "boxes-branch")
STRIDES = (bench.SEQUENTIAL, "sequential, stride 2", "sequential, stride 4", "sequential, stride 8")
THICKNESSES = ("hierarchical, thickness 0.1", bench.DEFAULT, "hierarchical, thickness 2.0")
MOST_GAIN = 1.0  # [percentage points] what "no other setting" may gain on the default
SAME_RIGHT = 0.05  # [percentage points] up to which two searches find the same


def right(data: BenchData, method: str, slope: float = bench.MAIN_SLOPE) -> float:
    return mean_right(of_scenes(data, data.accuracy, method, slope))


def rival_right(data: BenchData, method: str, slope: float = bench.MAIN_SLOPE) -> float:
    return mean_right(of_scenes(data, data.rivals, method, slope))


def cost(data: BenchData, method: str) -> float:
    defaults = of_scenes(data, data.accuracy, bench.DEFAULT)
    return relative_cost(of_scenes(data, data.accuracy, method), defaults)


def rises(values: list[float]) -> bool:
    return all(a <= b for a, b in pairwise(values))


def falls(values: list[float]) -> bool:
    return rises(values[::-1])


def moving(data: BenchData) -> list[float]:
    return [slope for slope in data.slopes if slope != bench.CALM]


def default_is_best(data: BenchData) -> bool:
    best = max(right(data, method) for method in tables.ADVICE)
    return best <= right(data, bench.DEFAULT) + MOST_GAIN


def longer_strides_trade(data: BenchData) -> bool:
    return falls([right(data, method) for method in STRIDES]) and falls(
        [cost(data, method) for method in STRIDES]
    )


def hierarchical_finds_the_same(data: BenchData) -> bool:
    """In every scene and on all waves, and for less."""
    same = all(
        abs(right_percent(own) - right_percent(other)) <= SAME_RIGHT
        for slope in data.slopes
        for own, other in zip(
            of_scenes(data, data.accuracy, bench.DEFAULT, slope),
            of_scenes(data, data.accuracy, bench.SEQUENTIAL, slope),
            strict=True,
        )
    )
    return same and cost(data, bench.SEQUENTIAL) > 1.0


def default_costs_no_more_than_long_strides(data: BenchData) -> bool:
    return cost(data, "sequential, stride 4") > 1.0


def binary_misses(data: BenchData) -> bool:
    return right(data, bench.BINARY) < right(data, bench.DEFAULT)


def thickness_trades(data: BenchData) -> bool:
    rows = [of_scenes(data, data.accuracy, method) for method in THICKNESSES]
    branch = [tables.main_row(data, "branch", method) for method in THICKNESSES]
    return falls([derived.pooled_outcome(r, "visible", "missed") for r in rows]) and rises(
        [bench.outcome_percent(row, "sky", "false_hit") for row in branch]
    )


def smaller_captures_are_cheaper(data: BenchData) -> bool:
    scales = ("hierarchical, capture scale 0.50", "hierarchical, capture scale 0.25")
    return falls([cost(data, method) for method in (bench.DEFAULT, *scales)])


def paper_is_less_right(data: BenchData) -> bool:
    return all(
        rival_right(data, "paper", slope) < rival_right(data, bench.DEFAULT, slope)
        for slope in data.slopes
    )


def paper_fails_behind_a_branch(data: BenchData) -> bool:
    """By ten points at least."""
    return all(
        right_percent(tables.main_row(data, scene, "paper")) + 10.0
        < right_percent(tables.main_row(data, scene, bench.DEFAULT))
        for scene in WITH_BRANCH
    )


def mirror_is_unbeaten_when_calm(data: BenchData) -> bool:
    return all(
        rival_right(data, bench.MIRROR, bench.CALM) >= rival_right(data, method, bench.CALM)
        for method in bench.RIVALS
    )


def trace_beats_mirror_on_waves(data: BenchData) -> bool:
    return all(
        rival_right(data, bench.DEFAULT, slope) > rival_right(data, bench.MIRROR, slope)
        for slope in moving(data)
    )


def mirror_hits_are_farther_off(data: BenchData) -> bool:
    def median_error(method: str) -> float:
        rows = of_scenes(data, data.rivals, method)
        return derived.median_of(rows, "hit_error_px.median")

    return median_error(bench.MIRROR) > median_error(bench.DEFAULT)


def mirror_sees_what_the_picture_lacks(data: BenchData) -> bool:
    """On calm water nearly all of it, and rightly."""

    def shown(method: str, slope: float) -> float:
        rows = of_scenes(data, data.rivals, method, slope)
        return derived.pooled_right(rows, bench.NOT_IN_IMAGE)

    return shown(bench.MIRROR, bench.CALM) > 90.0 and all(
        shown(bench.MIRROR, slope) > shown(bench.DEFAULT, slope)
        for slope in (bench.CALM, bench.MAIN_SLOPE)
    )


def exponents_are_as_expected(data: BenchData) -> bool:
    def trace(method: str) -> float:
        return tables.table1_exponent(data, bench.CALM, method, "trace_ms")

    def frame(method: str) -> float:
        return tables.table1_exponent(data, bench.CALM, method, "frame_ms")

    methods = (bench.DEFAULT, bench.SEQUENTIAL, bench.BINARY)
    return (
        abs(trace(bench.SEQUENTIAL) - 1.5) <= 0.1
        and trace(bench.DEFAULT) < trace(bench.SEQUENTIAL)
        and trace(bench.BINARY) < trace(bench.SEQUENTIAL)
        and all(frame(method) < trace(method) for method in methods)
    )


CLAIMS = {
    "no other setting is right in more pixels by over one point": default_is_best,
    "longer strides cost less and are less right": longer_strides_trade,
    "the hierarchical search finds the same as the sequential, for less": hierarchical_finds_the_same,
    "a stride of 4 costs more than the default": default_costs_no_more_than_long_strides,
    "the binary search is less right than the default": binary_misses,
    "the mirrored camera's hits are farther off than the trace's": mirror_hits_are_farther_off,
    "thicker: no fewer false hits on the sky (branch), no more misses": thickness_trades,
    "a smaller captured image costs less": smaller_captures_are_cheaper,
    "the paper's method is less right at every slope": paper_is_less_right,
    "the paper's method fails where something hangs ahead": paper_fails_behind_a_branch,
    "nothing beats the mirrored camera on calm water": mirror_is_unbeaten_when_calm,
    "on waves the trace is right more often than the mirrored camera": trace_beats_mirror_on_waves,
    "the mirrored camera shows more of what the picture lacks": mirror_sees_what_the_picture_lacks,
    "the sequential trace grows about as N^1.5, others less, frames less": exponents_are_as_expected,
}


def check(data: BenchData) -> None:
    broken = [words for words, holds in CLAIMS.items() if not holds(data)]
    if broken:
        listed = "".join(f"\n  {words}" for words in broken)
        raise DataError(f"{data.directory}: the text says what these data contradict:{listed}")
