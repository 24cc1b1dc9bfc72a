"""Whether a fix is safe: judged on the resolved program, where names are addresses."""
