"""The documents keep to their JSON Schemas, as another implementation reads these, and to their types."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, get_type_hints

import pytest
from jsonschema import Draft202012Validator

import boundfit
from boundfit import documents

from conftest import FIXTURES, ROOT

SCHEMAS: dict[str, Any] = {
    schema["title"]: schema for schema in (json.loads(path.read_text()) for path in sorted((ROOT / "schema").glob("*.json")))
}


def golden() -> list[Path]:
    paths = [path for path in sorted(FIXTURES.rglob("*.json")) if b'"schema": "boundfit/' in path.read_bytes()[:200]]
    return [path for path in paths if json.loads(path.read_bytes())["schema"] in SCHEMAS]


@pytest.mark.parametrize("name", SCHEMAS)
def test_a_schema_is_one(name: str) -> None:
    Draft202012Validator.check_schema(SCHEMAS[name])


def test_golden_documents_keep_to_their_schemas() -> None:
    paths = golden()
    for path in paths:
        document = json.loads(path.read_text())
        Draft202012Validator(SCHEMAS[document["schema"]]).validate(document)
    assert len(paths) >= 10


def test_answers_have_the_keys_of_their_types() -> None:
    fit = boundfit.fit([1, 2, 3], [2, 3, 5], eps=1)
    document = fit.to_dict()
    assert document["schema"] == "boundfit/fit/2"
    Draft202012Validator(SCHEMAS["boundfit/fit/2"]).validate(document)
    assert documents.FitDocument.__required_keys__ - {"sweep", "guarantee"} <= set(document) <= set(get_type_hints(documents.FitDocument))
