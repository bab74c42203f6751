"""The figures and sentences that the template asks for, by name."""

from __future__ import annotations

from typing import Callable

import bench_data as bench
import derived
import plots
import rounding
import tables
from bench_data import BenchData, Row, field, right_percent
from derived import mean_right, median_of, of_borders, of_scenes

# How much a time may differ between the smallest and the largest and still count as the same: what
# caches, clocks and a shared machine make of it.
SAME_FACTOR = 1.15
NEARLY_SAME_FACTOR = 1.5


def rows_of(data: BenchData, method: str, slope: float = bench.MAIN_SLOPE) -> list[Row]:
    return of_scenes(data, data.accuracy, method, slope)


def rivals_of(data: BenchData, method: str, slope: float = bench.MAIN_SLOPE) -> list[Row]:
    return of_scenes(data, data.rivals, method, slope)


def cost_of(data: BenchData, method: str) -> str:
    """That of the hierarchical search in the view's capture being 1."""
    cost = derived.relative_cost(rows_of(data, method), rows_of(data, bench.SEARCH))
    return rounding.factor(cost)


def rival_cost_of(data: BenchData, method: str) -> str:
    """The default's being 1."""
    cost = derived.relative_cost(rivals_of(data, method), rivals_of(data, bench.DEFAULT))
    return rounding.factor(cost)


def loss_of(data: BenchData, method: str) -> str:
    """[percentage points] of the hierarchical search in the view's capture."""
    difference = mean_right(rows_of(data, method)) - mean_right(rows_of(data, bench.SEARCH))
    return rounding.points(difference)


def missed(data: BenchData, method: str) -> str:
    return rounding.percent(derived.pooled_outcome(rows_of(data, method), "visible", "missed"))


def branch_false(data: BenchData, method: str) -> str:
    row = tables.main_row(data, "branch", method)
    return rounding.percent(bench.outcome_percent(row, "sky", "false_hit"))


def scene_right(data: BenchData, scene: str, method: str) -> str:
    return rounding.percent(right_percent(tables.main_row(data, scene, method)))


def median_cost(data: BenchData) -> str:
    costs = [bench.cost_ms(row) for row in rows_of(data, bench.DEFAULT)]
    return rounding.milliseconds(derived.median(costs))


def outside_share(data: BenchData) -> str:
    rows = rows_of(data, bench.DEFAULT)
    return rounding.percent(derived.mean([plots.not_in_image_percent(row) for row in rows]))


def lacking_right(rows: list[Row]) -> str:
    """[%] of the pixels whose truth the picture does not hold: those that are right."""
    return rounding.percent(derived.pooled_right(rows, bench.NOT_IN_IMAGE))


def lacking_of_wrong(rows: list[Row]) -> str:
    """[%] of the pixels that are not right: whose truth the picture does not hold."""
    lacking = sum(wrong_pixels(row, bench.NOT_IN_IMAGE) for row in rows)
    return rounding.percent(bench.share(lacking, sum(wrong_pixels(row) for row in rows)))


def wrong_pixels(row: Row, classes: tuple[str, ...] = bench.CLASSES) -> int:
    return bench.pixels(row, classes) - bench.pixels(row, classes, "correct")


def scenes_of_both(data: BenchData) -> int:
    """In how many the default does what both captures do, and the view's alone does not."""
    defaults, both, view = (
        rows_of(data, method) for method in (bench.DEFAULT, bench.BOTH, bench.SEARCH)
    )
    return sum(
        own["classes"] == two["classes"] != one["classes"]
        for own, two, one in zip(defaults, both, view, strict=True)
    )


def size(conditions: dict) -> str:
    return f"{conditions['width']}x{conditions['height']}"


def enumeration(names: list[str]) -> str:
    return ", ".join(names[:-1]) + " and " + names[-1] if len(names) > 1 else "".join(names)


# --- Sentences --------------------------------------------------------------------------------


