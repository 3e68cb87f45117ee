"""Design of a study: its file, cases, fingerprint, plan and units of work."""
