"""Checking a repository: which files are programs, what each has, what of it is wanted, what can be mended."""
