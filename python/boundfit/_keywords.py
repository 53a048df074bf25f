"""Unknown keywords of public functions: refused in the name of the function that was called, with the keyword that was meant."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import wraps
from inspect import Parameter, signature
from typing import ParamSpec, TypeVar

Given = ParamSpec("Given")
Answered = TypeVar("Answered")


def knows(*more: Iterable[str], refuses: Iterable[str] = ()) -> Callable[[Callable[Given, Answered]], Callable[Given, Answered]]:
    """Returns a decorator of functions whose keywords are their own, and ``more`` that ``**how`` takes. Keywords that the function ``refuses`` with reasons of its own are none that it offers."""

    def decorated(function: Callable[Given, Answered]) -> Callable[Given, Answered]:
        parameters = signature(function).parameters.values()
        own = [one.name for one in parameters if one.kind is not Parameter.VAR_KEYWORD and one.name != "self"]
        offered = list(dict.fromkeys([*own, *(name for names in more for name in names)]))
        known = frozenset([*offered, *refuses])

        @wraps(function)
        def called(*given: Given.args, **how: Given.kwargs) -> Answered:
            if how and not how.keys() <= known:
                name = next(name for name in how if name not in known)
                raise TypeError(f"{function.__name__}() got an unexpected keyword argument {name!r}{_meant(name, offered)}")
            return function(*given, **how)

        return called

    return decorated


def _meant(name: str, offered: list[str]) -> str:
    from difflib import get_close_matches

    near = get_close_matches(name, offered, 1)
    return f": did you mean {near[0]!r}?" if near else f" (expected one of {', '.join(offered)})"
