"""Rules about a program, one in a file. ``registry.Folder`` says when the rules of a folder run."""
