"""What ``clickgen nicknames`` does with an address table: compare, merge, rename, explain."""
