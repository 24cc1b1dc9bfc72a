"""What CLICK holds, read back: ladder files to drawn rungs, and drawn rungs to rungs of a program."""
