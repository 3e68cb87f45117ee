"""Reports and pictures of the command line."""
