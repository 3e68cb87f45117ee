"""Studies: many runs of one scenario, reduced to what a decision needs."""
