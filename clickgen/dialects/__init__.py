"""The ways of writing a program: each reads text to the IR, and writes the IR to text."""
