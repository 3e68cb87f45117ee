"""`python -m kingpost` is the command `kingpost`."""

import sys

from .cli import main

sys.exit(main())
