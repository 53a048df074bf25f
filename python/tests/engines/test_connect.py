"""Spark Connect: the session is a client, and has no RDD. A server of its own, which a session without a client would disturb."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import boundfit.spark
import pyarrow
import pytest
from pyspark.errors import PySparkNotImplementedError
from pyspark.sql import DataFrame, SparkSession

from .conftest import FLEETS, LINES, check_groups, of_table, said


@pytest.fixture(scope="module")
def spark() -> Iterator[SparkSession]:
    session = SparkSession.builder.remote("local[2]").config("spark.sql.shuffle.partitions", "5").getOrCreate()
    yield session
    session.stop()


@pytest.fixture(scope="module")
def df(spark: SparkSession, table: pyarrow.Table) -> DataFrame:
    frame = spark.createDataFrame(table)
    return frame.repartition(7).union(frame.limit(0).repartition(2))


def test_there_is_no_rdd(df: DataFrame) -> None:
    with pytest.raises(PySparkNotImplementedError):
        df.rdd  # noqa: B018


@pytest.mark.parametrize("name", LINES)
def test_a_fit_of_all_readings(df: DataFrame, table: pyarrow.Table, name: str) -> None:
    assert said(boundfit.spark.fit(df, **LINES[name])) == said(of_table(table, LINES[name]))


def test_every_number_of_partitions(df: DataFrame, table: pyarrow.Table) -> None:
    expected = said(of_table(table, LINES["doubles"]))
    for count in (1, 20):
        for fan_in in (2, 256):
            assert said(boundfit.spark.reduce(df.repartition(count), "x", "y", id="row", fan_in=fan_in).fit("0.02")) == expected
    nothing = boundfit.spark.reduce(df.limit(0), "x", "y")
    assert (nothing.rows, nothing.kept) == (0, 0)


@pytest.mark.parametrize("name", ["decimals", "bad groups"])
@pytest.mark.parametrize("how", [{}, {"partitions": 3, "combine": 100}])
def test_fleets(df: DataFrame, table: pyarrow.Table, name: str, how: dict[str, Any]) -> None:
    answer = boundfit.spark.fit_groups(df, "sensor", **FLEETS[name], **how)
    check_groups([row.asDict() for row in answer.collect()], table, FLEETS[name])


def test_a_stream_is_refused(spark: SparkSession, df: DataFrame, tmp_path: Path) -> None:
    stream = spark.readStream.schema(df.schema).parquet(str(tmp_path))
    for question in (boundfit.spark.fit, boundfit.spark.reduce):
        with pytest.raises(ValueError, match="the frame is a stream"):
            question(stream, "x", "y", "0.1")
    with pytest.raises(ValueError, match="the frame is a stream"):
        boundfit.spark.fit_groups(stream, "sensor", "x", "y", "0.1")
