"""Folder of a study: names of its files, the frame of the results, digests, writing and reading."""
