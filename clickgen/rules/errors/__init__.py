"""What keeps CLICK from taking a program, and what is doubtful in it, one rule in a file. They run in every build."""
