"""The commands: a file each, with `HELP`, `add_options` and `run`, which returns the exit code."""
