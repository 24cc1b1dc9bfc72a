"""The language for editors: type stubs, made from the Specs, the banks and the address table."""
