"""Spark on threads of one JVM, and on executors that are processes of their own."""

from __future__ import annotations

import os
import re
import signal
import time
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import boundfit.spark
import pyarrow
import pytest
from boundfit import _partitions
from boundfit._reduction import Reduction, merge_parts, readings
from pyspark import TaskContext
from pyspark.sql import DataFrame, SparkSession

from .conftest import FLEETS, LINES, check_groups, of_table, said


@pytest.fixture(scope="module", params=["local[2]", "local-cluster[2,1,1024]"])
def spark(request: pytest.FixtureRequest) -> Iterator[SparkSession]:
    settings = {
        "spark.driver.host": "127.0.0.1",
        "spark.driver.bindAddress": "127.0.0.1",
        "spark.driver.memory": "1g",
        "spark.executor.memory": "1g",
        "spark.ui.enabled": "false",
        "spark.sql.shuffle.partitions": "5",
        # Batches that groups span.
        "spark.sql.execution.arrow.maxRecordsPerBatch": "100",
    }
    builder = SparkSession.builder.master(request.param).appName("boundfit")
    for name, value in settings.items():
        builder = builder.config(name, value)
    session = builder.getOrCreate()
    yield session
    session.stop()


@pytest.fixture(scope="module")
def df(spark: SparkSession, table: pyarrow.Table) -> DataFrame:
    # More partitions than keys in some of them, and some without any row.
    frame = spark.createDataFrame(table)
    return frame.repartition(7).union(frame.limit(0).repartition(2))


def separate(spark: SparkSession) -> bool:
    return spark.sparkContext.master.startswith("local-cluster")


@pytest.mark.parametrize("name", LINES)
def test_a_fit_of_all_readings(df: DataFrame, table: pyarrow.Table, name: str) -> None:
    fit = boundfit.spark.fit(df, **LINES[name])
    assert said(fit) == said(of_table(table, LINES[name]))


def test_every_number_of_partitions(df: DataFrame, table: pyarrow.Table) -> None:
    expected = said(of_table(table, LINES["doubles"]))
    for count in (1, 2, 40):
        for fan_in in (3, 256):
            reduction = boundfit.spark.reduce(df.repartition(count), "x", "y", id="row", fan_in=fan_in)
            assert said(reduction.fit("0.02")) == expected
            xs, ys = table["x"].to_pylist(), table["y"].to_pylist()
            kept = [line.split(b",") for line in reduction.text.splitlines()[2:]]
            assert reduction.ids is not None and len(kept) == len(reduction.ids)
            for line, id in zip(kept, reduction.ids, strict=True):
                # In front may be how many readings it stands for.
                assert (float(line[0].split()[-1]), float(line[1])) == (xs[int(id)], ys[int(id)])


def test_no_rdd_is_asked_for(df: DataFrame, table: pyarrow.Table, monkeypatch: pytest.MonkeyPatch) -> None:
    # Serverless and shared clusters have none.
    def refused(_: DataFrame) -> None:
        raise AssertionError("rdd is asked for")

    monkeypatch.setattr(type(df), "rdd", property(refused))
    assert said(boundfit.spark.fit(df, **LINES["doubles"], fan_in=2)) == said(of_table(table, LINES["doubles"]))
    check_groups([row.asDict() for row in boundfit.spark.fit_groups(df, "sensor", **FLEETS["doubles"]).collect()], table, FLEETS["doubles"])


def test_a_stream_is_refused(spark: SparkSession, df: DataFrame, tmp_path: Path) -> None:
    stream = spark.readStream.schema(df.schema).parquet(str(tmp_path))
    with pytest.raises(ValueError, match="the frame is a stream"):
        boundfit.spark.fit_groups(stream, "sensor", "x", "y", "0.1")


def test_a_table_without_rows(spark: SparkSession, df: DataFrame) -> None:
    nothing = boundfit.spark.reduce(df.limit(0), "x", "y")
    assert (nothing.rows, nothing.kept) == (0, 0)
    with pytest.raises(ValueError, match="the table has no readings"):
        boundfit.spark.fit(df.limit(0), "x", "y", "0.1")
    assert boundfit.spark.fit_groups(df.limit(0), "sensor", "x", "y", "0.1").collect() == []


