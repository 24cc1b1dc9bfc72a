"""The work of the commands; the command line itself is in cli."""
