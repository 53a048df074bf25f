"""Open intervals whose values are promised: their ends are rounded inward."""

from __future__ import annotations

from dataclasses import dataclass, field
from decimal import ROUND_CEILING, ROUND_FLOOR
from fractions import Fraction
from typing import Literal

from ._bounds import Ends, _Bound
from ._columns import Number, fraction


class InnerLowerBound(_Bound):
    """The lower end of an :class:`OpenInterval`: a ``Fraction`` that is rounded up wherever it is rounded."""

    __slots__ = ()

    _rounding = ROUND_CEILING


class InnerUpperBound(_Bound):
    """The upper end of an :class:`OpenInterval`: a ``Fraction`` that is rounded down wherever it is rounded."""

    __slots__ = ()

    _rounding = ROUND_FLOOR


@dataclass(frozen=True, slots=True)
class OpenInterval(Ends[InnerLowerBound, InnerUpperBound]):
    """The values strictly between two ends; ``None`` where there is no end. Ends are rounded inward, so that nothing between the
    rounded ones is outside.

    >>> third = OpenInterval(None, InnerUpperBound(1, 3))
    >>> Fraction(1, 3) in third, f"{third:.4}"
    (False, '(-inf, 0.3333)')
    >>> Fraction(third.to_floats()[1]) < Fraction(1, 3)
    True
    """

    lower: InnerLowerBound | None
    upper: InnerUpperBound | None
    reading: Literal["decimal", "binary64"] = field(default="decimal", kw_only=True, repr=False, compare=False)
    """What a float means that is looked for: its shortest text, or what is stored."""

    _side = "inward"

    def __contains__(self, value: Number) -> bool:
        value = fraction(value, "value", self.reading)
        return (self.lower is None or self.lower < value) and (self.upper is None or value < self.upper)

    def __format__(self, spec: str) -> str:
        """Both ends as decimals of so many digits, rounded inward."""
        if not spec:
            return str(self)
        return f"({self._decimals(spec)})"
