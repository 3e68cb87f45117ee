"""Reports and pictures for the command line."""
