"""Fits of readings in memory and in files."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _boundfit
from ._bounds import Interval, Intervals, ProvedInterval, Term, lower_bound, upper_bound
from ._columns import Column, Missing, Number, Reading, Rows, asked, in_memory, table

if TYPE_CHECKING:
    import numpy
    from matplotlib.axes import Axes

Point = tuple[Fraction, Fraction]


class Central(NamedTuple):
    """The middle of the box of both intervals, and how far the true parameters can be from it."""

    theta1: Fraction
    theta2: Fraction
    guaranteed_error: Point


class Minimax(NamedTuple):
    """The least error bound that leaves anything, and a point that it leaves.

    ``least`` is a factor on the bounds where each reading has its own.
    """

    least: Fraction
    theta1: Fraction
    theta2: Fraction
    unique: bool


class Fit:
    """All parameters that agree with all readings, with what follows from them. Every number is exact."""

    __slots__ = ("_core",)

    def __init__(self, core: _boundfit.Fitted) -> None:
        self._core = core

    @property
    def kind(self) -> str:
        """Which kind of set it is: ``"polygon"``, ``"empty"``, ``"point"``, ``"segment"``, ``"unbounded-polygon"`` and so on."""
        return self._core.kind

    @property
    def is_empty(self) -> bool:
        """Whether no parameters agree with all readings: :attr:`contradiction` says why."""
        return self._core.kind == "empty"

    @property
    def rows(self) -> int:
        """How many readings are fitted."""
        return self._core.rows

    @property
    def rows_total(self) -> int:
        """How many rows there are, fitted or not."""
        return self._core.rows_total

    @property
    def reading(self) -> str:
        """How numbers were read: ``"decimal"`` or ``"binary64"``."""
        return self._core.reading

    @property
    def vertices(self) -> list[Point]:
        """The corners of the set, counter-clockwise from the lexicographically smallest."""
        return self._core.vertices()

    @property
    def rays(self) -> list[Point]:
        """The directions in which an unbounded set goes on."""
        return self._core.directions(False)

    @property
    def lines(self) -> list[Point]:
        """The directions in which the set goes on both ways."""
        return self._core.directions(True)

    @property
    def witness(self) -> Point | None:
        """A point of the set; ``None`` of an empty one."""
        return self._core.witness()

    @property
    def area(self) -> Fraction | None:
        """The area of the set; ``None`` where it is infinite."""
        return self._core.area()

    @property
    def pui(self) -> Intervals | None:
        """The interval of each parameter over the set, with proofs; ``None`` of an empty set."""
        both = self._core.pui()
        if both is None:
            return None
        intervals = []
        for (lower, lower_terms), (upper, upper_terms) in both:
            lower_proof = tuple(Term(row, bound, times) for (row, bound), times in lower_terms)
            upper_proof = tuple(Term(row, bound, times) for (row, bound), times in upper_terms)
            intervals.append(ProvedInterval(lower_bound(lower), upper_bound(upper), lower_proof, upper_proof))
        return Intervals(*intervals)

    @property
    def eui(self) -> Intervals | None:
        """How far errors within the bounds can move the least-squares estimate; ``None`` where there is none."""
        both = self._core.eui()
        if both is None:
            return None
        return Intervals(*(Interval(lower_bound(lower), upper_bound(upper)) for lower, upper in both))

    @property
    def central(self) -> Central | None:
        """The central estimate; ``None`` unless both intervals are bounded."""
        central = self._core.central()
        if central is None:
            return None
        (theta1, theta2), error = central
        return Central(theta1, theta2, error)

    @property
    def least_squares(self) -> Point | None:
        """The least-squares estimate; ``None`` where there is none."""
        return self._core.least_squares()

    @property
    def least_squares_is_feasible(self) -> bool | None:
        """Whether the least-squares estimate agrees with all readings; ``None`` where there is none."""
        return self._core.least_squares_is_feasible()

    @property
    def minimax(self) -> Minimax | None:
        """The least error bound and the minimax estimate; ``None`` where no bound leaves anything, or it is not known."""
        minimax = self._core.minimax()
        if minimax is None:
            return None
        least, (theta1, theta2), unique = minimax
        return Minimax(least, theta1, theta2, unique)

    @property
    def epsilon_min(self) -> Fraction | None:
        """The least error bound that leaves anything."""
        minimax = self._core.minimax()
        return None if minimax is None else minimax[0]

    @property
    def contradiction(self) -> tuple[Term, ...] | None:
        """Of an empty set at most three bounds that contradict each other: these multiples add up to 0 ≤ something negative."""
        terms = self._core.contradiction()
        return None if terms is None else tuple(Term(row, bound, times) for (row, bound), times in terms)

    def __contains__(self, theta: tuple[Number, Number]) -> bool:
        return self._core.contains(*theta)

    def response(self, x: Number, x2: Number | None = None) -> Interval | None:
        """The values of the true line at x, or of the model at two regressors: a guaranteed interval; ``None`` of an empty set.

        A float is the dyadic number that it is; write ``"0.1"`` for 1/10. Where x was counted from an origin, so is this x.

        >>> fit([0, 1, 2], [0, 1.5, 2], "1/2").response(3)
        Interval(lower=LowerBound(2, 1), upper=UpperBound(4, 1))
        """
        both = self._core.range(x, 1 if x2 is None else x2)
        return None if both is None else Interval(lower_bound(both[0]), upper_bound(both[1]))

    def verify(self) -> None:
        """Recomputes every proof of the answer from the readings.

        :raises ValueError: with the first statement that is false.
        """
        self._core.verify()

    def to_numpy(self, outward: bool = True) -> numpy.ndarray[Any, Any]:
        """The vertices as doubles, one per row. With ``outward`` the box of all vertices is not smaller for the rounding: the
        coordinates that are ends of the intervals are rounded away from the set, others to nearest. Rounded vertices are a
        picture of the set, not a proof: for that take :attr:`vertices`."""
        import numpy

        vertices = self.vertices
        exact = numpy.array([[float(a), float(b)] for a, b in vertices], dtype=float).reshape(len(vertices), 2)
        if outward and vertices:
            for axis in (0, 1):
                column = [vertex[axis] for vertex in vertices]
                least, most = min(column), max(column)
                lower, upper = lower_bound(least), upper_bound(most)
                for index, value in enumerate(column):
                    if value == least and lower is not None and least != most:
                        exact[index, axis] = float(lower)
                    elif value == most and upper is not None:
                        exact[index, axis] = float(upper)
        return exact

    def to_dict(self) -> dict[str, Any]:
        """The report as ``boundfit fit --format json`` writes it, schema boundfit/fit/1."""
        document: dict[str, Any] = json.loads(self._core.json())
        return document

    def to_json(self) -> str:
        """The report as JSON text, schema boundfit/fit/1."""
        return self._core.json()

    def report(self, format: str = "text", *, brief: bool = False, digits: int | None = None) -> str:
        """The report as ``"text"``, ``"markdown"`` or ``"latex"``; the set as ``"wkt"``, ``"ine"`` or ``"ext"``; ``"csv"``."""
        return self._core.text(format, brief, digits)

    def proof(self) -> str:
        """The proof of the answer as JSON text, which :func:`boundfit.verify` and ``boundfit verify`` check against the file.

        :raises ValueError: where the readings do not come from plain delimited text: proofs are about the bytes of a file.
        """
        proof = self._core.proof()
        if proof is None:
            raise ValueError(
                "a proof is about the rows of delimited text, and these readings come from something else: save them as CSV and "
                "use fit_file"
            )
        return proof

    def svg(
        self,
        figure: str = "fps",
        *,
        title: str | None = None,
        x_unit: str | None = None,
        y_unit: str | None = None,
        flip: bool = False,
    ) -> str:
        """A figure as SVG: ``"data"``, ``"eui"``, ``"pui"``, ``"fps"``, ``"corridor"`` or ``"directions"``."""
        return self._core.figure(figure, "svg", title, x_unit, y_unit, flip).decode()

    def png(self, figure: str = "fps", *, title: str | None = None, flip: bool = False) -> bytes:
        """A figure as the bytes of a PNG."""
        return self._core.figure(figure, "png", title, None, None, flip)

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the set on axes of matplotlib, with the box of the intervals and the estimates; ``style`` is that of the filled
        polygon. Of an unbounded set the part within the axes' limits is drawn, of an empty one the title says that it is."""
        from ._plot import plot

        return plot(self, ax, **style)

    def lesson(self, path: str | os.PathLike[str], *, title: str | None = None) -> None:
        """Writes the web page that teaches about these readings."""
        page = self._core.lesson(title)
        with open(path, "w", encoding="utf-8", newline="\n") as file:
            file.write(page)

    def __repr__(self) -> str:
        if self.is_empty:
            return f"<boundfit.Fit of {self.rows} readings: no parameters agree with all of them>"
        pui = self.pui
        assert pui is not None
        ends = []
        for name, interval in zip(pui._fields, pui, strict=True):
            ends.append(f"{name} in {interval:.6}")
        return f"<boundfit.Fit of {self.rows} readings: {self.kind}, about {', '.join(ends)}>"

    def __str__(self) -> str:
        return self._core.text("text", False, None)

    def _repr_html_(self) -> str:
        from ._html import of_fit

        return of_fit(self)


