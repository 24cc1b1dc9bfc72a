"""What can be wrong with a program: one rule in one file."""
