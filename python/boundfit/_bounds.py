"""Ends of intervals: exact fractions whose doubles do not cut anything off."""

from __future__ import annotations

import math
import re
import sys
from dataclasses import dataclass
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal
from fractions import Fraction
from typing import NamedTuple

#: Both parameters.
Point = tuple[Fraction, Fraction]


def nearest(value: Fraction) -> float:
    """The nearest double; of a bound that on its outer side."""
    if isinstance(value, (LowerBound, UpperBound)):
        return float(value)
    return _nearest(value)


def _nearest(value: Fraction) -> float:
    try:
        return value.numerator / value.denominator
    except OverflowError:
        return math.inf if value > 0 else -math.inf


class LowerBound(Fraction):
    """A lower end: a ``Fraction`` whose ``float()`` is the largest double that is not above it.

    >>> end = LowerBound(1, 3)
    >>> Fraction(float(end)) <= end
    True
    """

    __slots__ = ()

    def __float__(self) -> float:
        double = _nearest(self)
        if math.isinf(double):
            return min(double, sys.float_info.max)
        return math.nextafter(double, -math.inf) if Fraction(double) > self else double


class UpperBound(Fraction):
    """An upper end: a ``Fraction`` whose ``float()`` is the smallest double that is not below it.

    >>> end = UpperBound(1, 3)
    >>> Fraction(float(end)) >= end
    True
    """

    __slots__ = ()

    def __float__(self) -> float:
        double = _nearest(self)
        if math.isinf(double):
            return max(double, -sys.float_info.max)
        return math.nextafter(double, math.inf) if Fraction(double) < self else double


def lower_bound(value: Fraction | None) -> LowerBound | None:
    return None if value is None else LowerBound(value.numerator, value.denominator)


def upper_bound(value: Fraction | None) -> UpperBound | None:
    return None if value is None else UpperBound(value.numerator, value.denominator)


@dataclass(frozen=True, slots=True)
class Interval:
    """The values between two ends, which belong to it; ``None`` where there is no end.

    >>> Interval(LowerBound(1, 2), None)
    Interval(lower=LowerBound(1, 2), upper=None)
    """

    lower: LowerBound | None
    upper: UpperBound | None

    @property
    def width(self) -> Fraction | None:
        """The distance of the ends; ``None`` where one is missing."""
        return None if self.lower is None or self.upper is None else self.upper - self.lower

    def __contains__(self, value: Fraction | float) -> bool:
        return (self.lower is None or self.lower <= value) and (self.upper is None or value <= self.upper)

    def __array__(self, dtype: object = None, copy: bool | None = None) -> object:
        import numpy

        return numpy.array(self.to_floats(), dtype=float if dtype is None else dtype)  # type: ignore[call-overload]

    def __format__(self, spec: str) -> str:
        """Both ends as decimals of so many digits, rounded outward.

        >>> f"{Interval(LowerBound(1, 3), UpperBound(2, 3)):.4}"
        '[0.3333, 0.6667]'
        """
        if not spec:
            return str(self)
        digits = re.fullmatch(r"\.([1-9]\d{0,3})g?", spec)
        if digits is None:
            raise ValueError(f"format {spec!r} of an interval: expected how many digits, such as .5")
        return f"[{decimal(self.lower, int(digits[1]), True)}, {decimal(self.upper, int(digits[1]), False)}]"

    def to_floats(self) -> tuple[float, float]:
        """Both ends as doubles, rounded outward; infinite where there is none."""
        lower = -math.inf if self.lower is None else float(self.lower)
        return lower, math.inf if self.upper is None else float(self.upper)


def decimal(value: Fraction | None, digits: int, is_lower: bool) -> str:
    """An end as a decimal of so many digits, down for a lower one and up for any other."""
    if value is None:
        return "-inf" if is_lower else "inf"
    context = Context(prec=digits, rounding=ROUND_FLOOR if is_lower else ROUND_CEILING)
    return format(context.divide(Decimal(value.numerator), Decimal(value.denominator)), "g")


class Term(NamedTuple):
    """A multiple of the bound that a reading or a condition sets: of proofs.

    ``row`` counts from 1 and is ``None`` for a condition, or the text of the row's identity where the table was fitted in parts that
    name one; ``bound`` is ``"upper"``, ``"lower"`` or ``"where:K"``.
    """

    row: int | str | None
    bound: str
    multiplier: Fraction


@dataclass(frozen=True, slots=True)
class ProvedInterval(Interval):
    """An interval with what proves its ends: at most two multiples, which add up to the end's inequality."""

    lower_proof: tuple[Term, ...] = ()
    upper_proof: tuple[Term, ...] = ()


class Intervals(NamedTuple):
    """The intervals of both parameters."""

    theta1: Interval
    theta2: Interval
