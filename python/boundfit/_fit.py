"""What a fit answers."""

from __future__ import annotations

import json
import os
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, Self

from . import _boundfit
from ._answers import counted, value
from ._bounds import Interval, Intervals, LowerBound, Point, ProvedInterval, Term, UpperBound, lower_bound, nearest, upper_bound
from ._columns import Number, Reading, count, flag, fraction, maybe_count, maybe_digits, refuse_vain, several, text
from ._plane import PlaneSet
from ._questions import Asked

if TYPE_CHECKING:
    import numpy
    from matplotlib.axes import Axes

    from .documents import FitDocument


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


class Guarantee(NamedTuple):
    """Which share of further readings lies in the band of the least error bound, at least, if all readings are independent draws
    from one source, whatever it is."""

    confidence: Fraction
    covered: Fraction
    """The share; less than the true one, by less than one in 10^15."""
    readings: int
    assumes: list[str]
    source: str


def _round_outward(vertices: list[Point], rounded: list[list[float]]) -> None:
    """Rounds the least and the largest coordinates of several vertices away from each other."""
    for axis in (0, 1):
        column = [vertex[axis] for vertex in vertices]
        least, most = min(column), max(column)
        for place, value in enumerate(column):
            # Where all are equal the first one is the lower end.
            if value == least and (least != most or place == 0):
                rounded[place][axis] = float(LowerBound(value))
            elif value == most:
                rounded[place][axis] = float(UpperBound(value))


def _axis(ends: Any, name: str) -> list[str] | None:
    return None if ends is None else [text(end) for end in several(ends, name, 2, "both ends of the axis, such as (0, 10)")]


def _length(length: Any, name: str) -> float | None:
    return None if length is None else float(fraction(length, name, "decimal"))


