"""Reductions of tables in parts: what each part comes to, put together in any order and in any tree."""

from __future__ import annotations

import csv
import dataclasses
import io
import json
import os
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import Any

from . import _boundfit
from ._bounds import Intervals, ProvedInterval, Term
from ._columns import Missing, NamedColumns, Number, Reading, flag, quoted
from ._fit import Fit

#: How many reductions are put together at a time.
FAN_IN = 256

Names = str | Sequence[str]


@dataclass(frozen=True)
class Readings:
    """Which columns of a table are what, and what is asked of them: small, plain and the same on every machine."""

    x: tuple[str, ...]
    y: str | None = None
    eps: Number | None = None
    eps_column: str | None = None
    lower: str | None = None
    upper: str | None = None
    where: tuple[str, ...] = ()
    through_origin: bool = False
    x_origin: Number | None = None
    reading: Reading = "decimal"
    missing: Missing = "refuse"
    #: The columns that say to which group a row belongs.
    by: tuple[str, ...] = ()
    #: The column that says which row it is.
    identity: str | None = None

    @property
    def roles(self) -> list[str]:
        """The columns that are fitted, in the order of their roles."""
        columns = (*self.x, self.y, self.eps_column, self.lower, self.upper)
        return [column for column in columns if column is not None]

    @property
    def reduced_columns(self) -> list[str]:
        """The columns that a reduction has, each once."""
        identity = [] if self.identity is None else [self.identity]
        return list(dict.fromkeys([*self.roles, *identity]))

    @property
    def columns(self) -> list[str]:
        """All columns that are looked at, each once."""
        return list(dict.fromkeys([*self.by, *self.reduced_columns]))

    def asked(self, names: Iterable[str] | None = None) -> dict[str, Any]:
        """What the compiled part is asked of columns with these names, in the order of their roles, or else with their own."""
        own = iter(self.roles if names is None else names)
        x = [quoted(next(own)) for _ in self.x]
        columns = {key: None if getattr(self, key) is None else quoted(next(own)) for key in ("y", "eps_column", "lower", "upper")}
        return {
            "x": x[0] if len(x) == 1 else x,
            **columns,
            "eps": self.eps,
            "where": self.where,
            "through_origin": self.through_origin,
            "x_origin": self.x_origin,
            "reading": self.reading,
            "missing": self.missing,
        }

    @property
    def has_bounds(self) -> bool:
        """Whether something bounds the errors."""
        return any(own is not None for own in (self.eps, self.eps_column, self.lower, self.upper))

    def asked_to_reduce(self) -> dict[str, Any]:
        """As :meth:`asked`. Where a line has no bound yet its reduction serves each, and any stands for it."""
        return self.asked() | ({} if self.has_bounds else {"eps": any_bound(len(self.x))})

    def nothing(self) -> bytes:
        """The reduction of no rows. Asking for it finds what is wrong with the question before any row is moved."""
        return reduce_columns([(name, []) for name in self.reduced_columns], self)

    def decide_alone(self) -> bool:
        """Whether a reduction tells everything that is said of a group: not where ε_min needs readings that it leaves out."""
        return self.nothing().startswith((b"# boundfit/reduced/1 ", b"# boundfit/reduced/3 "))


def readings(
    x: Names,
    y: str | None = None,
    eps: Number | None = None,
    *,
    by: Names = (),
    id: str | None = None,
    eps_column: str | None = None,
    lower: str | None = None,
    upper: str | None = None,
    where: Names = (),
    through_origin: bool = False,
    x_origin: Number | None = None,
    reading: Reading = "decimal",
    missing: Missing = "refuse",
) -> Readings:
    """The columns and the question of a call.

    :raises ValueError: when the question makes no sense, whatever the readings are.
    """
    regressors = _tuple(x)
    if len(regressors) not in (1, 2):
        raise ValueError(f"x names {len(regressors)} columns: expected one, or two of a model with two regressors")
    _refuse_others({"y": y, "id": id, "eps_column": eps_column, "lower": lower, "upper": upper}, {"x": regressors, "by": _tuple(by)})
    return Readings(
        x=regressors,
        y=y,
        eps=eps,
        eps_column=eps_column,
        lower=lower,
        upper=upper,
        where=_tuple(where),
        through_origin=flag(through_origin, "through_origin"),
        x_origin=x_origin,
        reading=reading,
        missing=missing,
        by=_tuple(by),
        identity=id,
    )


