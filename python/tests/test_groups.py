"""Fleets in memory are the program's fleets."""

from __future__ import annotations

import csv
import io
import math
import re
from decimal import Decimal
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
    assert columns["cell"] == [row["group"] for row in expected]
    assert columns["rows"] == [int(row["rows"]) for row in expected]
    assert columns["kind"] == [row["kind"] for row in expected]
    for name in expected[0]:
        if name in ("group", "rows", "kind", "first_row"):
            continue
        for index, row in enumerate(expected):
            double, text = columns[name][index], columns[f"{name}_exact"][index]
            if row[name] in ("", "-inf", "inf"):
                assert text is None or text != text
                if row[name]:
                    assert double == float(row[name])
                else:
                    assert double is None if kind in ("polars", "pyarrow") else math.isnan(double)
                continue
            exact = Fraction(text)
            printed = Fraction(row[name])
            if name.endswith("lower"):
                assert printed <= exact and Fraction(double) <= exact
            elif name.endswith(("upper", "error")) or name.startswith("epsilon"):
                assert printed >= exact and Fraction(double) >= exact
            assert abs(printed - exact) <= abs(exact) / 1000 + Fraction(1, 100)
            if name.endswith("error"):
                # It covers the rounding of the centre too.
                centre = columns[name.replace("error", "central")][index]
                assert Fraction(double) - exact <= Fraction(math.ulp(centre)) + Fraction(math.ulp(double))
                continue
            assert double == pytest.approx(float(exact), rel=1e-15)


def encloses(row: dict[str, Any]) -> bool:
    """Whether centre and half-width of a row, as doubles, enclose the exact intervals of both parameters."""
    for theta in ("theta1", "theta2"):
        if row[f"{theta}_lower_exact"] is None or row[f"{theta}_upper_exact"] is None:
            continue
        centre, error = (Fraction(row[f"{theta}_{name}"]) for name in ("central", "error"))
        if centre - error > Fraction(row[f"{theta}_lower_exact"]) or centre + error < Fraction(row[f"{theta}_upper_exact"]):
            return False
    return True


def test_centre_and_error_as_doubles_enclose_the_intervals() -> None:
    # Far from zero a centre is rounded by more than the last place of the error.
    rows = 2000
    random = numpy.random.default_rng(5)
    cells = [f"c{number}" for number in random.integers(0, 200, rows)]
    x = [Fraction(int(number), 7) for number in random.integers(-30, 30, rows)]
    y = [Fraction(1, 3) * own + 10**6 + Fraction(int(number), 10**14) for own, number in zip(x, random.integers(-9, 9, rows), strict=True)]
    table = {"cell": cells, "x": x, "y": y}
    groups = pyarrow.table(boundfit.fit_groups(table, by="cell", x="x", y="y", eps=Fraction(9, 10**14)))
    bounded = [row for row in groups.to_pylist() if row["theta2_error"] is not None and math.isfinite(row["theta2_error"])]
    assert len(bounded) > 150
    assert all(encloses(row) for row in bounded)
    assert any(Fraction(row["theta2_error"]) > 2 * Fraction(row["theta2_error_exact"]) for row in bounded)


def test_a_group_is_its_own_fit() -> None:
    frame = FRAMES["polars"]
    groups = boundfit.fit_groups(frame, by="cell", x="x", y="y", eps="3", reading="binary64")
    for row in groups.iter_rows(named=True):
        own = frame.filter(polars.col("cell") == row["cell"])
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
        assert list(answer[by].fillna("")) == [row["group"] for row in rows]
        assert list(answer["kind"]) == [row["kind"] for row in rows]


def listed(answer: Any) -> dict[str, list[Any]]:
    """The columns of a frame, with nothing where a number is missing."""
    if isinstance(answer, pyarrow.Table):
        return answer.to_pydict()
    columns = {name: list(answer[name]) for name in (answer if isinstance(answer, dict) else answer.columns)}
    return {name: [None if value is None or value is pandas.NA or value != value else value for value in own] for name, own in columns.items()}


BLANKS = {
    "k": ["a", "a", " a", " a", "a\t", "a\t", "\u00a0a", "\u00a0a", None, None, "", "", "NA", "NA"],
    "x": [0, 1] * 7,
    "y": [0.0, 1.0, 0.0, 2.0, 0.0, 3.0, 0.0, 4.0, 0.0, 5.0, 0.0, 6.0, 0.0, 7.0],
}


