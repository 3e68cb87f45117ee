"""Every public function documents its parameters, results and exceptions, and has an example, which runs as a
doctest.
"""

from __future__ import annotations

import ast
import inspect
import re
import textwrap
from collections.abc import Callable, Iterator
from typing import Any

import kingpost
import pytest


def public() -> Iterator[tuple[str, Callable[..., Any]]]:
    """Functions of `__all__`, of its modules, and methods of its classes."""
    for name in kingpost.__all__:
        found = getattr(kingpost, name)
        if inspect.isfunction(found):
            yield name, found
        elif inspect.ismodule(found):
            own = getattr(found, "__all__", None) or [one for one in vars(found) if not one.startswith("_")]
            for member in own:
                function = getattr(found, member)
                if inspect.isfunction(function) and function.__module__.startswith(found.__name__):
                    yield f"{name}.{member}", function
        elif inspect.isclass(found):
            methods = dict(inspect.getmembers(found, inspect.isfunction))
            yield from ((f"{name}.{one}", method) for one, method in methods.items() if one[0] != "_")


def has_section(text: str, *headings: str) -> bool:
    """Whether there is one, with an entry and words that stand in under it."""
    rules = (rf"\n{heading}\n{'-' * len(heading)}\n\S.*\n    \S" for heading in headings)
    return any(re.search(rule, text) for rule in rules)


def sections(function: Callable[..., Any]) -> Iterator[str]:
    """What is missing from a function's docstring."""
    text = f"\n{inspect.getdoc(function)}\n"
    signature = inspect.signature(function)
    tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
    if [name for name in signature.parameters if name != "self"] and not has_section(text, "Parameters"):
        yield "Parameters"
    if signature.return_annotation != "None" and not has_section(text, "Returns", "Yields"):
        yield "Returns"
    if any(isinstance(node, ast.Raise) for node in ast.walk(tree)) and not has_section(text, "Raises"):
        yield "Raises"
    if ">>> " not in text:
        yield "an example"


@pytest.mark.parametrize(
    ("name", "function"), list(public()), ids=lambda one: one if isinstance(one, str) else ""
)
def test_a_public_function_is_documented(name: str, function: Callable[..., Any]) -> None:
    assert list(sections(function)) == []
    missing = [
        parameter
        for parameter in inspect.signature(function).parameters
        if parameter != "self" and parameter not in (inspect.getdoc(function) or "")
    ]
    assert missing == [], name


def test_every_public_name_has_a_docstring() -> None:
    bare = [
        name for name in kingpost.__all__ if name != "__version__" and not getattr(kingpost, name).__doc__
    ]
    assert bare == []
    assert len(list(public())) > 50