#: The keywords of a question about columns of a frame, for those who hand them on.
QUESTION = tuple(name for name in readings.__annotations__ if name not in ("x", "y", "eps", "by", "return"))


def to_reduce(x: Names, y: str | None, eps: Number | None, fan_in: int, **question: Any) -> Readings:
    """The columns and the question of a reduction in a tree, which of a line need no bound.

    :raises ValueError: when it makes no sense, whatever the readings are.
    """
    if fan_in < 2:
        raise ValueError(f"fan_in={fan_in}: expected at least 2 reductions to be put together at a time")
    own = readings(x, y, eps, **question)
    own.nothing()
    return own


def to_fit(x: Names, y: str | None, eps: Number | None, fan_in: int, **question: Any) -> Readings:
    """As :func:`to_reduce`, with a bound.

    :raises ValueError: when it makes no sense, whatever the readings are, or without a bound.
    """
    own = to_reduce(x, y, eps, fan_in, **question)
    if not own.has_bounds:
        raise ValueError("the bound on the errors is missing: eps, eps_column, lower or upper")
    return own


def any_bound(regressors: int) -> Number:
    """A bound in place of none, which a reduction of a line under one bound does not have.

    :raises ValueError: of two regressors.
    """
    if regressors == 2:
        raise ValueError("the bound on the errors is missing (eps, lower or upper): with two regressors it tells which readings decide")
    return 0


def _tuple(names: Names) -> tuple[str, ...]:
    # What is no name is refused as one, with its argument.
    return (names,) if isinstance(names, str) or not isinstance(names, Iterable) else tuple(names)


def _refuse_others(one: dict[str, Any], several: dict[str, tuple[Any, ...]]) -> None:
    """Refuses what is no name of a column."""
    for key, names in {**{key: (name,) for key, name in one.items() if name is not None}, **several}.items():
        for name in names:
            if not isinstance(name, str):
                raise ValueError(f"{key}: {name!r} is of type {type(name).__name__}: expected the name of a column, which is a text")


def unique(names: Sequence[str]) -> list[str]:
    """Names of columns, of which one with two roles has two."""
    taken: list[str] = []
    for name in names:
        while name in taken:
            name += "'"
        taken.append(name)
    return taken


def fitted_groups(columns: NamedColumns, own: Readings, codes: Any) -> dict[str, Any]:
    """What is said of the groups that have readings, whose numbers are ``codes``: by name, numbers as the bytes of doubles and as
    exact texts, and in ``group`` which group it is, as text.

    :raises ValueError: when something is wrong with any of them.
    """
    name = "group"
    while name in (column for column, _ in columns):
        name += "'"
    return _boundfit.fit_groups(columns, (name, codes), own.asked(name for name, _ in columns))


def columns_of_groups(own: Readings) -> list[str]:
    """The columns of an answer about groups behind those of the key. Asking for them finds what is wrong with the question.

    :raises ValueError: when it makes no sense, whatever the readings are.
    """
    if not own.by or len(set(own.by)) < len(own.by):
        raise ValueError(f"by={list(own.by)!r}: expected the name of a column, or several different ones")
    # One reading of ones, which every question can be asked of.
    one = [(name, ["1"]) for name in unique(own.roles)]
    names = [*(name for name in fitted_groups(one, own, [0]) if name != "group"), "problem"]
    for name in own.by:
        if name in names:
            raise ValueError(f"by: a column {name!r} is part of the answer: name that of the table differently")
    return names


def in_halves(fitted: Callable[[int, int], dict[str, Any]], start: int, end: int) -> Iterator[tuple[int, dict[str, Any] | ValueError]]:
    """What is said of consecutive groups from the first of them on: in one call, and where something is wrong with one of them in
    halves, down to it and what is wrong."""
    try:
        found = fitted(start, end)
    except ValueError as problem:
        if end - start == 1:
            yield start, problem
            return
        middle = (start + end) // 2
        yield from in_halves(fitted, start, middle)
        yield from in_halves(fitted, middle, end)
        return
    yield start, found


#: What is said of a group without any reading.
NO_NUMBERS = "every row of the group lacks a number"


def lacks_all(columns: NamedColumns, own: Readings) -> bool:
    """Whether no row of a group has all numbers, where such rows are left out."""
    alone = dataclasses.replace(own, identity=None)
    try:
        return own.missing == "skip" and Reduction(reduce_columns(columns, alone), alone).rows == 0
    except ValueError:
        return False


