"""Results of LP solvers, judged exactly."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

from . import _boundfit
from ._answers import number, value
from ._asking import exact
from ._columns import Number, fraction, numbers_of, rows_of, several
from ._keywords import knows


class Finding(NamedTuple):
    """What was found about one aspect of a result."""

    aspect: str
    """Status, objective, feasibility and so on: docs/solutions.md has the table."""
    worth: str
    """``"exact"``, ``"rounded"``, ``"within tolerance"``, ``"no answer"`` or ``"refuted"``."""
    error: Fraction | None
    """The largest error in units of its own; ``None`` for statuses."""


@dataclass(frozen=True, slots=True)
class JudgedProgram:
    """The exact answer about a linear program, and what a solver's result is worth."""

    status: str
    """``"optimal"``, ``"infeasible"`` or ``"unbounded"``."""
    value: Fraction | None
    """The optimum."""
    points: list[tuple[Fraction, ...]]
    """The vertices where it is attained."""
    findings: list[Finding]
    """One for each aspect that the result says something about."""

    @property
    def worst(self) -> str | None:
        """The worst worth of all; ``None`` without a result."""
        order = ["exact", "rounded", "within tolerance", "no answer", "refuted"]
        return max((own.worth for own in self.findings), key=order.index, default=None)

    @property
    def is_refuted(self) -> bool:
        """Whether something is refuted."""
        return self.worst == "refuted"

    def __hash__(self) -> int:
        return hash((self.status, self.value, *self.points, *self.findings))

    def _repr_html_(self) -> str:
        from ._html import of_judged

        return of_judged(self)


@knows()
def judge(
    c: Sequence[Any],
    A_ub: Iterable[Sequence[Any]] | None = None,
    b_ub: Iterable[Any] | None = None,
    bounds: Any = (0, None),
    result: Any = None,
    *,
    A_eq: Iterable[Sequence[Any]] | None = None,
    b_eq: Iterable[Any] | None = None,
    tolerance: Any = "1e-6",
) -> JudgedProgram:
    """Solves ``min c·x`` with ``A_ub·x ≤ b_ub``, ``A_eq·x = b_eq`` and ``bounds`` exactly, and judges a result: the object that
    ``scipy.optimize.linprog`` returns, or a ``highspy.Highs`` that has run the same rows in this order. The arguments are those of
    ``linprog``, bounds of (0, None) included; bounds must fix all but two variables. A float is the number that the solver
    received; texts and fractions are exact. What a tolerance excuses is that share of the numbers' own size.

    >>> judged = judge([-1, -1], [[1, 2], [3, 1]], [4, 6])
    >>> judged.status, judged.value, judged.points
    ('optimal', Fraction(-14, 5), [(Fraction(8, 5), Fraction(6, 5))])
    """
    costs = numbers_of(c, "c")
    rows: list[tuple[list[Any], Any, Any]] = [(row, None, end) for row, end in _rows(A_ub, b_ub, "ub")]
    rows += [(row, end, end) for row, end in _rows(A_eq, b_eq, "eq")]
    for index, (row, _, _) in enumerate(rows):
        if len(row) != len(costs):
            raise ValueError(f"row {index + 1} has {len(row)} coefficients, but c has {len(costs)}")
    if fraction(tolerance, "tolerance", "binary64") < 0:
        raise ValueError(f"tolerance={tolerance!r}: expected a share, at least 0")
    claimed = None if result is None else _claimed(result)
    status, value, points, findings = _boundfit.judge(costs, rows, _bounds(bounds, len(costs)), claimed, tolerance)
    found = [Finding(*finding) for finding in findings]
    return JudgedProgram(status, value, [tuple(point) for point in points], found)


@knows()
def judge_file(
    path: str | os.PathLike[str],
    solution: str | os.PathLike[str] | None = None,
    *,
    tolerance: Number = "1e-6",
    digits_as_printed: bool = True,
) -> JudgedProgram:
    """Solves the linear program of an MPS or LP file exactly, and judges the solution file that a solver wrote about it. Without
    ``digits_as_printed`` its numbers are exact.
    """
    request: dict[str, Any] = {"ask": "judge", "tolerance": exact(tolerance, "decimal"), "digits_as_printed": digits_as_printed}
    if solution is not None:
        with open(solution, encoding="utf-8") as file:
            request["solution"] = [{"file": os.fsdecode(solution), "text": file.read()}]
    document = json.loads(_boundfit.judge_file(os.fsdecode(path), json.dumps(request), "json"))
    vertices = (document["face"] or {"vertices": []})["vertices"]
    points = [tuple(map(value, vertex)) for vertex in vertices]
    found = (own for judged in document.get("solutions", []) for own in judged["findings"])
    findings = [Finding(own["aspect"], own["verdict"], number(own["error"])) for own in found]
    return JudgedProgram(document["status"], number(document["objective"]), points, findings)


