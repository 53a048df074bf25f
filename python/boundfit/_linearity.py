"""How far a sensor is from a straight line."""

from __future__ import annotations

import math
import os
from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, Unpack

from . import _boundfit
from ._answers import Answer, number, point, value
from ._bounds import Point, decimal
from ._asking import Name, Table, ask, exact, file_name
from ._cells import cells
from ._columns import Column, Missing, Number, Reading, named, quoted, several, table
from ._keywords import knows

if TYPE_CHECKING:
    from .documents import LinearityDocument


class LinearityLine(NamedTuple):
    """The largest deviation from a line."""

    deviation: Fraction
    percent: Fraction | None
    """Of full scale; ``None`` where that is 0."""
    theta: Point
    """Slope and offset of the line."""
    rows: list[int]
    """Where it is reached."""
    unique: bool
    """Whether no other line has a deviation as small."""


class Characteristic(NamedTuple):
    """The four linearities of one characteristic."""

    full_scale: Fraction
    """What percents are of."""
    span: Fraction
    """The span of the response."""
    independent: LinearityLine
    """From the line that makes the largest deviation smallest."""
    terminal: LinearityLine | None
    """From the line through both ends of the range."""
    zero_based: LinearityLine
    """From the best line through a given point."""
    least_squares: LinearityLine | None
    """From the least-squares line."""


class Linearity(Answer["LinearityDocument"]):
    """How far a sensor is from a straight line, as laws and data sheets state it."""

    __slots__ = ()

    def __repr__(self) -> str:
        independent = self.independent
        percent = "" if independent.percent is None else f", {decimal(independent.percent, 6, False)} % of full scale"
        return f"<boundfit.Linearity: independent {decimal(independent.deviation, 6, False)}{percent}>"

    @property
    def average(self) -> Characteristic:
        """Of the actual characteristic: the average of upscale and downscale readings, or every reading where none is known."""
        return _characteristic(self._document)

    @property
    def up(self) -> Characteristic | None:
        """Of the upscale readings alone."""
        own = self._document["up"]
        return None if own is None else _characteristic(own)

    @property
    def down(self) -> Characteristic | None:
        """Of the downscale readings alone."""
        own = self._document["down"]
        return None if own is None else _characteristic(own)

    @property
    def independent(self) -> LinearityLine:
        """Independent linearity of the average."""
        return self.average.independent

    @property
    def terminal(self) -> LinearityLine | None:
        """Terminal linearity of the average; ``None`` where no two x differ."""
        return self.average.terminal

    @property
    def zero_based(self) -> LinearityLine:
        """Zero-based linearity of the average."""
        return self.average.zero_based

    @property
    def least_squares(self) -> LinearityLine | None:
        """Least-squares linearity of the average; ``None`` where no two x differ."""
        return self.average.least_squares

    @property
    def hysteresis(self) -> Fraction | None:
        """The largest difference of upscale and downscale averages at one x; ``None`` where no x has both."""
        return number(self._document["hysteresis"])

    @property
    def repeatability(self) -> Fraction | None:
        """The largest spread of readings at one x in one direction; ``None`` where no x was read twice in one."""
        return number(self._document["repeatability"])


def _characteristic(own: Any) -> Characteristic:
    def line(one: Any) -> LinearityLine:
        return LinearityLine(value(one["deviation"]), number(one["percent"]), point(one["theta"]), one["rows"], one["unique"])

    terminal, squares = own["terminal"], own["least_squares"]
    return Characteristic(
        value(own["full_scale"]),
        value(own["span"]),
        line(own["independent"]),
        None if terminal is None else line(terminal),
        line(own["zero_based"]),
        None if squares is None else line(squares),
    )


