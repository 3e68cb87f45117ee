"""Kinds of input, one file each: `drawn` makes a case, `use` processes it as a user would."""
