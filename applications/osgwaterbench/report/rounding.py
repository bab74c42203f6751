"""How every figure of the document is written: the one place where rounding is decided."""

from __future__ import annotations

import math

NONE = "–"  # where there is nothing to measure


def significant(value: float, digits: int) -> str:
    """That many significant digits, thousands apart, no exponent."""
    if value == 0.0:
        return "0"
    rounded = float(f"{value:.{digits - 1}e}")
    decimals = digits - 1 - math.floor(math.log10(abs(rounded)))
    return f"{rounded:,.{max(0, decimals)}f}"


def percent(value: float | None) -> str:
    """Without its sign; two decimals at both ends, where one would hide what is left."""
    if value is None:
        return NONE
    if 0.0 < value < 0.005:
        return "< 0.01"
    if 99.995 < value < 100.0:
        return "> 99.99"
    decimals = 2 if 0.0 < min(value, 100.0 - value) < 1.0 else 1
    return f"{value:.{decimals}f}"


def points(value: float) -> str:
    """A difference of percentages."""
    text = f"{value:+.2f}" if abs(value) < 1.0 else f"{value:+.1f}"
    return text.replace("-", "−")


def milliseconds(value: float | None) -> str:
    return NONE if value is None else significant(value, 3) if value >= 0.01 else "< 0.01"


def offset_pixels(value: float | None) -> str:
    return NONE if value is None else significant(value, 2) if value >= 0.001 else "< 0.001"


def tiny(value: float | None) -> str:
    """Millimetres, degrees."""
    return NONE if value is None else significant(value, 2) if value >= 0.0001 else "< 0.0001"


def factor(value: float | None) -> str:
    return NONE if value is None else significant(value, 2).replace("-", "−")


def frames_a_second(value: float) -> str:
    return significant(value, 3)


def fetches(value: float | None) -> str:
    return NONE if value is None else significant(value, 3)


def exponent(value: float) -> str:
    return f"{value:.2f}"


def decibels(value: float | None) -> str:
    return NONE if value is None else f"{value:.1f}"


def similarity(value: float) -> str:
    return f"{value:.3f}"


def steps(value: float) -> str:
    """Of 8 bits."""
    return f"{value:.1f}"


def count(value: float) -> str:
    return f"{round(value):,}"


def slope(value: float) -> str:
    return f"{value:g}"


def spread(row_times: dict[str, float]) -> str:
    """A median with its quartiles."""
    quartiles = " to ".join(milliseconds(row_times[key]) for key in ("p25", "p75"))
    return f"{milliseconds(row_times['median'])} ({quartiles})"