@knows()
def linearity(
    x: Column,
    y: Column | None = None,
    *,
    up: Column | None = None,
    down: Column | None = None,
    direction: Column | None = None,
    full_scale: Number | None = None,
    through: tuple[Number, Number] = (0, 0),
    reading: Reading = "decimal",
    missing: Missing = "refuse",
) -> Linearity:
    """Independent, terminal, zero-based and least-squares linearity of readings y of what was applied, x; with hysteresis and
    repeatability where it is known whether x was rising: readings ``up`` and ``down`` in place of y, either of which may be
    missing, or beside y a column ``direction`` of words such as up and down.

    Percents are of ``full_scale``, or else of the span of y. The line of zero-based linearity goes ``through`` a point.

    >>> found = linearity([0, 1, 2, 3], [0, 1.25, 2, 3])
    >>> found.independent.deviation, found.independent.rows
    (Fraction(1, 8), [1, 2, 3, 4])
    """
    taken: set[str] = set()
    _refuse_others(y, up, down, direction)
    given = {"x": x, "y": y, "direction": direction, "up": up, "down": down}
    columns = {key: (named(own, key, taken), cells(own, key, reading)) for key, own in given.items() if own is not None}
    if direction is not None:
        columns["direction"] = (columns["direction"][0], _words(columns["direction"][1]))
    words: dict[str, Any] = {"ask": "linearity", "reading": reading, "missing": missing}
    words |= {key: quoted(columns[key][0]) for key in ("x", "y") if key in columns}
    readings = _boundfit.readings_of_columns(list(columns.values()), words)
    return _answer(readings, full_scale, through, {key: quoted(columns[key][0]) for key in _KEYS if key in columns})


@knows(Table.__annotations__)
def linearity_file(
    path: str | os.PathLike[str],
    x: Name,
    y: Name | None = None,
    *,
    up: Name | None = None,
    down: Name | None = None,
    direction: Name | None = None,
    full_scale: Number | None = None,
    through: tuple[Number, Number] = (0, 0),
    reading: Reading | None = None,
    missing: Missing = "refuse",
    **how: Unpack[Table],
) -> Linearity:
    """As :func:`linearity`, of columns of a file, by name or number. How it is read is told as in :func:`boundfit.fit_file`."""
    _refuse_others(y, up, down, direction)
    given = {key: str(own) for key, own in {"x": x, "y": y, "up": up, "down": down, "direction": direction}.items() if own is not None}
    own: dict[str, Any] = {key: given.pop(key) for key in ("x", "y") if key in given}
    words: dict[str, Any] = {"ask": "linearity", "reading": reading, "missing": missing, **own, **table(**how)}
    readings = _boundfit.readings_of_file(file_name(path), list(own.values()), words)
    return _answer(readings, full_scale, through, given)


#: Columns besides x and y.
_KEYS = ("up", "down", "direction")


def _words(column: Any) -> list[str]:
    values = column.tolist() if hasattr(column, "tolist") else list(column)
    return [_word(own, row) for row, own in enumerate(values, 1)]


def _word(own: Any, row: int) -> str:
    """A direction as a word; of a float that is whole the integer, since 1.0 is no word for 1."""
    if hasattr(own, "as_py"):
        own = own.as_py()
    if hasattr(own, "item"):
        own = own.item()
    if isinstance(own, bool):
        raise ValueError(f"row {row} of direction: {own} is a truth value: expected words such as up and down, or 1 and -1")
    if own is None or type(own).__name__ == "NAType" or own != own:
        return ""
    if isinstance(own, (float, Decimal, Fraction)) and own not in (math.inf, -math.inf) and own == int(own):
        return str(int(own))
    return str(own)


def _refuse_others(y: Any, up: Any, down: Any, direction: Any) -> None:
    given = tuple(own is not None for own in (y, up, down, direction))
    if given not in ((True, False, False, False), (True, False, False, True), (False, True, True, False)):
        raise ValueError("expected y, or y and direction, or up and down")


def _answer(
    readings: _boundfit.Readings, full_scale: Number | None, through: tuple[Number, Number], columns: dict[str, Any]
) -> Linearity:
    point = [exact(own, readings.reading) for own in several(through, "through", 2, "a point, such as (0, 0)")]
    full = exact(full_scale, readings.reading)
    return Linearity(ask(readings, "linearity", full_scale=full, through=point, **columns))
