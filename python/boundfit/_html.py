"""What notebooks show."""

from __future__ import annotations

import html
import re
from decimal import Context, Decimal
from fractions import Fraction
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._fit import Fit
    from ._judge import JudgedProgram

#: Fractions of more letters are shown as decimals.
_LONGEST = 24


def of_text(text: str) -> str:
    """A report. JupyterLab shows what is preformatted in letters of different widths, unless it is told not to."""
    return f"<pre style='font-family:monospace;line-height:1.3;margin:0.5em 0'>{html.escape(text)}</pre>"


def of_fit(fit: Fit) -> str:
    """The picture of the set and the short report. Nothing in it has an id, so that many of them can be in one page."""
    report = of_text(fit.report(brief=True))
    try:
        picture = in_page(fit.svg("fps"))
    except ValueError:
        return report
    return f"<div>{picture}{report}</div>"


def of_judged(judged: JudgedProgram) -> str:
    """The exact answer in a sentence, and a row for each finding."""
    answer = f"exactly: <b>{judged.status}</b>"
    if judged.value is not None:
        answer += f", {_number(judged.value)}"
        points = [f"({', '.join(map(_number, point))})" for point in judged.points]
        answer += f", attained at {' and '.join(points)}" if points else ""
    if not judged.findings:
        return f"<p>{answer}</p>"
    rows = []
    for finding in judged.findings:
        worth = f"<b>{finding.worth}</b>" if finding.worth == "refuted" else finding.worth
        error = "" if not finding.error else _number(finding.error)
        rows.append(f"<tr><td>{finding.aspect}</td><td>{worth}</td><td>{error}</td></tr>")
    head = "<tr><th>what the result says</th><th>is</th><th>off by</th></tr>"
    return f"<p>{answer}; the result is, at worst, <b>{judged.worst}</b></p><table>{head}{''.join(rows)}</table>"


def _number(value: Fraction) -> str:
    """A fraction, or where it is long about how large it is."""
    text = str(value)
    if len(text) <= _LONGEST:
        return text
    # The largest doubles are passed by numbers that a judge may meet.
    return f"about {format(Context(prec=5).divide(Decimal(value.numerator), Decimal(value.denominator)), 'g')}"


def in_page(svg: str) -> str:
    """A picture as wide as there is room for, up to its size, with the same lines and letters in fewer bytes: a page keeps every
    picture that is shown in it."""
    svg = re.sub(r'^<svg width="([^"]*)" height="[^"]*"', r'<svg style="width:100%;max-width:\1px;height:auto"', svg)
    svg = re.sub(r'(?<= d=")[^"]*', lambda path: _relative(path[0]), svg)
    return _joined(svg)


def _relative(path: str) -> str:
    """The same path, counted from point to point, which takes fewer digits; unchanged where it has more than whole numbers."""
    parts: list[str] = []
    x = y = start_x = start_y = 0
    for command, numbers in re.findall(r"([A-Za-z])([^A-Za-z]*)", path):
        if command == "Z":
            parts.append("z")
            x, y = start_x, start_y
            continue
        own = numbers.split()
        if command not in "MLQC" or len(own) % 2 or not own or not all(re.fullmatch(r"-?\d+", number) for number in own):
            return path
        ends = list(zip(map(int, own[::2]), map(int, own[1::2]), strict=True))
        steps = [(end_x - x, end_y - y) for end_x, end_y in ends]
        x, y = ends[-1]
        if command == "M":
            start_x, start_y = x, y
            parts.append(f"M{x} {y}")
        elif command == "L" and len(steps) == 1 and 0 in steps[0]:
            right, down = steps[0]
            parts.append(f"v{down}" if right == 0 else f"h{right}")
        elif command == "L" and len(steps) > 1:
            return path
        else:
            parts.append(command.lower() + " ".join(f"{right} {down}" for right, down in steps))
    return "".join(parts).replace(" -", "-")


def _joined(svg: str) -> str:
    """Neighbouring strokes of one look, such as dashes, as one path."""
    pattern = re.compile(r'<path (fill="none" [^>]*?) d="([^"]*)"/>(?:\n<path \1 d="[^"]*"/>)+')

    def join(found: re.Match[str]) -> str:
        paths = re.findall(r' d="([^"]*)"', found[0])
        return f'<path {found[1]} d="{"".join(paths)}"/>'

    return pattern.sub(join, svg)
