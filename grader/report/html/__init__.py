"""Pages for a browser: each is one file, needs nothing else, and runs what is ours alone."""
