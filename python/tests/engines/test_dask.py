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
