"""Studies: many runs of one scenario, reduced to stored numbers, on one machine or many."""
