"""The address table: rows, CSV and workbooks, blocks, and the record of what clickgen placed."""
