"""How a grade is told: as a file for machines and as text for people, both pure functions."""
