"""The program as the person wrote it, as frozen trees: operands, conditions, rungs, routines."""
