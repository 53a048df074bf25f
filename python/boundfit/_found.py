"""What is answered about readings beyond their set: of each other, of further ones, and of what they are like."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from ._answers import Answer, counted, interval, intervals, number, point, proved_intervals, terms, value
from ._bounds import Interval, Intervals, Point, ProvedInterval, Term
from ._columns import Reading
from ._open import InnerLowerBound, InnerUpperBound, OpenInterval

if TYPE_CHECKING:
    from .documents import LinearRangeDocument, NextReadingDocument, OutliersDocument, PredictionDocument, StatusesDocument, WindowDocument


class RowStatus(NamedTuple):
    """What a reading and a set say of each other. Statuses are ``"inner"``, ``"boundary"``, ``"outer"``, ``"strictly outer"`` and
    ``"outlier"`` (docs/status.md); ``None`` where the set is empty."""

    row: int
    status: str | None
    """Against the set of all readings."""
    leverage: Fraction | None
    """Half the range of the model over the set at the reading, over half the reading's width."""
    residual: Fraction | None
    """The distance of both middles over the same."""
    without: str | None
    """Against the set of the others; of further readings as ``status``."""
    without_leverage: Fraction | None
    without_residual: Fraction | None


class Widened(NamedTuple):
    """A reading whose bound has to be wider."""

    row: int
    factor: Fraction
    half_width: Fraction


class Repair(NamedTuple):
    """The least total widening under which something meets all bounds."""

    total: Fraction | None
    """The sum of all factors, each at least 1; ``None`` where conditions contradict each other."""
    theta: Point | None
    """Parameters that meet the wider bounds."""
    widened: list[Widened]


class Statuses(Answer["StatusesDocument"]):
    """What every reading and the set of all, and that of the others, say of each other."""

    __slots__ = ()

    def __repr__(self) -> str:
        readings = counted(len(self._document["rows"]), "reading")
        return f"<boundfit.Statuses of {readings}: {self.kind}, decided by rows {self.deciding}>"

    @property
    def kind(self) -> str:
        """Which kind of set there is: of :attr:`boundfit.Fit.kind`."""
        kind: str = self._document["set"]["kind"]
        return kind

    @property
    def contradiction(self) -> tuple[Term, ...] | None:
        """Of an empty set bounds that contradict each other."""
        own = self._document["set"]["contradiction"]
        return None if own is None else terms(own)

    @property
    def deciding(self) -> list[int]:
        """The rows without which the set of the others may be another one."""
        return list(self._document["deciding"])

    @property
    def rows(self) -> list[RowStatus]:
        """All readings, in order of rows."""
        return [_status(own, "without") for own in self._document["rows"]]

    @property
    def new(self) -> list[RowStatus]:
        """The further readings, which change nothing."""
        return [_status(own, "") for own in self._document.get("new", {"rows": []})["rows"]]

    @property
    def repair(self) -> Repair | None:
        """The least total widening, where it is asked for."""
        own = self._document.get("repair")
        if own is None:
            return None
        widened = [Widened(one["row"], value(one["factor"]), value(one["half_width"])) for one in own["widened"]]
        return Repair(number(own["total"]), None if own["theta"] is None else point(own["theta"]), widened)


def _status(own: Any, without: str) -> RowStatus:
    against_all = own["status"], number(own["leverage"]), number(own["residual"])
    if not without:
        return RowStatus(own["row"], *against_all, *against_all)
    return RowStatus(own["row"], *against_all, own["without"], number(own["without_leverage"]), number(own["without_residual"]))


class PredictedValue(NamedTuple):
    """What is predicted at one x, or at one pair of regressors."""

    x: Fraction | Point
    line: Interval
    """The values of the true line there, if all bounds hold."""
    reading: Interval | None
    """Where a further reading lies; ``None`` where nothing is known of its error."""


class PossibleX(NamedTuple):
    """The x that a reading may come from."""

    y: Fraction
    x: list[Interval]
    """One interval or two; none where no x gives such a reading. An end may be excluded: no line gives the reading there."""


