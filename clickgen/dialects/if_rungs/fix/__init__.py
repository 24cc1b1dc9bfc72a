"""Source text rewritten: what a fix puts in the place of a fault."""