def fit(
    x: Column | tuple[Column, Column],
    y: Column | None = None,
    eps: Number | Column | None = None,
    *,
    lower: Column | None = None,
    upper: Column | None = None,
    where: str | Sequence[str] = (),
    through_origin: bool = False,
    x_origin: Number | None = None,
    reading: Reading = "decimal",
    missing: Missing = "refuse",
    eui: bool = True,
) -> Fit:
    """Fits a line, y = theta1*x + theta2 + e, or with two regressors in ``x``, y = theta1*phi1 + theta2*phi2 + e.

    Columns are numpy arrays, pandas or polars Series, pyarrow arrays, or lists of int, float, ``Decimal``, ``Fraction`` and str.
    Texts, decimals and fractions are exact. A float stands, under ``reading="decimal"``, for its shortest text, so that a frame
    gives the answer of the CSV that it came from (0.1 is 1/10); under ``"binary64"`` for the number that is stored.

    ``eps`` bounds every error: a number, a column of one per reading, a law such as ``"0.05%*|y| + 2e-3"``, or a multiple of the
    least bound, ``"1.2*min"``. In its place ``lower`` and ``upper`` may bound the line itself at each reading; a NaN or ``None``
    is no bound. ``where`` has what is known of the parameters, such as ``"theta1 >= 0"``.

    Rows without a number are refused, or left out with ``missing="skip"``. ``eui=False`` saves the look that the EUI takes.

    :raises ValueError: with the row, for NaN, infinities, texts that are no numbers, and columns of different lengths.

    >>> through = fit([1, 2, 3], ["2.1", "3.9", "6.2"], 0.5, through_origin=True)
    >>> through.pui.theta1.lower, through.pui.theta1.upper
    (LowerBound(19, 10), UpperBound(11, 5))
    >>> through.pui.theta1.upper_proof[0]
    Term(row=2, bound='upper', multiplier=Fraction(1, 2))
    """
    columns, question = in_memory(
        x,
        y,
        eps,
        lower=lower,
        upper=upper,
        where=where,
        through_origin=through_origin,
        x_origin=x_origin,
        reading=reading,
        missing=missing,
        eui=eui,
    )
    return Fit(_boundfit.fit_columns(columns, question))