def _rows(matrix: Any, ends: Any, name: str) -> list[tuple[list[Any], Any]]:
    if matrix is None and ends is None:
        return []
    if matrix is None or ends is None:
        raise ValueError(f"A_{name} and b_{name} belong together")
    matrix, ends = rows_of(matrix, f"A_{name}"), numbers_of(ends, f"b_{name}")
    for place, end in enumerate(ends):
        if end is None:
            raise ValueError(f"b_{name}[{place}] is missing: expected a number; leave the row out if nothing bounds it")
    if len(matrix) != len(ends):
        raise ValueError(f"A_{name} has {len(matrix)} rows, but b_{name} has {len(ends)}")
    return list(zip(matrix, ends, strict=True))


def _bounds(bounds: Any, count: int) -> list[tuple[Any, Any]]:
    if bounds is None:
        bounds = (0, None)
    if hasattr(bounds, "lb"):
        bounds = list(zip(bounds.lb, bounds.ub, strict=True))
    if not isinstance(bounds, Iterable):
        raise ValueError(f"bounds={bounds!r}: expected a pair such as (0, None), or a list of one per variable")
    bounds = rows_of(bounds, "bounds") if hasattr(bounds, "columns") else list(bounds)
    if len(bounds) == 2 and all(end is None or not hasattr(end, "__len__") for end in bounds):
        bounds = [tuple(bounds)] * count
    elif len(bounds) == 1:
        bounds = bounds * count
    if len(bounds) != count:
        raise ValueError(f"there are {len(bounds)} bounds, but c has {count} numbers")

    def end(value: Any, place: int, side: str, none: float) -> Any:
        """An end; that which is none for this side says that there is none."""
        is_float = isinstance(value, float) or getattr(getattr(value, "dtype", None), "kind", None) == "f"
        if not is_float or not math.isinf(value):
            return value
        if value != none:
            raise ValueError(f"bounds[{place}]: the {side} bound is {float(value)}: expected a number, {none} or None")
        return None

    pairs = [several(pair, f"bounds[{place}]", 2, "a lower and an upper bound") for place, pair in enumerate(bounds)]
    return [(end(low, place, "lower", -math.inf), end(high, place, "upper", math.inf)) for place, (low, high) in enumerate(pairs)]


def _claimed(result: Any) -> dict[str, Any]:
    """What a result says."""
    if hasattr(result, "getModelStatus"):
        return _of_highs(result)
    if not hasattr(result, "status") or not hasattr(result, "x"):
        raise ValueError(
            f"result is of type {type(result).__name__}: expected what scipy.optimize.linprog returns, or a highspy.Highs"
        )
    status = {0: "optimal", 2: "infeasible", 3: "unbounded"}.get(int(result.status), str(result.get("message", "")))
    duals = None
    reduced = None
    if result.get("ineqlin") is not None and result.x is not None:
        marginals = [*result.ineqlin.marginals, *result.eqlin.marginals]
        duals = [float(value) for value in marginals]
        lower, upper = result.lower.marginals, result.upper.marginals
        # At most one of them is not 0, so that nothing is rounded.
        reduced = [float(a) + float(b) for a, b in zip(lower, upper, strict=True)]
    return {
        "solver": "SciPy",
        "status": status,
        "objective": None if result.fun is None else float(result.fun),
        "point": None if result.x is None else [float(value) for value in result.x],
        "duals": duals,
        "reduced_costs": reduced,
    }


def _of_highs(highs: Any) -> dict[str, Any]:
    solution, info = highs.getSolution(), highs.getInfo()
    has_point, has_duals = bool(solution.value_valid), bool(solution.dual_valid)
    return {
        "solver": "HiGHS",
        "status": highs.modelStatusToString(highs.getModelStatus()),
        "objective": float(info.objective_function_value) if has_point else None,
        "point": list(solution.col_value) if has_point else None,
        "duals": list(solution.row_dual) if has_duals else None,
        "reduced_costs": list(solution.col_dual) if has_duals else None,
    }
