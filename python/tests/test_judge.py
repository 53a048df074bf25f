"""Results of SciPy and HiGHS as they are, judged exactly."""

from __future__ import annotations

import csv
import json
from fractions import Fraction
from typing import Any

import boundfit
import highspy
import numpy
import pytest
from scipy.optimize import linprog

from conftest import FIXTURES

CASES = sorted(path.stem for path in (FIXTURES / "hard-lp").glob("*.json"))


def half_planes(case: str) -> tuple[numpy.ndarray[Any, Any], numpy.ndarray[Any, Any]]:
    """The rows of a fit as doubles: what a solver receives."""
    eps = Fraction(json.loads((FIXTURES / "hard-lp" / f"{case}.json").read_text())["eps"])
    with open(FIXTURES / "hard-lp" / f"{case}.csv") as file:
        readings = [(row["x"], Fraction(row["y"])) for row in csv.DictReader(file)]
    upper = [[float(x), 1.0] for x, _ in readings]
    lower = [[-float(x), -1.0] for x, _ in readings]
    ends = [float(y + eps) for _, y in readings] + [float(eps - y) for _, y in readings]
    return numpy.array(upper + lower), numpy.array(ends)


def run_highs(c: list[float], matrix: Any, ends: Any) -> highspy.Highs:
    highs = highspy.Highs()
    highs.setOptionValue("output_flag", False)
    for cost in c:
        highs.addVar(-highspy.kHighsInf, highspy.kHighsInf)
        highs.changeColCost(highs.getNumCol() - 1, cost)
    for row, end in zip(matrix, ends, strict=True):
        highs.addRow(-highspy.kHighsInf, end, len(row), numpy.arange(len(row), dtype="int32"), row)
    highs.run()
    return highs


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("c", [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]], ids=str)
def test_results_about_hard_programs_are_judged(case: str, c: list[float]) -> None:
    matrix, ends = half_planes(case)
    free = (None, None)
    exact = boundfit.judge(c, matrix, ends, free)
    # The exact answer is that of the set of the same half-planes.
    bounds = boundfit.polygon(matrix, ends, reading="binary64").bounds
    if bounds is None:
        assert exact.status == "infeasible"
    else:
        axis = 0 if c[0] else 1
        end = bounds[axis].lower if sum(c) > 0 else bounds[axis].upper
        assert exact.value == (None if end is None else sum(c) and Fraction(sum(c)) * end)
    assert exact.findings == [] and exact.worst is None
    results = [linprog(c, matrix, ends, bounds=free), run_highs(c, matrix, ends)]
    for result in results:
        judged = boundfit.judge(c, matrix, ends, free, result)
        assert (judged.status, judged.value) == (exact.status, exact.value)
        assert judged.findings[0].aspect == "status"
        claimed = "optimal" if getattr(result, "status", None) == 0 else None
        if claimed and exact.status != "optimal":
            assert judged.is_refuted


def test_a_file_is_judged_as_the_program_does() -> None:
    path = FIXTURES / "tiny-lp/vertex-third.mps"
    assert boundfit.judge_file(path).value == Fraction(-2, 3) and boundfit.judge_file(path).worst is None
    solution = FIXTURES / "solutions/tiny-lp/vertex-third.cbc.sol"
    judged = boundfit.judge_file(path, solution)
    third = Fraction(1, 3)
    assert (judged.status, judged.points, judged.worst) == ("optimal", [(third, third)], "rounded")
    assert boundfit.judge_file(path, solution, tolerance=0, digits_as_printed=False).is_refuted
    refused = FIXTURES / "solutions/statuses/highs-raw-infeasible.sol"
    assert boundfit.judge_file(path, refused).findings[0] == ("status", "refuted", None)
    with pytest.raises(ValueError, match="line 1, column 1"):
        boundfit.judge_file(FIXTURES / "polygon/house.csv")


