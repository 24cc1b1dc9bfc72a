"""A flat view of the resolved program and its uses, for the rules."""
