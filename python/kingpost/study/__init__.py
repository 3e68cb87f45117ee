"""Studies: many cases of one scenario, screened, run, reduced and reported."""
