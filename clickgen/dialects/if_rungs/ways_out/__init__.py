"""Ways out for code that people bring from other languages and machines."""