@pytest.mark.parametrize("kind", [dict, pandas.DataFrame, polars.DataFrame, pyarrow.table])
def test_keys_that_differ_in_blanks_or_are_missing_are_different_keys(kind: Any) -> None:
    answer = listed(boundfit.fit_groups(kind(BLANKS), "k", "x", "y", "1/10"))
    assert answer["k"] == ["a", " a", "a\t", "\u00a0a", None, "", "NA"]
    assert answer["kind"] == ["polygon"] * 7 and answer["rows"] == [2] * 7
    assert answer["theta1_central_exact"] == ["1", "2", "3", "4", "5", "6", "7"]


@pytest.mark.parametrize(
    "keys",
    [
        ["b", "a", "b", "", "a"],
        [3, -1, 3, 10**30, -1],
        [3, -1, 3, 3, -1],
        ["1", 1, "1", 1],
        [1, True, 1, False, 0],
        [2.0, 2, 3],
        ["\ud800", "a", "\ud800"],
        [None, "a", None],
        [(1, 2), (1, 3), (1, 2)],
    ],
    ids=repr,
)
def test_keys_are_equal_where_python_says_so(keys: list[Any]) -> None:
    table = {"key": keys, "x": range(len(keys)), "y": [0] * len(keys)}
    groups = boundfit.fit_groups(table, by="key", x="x", y="y", eps=1)
    expected: dict[Any, int] = {}
    for key in keys:
        expected[key] = expected.get(key, 0) + 1
    assert (groups["key"], list(groups["rows"])) == (list(expected), list(expected.values()))


def test_keys_keep_names_and_types() -> None:
    frame = pandas.DataFrame(
        {
            "plant": pandas.Categorical(["n", "s", "n", "s", "n", "n"]),
            "sensor": pandas.array([1, 1, 1, 1, None, None], dtype="Int64"),
            "day": pandas.to_datetime(["2026-01-01", "2026-01-02", "2026-01-01", "2026-01-02", None, None]),
            "x": [0, 0, 1, 1, 0, 1],
            "y": [0.0, 0.0, 1.0, 2.0, 0.0, 3.0],
        }
    )
    by = ["plant", "sensor", "day"]
    answer = boundfit.fit_groups(frame, by, "x", "y", 0)
    assert list(answer.columns[:5]) == [*by, "rows", "kind"] and list(answer.columns)[-1] == "problem"
    assert [str(answer[name].dtype) for name in by] == [str(frame[name].dtype) for name in by]
    assert answer["theta1_lower_exact"].tolist() == ["1", "2", "3"]
    assert frame.merge(answer, on=by)["rows"].tolist() == [2] * 6
    assert str(answer["rows"].dtype) == "int64"
    ints = pandas.DataFrame({"k": [7, 8, 7, 8], "x": [0, 0, 1, 1], "y": [0, 0, 1, 2]})
    merged = ints.merge(boundfit.fit_groups(ints, "k", "x", "y", 0), on="k")
    assert merged["theta1_lower"].tolist() == [1, 2, 1, 2] and str(merged["k"].dtype) == "int64"
    table = pyarrow.table({"k": pyarrow.array([1.5, None, float("nan"), 1.5, None]), "x": [0, 0, 0, 1, 1], "y": [0, 0, 0, 1, 2]})
    of_arrow = boundfit.fit_groups(table, "k", "x", "y", 0)
    assert of_arrow.schema.field("k").type == pyarrow.float64()
    assert [repr(key) for key in of_arrow["k"].to_pylist()] == ["1.5", "None", "nan"]
    of_polars = boundfit.fit_groups(polars.from_arrow(table), "k", "x", "y", 0)
    assert of_polars["k"].dtype == polars.Float64 and of_polars["rows"].to_list() == [2, 2, 1]
    assert of_polars.schema["problem"] == polars.String and of_polars.schema["theta1_lower"] == polars.Float64


