"""Dask on threads, and on processes of their own."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import date
from decimal import Decimal
from fractions import Fraction
from typing import Any

import boundfit.dask
import dask
import dask.dataframe
import pandas
import pyarrow
import pytest

from .conftest import FLEETS, LINES, check_groups, of_table, said


@pytest.fixture(scope="module", params=["threads", "processes"], autouse=True)
def scheduler(request: pytest.FixtureRequest) -> Iterator[None]:
    with dask.config.set(scheduler=request.param, num_workers=2):
        yield


@pytest.fixture(scope="module")
def ddf(table: pyarrow.Table) -> Any:
    # Some partitions have no rows.
    frame = dask.dataframe.from_pandas(table.to_pandas(), npartitions=7)
    return dask.dataframe.concat([frame, frame.partitions[0][frame.partitions[0]["x"] < -1]])


@pytest.mark.parametrize("name", LINES)
def test_a_fit_of_all_readings(ddf: Any, table: pyarrow.Table, name: str) -> None:
    expected = said(of_table(table, LINES[name]))
    assert said(boundfit.dask.fit(ddf, **LINES[name])) == expected
    assert said(boundfit.dask.fit(ddf, **LINES[name], fan_in=2)) == expected


@pytest.mark.parametrize("name", FLEETS)
@pytest.mark.parametrize("how", [{}, {"partitions": 3, "combine": 100}])
def test_fleets(ddf: Any, table: pyarrow.Table, name: str, how: dict[str, Any]) -> None:
    answer = boundfit.dask.fit_groups(ddf, "sensor", **FLEETS[name], **how)
    found = answer.compute()
    assert list(found.columns) == list(answer.columns)
    rows = found.astype(object).where(found.notna(), None).to_dict("records")
    check_groups(rows, table, FLEETS[name])


def test_what_is_wrong_is_said() -> None:
    frame = dask.dataframe.from_pandas(pandas.DataFrame({"row": [10, 20, 30], "x": [0.0, 1.0, 2.0], "y": [0.0, None, 1.0]}), npartitions=2)
    with pytest.raises(ValueError, match=r"part 0: readings: row 2, column 2 \(y\)"):
        boundfit.dask.fit(frame, "x", "y", "0.1")
    nothing = boundfit.dask.reduce(frame[frame["x"] < 0], "x", "y")
    assert (nothing.rows, nothing.kept) == (0, 0)


def test_keys_keep_their_types() -> None:
    keys = pandas.array([2**60 + 1, None, 2**60 + 1, None, 5, 5], dtype="Int64")
    frame = pandas.DataFrame({"k": keys, "j": pandas.Categorical(["a", "b", "a", "b", " a", " a"]), "x": [0, 0, 1, 1, 0, 1], "y": [0.0, 0, 1, 2, 0, 3]})
    for how in ({}, {"combine": 1}):
        answer = boundfit.dask.fit_groups(dask.dataframe.from_pandas(frame, npartitions=2), ["k", "j"], "x", "y", 0, **how)
        found = answer.compute().sort_values("theta1_lower").reset_index(drop=True)
        expected = boundfit.fit_groups(frame, ["k", "j"], "x", "y", 0)
        assert [str(found[name].dtype) for name in ("k", "j")] == ["Int64", "category"]
        for name in expected.columns:
            assert [None if value is pandas.NA or value != value else value for value in found[name]] == [
                None if value is pandas.NA or value != value else value for value in expected[name]
            ], name


MIXED: dict[str, list[Any]] = {
    "numbers": [0, "1", Decimal("2"), Fraction(1, 3)],
    "long integers": [0, 10**30, 2, 3],
    "floats and integers": [0, 2.5, 2, 3],
}


@pytest.mark.parametrize("name", MIXED)
@pytest.mark.parametrize("partitions", [1, 2])
def test_columns_of_objects_of_several_types_are_as_exact(name: str, partitions: int) -> None:
    frame = pandas.DataFrame({"k": ["a", "b", "a", "b"], "x": [0, 1, 2, 3], "y": pandas.Series(MIXED[name], dtype=object)})
    with dask.config.set({"dataframe.convert-string": False}):
        found = boundfit.dask.fit_groups(dask.dataframe.from_pandas(frame, npartitions=partitions), "k", "x", "y", 0).compute()
    expected = boundfit.fit_groups(frame, "k", "x", "y", 0).set_index("k")["theta1_lower_exact"]
    assert found.set_index("k")["theta1_lower_exact"].to_dict() == expected.to_dict()


@pytest.mark.parametrize("keys", [[b"a", b"b"], [1, 2.5], [date(2026, 1, 1), date(2026, 1, 2)]], ids=repr)
def test_keys_of_objects_are_keys(keys: list[Any]) -> None:
    frame = pandas.DataFrame({"k": pandas.Series(keys * 2, dtype=object), "x": [0, 0, 1, 1], "y": [0, 0, 1, 2]})
    with dask.config.set({"dataframe.convert-string": False}):
        found = boundfit.dask.fit_groups(dask.dataframe.from_pandas(frame, npartitions=2), "k", "x", "y", 0).compute()
    assert found.set_index("k")["theta1_lower"].to_dict() == {keys[0]: 1, keys[1]: 2}


def test_what_is_misspelt_is_refused_by_name() -> None:
    frame = pandas.DataFrame({"k": [1], "x": [1], "y": [1]})
    ddf = dask.dataframe.from_pandas(frame, npartitions=1)
    with pytest.raises(ValueError, match=r"the frame has no column 'z' \(it has 'k', 'x', 'y'\)"):
        boundfit.dask.fit(ddf, "x", "z", 1)
    with pytest.raises(ValueError, match="the frame has no column 'key'"):
        boundfit.dask.fit_groups(ddf, "key", "x", "y", 1)
    with pytest.raises(ValueError, match=r"ddf is of type pandas\..*DataFrame: expected a data frame of Dask"):
        boundfit.dask.fit(frame, "x", "y", 1)
    with pytest.raises(TypeError, match=r"fit\(\) got an unexpected keyword argument 'epsilon_column': did you mean 'eps_column'\?"):
        boundfit.dask.fit(ddf, "x", "y", epsilon_column="y")
