"""Running a study: units computed by worker processes, locks of the folder."""
