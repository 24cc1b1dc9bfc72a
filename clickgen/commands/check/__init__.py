"""Checking a repository: finds its programs, judges each, selects among the findings, and fixes what can be fixed."""
