"""Every question × every form × fits of the fixtures: the package says what the program writes, byte for byte, or both refuse. The list
is that of the tests in Rust, which hold it equal to the registry."""

from __future__ import annotations

import inspect
import json
import subprocess
from pathlib import Path
from typing import Any

import boundfit
import pytest
from boundfit import _asking, _boundfit
from jsonschema import Draft202012Validator

from conftest import ROOT, _program

LIST: dict[str, Any] = json.loads((ROOT / "tests/questions.json").read_text())
QUESTIONS: dict[str, dict[str, Any]] = LIST["questions"]

# What people call.
FUNCTIONS = {
    "check": boundfit.check,
    "fit": boundfit.fit_file,
    "fit-x-errors": boundfit.fit_file,
    "fleet": boundfit.fit_groups,
    "judge": boundfit.judge_file,
    "linearity": boundfit.linearity_file,
    "next": boundfit.next,
    "outliers": boundfit.outliers,
    "polygon": boundfit.polygon_file,
    "predict": boundfit.predict,
    "range": boundfit.range,
    "status": boundfit.status,
    "window": boundfit.windows,
}


def test_every_question_has_a_function() -> None:
    assert sorted(FUNCTIONS) == sorted(QUESTIONS)


REQUEST: dict[str, Any] = json.loads((ROOT / "schema/boundfit-request-1.json").read_text())

# Keys of an answer: Python has them where it is asked for.
ANSWER = {"file", "row_numbers", "format", "digits", "rounding", "exact"}
# Keys of a question that only reports have, or that no function has yet.
REPORTS = {
    "check": {"solver", "claim", "digits_as_printed", "all_rows", "directions", "scaled", "time_limit"},
    "fit": {"sweep", "brief", "full", "inverse"},
    "status": {"all"},
}
# Parameters with other names than their keys, or without keys.
NAMES = {"from_": "from", "eui": "no_eui", "claim": "claim_pui"}
DATA = {"path", "frame", "id", "how", "problem"}


def parameters(function: Any) -> set[str]:
    return {NAMES.get(name, name) for name in inspect.signature(function).parameters} - DATA


def test_keywords_are_the_keys_of_a_request() -> None:
    keywords = parameters(_asking.readings_of_file) | set(_asking.Table.__annotations__)
    assert keywords | ANSWER == set(REQUEST["properties"])
    assert set(_asking.How.__annotations__) < keywords
    own: dict[Any, set[str]] = {}
    for question in REQUEST["anyOf"]:
        name = question["properties"]["ask"]["const"]
        own.setdefault(FUNCTIONS[name], set()).update(question["properties"].keys() - {"ask"} - REPORTS.get(name, set()))
    assert {function: parameters(function) - keywords for function in own} == own


@pytest.mark.parametrize("question", QUESTIONS)
def test_requests_keep_to_the_schema(question: str) -> None:
    schema = Draft202012Validator(REQUEST)
    request = {"ask": question, **QUESTIONS[question]["request"], "x": "x", "y": "y", "eps": "1"}
    schema.validate(request)
    assert not schema.is_valid({**request, "unheard_of": 1})
    assert not schema.is_valid({**request, "eps": True})


def readings(line: str, question: str) -> _boundfit.Readings:
    file, *words = line.split(" ")
    given = {name.removeprefix("--").replace("-", "_"): value for name, value in zip(words[::2], words[1::2], strict=True)}
    x: Any = given.pop("x").split(",")
    y, eps = given.pop("y", None), given.pop("eps", None)
    more: dict[str, Any] = {**given, "x_eps": "1/10"} if question == "fit-x-errors" else dict(given)
    return _asking.readings_of_file(file, x, y, eps, **more)


def told(line: str, question: str, request: str, form: str) -> str:
    """What the package answers."""
    if question == "polygon":
        return boundfit.polygon_file(line).report(form)
    if question == "judge":
        return _boundfit.judge_file(line, request, form)
    return _boundfit.ask(readings(line, question), request, form, None)


def written(line: str, command: str, form: str, proof: Path) -> str | None:
    """What the program writes, where it writes an answer."""
    file, *words = line.split(" ")
    if command.startswith("linearity"):
        # It has no bounds on the errors.
        taken = [at for at, word in enumerate(words) if word in ("--x", "--y", "--rows", "--reading")]
        words = [word for at in taken for word in words[at : at + 2]]
    name, *own = command.split(" ")
    formats = {"vertices": ["--vertices", "--format", "csv"], "proof": ["--proof", str(proof)]}
    arguments = [name, file, *words, *own, *formats.get(form, ["--format", form])]
    done = subprocess.run([_program(), *arguments], capture_output=True, text=True, cwd=ROOT / "fixtures")
    if done.returncode not in (0, 3, 4):
        return None
    return proof.read_text() if form == "proof" else done.stdout


@pytest.mark.parametrize("question", QUESTIONS)
def test_the_package_says_what_the_program_writes(question: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT / "fixtures")
    own = QUESTIONS[question]
    request = json.dumps({"ask": question, **own["request"]})
    answers = 0
    for number, line in enumerate(LIST[own.get("about", "about")]):
        for form in own["forms"]:
            expected = written(line, own["command"], form, tmp_path / f"{number}.json")
            try:
                said = told(line, question, request, form)
            except ValueError as error:
                assert expected is None, f"{question} as {form} of {line}: {error}"
                continue
            # Next steps are commands of the program.
            expected = expected and expected.split("\nNext steps")[0]
            assert said == expected, f"{question} as {form} of {line}"
            answers += 1
    assert answers > len(own["forms"])
