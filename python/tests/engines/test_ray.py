"""Ray on two processes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import boundfit.ray
import pyarrow
import pytest
import ray
import ray.data

from .conftest import FLEETS, LINES, check_groups, of_table, said


@pytest.fixture(scope="module", autouse=True)
def cluster() -> Iterator[None]:
    ray.init(num_cpus=2, object_store_memory=200 * 2**20, include_dashboard=False, log_to_driver=False)
    yield
    ray.shutdown()


@pytest.fixture(scope="module")
def dataset(table: pyarrow.Table, cluster: None) -> Any:
    # Some blocks have no rows.
    return ray.data.from_arrow([table.slice(0, 3), table.slice(3, 2000), table.slice(0, 0), table.slice(2003)])


@pytest.mark.parametrize("name", LINES)
def test_a_fit_of_all_readings(dataset: Any, table: pyarrow.Table, name: str) -> None:
    expected = said(of_table(table, LINES[name]))
    assert said(boundfit.ray.fit(dataset, **LINES[name])) == expected
    assert said(boundfit.ray.fit(dataset, **LINES[name], fan_in=2)) == expected


@pytest.mark.parametrize("name", FLEETS)
@pytest.mark.parametrize("how", [{}, {"partitions": 1}, {"partitions": 3, "combine": 100}])
def test_fleets(dataset: Any, table: pyarrow.Table, name: str, how: dict[str, Any]) -> None:
    answer = boundfit.ray.fit_groups(dataset, "sensor", **FLEETS[name], **how)
    check_groups(answer.take_all(), table, FLEETS[name])


def test_what_is_wrong_is_said(dataset: Any) -> None:
    with pytest.raises(ValueError, match=r"part \d: readings: row \d+, column 2 \(gaps\)"):
        boundfit.ray.fit(dataset, "x", "gaps", "0.1")
    nothing = boundfit.ray.reduce(dataset.filter(lambda row: row["x"] < -1), "x", "y")
    assert (nothing.rows, nothing.kept) == (0, 0)