@pytest.mark.parametrize("kind", [dict, pandas.DataFrame, polars.DataFrame, pyarrow.table])
def test_a_bad_group_is_a_row_with_its_problem(kind: Any) -> None:
    table = {"k": [2, 1, 3, 1, 2, 3], "id": [10, 20, 30, 40, 50, 60], "x": [0, 0, 0, 1, 1, 1], "y": [0.0, 0.0, 0.0, math.inf, 1.0, 2.0]}
    answer = boundfit.fit_groups(kind(table), "k", "x", "y", 0)
    columns = listed(answer)
    assert columns["k"] == [2, 1, 3] and columns["rows"] == [2, 2, 2]
    assert columns["kind"] == ["point", None, "point"] and columns["theta1_lower"] == [1.0, None, 2.0]
    assert columns["problem"][::2] == [None, None]
    assert columns["problem"][1].startswith('row 4, column 2 (y): "inf": not a number')
    assert listed(boundfit.fit_groups(kind(table), "k", "x", "y", 0, id="id"))["problem"][1].startswith('id 40, column 2 (y): "inf"')
    plain = boundfit.fit_groups(kind(table | {"y": [0.0] * 6}), "k", "x", "y", 0)
    names = list(answer if kind is dict else answer.columns if kind is not pyarrow.table else answer.column_names)
    assert names == list(plain if kind is dict else plain.columns if kind is not pyarrow.table else plain.column_names)
    if kind is pandas.DataFrame:
        assert list(answer.dtypes) == list(plain.dtypes)
    if kind in (polars.DataFrame, pyarrow.table):
        assert answer.schema == plain.schema


def test_groups_without_numbers_and_tables_without_rows() -> None:
    table = {"k": ["a", "b", "a", "b"], "x": [0, 0, 1, 1], "y": [None, 0, None, 1]}
    answer = boundfit.fit_groups(table, "k", "x", "y", 0, missing="skip")
    assert answer["rows"] == [0, 2] and answer["kind"] == [None, "point"]
    assert answer["problem"] == ["every row of the group lacks a number", None]
    nothing = boundfit.fit_groups(pandas.DataFrame(table).iloc[:0], "k", "x", "y", 0)
    assert len(nothing) == 0 and list(nothing.columns)[:2] == ["k", "rows"]
    # Values of Python that are no numbers spoil their group alone.
    found = boundfit.fit_groups({"k": [1, 2], "x": [0, 0], "y": [True, 3]}, "k", "x", "y", 1)["problem"]
    assert found == ["row 1 of y: True is a truth value, not a number", None]


def test_what_is_wrong_is_told() -> None:
    with pytest.raises(ValueError, match="the frame has no column 'z'"):
        boundfit.fit_groups(FRAMES["pandas"], by="cell", x="z", y="y", eps=1)
    for kind in FRAMES:
        with pytest.raises(ValueError, match="the frame has no column 'z'"):
            boundfit.fit_groups(FRAMES[kind], by="z", x="x", y="y", eps=1)
    with pytest.raises(ValueError, match="the errors have one bound: eps, or eps_column"):
        boundfit.fit_groups(FRAMES["dict"], by="cell", x="x", y="y", eps=1, eps_column="e")
    with pytest.raises(ValueError, match="eps=-1: negative"):
        boundfit.fit_groups(FRAMES["dict"], by="cell", x="x", y="y", eps=-1)
    with pytest.raises(ValueError, match="by=\\[\\]: expected the name of a column"):
        boundfit.fit_groups(FRAMES["dict"], by=[], x="x", y="y", eps=1)
    with pytest.raises(ValueError, match="a column 'kind' is part of the answer"):
        boundfit.fit_groups({"kind": [1], "x": [0], "y": [0]}, by="kind", x="x", y="y", eps=1)
    with pytest.raises(ValueError, match="the column 'y' has 1 rows, but 'k' has 2"):
        boundfit.fit_groups({"k": [1, 2], "x": [0, 1], "y": [0]}, by="k", x="x", y="y", eps=1)
    with pytest.raises(ValueError, match="a cell of 'k' is no key"):
        boundfit.fit_groups({"k": [[1], [2]], "x": [0, 1], "y": [0, 1]}, by="k", x="x", y="y", eps=1)


def test_times_are_keys_to_the_last_nanosecond_and_in_both_hours_of_a_change_of_the_clock() -> None:
    hours = [1761438600 * 10**6] * 2 + [1761442200 * 10**6] * 2
    readings = {"x": [0.0, 1.0, 0.0, 1.0], "y": [0.0, 1.0, 5.0, 6.0]}
    zoned = pyarrow.table({"k": pyarrow.array(hours, pyarrow.timestamp("us", "Europe/Berlin")), **readings})
    assert boundfit.fit_groups(zoned, "k", "x", "y", 1)["rows"].to_pylist() == [2, 2]
    nanoseconds = pyarrow.array([0, 1, None, 1000], pyarrow.time64("ns"))
    for keys in (nanoseconds, nanoseconds.dictionary_encode()):
        table = pyarrow.table({"k": keys, **readings})
        assert boundfit.fit_groups(table, "k", "x", "y", 1)["rows"].to_pylist() == [1, 1, 1, 1]
    frame = polars.DataFrame({"k": [0, 1, 1, 1000], **readings}).with_columns(polars.col("k").cast(polars.Datetime("ns")))
    assert boundfit.fit_groups(frame, "k", "x", "y", 1)["rows"].to_list() == [1, 2, 1]


