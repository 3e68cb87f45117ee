"""Execution of a study: units computed by worker processes, and locks of the folder."""