def _source(own: Any, reading: Reading) -> Interval:
    lower_included, upper_included = own["lower_included"] is not False, own["upper_included"] is not False
    return replace(interval(own, reading), lower_included=lower_included, upper_included=upper_included)


class Prediction(Answer["PredictionDocument"]):
    """Where the line runs, where further readings lie, and where readings may come from."""

    __slots__ = ()

    def __repr__(self) -> str:
        readings = counted(len(self._document["from"]), "reading")
        return f"<boundfit.Prediction at {len(self._document['at'])} x and from {readings}: {self.kind}>"

    @property
    def kind(self) -> str:
        """Which kind of set there is; an empty one predicts nothing."""
        kind: str = self._document["fps"]["kind"]
        return kind

    @property
    def at(self) -> list[PredictedValue]:
        """The values asked for, in their order."""

        def one(own: Any) -> PredictedValue:
            x: Fraction | Point = point(own["x"]) if isinstance(own["x"], list) else value(own["x"])
            return PredictedValue(x, interval(own["line"], self._reading), None if own["reading"] is None else interval(own["reading"], self._reading))

        return [one(own) for own in self._document["at"]]

    @property
    def from_(self) -> list[PossibleX]:
        """The readings asked about, in their order."""
        return [PossibleX(value(own["y"]), [_source(one, self._reading) for one in own["x"]]) for own in self._document["from"]]


class Outliers(Answer["OutliersDocument"]):
    """The fewest readings to leave out so that some parameters agree with all others, and what is left then."""

    __slots__ = ()

    def __repr__(self) -> str:
        if self.least is None:
            return "<boundfit.Outliers: the conditions contradict each other>"
        sets = counted(len(self.sets), "set")
        return f"<boundfit.Outliers: {counted(self.least, 'reading')} to leave out, {sets if self.is_complete else f'{sets} and more'}>"

    @property
    def least(self) -> int | None:
        """How many have to be left out; ``None`` where conditions contradict each other."""
        least: int | None = self._document["least"]
        return least

    @property
    def sets(self) -> list[list[int]]:
        """Every set of so many rows without which something is left."""
        return [list(rows) for rows in self._document["sets"]]

    @property
    def is_complete(self) -> bool:
        """Whether all such sets are listed."""
        complete: bool = self._document["complete"]
        return complete

    @property
    def pieces(self) -> list[list[Point]]:
        """What is left without each of the sets: its corners."""
        return [[point(vertex["theta"]) for vertex in piece] for piece in self._document["pieces"]]

    @property
    def pui(self) -> Intervals[Interval] | None:
        """The intervals of both parameters over all that is left."""
        return intervals(self._document["pui"], self._reading)

    @property
    def growth(self) -> list[Growth]:
        """How the set grows when up to so many readings may be missed."""
        return [
            Growth(own["most"], own["pieces"], own["holes"], intervals(own["pui"], self._reading), number(own["area"]))
            for own in self._document["growth"]
        ]


class Growth(NamedTuple):
    """The parameters that miss at most so many readings."""

    most: int
    pieces: int
    holes: int
    pui: Intervals[Interval] | None
    area: Fraction | None


class Run(NamedTuple):
    """A run of readings, in order of x or of rows, that some parameters agree with, and that cannot be made longer."""

    first: int
    """Its first and last place in the order, from 1."""
    last: int
    rows: tuple[int, int]
    """The rows that stand there."""
    x: tuple[Fraction, Fraction] | None
    """Its least and largest x; ``None`` with two regressors."""


