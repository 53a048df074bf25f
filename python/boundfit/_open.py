"""Open intervals whose values are promised: their ends are rounded inward."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from decimal import ROUND_CEILING, ROUND_FLOOR
from fractions import Fraction
from typing import Literal

from ._bounds import _Bound, decimal
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
class OpenInterval:
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

    def __iter__(self) -> Iterator[InnerLowerBound | InnerUpperBound | None]:
        """Both ends: ``lower, upper = interval``."""
        return iter((self.lower, self.upper))

    @property
    def width(self) -> Fraction | None:
        """The distance of the ends; ``None`` where one is missing."""
        return None if self.lower is None or self.upper is None else self.upper - self.lower

    def __contains__(self, value: Number) -> bool:
        value = fraction(value, "value", self.reading)
        return (self.lower is None or self.lower < value) and (self.upper is None or value < self.upper)

    def __array__(self, dtype: object = None, copy: bool | None = None) -> object:
        import numpy

        kind = numpy.dtype(float if dtype is None else dtype)  # type: ignore[call-overload]
        if kind.kind not in "fO":
            raise ValueError(f"dtype={kind}: expected a type of floats, to which the ends are rounded inward, or object")
        doubles = self.to_floats()
        with numpy.errstate(over="ignore"):
            ends = numpy.array(doubles, dtype=kind)
        # A short float is rounded to nearest.
        if float(ends[0]) < doubles[0]:
            ends[0] = numpy.nextafter(ends[0], kind.type(math.inf))
        if float(ends[1]) > doubles[1]:
            ends[1] = numpy.nextafter(ends[1], kind.type(-math.inf))
        return ends

    def __format__(self, spec: str) -> str:
        """Both ends as decimals of so many digits, rounded inward."""
        if not spec:
            return str(self)
        digits = re.fullmatch(r"\.([1-9]\d{0,3})g?", spec)
        if digits is None:
            raise ValueError(f"format {spec!r} of an interval: expected how many digits, such as .5")
        lower = "-inf" if self.lower is None else decimal(self.lower, int(digits[1]), False)
        upper = "inf" if self.upper is None else decimal(self.upper, int(digits[1]), True)
        return f"({lower}, {upper})"

    def to_floats(self) -> tuple[float, float]:
        """Both ends as doubles, rounded inward; infinite where there is none."""
        lower = -math.inf if self.lower is None else float(self.lower)
        return lower, math.inf if self.upper is None else float(self.upper)
