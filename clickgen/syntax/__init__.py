"""Reading source text: libcst for statements and their comments, ast for expressions and their places."""
