"""Proofs, checked."""

from __future__ import annotations

import os
from typing import Literal

from . import _boundfit


def verify(proof: str | bytes | os.PathLike[str], data: str | os.PathLike[str] | bytes | bytearray) -> Literal[True]:
    """Checks every statement of a proof against the file that it is about, by a checker that shares nothing with the engine but its
    numbers. The proof is its JSON text, as text or bytes, or the path of its file; the data are bytes, or the path of a file.

    :raises ValueError: with the first statement that is false, or where it is no proof.
    """
    if isinstance(proof, (bytes, bytearray)):
        proof = proof.decode()
        if not proof.lstrip().startswith("{"):
            raise ValueError("proof: these bytes are no JSON: expected those of a proof, or the path of its file as a str")
    if not isinstance(proof, str) or not proof.lstrip().startswith("{"):
        with open(os.fspath(proof), encoding="utf-8") as file:
            proof = file.read()
    if isinstance(data, (bytearray, memoryview)):
        data = bytes(data)
    if not isinstance(data, bytes):
        if isinstance(data, str) and "\n" in data:
            raise ValueError("data is the text of a table: expected its bytes, as text.encode() or fit.to_csv(), or the path of its file")
        with open(os.fspath(data), "rb") as table:
            data = table.read()
    false = _boundfit.verify(proof, data)
    if false is not None:
        raise ValueError(f"the proof is not true of the data: {false}")
    return True
