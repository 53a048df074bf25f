"""Dask on threads, and on processes of their own."""

from __future__ import annotations

from collections.abc import Iterator
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
