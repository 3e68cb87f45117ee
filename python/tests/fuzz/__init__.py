"""Inputs of every kind with something wrong in them, and the one contract that holds for all."""
