"""Folder of a study: names of its files, coordinates and attributes of the results, digests, writing and
reading."""
