"""The start of the command `kingpost`: an interrupt during the imports is reported in one line."""

import sys

INTERRUPTED = 130
"""The exit code of the command when it is interrupted."""


def main() -> int:
    """Import the command line and run it; return its exit code."""
    try:
        from kingpost.cli import main as run
    except KeyboardInterrupt:
        print("error: interrupted", file=sys.stderr)
        return INTERRUPTED
    return run()
