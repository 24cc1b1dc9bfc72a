"""The operands of each instruction, as tables to be compared with docs/click-facts.md.

``test_matrix.py`` builds every cell.
"""
