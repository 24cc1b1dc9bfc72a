"""Reasoning about conditions."""
