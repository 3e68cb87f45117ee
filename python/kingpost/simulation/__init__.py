"""Simulation of a scenario: step by step, to its end, or many variants or seeds at once."""