def in_words(problem: ValueError, named: Callable[[int], str]) -> str:
    """What is wrong with a group. ``named`` says what a row is called, from 0, which has another number among those at hand."""

    def renamed(found: re.Match[str]) -> str:
        name = named(int(found[1]) - 1)
        return f"{name}{found[2] or ''}" if name else ""

    return re.sub(r"\brow (\d+)(, |: | of )?", renamed, str(problem).removeprefix("readings: "), count=1)


def reduce_columns(columns: NamedColumns, own: Readings) -> bytes:
    """The reduction of some rows, which may be none."""
    return _boundfit.reduce_part(columns, own.roles, own.identity, own.asked_to_reduce())


def merged(texts: Iterable[bytes], own: Readings) -> bytes:
    """One reduction of what all these are reductions of. A tree of such calls gives what one of them gives."""
    level = list(texts) or [own.nothing()]
    if own.reading == "binary64" and len({_record(text)["reading"] for text in level}) > 1:
        level = [_as_decimals(text, own) for text in level]
    while len(level) > 1:
        groups = [level[start : start + FAN_IN] for start in range(0, len(level), FAN_IN)]
        level = [_boundfit.merge_reductions(b"".join(group), own.identity, own.asked_to_reduce()) for group in groups]
    return level[0]


def _as_decimals(text: bytes, own: Readings) -> bytes:
    """A reduction whose numbers are read as they are written. Numbers are stored doubles where all of a part are such, and parts go
    together if they are read in one way."""
    if _record(text)["reading"] == "decimal":
        return text
    stated, header, rows = _parts(text)
    names = next(_records(header))
    written = []
    has_counts = text.startswith(_WITH_COUNTS)
    for row in _records(rows):
        count, blank, first = row[0].partition(" ") if has_counts else ("", "", row[0])
        cells = [exactly(cell) if name in own.roles else cell for name, cell in zip(names, [first, *row[1:]], strict=True)]
        written.append(f"{count}{blank}{','.join(map(_in_quotes, cells))}\n")
    return "\n".join([stated.replace('"reading":"binary64"', '"reading":"decimal"', 1), header, "".join(written)]).encode()


def _parts(text: bytes) -> tuple[str, str, str]:
    """The line in front of a reduction, its header, of which a cell in quotes may have several lines, and its rows."""
    lines = text.decode().split("\n")
    end = 1 + _record(text).get("header_lines", 1)
    return lines[0], "\n".join(lines[1:end]), "\n".join(lines[end:])


def _records(text: str) -> Iterator[list[str]]:
    return csv.reader(io.StringIO(text, newline=""))


def _in_quotes(cell: str) -> str:
    """A cell of a line. The module csv leaves a carriage return that stands alone without quotes."""
    return '"' + cell.replace('"', '""') + '"' if re.search('[,"\r\n]', cell) else cell


def exactly(cell: str) -> str:
    """A cell that is exactly the double that it is read as: itself, if it is, else all digits of that. What is no number stays."""
    try:
        number = Fraction(cell.strip())
    except ValueError:
        return cell
    double = float(number)
    return cell if Fraction(double) == number else format(Decimal(double), "f")


#: How reductions begin whose lines say for how many readings they stand.
_WITH_COUNTS = (b"# boundfit/reduced/3 ", b"# boundfit/reduced/4 ")


@dataclass(frozen=True)
class Part:
    """What one part of a table comes to: its reduction, or why it has none."""

    #: The smallest number of the parts that it is made of, which says where it stands in the table.
    number: int
    reduction: bytes | None
    problem: str | None = None


def of_part(number: int, reduce: Callable[[], bytes]) -> Part:
    """What a part comes to. Readings that are wrong are an answer: a task that failed for them would fail each time it is retried."""
    try:
        return Part(number, reduce())
    except ValueError as problem:
        return Part(number, None, f"part {number}: {problem}")


def merge_parts(parts: Iterable[Part], own: Readings) -> Part:
    """Parts put together in the order of their numbers. What a task that was run twice has sent twice counts once."""
    once: dict[int, Part] = {}
    for part in parts:
        before = once.setdefault(part.number, part)
        if before is not part and _stated(before.reduction) != _stated(part.reduction):
            raise ValueError(f"part {part.number} came twice with different readings: do the parts of the table change between reads?")
    in_order = [once[number] for number in sorted(once)]
    number = in_order[0].number if in_order else 0
    for part in in_order:
        if part.problem is not None:
            return Part(number, None, part.problem)
    return Part(number, merged([part.reduction for part in in_order if part.reduction is not None], own))


