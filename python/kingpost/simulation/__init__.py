"""Running a scenario: step by step, to its end, many variants or seeds at once."""
