"""Address lists that a person keeps in a workbook."""