class LinearRange(Answer["LinearRangeDocument"]):
    """Every run of readings that some parameters agree with."""

    __slots__ = ()

    def __repr__(self) -> str:
        own = self.longest
        longest = "no reading fits" if own is None else f"the longest from row {own.rows[0]} to row {own.rows[1]}"
        return f"<boundfit.LinearRange: {counted(len(self.runs), 'run')}, {longest}>"

    @property
    def order(self) -> list[int]:
        """The rows in the order that is used."""
        return list(self._document["order"])

    @property
    def runs(self) -> list[Run]:
        """All runs, from the first."""
        return [
            Run(own["first"], own["last"], tuple(own["rows"]), None if own["x"] is None else point(own["x"]))
            for own in self._document["parts"]
        ]

    def _run(self, ends: Any) -> Run | None:
        return next((run for run in self.runs if [run.first, run.last] == ends), None)

    @property
    def longest(self) -> Run | None:
        """The run with the most readings; ``None`` where no reading fits, not even alone."""
        return self._run(self._document["longest"])

    @property
    def widest(self) -> Run | None:
        """The run that is widest in x."""
        return self._run(self._document["widest"])

    @property
    def fewest(self) -> list[Run]:
        """As few runs as can be that have every reading."""
        asked = self._document["fewest"]
        return [run for run in self.runs if [run.first, run.last] in asked]

    @property
    def pui(self) -> Intervals[ProvedInterval] | None:
        """The intervals of both parameters of the longest run."""
        own = self._document["longest_fit"]
        return None if own is None else proved_intervals(own["pui"], own["kind"], self._reading)


class Best(NamedTuple):
    """The best x for a goal."""

    goal: str
    """``"theta1"`` or ``"theta2"``, the length of its interval, or ``"area"``."""
    now: Fraction | None
    """``None`` without end, or where the fraction is too long to be written."""
    worst: Fraction | None
    """After the worst outcome of a reading at the best x; as ``now``."""
    at: list[Fraction]
    """The best x; empty where the worst outcome leaves the goal as it is at every x of the range."""


class NextReading(Answer["NextReadingDocument"]):
    """Where the next reading certainly makes the set smaller, and which x of a range leaves the least at worst."""

    __slots__ = ()

    def __repr__(self) -> str:
        return f"<boundfit.NextReading: certain in {self.certain}>"

    @property
    def certain(self) -> list[OpenInterval]:
        """The open intervals of x where a reading certainly makes the set smaller; none of an empty set. Ends are rounded inward."""

        def one(own: Any) -> OpenInterval:
            lower, upper = number(own["lower"]), number(own["upper"])
            inner = None if lower is None else InnerLowerBound(lower)
            return OpenInterval(inner, None if upper is None else InnerUpperBound(upper), reading=self._reading)

        return [one(own) for own in self._document["certain"] or ()]

    @property
    def within(self) -> tuple[Fraction, Fraction] | None:
        """The range in which the best x is looked for; ``None`` where it is not known, or the set is empty."""
        own = self._document["within"]
        return None if own is None else (value(own["lower"]), value(own["upper"]))

    @property
    def is_certain_within(self) -> bool | None:
        """``True`` if a reading certainly makes the set smaller somewhere in that range."""
        certain: bool | None = self._document["certain_within"]
        return certain

    @property
    def best(self) -> list[Best]:
        """The best x for each goal."""
        return [
            Best(own["goal"], number(own["now"]), number(own["worst"]), [value(x) for x in own["at"]]) for own in self._document["goals"]
        ]


class WindowFit(NamedTuple):
    """The fit of a window of readings."""

    first_row: int
    last_row: int
    rows: int
    kind: str
    pui: Intervals[ProvedInterval] | None
    """``None`` of an empty set."""
    central: Point | None
    epsilon_min: Fraction | None
    """``None`` unless the readings are of a line under one error bound, and there is no condition."""
    contradiction: tuple[Term, ...] | None
    document: WindowDocument
    """The line that the program writes, schema boundfit/window/1."""


def window(line: str, reading: Reading) -> WindowFit:
    own = json.loads(line)
    certificate, central = own["fps"]["certificate"], own["central"]
    return WindowFit(
        own["first_row"],
        own["last_row"],
        own["rows"],
        own["fps"]["kind"],
        proved_intervals(own["pui"], own["fps"]["kind"], reading),
        None if central is None else point(central["theta"]),
        number(own["epsilon_min"]),
        None if certificate is None else terms(certificate["farkas"]),
        own,
    )
