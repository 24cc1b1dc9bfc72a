"""What a build leaves behind: one pure writer for each output, and putting them in place."""
