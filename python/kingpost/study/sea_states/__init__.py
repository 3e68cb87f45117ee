"""Sea states of a place: scatter tables, series over time, periods."""
