"""Proofs, checked."""

from __future__ import annotations

import os

from . import _boundfit


def verify(proof: str | os.PathLike[str], data: str | os.PathLike[str] | bytes) -> str | None:
    """Checks every statement of a proof against the file that it is about, by a checker that shares nothing with the engine but its
    numbers. ``None`` where all of them are true, else what is false. The proof is its JSON text or the path of its file.

    :raises ValueError: where it is no proof.
    """
    if not isinstance(proof, str) or not proof.lstrip().startswith("{"):
        with open(proof, encoding="utf-8") as file:
            proof = file.read()
    if not isinstance(data, bytes):
        with open(data, "rb") as table:
            data = table.read()
    return _boundfit.verify(proof, data)
