"""Ends of intervals: exact fractions whose doubles do not cut anything off."""

from __future__ import annotations

import math
import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field
from decimal import MAX_EMAX, MAX_PREC, MIN_EMIN, ROUND_CEILING, ROUND_FLOOR, Context, Decimal, localcontext
from fractions import Fraction
from typing import Any, ClassVar, Generic, Literal, NamedTuple, TypeVar

from ._columns import Number, fraction

#: Both parameters.
Point = tuple[Fraction, Fraction]


def nearest(value: Fraction) -> float:
    """The nearest double; of a bound that on its side."""
    if isinstance(value, _Bound):
        return float(value)
    return _nearest(value)


def _nearest(value: Fraction) -> float:
    try:
        return value.numerator / value.denominator
    except OverflowError:
        return math.inf if value > 0 else -math.inf


class _Bound(Fraction):
    """An end of an interval, which is written on one side of it: the outer one, unless the interval is open."""

    __slots__ = ()

    _rounding: ClassVar[str]

    @property
    def is_floor(self) -> bool:
        """Whether it is rounded down."""
        return self._rounding == ROUND_FLOOR

    def __float__(self) -> float:
        double = _nearest(self)
        if self.is_floor:
            if math.isinf(double):
                return min(double, sys.float_info.max)
            return math.nextafter(double, -math.inf) if Fraction(double) > self else double
        if math.isinf(double):
            return max(double, -sys.float_info.max)
        return math.nextafter(double, math.inf) if Fraction(double) < self else double

    def __format__(self, spec: str) -> str:
        """As a float is formatted (``.3f``, ``.4g``, ``.2e``, ``.1%``, with sign, width and commas), but rounded outward. An
        exponent has no zeros before it (``1.00e-7``). Without digits and type it is the fraction."""
        found = _SPEC.fullmatch(spec)
        if found is None:
            raise ValueError(f"format {spec!r} of a bound: expected one of a float, such as .3f, .4g or 10.2e")
        if found["digits"] is None and found["kind"] is None:
            return format(str(self), spec)
        # The caller's context may have fewer digits, and other ways to round.
        with localcontext(Context(prec=MAX_PREC, rounding=self._rounding, Emax=MAX_EMAX, Emin=MIN_EMIN)):
            return self._formatted(found)

    def _formatted(self, found: re.Match[str]) -> str:
        kind, digits = found["kind"] or "g", 6 if found["digits"] is None else int(found["digits"])
        if kind in "fF%":
            rounded = self._to_places(digits + (2 if kind == "%" else 0))
        else:
            digits = digits + 1 if kind in "eE" else max(digits, 1)
            context = Context(prec=digits, rounding=self._rounding, Emax=MAX_EMAX, Emin=MIN_EMIN)
            rounded = context.divide(Decimal(self.numerator), Decimal(self.denominator))
        precision = f".{found['digits'] or 6}"
        if kind in "gG":
            # As of a float zeros at the end are not written, but where no exponent is.
            rounded, precision = rounded.normalize(Context(prec=digits, Emax=MAX_EMAX, Emin=MIN_EMIN)), ""
            if 0 < rounded.adjusted() < digits and rounded == rounded.to_integral_value():
                rounded = rounded.quantize(Decimal(1))
        return format(rounded, f"{found['before']}{precision}{kind}")

    def _to_places(self, places: int) -> Decimal:
        """The nearest decimal with so many digits behind the point on the outer side."""
        scaled = self.numerator * 10**places
        count = scaled // self.denominator if self.is_floor else -(-scaled // self.denominator)
        return Decimal(count).scaleb(-places, Context(prec=MAX_PREC, Emax=MAX_EMAX, Emin=MIN_EMIN))

    def __round__(self, ndigits: int | None = None) -> Any:
        """The nearest integer on the outer side, or the bound with so many digits behind the point."""
        power = Fraction(10) ** (ndigits or 0)
        scaled = Fraction(self) * power
        count = math.floor(scaled) if self.is_floor else math.ceil(scaled)
        if ndigits is None:
            return count
        end = count / power
        return type(self)(end.numerator, end.denominator)


