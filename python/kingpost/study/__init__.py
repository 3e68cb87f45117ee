"""Studies: many runs of one scenario, reduced to numbers that last, on one machine or many."""
