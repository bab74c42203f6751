"""The document's tables, in Markdown."""

from __future__ import annotations

import bench_data as bench
import derived
import rounding
from bench_data import BenchData, Row, cost_ms, field, right_percent

# Of the tables that cannot hold all methods.
MAIN_METHODS = (
    bench.DEFAULT,
    bench.SEQUENTIAL,
    "sequential, stride 4",
    bench.BINARY,
    "paper",
    "paper-binary",
    "baseline",
)

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


# --- On top -----------------------------------------------------------------------------------


def summary(data: BenchData) -> str:
    entries = [
        ("**the default** (hierarchical)", data.accuracy, bench.DEFAULT),
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
        found = derived.of_scenes(data, experiment, method)
        references = derived.of_scenes(data, experiment, bench.DEFAULT)
        worst = derived.worst(found)
        rows.append(
            [
                name,
                rounding.percent(derived.mean_right(found)),
                f"{rounding.percent(right_percent(worst))} ({worst['scene']})",
                rounding.offset_pixels(derived.median_of(found, "hit_error_px.median")),
                rounding.steps(derived.mean([field(row, "picture.rmse_8bit") for row in found])),
                rounding.factor(derived.relative_cost(found, references)),
            ]
        )
    errors = ["hits off by, median px", "picture RMSE"]
    return markdown(["", "right, mean %", "right, worst %", *errors, "cost"], rows)


ADVICE = {
    "hierarchical, thickness 0.1": ("`thickness` 0.1", "thin things ahead of the water"),
    "hierarchical, thickness 2.0": ("`thickness` 2", "large, deep things only"),
    "hierarchical, capture scale 0.50": ("`captureScale` 0.5", "time, in large pictures"),
    "hierarchical, capture scale 0.25": ("`captureScale` 0.25", "more time, in large pictures"),
    bench.SEQUENTIAL: ("`Search::SEQUENTIAL`", "comparison"),
    "sequential, stride 2": ("the same, `stride` 2", "comparison"),
    "sequential, stride 4": ("the same, `stride` 4", "comparison"),
    "sequential, stride 8": ("the same, `stride` 8", "time"),
    bench.BINARY: ("`Search::BINARY`", "time, without a pyramid"),
}


def advice(data: BenchData) -> str:
    defaults = derived.of_scenes(data, data.accuracy, bench.DEFAULT)
    rows = []
    for method, (setting, gain) in ADVICE.items():
        if method not in data.methods:
            continue
        found = derived.of_scenes(data, data.accuracy, method)
        changes = [
            (right_percent(row) - right_percent(default), row["scene"])
            for row, default in zip(found, defaults, strict=True)
        ]
        rows.append(
            [
                setting,
                gain,
                rounding.points(sum(change for change, _ in changes) / len(changes)),
                *(f"{rounding.points(c)} ({scene})" for c, scene in (min(changes), max(changes))),
                rounding.factor(derived.relative_cost(found, defaults)),
            ]
        )
    points = ["points, all scenes", "where it is worst", "where it is best"]
    return markdown(["setting", "for", *points, "cost"], rows)


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
        rounding.decibels(field(row, "picture.psnr_db")),
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
        "PSNR dB",
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
    others = ("binary", "paper", "paper-binary")
    header = ["scene", "true class", "share"]
    header += ["hierarchical: right", "misplaced", "missed", "false hit"]
    rows = []
    for scene in data.scenes:
        own = main_row(data, scene, bench.DEFAULT)
        for name in bench.CLASSES:
            if not bench.pixels(own, (name,)):
                continue
            percents = [bench.share(bench.pixels(own, (name,)), bench.pixels(own))]
            percents += [bench.outcome_percent(own, name, outcome) for outcome in bench.OUTCOMES]
            percents += [
                right_percent(main_row(data, scene, method), (name,)) for method in others
            ]
            rows.append([scene, CLASS_NAMES[name], *map(rounding.percent, percents)])
    return markdown(header + [f"{method}: right" for method in others], rows)


def search_error(data: BenchData) -> str:
    rows = []
    for scene in data.scenes:
        for method in main_methods(data):
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


# --- Table 1 ----------------------------------------------------------------------------------


def table1_rows(data: BenchData, slope: float, method: str) -> list[Row]:
    return [
        data.table1.row(slope=slope, width=width, height=height, method=method)
        for width, height in data.sizes()
    ]


def table1_exponent(data: BenchData, slope: float, method: str, stage: str) -> float:
    times = [field(row, f"{stage}.median") for row in table1_rows(data, slope, method)]
    return derived.exponent(data.sizes(), times)


def paper_exponent() -> float:
    sizes = list(derived.PAPER_FRAMES)
    return derived.exponent(sizes, [1000.0 / frames for frames in derived.PAPER_FRAMES.values()])


def table1(data: BenchData) -> str:
    sizes = data.sizes()
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
    names = [f"{width}x{height}" for width, height in sizes]
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
            found = derived.of_scenes(data, data.rivals, method, slope)
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
