"""An existing CLICK project to the text of a program."""
