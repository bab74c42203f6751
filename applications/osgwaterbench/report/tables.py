"""The document's tables, in Markdown."""

from __future__ import annotations

import bench_data as bench
import derived
import rounding
from bench_data import BenchData, Row, cost_ms, field, right_percent, search_ms
from derived import mean_right, of_borders, of_scenes

# Of the tables that cannot hold all methods.
MAIN_METHODS = (
    bench.DEFAULT,
    bench.SEARCH,
    bench.MIRRORED,
    bench.BOTH,
    "sequential, stride 4",
    bench.BINARY,
    "paper",
    bench.BASELINE,
)
SEARCHES = (  # in the view's capture
    bench.SEARCH,
    bench.SEQUENTIAL,
    "sequential, stride 4",
    bench.BINARY,
    "paper",
    "paper-binary",
    bench.BASELINE,
)
# Of borders: the view's capture without a band and with one, the mirrored eye's, and both.
BORDER_CAPTURES = (bench.PLAIN, bench.ADAPTIVE_BAND, bench.MIRRORED, bench.BOTH_ADAPTIVE)

CLASS_NAMES = {
    "sky": "sky",
    "visible": "visible",
    "hidden": "hidden",
    "outside_top": "outside, top",
    "outside_sides": "outside, sides",
}


def markdown(header: list[str], rows: list[list[str]]) -> str:
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in lines)


def main_row(data: BenchData, scene: str, method: str) -> Row:
    return data.accuracy.row(scene=scene, slope=bench.MAIN_SLOPE, method=method)


def percentiles(row: Row, path: str, write) -> str:
    return " / ".join(write(field(row, f"{path}.{name}")) for name in ("median", "p90", "p99"))


def main_methods(data: BenchData) -> list[str]:
    return [method for method in MAIN_METHODS if method in data.methods]


def size_name(size: tuple[int, int]) -> str:
    return "{}x{}".format(*size)


# --- On top -----------------------------------------------------------------------------------


def summary(data: BenchData) -> str:
    entries = [
        ("**the default** (automatic)", data.accuracy, bench.DEFAULT),
        ("the view's capture, with its band", data.accuracy, bench.SEARCH),
        ("the mirrored eye's capture", data.accuracy, bench.MIRRORED),
        ("both", data.accuracy, bench.BOTH),
        ("`traceScale` 0.5", data.accuracy, "hierarchical, trace scale 0.50"),
        ("every column in turn (sequential)", data.accuracy, bench.SEQUENTIAL),
        ("every fourth column (stride 4)", data.accuracy, "sequential, stride 4"),
        ("binary", data.accuracy, "binary"),
        ("the paper, literally", data.rivals, "paper"),
        ("the paper's binary search", data.rivals, "paper-binary"),
        ("a mirrored camera, bent", data.rivals, bench.MIRROR),
        ("the sky alone", data.rivals, "sky-only"),
    ]
    rows = []
    for name, experiment, method in entries:
        found = of_scenes(data, experiment, method)
        references = of_scenes(data, experiment, bench.DEFAULT)
        worst = derived.worst(found)
        rows.append(
            [
                name,
                rounding.percent(mean_right(found)),
                f"{rounding.percent(right_percent(worst))} ({worst['scene']})",
                calm_right(data, experiment, method),
                rounding.offset_pixels(derived.median_of(found, "hit_error_px.median")),
                rounding.steps(derived.mean([field(row, "picture.rmse_8bit") for row in found])),
                rounding.factor(derived.relative_cost(found, references)),
            ]
        )
    right = ["right, mean %", "right, worst %", "right when calm, mean %"]
    return markdown(["", *right, "hits off by, median px", "picture RMSE", "cost"], rows)


def calm_right(data: BenchData, experiment: bench.Experiment, method: str) -> str:
    if bench.CALM not in data.slopes:
        return rounding.NONE
    return rounding.percent(mean_right(of_scenes(data, experiment, method, bench.CALM)))


