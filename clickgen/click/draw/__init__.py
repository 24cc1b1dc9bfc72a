"""Draws rungs in CLICK's grid."""
