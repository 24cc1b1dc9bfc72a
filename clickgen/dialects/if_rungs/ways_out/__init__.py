"""Ways out for what people bring along from other languages and machines."""
