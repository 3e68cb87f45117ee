"""Studies over many seas, with results stored beside their scripts."""
