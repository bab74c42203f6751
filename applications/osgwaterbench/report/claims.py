"""What the template says in words, checked against the data: a claim that does not hold stops the
report, until either the words or the data are mended."""

from __future__ import annotations

from itertools import pairwise

import bench_data as bench
import derived
import tables
from bench_data import BenchData, DataError, right_percent
from derived import mean_right, of_borders, of_scenes, relative_cost

WITH_BRANCH = ("branch", "boxes-branch")
STRIDES = (bench.SEQUENTIAL, "sequential, stride 2", "sequential, stride 4", "sequential, stride 8")
THICKNESSES = ("hierarchical, thickness 0.1", bench.SEARCH, "hierarchical, thickness 2.0")
CAPTURE_SCALES = (
    bench.SEARCH,
    "hierarchical, capture scale 0.50",
    "hierarchical, capture scale 0.25",
)
TRACE_SCALES = (bench.SEARCH, "hierarchical, trace scale 0.50", "hierarchical, trace scale 0.25")
MOST_GAIN = 1.0  # [percentage points] what "no other setting" may gain on the default
ALIKE_RIGHT = 0.2  # [percentage points] up to which two mirrored images are right alike
SAME_RIGHT = 0.05  # [percentage points] up to which two searches find the same


def right(data: BenchData, method: str, slope: float = bench.MAIN_SLOPE) -> float:
    return mean_right(of_scenes(data, data.accuracy, method, slope))


def rival_right(data: BenchData, method: str, slope: float = bench.MAIN_SLOPE) -> float:
    return mean_right(of_scenes(data, data.rivals, method, slope))


def cost(data: BenchData, method: str) -> float:
    """That of the hierarchical search in the view's capture being 1."""
    references = of_scenes(data, data.accuracy, bench.SEARCH)
    return relative_cost(of_scenes(data, data.accuracy, method), references)


def rises(values: list[float]) -> bool:
    return all(a <= b for a, b in pairwise(values))


def falls(values: list[float]) -> bool:
    return rises(values[::-1])


def moving(data: BenchData) -> list[float]:
    return [slope for slope in data.slopes if slope != bench.CALM]


def default_is_best_but_for_both(data: BenchData) -> bool:
    others = [method for method in tables.ADVICE if method != bench.BOTH]
    return all(
        max(right(data, method, slope) for method in others)
        <= right(data, bench.DEFAULT, slope) + MOST_GAIN
        for slope in data.slopes
    )


def default_is_mirrored_when_calm(data: BenchData) -> bool:
    """In every scene as right as the mirrored capture."""
    pairs = zip(
        of_scenes(data, data.accuracy, bench.DEFAULT, bench.CALM),
        of_scenes(data, data.accuracy, bench.MIRRORED, bench.CALM),
        strict=True,
    )
    return all(abs(right_percent(a) - right_percent(b)) <= SAME_RIGHT for a, b in pairs)


def mirrored_capture_is_best_when_calm(data: BenchData) -> bool:
    best = right(data, bench.MIRRORED, bench.CALM)
    return all(right(data, method, bench.CALM) <= best for method in tables.ADVICE)


def view_beats_mirrored_capture_on_waves(data: BenchData) -> bool:
    return all(
        right(data, bench.SEARCH, slope) > right(data, bench.MIRRORED, slope)
        for slope in moving(data)
    )


def view_costs_less_than_both(data: BenchData) -> bool:
    return cost(data, bench.BOTH) > 1.0


def both_beat_the_view_behind_a_branch(data: BenchData) -> bool:
    """On calm water and on waves, by a point at least."""
    return all(
        right_percent(data.accuracy.row(scene=scene, slope=slope, method=bench.BOTH))
        >= right_percent(data.accuracy.row(scene=scene, slope=slope, method=bench.SEARCH)) + 1.0
        for scene in WITH_BRANCH
        for slope in data.slopes
    )


def both_show_more_of_what_the_picture_lacks(data: BenchData) -> bool:
    def shown(method: str, slope: float) -> float:
        rows = of_scenes(data, data.accuracy, method, slope)
        return derived.pooled_right(rows, bench.NOT_IN_IMAGE)

    return all(shown(bench.BOTH, slope) > shown(bench.SEARCH, slope) for slope in data.slopes)


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
            of_scenes(data, data.accuracy, bench.SEARCH, slope),
            of_scenes(data, data.accuracy, bench.SEQUENTIAL, slope),
            strict=True,
        )
    )
    return same and cost(data, bench.SEQUENTIAL) > 1.0


