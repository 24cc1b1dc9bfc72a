"""Text and files: source, spans, edits, and writing several files at once."""
