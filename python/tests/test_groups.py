"""Fleets in memory are the program's fleets."""

from __future__ import annotations

import csv
import io
import math
from fractions import Fraction
from pathlib import Path
from typing import Any

import boundfit
import numpy
import pandas
import polars
import pyarrow
import pytest

from conftest import FIXTURES, Program


def frames() -> dict[str, Any]:
    random = numpy.random.default_rng(11)
    rows = 4000
    table = {
        "cell": [f"c{number}" for number in random.integers(0, 300, rows)],
        "x": [round(float(number), 2) for number in random.uniform(-3, 3, rows)],
        "y": [round(float(number), 2) for number in random.uniform(-3, 3, rows)],
        "e": [round(float(number), 2) for number in random.uniform(2, 4, rows)],
    }
    return {"dict": table, "pandas": pandas.DataFrame(table), "polars": polars.DataFrame(table), "pyarrow": pyarrow.table(table)}


FRAMES = frames()


@pytest.mark.parametrize("kind", FRAMES)
@pytest.mark.parametrize("bound", [{"eps": "3"}, {"eps_column": "e"}, {"eps": "1.1*min"}, {"eps": 2, "where": "theta1 >= 0"}], ids=str)
def test_groups_are_those_of_the_program(kind: str, bound: dict[str, Any], program: Program, tmp_path: Path) -> None:
    FRAMES["pandas"].to_csv(tmp_path / "fleet.csv", index=False)
    options = ["--by", "cell", "--x", "x", "--y", "y", "--format", "csv"]
    for name, value in bound.items():
        options += [f"--{name.replace('_', '-')}", str(value)]
    expected = list(csv.DictReader(io.StringIO(program("fit", tmp_path / "fleet.csv", *options))))
    answer = boundfit.fit_groups(FRAMES[kind], by="cell", x="x", y="y", **bound)
    assert type(answer) is type(FRAMES[kind])
    columns = answer.to_pydict() if kind == "pyarrow" else {name: list(answer[name]) for name in (answer if kind == "dict" else answer.columns)}
    assert columns["group"] == [row["group"] for row in expected]
    assert columns["rows"] == [int(row["rows"]) for row in expected]
    assert columns["kind"] == [row["kind"] for row in expected]
    for name in expected[0]:
        if name in ("group", "rows", "kind", "first_row"):
            continue
        for index, row in enumerate(expected):
            double, text = columns[name][index], columns[f"{name}_exact"][index]
            if row[name] in ("", "-inf", "inf"):
                assert text is None or text != text
                assert math.isnan(double) if row[name] == "" else double == float(row[name])
                continue
            exact = Fraction(text)
            printed = Fraction(row[name])
            if name.endswith("lower"):
                assert printed <= exact and Fraction(double) <= exact
            elif name.endswith(("upper", "error")) or name.startswith("epsilon"):
                assert printed >= exact and Fraction(double) >= exact
            assert abs(printed - exact) <= abs(exact) / 1000 + Fraction(1, 100)
            assert double == pytest.approx(float(exact), rel=1e-15)


def test_a_group_is_its_own_fit() -> None:
    frame = FRAMES["polars"]
    groups = boundfit.fit_groups(frame, by="cell", x="x", y="y", eps="3", reading="binary64")
    for row in groups.iter_rows(named=True):
        own = frame.filter(polars.col("cell") == row["group"])
        fit = boundfit.fit(own["x"], own["y"], "3", reading="binary64")
        ends = [None, None] if fit.pui is None else [fit.pui.theta1.lower, fit.pui.theta2.upper]
        assert [row["theta1_lower_exact"], row["theta2_upper_exact"]] == [None if end is None else str(end) for end in ends]
        assert row["epsilon_min_exact"] == str(fit.epsilon_min)


def test_fleets_of_the_fixtures(program: Program) -> None:
    for path in sorted((FIXTURES / "fleet").glob("*.csv")):
        frame = pandas.read_csv(path, dtype=str)
        by, x, y = frame.columns[:3]
        try:
            expected = program("fit", path, "--by", by, "--x", x, "--y", y, "--eps", "0.5", "--format", "csv")
        except AssertionError:
            continue
        answer = boundfit.fit_groups(frame, by=by, x=x, y=y, eps="0.5")
        rows = list(csv.DictReader(io.StringIO(expected)))
        assert list(answer["group"]) == [row["group"] for row in rows]
        assert list(answer["kind"]) == [row["kind"] for row in rows]


def test_what_is_wrong_is_told() -> None:
    with pytest.raises(ValueError, match="the frame has no column 'z'"):
        boundfit.fit_groups(FRAMES["pandas"], by="cell", x="z", y="y", eps=1)
    with pytest.raises(ValueError, match=r"row 2, column 2 \(y\)"):
        boundfit.fit_groups({"k": [1, 2], "x": [0, 1], "y": [0, math.nan]}, by="k", x="x", y="y", eps=1)
    with pytest.raises(ValueError, match="eps and eps_column"):
        boundfit.fit_groups(FRAMES["dict"], by="cell", x="x", y="y", eps=1, eps_column="e")