ADVICE = {
    bench.SEARCH: ("`CaptureKind::VIEW`", "waters in several planes"),
    bench.MIRRORED: ("`CaptureKind::MIRROR`", "calm water"),
    bench.BOTH: ("`CaptureKind::VIEW_AND_MIRROR`", "waves under boughs and bridges, steep views"),
    "hierarchical, thickness 0.1": ("`thickness` 0.1", "thin things ahead of the water"),
    "hierarchical, thickness 2.0": ("`thickness` 2", "large, deep things only"),
    "hierarchical, capture scale 0.50": ("`captureScale` 0.5", "time, in large pictures"),
    "hierarchical, capture scale 0.25": ("`captureScale` 0.25", "more time, in large pictures"),
    "hierarchical, trace scale 0.50": ("`traceScale` 0.5", "time, behind things ahead"),
    "hierarchical, trace scale 0.25": ("`traceScale` 0.25", "more time, behind things ahead"),
    bench.SEQUENTIAL: ("`Search::SEQUENTIAL`", "comparison"),
    "sequential, stride 2": ("the same, `stride` 2", "comparison"),
    "sequential, stride 4": ("the same, `stride` 4", "comparison"),
    "sequential, stride 8": ("the same, `stride` 8", "time"),
    bench.BINARY: ("`Search::BINARY`", "time, without a pyramid"),
}


def gains(data: BenchData, method: str, slope: float) -> list[tuple[float, str]]:
    """[percentage points] of right pixels over the default, with the scene."""
    found = of_scenes(data, data.accuracy, method, slope)
    defaults = of_scenes(data, data.accuracy, bench.DEFAULT, slope)
    return [
        (right_percent(row) - right_percent(default), row["scene"])
        for row, default in zip(found, defaults, strict=True)
    ]


def mean_gain(data: BenchData, method: str, slope: float) -> str:
    if slope not in data.slopes:
        return rounding.NONE
    return rounding.points(derived.mean([gain for gain, _ in gains(data, method, slope)]))


def advice(data: BenchData) -> str:
    defaults = of_scenes(data, data.accuracy, bench.DEFAULT)
    rows = []
    for method, (setting, purpose) in ADVICE.items():
        if method not in data.methods:
            continue
        changes = gains(data, method, bench.MAIN_SLOPE)
        found = of_scenes(data, data.accuracy, method)
        rows.append(
            [
                setting,
                purpose,
                mean_gain(data, method, bench.CALM),
                mean_gain(data, method, bench.MAIN_SLOPE),
                *(f"{rounding.points(c)} ({scene})" for c, scene in (min(changes), max(changes))),
                rounding.factor(derived.relative_cost(found, defaults)),
            ]
        )
    waves = f"points, slope {rounding.slope(bench.MAIN_SLOPE)}"
    header = ["setting", "for", "points, calm", waves, "where it is worst", "where it is best"]
    return markdown([*header, "cost"], rows)


# --- How it was measured ----------------------------------------------------------------------


def machines(data: BenchData, link: str) -> str:
    rows = []
    for experiment in data.experiments:
        machine = experiment.machine
        rows.append(
            [
                f"[{experiment.file.name}]({link}/{experiment.file.name})",
                experiment.date,
                f"`{experiment.commit}`",
                f"{machine['processor']}, {machine['cores']} cores",
                f"{machine['renderer']}, {machine['driver']}",
                machine["clock"],
                str(experiment.conditions["frames"]),
            ]
        )
    header = ["data", "date", "commit", "processor", "renderer", "clock", "frames a point"]
    return markdown(header, rows)


# --- Accuracy ---------------------------------------------------------------------------------


def accuracy_row(row: Row) -> list[str]:
    return [
        row["method"],
        rounding.percent(right_percent(row)),
        rounding.percent(bench.outcome_percent(row, "visible", "correct")),
        rounding.percent(bench.outcome_percent(row, "sky", "false_hit")),
        percentiles(row, "hit_error_px", rounding.offset_pixels),
        rounding.steps(field(row, "picture.rmse_8bit")),
        rounding.similarity(field(row, "picture.ssim")),
        rounding.fetches(field(row, "fetches")),
        rounding.milliseconds(field(row, "image_ms.median")),
        rounding.spread(row["trace_ms"]),
        rounding.milliseconds(field(row, "frame_ms.median")),
    ]


def accuracy(data: BenchData) -> str:
    header = [
        "method",
        "right %",
        "visible right %",
        "sky false %",
        "hit error, px: 50 / 90 / 99 %",
        "RMSE",
        "SSIM",
        "fetches",
        "image ms",
        "trace ms",
        "frame ms",
    ]
    parts = []
    for scene in data.scenes:
        rows = [main_row(data, scene, method) for method in data.methods]
        water = rounding.count(bench.pixels(rows[0]))
        parts.append(f"**{scene}**, {water} water pixels")
        parts.append(markdown(header, [accuracy_row(row) for row in rows]))
    return "\n\n".join(parts)


