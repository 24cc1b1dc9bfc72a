"""What ``clickgen workbook`` does: the program as an Excel workbook."""
