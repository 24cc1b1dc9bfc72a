"""Rules that ask where the scratch cells are, one in a file. They run in every build of a program without errors."""
