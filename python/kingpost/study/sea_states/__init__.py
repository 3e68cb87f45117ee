"""Sea states of a site: scatter tables, time series, periods."""
