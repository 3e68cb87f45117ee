"""Mutations of texts, bytes and trees, drawn from `random.Random` or from hypothesis in its place."""

from __future__ import annotations

import json
import random
import re
from collections.abc import Callable, Sequence
from typing import Any

from lift_mutations import NUMBERS, OTHERS, at, places, put

NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])")
WORD = re.compile(r"[A-Za-z_][A-Za-z_0-9]*")
NUMBER_TEXTS = [
    "0", "-0", "-1", "1", "2", "3", "0.5", ".5", "5.", "1e3", "1e-3", "1e6", "1e-9", "1e15", "1e16",
    "1e100", "-1e100",
    "1e300", "1e308", "-1e308", "1e-300", "5e-324", "1e400", "nan", "NaN", ".nan", "inf", "-inf", ".inf",
    "Infinity", "9" * 30, "9" * 400, "0." + "0" * 60 + "1", "2147483648", "9223372036854775808",
    "18446744073709551616", "-9223372036854775809", "0x10", "1_000", "1,5", "1e", "e5", "--1", "+1", "",
    " ", "x",
    "\uff11\uff12", "\u0663", "1d5", "1D+05", "********", "true", "null", "''", "'1'",
]  # fmt: skip
TOKENS = [
    "\n", "\n\n", "\r\n", "\r", "\t", " ", ",", ";", ":", ": ", "{", "}", "[", "]", "(", ")", "'", '"',
    "#", "&a ",
    "*a", "<<: ", "!x ", "!!float ", "|", ">", "? ", "- ", "---", "...", "%", "\\", "\x00", "\x1b[31m",
    "\x07", "\x7f",
    "\x85", "\u2028", "\ufeff", "\u202e", "é", "🚢", "\ud7ff", "$", "~", "null", "true", "=", "==", "..",
    "/", "../",
    "[" * 300, "{a: " * 300, "(" * 3000, "x" * 3000, "-" * 100,
]  # fmt: skip


def weird_number(draw: random.Random) -> str:
    """Draw a number as in a file, possibly malformed."""
    if draw.random() < 0.7:
        return draw.choice(NUMBER_TEXTS)
    return repr(draw.uniform(-1, 1) * 10.0 ** draw.randrange(-30, 31))


# Texts.


def _one_of(pattern: re.Pattern[str], draw: random.Random, text: str) -> re.Match[str] | None:
    """Find the next match after a random position: a list of all matches would take long in a long text."""
    return pattern.search(text, draw.randrange(len(text) + 1)) or pattern.search(text)


def number_changed(draw: random.Random, text: str) -> str:
    one = _one_of(NUMBER, draw, text)
    if one is None:
        return token_put(draw, text)
    return text[: one.start()] + weird_number(draw) + text[one.end() :]


def word_changed(draw: random.Random, text: str) -> str:
    """Replace a word by another one of the text, or remove or add a letter."""
    one, other = (_one_of(WORD, draw, text) for _ in range(2))
    if one is None or other is None:
        return token_put(draw, text)
    k = draw.randrange(len(one[0]) + 1)
    new = draw.choice(
        [other[0], one[0][:k] + one[0][k + 1 :], one[0][:k] + "x" + one[0][k:], one[0].upper(), ""]
    )
    return text[: one.start()] + new + text[one.end() :]


def token_put(draw: random.Random, text: str) -> str:
    k = draw.randrange(len(text) + 1)
    return text[:k] + draw.choice(TOKENS) + text[k:]


def stretch_changed(draw: random.Random, text: str) -> str:
    k, length = draw.randrange(len(text) + 1), draw.randrange(20)
    new = "".join(
        chr(draw.choice([draw.randrange(32, 127), draw.randrange(0x250)])) for _ in range(draw.randrange(5))
    )
    return text[:k] + new + text[k + length :]


def cut(draw: random.Random, text: str) -> str:
    k = draw.randrange(len(text) + 1)
    return text[:k] if draw.random() < 0.8 else text[k:]


def line_changed(draw: random.Random, text: str) -> str:
    """Remove, double, move or empty a line, or repeat it very often."""
    lines = text.split("\n")
    k = draw.randrange(len(lines))
    way = draw.randrange(6)
    if way == 0:
        lines.pop(k)
    elif way == 1:
        lines.insert(k, lines[k])
    elif way == 2:
        lines.insert(draw.randrange(len(lines)), lines.pop(k))
    elif way == 3:
        lines[k] = ""
    elif way == 4:
        lines[k:k] = [lines[k]] * draw.choice([10, 1000])
    else:
        end = draw.randrange(k, min(k + 40, len(lines)) + 1)
        del lines[k:end]
    return "\n".join(lines)


