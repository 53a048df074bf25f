"""Lines that agree with readings whose x have errors too."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from ._answers import Answer, intervals, number, point, proved_intervals, value
from ._bounds import Interval, Intervals, Point, ProvedInterval

if TYPE_CHECKING:
    from .documents import XErrorDocument


class Side(NamedTuple):
    """The lines of one side: those that do not fall, or do not rise; or all, where they are one set."""

    side: str
    """``"+"``, ``"-"`` or ``"both"``."""
    kind: str
    vertices: list[Point]
    pui: Intervals[ProvedInterval] | None
    """``None`` of an empty set."""
    area: Fraction | None


class Factor(NamedTuple):
    """The least factor on all bounds, of x and of y, under which any line agrees."""

    lower: Fraction
    """Less than the least factor, or the least factor itself where ``upper`` is equal."""
    upper: Fraction
    """At least the least factor."""
    attained: bool
    """Whether some line agrees under ``upper``, and not only under every larger factor."""
    theta: Point | None
    """That line; ``None`` where there is none."""

    @property
    def value(self) -> Fraction | None:
        """The least factor itself; ``None`` where only an enclosure is known, as of an irrational factor."""
        return self.upper if self.lower == self.upper else None


class XErrorFit(Answer["XErrorDocument"]):
    """All lines that agree with all readings when x has errors too: one set, or one for each sign of theta1. Every number is exact.

    >>> import boundfit
    >>> fit = boundfit.fit([0, 1, 2], [0, 1.5, 2], "1/2", x_eps="1/10")
    >>> [(own.side, own.kind) for own in fit.sides]
    [('+', 'polygon'), ('-', 'empty')]
    >>> fit.pui.theta1.upper
    UpperBound(5, 3)
    """

    __slots__ = ()

    @property
    def is_empty(self) -> bool:
        """Whether no line agrees with all readings."""
        return all(own.kind == "empty" for own in self.sides)

    @property
    def sides(self) -> list[Side]:
        """The sets, of which every line that agrees is in one."""

        def one(own: Any) -> Side:
            fps = own["fps"]
            vertices = [point(vertex["theta"]) for vertex in fps["vertices"]]
            pui = proved_intervals(own["pui"], fps["kind"], self._reading)
            return Side(own["side"], fps["kind"], vertices, pui, number(fps["area"]))

        return [one(own) for own in self._document["sides"]]

    @property
    def pieces(self) -> int:
        """In how many pieces the sets lie: 0, 1 or 2."""
        pieces: int = self._document["pieces"]
        return pieces

    @property
    def pui(self) -> Intervals[ProvedInterval] | None:
        """The interval of each parameter over all sets, with proofs; ``None`` where they are empty."""
        return proved_intervals(self._document["pui"], "empty" if self.is_empty else "sides", self._reading)

    @property
    def central(self) -> Point | None:
        """The middle of both intervals; ``None`` unless they are bounded."""
        own = self._document["central"]
        return None if own is None else point(own["theta"])

    @property
    def factor(self) -> Factor | None:
        """By which factor all bounds may shrink, or have to grow; ``None`` where no factor helps."""
        own = self._document["factor"]
        if own is None:
            return None
        lower, upper = value(own["lower"]), value(own["upper"])
        return Factor(lower, upper, own["attained"], None if own["theta"] is None else point(own["theta"]))

    @property
    def least_squares(self) -> Point | None:
        """The least-squares estimate, as if x were exact; ``None`` where there is none."""
        own = self._document["least_squares"]
        return None if own is None else point(own["theta"])

    @property
    def eui(self) -> Intervals[Interval] | None:
        """How far errors of y within their bounds can move the least-squares estimate."""
        return intervals(self._document["eui"], self._reading)

    def __repr__(self) -> str:
        return f"<boundfit.XErrorFit: {', '.join(f'{own.side} {own.kind}' for own in self.sides)}>"
