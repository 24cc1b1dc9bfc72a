"""The room of imports: what CLICK has, a ladder of rungs in cells, back to source that a person would have written."""
