"""`python -m kingpost` is the command `kingpost`."""

import sys

from kingpost_command import main

sys.exit(main())
