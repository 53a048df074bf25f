"""Sets of half-planes and of generators."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Self

from . import _boundfit
from ._bounds import Interval, Intervals, lower_bound, upper_bound
from ._columns import Reading, fraction, numbers_of, rows_of, several, text
from ._html import of_text
from ._keywords import knows
from ._plane import PlaneSet

if TYPE_CHECKING:
    from .documents import PolygonDocument


class Polygon(PlaneSet["_boundfit.Plane"]):
    """A set in the plane, exactly: a polygon, or any other intersection of half-planes."""

    __slots__ = ("_core", "_made")

    def __init__(self, core: _boundfit.Plane, made: tuple[Callable[[str, Reading], Polygon], tuple[str, Reading]]) -> None:
        self._core = core
        self._made = made

    def __reduce__(self) -> Any:
        # The rows that it was made of, or the path of their file.
        return self._made

    def __copy__(self) -> Self:
        # Nothing changes a polygon.
        return self

    def __deepcopy__(self, memo: Any) -> Self:
        return self

    @property
    def bounds(self) -> Intervals[Interval] | None:
        """The box around the set; ``None`` of an empty one."""
        both = self._core.bounds()
        if both is None:
            return None
        reading = self._core.reading
        return Intervals(*(Interval(lower_bound(lower), upper_bound(upper), reading=reading) for lower, upper in both))

    @property
    def redundant(self) -> list[int]:
        """The half-planes, from 0, without which the set is the same."""
        return self._core.redundant()

    def to_dict(self) -> PolygonDocument:
        """The report as ``boundfit polygon --format json`` writes it, schema boundfit/polygon/2."""
        document: PolygonDocument = json.loads(self._core.text("json"))
        return document

    def report(self, format: str = "text") -> str:
        """The report as ``"text"``, ``"markdown"`` or ``"latex"``, the set as ``"json"``, ``"wkt"``, ``"ine"`` or ``"ext"``, its vertices
        as ``"csv"`` or ``"m"``.
        """
        return self._core.text(format)

    def __repr__(self) -> str:
        count = len(self.vertices)
        return f"<boundfit.Polygon: {self.kind}, {count} {'vertex' if count == 1 else 'vertices'}>"

    def __str__(self) -> str:
        return self._core.text("text")

    def _repr_html_(self) -> str:
        return of_text(str(self))


def _pairs(matrix: Iterable[Iterable[Any]], name: str, reading: str) -> list[tuple[Fraction, Fraction]]:
    pairs = []
    for number, row in enumerate(rows_of(matrix, name), 1):
        place = f"row {number} of {name}"
        first, second = several(row, place, 2, "two numbers")
        pairs.append((fraction(first, place, reading), fraction(second, place, reading)))
    return pairs


def _of_rows(kind: str, rows: list[list[Fraction]], reading: Reading, linear: Sequence[int] = ()) -> Polygon:
    lines = [kind]
    if linear:
        lines.append(" ".join(["linearity", str(len(linear)), *map(str, linear)]))
    lines += ["begin", f"{len(rows)} 3 rational"]
    lines += [" ".join(text(value) for value in row) for row in rows]
    return _of_text("\n".join([*lines, "end", ""]), reading)


def _of_text(rows: str, reading: Reading) -> Polygon:
    return Polygon(_boundfit.polygon_of_text(rows, reading), (_of_text, (rows, reading)))


def _of_file(path: str, reading: Reading) -> Polygon:
    return Polygon(_boundfit.polygon_of_file(path, reading), (_of_file, (path, reading)))


@knows()
def polygon(A: Iterable[Iterable[Any]], b: Iterable[Any], *, reading: Reading = "decimal") -> Polygon:
    """The set of all points with A·θ ≤ b, row by row. Numbers are read as those of :func:`boundfit.fit`.

    >>> triangle = polygon([[-1, 0], [0, -1], [2, 3]], [0, 0, 6])
    >>> triangle.area, triangle.vertices[1]
    (Fraction(3, 1), (Fraction(3, 1), Fraction(0, 1)))
    """
    rows = _pairs(A, "A", reading)
    ends = [fraction(value, f"row {number} of b", reading) for number, value in enumerate(numbers_of(b, "b"), 1)]
    if len(rows) != len(ends):
        raise ValueError(f"A has {len(rows)} rows, but b has {len(ends)}")
    return _of_rows("H-representation", [[end, -a1, -a2] for (a1, a2), end in zip(rows, ends, strict=True)], reading)


@knows()
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


@knows()
def polygon_file(path: str | os.PathLike[str], *, reading: Reading = "decimal") -> Polygon:
    """The set of a file of half-planes (``.ine``, or a table of a1, a2, b) or of generators (``.ext``)."""
    return _of_file(os.fsdecode(path), reading)
