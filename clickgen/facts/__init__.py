"""What is wrong with a program: the rules that every build applies, one file each."""
