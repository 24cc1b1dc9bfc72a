"""CLICK's side: rungs drawn, read, and compared."""
