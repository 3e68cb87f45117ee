"""Server of the app."""
