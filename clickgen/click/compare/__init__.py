"""Decides whether two ladders do the same: power through the drawing, outputs in one spelling, differences in words."""
