"""Exact bounded-error (set-membership) estimation in two parameters.

Readings follow a line up to errors of which nothing is known but a bound. :func:`fit` computes every line that agrees with all
of them, exactly:

>>> import boundfit
>>> fit = boundfit.fit([0, 1, 2], [0, 1.5, 2], "1/2")
>>> fit.vertices
[(Fraction(1, 2), Fraction(1, 2)), (Fraction(3, 2), Fraction(-1, 2)), (Fraction(1, 1), Fraction(1, 2))]
>>> fit.pui.theta1.lower, fit.pui.theta1.upper
(LowerBound(1, 2), UpperBound(3, 2))
>>> fit.epsilon_min
Fraction(1, 4)
"""

from ._bounds import Interval, Intervals, LowerBound, ProvedInterval, Term, UpperBound
from ._check import Judgement, check
from ._fit import Central, Fit, Minimax, fit, fit_file
from ._groups import fit_groups
from ._judge import Finding, JudgedProgram, judge
from ._polygon import Polygon, generators, polygon, polygon_file
from ._proof import verify
from ._reduce import reduce, reduce_file

__all__ = [
    "Central",
    "Finding",
    "Fit",
    "Interval",
    "Intervals",
    "JudgedProgram",
    "Judgement",
    "LowerBound",
    "Minimax",
    "Polygon",
    "ProvedInterval",
    "Term",
    "UpperBound",
    "check",
    "fit",
    "fit_file",
    "fit_groups",
    "generators",
    "judge",
    "polygon",
    "polygon_file",
    "reduce",
    "reduce_file",
    "verify",
]