def _stated(reduction: bytes | None) -> Any:
    """What a reduction says of all its readings, whichever of equal ones it keeps."""
    if reduction is None:
        return None
    record = _record(reduction)
    return record["rows"], record["sums"]


def _record(reduction: bytes) -> dict[str, Any]:
    line = reduction.split(b"\n", 1)[0]
    record: dict[str, Any] = json.loads(line.split(b" ", 2)[2])
    return record


@dataclass(frozen=True)
class Reduction:
    """The readings of a table that decide, with the sums over all of them: :meth:`fit` says what :func:`boundfit.fit` of all would.

    ``text`` is what ``boundfit reduce`` writes; :func:`boundfit.fit_file` and the program read it.
    """

    text: bytes
    readings: Readings

    @property
    def rows(self) -> int:
        """How many readings there are in all."""
        rows: int = _record(self.text)["rows"]
        return rows

    @property
    def kept(self) -> int:
        """How many readings are kept."""
        return len(self._rows())

    @property
    def ids(self) -> list[str] | None:
        """The identities of the readings that are kept; ``None`` where no column of them was named. Of several equal readings
        the first one stands for all."""
        name = self.readings.identity
        if name is None:
            return None
        header = next(_records(_parts(self.text)[1]))
        return [row[header.index(name)] for row in self._rows()]

    def _rows(self) -> list[list[str]]:
        rows = _parts(self.text)[2]
        if self.text.startswith(_WITH_COUNTS):
            rows = re.sub(r"^\d+ ", "", rows, flags=re.MULTILINE)
        return list(_records(rows))

    def fit(
        self,
        eps: Number | None = None,
        *,
        where: Names | None = None,
        through_origin: bool | None = None,
        x_origin: Number | None = None,
    ) -> ReducedFit:
        """The fit of all readings. What is not said here is what the reduction was asked with; of a line under one bound for all
        readings any ``eps`` may be asked, of anything else the one that it was made with.

        :raises ValueError: when it was made for something else, or of no readings at all.
        """
        own = self.readings
        changes: dict[str, Any] = {}
        if eps is not None:
            changes["eps"] = eps
        if where is not None:
            changes["where"] = _tuple(where)
        if through_origin is not None:
            changes["through_origin"] = through_origin
        if x_origin is not None:
            changes["x_origin"] = x_origin
        own = dataclasses.replace(own, **changes)
        if self.rows == 0:
            raise ValueError("the table has no readings: expected at least one")
        return ReducedFit(_boundfit.readings_of_reductions(self.text, own.roles, own.asked()), self.ids)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the reduction as a file."""
        with open(os.fspath(path), "wb") as file:
            file.write(self.text)

    def __repr__(self) -> str:
        return f"<boundfit.Reduction of {self.rows} readings to {self.kept}>"


class ReducedFit(Fit):
    """The fit of a reduction. Where rows have identities, proofs name these in place of row numbers; reports, which count the
    rows of the reduction, name row ``n`` where :attr:`ids` has it at ``n - 1``."""

    __slots__ = ("ids",)

    def __init__(self, readings: _boundfit.Readings, ids: list[str] | None) -> None:
        super().__init__(readings, eui=False)
        #: The identities of the readings that are kept, in the order in which reports count them.
        self.ids = ids

    def __reduce__(self) -> Any:
        return ReducedFit, (self._readings, self.ids)

    @property
    def rows(self) -> int:
        """How many readings the fit is of."""
        return self._core.rows_total

    @property
    def pui(self) -> Intervals[ProvedInterval] | None:
        """The interval of each parameter over the set, with proofs; ``None`` of an empty set."""
        both = super().pui
        if both is None or self.ids is None:
            return both
        return Intervals(*(self._named(interval) for interval in both))

    @property
    def contradiction(self) -> tuple[Term, ...] | None:
        """Of an empty set at most three bounds that contradict each other: these multiples add up to 0 ≤ something negative."""
        terms = super().contradiction
        return None if terms is None else self._terms(terms)

    def _named(self, interval: ProvedInterval) -> ProvedInterval:
        lower_proof, upper_proof = self._terms(interval.lower_proof), self._terms(interval.upper_proof)
        return dataclasses.replace(interval, lower_proof=lower_proof, upper_proof=upper_proof)

    def _terms(self, terms: tuple[Term, ...]) -> tuple[Term, ...]:
        ids = self.ids
        if ids is None:
            return terms
        return tuple(term if not isinstance(term.row, int) else term._replace(row=ids[term.row - 1]) for term in terms)


