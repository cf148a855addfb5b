"""How a compiled submission is called in a process of its own, and what comes back."""
