"""Engines that run on many machines, each against what is computed here at once. `.ci/distributed` installs them and runs these."""

from __future__ import annotations

import os
import random
import re
from decimal import Decimal
from typing import Any

import boundfit
import pyarrow
import pytest

if "BOUNDFIT_DISTRIBUTED" not in os.environ:
    collect_ignore_glob = ["test_*.py"]

#: Questions about lines of all readings, and those about groups.
LINES: dict[str, dict[str, Any]] = {
    "doubles": {"x": "x", "y": "y", "eps": "0.02"},
    "as stored": {"x": "x", "y": "y", "eps": "0.02", "reading": "binary64"},
    "decimals": {"x": "x", "y": "d", "eps": "1/50"},
    "gaps": {"x": "x", "y": "gaps", "eps": "0.02", "missing": "skip"},
    "column": {"x": "x", "y": "d", "eps_column": "e"},
    "law": {"x": "x", "y": "y", "eps": "1%*|y| + 0.05"},
    "regressors": {"x": ["x", "e"], "y": "y", "eps": "2"},
}
FLEETS = {name: LINES[name] for name in ("doubles", "decimals", "gaps", "column", "law")} | {
    "bad groups": {"x": "x", "y": "gaps", "eps": "0.02", "id": "row"}
}


@pytest.fixture(scope="session")
def table() -> pyarrow.Table:
    """Readings of 60 sensors, one of which has nearly half of them, and one of which has no name."""
    random_ = random.Random(5)
    names = [None if k == 7 else f"s{k:02}" for k in range(60)]
    keys = [names[3] if k % 5 < 2 else random_.choice(names) for k in range(5000)]
    xs = [random_.randrange(800) / 16 for _ in keys]
    ys = [round(1.5 * x + 0.25 + random_.uniform(-0.02, 0.02), 4) for x in xs]
    gaps = [None if key == "s05" and k % 3 == 0 else float("nan") if key == "s06" else y for k, (key, y) in enumerate(zip(keys, ys, strict=True))]
    return pyarrow.table(
        {
            "row": pyarrow.array(range(5000), pyarrow.int64()),
            "sensor": keys,
            "x": xs,
            "y": ys,
            "gaps": gaps,
            "e": [random_.choice([0.02, 0.025, 0.05]) for _ in keys],
            "d": pyarrow.array([Decimal(str(y)) for y in ys], pyarrow.decimal128(10, 4)),
        }
    )


def of_table(table: pyarrow.Table, question: dict[str, Any]) -> boundfit.Fit:
    """The fit of all rows at once."""
    own = dict(question)
    own.pop("id", None)
    names = own.pop("x")
    x = table[names] if isinstance(names, str) else tuple(table[name] for name in names)
    y, column = table[own.pop("y")], own.pop("eps_column", None)
    eps = own.pop("eps", None) if column is None else table[column]
    return boundfit.fit(x, y, eps, **own, eui=False)


def said(fit: boundfit.Fit) -> Any:
    """What a fit says of all readings, whatever their rows are called."""
    pui = fit.pui
    ends = None if pui is None else [(end.lower, end.upper) for end in pui]
    return fit.rows, fit.kind, fit.vertices, ends, fit.central, fit.least_squares


def of_groups(table: pyarrow.Table, question: dict[str, Any]) -> dict[Any, dict[str, Any]]:
    """What is said of each group in memory."""
    answer = boundfit.fit_groups(table, "sensor", **question)
    return {row.pop("sensor"): row for row in answer.to_pylist()}


def check_groups(found: list[dict[str, Any]], table: pyarrow.Table, question: dict[str, Any]) -> None:
    """The rows that there are in memory, in any order. A problem names one of the wrong readings, if they have identities."""
    # pandas has NaN where there is nothing.
    rows = [{name: None if value != value else value for name, value in row.items()} for row in found]
    keyed = {row.pop("sensor"): row for row in rows}
    assert len(keyed) == len(rows)
    expected = of_groups(table, question)
    assert list(next(iter(keyed.values()))) == list(next(iter(expected.values())))
    for own in (keyed, expected):
        for key, row in own.items():
            if row["problem"] in (None, "every row of the group lacks a number"):
                continue
            named = re.search(r"\brow (\d+), ", row["problem"])
            assert (named is not None) == ("id" in question or own is expected), row["problem"]
            if named is not None and "id" in question:
                assert table["sensor"][int(named[1])].as_py() == key, "identities are numbers of rows from 0"
            row["problem"] = re.sub(r"\brow \d+, ", "", row["problem"], count=1)
    assert keyed == expected
