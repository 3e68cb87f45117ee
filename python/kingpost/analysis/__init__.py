"""What is computed from a model or from recorded runs."""
