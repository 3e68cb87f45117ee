"""Limiting sea states by time-domain runs, and the operability by limiting heights."""
