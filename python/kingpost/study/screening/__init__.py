"""Screening by linear response: limits in every case without a run."""
