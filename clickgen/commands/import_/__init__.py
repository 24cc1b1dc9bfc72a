"""Turns an existing CLICK project into the text of a program."""
