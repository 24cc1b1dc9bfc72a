"""Decides whether a fix is safe, on the resolved program, where names are addresses."""
