"""The work of ``clickgen nicknames`` on an address table: compare, merge, rename, explain."""
