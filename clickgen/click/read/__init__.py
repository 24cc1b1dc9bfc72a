"""Reads back what CLICK holds: ladder files to drawn rungs, and drawn rungs to rungs of a program."""
