"""Claims about the intervals, judged exactly."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import Any, NamedTuple

from . import _boundfit
from ._columns import Number, several
from ._fit import Fit


class Judgement(NamedTuple):
    """What a claimed end is worth."""

    end: str
    """Which end: ``"theta1-min"``, ``"theta1-max"``, ``"theta2-min"`` or ``"theta2-max"``."""
    verdict: str
    """``"exact"``, ``"rounded"``, ``"within tolerance"``, ``"loose"``, ``"unsafe"`` and others: docs/verdicts.md has the table."""
    exact: Fraction | None
    """The true end; ``None`` where there is none."""
    claimed: Fraction | None
    """The claimed end."""
    excess: Fraction | None
    """How far the claim is outside (positive) or inside (negative) of the true end."""


def check(problem: Fit, claim: Iterable[Iterable[Number | None]] | None) -> list[Judgement]:
    """Judges claimed intervals, ``[(lower, upper) of theta1, (lower, upper) of theta2]``, or :attr:`boundfit.Fit.pui`. A float is
    meant exactly, short ones too, and a text is as precise as its last digit. ``None`` claims that there is no end.

    >>> import boundfit
    >>> fit = boundfit.fit([0, 1, 2], [0, 1.5, 2], "1/2")
    >>> [own.verdict for own in check(fit, [(0.6, 1.5), (-0.5, 0.7)])]
    ['unsafe', 'exact', 'exact', 'loose']
    """
    expected = "two ends of each parameter, such as [(0, 1), (0, 1)]"
    if not isinstance(problem, Fit):
        raise ValueError(f"problem is of type {type(problem).__name__}: expected a fit of exact x, as boundfit.fit returns it")
    both = several(claim, "claim", 2, expected)
    ends = [end for interval in both for end in several(interval, "claim", 2, expected)]
    for place, end in enumerate(ends):
        if _is_infinite(end):
            name = f"{'upper' if place % 2 else 'lower'} end of theta{place // 2 + 1}"
            raise ValueError(f"claim: the {name} is {end}: expected a number, or None where there is no end")
    return [Judgement(*own) for own in _boundfit.check(problem._core, ends)]


def _is_infinite(end: Any) -> bool:
    try:
        return math.isinf(float(end)) and "inf" in str(end).lower()
    except (TypeError, ValueError, OverflowError):
        return False