def test_a_reduction_of_two_regressors_needs_a_bound() -> None:
    with pytest.raises(ValueError, match="the bound on the errors is missing"):
        boundfit.reduce(([1, 2, 4], [2, 3, 1]), [3, 5, 5])


DUPLICATES = pandas.DataFrame([["a", "a", 0, 1], ["b", "b", 1, 1], ["b", "b", 2, 1]], columns=["k", "k", "x", "y"])
NAMED_TWICE = pandas.DataFrame([["a", 0, 0, 1, "z"], ["b", 1, 1, 1, 1]], columns=["k", "x", "id", "id", "y"])

NO_COLUMNS: list[tuple[Any, dict[str, Any], str]] = [
    ({"k": ["a", "b", "a"], "x": [0, 0, 1], "y": [0, 1, 2], "id": ["r1"]}, {"id": "id"}, "the column 'id' has 1 rows, but 'k' has 3"),
    ({"k": ["a"], "x": [0], "y": [0], "id": [1, 2]}, {"id": "id"}, "the column 'id' has 2 rows, but 'k' has 1"),
    (DUPLICATES, {}, "k has 2 columns: expected one"),
    (NAMED_TWICE, {"id": "id"}, "id has 2 columns: expected one"),
    ({"k": [Decimal("sNaN"), 1, 1], "x": [0, 1, 2], "y": [0, 1, 2]}, {}, "by: a cell of 'k' is no key: "),
    ({"k": [numpy.array([1, 2])] * 3, "x": [0, 1, 2], "y": [0, 1, 2]}, {}, "by: a cell of 'k' is no key: "),
    ({"k": [[1], [1], [1]], "x": [0, 1, 2], "y": [0, 1, 2]}, {}, "by: a cell of 'k' is no key: "),
]


@pytest.mark.parametrize(("frame", "how", "message"), NO_COLUMNS, ids=lambda own: own if isinstance(own, str) else "")
def test_columns_that_are_none_are_refused(frame: Any, how: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(message)}"):
        boundfit.fit_groups(frame, "k", "x", "y", 1, **how)


def test_names_with_levels_are_taken_by_the_first() -> None:
    frame = pandas.DataFrame([["a", 0, 1], ["b", 1, 1], ["b", 2, 1]], columns=pandas.MultiIndex.from_tuples([("k", "p"), ("x", "p"), ("y", "q")]))
    found = boundfit.fit_groups(frame, "k", "x", "y", 1)
    assert (found["k"].tolist(), found["rows"].tolist()) == (["a", "b"], [1, 2])


@pytest.mark.parametrize("stored", ["int8", "uint16", "int32", "int64", "uint64"])
def test_integers_are_the_keys_that_they_are_in_a_list(stored: str) -> None:
    most = int(numpy.iinfo(stored).max)
    keys = [7, 7, most, 0, most, 7, 0, most]
    table = {"x": [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0], "y": [0.5, 1.0, 2.5, 3.0, 4.0, 5.5, 6.0, 7.25]}
    expected = boundfit.fit_groups({"k": keys, **table}, by="k", x="x", y="y", eps="1/2")
    assert expected["k"] == [7, most, 0]
    array = numpy.array(keys, dtype=stored)
    columns: dict[str, Any] = {"numpy": {"k": array, **table}, "pandas": pandas.DataFrame({"k": array, **table}), "polars": polars.DataFrame({"k": array, **table})}
    # Every other row of a longer table: its cells are no neighbours in memory.
    columns["strided"] = {"k": numpy.repeat(array, 2)[::2], **table}
    for frame in columns.values():
        answer = boundfit.fit_groups(frame, by="k", x="x", y="y", eps="1/2")
        for name in expected:
            assert list(answer[name]) == expected[name] or name == "problem", name
    missing = {"k": polars.Series([*keys[:-1], None], dtype=columns["polars"]["k"].dtype), **table}
    answer = boundfit.fit_groups(polars.DataFrame(missing), by="k", x="x", y="y", eps="1/2")
    assert answer["k"].to_list() == [7, most, 0, None]