def cells_changed(draw: random.Random, text: str) -> str:
    """Remove, double or move a cell of a table."""
    lines = text.split("\n")
    k = draw.randrange(len(lines))
    cells = lines[k].split(",")
    j = draw.randrange(len(cells))
    way = draw.randrange(3)
    if way == 0:
        cells.pop(j)
    elif way == 1:
        cells.insert(j, cells[j])
    else:
        cells.insert(draw.randrange(len(cells)), cells.pop(j))
    lines[k] = ",".join(cells)
    return "\n".join(lines)


def of_nothing(draw: random.Random, text: str) -> str:
    return draw.choice(
        ["", " ", "\n", "#", "null", "[]", "{}", "0", "\ufeff", "\x00", "[" * 100_000, text[:1]]
    )


TEXT_WAYS = [number_changed] * 8 + [word_changed] * 4 + [token_put, stretch_changed, line_changed] * 2 + [cut]
TABLE_WAYS = [*TEXT_WAYS, cells_changed, cells_changed, line_changed]


def damaged(
    draw: random.Random, text: str, ways: Sequence[Callable[[random.Random, str], str]] = TEXT_WAYS
) -> str:
    """Apply one to three mutations to a text."""
    if draw.random() < 0.01:
        return of_nothing(draw, text)
    for _ in range(draw.choices([1, 2, 3], [6, 3, 1])[0]):
        text = draw.choice(ways)(draw, text)
    return text


def encoded(draw: random.Random, text: str) -> bytes:
    """Encode a text as a file, sometimes in another encoding or with the line ends of another system."""
    way = draw.random()
    if way < 0.95:
        return text.encode("utf-8", "surrogatepass" if way < 0.001 else "replace")
    if way < 0.96:
        return text.encode("utf-16")
    if way < 0.97:
        return text.encode("latin-1", "replace")
    if way < 0.98:
        return b"\xef\xbb\xbf" + text.encode("utf-8", "replace")
    return text.replace("\n", "\r\n").encode("utf-8", "replace")


# Bytes.


def damaged_bytes(draw: random.Random, content: bytes) -> bytes:
    """Flip bits, change, remove or insert bytes, or cut the end off."""
    changed = bytearray(content)
    for _ in range(draw.choices([1, 2, 5, 20], [6, 3, 2, 1])[0]):
        if not changed:
            break
        k = draw.randrange(len(changed))
        way = draw.randrange(7)
        if way < 2:
            changed[k] ^= 1 << draw.randrange(8)
        elif way == 2:
            changed[k] = draw.choice([0, 1, 0x7F, 0x80, 0xFF])
        elif way == 3:
            changed[k : k + draw.choice([1, 2, 4, 8, 64])] = b""
        elif way == 4:
            changed[k:k] = bytes(draw.choice([0, 0xFF, 65]) for _ in range(draw.choice([1, 4, 8])))
        elif way == 5:
            length = draw.choice([2, 4, 8])
            changed[k : k + length] = draw.choice([b"\xff", b"\x00", b"\x7f"]) * length
        elif draw.random() < 0.3:
            del changed[k:]
    return bytes(changed)


# Trees, of JSON.


def damaged_tree(draw: random.Random, tree: Any, most: int = 3) -> Any:
    """Change one to `most` values of a tree in place."""
    for _ in range(draw.randrange(1, most + 1)):
        every = list(places(tree))
        if not every:
            return tree
        path = draw.choice(every)
        try:
            _damage(draw, tree, path)
        except (AttributeError, IndexError, KeyError, TypeError):
            continue
    return tree


def _damage(draw: random.Random, tree: Any, path: tuple[str | int, ...]) -> None:
    old, way = at(tree, path), draw.randrange(9)
    if way < 3:
        put(tree, path, draw.choice(NUMBERS))
    elif way < 4 and isinstance(old, int | float):
        put(tree, path, old * draw.choice([-1, 2, 0.5, 1e-3, 1e3, 1e9, 1.0001]))
    elif way < 5:
        del at(tree, path[:-1])[path[-1]]
    elif way < 6 and isinstance(old, list):
        put(tree, path, draw.choice([[], old[:-1], old + old, old[::-1], [old], old * 50]))
    elif way < 7 and isinstance(path[-1], str):
        parent = at(tree, path[:-1])
        parent[draw.choice([path[-1] + "x", "", path[-1].upper()])] = parent.pop(path[-1])
    else:
        put(tree, path, json.loads(json.dumps(draw.choice(OTHERS))))
