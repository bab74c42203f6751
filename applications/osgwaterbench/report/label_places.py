"""Where the labels of points go, so that they cover neither each other nor a point."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

CHARACTER_WIDTH = 6.0  # [pixels] of the plots' font, in the mean
LABEL_HEIGHT = 13.0  # [pixels]
POINT_SIZE = 8.0  # [pixels]
DISTANCES = (7.0, 20.0, 34.0, 50.0, 68.0)  # [pixels] between a point and its label
LINE_WIDTH, LINE_STEP = 3.0, 3.0  # [pixels] of lines that labels keep off
NEAR = DISTANCES[0]  # a label that is farther gets a line to its point
DIRECTIONS = ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1))


@dataclass(frozen=True)
class Box:
    """[pixels] y upward."""

    left: float
    bottom: float
    right: float
    top: float

    def overlap(self, other: Box) -> float:
        width = min(self.right, other.right) - max(self.left, other.left)
        height = min(self.top, other.top) - max(self.bottom, other.bottom)
        return width * height if width > 0.0 and height > 0.0 else 0.0

    def inside(self, frame: Box) -> bool:
        return (
            self.left >= frame.left
            and self.right <= frame.right
            and self.bottom >= frame.bottom
            and self.top <= frame.top
        )


@dataclass(frozen=True)
class Label:
    box: Box
    far: bool  # from its point

    def nearest(self, x: float, y: float) -> tuple[float, float]:
        """The point of the label that is nearest."""
        return (
            min(max(x, self.box.left), self.box.right),
            min(max(y, self.box.bottom), self.box.top),
        )


def box_about(x: float, y: float, width: float, height: float) -> Box:
    return Box(x - width / 2.0, y - height / 2.0, x + width / 2.0, y + height / 2.0)


def candidates(x: float, y: float, text: str) -> list[Label]:
    width = CHARACTER_WIDTH * len(text)
    labels = []
    for distance in DISTANCES:
        for dx, dy in DIRECTIONS:
            aside = distance if dy == 0 else distance / 2.0
            centre_x = x + dx * (aside + width / 2.0)
            centre_y = y + dy * (distance + LABEL_HEIGHT / 2.0)
            box = box_about(centre_x, centre_y, width, LABEL_HEIGHT)
            labels.append(Label(box, far=distance > NEAR))
    return labels


def along(line: list[tuple[float, float]]) -> list[Box]:
    """Small boxes on the line's segments."""
    boxes = []
    for (x0, y0), (x1, y1) in pairwise(line):
        count = max(1, math.ceil(math.hypot(x1 - x0, y1 - y0) / LINE_STEP))
        for i in range(count + 1):
            share = i / count
            x, y = x0 + share * (x1 - x0), y0 + share * (y1 - y0)
            boxes.append(box_about(x, y, LINE_WIDTH, LINE_WIDTH))
    return boxes


def place(
    points: list[tuple[float, float, str]], lines: list[list[tuple[float, float]]], frame: Box
) -> list[Label]:
    """A label for each point (x, y, text): the first free candidate, else the least covered."""
    taken = [box_about(x, y, POINT_SIZE, POINT_SIZE) for x, y, _ in points]
    for line in lines:
        taken += along(line)
    placed: list[Label] = []
    for x, y, text in points:
        labels = [other.box for other in placed]

        def covered(label: Label) -> float:
            leader = leader_of(label, x, y)
            return overlaps([label.box], taken + labels) + overlaps(leader, labels)

        fitting = [label for label in candidates(x, y, text) if label.box.inside(frame)]
        best = min(fitting, key=covered)
        placed.append(best)
        taken += leader_of(best, x, y)
    return placed


def leader_of(label: Label, x: float, y: float) -> list[Box]:
    """Along the line between a far label and its point."""
    return along([(x, y), label.nearest(x, y)]) if label.far else []


def overlaps(boxes: list[Box], others: list[Box]) -> float:
    return sum(box.overlap(other) for box in boxes for other in others)