def fit_file(
    path: str | os.PathLike[str],
    x: str | int | Sequence[str | int],
    y: str | int | None = None,
    eps: Number | None = None,
    *,
    eps_column: str | int | None = None,
    lower: str | int | None = None,
    upper: str | int | None = None,
    where: str | Sequence[str] = (),
    through_origin: bool = False,
    x_origin: Number | None = None,
    reading: Reading = "decimal",
    missing: Missing = "refuse",
    eui: bool = True,
    rows: Rows = None,
    without: Rows = None,
    where_row: str | Sequence[str] = (),
    header: bool | None = None,
    delimiter: str | None = None,
    sheet: str | int | None = None,
    skip_lines: int = 0,
    units_row: bool = False,
) -> Fit:
    """Fits columns of a file in any format that the program reads: CSV in many dialects, workbooks, MATLAB, Parquet, Arrow, and
    reductions, packed or not. Columns are named by their headers, or numbered from 1; two in ``x`` are two regressors. Rows are
    numbered from 1 without the header: ``rows="14..36"``. Everything else is as in :func:`fit`.
    """
    question, names, how = of_file(
        x, y, eps, eps_column, lower, upper, where, through_origin, x_origin, reading, missing, eui,
        rows, without, where_row, header, delimiter, sheet, skip_lines, units_row,
    )  # fmt: skip
    return Fit(_boundfit.fit_file(os.fspath(path), names, question, how))


def of_file(
    x: str | int | Sequence[str | int],
    y: str | int | None,
    eps: Number | None,
    eps_column: str | int | None,
    lower: str | int | None,
    upper: str | int | None,
    where: str | Sequence[str],
    through_origin: bool,
    x_origin: Number | None,
    reading: str,
    missing: str,
    eui: bool,
    rows: Rows,
    without: Rows,
    where_row: str | Sequence[str],
    header: bool | None,
    delimiter: str | None,
    sheet: str | int | None,
    skip_lines: int,
    units_row: bool,
) -> tuple[dict[str, Any], list[str], dict[str, Any]]:
    """What is asked of a file, the columns in the order of their roles, and how it is read."""
    regressors = [x] if isinstance(x, (str, int)) else list(x)
    if len(regressors) not in (1, 2):
        raise ValueError(f"x names {len(regressors)} columns: expected one, or two of a model with two regressors")
    columns = [*regressors, y, eps_column, lower, upper]
    question = asked(
        regressors=len(regressors),
        response=y is not None,
        eps=eps,
        lower=lower is not None,
        upper=upper is not None,
        where=where,
        through_origin=through_origin,
        x_origin=x_origin,
        reading=reading,
        missing=missing,
        eui=eui,
        eps_column=eps_column is not None,
    )
    how = table(
        rows_asked=rows,
        without=without,
        where_row=where_row,
        header=header,
        delimiter=delimiter,
        sheet=sheet,
        skip_lines=skip_lines,
        units_row=units_row,
    )
    return question, [str(column) for column in columns if column is not None], how
