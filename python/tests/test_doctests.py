"""The examples of the package and of its page in the guide."""

from __future__ import annotations

import doctest
import importlib.util
import pkgutil

import boundfit
import pytest

from conftest import ROOT

# These are of use where what they are called after is installed.
ENGINES = ["spark", "dask", "ray"]
NAMES = [own.name for own in pkgutil.iter_modules(boundfit.__path__) if own.name != "_boundfit"]
MODULES = ["boundfit", *(f"boundfit.{name}" for name in NAMES if name not in ENGINES or importlib.util.find_spec(name))]


@pytest.mark.parametrize("name", MODULES)
def test_examples_of_the_package(name: str) -> None:
    assert doctest.testmod(importlib.import_module(name)).failed == 0


@pytest.mark.parametrize("page", ["docs/python.md", "docs/python-columns.md", "python/README.md"])
def test_examples_of_the_guide(page: str, monkeypatch: pytest.MonkeyPatch) -> None:
    # Files are named from the top of the repository.
    monkeypatch.chdir(ROOT)
    tested = doctest.testfile(str(ROOT / page), module_relative=False)
    assert tested.attempted > 0 and tested.failed == 0
    # What is not an example is not run: every block has to be one.
    blocks = (ROOT / page).read_text(encoding="utf-8").split("```python\n")[1:]
    assert all(block.startswith(">>> ") for block in blocks)