def by_slope(data: BenchData) -> str:
    header = ["scene", "method", *(rounding.slope(slope) for slope in data.slopes), "cost"]
    rows = []
    for scene in data.scenes:
        for method in main_methods(data):
            found = [
                data.accuracy.row(scene=scene, slope=slope, method=method) for slope in data.slopes
            ]
            rows.append(
                [
                    scene,
                    method,
                    *(rounding.percent(right_percent(row)) for row in found),
                    rounding.factor(cost_ms(found[-1]) / cost_ms(found[0])),
                ]
            )
    return markdown(header, rows)


def by_class(data: BenchData) -> str:
    others = (bench.MIRRORED, bench.BOTH, "paper")
    header = ["scene", "true class", "share"]
    header += ["automatic: right", "misplaced", "missed", "false hit"]
    rows = []
    for scene in data.scenes:
        own = main_row(data, scene, bench.DEFAULT)
        for name in bench.CLASSES:
            if not bench.pixels(own, (name,)):
                continue
            percents = [bench.share(bench.pixels(own, (name,)), bench.pixels(own))]
            percents += [bench.outcome_percent(own, name, outcome) for outcome in bench.OUTCOMES]
            percents += [right_percent(main_row(data, scene, method), (name,)) for method in others]
            rows.append([scene, CLASS_NAMES[name], *map(rounding.percent, percents)])
    return markdown(header + [f"{method}: right" for method in others], rows)


def search_error(data: BenchData) -> str:
    rows = []
    for scene in data.scenes:
        for method in SEARCHES:
            row = main_row(data, scene, method)
            behind = bench.share(field(row, "search.answered_behind"), bench.pixels(row))
            rows.append(
                [
                    scene,
                    method,
                    rounding.percent(field(row, "search.disagreed_percent")),
                    rounding.percent(behind),
                    percentiles(row, "search.error_px", rounding.offset_pixels),
                    rounding.percent(100.0 - right_percent(row)),
                ]
            )
    header = [
        "scene",
        "method",
        "disagrees, % of water",
        "of these behind, % of water",
        "error, px: 50 / 90 / 99 %",
        "beside: not the truth, % of water",
    ]
    return markdown(header, rows)


def tessellation(data: BenchData) -> str:
    rows = []
    for scene in data.scenes:
        for slope in data.slopes:
            if slope == bench.CALM:
                continue
            row = data.accuracy.row(scene=scene, slope=slope, method=bench.DEFAULT)
            rows.append(
                [
                    scene,
                    rounding.slope(slope),
                    *(
                        percentiles(row, f"tessellation.{name}", rounding.tiny)
                        for name in ("height_m", "normal_degrees", "moved_px")
                    ),
                ]
            )
    header = [
        "scene",
        "slope",
        "height, m: 50 / 90 / 99 %",
        "normal, degrees: 50 / 90 / 99 %",
        "moved, px: 50 / 90 / 99 %",
    ]
    return markdown(header, rows)


# --- Borders ----------------------------------------------------------------------------------


def border_name(method: str) -> str:
    return f"{method}, no band" if method in (bench.PLAIN, bench.SEQUENTIAL) else method


def border_right(row: Row) -> list[str]:
    """Right pixels: of all, and of the classes that a plain capture does not hold; false hits."""
    classes = (bench.CLASSES, *((name,) for name in bench.NOT_IN_IMAGE))
    return [
        *(rounding.percent(right_percent(row, names)) for names in classes),
        rounding.percent(bench.outcome_percent(row, "sky", "false_hit")),
    ]


BORDER_RIGHT = ["right %", "hidden right %", "top right %", "sides right %", "sky false %"]


def borders(data: BenchData) -> str:
    times = ("image_ms.median", "pyramid_ms.median", "trace_ms.median")
    header = ["method", *BORDER_RIGHT, "fetches", "image ms", "of it pyramid ms", "trace ms"]
    parts = []
    for size in data.borders.sizes():
        by_method = [
            of_borders(data, method, bench.MAIN_SLOPE, size) for method in bench.BORDER_METHODS
        ]
        for rows in zip(*by_method, strict=True):
            cells = [
                [
                    border_name(row["method"]),
                    *border_right(row),
                    rounding.fetches(field(row, "fetches")),
                    *(rounding.milliseconds(field(row, time) or None) for time in times),
                ]
                for row in rows
            ]
            title = f"**{rows[0]['scene']}**, {size_name(size)}"
            parts += [title, markdown(header, cells)]
    return "\n\n".join(parts)


def border_exponent(data: BenchData, slope: float, method: str) -> float:
    """Of the search's time in the number of pixels; mean over the scenes."""
    sizes = data.borders.sizes()
    by_size = [of_borders(data, method, slope, size) for size in sizes]
    times = [[search_ms(row) for row in rows] for rows in zip(*by_size, strict=True)]
    return derived.mean([derived.exponent(sizes, of_scene) for of_scene in times])


