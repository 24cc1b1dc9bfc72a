"""Writes a program as a person would."""
