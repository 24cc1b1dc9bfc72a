"""What editors are told about the language: type stubs, made from the Specs, the banks and the address table."""