#: What a format of a float may be, but for the letter n, which asks for words of a place.
_SPEC = re.compile(
    r"(?P<before>(?:.?[<>=^])?[-+ ]?z?0?\d*,?)(?:\.(?P<digits>\d{1,4}))?(?P<kind>[eEfFgG%])?", re.DOTALL
)


class LowerBound(_Bound):
    """A lower end: a ``Fraction`` that is rounded down wherever it is rounded: by ``float()``, ``round()`` and formats.

    >>> end = LowerBound(1, 3)
    >>> Fraction(float(end)) <= end
    True
    >>> f"{end:.3f}", round(end, 2)
    ('0.333', LowerBound(33, 100))
    """

    __slots__ = ()

    _rounding = ROUND_FLOOR


class UpperBound(_Bound):
    """An upper end: a ``Fraction`` that is rounded up wherever it is rounded: by ``float()``, ``round()`` and formats.

    >>> end = UpperBound(1, 3)
    >>> Fraction(float(end)) >= end
    True
    >>> f"{end:.3f}", round(end, 2)
    ('0.334', UpperBound(17, 50))
    """

    __slots__ = ()

    _rounding = ROUND_CEILING


def lower_bound(value: Fraction | None) -> LowerBound | None:
    return None if value is None else LowerBound(value.numerator, value.denominator)


def upper_bound(value: Fraction | None) -> UpperBound | None:
    return None if value is None else UpperBound(value.numerator, value.denominator)


Lower = TypeVar("Lower", bound=_Bound)
Upper = TypeVar("Upper", bound=_Bound)


class Ends(Generic[Lower, Upper]):
    """What intervals say of their ends, each of which is rounded to its own side; ``None`` where there is no end."""

    __slots__ = ()

    lower: Lower | None
    upper: Upper | None
    _side: ClassVar[str]

    def __iter__(self) -> Iterator[Lower | Upper | None]:
        """Both ends: ``lower, upper = interval``."""
        return iter((self.lower, self.upper))

    @property
    def width(self) -> Fraction | None:
        """The distance of the ends; ``None`` where one is missing."""
        return None if self.lower is None or self.upper is None else self.upper - self.lower

    def __array__(self, dtype: object = None, copy: bool | None = None) -> object:
        import numpy

        kind = numpy.dtype(float if dtype is None else dtype)  # type: ignore[call-overload]
        if kind.kind not in "fO":
            raise ValueError(f"dtype={kind}: expected a type of floats, to which the ends are rounded {self._side}, or object")
        doubles = self.to_floats()
        with numpy.errstate(over="ignore"):
            ends = numpy.array(doubles, dtype=kind)
        # A short float is rounded to nearest.
        for place, end in enumerate((self.lower, self.upper)):
            if end is not None and (short := float(ends[place])) != doubles[place] and (short > doubles[place]) == end.is_floor:
                ends[place] = numpy.nextafter(ends[place], kind.type(-math.inf if end.is_floor else math.inf))
        return ends

    def to_floats(self) -> tuple[float, float]:
        """Both ends as doubles, each rounded to its side; infinite where there is none."""
        lower = -math.inf if self.lower is None else float(self.lower)
        return lower, math.inf if self.upper is None else float(self.upper)

    def _decimals(self, spec: str) -> str:
        """Both ends as decimals of so many digits."""
        digits = re.fullmatch(r"\.([1-9]\d{0,3})g?", spec)
        if digits is None:
            raise ValueError(f"format {spec!r} of an interval: expected how many digits, such as .5")
        lower = "-inf" if self.lower is None else decimal(self.lower, int(digits[1]), self.lower.is_floor)
        upper = "inf" if self.upper is None else decimal(self.upper, int(digits[1]), self.upper.is_floor)
        return f"{lower}, {upper}"


