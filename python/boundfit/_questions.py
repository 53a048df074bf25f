"""What readings are asked beyond their set."""

from __future__ import annotations

import builtins
from collections.abc import Mapping
from typing import Any, Literal, Unpack

from . import _boundfit, _found
from ._answers import counted as so_many
from ._asking import How, ask, exact, readings
from ._cells import cells
from ._columns import Column, Number, count, flag, fraction, is_number, maybe_count, regressors, several, text
from ._found import LinearRange, NextReading, Outliers, Prediction, Statuses, WindowFit
from ._keywords import knows

#: What only fits answer about.
_OF_X_ERRORS = ("x_eps", "strong")


class Asked:
    """Readings that can be asked: what :class:`boundfit.Fit` and the functions of this module have in common."""

    __slots__ = ("_readings",)

    def __init__(self, readings: _boundfit.Readings) -> None:
        self._readings = readings

    @knows()
    def status(self, *, repair: bool = False, new: Any = None) -> Statuses:
        """What every reading and the set of all, and that of the others, say of each other: which are outliers, which decide.

        ``repair`` also finds the least total widening of the bounds under which something meets all of them. ``new`` are further
        readings, which change nothing and are listed by their rows: a tuple of columns in the order in which they were given (x, y, and the bounds if they are
        columns), or of a file the path of another one.
        """
        tables = [] if new is None or isinstance(new, str) else [("new", _further(new, self._readings))]
        name = new if isinstance(new, str) else "new" if tables else None
        asked = ask(self._readings, "status", tables=tables, new=name, repair=flag(repair, "repair"))
        return Statuses(asked, self._readings.reading)

    @knows()
    def predict(
        self,
        at: Any = None,
        *,
        from_: Any = None,
        grid: tuple[Number, Number, int] | None = None,
        new_eps: Number | None = None,
        proofs: bool = False,
    ) -> Prediction:
        """Where the line runs ``at`` an x, or at many, and where a further reading lies there; and which x a reading ``from_`` which
        is known may come from. All of it is guaranteed if no error is larger than its bound.

        ``at`` and ``from_`` are numbers or columns, in which no number is missing: answers are in their order. With two regressors ``at`` is a tuple of two columns, or an array of them.
        ``grid=(0, 10, 100)`` asks at 101 values in equal steps. ``new_eps`` bounds the error of a further reading, where it is not
        that of the fitted ones: a number, or a law. ``proofs`` shows the readings that prove each end in reports.

        :raises ValueError: where a number of ``at`` or ``from_`` is missing, also with ``missing="skip"``, which skips readings.
        """
        count = self._readings.regressors
        if count == 2 and (from_ is not None or grid is not None):
            raise ValueError("from_ and grid are about a line: with two regressors there is no single x (ask at pairs)")
        reading = self._readings.reading
        # A column is asked for by its number: both of two regressors have one name.
        given = {"at": at, "from_": from_}
        tables = [
            (name, _values(own, name, count if name == "at" else 1, reading)) for name, own in given.items() if own is not None
        ]
        columns = {name: [f"{name}:{';'.join(str(number + 1) for number in builtins.range(len(own)))}"] for name, own in tables}
        bound = exact(new_eps, reading)
        asked = ask(
            self._readings,
            "predict",
            tables=tables,
            at=columns.get("at"),
            grid=None if grid is None else _of_grid(grid, reading),
            new_eps=None if bound is None else bound["exact"],
            proofs=flag(proofs, "proofs"),
            **({"from": columns["from_"]} if "from_" in columns else {}),
        )
        return Prediction(asked, reading)

    @knows()
    def outliers(self, *, most: int | None = None, max_sets: int | None = None, max_steps: int | None = None) -> Outliers:
        """The fewest readings to leave out so that something agrees with all others, every such choice, and what is left then. With
        ``most`` how the set grows when up to so many may be missed. At most ``max_sets`` choices are listed, and ``max_steps``
        crossings of bounds looked at.

        :raises ValueError: where that is too much.
        """
        asked = ask(
            self._readings,
            "outliers",
            most=maybe_count(most, "most"),
            max_sets=maybe_count(max_sets, "max_sets"),
            max_steps=maybe_count(max_steps, "max_steps"),
        )
        return Outliers(asked, self._readings.reading)

    @knows()
    def range(self, *, by: Literal["x", "row"] | None = None) -> LinearRange:
        """Every run of readings, in order of x or of rows, that some parameters agree with: where a sensor is linear."""
        return LinearRange(ask(self._readings, "range", by=by), self._readings.reading)

    @knows()
    def next(
        self,
        within: tuple[Number, Number] | None = None,
        *,
        goal: Literal["theta1", "theta2", "area"] | None = None,
        new_eps: Number | None = None,
    ) -> NextReading:
        """Where the next reading of a line certainly makes the set smaller, whatever it shows, and which x ``within`` a range leaves
        the shortest interval of θ1, the shortest one of θ2 and the smallest area, or the ``goal`` of these, at worst.

        ``within`` is the range of the readings unless it is given. ``new_eps`` bounds the error of the next reading, where it is not
        that of the fitted ones.
        """
        reading = self._readings.reading
        ends = None if within is None else [exact(end, reading) for end in several(within, "within", 2, "both ends, such as (0, 10)")]
        return NextReading(ask(self._readings, "next", within=ends, goal=goal, new_eps=exact(new_eps, reading)), reading)

    @knows()
    def windows(self, window: int | None = None, *, window_x: Number | None = None, step: int = 1) -> list[WindowFit]:
        """The fits of the last ``window`` readings in order of rows, or of those whose x is at most ``window_x`` less than the
        newest's in order of x, again and again as the window moves on by ``step`` readings."""
        reading = self._readings.reading
        counted, moved = maybe_count(window, "window", 1), count(step, "step", 1)
        asked = ask(self._readings, "window", window=counted, window_x=exact(window_x, reading), step=None if moved == 1 else moved)
        lines = asked("json", None)
        return [_found.window(line, reading) for line in lines.splitlines()]


