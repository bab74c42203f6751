"""The document's plots: gnuplot's scripts, and the SVG that it makes of them."""

from __future__ import annotations

import hashlib
import math
import subprocess
from dataclasses import dataclass

import bench_data as bench
import label_places
from bench_data import BenchData, DataError, Row, cost_ms, field, right_percent
from label_places import Box

WIDTH = 900  # [pixels]
PANEL_HEIGHT = 340  # [pixels]
COLUMNS = 2
MARGINS = Box(left=62, bottom=48, right=14, top=30)  # [pixels] of a panel

LEAST_PERCENT = 0.01  # shown of wrong pixels, on a logarithmic axis
PADDING = 0.10  # of a logarithmic axis, on either side

# Leading digits of the ticks, from few to many.
TICK_DIGITS = (
    (1,),
    (1, 2, 5),
    (1, 1.5, 2, 3, 5, 7),
    (1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 9),
    tuple(half / 2.0 for half in range(2, 20)),
)

OWN_SEARCHES = (bench.DEFAULT, bench.SEARCH, bench.SEQUENTIAL, bench.BINARY)
BESIDE_OTHERS = (  # left out of the plots of error against time, for room
    "hierarchical, thickness 0.1",
    "hierarchical, thickness 2.0",
    "hierarchical, capture scale 0.25",
    "hierarchical, trace scale 0.25",
    "sequential, stride 2",
    "sequential, stride 8",
)
OWN, OTHERS, GREY = "#0072b2", "#d55e00", "#888888"
STAGES = {
    "image_ms": ("captured image", "#e69f00"),
    "trace_ms": ("trace", OWN),
    "frame_ms": ("frame", "#000000"),
}
VARIED = {
    "triangles": "triangles of the scene",
    "waters": "waters",
    "corners": "corners of the water's outline",
    "pixels": "pixels",
}


@dataclass(frozen=True)
class Axis:
    """Logarithmic."""

    low: float
    high: float

    @classmethod
    def of(cls, values: list[float]) -> Axis:
        low, high = math.log(min(values)), math.log(max(values))
        padding = PADDING * max(high - low, math.log(2.0))
        return cls(math.exp(low - padding), math.exp(high + padding))

    def share(self, value: float) -> float:
        """0 at its low end, 1 at its high end."""
        return math.log(value / self.low) / math.log(self.high / self.low)

    def ticks(self) -> list[float]:
        """As few round numbers as tell the scale."""
        decades = range(math.floor(math.log10(self.low)), math.ceil(math.log10(self.high)) + 1)
        for digits in TICK_DIGITS:
            ticks = [digit * 10.0**decade for decade in decades for digit in digits]
            ticks = [tick for tick in ticks if self.low <= tick <= self.high]
            if len(ticks) >= 4:
                break
        return ticks


def tick_list(ticks: list[float]) -> str:
    return ", ".join(f'"{tick_name(tick)}" {tick:g}' for tick in ticks)


def tick_name(tick: float) -> str:
    if tick >= 1e6:
        return f"{tick / 1e6:.3g} M"
    if tick >= 1e4:
        return f"{tick / 1e3:.3g} k"
    return f"{tick:g}"


# --- A figure of panels -----------------------------------------------------------------------


def figure_height(count: int) -> int:
    return PANEL_HEIGHT * math.ceil(count / COLUMNS)


