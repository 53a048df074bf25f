"""What any set in the plane is asked."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Generic, Protocol, TypeVar

from ._bounds import Point
from ._columns import Number, several


class _Region(Protocol):
    @property
    def kind(self) -> str: ...
    def vertices(self) -> list[Point]: ...
    def directions(self, lines: bool) -> list[Point]: ...
    def area(self) -> Fraction | None: ...
    def contains(self, theta1: Any, theta2: Any) -> bool: ...


Region = TypeVar("Region", bound=_Region)


class PlaneSet(Generic[Region]):
    """An intersection of half-planes. Every number is exact."""

    __slots__ = ()

    _core: Region

    @property
    def kind(self) -> str:
        """Which kind of set it is: ``"polygon"``, ``"empty"``, ``"point"``, ``"segment"``, ``"unbounded-polygon"`` and so on."""
        return self._core.kind

    @property
    def is_empty(self) -> bool:
        """Whether there is no point in it."""
        return self._core.kind == "empty"

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
    def area(self) -> Fraction | None:
        """The area of the set; ``None`` where it is infinite."""
        return self._core.area()

    def __contains__(self, point: tuple[Number, Number]) -> bool:
        return self._core.contains(*several(point, "point", 2, "both parameters, such as (1, 0)"))