def border_search(
    data: BenchData, slope: float, size: tuple[int, int], method: str, reference: str
) -> float:
    """Time of the search, the reference's being 1."""
    rows, references = (of_borders(data, name, slope, size) for name in (method, reference))
    return derived.relative_time(rows, references, search_ms)


def borders_time(data: BenchData) -> str:
    sizes = data.borders.sizes()
    references = (bench.BASELINE, bench.PLAIN)
    rows = []
    for slope in data.border_slopes:
        for method in bench.BORDER_METHODS:
            ratios = [
                border_search(data, slope, size, method, reference)
                for reference in references
                for size in sizes
            ]
            rows.append(
                [
                    rounding.slope(slope),
                    border_name(method),
                    *map(rounding.factor, ratios),
                    rounding.exponent(border_exponent(data, slope, method)),
                ]
            )
    header = ["slope", "method"]
    for name in ("baseline", "no band"):
        header += [f"over {name}, {size_name(size)}" for size in sizes]
    return markdown([*header, "exponent"], rows)


def borders_by_slope(data: BenchData) -> str:
    size = data.borders.sizes()[-1]
    rows = []
    for slope in data.border_slopes:
        by_method = [of_borders(data, method, slope, size) for method in BORDER_CAPTURES]
        for rows_of_scene in zip(*by_method, strict=True):
            for row in rows_of_scene:
                name = border_name(row["method"])
                rows.append([rounding.slope(slope), row["scene"], name, *border_right(row)])
    return markdown(["slope", "scene", "method", *BORDER_RIGHT], rows)


# --- Table 1 ----------------------------------------------------------------------------------


def table1_rows(data: BenchData, slope: float, method: str) -> list[Row]:
    return [
        data.table1.row(slope=slope, width=width, height=height, method=method)
        for width, height in data.table1.sizes()
    ]


def table1_exponent(data: BenchData, slope: float, method: str, stage: str) -> float:
    times = [field(row, f"{stage}.median") for row in table1_rows(data, slope, method)]
    return derived.exponent(data.table1.sizes(), times)


def paper_exponent() -> float:
    sizes = list(derived.PAPER_FRAMES)
    return derived.exponent(sizes, [1000.0 / frames for frames in derived.PAPER_FRAMES.values()])


def table1(data: BenchData) -> str:
    sizes = data.table1.sizes()
    rows = []
    if sizes == list(derived.PAPER_FRAMES):
        frames = [f"{value:g}" for value in derived.PAPER_FRAMES.values()]
        exponent = rounding.exponent(paper_exponent())
        name = "the paper's own, GeForce 8800 GTX"
        rows.append([rounding.NONE, name, *frames, exponent, rounding.NONE])
    for slope in (bench.CALM, bench.MAIN_SLOPE):
        for method in bench.TABLE1_METHODS:
            found = table1_rows(data, slope, method)
            rows.append(
                [
                    "calm" if slope == bench.CALM else "moving",
                    method,
                    *(
                        rounding.frames_a_second(1000.0 / field(row, "frame_ms.median"))
                        for row in found
                    ),
                    *(
                        rounding.exponent(table1_exponent(data, slope, method, stage))
                        for stage in ("frame_ms", "trace_ms")
                    ),
                ]
            )
    names = map(size_name, sizes)
    return markdown(["water", "method", *names, "exponent, frame", "exponent, trace"], rows)


# --- Rivals -----------------------------------------------------------------------------------


def bending(row: Row) -> str:
    strength = rounding.slope(field(row, "distortion"))
    return f"{strength} *d*" if row["bending"] != bench.MIRROR else strength


def rivals(data: BenchData) -> str:
    rows = []
    for scene in data.scenes:
        for slope in data.slopes:
            cells = []
            for method in bench.RIVALS:
                row = data.rivals.row(scene=scene, slope=slope, method=method)
                cell = rounding.percent(right_percent(row))
                cells.append(f"{cell} ({bending(row)})" if method == bench.MIRROR else cell)
            rows.append([scene, rounding.slope(slope), *cells])
    return markdown(["scene", "slope", *bench.RIVALS], rows)


def rivals_by_class(data: BenchData) -> str:
    rows = []
    for slope in data.slopes:
        for method in bench.RIVALS:
            found = of_scenes(data, data.rivals, method, slope)
            rows.append(
                [
                    rounding.slope(slope),
                    method,
                    *(
                        rounding.percent(derived.pooled_right(found, classes))
                        for classes in (*((name,) for name in bench.CLASSES), bench.CLASSES)
                    ),
                ]
            )
    names = [f"{name} right %" for name in CLASS_NAMES.values()]
    return markdown(["slope", "method", *names, "all right %"], rows)


