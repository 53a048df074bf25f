"""Sets of half-planes and of generators."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from . import _boundfit
from ._bounds import Interval, Intervals, Point, lower_bound, upper_bound
from ._columns import Number, Reading, text
from ._html import of_text
from ._plane import PlaneSet

if TYPE_CHECKING:
    from .documents import PolygonDocument


class Polygon(PlaneSet["_boundfit.Plane"]):
    """A set in the plane, exactly: a polygon, or any other intersection of half-planes."""

    __slots__ = ("_core",)

    def __init__(self, core: _boundfit.Plane) -> None:
        self._core = core

    @property
    def bounds(self) -> Intervals | None:
        """The box around the set; ``None`` of an empty one."""
        both = self._core.bounds()
        if both is None:
            return None
        return Intervals(*(Interval(lower_bound(lower), upper_bound(upper)) for lower, upper in both))

    @property
    def redundant(self) -> list[int]:
        """The half-planes, from 0, without which the set is the same."""
        return self._core.redundant()

    def to_dict(self) -> PolygonDocument:
        """The report as ``boundfit polygon --format json`` writes it, schema boundfit/polygon/2."""
        document: PolygonDocument = json.loads(self._core.json())
        return document

    def report(self, format: str = "text") -> str:
        """The report as ``"text"``, ``"markdown"`` or ``"latex"``, the set as ``"wkt"``, ``"ine"`` or ``"ext"``."""
        return self._core.text(format)

    def __repr__(self) -> str:
        count = len(self.vertices)
        return f"<boundfit.Polygon: {self.kind}, {count} {'vertex' if count == 1 else 'vertices'}>"

    def __str__(self) -> str:
        return self._core.text("text")

    def _repr_html_(self) -> str:
        return of_text(str(self))


def _exact(value: Any, reading: str) -> Fraction:
    if hasattr(value, "item"):
        # The shortest text of a short float is not that of the double which it is.
        value = str(value) if reading == "decimal" and value.dtype.kind == "f" else value.item()
    if isinstance(value, float):
        return Fraction(value) if reading == "binary64" else Fraction(repr(value))
    return Fraction(value)


def _pairs(rows: Iterable[Iterable[Any]], name: str, reading: str) -> list[tuple[Fraction, Fraction]]:
    pairs = []
    for index, row in enumerate(rows):
        try:
            first, second = (_exact(value, reading) for value in row)
        except (ValueError, TypeError, OverflowError, ZeroDivisionError) as error:
            raise ValueError(f"row {index + 1} of {name}: expected two numbers ({error})") from None
        pairs.append((first, second))
    return pairs


def _of_rows(kind: str, rows: list[list[Fraction]], reading: Reading, linear: Sequence[int] = ()) -> Polygon:
    lines = [kind]
    if linear:
        lines.append(" ".join(["linearity", str(len(linear)), *map(str, linear)]))
    lines += ["begin", f"{len(rows)} 3 rational"]
    lines += [" ".join(text(value) for value in row) for row in rows]
    return Polygon(_boundfit.polygon_of_text("\n".join([*lines, "end", ""]), reading))


def polygon(A: Iterable[Iterable[Any]], b: Iterable[Any], *, reading: Reading = "decimal") -> Polygon:
    """The set of all points with A·θ ≤ b, row by row. Numbers are read as those of :func:`boundfit.fit`.

    >>> triangle = polygon([[-1, 0], [0, -1], [2, 3]], [0, 0, 6])
    >>> triangle.area, triangle.vertices[1]
    (Fraction(3, 1), (Fraction(3, 1), Fraction(0, 1)))
    """
    rows = _pairs(A, "A", reading)
    ends = [_exact(value, reading) for value in b]
    if len(rows) != len(ends):
        raise ValueError(f"A has {len(rows)} rows, but b has {len(ends)}")
    return _of_rows("H-representation", [[end, -a1, -a2] for (a1, a2), end in zip(rows, ends, strict=True)], reading)


def generators(
    V: Iterable[Iterable[Any]],
    R: Iterable[Iterable[Any]] = (),
    *,
    lines: Iterable[Iterable[Any]] = (),
    reading: Reading = "decimal",
) -> Polygon:
    """The convex hull of the points V, together with the directions R in which it goes on, and the ``lines`` both ways.

    >>> generators([[0, 0], [1, 0], [0, 1], ["1/3", "1/3"]]).vertices
    [(Fraction(0, 1), Fraction(0, 1)), (Fraction(1, 1), Fraction(0, 1)), (Fraction(0, 1), Fraction(1, 1))]
    """
    one, zero = Fraction(1), Fraction(0)
    rows = [[one, *point] for point in _pairs(V, "V", reading)]
    rows += [[zero, *ray] for ray in _pairs(R, "R", reading)]
    both = [[zero, *line] for line in _pairs(lines, "lines", reading)]
    linear = range(len(rows) + 1, len(rows) + len(both) + 1)
    return _of_rows("V-representation", rows + both, reading, list(linear))


def polygon_file(path: str | os.PathLike[str], *, reading: Reading = "decimal") -> Polygon:
    """The set of a file of half-planes (``.ine``, or a table of a1, a2, b) or of generators (``.ext``)."""
    return Polygon(_boundfit.polygon_of_file(os.fspath(path), reading))
