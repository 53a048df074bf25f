"""Claims about the intervals, judged exactly."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import NamedTuple

from . import _boundfit
from ._columns import Number, several
from ._fit import Fit


class Judgement(NamedTuple):
    """What a claimed end is worth."""

    end: str
    """Which end: ``"theta1-min"``, ``"theta1-max"``, ``"theta2-min"`` or ``"theta2-max"``."""
    verdict: str
    """``"exact"``, ``"rounded"``, ``"within tolerance"``, ``"loose"``, ``"unsafe"`` and others: docs/judging.md has the table."""
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
    both = several(claim, "claim", 2, expected)
    ends = [end for interval in both for end in several(interval, "claim", 2, expected)]
    return [Judgement(*own) for own in _boundfit.check(problem._core, ends)]
