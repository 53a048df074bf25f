"""Tables in parts: the functions that Spark, Dask and Ray run, here without any of them. Whatever way rows are dealt out, the answer
is that of the whole."""

from __future__ import annotations

import itertools
import math
import random
import re
from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import boundfit
import pyarrow
import pyarrow.compute
import pytest
from boundfit import _partitions as partitions
from boundfit._reduction import Part, Readings, Reduction, merge_parts, merged, readings, to_fit, to_reduce

from conftest import Program

# Edges of hulls, equal points, and numbers that no double is.
TABLE = pyarrow.table(
    {
        "id": ["a", "b", 'c"1', "d,e", "f", "g\nh", "#i"],
        "x": [0.0, 0.1, 2.0, 2.0, 3.0, 1.0, 3.0],
        "y": [0.3, 1.5, 1.5, 1.5, 3.0, 1e-7, 3.0],
        "d": [Decimal("0.30"), Decimal("1.50"), Decimal("1.55"), Decimal("-1.50"), Decimal("3.00"), Decimal("0.01"), Decimal("3.00")],
        "t": ["1/3", "0.5", "7", "1e-3", "2", "-1", "2"],
        "e": [0.5, 1.0, 0.5, 0.5, 2.0, 0.25, 0.5],
        "n": [1, -2, 3, 3, 5, 1 << 60, 4],
        "gaps": [0.5, None, 2.0, float("nan"), 3.0, 1.0, 3.5],
        "lo": [0.0, None, 1.0, 1.0, None, -1.0, 2.0],
        "up": [1.0, 2.0, None, 3.0, 4.0, 2.0, None],
    }
)

QUESTIONS = {
    "line": readings("x", "y", "0.5", id="id"),
    "no identity": readings("x", "y", "0.5"),
    "doubles as stored": readings("x", "y", "0.5", id="id", reading="binary64"),
    "decimals": readings("x", "d", "1/3", id="id"),
    "decimals beside doubles as stored": readings("x", "d", "1/3", id="id", reading="binary64"),
    "texts beside doubles as stored": readings("x", "t", 0.1, id="id", reading="binary64"),
    "texts": readings("t", "d", "2", id="id"),
    "integers": readings("n", "y", "2", id="id", through_origin=True),
    "gaps": readings("x", "gaps", "2", id="id", missing="skip"),
    "least": readings("x", "y", "1.5*min", id="id", where="theta1 >= 0"),
    "column": readings("x", "y", eps_column="e", id="id"),
    "numbers that are names": readings("x", "y", "0.1", id="x"),
    "law": readings("x", "y", "5%*|y| + 0.4", id="id"),
    "intervals": readings("x", lower="lo", upper="up", id="id"),
    "regressors": readings(["x", "t"], "y", "3", id="id"),
}


def batches_of(table: pyarrow.Table, most: int = 2) -> Iterator[pyarrow.RecordBatch]:
    # Engines send empty batches too.
    yield pyarrow.RecordBatch.from_pylist([], schema=table.schema)
    yield from table.to_batches(max_chunksize=most)


def whole(own: Readings, table: pyarrow.Table = TABLE) -> Reduction:
    part = partitions.reduce_partition(0, table.to_batches(), own)
    assert part.reduction is not None, part.problem
    return Reduction(part.reduction, own)


def fit_in_memory(own: Readings) -> boundfit.Fit:
    """The fit of all rows at once, by the function for arrays, which knows nothing of parts."""
    columns = {name: TABLE[name] for name in own.columns}
    if "d" in columns:
        columns["d"] = columns["d"].to_pylist()
    x = tuple(columns[name] for name in own.x)
    return boundfit.fit(
        x if len(x) == 2 else x[0],
        None if own.y is None else columns[own.y],
        own.eps if own.eps_column is None else columns[own.eps_column],
        lower=None if own.lower is None else columns[own.lower],
        upper=None if own.upper is None else columns[own.upper],
        where=own.where,
        through_origin=own.through_origin,
        reading=own.reading,
        missing=own.missing,
        eui=False,
    )


def said(fit: boundfit.Fit) -> Any:
    pui = fit.pui
    ends = None if pui is None else [(end.lower, end.upper) for end in pui]
    return fit.kind, fit.vertices, fit.rays, fit.lines, ends, fit.central, fit.least_squares


