"""The work of ``clickgen workbook``: the program as an Excel workbook."""
