"""Do two ladders say the same: power through the drawing, outputs in one spelling, and what differs in words."""