def _further(columns: Any, readings: _boundfit.Readings) -> list[tuple[str, Any]]:
    if hasattr(columns, "__fspath__"):
        raise ValueError("new: expected a tuple of columns, or the path of a file as a str")
    if not isinstance(columns, tuple):
        raise ValueError(f"new is of type {type(columns).__name__}: expected a tuple of columns such as (x, y)")
    names = readings.names
    if len(columns) != len(names):
        raise ValueError(f"new has {so_many(len(columns), 'column')}: expected {', '.join(names)}")
    further = [(name, cells(column, "new", readings.reading)) for name, column in zip(names, columns, strict=True)]
    if not any(len(column) for _, column in further):
        raise ValueError("new: the columns are empty")
    return further


def _values(asked: Any, name: str, regressors_of_each: int, reading: str) -> list[tuple[str, Any]]:
    """The columns of values that are asked about: one, or both of two regressors."""
    if regressors_of_each == 1:
        columns = [[asked]] if is_number(asked) else regressors(list(asked) if isinstance(asked, tuple) else asked)
    elif isinstance(asked, tuple) and len(asked) == 2 and all(map(is_number, asked)):
        columns = [[one] for one in asked]
    elif isinstance(asked, list) and all(isinstance(pair, (tuple, list)) and len(pair) == 2 for pair in asked):
        columns = [[pair[side] for pair in asked] for side in (0, 1)]
    else:
        columns = [] if is_number(asked) else regressors(asked)
    if len(columns) != regressors_of_each:
        expected = "numbers, or a column of them" if regressors_of_each == 1 else "pairs of numbers, or two columns"
        raise ValueError(f"{name}: expected {expected}")
    columns = [cells(column, name, reading) for column in columns]
    if not len(columns[0]):
        raise ValueError(f"{name}={asked!r}: expected at least one number")
    if len({len(column) for column in columns}) > 1:
        raise ValueError(f"{name} has columns of different lengths")
    return [(name, column) for column in columns]


def _of_grid(grid: tuple[Number, Number, int], reading: str) -> str:
    expected = "(from, to, steps) with from < to and at least one step, such as (0, 10, 100)"
    start, end, steps = several(grid, "grid", 3, expected)
    first, last = fraction(start, "grid", reading), fraction(end, "grid", reading)
    if not first < last:
        raise ValueError(f"grid={grid!r}: expected {expected}")
    return f"{text(first)}..{text(last)}/{count(steps, 'grid: the number of steps', 1)}"


def _asked(x: Any, y: Any, eps: Any, how: Mapping[str, Any]) -> Asked:
    """Columns with a question that errors of x have no part in."""
    for key in _OF_X_ERRORS:
        if how.get(key) is not None and how[key] is not False:
            raise ValueError(f"{key}: only fit and fit_file answer with errors in x: expected exact x")
    return Asked(readings(x, y, eps, **{key: value for key, value in how.items() if key not in _OF_X_ERRORS}))


@knows(How.__annotations__, refuses=_OF_X_ERRORS)
def status(
    x: Column | tuple[Column, Column],
    y: Column | None = None,
    eps: Number | Column | None = None,
    *,
    repair: bool = False,
    new: Any = None,
    **how: Unpack[How],
) -> Statuses:
    """What every reading and the set say of each other: :meth:`boundfit.Fit.status` of columns, which are as in
    :func:`boundfit.fit`.

    >>> [(own.row, own.status, own.without) for own in status([0, 1, 2, 3], [0, 1, 2, 9], 1).rows]
    [(1, None, None), (2, None, None), (3, None, 'outlier'), (4, None, 'outlier')]
    """
    return _asked(x, y, eps, how).status(repair=repair, new=new)


