"""Films of runs, which the app makes in a browser of this machine."""
