"""Reading source text: statements, expressions and comments, each with its place."""