def panel_frame(index: int, count: int) -> Box:
    """[pixels] y upward; where the curves of a panel are drawn."""
    width = WIDTH / COLUMNS
    left = width * (index % COLUMNS)
    top = figure_height(count) - PANEL_HEIGHT * (index // COLUMNS)
    return Box(
        left + MARGINS.left,
        top - PANEL_HEIGHT + MARGINS.bottom,
        left + width - MARGINS.right,
        top - MARGINS.top,
    )


def start_of_figure(count: int) -> list[str]:
    height = figure_height(count)
    return [
        f'set terminal svg size {WIDTH},{height} font "sans-serif,12" background "white"',
        "set multiplot",
        "set logscale xy",
        'set grid lc rgb "#dddddd"',
        "set tics nomirror scale 0.5",
        "set mxtics 1",
        "set mytics 1",
        "set border 3",
    ]


def start_of_panel(frame: Box, count: int, x: Axis, y: Axis, title: str) -> list[str]:
    height = figure_height(count)
    return [
        "unset label",
        "unset arrow",
        f"set lmargin at screen {frame.left / WIDTH:.5f}",
        f"set rmargin at screen {frame.right / WIDTH:.5f}",
        f"set bmargin at screen {frame.bottom / height:.5f}",
        f"set tmargin at screen {frame.top / height:.5f}",
        f"set xrange [{x.low:.6g}:{x.high:.6g}]",
        f"set yrange [{y.low:.6g}:{y.high:.6g}]",
        f"set xtics ({tick_list(x.ticks())})",
        f"set ytics ({tick_list(y.ticks())})",
        f'set title "{title}" offset 0,-0.5',
    ]


def block(name: str, points: list[tuple[float, float]]) -> list[str]:
    return [f"${name} << EOD", *(f"{x:.6g} {y:.6g}" for x, y in points), "EOD"]


# --- Error against time -----------------------------------------------------------------------


def wrong_percent(row: Row) -> float:
    return max(100.0 - right_percent(row), LEAST_PERCENT)


def not_in_image_percent(row: Row) -> float:
    return bench.share(bench.pixels(row, bench.NOT_IN_IMAGE), bench.pixels(row))


def front(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Those that no other beats in both."""
    best = []
    for point in sorted(points):
        if not best or point[1] < best[-1][1]:
            best.append(point)
    return best


def short_name(method: str) -> str:
    return method.removeprefix("hierarchical, ").removeprefix("sequential, ")


def label_lines(
    points: list[tuple[float, float, str]],
    lines: list[list[tuple[float, float]]],
    frame: Box,
    x: Axis,
    y: Axis,
) -> list[str]:
    """Labels for points (x, y, text) that keep off the lines."""
    width, height = frame.right - frame.left, frame.top - frame.bottom

    def pixel(point: tuple) -> tuple[float, float]:
        return width * x.share(point[0]), height * y.share(point[1])

    def graph(place: tuple[float, float]) -> str:
        return f"graph {place[0] / width:.4f},{place[1] / height:.4f}"

    labels = label_places.place(
        [(*pixel(point), point[2]) for point in points],
        [[pixel(point) for point in line] for line in lines],
        Box(0.0, 0.0, width, height),
    )
    commands = []
    for point, label in zip(points, labels, strict=True):
        middle_left = label.box.left, (label.box.bottom + label.box.top) / 2.0
        commands.append(f'set label "{point[2]}" at {graph(middle_left)} font ",10"')
        if label.far:
            ends = f"from {graph(pixel(point))} to {graph(label.nearest(*pixel(point)))}"
            commands.append(f'set arrow {ends} nohead lc rgb "{GREY}" lw 0.7 back')
    return commands


def pareto_panel(data: BenchData, scene: str, index: int) -> list[str]:
    rows = [
        data.accuracy.row(scene=scene, slope=bench.MAIN_SLOPE, method=method)
        for method in data.methods
        if method not in BESIDE_OTHERS
    ]
    points = [(cost_ms(row), wrong_percent(row), short_name(row["method"])) for row in rows]
    is_own = [row["method"].startswith(OWN_SEARCHES) for row in rows]
    ceiling = max(not_in_image_percent(rows[0]), LEAST_PERCENT)
    x = Axis.of([point[0] for point in points])
    y = Axis.of([point[1] for point in points] + [ceiling])
    frame = panel_frame(index, len(data.scenes))
    own = [point[:2] for point, is_it in zip(points, is_own, strict=True) if is_it]
    others = [point[:2] for point, is_it in zip(points, is_own, strict=True) if not is_it]
    best = front([point[:2] for point in points])
    dashed = [(x.low, ceiling), (x.high, ceiling)]
    return [
        *start_of_panel(frame, len(data.scenes), x, y, scene),
        'set xlabel "image and trace, ms" offset 0,0.5',
        'set ylabel "not right, % of the water" offset 1.2,0',
        *label_lines(points, [best, dashed], frame, x, y),
        *block("front", best),
        *block("own", own),
        *block("others", others),
        f"plot {ceiling:.6g} with lines dt 2 lc rgb '{GREY}' notitle, "
        f"$front with lines lc rgb '{OWN}' lw 1.5 notitle, "
        f"$own with points pt 7 ps 0.6 lc rgb '{OWN}' notitle, "
        f"$others with points pt 5 ps 0.6 lc rgb '{OTHERS}' notitle",
    ]


def pareto_script(data: BenchData) -> str:
    lines = start_of_figure(len(data.scenes))
    for index, scene in enumerate(data.scenes):
        lines += pareto_panel(data, scene, index)
    return "\n".join([*lines, "unset multiplot", ""])


# --- Scaling ----------------------------------------------------------------------------------


def curve(rows: list[Row], stage: str) -> list[tuple[float, float]]:
    return sorted((row["value"], field(row, f"{stage}.median")) for row in rows)


def scaling_panel(data: BenchData, varied: str, index: int) -> list[str]:
    wet = data.scaling.all(varied=varied, slope=bench.MAIN_SLOPE, water=True)
    dry = data.scaling.all(varied=varied, water=False)
    curves = [(curve(wet, stage), *look) for stage, look in STAGES.items()]
    if dry:
        curves.append((curve(dry, "frame_ms"), "frame without water", GREY))
    everything = [time for row in data.scaling.all(water=True) for time in times_of(row)]
    dry_times = [field(row, "frame_ms.median") for row in data.scaling.all(water=False)]
    x = Axis.of([row["value"] for row in wet])
    y = Axis.of(everything + dry_times)
    lines = start_of_panel(panel_frame(index, len(VARIED)), len(VARIED), x, y, "")
    lines += [
        "unset title",
        f"set xtics ({tick_list([row['value'] for row in wet])})",
        f'set xlabel "{VARIED[varied]}" offset 0,0.5',
        'set ylabel "ms" offset 1.2,0',
    ]
    parts = []
    for number, (points, name, colour) in enumerate(curves):
        if dry:  # this panel has every curve
            lines.append(key_entry(number, name, colour))
        lines += block(f"curve{number}", points)
        parts.append(
            f"$curve{number} with linespoints pt 7 ps 0.5 lw 1.5 lc rgb '{colour}' notitle"
        )
    return [*lines, "plot " + ", ".join(parts)]


def key_entry(number: int, name: str, colour: str) -> str:
    """In a row above all panels."""
    place = f"screen {0.08 + 0.17 * number:.2f},0.98"
    return f"set label '{name}' at {place} offset 0.8,-0.3 point pt 7 ps 0.7 lc rgb '{colour}'"


def times_of(row: Row) -> list[float]:
    return [field(row, f"{stage}.median") for stage in STAGES]


def scaling_script(data: BenchData) -> str:
    lines = start_of_figure(len(VARIED))
    for index, varied in enumerate(VARIED):
        lines += scaling_panel(data, varied, index)
    return "\n".join([*lines, "unset multiplot", ""])


# --- SVG --------------------------------------------------------------------------------------


def mark(script: str) -> str:
    """What a plot's file says of the script that it was made by: so that stale ones are noticed
    without gnuplot."""
    return f"<!-- of the script {hashlib.sha256(script.encode()).hexdigest()} -->"


def draw(script: str) -> str:
    """The SVG."""
    try:
        done = subprocess.run(
            ["gnuplot", "-"], input=script, capture_output=True, text=True, check=False
        )
    except FileNotFoundError:
        raise DataError("gnuplot: expected a program, got none (Debian: gnuplot-nox)") from None
    if done.returncode != 0 or done.stderr or "</svg>" not in done.stdout:
        raise DataError(f"gnuplot: expected an SVG, got: {done.stderr.strip()}")
    return f"{done.stdout.rstrip()}\n{mark(script)}\n"
