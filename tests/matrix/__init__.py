"""What each instruction takes, as tables to be held against docs/click-facts.md.

``test_matrix.py`` builds every cell.
"""
