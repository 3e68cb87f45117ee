"""Limiting sea states by runs in time, and the operability that follows from limiting heights."""
