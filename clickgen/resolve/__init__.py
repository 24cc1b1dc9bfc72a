"""Names to addresses: the address table, declarations, system names, allocation; and the types of constants."""
