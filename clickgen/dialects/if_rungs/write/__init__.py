"""A program written as a person would."""
