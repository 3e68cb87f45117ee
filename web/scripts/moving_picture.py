"""Puts frames together to a moving picture: moving_picture.py FOLDER FILE MILLISECONDS_A_FRAME."""

import sys
from pathlib import Path

from PIL import Image


def main(folder: str, file: str, milliseconds: str) -> None:
    """Write the PNG files of a folder, in the order of their names, as one animated WebP."""
    frames = [Image.open(path).convert("RGB") for path in sorted(Path(folder).glob("*.png"))]
    frames[0].save(
        file,
        save_all=True,
        append_images=frames[1:],
        duration=float(milliseconds),
        loop=0,
        quality=60,
        method=6,
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
