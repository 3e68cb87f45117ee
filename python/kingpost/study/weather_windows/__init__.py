"""Weather windows of a series of sea states: go or no-go, persistence, waiting time."""
