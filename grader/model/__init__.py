"""Which records flow from one stage to the next: frozen data, no logic."""