def hierarchical_costs_less_than_long_strides(data: BenchData) -> bool:
    return cost(data, "sequential, stride 4") > 1.0


def binary_misses(data: BenchData) -> bool:
    return right(data, bench.BINARY) < right(data, bench.SEARCH)


def thickness_trades(data: BenchData) -> bool:
    rows = [of_scenes(data, data.accuracy, method) for method in THICKNESSES]
    branch = [tables.main_row(data, "branch", method) for method in THICKNESSES]
    return falls([derived.pooled_outcome(r, "visible", "missed") for r in rows]) and rises(
        [bench.outcome_percent(row, "sky", "false_hit") for row in branch]
    )


def smaller_captures_are_cheaper(data: BenchData) -> bool:
    return falls([cost(data, method) for method in CAPTURE_SCALES])


def fewer_traced_pixels_trade(data: BenchData) -> bool:
    def fetches(method: str) -> float:
        return derived.median_of(of_scenes(data, data.accuracy, method), "fetches")

    return falls([fetches(method) for method in TRACE_SCALES]) and falls(
        [right(data, method) for method in TRACE_SCALES]
    )


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


def mirror_and_default_are_alike_when_calm(data: BenchData) -> bool:
    mirror, default = (
        rival_right(data, method, bench.CALM) for method in (bench.MIRROR, bench.DEFAULT)
    )
    return abs(mirror - default) <= ALIKE_RIGHT


def default_beats_mirror_on_waves(data: BenchData) -> bool:
    return all(
        rival_right(data, bench.DEFAULT, slope) > rival_right(data, bench.MIRROR, slope)
        for slope in moving(data)
    )


def mirror_hits_are_farther_off(data: BenchData) -> bool:
    def median_error(method: str) -> float:
        rows = of_scenes(data, data.rivals, method)
        return derived.median_of(rows, "hit_error_px.median")

    return median_error(bench.MIRROR) > median_error(bench.DEFAULT)


# --- Borders ----------------------------------------------------------------------------------


def border_shown(
    data: BenchData, method: str, classes: tuple[str, ...], size: tuple[int, int]
) -> float:
    """[%] of classes shown rightly, at the main slope."""
    return derived.pooled_right(of_borders(data, method, bench.MAIN_SLOPE, size), classes)


def bands_show_what_lies_outside(data: BenchData) -> bool:
    return all(
        border_shown(data, band, bench.OUTSIDE, size)
        > border_shown(data, bench.PLAIN, bench.OUTSIDE, size)
        for band in (bench.FIXED_BAND, bench.ADAPTIVE_BAND)
        for size in data.borders.sizes()
    )


def only_mirrored_eyes_see_behind(data: BenchData) -> bool:
    return all(
        border_shown(data, method, ("hidden",), size)
        > border_shown(data, bench.ADAPTIVE_BAND, ("hidden",), size)
        for method in (bench.MIRRORED, bench.BOTH_ADAPTIVE)
        for size in data.borders.sizes()
    )


def both_are_more_right_than_either(data: BenchData) -> bool:
    """On waves, in the mean of the scenes."""

    def right_at(method: str, slope: float, size: tuple[int, int]) -> float:
        return mean_right(of_borders(data, method, slope, size))

    return all(
        right_at(bench.BOTH_ADAPTIVE, slope, size) > right_at(method, slope, size)
        for method in (bench.ADAPTIVE_BAND, bench.MIRRORED)
        for slope in data.border_slopes
        if slope != bench.CALM
        for size in data.borders.sizes()
    )


def search_grows_less_than_the_plainest(data: BenchData) -> bool:
    plain, baseline = (
        tables.border_exponent(data, bench.CALM, method)
        for method in (bench.PLAIN, bench.BASELINE)
    )
    return plain < baseline


# --- What water adds to a frame ---------------------------------------------------------------