def test_a_right_result_is_not_refuted_and_a_false_one_is() -> None:
    c, matrix, ends = [-1, -1], [[1, 2], [3, 1]], [4, 6]
    right = linprog(c, matrix, ends)
    judged = boundfit.judge(c, matrix, ends, (0, None), right)
    assert judged.worst in ("exact", "rounded", "within tolerance"), judged.findings
    assert judged.points == [(Fraction(8, 5), Fraction(6, 5))]
    right.fun -= 0.1
    judged = boundfit.judge(c, matrix, ends, (0, None), right)
    assert judged.is_refuted
    refuted = [own for own in judged.findings if own.worth == "refuted"]
    assert any(own.aspect == "objective" for own in refuted)


def test_statuses_equations_and_bounds() -> None:
    assert boundfit.judge([1, 0], bounds=(None, None), result=linprog([1, 0], bounds=(None, None))).status == "unbounded"
    never = linprog([1, 0], [[1, 0], [-1, 0]], [-1, -1])
    assert boundfit.judge([1, 0], [[1, 0], [-1, 0]], [-1, -1], result=never).worst in ("exact", "no answer")
    equal = linprog([1, 2], A_eq=[[1, 1]], b_eq=[1], bounds=[(0, 1), (0.25, None)])
    judged = boundfit.judge([1, 2], None, None, [(0, 1), (0.25, None)], equal, A_eq=[[1, 1]], b_eq=[1])
    assert judged.value == Fraction(5, 4) and not judged.is_refuted
    assert boundfit.judge(["1/3", 0], [[-1, 0]], ["-1/7"], (None, None)).value == Fraction(1, 21)
    with pytest.raises(ValueError, match="A_ub has 1 rows, but b_ub has 2"):
        boundfit.judge([1, 1], [[1, 1]], [1, 2])
    with pytest.raises(ValueError, match="row 1 has 3 coefficients, but c has 2"):
        boundfit.judge([1, 1], [[1, 1, 1]], [1])
    with pytest.raises(ValueError, match="expected what scipy.optimize.linprog returns"):
        boundfit.judge([1, 1], [[1, 1]], [1], result=object())
    with pytest.raises(ValueError):
        boundfit.judge([1, 1, 1], [[1, 1, 1]], [1])


def test_claims_about_intervals() -> None:
    fit = boundfit.fit([0, 1, 2], [0, 1.5, 2], "1/2")
    judged = boundfit.check(fit, [("0.500", 1.5), (-0.5, 0.7)])
    assert [own.verdict for own in judged] == ["exact", "exact", "exact", "loose"]
    assert judged[3].exact == Fraction(1, 2) and judged[3].claimed == Fraction(0.7)
    with pytest.raises(ValueError, match=r"^claim=\(3,\): expected two ends of each parameter"):
        boundfit.check(fit, [(1, 2), (3,)])


@pytest.mark.parametrize("ends", [[4, None], numpy.ma.array([4, 6], mask=[0, 1])])
def test_a_missing_right_hand_side_is_refused(ends):
    with pytest.raises(ValueError, match=r"b_ub\[1\] is missing"):
        boundfit.judge([-1, -1], [[1, 2], [3, 1]], ends)
    with pytest.raises(ValueError, match=r"b_eq\[0\] is missing"):
        boundfit.judge([-1, -1], A_eq=[[1, 2]], b_eq=[None])


def test_a_result_of_another_program_is_refused() -> None:
    c, matrix, ends = [-1, -1], [[1, 2], [3, 1]], [4, 6]
    other = linprog([-1, -1, -1], [[1, 2, 1], [3, 1, 1]], [4, 6])
    with pytest.raises(ValueError, match=r"^result: the point has 3 numbers \(expected 2, one for each column of the program\)$"):
        boundfit.judge(c, matrix, ends, result=other)
    with pytest.raises(ValueError, match=r"^result: the list of duals has 2 numbers \(expected 1, one for each row"):
        boundfit.judge(c, matrix[:1], ends[:1], result=linprog(c, matrix, ends))
    with pytest.raises(ValueError, match=r"^result: the list of duals has 1 number \(expected 2, one for each row"):
        boundfit.judge(c, matrix, ends, result=linprog(c, matrix[:1], ends[:1]))
