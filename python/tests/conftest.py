"""The program that the package is compared with: the one that BOUNDFIT_PROGRAM names, else the newest one built here."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FIXTURES = ROOT / "fixtures"

Program = Callable[..., str]


def _program() -> Path:
    if named := os.environ.get("BOUNDFIT_PROGRAM"):
        return Path(named)
    names = ["release/boundfit", "debug/boundfit", "debug/boundfit-for-tests"]
    built = [path for name in names if (path := ROOT / "target" / name).exists()]
    assert built, "build the program first: cargo build --release, or name one in BOUNDFIT_PROGRAM"
    return max(built, key=lambda path: path.stat().st_mtime)


@pytest.fixture(scope="session")
def program() -> Program:
    path = _program()

    def run(*arguments: str | Path) -> str:
        done = subprocess.run([path, *map(str, arguments)], capture_output=True, text=True, cwd=ROOT)
        assert done.returncode in (0, 3), done.stderr
        return done.stdout

    return run
