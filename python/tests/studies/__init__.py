"""Studies over many seas, whose numbers are stored beside the scripts that make them."""
