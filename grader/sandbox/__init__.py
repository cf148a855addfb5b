"""How processes are started, bounded and ended: nothing else in the project does."""