def rivals_cost(data: BenchData) -> str:
    rows = []
    for scene in data.scenes:
        for method in bench.RIVALS:
            row = data.rivals.row(scene=scene, slope=bench.MAIN_SLOPE, method=method)
            rows.append(
                [
                    scene,
                    method,
                    rounding.offset_pixels(field(row, "hit_error_px.median")),
                    rounding.steps(field(row, "picture.rmse_8bit")),
                    rounding.decibels(field(row, "picture.psnr_db")),
                    rounding.similarity(field(row, "picture.ssim")),
                    rounding.milliseconds(field(row, "image_ms.median")),
                    rounding.spread(row["trace_ms"]),
                    rounding.milliseconds(field(row, "frame_ms.median")),
                ]
            )
    header = ["scene", "method", "hit error, median px", "RMSE", "PSNR dB", "SSIM", "image ms"]
    return markdown([*header, "trace ms", "frame ms"], rows)


# --- Scaling ----------------------------------------------------------------------------------


def scaling(data: BenchData) -> str:
    rows = []
    for varied in bench.VARIED:
        for row in data.scaling.all(varied=varied, water=True):
            dry = data.scaling.all(varied=varied, water=False, value=row["value"])
            without = field(dry[0], "frame_ms.median") if dry else None
            rows.append(
                [
                    varied,
                    rounding.count(row["value"]),
                    rounding.slope(row["slope"]),
                    rounding.milliseconds(field(row, "image_ms.median")),
                    rounding.spread(row["trace_ms"]),
                    rounding.milliseconds(field(row, "frame_ms.median")),
                    rounding.milliseconds(without),
                ]
            )
    header = ["varied", "value", "slope", "image", "trace", "frame", "frame without water"]
    return markdown(header, rows)


# --- What water adds to a frame ---------------------------------------------------------------


ADDED_NAMES = {bench.MIRROR: "mirrored camera"}


def dry_ms(data: BenchData, triangles: float) -> float:
    return field(data.added.row(triangles=triangles, method=None), "frame_ms.median")


def added_over_mirror(data: BenchData, triangles: float, slope: float, method: str) -> float:
    """What water adds to a frame, the mirrored camera's being 1."""
    row = data.added.row(triangles=triangles, slope=slope, method=method)
    return field(row, "added_over_mirrored_camera")


def by_triangles(data: BenchData, methods: tuple[str, ...], path: str) -> list[list[str]]:
    """A row for each number of triangles and slope, with a factor of each method."""
    return [
        [
            rounding.count(triangles),
            rounding.slope(slope),
            rounding.milliseconds(dry_ms(data, triangles)),
            *(
                rounding.factor(
                    field(data.added.row(triangles=triangles, slope=slope, method=method), path)
                )
                for method in methods
            ),
        ]
        for triangles in data.added.values("triangles")
        for slope in (bench.CALM, bench.MAIN_SLOPE)
    ]


def added_header(methods: tuple[str, ...]) -> list[str]:
    names = (ADDED_NAMES.get(method, method) for method in methods)
    return ["triangles", "slope", "without water, ms", *names]


def frame_over_dry(data: BenchData) -> str:
    methods = bench.ADDED_METHODS
    return markdown(added_header(methods), by_triangles(data, methods, "over_no_water"))


def added(data: BenchData) -> str:
    methods = bench.ADDED_METHODS[1:]
    rows = by_triangles(data, methods, "added_over_mirrored_camera")
    return markdown(added_header(methods), rows)


# --- On a GPU ---------------------------------------------------------------------------------


def beside(data: BenchData, gpu: BenchData) -> str:
    """The same methods on both machines, at the main slope."""
    rows = []
    for scene in gpu.scenes:
        for method in main_methods(gpu):
            cells = []
            for machine in (data, gpu):
                row = main_row(machine, scene, method)
                cells += [
                    rounding.percent(right_percent(row)),
                    rounding.milliseconds(field(row, "image_ms.median")),
                    rounding.spread(row["trace_ms"]),
                    rounding.milliseconds(field(row, "frame_ms.median")),
                ]
            rows.append([scene, method, *cells])
    ours = ["right %", "image ms", "trace ms", "frame ms"]
    return markdown(["scene", "method", *ours, *(f"GPU: {name}" for name in ours)], rows)
