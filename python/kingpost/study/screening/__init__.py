"""Screening by linear response: evaluation of limits in every case without time-domain runs."""