@pytest.mark.parametrize("name", QUESTIONS)
def test_every_way_of_cutting_a_table_gives_the_reduction_of_the_whole(name: str) -> None:
    own = QUESTIONS[name]
    expected = whole(own).text
    rows = TABLE.num_rows
    for cuts in itertools.chain.from_iterable(itertools.combinations(range(rows + 1), count) for count in range(4)):
        # The first and the last cut leave nothing on one side.
        edges = [0, *cuts, rows]
        pieces = [TABLE.slice(start, end - start) for start, end in itertools.pairwise(edges)]
        parts = [partitions.reduce_partition(number, batches_of(piece), own) for number, piece in enumerate(pieces)]
        parts += [partitions.reduce_partition(len(parts), [], own)]
        assert merge_parts(reversed(parts), own) == Part(0, expected), cuts
        # A tree is no different, nor what is sent as rows.
        sent = partitions.parts_as_batch(parts)
        level = [part for batch in partitions.merge_partition([sent], own, 2) for part in partitions.parts_of([batch])]
        assert [part.number for part in level] == list(range((len(parts) + 1) // 2))
        assert merge_parts(level, own) == Part(0, expected), cuts


@pytest.mark.parametrize("name", QUESTIONS)
def test_rows_dealt_out_at_random_give_the_same_fit(name: str) -> None:
    own = QUESTIONS[name]
    random_ = random.Random(7)
    expected = fit_in_memory(own)
    for count in (1, 2, 3, 5):
        dealt: list[list[int]] = [[] for _ in range(count)]
        for row in random_.sample(range(TABLE.num_rows), TABLE.num_rows):
            random_.choice(dealt).append(row)
        parts = [partitions.reduce_partition(number, batches_of(TABLE.take(pyarrow.array(rows, pyarrow.int64()))), own) for number, rows in enumerate(dealt)]
        merged_part = merge_parts(parts, own)
        assert merged_part.reduction is not None
        fit = Reduction(merged_part.reduction, own).fit()
        assert said(fit) == said(expected)
        assert fit.rows == expected.rows
        if own.decide_alone():
            assert fit.minimax == expected.minimax
        fit.verify()


def test_proofs_name_the_identities_of_readings() -> None:
    own = readings("x", "y", "0.5", id="id")
    table = pyarrow.table({"id": [70, 60, 50, 40], "x": [0.0, 1.0, 2.0, 3.0], "y": [0.0, 1.5, 1.5, 3.0]})
    fit, expected = whole(own, table).fit(), boundfit.fit(table["x"], table["y"], "0.5")
    assert fit.ids == ["70", "60", "50", "40"]
    assert fit.pui is not None and expected.pui is not None
    for end, other in zip(fit.pui, expected.pui, strict=True):
        assert isinstance(end, boundfit.ProvedInterval) and isinstance(other, boundfit.ProvedInterval)
        for terms, others in ((end.lower_proof, other.lower_proof), (end.upper_proof, other.upper_proof)):
            # Row 1 is 70, row 2 is 60, and so on.
            assert [term._replace(row=8 - int(term.row or 0) // 10) for term in terms] == list(others)
    assert fit.contradiction is None
    contradiction = whole(own, table).fit("0.1").contradiction
    assert contradiction is not None and {term.row for term in contradiction} <= {"70", "60", "50", "40"}


def test_identities_may_be_any_text() -> None:
    reduction = whole(readings("x", "y", "0.5", id="id"))
    assert reduction.ids == ["a", "b", 'c"1', "f", "g\nh"]
    assert reduction.kept == 5 and reduction.rows == 7
    assert whole(readings("x", "y", "0.5")).ids is None
    assert whole(readings("x", "y", "0.5")).fit().ids is None


def test_a_reduction_is_what_the_program_reads(tmp_path: Path, program: Program) -> None:
    own = readings("x", "y", "0.5", id="id")
    path = tmp_path / "reduced.csv"
    whole(own).save(path)
    assert program("reduce", path, "--x", "x", "--y", "y").encode() == path.read_bytes()
    assert boundfit.fit_file(path, "x", "y", "0.5").vertices == fit_in_memory(own).vertices
    assert whole(own).fit("0.9").vertices == boundfit.fit(TABLE["x"], TABLE["y"], "0.9").vertices


def test_nothing_is_reduced_to_nothing(tmp_path: Path, program: Program) -> None:
    own = readings("x", "y", "0.5", id="id")
    nothing = b'# boundfit/reduced/1 {"rows":0,"kept":0,"header":true,"reading":"decimal","x":"x","y":"y","epsilon":null,"sums":["0","0","0","0"]}\nx,y,id\n'
    assert own.nothing() == nothing == merged([], own) == merged([nothing] * 3, own)
    with pytest.raises(ValueError, match="the table has no readings"):
        Reduction(nothing, own).fit()
    path = tmp_path / "reduced.csv"
    path.write_bytes(nothing + whole(own).text + nothing)
    assert program("reduce", path, "--x", "x", "--y", "y").encode() == whole(own).text
    assert boundfit.fit_file(path, "x", "y", "0.5").vertices == fit_in_memory(own).vertices


def test_a_thousand_partitions_in_a_tree() -> None:
    own = readings("x", "y", "0.02", id="id")
    random_ = random.Random(1)
    texts, tables = [], []
    for part in range(1000):
        rows = random_.choice([0, 1, 7, 40])
        xs = [random_.randrange(1000) / 8 for _ in range(rows)]
        ys = [round(1.5 * x + 0.25 + random_.uniform(-0.01, 0.01), 5) for x in xs]
        table = pyarrow.table(
            {"id": pyarrow.array([f"{part}:{row}" for row in range(rows)], pyarrow.string()), "x": pyarrow.array(xs, pyarrow.float64()), "y": pyarrow.array(ys, pyarrow.float64())}
        )
        tables.append(table)
        texts.append(partitions.reduce_partition(part, table.to_batches(), own))
    everything = whole(own, pyarrow.concat_tables(tables))
    assert everything.rows > 10_000 and everything.kept < 60
    for fan_in in (2, 10, 256, 1000):
        level, depth = texts, 0
        while len(level) > 1:
            sent = partitions.parts_as_batch(random_.sample(level, len(level)))
            level = [part for batch in partitions.merge_partition([sent], own, fan_in) for part in partitions.parts_of([batch])]
            depth += 1
        assert level == [Part(0, everything.text)]
        assert depth == {2: 10, 10: 3, 256: 2, 1000: 1}[fan_in]


def test_a_part_that_comes_twice_counts_once() -> None:
    own = readings("x", "y", "0.5")
    halves = [partitions.reduce_partition(number, TABLE.slice(4 * number, 4).to_batches(), own) for number in (0, 1)]
    assert merge_parts([*halves, halves[1], halves[0]], own) == merge_parts(halves, own) == Part(0, whole(own).text)
    # The other attempt of a task may have read its rows in another order, and kept another one of equal readings.
    again = partitions.reduce_partition(0, TABLE.slice(0, 4).take([3, 2, 1, 0]).to_batches(), own)
    assert again != halves[0]
    assert merge_parts([*halves, again], own) == Part(0, whole(own).text)
    with pytest.raises(ValueError, match="part 1 came twice with different readings"):
        merge_parts([*halves, Part(1, halves[0].reduction)], own)


def test_readings_that_are_wrong_are_an_answer() -> None:
    own = readings("x", "gaps", "2")
    parts = [partitions.reduce_partition(number, TABLE.slice(3 * number, 3).to_batches(), own) for number in (0, 1, 2)]
    problem = 'part 0: readings: row 2, column 2 (gaps): "NaN": the value is missing'
    assert [part.reduction is None for part in parts] == [True, True, False]
    assert str(parts[0].problem).startswith(problem)
    assert str(merge_parts(reversed(parts), own).problem).startswith(problem)
    [sent] = partitions.merge_partition([partitions.parts_as_batch(parts)], own, 8)
    assert str(partitions.parts_of([sent])[0].problem).startswith(problem)


@pytest.mark.parametrize(
    "arguments, message",
    [
        ({"x": ["x", "t"], "y": "y"}, "the bound on the errors is missing"),
        ({"x": ["x", "y", "t"], "y": "y", "eps": 1}, "x names 3 columns"),
        ({"x": "x", "y": "y", "eps": "much"}, 'eps="much"'),
        ({"x": "x", "y": "y", "eps": 1, "where": "theta3 > 1"}, 'where="theta3 > 1"'),
        ({"x": ["x", "t"], "y": "y", "eps": "2*min"}, "a multiple of the least bound is not known"),
        ({"x": "x", "y": "y", "eps": "5%*range(y) + 1%*|y|"}, "range"),
    ],
)
def test_questions_that_make_no_sense_are_refused_before_rows_are_moved(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError) as refused:
        readings(**arguments).nothing()
    assert message in str(refused.value)


# Fleets.

FLEET = pyarrow.table(
    {
        "k": ["u", "v", "u", None, "u", "v", "w", "w", None, "", "s", "s"],
        "j": [1, 2, 1, None, 1, 2, 3, 3, None, 1, 4, 4],
        "id": list(range(100, 112)),
        "x": [0.0, 1.0, 2.0, 3.0, 1.0, 7.0, 1.0, 2.0, 3.0, 1.0, 1.0, 2.0],
        "y": [0.1, 1.5, 1.5, 3.0, 1.0, 3.0, None, 3.0, 3.0, 2.0, None, float("nan")],
        "e": [0.5, 0.5, 1.0, 0.5, 0.5, 0.25, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5],
        "d": [Decimal(number) for number in "0.10 1.50 1.50 3.00 1.00 3.00 0.00 3.00 3.00 2.00 1.00 2.00".split()],
    }
)
KEYS = [("u", 1), ("v", 2), (None, None), ("w", 3), ("", 1), ("s", 4)]

FLEETS = {
    "line": readings("x", "y", "0.5", by=["k", "j"]),
    "binary64": readings("x", "y", "0.5", by=["k", "j"], reading="binary64"),
    "identity": readings("x", "y", "0.5", by=["k", "j"], id="id"),
    "skip": readings("x", "y", "0.5", by=["k", "j"], missing="skip"),
    "decimals": readings("x", "d", "0.5", by=["k", "j"]),
    "column": readings("x", "d", eps_column="e", by=["k", "j"]),
    "least": readings("x", "d", "1.5*min", by=["k", "j"]),
    "origin": readings("x", "d", "1", by=["k", "j"], through_origin=True, where="theta1 <= 2"),
    "law": readings("x", "d", "5%*|y| + 0.5", by=["k", "j"]),
    "regressors": readings(["x", "e"], "d", "1/2", by=["k", "j"]),
}


def rows_of(batches: Any, own: Readings) -> dict[Any, dict[str, Any]]:
    rows = [row for batch in batches for row in batch.to_pylist()]
    keyed = {tuple(row[name] for name in own.by): row for row in rows}
    assert len(keyed) == len(rows), "a key has two rows"
    return keyed


def expected_of(own: Readings) -> dict[Any, dict[str, Any]]:
    """Each group by the function for frames in memory."""
    answer = boundfit.fit_groups(
        FLEET, own.by, own.x, own.y, own.eps, id=own.identity, eps_column=own.eps_column, where=own.where,
        through_origin=own.through_origin, reading=own.reading, missing=own.missing,
    )  # fmt: skip
    rows: list[dict[str, Any]] = answer.to_pylist()
    for row in rows:
        if own.identity is None and row["problem"] is not None:
            # Nothing but a name tells rows apart that were dealt out.
            row["problem"] = re.sub(r"\brow \d+, ", "", row["problem"], count=1)
    return {tuple(row[name] for name in own.by): row for row in rows}


def check_fleet(found: dict[Any, dict[str, Any]], own: Readings) -> None:
    expected = expected_of(own)
    assert list(expected) == KEYS
    assert {key: list(row) for key, row in found.items()} == {key: list(row) for key, row in expected.items()}
    for row in (found["s", 4], expected["s", 4]):
        # Both readings are wrong, and the first one of those at hand is named.
        row["problem"] = row["problem"] and row["problem"].replace("id 111", "id 110")
    assert found == expected


@pytest.mark.parametrize("name", FLEETS)
@pytest.mark.parametrize("held", [None, 5, 1])
def test_groups_of_rows_in_any_order_and_batches(name: str, held: int | None, monkeypatch: pytest.MonkeyPatch) -> None:
    own = FLEETS[name]
    if held is not None:
        # As if these few rows were more than there is memory for.
        monkeypatch.setattr(partitions, "MOST_ROWS_HELD", held)
        monkeypatch.setattr(partitions, "FEWEST_ROWS_REDUCED", 1)
        monkeypatch.setattr(partitions, "ROWS_AT_A_TIME", 2)
    random_ = random.Random(3)
    for most in (1, 2, 3, 100):
        table = FLEET.take(random_.sample(range(len(FLEET)), len(FLEET)))
        check_fleet(rows_of(partitions.fit_partition(batches_of(table, most), own), own), own)


@pytest.mark.parametrize("name", FLEETS)
@pytest.mark.parametrize("parts", [1, 2, 5])
def test_groups_gathered_from_parts_and_reduced_on_the_way(name: str, parts: int) -> None:
    own = FLEETS[name]
    for combine in (None, 0, 1, 100):
        # Dealt out like cards, so that each group is in several parts, and then gathered by key.
        sent = []
        for part in range(3):
            table = FLEET.take(list(range(part, len(FLEET), 3)))
            if combine is not None:
                table = pyarrow.Table.from_batches(partitions.combine_partition(batches_of(table), own, combine))
            sent.append(partitions.split(table, own, parts))
        found: dict[Any, dict[str, Any]] = {}
        for place in range(parts):
            batches = [batch for tables in sent for batch in tables[place].to_batches()]
            answers = rows_of(partitions.fit_partition(batches, own), own)
            assert not answers.keys() & found.keys(), "a key is in two places"
            found |= answers
        check_fleet(found, own)


def test_reasons_name_the_reading() -> None:
    own = FLEETS["identity"]
    found = rows_of(partitions.fit_partition(batches_of(FLEET), own), own)
    assert found["w", 3]["problem"].startswith('id 106, column 2 (y): "NaN": the value is missing')
    assert found["w", 3]["rows"] == 2
    found = rows_of(partitions.fit_partition(batches_of(FLEET), FLEETS["line"]), own)
    assert found["w", 3]["problem"].startswith('column 2 (y): "NaN": the value is missing')
    found = rows_of(partitions.fit_partition(batches_of(FLEET), FLEETS["skip"]), own)
    assert found["s", 4]["problem"] == "every row of the group lacks a number"
    assert found["s", 4]["rows"] == 0 and found["w", 3]["problem"] is None


def test_the_schema_is_declared_and_kept() -> None:
    for own in FLEETS.values():
        schema = partitions.schema_of_groups([FLEET.schema.field(name) for name in own.by], own)
        for batch in partitions.fit_partition(batches_of(FLEET), own):
            assert batch.schema == schema
    assert list(partitions.fit_partition([], FLEETS["line"])) == []
    assert list(partitions.fit_partition(FLEET.slice(0, 0).to_batches(), FLEETS["line"])) == []
    own = readings("x", "y", "0.5", by="kind")
    with pytest.raises(ValueError, match="a column 'kind' is part of the answer"):
        partitions.schema_of_groups([pyarrow.field("kind", pyarrow.string())], own)


def test_many_bad_groups_are_rows_too() -> None:
    own = readings("x", "y", "0.5", by="k")
    count = 2000
    table = pyarrow.table(
        {
            "k": [f"s{k}" for k in range(count) for _ in range(3)],
            "x": [0.0, 1.0, 2.0] * count,
            "y": [None if k % 7 == 0 and row == 1 else float(row) for k in range(count) for row in range(3)],
        }
    )
    found = rows_of(partitions.fit_partition(batches_of(table, 1000), own), own)
    assert len(found) == count
    assert {key for (key,), row in found.items() if row["problem"] is not None} == {f"s{k}" for k in range(0, count, 7)}
    assert {row["theta1_upper_exact"] for row in found.values() if row["problem"] is None} == {"3/2"}


@pytest.mark.parametrize(("centre", "error"), [(Fraction(1, 3) + 10**6, Fraction(9, 10**14)), (Fraction(-1, 7), Fraction(0)), (Fraction(3), Fraction(1, 3))], ids=str)
def test_the_error_of_a_group_in_parts_covers_the_rounding_of_its_centre(centre: Fraction, error: Fraction) -> None:
    double = partitions._error_around(centre, error)
    assert double is not None
    middle = Fraction(float(centre))
    assert middle - Fraction(double) <= centre - error and centre + error <= middle + Fraction(double)
    assert Fraction(double) - error <= Fraction(math.ulp(float(centre))) + Fraction(math.ulp(double))


EQUAL_KEYS = {
    # Half past two, before and after clocks go back.
    "summer time ends": pyarrow.array([1761438600] * 3 + [1761442200] * 3, pyarrow.timestamp("s", "Europe/Berlin")),
    "nanoseconds of a day": pyarrow.array([0] * 3 + [1] * 3, pyarrow.time64("ns")),
    "nanoseconds": pyarrow.array([0] * 3 + [1] * 3, pyarrow.timestamp("ns")),
    "durations": pyarrow.array([0] * 3 + [1] * 3, pyarrow.duration("ns")),
    "short floats": pyarrow.array([0.1] * 3 + [0.3] * 3, pyarrow.float32()),
    "a dictionary of times": pyarrow.array([0] * 3 + [1] * 3, pyarrow.timestamp("ns")).dictionary_encode(),
    "zeros of both signs": pyarrow.array([0.0] * 3 + [-0.0] * 3),
}


@pytest.mark.parametrize("kind", EQUAL_KEYS)
def test_keys_are_equal_where_they_are_in_memory(kind: str) -> None:
    table = pyarrow.table({"k": EQUAL_KEYS[kind], "x": [0.0, 1.0, 2.0] * 2, "y": [0.0, 1.0, 2.0, 5.0, 6.0, 7.0]})
    own = readings("x", "y", "0.1", by="k")
    count = 1 if kind == "zeros of both signs" else 2
    for combine in (None, 2, 100):
        sent = table
        if combine is not None:
            sent = pyarrow.Table.from_batches(partitions.combine_partition(table.to_batches(), own, combine))
        places = partitions.split(sent, own, 3)
        fitted = [pyarrow.Table.from_batches(partitions.fit_partition(place.to_batches(), own)) for place in places if len(place)]
        found = pyarrow.concat_tables(fitted)
        assert found["rows"].to_pylist() == [6 // count] * count
        assert set(found["kind"].to_pylist()) == {"empty" if count == 1 else "polygon"}
        assert found.schema.field("k").type == table.schema.field("k").type
        key = found["k"].combine_chunks()
        key = key.dictionary_decode() if "dictionary" in kind else key
        assert pyarrow.compute.count_distinct(key).as_py() == count
    if "dictionary" not in kind:
        assert boundfit.fit_groups(table, "k", "x", "y", "0.1")["rows"].to_pylist() == [6 // count] * count


def test_a_reduction_without_a_bound_serves_each_and_has_none() -> None:
    own = to_reduce("x", "y", None, 2)
    part = partitions.reduce_partition(0, batches_of(TABLE), own)
    assert part.reduction is not None
    reduction = Reduction(merged([part.reduction], own), own)
    assert reduction.fit("0.5").vertices == reduction.fit(0.5).vertices
    with pytest.raises(ValueError, match="^the bound on the errors is missing: eps, eps_column, lower or upper$"):
        reduction.fit()
    with pytest.raises(ValueError, match="^the bound on the errors is missing .*: with two regressors it tells which readings decide$"):
        to_reduce(["x", "n"], "y", None, 2)
    with pytest.raises(ValueError, match="^the bound on the errors is missing: eps, eps_column, lower or upper$"):
        to_fit("x", "y", None, 2)
    assert to_fit("x", "y", None, 2, eps_column="e").eps is None


@pytest.mark.parametrize("name", ["row\nid", 'row,"id"', "row\r\nid\n\nof a table"])
@pytest.mark.parametrize("reading", ["decimal", "binary64"])
def test_names_and_identities_may_have_line_ends(name: str, reading: Any) -> None:
    own = readings("x", "y", "0.5", id=name, reading=reading)
    identities = ["a\rb", "c\n\nd", 'e,"f"', "g\r\nh", "i", "\rj"]
    halves = []
    for start, y in ((0, [0.1, 1.5, 2.0]), (3, ["1/3", "4", "1/7"])):
        table = pyarrow.table({name: identities[start : start + 3], "x": [float(start), start + 1.0, start + 2.0], "y": y})
        part = partitions.reduce_partition(start, table.to_batches(), own)
        assert part.reduction is not None, part.problem
        halves.append(part.reduction)
        assert set(Reduction(part.reduction, own).ids or ()) <= set(identities)
    whole = Reduction(merged(halves, own), own)
    expected = boundfit.fit([0.0, 1.0, 2.0, 3.0, 4.0, 5.0], [0.1, 1.5, 2.0, "1/3", "4", "1/7"], "4", reading=reading)
    assert whole.rows == 6 and whole.ids is not None and set(whole.ids) <= set(identities)
    assert whole.fit("4").vertices == expected.vertices
