"""Rungs drawn in CLICK's grid."""
