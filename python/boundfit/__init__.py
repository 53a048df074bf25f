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

from ._answers import Answer
from ._bounds import Interval, Intervals, LowerBound, ProvedInterval, Term, UpperBound
from ._check import Judgement, check
from ._fit import Central, Fit, Guarantee, Minimax
from ._fitting import fit, fit_file
from ._found import (
    Best,
    Growth,
    LinearRange,
    NextReading,
    Outliers,
    PossibleX,
    PredictedValue,
    Prediction,
    Repair,
    RowStatus,
    Run,
    Statuses,
    Widened,
    WindowFit,
)
from ._groups import fit_groups
from ._judge import Finding, JudgedProgram, judge, judge_file
from ._linearity import Characteristic, Linearity, LinearityLine, linearity, linearity_file
from ._open import InnerLowerBound, InnerUpperBound, OpenInterval
from ._polygon import Polygon, generators, polygon, polygon_file
from ._proof import verify
from ._questions import outliers, predict, status, windows

# Not among the names of a star: there they would take the places of builtins.
from ._questions import next as next
from ._questions import range as range
from ._reduce import reduce, reduce_file
from ._boundfit import __version__
from ._x_errors import Factor, Side, XErrorFit

__all__ = [
    "Answer",
    "Best",
    "Central",
    "Characteristic",
    "Factor",
    "Finding",
    "Fit",
    "Growth",
    "Guarantee",
    "InnerLowerBound",
    "InnerUpperBound",
    "Interval",
    "Intervals",
    "JudgedProgram",
    "Judgement",
    "LinearRange",
    "Linearity",
    "LinearityLine",
    "LowerBound",
    "Minimax",
    "NextReading",
    "OpenInterval",
    "Outliers",
    "Polygon",
    "PossibleX",
    "PredictedValue",
    "Prediction",
    "ProvedInterval",
    "Repair",
    "RowStatus",
    "Run",
    "Side",
    "Statuses",
    "Term",
    "UpperBound",
    "Widened",
    "WindowFit",
    "XErrorFit",
    "__version__",
    "check",
    "fit",
    "fit_file",
    "fit_groups",
    "generators",
    "judge",
    "judge_file",
    "linearity",
    "linearity_file",
    "outliers",
    "polygon",
    "polygon_file",
    "predict",
    "reduce",
    "reduce_file",
    "status",
    "verify",
    "windows",
]