class Fit(Asked, PlaneSet["_boundfit.Fitted"]):
    """All parameters that agree with all readings, with what follows from them. Every number is exact. Of an empty set
    :attr:`contradiction` says why it is.

    The readings stay at hand for further questions: :meth:`status`, :meth:`predict`, :meth:`next`, :meth:`outliers`, :meth:`range` and
    :meth:`windows`. Columns in memory are kept for that as they were, in the copy from which they were fitted. A fit can be pickled:
    its readings are, or the path of their file, and it is fitted again where it is read.
    """

    __slots__ = ("_core", "_how")

    def __init__(self, readings: _boundfit.Readings, eui: bool = True, confidence: Number | None = None) -> None:
        super().__init__(readings)
        eui = flag(eui, "eui")
        self._core = readings.fit(eui, confidence)
        self._how = eui, confidence

    def __reduce__(self) -> Any:
        # Readings are less than what follows from them; those of a file are its path.
        return Fit, (self._readings, *self._how)

    def __copy__(self) -> Self:
        # Nothing changes a fit.
        return self

    def __deepcopy__(self, memo: Any) -> Self:
        return self

    @property
    def rows(self) -> int:
        """How many readings are fitted."""
        return self._core.rows

    @property
    def rows_total(self) -> int:
        """How many rows there are, fitted or not."""
        return self._core.rows_total

    @property
    def reading(self) -> Reading:
        """What floats mean: their shortest text, ``"decimal"``, or what is stored, ``"binary64"``."""
        return self._core.reading

    @property
    def witness(self) -> Point | None:
        """A point of the set; ``None`` of an empty one."""
        return self._core.witness()

    @property
    def pui(self) -> Intervals[ProvedInterval] | None:
        """The interval of each parameter over the set, with proofs; ``None`` of an empty set."""
        both = self._core.pui()
        if both is None:
            return None
        intervals = []
        for (lower, lower_terms), (upper, upper_terms) in both:
            lower_proof = tuple(Term(row, bound, times) for (row, bound), times in lower_terms)
            upper_proof = tuple(Term(row, bound, times) for (row, bound), times in upper_terms)
            ends = lower_bound(lower), upper_bound(upper)
            intervals.append(ProvedInterval(*ends, lower_proof, upper_proof, reading=self.reading))
        return Intervals(*intervals)

    @property
    def eui(self) -> Intervals[Interval] | None:
        """How far errors within the bounds can move the least-squares estimate; ``None`` where there is none."""
        both = self._core.eui()
        if both is None:
            return None
        return Intervals(*(Interval(lower_bound(lower), upper_bound(upper), reading=self.reading) for lower, upper in both))

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

    @property
    def guarantee(self) -> Guarantee | None:
        """What is guaranteed of further readings, where ``confidence`` was asked for; ``None`` where there is no least bound."""
        own = json.loads(self._core.json()).get("guarantee")
        if own is None:
            return None
        return Guarantee(value(own["confidence"]), value(own["covered"]), own["readings"], own["assumes"], own["source"])

    def response(self, x: Number, x2: Number | None = None) -> Interval | None:
        """The values of the true line at x, or of the model at two regressors: a guaranteed interval; ``None`` of an empty set.

        A float means what it means in the readings. Where x was counted from an origin, so is this x.

        >>> from boundfit import fit
        >>> fit([0, 1, 2], [0, 1.5, 2], "1/2").response(3)
        Interval(lower=LowerBound(2, 1), upper=UpperBound(4, 1))
        """
        if x2 is None and self._readings.regressors == 2:
            raise ValueError("x2: expected one, as the model has two regressors")
        if x2 is not None and self._readings.regressors == 1:
            raise ValueError("x2: expected none, as the model is a line")
        both = self._core.range(x, 1 if x2 is None else x2)
        return None if both is None else Interval(lower_bound(both[0]), upper_bound(both[1]), reading=self.reading)

    def verify(self) -> None:
        """Recomputes every proof of the answer from the readings.

        :raises ValueError: with the first statement that is false.
        """
        self._core.verify()

    def to_numpy(self, outward: bool = True) -> numpy.ndarray[Any, Any]:
        """The vertices as doubles, one per row. With ``outward`` the box of all vertices is not smaller for the rounding: the
        coordinates that are ends of the intervals are rounded away from the set, others to nearest. A single vertex that is no pair
        of doubles becomes two rows: both corners of the least box around it. Rounded vertices are a picture of the set, not a
        proof: for that take :attr:`vertices`."""
        import numpy

        vertices = self.vertices
        rounded = [[nearest(theta) for theta in vertex] for vertex in vertices]
        if flag(outward, "outward") and vertices:
            if len(vertices) == 1:
                lowest, highest = ([float(own(theta)) for theta in vertices[0]] for own in (LowerBound, UpperBound))
                rounded = [lowest] if lowest == highest else [lowest, highest]
            else:
                _round_outward(vertices, rounded)
        return numpy.array(rounded, dtype=float).reshape(len(rounded), 2)

    def to_dict(self) -> FitDocument:
        """The report as ``boundfit fit --format json`` writes it, schema boundfit/fit/2."""
        document: FitDocument = json.loads(self._core.json())
        return document

    def to_json(self) -> str:
        """The report as JSON text, schema boundfit/fit/2."""
        return self._core.json()

    def report(self, format: str = "text", *, brief: bool = False, full: bool = False, digits: int | None = None) -> str:
        """The report as ``"text"``, ``"markdown"`` or ``"latex"``; the set as ``"wkt"``, ``"ine"`` or ``"ext"``; ``"csv"``;
        :meth:`proof` as ``"proof"``.

        ``brief`` writes ten lines; ``full`` adds proofs, area and centroid, and all estimates of the inverse line."""
        refuse_vain(format, maybe_digits(digits), flag(brief, "brief"), flag(full, "full"))
        if format == "proof":
            return self.proof()
        return self._core.text(format, flag(brief, "brief"), flag(full, "full"), maybe_digits(digits))

    def to_csv(self, path: str | os.PathLike[str] | None = None) -> bytes:
        """The columns in memory as CSV, every number exactly as it was read, and row K behind K lines: the bytes that proofs are
        about. The fit of a reduction in memory has the text of the reduction. They are also written to ``path``, if there is one.

        >>> from boundfit import fit
        >>> fit([0, 1, 2], ["0", "1.50", "1/3"], 1).to_csv()
        b'x,y\\n0,0\\n1,1.50\\n2,1/3\\n'

        :raises ValueError: where the readings come from a file.
        """
        text = self._readings.csv()
        if text is None:
            raise ValueError("the readings come from a file, which proofs are about as it is")
        if path is not None:
            with open(os.fspath(path), "wb") as file:
                file.write(text)
        return text

    def proof(self) -> str:
        """The proof of the answer as JSON text, which :func:`boundfit.verify` and ``boundfit verify`` check against the file; of
        columns in memory, against the bytes of :meth:`to_csv`.

        >>> from boundfit import fit, verify
        >>> through = fit([0, 1, 2], [0.1, 1.5, 2], "1/2")
        >>> verify(through.proof(), through.to_csv())
        True

        :raises ValueError: where the readings come from a file that is not plain delimited text, or from a reduction.
        """
        proof = self._readings.proof() if self._readings.is_in_memory else self._core.proof()
        if proof is None:
            raise ValueError(
                "a proof is about the rows of plain delimited text, and the file is none that the checkers read: save the table as "
                "CSV, or hand over its columns"
            )
        return proof

    def figure(
        self,
        figure: str = "fps",
        format: str = "svg",
        *,
        title: str | None = None,
        x_unit: str | None = None,
        y_unit: str | None = None,
        x_label: str | None = None,
        y_label: str | None = None,
        x_range: tuple[Number, Number] | None = None,
        y_range: tuple[Number, Number] | None = None,
        width: float | None = None,
        font_size: float | None = None,
        dpi: int | None = None,
        greyscale: bool = False,
        real_text: bool = False,
        flip: bool = False,
        directions: int = 16,
        scaled: bool = False,
    ) -> bytes:
        """A figure as the bytes of a file: ``"svg"``, ``"png"``, ``"pdf"``, ``"tikz"`` (a picture for ``\\input`` in LaTeX) or
        ``"tex"`` (a document with that picture). Figures are ``"data"``, ``"eui"``, ``"pui"``, ``"fps"``, ``"corridor"``,
        ``"directions"``, ``"status"``, ``"outliers"``, ``"range"`` and ``"next"``.

        ``width`` is in millimetres, ``font_size`` in points, ``dpi`` of a PNG alone; ``real_text`` keeps the texts of an SVG. An
        empty title, or label of an axis, leaves it out. ``directions`` is about the figure of that name; with ``scaled`` they are spread
        evenly where the box of both intervals is a square.

        :raises ValueError: where a value is none that the program takes.
        """
        labels: dict[str, Any] = {
            "title": title, "x_unit": x_unit, "y_unit": y_unit, "x_label": x_label, "y_label": y_label,
            "x_range": _axis(x_range, "x_range"), "y_range": _axis(y_range, "y_range"),
            "width": _length(width, "width"), "font_size": _length(font_size, "font_size"),
            "dpi": maybe_count(dpi, "dpi", 30, 1200), "directions": count(directions, "directions", 3, 1000),
            "greyscale": flag(greyscale, "greyscale"), "real_text": flag(real_text, "real_text"),
            "flip": flag(flip, "flip"), "scaled": flag(scaled, "scaled"),
        }  # fmt: skip
        for key in ("title", "x_unit", "y_unit", "x_label", "y_label"):
            if not isinstance(labels[key], str | None):
                raise ValueError(f"{key}={labels[key]!r}: expected a text")
        return _boundfit.figure(self._core, figure, format, labels)

    def svg(
        self,
        figure: str = "fps",
        *,
        title: str | None = None,
        x_unit: str | None = None,
        y_unit: str | None = None,
        flip: bool = False,
    ) -> str:
        """A figure as SVG; :meth:`figure` has all options and formats."""
        return self.figure(figure, title=title, x_unit=x_unit, y_unit=y_unit, flip=flip).decode()

    def png(self, figure: str = "fps", *, title: str | None = None, flip: bool = False) -> bytes:
        """A figure as the bytes of a PNG."""
        return self.figure(figure, "png", title=title, flip=flip)

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the set on axes of matplotlib, with the box of the intervals and the estimates; ``style`` is that of the filled
        polygon. Of an unbounded set the part within the axes' limits is drawn, of an empty one the title says that it is."""
        from ._plot import plot

        return plot(self, ax, **style)

    def lesson(self, path: str | os.PathLike[str], *, title: str | None = None) -> None:
        """Writes the web page that teaches about these readings."""
        page = _boundfit.lesson(self._core, title)
        with open(os.fspath(path), "w", encoding="utf-8", newline="\n") as file:
            file.write(page)

    def __repr__(self) -> str:
        if self.is_empty:
            return f"<boundfit.Fit of {counted(self.rows, 'reading')}: no parameters agree with all of them>"
        pui = self.pui
        assert pui is not None
        ends = []
        for name, interval in zip(pui._fields, pui, strict=True):
            ends.append(f"{name} in {interval:.6}")
        return f"<boundfit.Fit of {counted(self.rows, 'reading')}: {self.kind}, about {', '.join(ends)}>"

    def __str__(self) -> str:
        return self._core.text("text", False, False, None)

    def _repr_html_(self) -> str:
        from ._html import of_fit

        return of_fit(self)