def test_what_is_wrong_is_said_without_a_failed_job(df: DataFrame) -> None:
    with pytest.raises(ValueError, match=r"part \d+: readings: row \d+, column 2 \(gaps\): \"NaN\": the value is missing"):
        boundfit.spark.fit(df, "x", "gaps", "0.1")
    with pytest.raises(ValueError, match="the frame has no column 'z'"):
        boundfit.spark.fit(df, "x", "z", "0.1")
    with pytest.raises(ValueError, match="a column 'kind' is part of the answer"):
        boundfit.spark.fit_groups(df.withColumnRenamed("sensor", "kind"), "kind", "x", "y", "0.1")


@pytest.mark.parametrize("name", FLEETS)
@pytest.mark.parametrize("how", [{}, {"partitions": 1}, {"partitions": 9, "combine": 100}])
def test_fleets(df: DataFrame, table: pyarrow.Table, name: str, how: dict[str, Any]) -> None:
    answer = boundfit.spark.fit_groups(df, "sensor", **FLEETS[name], **how)
    check_groups([row.asDict() for row in answer.collect()], table, FLEETS[name])


def test_keys_keep_their_types(df: DataFrame) -> None:
    answer = boundfit.spark.fit_groups(df, ["sensor", "d"], "x", "y", "0.1")
    assert [field.dataType for field in answer.schema][:2] == [df.schema["sensor"].dataType, df.schema["d"].dataType]
    assert answer.count() == df.select("sensor", "d").distinct().count()


def test_the_page_of_the_guide(spark: SparkSession, table: pyarrow.Table, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page = (Path(__file__).resolve().parents[3] / "docs/past-one-machine.md").read_text()
    [block] = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    monkeypatch.chdir(tmp_path)
    path = str(tmp_path)
    spark.createDataFrame(table.select(["row", "sensor", "x", "y"])).write.parquet(f"{path}/readings.parquet")
    exec(block.replace('parquet("', f'parquet("{path}/'), {"spark": spark})
    assert (tmp_path / "reduced.csv").read_text().startswith("# boundfit/reduced/")
    assert spark.read.parquet(f"{path}/sensors.parquet").count() == 60


def killing(marker: Path, partition: int) -> Any:
    """Rows as they are; in the middle of a partition the executor is killed, once."""

    def work(batches: Iterator[pyarrow.RecordBatch]) -> Iterator[pyarrow.RecordBatch]:
        context = TaskContext.get()
        for batch in batches:
            yield batch
            if context is not None and context.partitionId() == partition and not marker.exists():
                marker.touch()
                # This process comes from a daemon, and that from the executor.
                parent = Path(f"/proc/{os.getppid()}/stat").read_text().rpartition(")")[2].split()[1]
                os.kill(int(parent), signal.SIGKILL)
                time.sleep(60)

    return work


def test_an_executor_that_is_killed_in_the_middle(spark: SparkSession, df: DataFrame, table: pyarrow.Table, tmp_path: Path) -> None:
    if not separate(spark):
        return  # It would be the driver.
    cut = df.mapInArrow(killing(tmp_path / "reduce", 2), df.schema)
    assert said(boundfit.spark.fit(cut, **LINES["decimals"])) == said(of_table(table, LINES["decimals"]))
    cut = df.mapInArrow(killing(tmp_path / "before", 1), df.schema)
    answer = boundfit.spark.fit_groups(cut, "sensor", **FLEETS["bad groups"], partitions=4)
    # What the executor had written for others is lost with it, and is computed again.
    answer = answer.mapInArrow(killing(tmp_path / "after", 0), answer.schema)
    check_groups([row.asDict() for row in answer.collect()], table, FLEETS["bad groups"])
    assert sorted(path.name for path in tmp_path.iterdir()) == ["after", "before", "reduce"]


def test_tasks_that_run_twice(df: DataFrame, table: pyarrow.Table) -> None:
    own = readings("x", "y", "0.02")
    parts = boundfit.spark._map(df, partial(boundfit.spark._reduced, own=own), _partitions.PARTS)
    # As when the copy of a slow task, which Spark begins on another machine, sends what the task has sent.
    twice = [*_partitions.parts_of(parts.toArrow().to_batches()), *_partitions.parts_of(parts.toArrow().to_batches())]
    assert len(twice) == 2 * df.rdd.getNumPartitions()
    merged = merge_parts(twice, own)
    assert merged.reduction is not None
    assert said(Reduction(merged.reduction, own).fit()) == said(of_table(table, LINES["doubles"]))
