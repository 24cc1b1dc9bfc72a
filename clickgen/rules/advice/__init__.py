"""Advice: rules about logic worth a second look, one in a file. They run in a check, of a program without errors."""
