"""Links that open a run in the app; the address itself contains the scenario."""

from __future__ import annotations

import base64
import json
import zlib
from typing import TYPE_CHECKING, Any

from .errors import KingpostError

if TYPE_CHECKING:
    from .scenario import Scenario

VERSION = 1
"""Version of the link format: the number after ``#k`` in an address."""
LONGEST = 64_000
"""Largest number of characters of a link: browsers accept more, but messengers and mail programs cut longer
ones."""
LARGEST = 2_000_000
"""Largest size of a link after decompression, bytes: the limit of the app."""
GALLERY = "gallery:"
FNV_OFFSET, FNV_PRIME = 0x811C9DC5, 0x01000193


def fragment(scenario: Scenario) -> str:
    """Return the fragment of the app's address that opens a scenario with its overrides, parameters and seed.

    The form is that of the app's *Share*: JSON, deflated, in base64url, then a point and the FNV-1a digest of
    the JSON (docs/decisions/links.md). Files of the gallery are named, others are in the link.

    Parameters
    ----------
    scenario
        Scenario with its overrides and parameters.

    Returns
    -------
    str
        ``#k1=`` and the encoded scenario.

    Raises
    ------
    KingpostError
        If the link would be longer than 64,000 characters.

    >>> from kingpost import load
    >>> fragment(load("paper"))[:4]
    '#k1='
    """
    own = {name: text for name, text in scenario.files.items() if not name.startswith(GALLERY)}
    file = scenario.file.replace("\\", "/").rpartition("/")[2]
    given = {"file": file, "text": scenario.json, "opened": own}
    return packed({"scenario": given, "values": {}, "changes": [], "moment": None})


def packed(run: dict[str, Any]) -> str:
    """Encode a run, in the form of the app's `SharedRun`, as the fragment of a link.

    >>> packed({"moment": None})[-8:]
    '82665658'
    """
    content = json.dumps(run, ensure_ascii=False, separators=(",", ":")).encode()
    deflate = zlib.compressobj(9, zlib.DEFLATED, -zlib.MAX_WBITS)
    text = base64.urlsafe_b64encode(deflate.compress(content) + deflate.flush()).decode().rstrip("=")
    found = f"#k{VERSION}={text}.{digest(content)}"
    if len(found) > LONGEST or len(content) > LARGEST:
        raise KingpostError(
            f"link: found {len(found)} characters, allowed: {LONGEST}; the scenario's own files make it long"
        )
    return found


def digest(content: bytes) -> str:
    """FNV-1a over bytes, 32 bits, in hexadecimal (Fowler, Noll & Vo; draft-eastlake-fnv).

    >>> digest(b"foobar")
    'bf9cf968'
    """
    found = FNV_OFFSET
    for byte in content:
        found = (found ^ byte) * FNV_PRIME & 0xFFFFFFFF
    return f"{found:08x}"
