"""What the person wrote, as frozen trees: operands, conditions, rungs, routines."""
