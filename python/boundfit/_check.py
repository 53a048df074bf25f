"""Claims about the intervals, judged exactly."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable
from fractions import Fraction
from typing import Any, NamedTuple

from ._answers import number
from ._asking import ask, exact
from ._columns import Number, fraction, several, text
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


def check(
    problem: Fit, claim: Iterable[Iterable[Number | None]] | None, *, tolerance: Number | None = None
) -> list[Judgement]:
    """Judges claimed intervals, ``[(lower, upper) of theta1, (lower, upper) of theta2]``, or :attr:`boundfit.Fit.pui`. A float is
    meant exactly, short ones too, and a text is as precise as its last digit. ``None`` claims that there is no end. An end is within
    tolerance if it is off by at most ``tolerance`` times the width of its interval, to either side (default: 1e-6).

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
    asked = ask(
        problem._readings,
        "check",
        claim_pui=[",".join(_end(end, place) for place, end in enumerate(ends))],
        tolerance=exact(tolerance, "decimal"),
    )
    # The first answer is judged against the readings as they are, a second one against their doubles.
    judged = json.loads(asked("json", None))["claims"][0]["bounds"]
    return [_judgement(own) for own in judged]


def _judgement(own: Any) -> Judgement:
    end = f"{own['target']}-{'min' if own['end'] == 'lower' else 'max'}"
    return Judgement(end, own["verdict"], number(own["exact"]), number(own["claimed"]), number(own["excess"]))


def _end(end: Any, place: int) -> str:
    """An end as a claim writes it: a text as it is, any other number as its fraction."""
    if end is None:
        return "inf" if place % 2 else "-inf"
    if _is_infinite(end):
        name = f"{'upper' if place % 2 else 'lower'} end of theta{place // 2 + 1}"
        raise ValueError(f"claim: the {name} is {end}: expected a number, or None where there is no end")
    meant = fraction(end, "claim", "binary64")
    return end if isinstance(end, str) else text(meant)


def _is_infinite(end: Any) -> bool:
    try:
        return math.isinf(float(end)) and "inf" in str(end).lower()
    except (TypeError, ValueError, OverflowError):
        return False