@dataclass(frozen=True, slots=True)
class Interval(Ends[LowerBound, UpperBound]):
    """The values between two ends, which belong to it unless they are said to be excluded; ``None`` where there is no end.

    >>> Interval(LowerBound(1, 2), None)
    Interval(lower=LowerBound(1, 2), upper=None)
    >>> 1 in Interval(None, UpperBound(1), upper_included=False)
    False
    """

    lower: LowerBound | None
    upper: UpperBound | None
    reading: Literal["decimal", "binary64"] = field(default="decimal", kw_only=True, repr=False, compare=False)
    """What a float means that is looked for: its shortest text, or what is stored."""
    lower_included: bool = field(default=True, kw_only=True, repr=False)
    """Whether the lower end belongs to the interval: not always where :attr:`boundfit.PossibleX.x` has it."""
    upper_included: bool = field(default=True, kw_only=True, repr=False)

    _side = "outward"

    def __repr__(self) -> str:
        excluded = "".join(f", {end}_included=False" for end in ("lower", "upper") if not getattr(self, f"{end}_included"))
        return f"{type(self).__name__}(lower={self.lower!r}, upper={self.upper!r}{excluded})"

    def __contains__(self, value: Number) -> bool:
        value = fraction(value, "value", self.reading)
        from_below = self.lower is None or self.lower < value or (self.lower_included and self.lower == value)
        return from_below and (self.upper is None or value < self.upper or (self.upper_included and self.upper == value))

    def __format__(self, spec: str) -> str:
        """Both ends as decimals of so many digits, rounded outward, with a round bracket where an end is excluded.

        >>> f"{Interval(LowerBound(1, 3), UpperBound(2, 3)):.4}"
        '[0.3333, 0.6667]'
        """
        if not spec:
            return str(self)
        return f"{'[' if self.lower_included else '('}{self._decimals(spec)}{']' if self.upper_included else ')'}"


def decimal(value: Fraction, digits: int, is_floor: bool) -> str:
    """A fraction as a decimal of so many digits, rounded down or up."""
    context = Context(prec=digits, rounding=ROUND_FLOOR if is_floor else ROUND_CEILING)
    return format(context.divide(Decimal(value.numerator), Decimal(value.denominator)), "g")


class Term(NamedTuple):
    """A multiple of the bound that a reading or a condition sets: of proofs.

    ``row`` counts from 1 and is ``None`` for a condition, or the text of the row's identity where the table was fitted in parts that
    name one; ``bound`` is ``"upper"``, ``"lower"`` or ``"where:K"``, of an equation ``"where:K upper"`` or ``"where:K lower"``.
    """

    row: int | str | None
    bound: str
    multiplier: Fraction


@dataclass(frozen=True, slots=True)
class ProvedInterval(Interval):
    """An interval with what proves its ends: at most two multiples, which add up to the end's inequality."""

    lower_proof: tuple[Term, ...] = ()
    upper_proof: tuple[Term, ...] = ()


#: Intervals as they are, or with what proves them.
Kind = TypeVar("Kind", bound=Interval, covariant=True)


class Intervals(NamedTuple, Generic[Kind]):
    """The intervals of both parameters: of :class:`ProvedInterval` where proofs come with them.

    >>> Intervals(Interval(LowerBound(1, 3), UpperBound(2, 3)), Interval(None, UpperBound(1)))
    <boundfit.Intervals: about theta1 in [0.333333, 0.666667], theta2 in [-inf, 1]>
    """

    theta1: Kind
    theta2: Kind

    def __array__(self, dtype: object = None, copy: bool | None = None) -> object:
        import numpy

        # Numpy would round the doubles of both to nearest.
        return numpy.array([interval.__array__(dtype) for interval in self])

    def __repr__(self) -> str:
        ends = (f"{name} in {interval:.6}" for name, interval in zip(self._fields, self, strict=True))
        return f"<boundfit.Intervals: about {', '.join(ends)}>"
