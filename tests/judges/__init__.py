"""Independent judges of emitted ladder: they read the CSV text alone and import nothing from clickgen."""
