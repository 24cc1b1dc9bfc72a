"""IR rungs to CLICK rungs: expansion, splitting, scratch addresses, and the drawing in the grid."""
