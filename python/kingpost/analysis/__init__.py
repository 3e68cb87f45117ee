"""Analyses of a model and of recorded runs."""