def who_wins(data: BenchData) -> str:
    traced, mirrored, literal, sky = (
        rivals_of(data, method) for method in (bench.DEFAULT, bench.MIRROR, "paper", "sky-only")
    )
    more_right = [
        own["scene"]
        for own, other in zip(traced, mirrored, strict=True)
        if right_percent(own) > right_percent(other)
    ]
    nearer = [
        own["scene"]
        for own, other in zip(traced, mirrored, strict=True)
        if field(other, "picture.rmse_8bit") < field(own, "picture.rmse_8bit")
    ]
    lacking = [lacking_right(rows) for rows in (mirrored, traced)]
    offsets = [
        rounding.offset_pixels(median_of(rows, "hit_error_px.median"))
        for rows in (mirrored, traced, literal)
    ]
    calm = [
        rounding.percent(mean_right(rivals_of(data, method, bench.CALM)))
        for method in (bench.MIRROR, bench.DEFAULT)
    ]
    slope = rounding.slope(bench.MAIN_SLOPE)
    return (
        f"On calm water the mirrored camera is right in {calm[0]} % of the pixels in the mean of "
        f"the scenes, the default, which looks in a mirrored image there, too, in {calm[1]} %. On "
        f"waves of slope {slope} the default is right in more pixels in {len(more_right)} of "
        f"{len(traced)} scenes; half of the mirrored camera's hits are {offsets[0]} pixels or more "
        f"off, of the default's {offsets[1]}, of the paper's {offsets[2]}, for one image cannot be "
        f"bent rightly for near and far things at once. Of what the picture lacks the mirrored "
        f"camera shows {lacking[0]} % rightly, the default {lacking[1]} %; the mirrored camera's "
        f"picture has the smaller RMSE in {enumeration(nearer) or 'none of the scenes'}. The sky "
        f"alone is right wherever there is nothing else to reflect, which is "
        f"{rounding.percent(mean_right(sky))} % of the water."
    )


def verdict(data: BenchData, varied: str, what: str, slope: float = bench.MAIN_SLOPE) -> str:
    rows = data.scaling.all(varied=varied, slope=slope, water=True)
    values = sorted(row["value"] for row in rows)
    spread = derived.extremes(rows, "trace_ms.median")
    holds = (
        "holds"
        if spread <= SAME_FACTOR
        else "nearly holds" if spread <= NEARLY_SAME_FACTOR else "does not hold"
    )
    image, trace, frame = (
        rounding.factor(derived.growth(rows, f"{stage}.median")) for stage in plots.STAGES
    )
    return (
        f"- **{what}**, {rounding.count(values[0])} to {rounding.count(values[-1])}: for the trace "
        f"it {holds} (its time changes by a factor of {trace}; the longest of its times is "
        f"{rounding.factor(spread)} times the shortest). The captured image's changes by {image}, "
        f"the frame's by {frame}{dry_growth(data, varied)}."
    )


def dry_growth(data: BenchData, varied: str) -> str:
    rows = data.scaling.all(varied=varied, water=False)
    if not rows:
        return ""
    return f" (without water by {rounding.factor(derived.growth(rows, 'frame_ms.median'))})"


def verdicts(data: BenchData) -> str:
    waters, corners = "Number of waters", "Shape of the water, in corners of its outline"
    lines = [
        verdict(data, "triangles", "Complexity of the scene, in triangles"),
        verdict(data, "waters", f"{waters}, when calm", bench.CALM),
        verdict(data, "waters", f"{waters}, on waves"),
        verdict(data, "corners", f"{corners}, when calm", bench.CALM),
        verdict(data, "corners", f"{corners}, on waves"),
    ]
    rows = data.scaling.all(varied="pixels", water=True)
    values = sorted(row["value"] for row in rows)
    lines.append(
        f"- **Pixels**, {rounding.count(values[0])} to {rounding.count(values[-1])}: the trace's "
        f"time changes by a factor of {rounding.factor(derived.growth(rows, 'trace_ms.median'))}, "
        f"for {rounding.factor(values[-1] / values[0])} times as many."
    )
    return "\n".join(lines)


def pictures(data: BenchData, link: str) -> str:
    parts = [
        f"Each sheet, slope {rounding.slope(bench.MAIN_SLOPE)}, shows above: truth, traced, the "
        "paper literally, the mirrored camera; below: the sky only, and the errors of the traced, "
        "the paper's and the mirrored picture. Errors are black where there are none, then red, "
        "yellow, and white from a mean difference of the channels of a quarter of their range; "
        "grey is no water."
    ]
    parts += [f"**{scene}**\n\n![{scene}]({link}/rivals-{scene}.jpg)" for scene in data.scenes]
    return "\n\n".join(parts)


def quick_note(data: BenchData) -> str:
    if not data.quick:
        return ""
    return (
        "\n> Made of a quick run, for trying: small pictures, few settings and slopes. What the "
        "text says\n> in words is not checked against it; what is not measured reads n/a.\n"
    )


