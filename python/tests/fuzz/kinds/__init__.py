"""The kinds of input, a file each: `drawn` makes a case, `use` does with it what a user would."""
