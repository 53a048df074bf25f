"""Answers that are the program's documents, with numbers as fractions."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from decimal import Decimal
from fractions import Fraction
from typing import Any, Generic, TypeVar, cast

from ._bounds import Interval, Intervals, LowerBound, Point, ProvedInterval, Term, UpperBound
from ._columns import Reading, maybe_digits, refuse_vain
from ._html import of_text

#: The document of an answer, of :mod:`boundfit.documents`.
Document = TypeVar("Document")

#: What gives an answer in a format, with so many digits.
Ask = Callable[[str, "int | None"], str]


class Answer(Generic[Document]):
    """An answer to a question about readings. Every number is exact."""

    __slots__ = ("_ask", "_document", "_json", "_reading")

    def __init__(self, ask: Ask, reading: Reading = "decimal") -> None:
        self._ask = ask
        self._reading: Reading = reading
        self._json = ask("json", None)
        self._document: dict[str, Any] = json.loads(self._json)

    def to_dict(self) -> Document:
        """The document that the program writes with ``--format json``; ``to_dict()["schema"]`` names its schema, and
        :mod:`boundfit.documents` has its type.
        """
        return cast(Document, json.loads(self._json))

    def to_json(self) -> str:
        """As :meth:`to_dict`, as text."""
        return self._json

    def report(self, format: str = "text", *, digits: int | None = None) -> str:
        """The report as ``"text"``, ``"markdown"`` or ``"latex"``; what is a table as ``"csv"``."""
        refuse_vain(format, maybe_digits(digits))
        return self._ask(format, maybe_digits(digits))

    def proof(self) -> str:
        """The proof of the answer as JSON text, which :func:`boundfit.verify` and ``boundfit verify`` check against the file; of
        columns in memory, against the bytes of :meth:`boundfit.Fit.to_csv`.

        :raises ValueError: where the readings come from a file that is not plain delimited text, or a proof would be too long.
        """
        return self._ask("proof", None)

    def __str__(self) -> str:
        return self._ask("text", None)

    def _repr_html_(self) -> str:
        return of_text(self._ask("text", None))


def counted(count: int, word: str) -> str:
    """So many of something, for people."""
    return f"{count} {word}{'' if count == 1 else 's'}"


def _fraction(text: str) -> Fraction:
    try:
        return Fraction(text)
    except ValueError:
        # Python reads no integers of more than 4,300 digits, but decimals of any length.
        numerator, _, denominator = text.partition("/")
        return Fraction(int(Decimal(numerator)), int(Decimal(denominator or 1)))


def number(own: Any) -> Fraction | None:
    """A number of a document; ``None`` where there is none, or its fraction is too long to be written."""
    return None if own is None or own["exact"] is None else _fraction(own["exact"])


def value(own: Any) -> Fraction:
    """A number of a document that is always there."""
    return _fraction(own["exact"])


def point(own: Any) -> Point:
    """The numbers of both parameters."""
    return value(own[0]), value(own[1])


def lower(own: Any) -> LowerBound | None:
    """A lower end."""
    return None if own is None else LowerBound(_fraction(own["exact"]))


def upper(own: Any) -> UpperBound | None:
    """An upper end."""
    return None if own is None else UpperBound(_fraction(own["exact"]))


def interval(own: Any, reading: Reading) -> Interval:
    """An interval without proofs; what a float means that is looked for in it."""
    return Interval(lower(own["lower"]), upper(own["upper"]), reading=reading)


def terms(own: Iterable[Any] | None) -> tuple[Term, ...]:
    """Multiples of bounds."""
    return tuple(Term(term["row"], term["bound"], value(term["multiplier"])) for term in own or ())


def intervals(own: Any, reading: Reading) -> Intervals[Interval] | None:
    """The intervals of both parameters; ``None`` where there are none."""
    return None if own is None else Intervals(interval(own[0], reading), interval(own[1], reading))


def proved_intervals(own: Any, kind: str, reading: Reading) -> Intervals[ProvedInterval] | None:
    """The intervals of both parameters over a set of this kind, with their proofs; ``None`` of an empty set. A document has none where
    nothing bounds the set."""

    def of(one: Any) -> ProvedInterval:
        ends = one["lower"], one["upper"]
        least, most = (None if end["exact"] is None else end for end in ends)
        return ProvedInterval(lower(least), upper(most), *(terms(end["active"]) for end in ends), reading=reading)

    if kind == "empty":
        return None
    free = ProvedInterval(None, None, reading=reading)
    return Intervals(free, free) if own is None else Intervals(of(own[0]), of(own[1]))