def gpu_section(data: BenchData, gpu: BenchData, link: str) -> str:
    """Nothing where nothing was measured on one."""
    parts = []
    if gpu.accuracy:
        parts += [
            f"Slope {rounding.slope(bench.MAIN_SLOPE)}, {size(gpu.accuracy.conditions)}; beside it "
            "the figures from above.",
            tables.beside(data, gpu),
            f"![The same plot of the GPU]({link}/pareto.svg)",
        ]
    if gpu.borders:
        parts += ["Borders, the search's time:", tables.borders_time(gpu)]
    if gpu.added:
        parts += ["What water adds, the mirrored camera's being 1:", tables.added(gpu)]
    if gpu.table1:
        parts += ["Table 1, frames a second:", tables.table1(gpu)]
    if gpu.rivals:
        parts += ["Rivals, right pixels in percent:", tables.rivals(gpu), tables.rivals_cost(gpu)]
    if gpu.scaling:
        parts += ["Scaling, ms:", tables.scaling(gpu), verdicts(gpu)]
    if not parts:
        return ""
    return "\n\n".join(["\n## On a GPU", tables.machines(gpu, link), *parts]) + "\n"


# --- Borders, and what water adds -------------------------------------------------------------


def border_shown(data: BenchData, method: str, classes: tuple[str, ...]) -> str:
    """[%] of classes shown rightly, at the main slope and the largest size."""
    rows = of_borders(data, method, bench.MAIN_SLOPE, data.borders.sizes()[-1])
    return rounding.percent(derived.pooled_right(rows, classes))


def border_false(data: BenchData, method: str) -> str:
    """[%] of the sky, over both scenes."""
    rows = of_borders(data, method, bench.MAIN_SLOPE, data.borders.sizes()[-1])
    return rounding.percent(derived.pooled_outcome(rows, "sky", "false_hit"))


def band_price(data: BenchData, method: str, time: Callable[[Row], float]) -> str:
    """Over no band, at the main slope and the largest size."""
    size = data.borders.sizes()[-1]
    rows, references = (
        of_borders(data, name, bench.MAIN_SLOPE, size) for name in (method, bench.PLAIN)
    )
    return rounding.factor(derived.relative_time(rows, references, time))


def over_baseline(data: BenchData, slope: float, method: str) -> str:
    """The search's time at both sizes."""
    factors = [
        rounding.factor(tables.border_search(data, slope, size, method, bench.BASELINE))
        for size in data.borders.sizes()
    ]
    return enumeration(factors)


def added_factors(data: BenchData, method: str, triangles: float) -> str:
    """Over the mirrored camera's, on calm water and on waves."""
    return enumeration(
        [
            rounding.factor(tables.added_over_mirror(data, triangles, slope, method))
            for slope in (bench.CALM, bench.MAIN_SLOPE)
        ]
    )


def border_placeholders(data: BenchData) -> dict:
    outside, hidden = bench.OUTSIDE, ("hidden",)
    sizes = data.borders.sizes()

    def exponent(method: str) -> str:
        return rounding.exponent(tables.border_exponent(data, bench.CALM, method))

    def image_ms(row: Row) -> float:
        return field(row, "image_ms.median")

    return {
        "border_sizes": lambda: enumeration([tables.size_name(size) for size in sizes]),
        "border_size": lambda: tables.size_name(sizes[-1]),
        "border_plain_outside": lambda: border_shown(data, bench.PLAIN, outside),
        "border_fixed_outside": lambda: border_shown(data, bench.FIXED_BAND, outside),
        "border_band_outside": lambda: border_shown(data, bench.ADAPTIVE_BAND, outside),
        "border_mirror_outside": lambda: border_shown(data, bench.MIRRORED, outside),
        "border_both_outside": lambda: border_shown(data, bench.BOTH_ADAPTIVE, outside),
        "border_plain_hidden": lambda: border_shown(data, bench.PLAIN, hidden),
        "border_band_hidden": lambda: border_shown(data, bench.ADAPTIVE_BAND, hidden),
        "border_mirror_hidden": lambda: border_shown(data, bench.MIRRORED, hidden),
        "border_both_hidden": lambda: border_shown(data, bench.BOTH_ADAPTIVE, hidden),
        "border_band_false": lambda: border_false(data, bench.ADAPTIVE_BAND),
        "border_mirror_false": lambda: border_false(data, bench.MIRRORED),
        "border_both_false": lambda: border_false(data, bench.BOTH_ADAPTIVE),
        "fixed_band_search": lambda: band_price(data, bench.FIXED_BAND, bench.search_ms),
        "band_search": lambda: band_price(data, bench.ADAPTIVE_BAND, bench.search_ms),
        "fixed_band_image": lambda: band_price(data, bench.FIXED_BAND, image_ms),
        "band_image": lambda: band_price(data, bench.ADAPTIVE_BAND, image_ms),
        "plain_over_baseline_calm": lambda: over_baseline(data, bench.CALM, bench.PLAIN),
        "plain_over_baseline": lambda: over_baseline(data, bench.MAIN_SLOPE, bench.PLAIN),
        "band_over_baseline": lambda: over_baseline(data, bench.MAIN_SLOPE, bench.ADAPTIVE_BAND),
        "plain_exponent": lambda: exponent(bench.PLAIN),
        "baseline_exponent": lambda: exponent(bench.BASELINE),
        "borders_tables": lambda: tables.borders(data),
        "borders_slope_table": lambda: tables.borders_by_slope(data),
        "borders_time_table": lambda: tables.borders_time(data),
    }


