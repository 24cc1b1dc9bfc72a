"""What each instruction takes, as tables to be held against click-facts; ``test_matrix.py`` builds every cell."""