@knows(How.__annotations__, refuses=_OF_X_ERRORS)
def predict(
    x: Column | tuple[Column, Column],
    y: Column | None = None,
    eps: Number | Column | None = None,
    *,
    at: Any = None,
    from_: Any = None,
    grid: tuple[Number, Number, int] | None = None,
    new_eps: Number | None = None,
    proofs: bool = False,
    **how: Unpack[How],
) -> Prediction:
    """Where the line runs, and where further readings lie: :meth:`boundfit.Fit.predict` of columns, which are as in
    :func:`boundfit.fit`.

    >>> predicted = predict([0, 1, 2], [0, 1.5, 2], "1/2", at=3, from_=1)
    >>> predicted.at[0].reading
    Interval(lower=LowerBound(3, 2), upper=UpperBound(9, 2))
    >>> predicted.from_[0].x
    [Interval(lower=LowerBound(0, 1), upper=UpperBound(2, 1))]
    """
    asked = _asked(x, y, eps, how)
    return asked.predict(at, from_=from_, grid=grid, new_eps=new_eps, proofs=proofs)


@knows(How.__annotations__, refuses=_OF_X_ERRORS)
def outliers(
    x: Column | tuple[Column, Column],
    y: Column | None = None,
    eps: Number | Column | None = None,
    *,
    most: int | None = None,
    max_sets: int | None = None,
    max_steps: int | None = None,
    **how: Unpack[How],
) -> Outliers:
    """The fewest readings to leave out: :meth:`boundfit.Fit.outliers` of columns, which are as in :func:`boundfit.fit`.

    >>> found = outliers([0, 1, 2, 3], [0, 1, 2, 9], 1)
    >>> found.least, found.sets
    (1, [[3], [4]])
    """
    return _asked(x, y, eps, how).outliers(most=most, max_sets=max_sets, max_steps=max_steps)


@knows(How.__annotations__, refuses=_OF_X_ERRORS)
def windows(
    x: Column | tuple[Column, Column],
    y: Column | None = None,
    eps: Number | Column | None = None,
    *,
    window: int | None = None,
    window_x: Number | None = None,
    step: int = 1,
    **how: Unpack[How],
) -> list[WindowFit]:
    """The last readings, fitted again and again: :meth:`boundfit.Fit.windows` of columns, which are as in :func:`boundfit.fit`.

    >>> [(own.last_row, own.kind) for own in windows([0, 1, 2, 3], [0, 1, 2, 9], 1, window=3)]
    [(3, 'polygon'), (4, 'empty')]
    """
    return _asked(x, y, eps, how).windows(window, window_x=window_x, step=step)


# The last of this module, which take the names of builtins.
@knows(How.__annotations__, refuses=_OF_X_ERRORS)
def next(
    x: Column,
    y: Column | None = None,
    eps: Number | Column | None = None,
    *,
    within: tuple[Number, Number] | None = None,
    goal: Literal["theta1", "theta2", "area"] | None = None,
    new_eps: Number | None = None,
    **how: Unpack[How],
) -> NextReading:
    """Where to take the next reading: :meth:`boundfit.Fit.next` of columns, which are as in :func:`boundfit.fit`.

    >>> import boundfit
    >>> found = boundfit.next([0, 2], [0, 2], "1/2", within=(0, 4), goal="theta1")
    >>> found.certain
    [OpenInterval(lower=None, upper=InnerUpperBound(0, 1)), OpenInterval(lower=InnerLowerBound(2, 1), upper=None)]
    >>> found.best[0].at, found.best[0].worst
    ([Fraction(4, 1)], Fraction(1, 2))
    """
    return _asked(x, y, eps, how).next(within, goal=goal, new_eps=new_eps)


@knows(How.__annotations__, refuses=_OF_X_ERRORS)
def range(
    x: Column | tuple[Column, Column],
    y: Column | None = None,
    eps: Number | Column | None = None,
    *,
    by: Literal["x", "row"] | None = None,
    **how: Unpack[How],
) -> LinearRange:
    """Every run of readings that some parameters agree with: :meth:`boundfit.Fit.range` of columns, which are as in
    :func:`boundfit.fit`.

    >>> import boundfit
    >>> boundfit.range([0, 1, 2, 3], [0, 1, 2, 9], 1).longest.rows
    (1, 3)
    """
    return _asked(x, y, eps, how).range(by=by)