def added_placeholders(data: BenchData) -> dict:
    triangles = data.added.values("triangles")
    least, most = min(triangles), max(triangles)
    return {
        "added_size": lambda: size(data.added.conditions),
        "least_triangles": lambda: rounding.count(least),
        "most_triangles": lambda: rounding.count(most),
        "added_view_least": lambda: added_factors(data, bench.VIEW, least),
        "added_frame_least": lambda: added_factors(data, bench.FRAME, least),
        "added_mirrored_least": lambda: added_factors(data, bench.MIRRORED_CAPTURE, least),
        "added_view_most": lambda: added_factors(data, bench.VIEW, most),
        "added_view_band_most": lambda: added_factors(data, bench.VIEW_BAND, most),
        "added_frame_most": lambda: added_factors(data, bench.FRAME, most),
        "added_frame_band_most": lambda: added_factors(data, bench.FRAME_BAND, most),
        "frame_over_dry_table": lambda: tables.frame_over_dry(data),
        "added_table": lambda: tables.added(data),
    }


# --- All of them ------------------------------------------------------------------------------


def placeholders(data: BenchData, gpu: BenchData, link: str) -> dict:
    """A function for each name in the template.

    link: from the document to the directory of the data
    """
    conditions = data.accuracy.conditions
    machine = data.accuracy.machine
    own = rows_of(data, bench.DEFAULT)
    worst = derived.worst(own)
    calm, roughest = bench.CALM, max(data.slopes)

    def mean_percent(rows: list[Row]) -> str:
        return rounding.percent(mean_right(rows))

    def exponent(method: str) -> str:
        return rounding.exponent(tables.table1_exponent(data, calm, method, "trace_ms"))

    return {
        **border_placeholders(data),
        **added_placeholders(data),
        "quick_note": lambda: quick_note(data),
        "main_slope": lambda: rounding.slope(bench.MAIN_SLOPE),
        "roughest": lambda: rounding.slope(roughest),
        "smoothest": lambda: rounding.slope(min(data.slopes)),
        "scene_count": lambda: str(len(data.scenes)),
        "size": lambda: size(conditions),
        "renderer": lambda: machine["renderer"],
        "cores": lambda: str(machine["cores"]),
        "clock": lambda: machine["clock"],
        "frames": lambda: str(conditions["frames"]),
        # how right
        "right": lambda: mean_percent(own),
        "right_calm": lambda: mean_percent(rows_of(data, bench.DEFAULT, calm)),
        "right_rough": lambda: mean_percent(rivals_of(data, bench.DEFAULT, roughest)),
        "worst_scene": lambda: worst["scene"],
        "worst_right": lambda: rounding.percent(right_percent(worst)),
        "visible_right": lambda: rounding.percent(derived.pooled_right(own, ("visible",))),
        "branch_right": lambda: scene_right(data, "branch", bench.DEFAULT),
        "outside_share": lambda: outside_share(data),
        "moving_lacking": lambda: lacking_of_wrong(own),
        "view_lacking_right": lambda: lacking_right(rows_of(data, bench.SEARCH)),
        "mirrored_lacking_right": lambda: lacking_right(rows_of(data, bench.MIRRORED)),
        "both_lacking_right": lambda: lacking_right(rows_of(data, bench.BOTH)),
        # by capture
        "mirrored_calm": lambda: mean_percent(rows_of(data, bench.MIRRORED, calm)),
        "view_calm": lambda: mean_percent(rows_of(data, bench.SEARCH, calm)),
        "view_right": lambda: mean_percent(rows_of(data, bench.SEARCH)),
        "mirrored_right": lambda: mean_percent(rows_of(data, bench.MIRRORED)),
        "both_right": lambda: mean_percent(rows_of(data, bench.BOTH)),
        "scenes_of_both": lambda: str(scenes_of_both(data)),
        "both_cost": lambda: cost_of(data, bench.BOTH),
        "boxes_branch_view": lambda: scene_right(data, "boxes-branch", bench.SEARCH),
        "boxes_branch_both": lambda: scene_right(data, "boxes-branch", bench.BOTH),
        "branch_view": lambda: scene_right(data, "branch", bench.SEARCH),
        "branch_both": lambda: scene_right(data, "branch", bench.BOTH),
        # how far off
        "hit_median": lambda: rounding.offset_pixels(median_of(own, "hit_error_px.median")),
        "hit_p99": lambda: rounding.offset_pixels(median_of(own, "hit_error_px.p99")),
        # what it costs
        "cost": lambda: median_cost(data),
        "trace": lambda: rounding.milliseconds(median_of(own, "trace_ms.median")),
        "fetches": lambda: rounding.fetches(median_of(own, "fetches")),
        "search_fetches": lambda: rounding.fetches(
            median_of(rows_of(data, bench.SEARCH), "fetches")
        ),
        "sequential_fetches": lambda: rounding.fetches(
            median_of(rows_of(data, bench.SEQUENTIAL), "fetches")
        ),
        "sequential_cost": lambda: cost_of(data, bench.SEQUENTIAL),
        "stride4_cost": lambda: cost_of(data, "sequential, stride 4"),
        "stride4_loss": lambda: loss_of(data, "sequential, stride 4"),
        "trace_scale_cost": lambda: cost_of(data, "hierarchical, trace scale 0.50"),
        "trace_scale_loss": lambda: loss_of(data, "hierarchical, trace scale 0.50"),
        "binary_cost": lambda: cost_of(data, "binary"),
        "binary_loss": lambda: loss_of(data, "binary"),
        "noise": lambda: rounding.percent(derived.middle_half_width(data.accuracy.rows)),
        # settings
        "binary_missed": lambda: missed(data, "binary"),
        "search_missed": lambda: missed(data, bench.SEARCH),
        "thin_missed": lambda: missed(data, "hierarchical, thickness 0.1"),
        "thick_missed": lambda: missed(data, "hierarchical, thickness 2.0"),
        "thin_false": lambda: branch_false(data, "hierarchical, thickness 0.1"),
        "search_false": lambda: branch_false(data, bench.SEARCH),
        "thick_false": lambda: branch_false(data, "hierarchical, thickness 2.0"),
        # rivals
        "paper_right": lambda: mean_percent(rivals_of(data, "paper")),
        "paper_cost": lambda: rival_cost_of(data, "paper"),
        "paper_branch_right": lambda: scene_right(data, "branch", "paper"),
        "mirror_right": lambda: mean_percent(rivals_of(data, bench.MIRROR)),
        "mirror_calm_right": lambda: mean_percent(rivals_of(data, bench.MIRROR, calm)),
        "mirror_rough_right": lambda: mean_percent(rivals_of(data, bench.MIRROR, roughest)),
        "mirror_cost": lambda: rival_cost_of(data, bench.MIRROR),
        "who_wins": lambda: who_wins(data),
        "pictures": lambda: pictures(data, link),
        # table 1
        "table1_scene": lambda: data.table1.conditions["scene"],
        "exponent_hierarchical": lambda: exponent(bench.SEARCH),
        "exponent_sequential": lambda: exponent(bench.SEQUENTIAL),
        "exponent_binary": lambda: exponent("binary"),
        "paper_exponent": lambda: rounding.exponent(tables.paper_exponent()),
        # scaling
        "scaling_triangles": lambda: rounding.count(data.scaling.conditions["triangles"]),
        "scaling_slope": lambda: rounding.slope(bench.MAIN_SLOPE),
        "scaling_size": lambda: size(data.scaling.conditions),
        "scaling_verdicts": lambda: verdicts(data),
        # tables and plots
        "summary_table": lambda: tables.summary(data),
        "advice_table": lambda: tables.advice(data),
        "machine_table": lambda: tables.machines(data, link),
        "accuracy_tables": lambda: tables.accuracy(data),
        "slope_table": lambda: tables.by_slope(data),
        "class_table": lambda: tables.by_class(data),
        "search_table": lambda: tables.search_error(data),
        "tessellation_table": lambda: tables.tessellation(data),
        "table1": lambda: tables.table1(data),
        "rivals_table": lambda: tables.rivals(data),
        "rivals_class_table": lambda: tables.rivals_by_class(data),
        "rivals_cost_table": lambda: tables.rivals_cost(data),
        "scaling_table": lambda: tables.scaling(data),
        "pareto_plot": lambda: f"{link}/pareto.svg",
        "scaling_plot": lambda: f"{link}/scaling.svg",
        "gpu_section": lambda: gpu_section(data, gpu, f"{link}/gpu"),
    }