def added_at_most_triangles(data: BenchData, method: str, slope: float) -> float:
    """The mirrored camera's being 1."""
    most = max(data.added.values("triangles"))
    return tables.added_over_mirror(data, most, slope, method)


def copied_frame_is_cheapest_when_heavy(data: BenchData) -> bool:
    """Without a band: it adds less than the view's capture and than a mirrored camera."""
    return all(
        added_at_most_triangles(data, bench.FRAME, slope)
        < added_at_most_triangles(data, method, slope)
        for method in (bench.MIRROR, bench.VIEW, bench.VIEW_BAND)
        for slope in (bench.CALM, bench.MAIN_SLOPE)
    )


def band_of_a_copied_frame_costs(data: BenchData) -> bool:
    """On waves."""
    with_band, without = (
        added_at_most_triangles(data, method, bench.MAIN_SLOPE)
        for method in (bench.FRAME_BAND, bench.FRAME)
    )
    return with_band > without


# --- Table 1 ----------------------------------------------------------------------------------


def exponents_are_as_expected(data: BenchData) -> bool:
    def trace(method: str) -> float:
        return tables.table1_exponent(data, bench.CALM, method, "trace_ms")

    def frame(method: str) -> float:
        return tables.table1_exponent(data, bench.CALM, method, "frame_ms")

    methods = (bench.SEARCH, bench.SEQUENTIAL, bench.BINARY)
    return (
        abs(trace(bench.SEQUENTIAL) - 1.5) <= 0.1
        and trace(bench.SEARCH) < trace(bench.SEQUENTIAL)
        and trace(bench.BINARY) < trace(bench.SEQUENTIAL)
        and all(frame(method) < trace(method) for method in methods)
    )


CLAIMS = {
    "no setting but both captures is right in more pixels by over one point": (
        default_is_best_but_for_both
    ),
    "the default is as right as the mirrored capture on calm water": default_is_mirrored_when_calm,
    "nothing beats the mirrored capture on calm water": mirrored_capture_is_best_when_calm,
    "on waves the view's capture is right more often than the mirrored one": (
        view_beats_mirrored_capture_on_waves
    ),
    "the view's capture costs less than both": view_costs_less_than_both,
    "both captures are right more often behind a branch": both_beat_the_view_behind_a_branch,
    "both captures show more of what the picture lacks": both_show_more_of_what_the_picture_lacks,
    "longer strides cost less and are less right": longer_strides_trade,
    "the hierarchical search finds the same as the sequential, for less": (
        hierarchical_finds_the_same
    ),
    "a stride of 4 costs more than the hierarchical search": (
        hierarchical_costs_less_than_long_strides
    ),
    "the binary search is less right than the hierarchical": binary_misses,
    "the mirrored camera's hits are farther off than the default's": mirror_hits_are_farther_off,
    "thicker: no fewer false hits on the sky (branch), no more misses": thickness_trades,
    "a smaller captured image costs less": smaller_captures_are_cheaper,
    "fewer traced pixels take fewer fetches and are less right": fewer_traced_pixels_trade,
    "the paper's method is less right at every slope": paper_is_less_right,
    "the paper's method fails where something hangs ahead": paper_fails_behind_a_branch,
    "the mirrored camera and the default are right alike on calm water": (
        mirror_and_default_are_alike_when_calm
    ),
    "on waves the default is right more often than the mirrored camera": (
        default_beats_mirror_on_waves
    ),
    "a guard band shows more of what lies outside": bands_show_what_lies_outside,
    "the mirrored eye shows more of what is hidden than a band": only_mirrored_eyes_see_behind,
    "on waves both captures are more right than either": both_are_more_right_than_either,
    "on calm water the search grows less than the plainest": search_grows_less_than_the_plainest,
    "a copied frame adds the least to a heavy frame": copied_frame_is_cheapest_when_heavy,
    "a copied frame's band costs, on waves": band_of_a_copied_frame_costs,
    "the sequential trace grows about as N^1.5, others less, frames less": exponents_are_as_expected,
}


def check(data: BenchData) -> None:
    broken = [words for words, holds in CLAIMS.items() if not holds(data)]
    if broken:
        listed = "".join(f"\n  {words}" for words in broken)
        raise DataError(f"{data.directory}: the text says what these data contradict:{listed}")
