"""Nothing here is a test: the modules need engines that may be absent."""

collect_ignore_glob = ["*.py"]
